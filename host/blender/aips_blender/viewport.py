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

from . import command, exr, passes, preferences, process, status
from .export.camera import View, window_of
from .export.film import Film
from .export.scene import ExportError, export

LONGEST_SIDE = 480       # pixels of the preview's image
SECONDS = 60             # for which a preview converges
SECONDS_OF_PEACE = 0.3   # without a change, before a render starts


class Preview:
    """Starts renders, and draws the latest image of the last one."""

    def __init__(self):
        self._state = _State()
        # The engine that holds this goes without notice, or Blender does.
        weakref.finalize(self, self._state.end)
        self._count = 0
        self._view = None
        self._changed = None  # when scene or view changed, until the render for that has begun
        self._seen, self._header, self._begun = 0, {}, 0.0
        self._texture = None
        self._image, self._film = '', Film(1, 1)

    def change(self):
        """The scene has changed: what goes on is ended, and a new render begins soon."""
        self._state.stop()
        self._changed = time.monotonic()

    def draw(self, engine, context, depsgraph):
        if _view_key(context) != self._view:
            self._view = _view_key(context)
            self.change()
        if self._changed is not None:
            if time.monotonic() - self._changed > SECONDS_OF_PEACE:
                self._start(engine, context, depsgraph)
            engine.tag_redraw()
        self._look()
        if self._texture is not None:
            engine.bind_display_space_shader(depsgraph.scene)
            draw_texture_2d(self._texture, (0, 0), context.region.width, context.region.height)
            engine.unbind_display_space_shader()
        self._tell(engine)

    def _start(self, engine, context, depsgraph):
        self._changed = None
        self._count += 1
        folder = self._state.new_folder(self._count)
        self._image = os.path.join(folder, 'image.exr')
        self._film, self._header, self._begun = _film(context), {}, time.monotonic()
        try:
            program = process.find(preferences.of(bpy.context).program)
            exported = export(os.path.join(folder, 'scene.lxs'), depsgraph, self._film,
                              view=_seen_by(context))
            self._state.running = process.Process(
                command.arguments(program, exported.path, self._image), folder)
        except (ExportError, process.NotFound, OSError) as error:
            engine.update_stats('', f'aips: {error}')

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
            engine.update_stats('', status.text(self._film, self._header,
                                                time.monotonic() - self._begun))
            engine.tag_redraw()
            return
        said = process.failure(running.wait(), running.lines())
        self._look()
        self._state.running = None
        engine.update_stats('', f'aips: {said}' if said else status.done(self._header))
        engine.tag_redraw()


class _State:
    """The render that goes on, and the folder of its files."""

    def __init__(self):
        self._folder = tempfile.mkdtemp(prefix='aips-preview-')
        self.running = None

    def new_folder(self, count):
        """A folder for one render; that of the one before goes."""
        shutil.rmtree(os.path.join(self._folder, str(count - 1)), ignore_errors=True)
        folder = os.path.join(self._folder, str(count))
        os.makedirs(folder)
        return folder

    def stop(self):
        if self.running:
            self.running.kill()
            self.running = None

    def end(self):
        self.stop()
        shutil.rmtree(self._folder, ignore_errors=True)


def _texture(image):
    values = passes.pixels(image, passes.COMBINED)
    rows, columns = image.channels['R'].shape
    buffer = gpu.types.Buffer('FLOAT', values.size, np.ascontiguousarray(values.ravel()))
    return gpu.types.GPUTexture((columns, rows), format='RGBA16F', data=buffer)


def _view_key(context):
    region = context.region_data
    matrices = (region.view_matrix, region.window_matrix)
    return (tuple(tuple(row) for matrix in matrices for row in matrix),
            context.region.width, context.region.height)


def _film(context):
    width, height = context.region.width, context.region.height
    scale = min(1.0, LONGEST_SIDE / max(width, height))
    return Film(max(int(width * scale), 1), max(int(height * scale), 1), seconds=SECONDS)


def _seen_by(context):
    """View and matrix of the viewport."""
    region = context.region_data
    matrix = region.window_matrix
    kind = 'perspective' if region.is_perspective else 'orthographic'
    space = context.space_data
    return (View(kind, window_of(matrix, not region.is_perspective), near=space.clip_start,
                 far=space.clip_end), region.view_matrix.inverted())
