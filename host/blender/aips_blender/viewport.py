"""The preview in the viewport: a small render that starts anew when scene or view have changed."""
import os
import shutil
import tempfile
import time
import weakref

import bpy
import gpu
import numpy as np
from gpu_extras.presets import draw_texture_2d
from mathutils import Matrix

from . import command, exr, passes, preferences, process, settings, status
from .export.camera import View, window_of
from .export.film import Film
from .export.kept import Kept
from .export.motion import Motion
from .export.scene import Exporting
from .reasons import reason

LONGEST_SIDE = 480       # pixels of the preview's image
SECONDS = 60             # for which a preview converges
SLICE = 0.05             # seconds of an export between two redraws, in which Blender waits
SECONDS_OF_PEACE = 0.3   # without a change, before a render starts


SHAPES = (bpy.types.Mesh, bpy.types.Curve, bpy.types.MetaBall)  # also of new names


class Preview:
    """Starts renders, and draws the latest image of the last one."""

    def __init__(self):
        self._state = _State()
        # The engine that holds this goes without notice, or Blender does.
        weakref.finalize(self, self._state.end)
        self._exporting = None  # the export of it that goes on
        self._exported = None   # the scene as it is now
        self._due = False       # whether a render is to begin once it is exported
        self._wanted = None    # film and view
        self._changed = None   # when scene or view changed, until the render for that has begun
        self._seen, self._header, self._begun = 0, {}, 0.0
        self._texture = None
        self._image = ''

    def change(self, updates=()):
        """The scene has changed: it is to be exported anew, by updates of the dependency graph."""
        for update in updates:
            if update.is_updated_geometry or isinstance(update.id, SHAPES):
                self._state.kept.changed(update.id.name_full)
        self._exported = self._exporting = None
        self._end_soon()

    def _end_soon(self):
        """What goes on is ended, and a new render begins soon."""
        self._state.stop()
        self._changed, self._due = time.monotonic(), False

    def draw(self, engine, context, depsgraph):
        wanted = film_of(context, depsgraph.scene), seen_by(context)
        if wanted != self._wanted:
            self._wanted = wanted
            self._end_soon()
        if self._changed is not None:
            if time.monotonic() - self._changed > SECONDS_OF_PEACE:
                self._changed, self._due = None, True
            engine.tag_redraw()
        if self._due:
            self._go_on(engine, depsgraph)
        self._look()
        if self._texture is not None:
            engine.bind_display_space_shader(depsgraph.scene)
            gpu.state.blend_set('ALPHA_PREMULT')
            draw_texture_2d(self._texture, (0, 0), context.region.width, context.region.height)
            gpu.state.blend_set('NONE')
            engine.unbind_display_space_shader()
        self._tell(engine)

    def _go_on(self, engine, depsgraph):
        try:
            program = process.find(preferences.of(bpy.context).program)
            if self._is_exported(depsgraph):
                self._start(program)
            else:
                engine.update_stats('', 'aips: exporting the scene')
                engine.tag_redraw()
        except Exception as error:  # whatever it is, the user sees it in the viewport
            self._due = False
            self._exporting = None
            engine.update_stats('', f'aips: {reason(error)}')

    def _start(self, program):
        self._due = False
        self._header, self._begun = {}, time.monotonic()
        folder = self._state.new_folder('image')
        self._image = os.path.join(folder, 'image.exr')
        self._state.running = process.Process(
            command.arguments(program, self._exported.path, self._image,
                              preferences.of(bpy.context).threads), folder)

    def _is_exported(self, depsgraph):
        """Goes on with that; meshes and images are written where the scene has changed, not for
        another view."""
        film, view = self._wanted
        if self._exported is None:
            if self._exporting is None:
                path = os.path.join(self._state.new_folder('scene'), 'scene.lxs')
                self._exporting = Exporting(path, depsgraph, film, Motion(depsgraph, None), view,
                                            self._state.kept, noted=True)
            self._exported = self._exporting.go_on(SLICE)
            if self._exported is None:
                return False
            self._exporting = None
        self._exported.look(film, view[0], (view[1],))
        return True

    def _look(self):
        try:
            changed = os.stat(self._image).st_mtime_ns
        except FileNotFoundError:
            return
        if changed != self._seen:
            self._seen = changed
            image = exr.read(self._image)
            self._header = image.texts
            self._texture = _texture(image)

    def _tell(self, engine):
        running = self._state.running
        if running is None:
            return
        if running.running():
            known = status.newer(self._header, running.log.progress)
            engine.update_stats('', status.text(self._wanted[0], known,
                                                time.monotonic() - self._begun))
            engine.tag_redraw()
            return
        said = process.failure(running.wait(), running.log.lines())
        self._look()
        self._state.running = None
        engine.update_stats('', f'aips: {said}' if said else status.done(self._header))
        engine.tag_redraw()


class _State:
    """The render that goes on, and folders of files: the scene's, and its image's."""

    def __init__(self):
        self._root = tempfile.mkdtemp(prefix='aips-preview-')
        self._folders, self._count = {}, 0
        self.kept = Kept()
        self.running = None

    def new_folder(self, kind):
        """An empty folder; the one of that kind before it goes."""
        if kind in self._folders:
            shutil.rmtree(self._folders[kind], ignore_errors=True)
        self._count += 1
        self._folders[kind] = os.path.join(self._root, f'{kind}-{self._count}')
        os.makedirs(self._folders[kind])
        return self._folders[kind]

    def stop(self):
        if self.running:
            self.running.kill()
            self.running = None

    def end(self):
        self.stop()
        self.kept.end()
        shutil.rmtree(self._root, ignore_errors=True)


def _texture(image):
    values = passes.pixels(image, passes.COMBINED)
    rows, columns = image.channels['R'].shape
    buffer = gpu.types.Buffer('FLOAT', values.size, np.ascontiguousarray(values.ravel()))
    return gpu.types.GPUTexture((columns, rows), format='RGBA16F', data=buffer)


def film_of(context, scene):
    """The preview's film; the scene's settings choose its integrator."""
    width, height = context.region.width, context.region.height
    scale = min(1.0, LONGEST_SIDE / max(width, height))
    return Film(max(int(width * scale), 1), max(int(height * scale), 1), seconds=SECONDS,
                integrator=scene.aips.integrator, options=settings.integrator_options(scene.aips),
                transparent=scene.render.film_transparent)


def seen_by(context):
    """View and matrix of the viewport."""
    region, space = context.region_data, context.space_data
    matrix, place = region.window_matrix, region.view_matrix.inverted()
    window = window_of(matrix, not region.is_perspective)
    if region.is_perspective:
        return View('perspective', window, near=space.clip_start, far=space.clip_end), place
    # Blender shows what is behind the eye too, by half of the viewport's clip_end.
    near, far = depths_of(matrix)
    back = max(-near, 0.0)
    return (View('orthographic', window, near=near + back, far=far + back),
            place @ Matrix.Translation((0, 0, back)))


def depths_of(matrix):
    """Nearest and farthest depth of an orthographic projection, below 0 behind the eye."""
    return tuple((matrix[2][3] - sign) / matrix[2][2] for sign in (-1, 1))
