"""File > Export > LuxRender scene (.lxs)."""
import os

import bpy
from bpy.props import StringProperty
from bpy_extras.io_utils import ExportHelper

from .engine import AipsRenderEngine, Pending


class AipsExport(bpy.types.Operator, ExportHelper):
    """Write the scene as LuxRender 1.x files, as a render by aips would see it"""
    bl_idname = 'export_scene.aips_lxs'
    bl_label = 'Export .lxs'

    filename_ext = '.lxs'
    filter_glob: StringProperty(default='*.lxs', options={'HIDDEN'})

    def execute(self, context):
        scene = context.scene
        before = scene.render.engine
        # A render alone sees modifiers as they are set for renders, and may move in time.
        Pending.path = os.path.abspath(bpy.path.abspath(self.filepath))
        scene.render.engine = AipsRenderEngine.bl_idname
        try:
            bpy.ops.render.render(scene=scene.name)
        except RuntimeError as error:  # reported as an error by the engine
            self.report({'ERROR'}, str(error).strip())
            return {'CANCELLED'}
        finally:
            Pending.path = None
            scene.render.engine = before
        return {'FINISHED'}


def _menu(self, _context):
    self.layout.operator(AipsExport.bl_idname, text='LuxRender scene (.lxs)')


def register():
    bpy.utils.register_class(AipsExport)
    bpy.types.TOPBAR_MT_file_export.append(_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(_menu)
    bpy.utils.unregister_class(AipsExport)
