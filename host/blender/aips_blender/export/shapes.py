"""Writes meshes with their materials: once each, in place, or as instances of an object."""
import dataclasses

import numpy as np

from .colours import light_color
from .lights import hidden
from .lxs_text import color, factor, parameter
from .media import both
from .spaces import LEAST_OVERLAP, box_of, corners_of, transformed


@dataclasses.dataclass
class Placed:
    """A mesh at its places: one matrix, or one at either end of the shutter's time."""
    name: str
    mesh: object         # key of the mesh and its materials
    matrices: tuple
    light_group: str = ''
    flat: bool = False   # whether it is flattened, and has no inside


@dataclasses.dataclass
class Mesh:
    name: str
    parts: object        # MeshParts
    shaders: dict        # Shader by slot

    def emits(self):
        return any(s.emission is not None for s in self.shaders.values())


class Shapes:
    """`names_apart`: whether instances of one mesh by several objects have the objects' names;
    `exposure` multiplies what shines."""

    def __init__(self, text, media, spaces, left_out, names_apart, exposure):
        self._exposure = exposure
        self._text = text
        self._media = media
        self._spaces = spaces
        self._left_out = left_out
        self._names_apart = names_apart

    def write(self, meshes, placed):
        """Meshes by key, and all that is placed of them."""
        counts = {}
        for each in placed:
            counts[each.mesh] = counts.get(each.mesh, 0) + len(each.matrices)
        named = {}
        boxes = None
        for i, each in enumerate(placed):
            mesh = meshes[each.mesh]
            around = self._spaces.around(each, mesh.parts.bounds)
            if mesh.emits() or counts[each.mesh] == 1:
                if mesh.parts.shines_outwards and boxes is None:
                    boxes = np.array([_box(meshes[other.mesh], other) for other in placed])
                both_sides = not mesh.parts.shines_outwards or _holds_another(boxes, i)
                self._in_place(mesh, each, around, both_sides)
                continue
            key = (each.mesh, around)
            if key not in named:
                named[key] = self._object(mesh, around)
            self._instance(self._name_of(each, mesh, key, named), each)

    def _name_of(self, placed, mesh, key, named):
        """The object to place: where masks tell objects apart, one of this object's name."""
        if not self._names_apart:
            return named[key]
        own = key if placed.name == mesh.name else (*key, placed.name)
        if own not in named:
            named[own] = self._text.free_name(placed.name, 'object')
            self._text.statement('ObjectBegin', named[own])
            self._text.statement('ObjectInstance', named[key])
            self._text.statement('ObjectEnd')
        if named[own] != placed.name:
            self._left_out.add('masks tell objects of one name apart by a number', named[own])
        return named[own]

    def _in_place(self, mesh, placed, around, both_sides):
        if len(placed.matrices) > 1:
            self._left_out.add('motion of what shines is left out', placed.name)
        self._text.statement('AttributeBegin')
        self._text.matrix('ConcatTransform', placed.matrices[0])
        if placed.light_group and mesh.emits():
            self._text.statement('LightGroup', placed.light_group)
        for slot, path in mesh.parts.files.items():
            shader = mesh.shaders[slot]
            self._text.statement('AttributeBegin')
            self._text.statement('NamedMaterial', shader.name)
            within = both(shader.medium, around)
            self._media.sides(within, around)
            if shader.emission is not None:
                self._emission(shader)
            self._plymesh(path, placed.name)
            if shader.emission is not None and both_sides:
                self._back(mesh.parts.backs[slot], placed.name, within)
            self._text.statement('AttributeEnd')
        self._text.statement('AttributeEnd')

    def _back(self, path, name, within):
        """What shines on the other side, and is else not there."""
        self._text.statement('Material', 'null')
        self._media.sides(within, within)
        self._plymesh(path, name)

    def _emission(self, shader):
        light = shader.emission
        if isinstance(light, tuple):
            light = light_color(light)
        self._text.statement('AreaLightSource', 'area', parameters=[
            color('L', light), factor('gain', self._exposure), factor('power', 0.0),
            factor('efficacy', 0.0), *hidden(shader.hidden)])

    def _plymesh(self, path, name):
        self._text.statement('Shape', 'plymesh', parameters=[
            self._text.file(path), parameter('string', 'name', name)])

    def _object(self, mesh, around):
        name = self._text.free_name(mesh.name, 'object')
        self._text.statement('ObjectBegin', name)
        for slot, path in mesh.parts.files.items():
            shader = mesh.shaders[slot]
            self._text.statement('AttributeBegin')
            self._text.statement('NamedMaterial', shader.name)
            self._media.sides(both(shader.medium, around), around)
            self._plymesh(path, mesh.name)
            self._text.statement('AttributeEnd')
        self._text.statement('ObjectEnd')
        return name

    def _instance(self, name, placed):
        self._text.statement('AttributeBegin')
        if len(placed.matrices) > 1:
            self._text.lines.append('MotionBegin [0 1]')
        for matrix in placed.matrices:
            self._text.matrix('ConcatTransform', matrix)
        if len(placed.matrices) > 1:
            self._text.lines.append('MotionEnd')
        self._text.statement('ObjectInstance', name)
        self._text.statement('AttributeEnd')


def _box(mesh, placed):
    return box_of(transformed(corners_of(mesh.parts.bounds), placed.matrices[0]))


def _holds_another(boxes, i):
    """Whether the box of what is placed as number i holds another's."""
    least, most = boxes[:, 0], boxes[:, 1]
    slack = LEAST_OVERLAP * (most[i] - least[i]).max()
    held = (least >= least[i] - slack).all(axis=1) & (most <= most[i] + slack).all(axis=1)
    return held.sum() > 1
