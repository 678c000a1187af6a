"""Tells where textures are looked up: by uv, which node Mapping scales and shifts."""
from . import graph
from .layers import RENDERED
from .lxs_text import parameter


class Coordinates:
    def __init__(self, read, left_out):
        self._read = read  # layers.Read
        self._left_out = left_out

    @staticmethod
    def are_plain(found):
        """Whether a texture node is looked up by uv, at most scaled and shifted by constants."""
        place = found.input('Vector')
        before = graph.source(place) if place else None
        if before and before.node.type == 'MAPPING':
            if any(graph.source(before.input(what)) for what in ('Scale', 'Rotation', 'Location')
                   if before.input(what)):
                return False
            turn = before.input('Rotation')
            if before.node.vector_type == 'NORMAL' or turn and any(graph.constant(turn)):
                return False
            before = graph.source(before.input('Vector'))
            if before is None:
                return False
        return before is None or before.node.type == 'UVMAP' or (
            before.node.type == 'TEX_COORD' and before.output.name == 'UV')

    def uv(self, found):
        """Scale and shift of the uv that a texture node is looked up by, if these are all."""
        scale, shift = (1.0, 1.0), (0.0, 0.0)
        before = self._before(found)
        if before and before.node.type == 'MAPPING':
            scale, shift = self._mapped(before)
        self.place_of(self._map_of(found))
        return scale, shift

    def are_of_first(self, found):
        """Whether those of a texture node that are plain are of the file's first uv map."""
        return self.place_of(self._map_of(found)) == 0

    def place_of(self, name):
        """Number of a uv map's place in the mesh's file."""
        place = self._read.place_of_uv(name)
        if place is None:
            self._left_out.add('of the uv maps and colours that a material reads two are taken')
        return place or 0

    @staticmethod
    def _before(found):
        place = found.input('Vector')
        return graph.source(place) if place else None

    def _map_of(self, found):
        """Name of the uv map that a texture node reads, by a node Mapping or not."""
        before = self._before(found)
        if before and before.node.type == 'MAPPING':
            before = graph.source(before.input('Vector'))
        return before.node.uv_map if before and before.node.type == 'UVMAP' else RENDERED

    def _mapped(self, before):
        """Scale and shift of a node Mapping."""
        scale, shift = (self.vector(before, what) for what in ('Scale', 'Location'))
        if before.node.vector_type == 'TEXTURE':
            shift = tuple(-m / s if s else 0.0 for m, s in zip(shift, scale))
            scale = tuple(1 / s if s else 1.0 for s in scale)
        return scale, shift

    def vector(self, before, what):
        """Three constants of a node Mapping; those that its type has not are 0."""
        place = before.input(what)
        if place is None:
            return (0.0, 0.0, 0.0)
        found = graph.source(place)
        if found and found.node.type == 'VALUE':
            return (float(found.output.default_value),) * 3
        if found:
            self._left_out.add('linked inputs of node Mapping are taken as they are set')
        return graph.constant(place)


def uv_parameters(scale, shift):
    return [parameter('float', 'uscale', scale[0]), parameter('float', 'vscale', scale[1]),
            parameter('float', 'udelta', shift[0]), parameter('float', 'vdelta', shift[1])]
