"""Programs of texture "nodes" for what fills space: there a point has a place in the world, and
values of grids, but no surface."""
from mathutils import Matrix

from .node_programs import Program


class VolumeProgram(Program):
    def local(self):
        matrix = self._textures.of_object('Matrix')
        place = self.emit('position')
        return place if matrix is None else self.affine(place, Matrix(matrix).inverted_safe())

    def uv(self, _name):
        return '0'

    def vertex_color(self, name):
        return self.grid(name) or '0'

    def grid(self, name):
        grids = (self._textures.of_object('Grids') or (None,))[0]
        grid = grids and grids.named(name)
        if grids and name in grids.lacking:
            self.tell(f'grids {name} of smoke domains are left out')
        if not grid:
            return None
        matrix = self._textures.of_object('Matrix')
        return self.texture(self._textures.grids.of(grids, grid, matrix))

    def vector_math(self, how, a, b):
        return self.emit('vector', how, a, b, '0', '0')
