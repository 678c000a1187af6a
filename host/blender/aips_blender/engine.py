"""The render engine: F12 exports the scene, runs lxsrender and shows the image as it converges."""
import os
import shlex
import shutil
import tempfile
import time

import bpy

from . import command, exr, passes, preferences, process, settings, status, viewport
from .export.camera import of_eye
from .export.kept import Kept
from .export.motion import Motion
from .export.scene import ExportError, Exporting, export
from .export.versions import set_pixels
from .reasons import Told, reason

SECONDS_BETWEEN_LOOKS = 0.1
_KEPT = {}


class Pending:
    """Path of an export that a render is to make in place of an image, or None."""
    path = None
    written = False  # it has been made


class WrongSize(Told):
    """lxsrender's image has another size than Blender's; the text names both."""


class AipsRenderEngine(bpy.types.RenderEngine):
    bl_idname = 'AIPS'
    bl_label = 'aips'
    bl_use_preview = False
    bl_use_shading_nodes_custom = False
    bl_use_eevee_viewport = True

    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)  # Blender passes arguments from 4.4 on
        self._preview = None

    def update_render_passes(self, scene=None, renderlayer=None):
        self.register_pass(scene, renderlayer, 'Combined', 4, 'RGBA', 'COLOR')
        for each in _passes(scene, renderlayer):
            self.register_pass(scene, renderlayer, each.name, len(each.letters), each.letters,
                               each.kind)

    def render(self, depsgraph):
        try:
            if Pending.path:
                self._export(depsgraph, Pending.path)
                return
            folder = tempfile.mkdtemp(prefix='aips-')
            try:
                Render(self, depsgraph, folder).run()
            finally:
                shutil.rmtree(folder, ignore_errors=True)
        except Exception as error:  # whatever it is, the user sees it where the image would be
            self.report({'ERROR'}, f'aips: {reason(error)}')

    def _export(self, depsgraph, path):
        film = settings.film_of(depsgraph.scene, depsgraph.view_layer)
        exported = export(path, depsgraph, film, self.frame_set)
        Pending.written = True
        tell_left_out(self, exported.left_out)
        self.report({'INFO'}, f'aips: {path} is written')

    def view_update(self, _context, depsgraph):
        if self._preview is None:
            self._preview = viewport.Preview()
        self._preview.change(depsgraph.updates)

    def view_draw(self, context, depsgraph):
        if self._preview is not None:
            self._preview.draw(self, context, depsgraph)


def _passes(scene, view_layer):
    return settings.passes_of(scene, view_layer) + ([passes.NOISY] if scene.aips.denoise else [])


def tell_left_out(engine, lines):
    """Reports each kind of thing that is not carried over."""
    for line in lines:
        engine.report({'WARNING'}, f'aips: {line}')


