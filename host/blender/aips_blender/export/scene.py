"""Exports a scene of Blender: one .lxs file, and its meshes and images in a folder beside it."""
import contextlib
import dataclasses
import functools
import math
import os
import time
from concurrent.futures import ThreadPoolExecutor, wait

import bpy

from ..reasons import Told
from . import camera, versions
from .domains import of_domain, settings_of
from .grids import of_volume
from .images import Images
from .left_out import LeftOut
from .lights import Lights
from .lxs_text import LxsText
from .materials import Materials
from .media import CLEAR, Media
from .mesh_files import MeshFiles
from .motion import Motion, instance_key
from .object_info import ObjectInfo
from .objects import Objects
from .scene_text import SceneText
from .shapes import Placed, Shapes
from .spaces import Space, Spaces
from .textures import Textures
from .transforms import is_seen, is_singular, placeable
from .world import World


class ExportError(Told):
    """The scene cannot be exported; the text says why."""


@dataclasses.dataclass
class Exported:
    path: str
    left_out: list  # lines of text
    camera: tuple   # View, and its matrices while the shutter is open
    _text: SceneText

    def look(self, film, shown, matrices):
        """Writes `path` anew for another film and View; the rest of its files stays."""
        name = os.path.splitext(os.path.basename(self.path))[0]
        with _told_by_path(self.path), open(self.path, 'w', encoding='utf-8') as file:
            file.write(self._text.of(film, name, shown, matrices))


def export(path, depsgraph, film, frame_set=None, kept=None):
    """Writes `path` and the folder beside it.

    `frame_set(frame, subframe)` moves the dependency graph in time, for motion blur; `kept` is a
    Kept, in whose folder meshes and images then lie.
    """
    exporting = Exporting(path, depsgraph, film, Motion(depsgraph, frame_set), kept=kept)
    while True:
        exported = exporting.go_on()
        if exported:
            return exported


class Exporting:
    """An export that goes on in slices, so that Blender's interface goes on, too.

    Between slices the dependency graph must not change. `view` is a (View, matrix) in place of the
    scene's camera; `noted`: whether `kept` is told of meshes that change.
    """

    def __init__(self, path, depsgraph, film, motion, view=None, kept=None, noted=False):
        self._path, self._film, self._view, self._motion = path, film, view, motion
        self._kept = kept
        self._own_worker = None if kept else ThreadPoolExecutor(1)
        self._jobs = []    # the futures of what is written aside
        self._text = None  # the future of the whole text
        folder = os.path.splitext(path)[0] + '-files'
        if kept:
            kept.begin()
        with _told_by_path(folder):
            os.makedirs(folder, exist_ok=True)
        self._export = _SceneExport(os.path.dirname(path), folder, depsgraph, self._work, kept,
                                    noted)

    def _work(self, what, *arguments):
        worker = self._kept.worker if self._kept else self._own_worker
        self._jobs.append(worker.submit(what, *arguments))
        return self._jobs[-1]

    def go_on(self, seconds=math.inf):
        """For about so long, one mesh at least; the Exported once all is written, else None."""
        with _told_by_path(self._path):
            if self._text is None:
                if not self._export.collect(self._motion, time.monotonic() + seconds):
                    return None
                self._camera = self._export.view(self._film) if self._view is None else \
                    (self._view[0], (self._view[1],))
                write = self._export.text('objects' in self._film.layers)
                self._text = self._work(self._finish, write)
            wait([self._text], None if seconds == math.inf else seconds)
            if not self._text.done():
                return None
            for job in self._jobs:
                job.result()
        if self._kept:
            self._kept.done()
        else:
            self._own_worker.shutdown()
        return self._text.result()

    def _finish(self, write):
        text = write()  # which tells what is left out, too
        exported = Exported(self._path, self._export.left_out.lines(), self._camera, text)
        exported.look(self._film, *self._camera)
        return exported


@contextlib.contextmanager
def _told_by_path(path):
    try:
        yield
    except OSError as error:
        where = error.filename or path
        raise ExportError(f'{where} cannot be written: {error.strerror}') from error


