"""Turns Blender's volume shaders into media, whose coefficients are constants or textures."""
import math

from . import graph
from .media import CLEAR, NONE, Medium, both
from .node_programs import TooLong, text
from .volume_programs import VolumeProgram

ONE_PHASE = 'HENYEY_GREENSTEIN'
STEFAN_BOLTZMANN = 5.670373e-8 * 1e-6 / math.pi  # in Cycles' unit of brightness


class MediumNodes:
    def __init__(self, textures, left_out):
        self._textures = textures
        self._left_out = left_out
        self._leaves = {'VOLUME_ABSORPTION': self._absorption, 'VOLUME_SCATTER': self._scatter,
                        'PRINCIPLED_VOLUME': self._principled, 'EMISSION': self._emission}

    def of(self, place, name):
        """The Medium of what feeds a socket Volume; `name` is that of the material or world."""
        self._left_out.reading = name
        return self._of(place, ())

    def of_no_material(self):
        """The Medium of a volume without a material, as Blender has it: grey smoke."""
        def half(program):
            return program.vector_math('multiply', '0.5', program.grid('density') or '1')

        return self._medium((), half, half)

    def _of(self, place, shares):
        """`shares` are places of numbers that mix what lies before, and whether it is the first
        of the two."""
        found = graph.source(place)
        if found is None:
            return CLEAR
        if found.node.type in ('ADD_SHADER', 'MIX_SHADER'):
            return self._both(found, shares)
        make = self._leaves.get(found.node.type)
        if make is None:
            self._left_out.add(f'shaders {found.node.bl_label} of volumes are left out')
        return make(found, shares) if make else CLEAR

    def _both(self, found, shares):
        first, second = [graph.Place(s, found.groups) for s in found.node.inputs
                         if s.type == 'SHADER']
        if found.node.type == 'ADD_SHADER':
            return both(self._of(first, shares), self._of(second, shares))
        share = found.input('Fac')
        return both(self._of(first, (*shares, (share, True))),
                    self._of(second, (*shares, (share, False))))

    def _absorption(self, found, shares):
        return self._medium(shares, absorbs=lambda program: program.vector_math(
            'multiply', _rest(program, program.color(found, 'Color')), _density(program, found)))

    def _scatter(self, found, shares):
        cosine = 0.0
        if getattr(found.node, 'phase', ONE_PHASE) == ONE_PHASE:  # from 4.3 on there are others
            cosine = self._cosine(found)
        else:
            self._left_out.add("phase functions but Henyey and Greenstein's are taken for even")
        return self._medium(shares, cosine=cosine, scatters=lambda program: program.vector_math(
            'multiply', program.color(found, 'Color'), _density(program, found)))

    def _emission(self, found, shares):
        return self._medium(shares, emits=lambda program: program.vector_math(
            'multiply', program.color(found, 'Color'), _at_least_0(program, found, 'Strength')))

    def _principled(self, found, shares):
        def tint(program):
            return _times_grid(program, found, 'Color Attribute', program.color(found, 'Color'))

        def density(program):
            return _times_grid(program, found, 'Density Attribute', _density(program, found))

        def absorbs(program):
            dims = program.emit('gamma', program.color(found, 'Absorption Color'), '0.5')
            share = program.vector_math('multiply', _rest(program, tint(program)),
                                        _rest(program, dims))
            return program.vector_math('multiply', share, density(program))

        return self._medium(shares, absorbs, lambda program: program.vector_math(
            'multiply', tint(program), density(program)), self._cosine(found),
                            self._shining(found))

    def _shining(self, found):
        """What a Principled Volume sends: Cycles' sum of a colour and of a black body."""
        glows, burns = [_is_above_0(found.input(name))
                        for name in ('Emission Strength', 'Blackbody Intensity')]

        def emits(program):
            colour, body = '0', '0'
            if glows:
                colour = program.vector_math('multiply', program.color(found, 'Emission Color'),
                                             _at_least_0(program, found, 'Emission Strength'))
            if burns:
                kelvin = _times_grid(program, found, 'Temperature Attribute',
                                     _at_least_0(program, found, 'Temperature'))
                power = program.emit('math', 'power', kelvin, '4', '0')
                share = program.clamped(program.float(found, 'Blackbody Intensity'))
                power = program.emit('mix', 'mix', share, '1', power)
                power = program.emit('math', 'multiply', power, text(STEFAN_BOLTZMANN), '0')
                tint = program.vector_math('multiply', program.color(found, 'Blackbody Tint'),
                                           power)
                body = program.vector_math('multiply', program.blackbody_at(kelvin), tint)
            return program.vector_math('add', colour, body)

        return emits if glows or burns else None

    def _cosine(self, found):
        return self._textures.constant_number(found.input('Anisotropy'), 'anisotropies of volumes')

    def _medium(self, shares, absorbs=None, scatters=None, cosine=0.0, emits=None):
        """Of what gives an operand of a VolumeProgram."""
        values = [self._value(make, shares) if make else NONE
                  for make in (absorbs, scatters, emits)]
        (absorbs, absorbing), (scatters, scattering), (emits, emitting) = [
            (NONE, (value,)) if isinstance(value, str) else (value, ()) for value in values]
        medium = Medium(absorbs, scatters, cosine, absorbing, scattering, emits, emitting)
        return medium if medium.is_there() else CLEAR

    def _value(self, make, shares):
        """A coefficient: constant, or a texture's name."""
        program = VolumeProgram(self._textures, self._left_out)
        try:
            operand = make(program)
            for place, is_first in shares:
                share = program.clamped(program.of(place, 'float'))
                if is_first:
                    share = program.emit('math', 'subtract', '1', share, '0')
                operand = program.vector_math('multiply', operand, share)
            size = self._textures.of_object('Size of Density')
            if size and size[0] != 1:
                operand = program.vector_math('divide', operand, text(size[0]))
            operand = program.vector_math('maximum', operand, '0')
        except TooLong:
            self._left_out.add('volumes by graphs of too many nodes are left out')
            return NONE
        return self._textures.of_program(program, operand, 'plain')


def _is_above_0(place):
    return graph.source(place) is not None or graph.constant(place) > 0


def _density(program, found):
    return _at_least_0(program, found, 'Density')


def _at_least_0(program, found, name):
    return program.emit('math', 'maximum', program.float(found, name), '0', '0')


def _times_grid(program, found, which, operand):
    """Times the grid that an input names, where there is one."""
    place = found.input(which)
    grid = program.grid(place.socket.default_value) if place else None
    return program.vector_math('multiply', operand, grid) if grid else operand


def _rest(program, color):
    """What is left of white, at least nothing."""
    return program.vector_math('maximum', program.vector_math('subtract', '1', color), '0')
