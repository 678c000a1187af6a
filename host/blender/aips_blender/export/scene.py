"""Exports a scene of Blender: one .lxs file, and its meshes and images in a folder beside it."""
import dataclasses
import os

from . import camera, film as film_statements, meshes
from .images import Images, safe_name
from .left_out import LeftOut
from .lights import Lights
from .lxs_text import LxsText, parameter
from .materials import Materials
from .media import CLEAR, Media
from .motion import Motion, instance_key
from .shapes import Mesh, Placed, Shapes
from .spaces import Space, Spaces, is_solid
from .textures import Textures
from .world import World

GEOMETRY = {'MESH', 'CURVE', 'SURFACE', 'FONT', 'META'}
# Modifiers that mostly change a mesh from frame to frame.
DEFORMS = {'ARMATURE', 'CLOTH', 'HOOK', 'MESH_CACHE', 'MESH_SEQUENCE_CACHE', 'OCEAN', 'SOFT_BODY',
           'WAVE'}
KINDS_OF_RAYS = ('camera', 'diffuse', 'glossy', 'transmission', 'volume_scatter', 'shadow')
NOTHING = {'EMPTY', 'CAMERA', 'ARMATURE', 'LATTICE', 'LIGHT_PROBE', 'SPEAKER', 'LIGHT'}


class ExportError(Exception):
    """The scene cannot be exported; the text says why."""


@dataclasses.dataclass
class Exported:
    path: str
    left_out: list  # lines of text


def export(path, depsgraph, film, frame_set=None, view=None):
    """Writes `path` and the folder beside it.

    `frame_set(frame, subframe)` moves the dependency graph in time, for motion blur; `view` is a
    (View, matrix) in place of the scene's camera.
    """
    folder = os.path.splitext(path)[0] + '-files'
    try:
        os.makedirs(folder, exist_ok=True)
        export_ = _SceneExport(os.path.dirname(path), folder, depsgraph)
        export_.collect(Motion(depsgraph, frame_set))
        text = export_.text_of(film, os.path.splitext(os.path.basename(path))[0], view)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)
    except OSError as error:
        where = error.filename or folder
        raise ExportError(f'{where} cannot be written: {error.strerror}') from error
    return Exported(path, export_.left_out.lines())


