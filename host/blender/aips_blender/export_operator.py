"""File > Export > LuxRender scene (.lxs)."""
import contextlib
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
        path = os.path.abspath(bpy.path.abspath(self.filepath))
        try:
            written = _render_to(path, context.scene, context.view_layer)
        except RuntimeError as error:  # reported as an error by the engine
            self.report({'ERROR'}, str(error).strip())
            return {'CANCELLED'}
        if not written:
            self.report({'ERROR'}, f'aips: {path} is not written: no render came to its end')
            return {'CANCELLED'}
        return {'FINISHED'}


def _render_to(path, scene, view_layer):
    """Exports by a render, which alone sees modifiers as they are set for renders, and may move in
    time; whether it did."""
    Pending.path, Pending.written = path, False
    try:
        with contextlib.ExitStack() as changes:
            # The image is empty: no file of the compositor is to have it, and what the compositor
            # or strips make is not to be rendered in its place.
            changes.enter_context(_changed(
                scene.render, engine=AipsRenderEngine.bl_idname, use_compositing=False,
                use_sequencer=False, use_single_layer=False))
            # Several would be written one over the other. `use_single_layer` is for windows alone.
            for layer in scene.view_layers:
                changes.enter_context(_changed(layer, use=layer == view_layer))
            bpy.ops.render.render(scene=scene.name)
    finally:
        Pending.path = None
    return Pending.written


@contextlib.contextmanager
def _changed(settings, **wanted):
    """Settings by name as they are wanted, then as they were."""
    before = {name: getattr(settings, name) for name in wanted}
    try:
        for name, value in wanted.items():
            setattr(settings, name, value)
        yield
    finally:
        for name, value in before.items():
            setattr(settings, name, value)


def _menu(self, _context):
    self.layout.operator(AipsExport.bl_idname, text='LuxRender scene (.lxs)')


def register():
    bpy.utils.register_class(AipsExport)
    bpy.types.TOPBAR_MT_file_export.append(_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(_menu)
    bpy.utils.unregister_class(AipsExport)
