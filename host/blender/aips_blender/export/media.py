"""Turns Blender's volume shaders into homogeneous volumes of the scene language."""
import dataclasses

from . import graph
from .lxs_text import color

NONE = (0.0, 0.0, 0.0)


@dataclasses.dataclass(frozen=True)
class Medium:
    """Coefficients per metre, and the mean cosine of Henyey and Greenstein's phase function."""
    absorbs: tuple = NONE
    scatters: tuple = NONE
    cosine: float = 0.0

    def times(self, share):
        return Medium(_times(self.absorbs, share), _times(self.scatters, share), self.cosine)


CLEAR = Medium()


def _times(rgb, factor):
    return tuple(c * factor for c in rgb)


def _plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def both(a, b):
    """The medium where two overlap; of two phase functions it has the mean cosine."""
    if CLEAR in (a, b):
        return b if a == CLEAR else a
    weights = sum(a.scatters), sum(b.scatters)
    total = sum(weights)
    cosine = (weights[0] * a.cosine + weights[1] * b.cosine) / total if total else 0.0
    return Medium(_plus(a.absorbs, b.absorbs), _plus(a.scatters, b.scatters), cosine)


class MediumNodes:
    """Reads volume shaders as Cycles 3.4 has them, alike all over a volume."""

    def __init__(self, textures, left_out):
        self._textures = textures
        self._left_out = left_out
        self._leaves = {'VOLUME_ABSORPTION': self._absorption, 'VOLUME_SCATTER': self._scatter,
                        'PRINCIPLED_VOLUME': self._principled, 'ADD_SHADER': self._sum,
                        'MIX_SHADER': self._mix}

    def of(self, place, name):
        """The Medium of what feeds a socket Volume; `name` is that of the material or world."""
        self._left_out.reading = name
        found = graph.source(place)
        if found is None:
            return CLEAR
        make = self._leaves.get(found.node.type)
        if make is None:
            self._left_out.add(f'shaders {found.node.bl_label} of volumes are left out', name)
            return CLEAR
        medium = make(found, name)
        return medium if any(medium.absorbs + medium.scatters) else CLEAR

    def _color(self, found, socket, name):
        rgb = self._textures.color(found.input(socket))
        if isinstance(rgb, str):
            self._left_out.add('textures of volumes are left out', name)
            rgb = tuple(found.input(socket).socket.default_value[:3])
        return tuple(max(c, 0.0) for c in rgb)

    def _number(self, found, socket):
        return self._textures.constant_number(found.input(socket), 'volumes')

    def _absorption(self, found, name):
        density = max(self._number(found, 'Density'), 0.0)
        tint = self._color(found, 'Color', name)
        return Medium(absorbs=tuple(max(1 - c, 0.0) * density for c in tint))

    def _scatter(self, found, name):
        density = max(self._number(found, 'Density'), 0.0)
        return Medium(scatters=_times(self._color(found, 'Color', name), density),
                      cosine=self._number(found, 'Anisotropy'))

    def _principled(self, found, name):
        if any(self._number(found, light) > 0
               for light in ('Emission Strength', 'Blackbody Intensity')):
            self._left_out.add('light of volumes is left out', name)
        density = max(self._number(found, 'Density'), 0.0)
        tint = self._color(found, 'Color', name)
        dims = self._color(found, 'Absorption Color', name)
        return Medium(tuple(max(1 - c, 0.0) * max(1 - d ** 0.5, 0.0) * density
                            for c, d in zip(tint, dims)),
                      _times(tint, density), self._number(found, 'Anisotropy'))

    def _parts(self, found, name):
        return [self.of(graph.Place(s, found.groups), name) for s in found.node.inputs
                if s.type == 'SHADER']

    def _sum(self, found, name):
        return both(*self._parts(found, name))

    def _mix(self, found, name):
        share = min(max(self._number(found, 'Fac'), 0.0), 1.0)
        first, second = self._parts(found, name)
        return both(first.times(1 - share), second.times(share))


class Media:
    """Named volumes of the scene language, each medium once."""

    def __init__(self, text):
        self._text = text
        self._names = {CLEAR: ''}
        self.statements = []  # to stand before what uses them

    def sides(self, interior, exterior):
        """Says what the shapes that follow bound."""
        for statement, medium in (('Interior', interior), ('Exterior', exterior)):
            if medium != CLEAR:
                self._text.statement(statement, self._name(medium))

    def _name(self, medium):
        if medium not in self._names:
            name = f'volume {len(self._names)}'
            self._names[medium] = name
            self.statements.append(self._text.written(
                'MakeNamedVolume', name, 'homogeneous', parameters=[
                    color('sigma_a', medium.absorbs), color('sigma_s', medium.scatters),
                    color('g', (medium.cosine,) * 3)]))
        return self._names[medium]