class _SceneExport:
    def __init__(self, base, folder, depsgraph):
        self._folder = folder
        self._depsgraph = depsgraph
        self.left_out = LeftOut()
        self._text = LxsText(base)
        self._textures = Textures(self._text, Images(folder, self.left_out), self.left_out)
        self._materials = Materials(self._text, self._textures, self.left_out)
        self._lights = Lights(self._text, folder, self._textures, self.left_out)
        self._meshes, self._placed, self._lamps = {}, [], []
        self._camera = None

    def collect(self, motion):
        """Writes meshes and materials, and notes what is placed where."""
        for instance in self._depsgraph.object_instances:
            if not instance.show_self and not instance.is_instance:
                continue
            self._collect_instance(instance, motion)
        scene_camera = self._depsgraph.scene_eval.camera
        if scene_camera is not None:
            self._camera = scene_camera.evaluated_get(self._depsgraph)
            self._camera_matrices = motion.of(None, self._camera.matrix_world.copy())

    def _collect_instance(self, instance, motion):
        thing = instance.object
        self._tell_hair(thing)
        self._tell_visibility(thing)
        if motion.blurs and any(m.type in DEFORMS for m in thing.modifiers):
            self.left_out.add("deformation within the shutter's time is left out", thing.name)
        matrices = motion.of(instance_key(instance), instance.matrix_world.copy())
        if thing.type in GEOMETRY:
            key = self._mesh_of(thing)
            if key is not None:
                self._placed.append(Placed(thing.name, key, matrices, thing.original.lightgroup))
        elif thing.type == 'LIGHT':
            if len(matrices) > 1:
                self.left_out.add('motion of what shines is left out', thing.name)
            # The evaluated light goes with the instance; names lead back to it.
            self._lamps.append((thing.name, thing.data, matrices[0], thing.visible_camera,
                                thing.original.lightgroup))
        elif thing.type == 'CURVES':
            self.left_out.add('hair is left out', thing.name)
        elif thing.type not in NOTHING:
            self.left_out.add(f'objects of type {thing.type.lower()} are left out', thing.name)

    def _tell_hair(self, thing):
        for system in thing.particle_systems:
            if system.settings.type == 'HAIR' and system.settings.render_type == 'PATH':
                self.left_out.add('hair is left out', thing.name)

    def _tell_visibility(self, thing):
        """Of lights all but what is hidden from the camera, which is carried over."""
        if thing.type in GEOMETRY:
            if not all(getattr(thing, f'visible_{kind}') for kind in KINDS_OF_RAYS):
                self.left_out.add('what is hidden from some rays is seen by all', thing.name)
            if thing.is_holdout or thing.is_shadow_catcher:
                self.left_out.add('holdouts and shadow catchers are shown as objects', thing.name)
        elif thing.type == 'LIGHT':
            if not all(getattr(thing, f'visible_{kind}') for kind in KINDS_OF_RAYS[1:]):
                self.left_out.add('lights hidden from some rays shine on all', thing.name)
            if not getattr(getattr(thing.data, 'cycles', None), 'cast_shadow', True):
                self.left_out.add('lights without shadows cast them', thing.name)

    def _mesh_of(self, thing):
        """Key of a mesh with its materials, written where it is new; None without triangles."""
        slots = tuple(s.material.name_full if s.material else '' for s in thing.material_slots)
        data = thing.data.as_pointer() if thing.type == 'MESH' else thing.as_pointer()
        key = (data, slots)
        if key not in self._meshes:
            self._meshes[key] = self._written_mesh(thing)
        return key if self._meshes[key] else None

    def _written_mesh(self, thing):
        materials = [s.material for s in thing.material_slots] or [None]

        def shader(slot):
            return self._materials.shader(materials[min(slot, len(materials) - 1)])

        mesh = thing.to_mesh()
        try:
            stem = f'{len(self._meshes)}-{safe_name(thing.name)}'
            parts = mesh and meshes.write_parts(mesh, self._folder, stem, shader)
        finally:
            thing.to_mesh_clear()
        if parts is None:
            return None
        shaders = {slot: shader(slot) for slot in parts.files}
        if parts.triangles is not None and not self._may_be_filled(thing, parts):
            parts.triangles = None
            shaders = {slot: dataclasses.replace(s, medium=CLEAR) for slot, s in shaders.items()}
        return Mesh(thing.name, parts, shaders)

    def _may_be_filled(self, thing, parts):
        """Whether the volume of a mesh's material can be carried over."""
        if not parts.closed:
            self.left_out.add('volumes of meshes that are not closed are left out', thing.name)
            return False
        if any(m.type == 'FLUID' and m.fluid_type == 'DOMAIN' for m in thing.modifiers):
            self.left_out.add('smoke and fire are left out', thing.name)
            return False
        return True

    def text_of(self, film, name, view):
        """The whole scene; materials are written by now, and stand before what uses them."""
        world = World(self._text, self._folder, self._textures, self.left_out)
        spaces = self._spaces(world.medium(self._depsgraph.scene_eval.world))
        materials = self._taken_lines()
        place = self._write_view(film, view)
        camera_lines = self._taken_lines()
        media = Media(self._text)
        self._write_things(world, media, spaces, 'objects' in film.layers)
        media.sides(CLEAR, spaces.at(place))  # at the end it is what the camera stands in
        things = self._taken_lines()
        if self._depsgraph.scene.render.film_transparent:
            self.left_out.add('transparent backgrounds are left out', self._depsgraph.scene.name)
        self._text.comment("Exported from Blender by the add-on of aips.")
        film_statements.write(self._text, film, name)
        if spaces.scatter():
            self._text.statement('VolumeIntegrator', 'multi')
        self._text.lines += camera_lines
        self._text.statement('WorldBegin')
        self._text.lines += materials + media.statements + things
        self._text.statement('WorldEnd')
        return self._text.text()

    def _taken_lines(self):
        """What has been written so far, to be put elsewhere."""
        lines, self._text.lines[:] = list(self._text.lines), []
        return lines

    def _spaces(self, world_medium):
        spaces = Spaces(world_medium, self.left_out)
        for placed in self._placed:
            mesh = self._meshes[placed.mesh]
            if mesh.parts.triangles is not None and is_solid(placed.matrices[0]):
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

    def _write_things(self, world, media, spaces, names_apart):
        """Lights and shapes, with the media that they stand in."""
        world.write(self._depsgraph.scene_eval.world, media, spaces.world)
        for name, light, matrix, seen, group in self._lamps:
            far = light.type == 'SUN'
            around = spaces.world if far else spaces.at([matrix[row][3] for row in range(3)])
            self._text.statement('AttributeBegin')
            media.sides(around, around)
            self._lights.write(name, light, matrix, seen, group)
            self._text.statement('AttributeEnd')
        Shapes(self._text, media, spaces, self.left_out, names_apart).write(self._meshes,
                                                                            self._placed)

    def _write_view(self, film, view):
        """Writes the camera; its place."""
        if view is not None:
            shown, matrices = view[0], (view[1],)
        elif self._camera is not None:
            render = self._depsgraph.scene.render
            shown = camera.view_of(self._camera, self._depsgraph, film.width, film.height,
                                   (render.pixel_aspect_x, render.pixel_aspect_y), self.left_out)
            matrices = self._camera_matrices
        else:
            raise ExportError('the scene has no camera')
        if len(matrices) > 1:
            self._text.lines.append('MotionBegin [0 1]')
        for matrix in matrices:
            self._text.statement('LookAt', *map(float, camera.look_at(matrix)))
        if len(matrices) > 1:
            self._text.lines.append('MotionEnd')
        shutter = [parameter('float', 'shutteropen', 0.0), parameter('float', 'shutterclose', 1.0)]
        self._text.statement('Camera', shown.kind, parameters=shown.parameters() + shutter)
        return [matrices[0][row][3] for row in range(3)]
