"""Media that fill closed meshes and the world, and the named volumes that stand for them."""
import dataclasses

from .lxs_text import color, parameter

NONE = (0.0, 0.0, 0.0)


@dataclasses.dataclass(frozen=True)
class Medium:
    """Coefficients per metre, constants and names of colour textures that add to them, the mean
    cosine of Henyey and Greenstein's phase function, and the radiance that it sends per metre."""
    absorbs: tuple = NONE
    scatters: tuple = NONE
    cosine: float = 0.0
    absorbing: tuple = ()
    scattering: tuple = ()
    emits: tuple = NONE
    emitting: tuple = ()

    def is_there(self):
        return any(self.absorbs + self.absorbing) or self.is_scattering() or self.shines()

    def shines(self):
        return any(self.emits + self.emitting)

    def is_scattering(self):
        return any(self.scatters + self.scattering)

    def weight(self):
        """How much it scatters: textures are taken for 1."""
        return sum(self.scatters) + 3 * len(self.scattering)


CLEAR = Medium()


def _plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def both(a, b):
    """The medium where two overlap; of two phase functions it has the mean cosine."""
    if CLEAR in (a, b):
        return b if a == CLEAR else a
    total = a.weight() + b.weight()
    cosine = (a.weight() * a.cosine + b.weight() * b.cosine) / total if total else 0.0
    return Medium(_plus(a.absorbs, b.absorbs), _plus(a.scatters, b.scatters), cosine,
                  tuple(sorted(a.absorbing + b.absorbing)),
                  tuple(sorted(a.scattering + b.scattering)),
                  _plus(a.emits, b.emits), tuple(sorted(a.emitting + b.emitting)))


class Media:
    """Named volumes of the scene language, each medium once."""

    def __init__(self, text):
        self._text = text
        self._names = {CLEAR: ''}
        self._sums = {}
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
            varies = medium.absorbing or medium.scattering or medium.emitting
            coefficients = [color('sigma_a', self._sum(medium.absorbs, medium.absorbing)),
                            color('sigma_s', self._sum(medium.scatters, medium.scattering))]
            if medium.shines():
                coefficients.append(color('emission', self._sum(medium.emits, medium.emitting)))
            self.statements.append(self._text.written(
                'MakeNamedVolume', name, 'heterogeneous' if varies else 'homogeneous',
                parameters=[*coefficients, color('g', (medium.cosine,) * 3)]))
        return self._names[medium]

    def _sum(self, constant, textures):
        """Three numbers, or the name of a texture."""
        if not textures:
            return constant
        if len(textures) == 1 and not any(constant):
            return textures[0]
        if (constant, textures) not in self._sums:
            self._sums[constant, textures] = self._written_sum(constant, textures)
        return self._sums[constant, textures]

    def _written_sum(self, constant, textures):
        name = self._text.free_name('sum of media')
        program = ['value ' + ' '.join(f'{c:.6g}' for c in constant)]
        for number in range(1, len(textures) + 1):
            program += [f'texture {number}',
                        f'vector add r{len(program) - 1} r{len(program)} 0 0']
        self.statements.append(self._text.written(
            'Texture', name, 'color', 'nodes', parameters=[
                parameter('string', 'program', program),
                *(parameter('texture', f'tex{i}', each) for i, each in enumerate(textures, 1))]))
        return name
