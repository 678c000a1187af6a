"""Reads what a mesh has at the corners of its triangles: place, normal, uv and colour."""
import dataclasses

import numpy as np

from .layers import RENDERED, chosen


def array(collection, attribute, kind, width):
    """Values of an attribute of all items, one row each."""
    values = np.empty(len(collection) * width, kind)
    collection.foreach_get(attribute, values)
    return values.reshape(-1, width)


def uv_of(layer):
    """Of a uv map, one row a loop."""
    if hasattr(layer, 'uv'):  # from 3.5 on
        return array(layer.uv, 'vector', np.float32, 2)
    return array(layer.data, 'uv', np.float32, 2)


@dataclasses.dataclass
class Read:
    """Values of a mesh's layers; of colours also whether they are a vertex's, else a loop's."""
    uv: object = None
    second: object = None  # uv
    colors: object = None
    by_vertex: bool = False


class Corners:
    """What is made of a mesh is apart from it: `rows` may be called once it is gone."""

    def __init__(self, mesh):
        if hasattr(mesh, 'calc_normals_split'):  # from 4.1 on normals are there unasked
            mesh.calc_normals_split()
        mesh.calc_loop_triangles()
        self._mesh = mesh
        triangles = mesh.loop_triangles
        self._loops = array(triangles, 'loops', np.int32, 3).ravel()
        of_loops = array(mesh.loops, 'vertex_index', np.int32, 1).ravel()
        self._vertices = of_loops[self._loops]
        self._normals = array(triangles, 'split_normals', np.float32, 9).reshape(-1, 3)
        self._places = array(mesh.vertices, 'co', np.float32, 3)
        self._slots = array(triangles, 'material_index', np.int32, 1).ravel()
        self.slots = list(map(int, np.flatnonzero(np.bincount(self._slots))))

    def bounds(self):
        """Least and greatest coordinates of what has faces."""
        used = np.zeros(len(self._places), bool)
        used[self._vertices] = True
        places = self._places[used]
        return places.min(axis=0), places.max(axis=0)

    @property
    def positions(self):
        """Three rows a triangle."""
        return self._places[self._vertices]

    def read(self, layers, tell):
        """The Read of a mesh that is still there, of the Layers that a material reads."""
        first, *others = [self._uv(name, tell) for name in layers.uv or (RENDERED,)]
        if first is None:
            return self._colors(layers.colors, tell)
        if others:
            return Read(uv_of(first), uv_of(others[0]))
        return dataclasses.replace(self._colors(layers.colors, tell), uv=uv_of(first))

    def rows(self, slot, read):
        """Rows of a material slot's corners, and whether these hold uv and colours."""
        there = np.repeat(self._slots == slot, 3)
        loops, vertices = self._loops[there], self._vertices[there]
        columns = [self._places[vertices], self._normals[there]]
        if read.uv is not None:
            columns.append(read.uv[loops])
        if read.second is not None:
            second = read.second[loops]
            columns += [second, np.zeros((len(second), 1), np.float32)]
        elif read.colors is not None:
            columns.append(read.colors[vertices if read.by_vertex else loops])
        colored = read.second is not None or read.colors is not None
        return np.hstack(columns), read.uv is not None, colored

    def _uv(self, name, tell):
        maps = self._mesh.uv_layers
        if name and name not in maps:
            tell('uv maps that are not there are replaced by the one for renders')
        return maps.get(name) or next((m for m in maps if m.active_render), None)

    def _colors(self, read, tell):
        """The Read of a layer of colours."""
        if not read:
            return Read()
        layers = self._mesh.color_attributes
        at = layers.render_color_index
        name, others = chosen(read, layers[at].name if 0 <= at < len(layers) else '')
        if others:
            tell('of the colours that a material reads one layer is taken')
        found = layers.get(name)
        if found is None and name not in self._mesh.attributes:  # as Cycles has it
            return Read(colors=np.zeros((len(self._places), 3), np.float32), by_vertex=True)
        if found is None or found.domain not in ('POINT', 'CORNER'):
            tell('attributes that are no colours are taken for white')
            return Read()
        return Read(colors=array(found.data, 'color', np.float32, 4)[:, :3],
                    by_vertex=found.domain == 'POINT')
