"""Reads what a mesh has at the corners of its triangles: place, normal, uv and colour."""
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


class Corners:
    def __init__(self, mesh):
        if hasattr(mesh, 'calc_normals_split'):  # from 4.1 on normals are there unasked
            mesh.calc_normals_split()
        mesh.calc_loop_triangles()
        self._mesh = mesh
        triangles = mesh.loop_triangles
        self._loops = array(triangles, 'loops', np.int32, 3).ravel()
        self._vertices = array(triangles, 'vertices', np.int32, 3).ravel()
        self._normals = array(triangles, 'split_normals', np.float32, 9).reshape(-1, 3)
        self.positions = array(mesh.vertices, 'co', np.float32, 3)[self._vertices]
        self.slots = array(triangles, 'material_index', np.int32, 1).ravel()

    def rows(self, slot, layers, tell):
        """Rows of a material slot's corners, with the Layers that its material reads, if there
        are; and whether these hold uv and colours."""
        there = np.repeat(self.slots == slot, 3)
        columns = [self.positions[there], self._normals[there]]
        first, *others = [self._uv(name, tell) for name in layers.uv or (RENDERED,)]
        if first is not None:
            columns.append(uv_of(first)[self._loops[there]])
        colors = self._colors(layers.colors, there, tell) if layers.colors else None
        if others and first is not None:
            second = uv_of(others[0])[self._loops[there]]
            colors = np.hstack([second, np.zeros((len(second), 1), np.float32)])
        if colors is not None:
            columns.append(colors)
        return np.hstack(columns), first is not None, colors is not None

    def _uv(self, name, tell):
        maps = self._mesh.uv_layers
        if name and name not in maps:
            tell('uv maps that are not there are replaced by the one for renders')
        return maps.get(name) or next((m for m in maps if m.active_render), None)

    def _colors(self, read, there, tell):
        layers = self._mesh.color_attributes
        at = layers.render_color_index
        name, others = chosen(read, layers[at].name if 0 <= at < len(layers) else '')
        if others:
            tell('of the colours that a material reads one layer is taken')
        found = layers.get(name)
        if found is None and name not in self._mesh.attributes:
            return np.zeros((there.sum(), 3), np.float32)  # as Cycles has it
        if found is None or found.domain not in ('POINT', 'CORNER'):
            tell('attributes that are no colours are taken for white')
            return None
        rows = (self._loops if found.domain == 'CORNER' else self._vertices)[there]
        return array(found.data, 'color', np.float32, 4)[rows, :3]
