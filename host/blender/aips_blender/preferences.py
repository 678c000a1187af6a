"""The add-on's preferences: where lxsrender is."""
import bpy
from bpy.props import IntProperty, StringProperty


class AipsPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: StringProperty(name='lxsrender', subtype='FILE_PATH',
                            description='The program lxsrender; empty: the one on PATH')
    threads: IntProperty(name='Threads', min=0, max=1024, description='0: all processors')

    def draw(self, _context):
        self.layout.prop(self, 'program')
        self.layout.prop(self, 'threads')


def of(context):
    return context.preferences.addons[__package__].preferences


def register():
    bpy.utils.register_class(AipsPreferences)


def unregister():
    bpy.utils.unregister_class(AipsPreferences)