class Render:
    """One image of one view layer, from the export to the end."""

    def __init__(self, engine, depsgraph, folder):
        self._engine = engine
        self._depsgraph = depsgraph
        self._folder = folder
        self._said = ''
        self._options = depsgraph.scene.aips
        self._program = process.find(preferences.of(bpy.context).program)

    def run(self):
        scene, view_layer = self._depsgraph.scene, self._depsgraph.view_layer
        self._engine.update_stats('', 'aips: exporting the scene')
        self._film = settings.film_of(scene, view_layer)
        exported = self._export()
        if exported is None:
            return
        tell_left_out(self._engine, exported.left_out)
        for eye in _eyes(scene.render):
            if eye:
                self._look_by(eye, exported)
            self._render(exported.path, eye)
        # The whole result holds them, of which the one that has just ended became a part.
        told = passes.mask_texts(self._header, view_layer.name)
        if told:
            whole = self._engine.get_result()
            for key, text in told.items():
                whole.stamp_data_add_field(key, text)

    def _export(self):
        """None where the user ends it."""
        exporting = Exporting(os.path.join(self._folder, 'scene.lxs'), self._depsgraph, self._film,
                              Motion(self._depsgraph, self._engine.frame_set),
                              kept=kept_between_renders())
        while not self._engine.test_break():
            exported = exporting.go_on(SECONDS_BETWEEN_LOOKS)
            if exported:
                return exported
        return None

    def _look_by(self, eye, exported):
        """Lets the scene's file have the camera of one of the views of a stereoscopic render."""
        self._engine.active_view_set(eye)
        camera = self._depsgraph.scene_eval.camera.evaluated_get(self._depsgraph)
        shown, matrices = exported.camera
        if shown.kind == 'environment':
            self._engine.report({'WARNING'}, 'aips: both eyes of a panorama see the same')
            return
        film = self._film
        render = self._depsgraph.scene.render
        fit = camera.data.sensor_fit
        wide = fit == 'HORIZONTAL' or fit == 'AUTO' and \
            film.width * render.pixel_aspect_x >= film.height * render.pixel_aspect_y
        exported.look(film, *of_eye(camera, shown, matrices,
                                    self._engine.camera_model_matrix(camera),
                                    self._engine.camera_shift_x(camera), wide))

    def _render(self, path, eye):
        self._image = os.path.join(self._folder, f'image{eye}.exr')
        self._seen, self._header = 0, {}
        self._result = _begin_result(self._engine, self._depsgraph.scene.render,
                                     self._depsgraph.view_layer, eye)
        try:
            self._follow(process.Process(self._arguments(path), self._folder))
        finally:
            self._engine.end_result(self._result)

    def _arguments(self, path):
        every = command.write_every(self._film.width * self._film.height,
                                    self._options.update_interval)
        found = command.arguments(
            self._program, path, self._image, preferences.of(bpy.context).threads,
            self._options.seed, self._options.denoise, self._options.explain, every)
        return found + _options(self._options.extra)

    def _follow(self, running):
        begun = time.monotonic()
        try:
            while running.running():
                if self._engine.test_break():
                    running.interrupt()
                    running.wait(process.SECONDS_TO_CANCEL)
                    self._load()
                    return
                self._show(time.monotonic() - begun, running.log.progress)
                time.sleep(SECONDS_BETWEEN_LOOKS)
            code = running.wait()
        except BaseException:
            running.kill()
            raise
        said = process.failure(code, running.log.lines())
        self._load()
        if said:
            self._engine.report({'ERROR'}, f'aips: {said}')
        for line in running.log.warnings():
            self._engine.report({'WARNING'}, f'aips: {line}')
        if self._options.explain:
            _keep_text('aips explains', running.log.warnings() + running.log.lines())

    def _show(self, seconds, progress):
        self._load()
        known = status.newer(self._header, progress)
        said = status.text(self._film, known, seconds)
        if said != self._said:
            self._said = said
            self._engine.update_progress(status.share(self._film, known, seconds))
            self._engine.update_stats('', said)

    def _load(self):
        """Puts the image so far into the result, if it is a new one."""
        try:
            changed = os.stat(self._image).st_mtime_ns
        except FileNotFoundError:
            return
        if changed == self._seen:
            return
        self._seen = changed
        image = exr.read(self._image)
        self._header = image.texts
        _fill(self._result, image, _passes(self._depsgraph.scene, self._depsgraph.view_layer))
        self._engine.update_result(self._result)


def kept_between_renders():
    """The Kept of all renders of this session: frames of an animation share meshes."""
    if 'renders' not in _KEPT:
        _KEPT['renders'] = Kept()
    return _KEPT['renders']


def _options(text):
    try:
        return shlex.split(text)
    except ValueError as error:
        raise ExportError(f'"More options" cannot be read: {error}') from error


def _eyes(render):
    """Names of the views of a stereoscopic render, or one that is empty."""
    if not render.use_multiview:
        return ['']
    return [view.name for view in render.views if view.use and
            (render.views_format == 'MULTIVIEW' or view.name in ('left', 'right'))]


def _begin_result(engine, render, view_layer, eye):
    x0, x1, y0, y1 = settings.border(render)
    return engine.begin_result(0, 0, x1 - x0, y1 - y0, layer=view_layer.name, view=eye)


def _fill(result, image, found):
    rows, columns = image.channels['R'].shape
    width, height = result.resolution_x, result.resolution_y
    if (columns, rows) != (width, height):
        raise WrongSize(f"lxsrender's image has {columns} x {rows} pixels, Blender's "
                        f'{width} x {height}: see "More options" for what changes the size')
    layer = result.layers[0]
    for each in [passes.COMBINED, *found]:
        if each.name in layer.passes:
            set_pixels(layer.passes[each.name], passes.pixels(image, each))


def _keep_text(name, lines):
    def write():
        text = bpy.data.texts.get(name) or bpy.data.texts.new(name)
        text.from_string('\n'.join(lines) + '\n')

    if bpy.app.background:
        write()
    else:
        # Renders have a thread of their own, in which Blender's data are not to be changed.
        bpy.app.timers.register(write)


def register():
    bpy.utils.register_class(AipsRenderEngine)


def unregister():
    bpy.utils.unregister_class(AipsRenderEngine)
    while _KEPT:
        _KEPT.popitem()[1].end()