class _SceneExport:
    def __init__(self, base, folder, depsgraph, work, kept, noted):
        self._folder = folder
        self._depsgraph = depsgraph
        layer = depsgraph.view_layer_eval
        # Worlds are no part of view layers without a sky.
        self._world = depsgraph.scene_eval.world if layer.use_sky else None
        self.left_out = LeftOut()
        self._text = LxsText(base)
        images = Images(kept.folder if kept else folder, self.left_out)
        self._textures = Textures(self._text, images, self.left_out)
        self._exposure = versions.film_exposure(depsgraph.scene)
        self._lights = Lights(self._text, folder, self._textures, self.left_out, self._exposure)
        self._objects = Objects(depsgraph.view_layer, self.left_out)
        self._meshes = MeshFiles(folder, Materials(
            self._text, self._textures, self.left_out, layer.material_override),
            self.left_out, work, kept, noted)
        self._with_volumes = layer.use_volumes
        self._grids = {}  # Grids by the data of objects
        self._placed, self._lamps = [], []
        self._camera = None

    def collect(self, motion, until):
        """Writes meshes and materials, and notes what is placed where; False where time is up, to
        be begun anew: what is written by then takes next to no time."""
        self._placed, self._lamps = [], []
        begun = len(self._meshes.known)
        for instance in self._depsgraph.object_instances:
            if len(self._meshes.known) > begun and time.monotonic() > until:
                return False
            matrices = motion.of(instance_key(instance), instance.matrix_world.copy())
            info = ObjectInfo(instance, matrices[0], self._grids_of(instance.object))
            if instance.show_self:
                self._collect_instance(instance, info, matrices, motion.blurs)
            if instance.show_particles:
                self._collect_hair(instance.object, info, matrices)
        scene_camera = self._depsgraph.scene_eval.camera
        if scene_camera is not None:
            self._camera = scene_camera.evaluated_get(self._depsgraph)
            self._camera_matrices = motion.of(None, self._camera.matrix_world.copy())
        return True

    def _collect_instance(self, instance, info, matrices, blurs):
        thing = instance.object
        self._objects.tell(instance, blurs)
        # Curves, texts and metaballs come as themselves too, beside an instance of their mesh.
        if isinstance(thing.data, bpy.types.Mesh):
            self._place(thing, info, self._meshes.of, matrices)
        elif isinstance(thing.data, bpy.types.Volume):
            if info.grids:
                self._place(thing, info, self._meshes.volume, matrices)
        elif thing.type == 'CURVES':
            self._place(thing, info, self._meshes.curves, matrices)
        elif thing.type == 'LIGHT':
            if len(matrices) > 1:
                self.left_out.add('motion of what shines is left out', thing.name)
            # The evaluated light goes with the instance; names lead back to it.
            self._lamps.append((thing.name, thing.data, matrices[0], thing.visible_camera,
                                thing.original.lightgroup))

    def _grids_of(self, thing):
        """The Grids in an object, or None; each file is looked for once."""
        is_volume = isinstance(thing.data, bpy.types.Volume)
        domain = None if is_volume else settings_of(thing)
        if not is_volume and not domain or not self._with_volumes:
            return None
        key = thing.data.as_pointer()
        if key not in self._grids:
            self._grids[key] = of_volume(thing, self._folder, len(self._grids)) if is_volume else \
                of_domain(thing, domain, bpy.path.abspath(domain.cache_directory),
                          self._depsgraph.scene.frame_current)
            if is_volume and self._grids[key] is None:
                self.left_out.add('volumes whose files cannot be read are left out', thing.name)
        return self._grids[key]

    def _collect_hair(self, thing, info, matrices):
        for number, system in enumerate(thing.particle_systems):
            settings = system.settings
            if settings.type == 'HAIR' and settings.render_type == 'PATH':
                key_of = functools.partial(self._meshes.hair, system=system, number=number,
                                           for_render=self._depsgraph.mode == 'RENDER')
                self._place(thing, info, key_of, matrices)

    def _place(self, thing, info, key_of, matrices):
        """`key_of(thing, info)` writes it where it is new."""
        key = key_of(thing, info) if any(map(is_seen, matrices)) else None
        if key is not None:
            least, most = self._meshes.known[key].parts.bounds
            self._placed.append(Placed(
                thing.name, key, placeable(matrices, most - least), thing.original.lightgroup,
                is_singular(matrices[0])))

    def text(self, names_apart):
        """What makes the SceneText, without Blender; all materials are written by now."""
        world = World(self._text, self._folder, self._textures, self.left_out, self._exposure)
        spaces = self._spaces(world.medium(self._world))
        materials = self._text.taken()
        media = Media(self._text)
        self._write_lights(world, media, spaces)

        def write():
            Shapes(self._text, media, spaces, self.left_out, names_apart, self._exposure).write(
                self._meshes.known, self._placed)
            return SceneText(self._text, materials, self._text.taken(), media, spaces)

        return write

    def _spaces(self, world_medium):
        spaces = Spaces(world_medium, self.left_out)
        for placed in self._placed:
            mesh = self._meshes.known[placed.mesh]
            if mesh.parts.triangles is not None and not placed.flat:
                media = [s.medium for s in mesh.shaders.values()]
                self._tell_medium(placed, media)
                medium = next(m for m in media if m != CLEAR)
                spaces.add(Space(placed, medium, mesh.parts.triangles, placed.matrices[0]))
        return spaces

    def _tell_medium(self, placed, media):
        if len(set(media)) > 1:
            self.left_out.add('volumes of some faces of a mesh lie behind these alone',
                              placed.name)
        if len(placed.matrices) > 1:
            self.left_out.add('volumes that move hold what is in them as the shutter opens',
                              placed.name)

    def _write_lights(self, world, media, spaces):
        """With the media that they stand in."""
        world.write(self._world, media, spaces.world)
        for name, light, matrix, seen, group in self._lamps:
            far = light.type == 'SUN'
            around = spaces.world if far else spaces.at([matrix[row][3] for row in range(3)])
            self._text.statement('AttributeBegin')
            media.sides(around, around)
            self._lights.write(name, light, matrix, seen, group)
            self._text.statement('AttributeEnd')

    def view(self, film):
        """View and matrices of the scene's camera."""
        if self._camera is None:
            raise ExportError('the scene has no camera')
        render = self._depsgraph.scene.render
        shown = camera.view_of(self._camera, self._depsgraph, film.width, film.height,
                               (render.pixel_aspect_x, render.pixel_aspect_y), self.left_out)
        return shown, self._camera_matrices
