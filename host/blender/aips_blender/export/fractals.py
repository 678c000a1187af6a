"""Writes fractals of nodes Musgrave and Noise Texture as sums and products of plain noises.

The formulas are Blender's: `octaves` is a number with a fraction, by which the last one counts, and
`fade` is what each octave is fainter than the one before.
"""
MOST_OCTAVES = 16


def text(number):
    return f'{float(number):.6g}'


class Fractal:
    """`noise(octave, detail, fade)` writes a noise of so many octaves more than one, from 0 to 1."""

    def __init__(self, program, noise, octaves, fade, offset, gain):
        self._program, self._noise = program, noise
        self._fade, self._offset, self._gain = fade, offset, gain
        octaves = min(max(octaves, 0.0), float(MOST_OCTAVES))
        self._whole, self._part = int(octaves), octaves - int(octaves)

    def of(self, kind):
        return {'FBM': self._sum, 'MULTIFRACTAL': self._product, 'HETERO_TERRAIN': self._terrain,
                'HYBRID_MULTIFRACTAL': self._hybrid,
                'RIDGED_MULTIFRACTAL': self._ridges}[kind]()

    def _math(self, operation, *operands):
        return self._program.emit('math', operation, *operands, *['0'] * (3 - len(operands)))

    def _signed(self, octave):
        """A noise from -1 to 1."""
        return self._math('multiply_add', self._noise(octave, 0, 0.5), '2', '-1')

    def _octaves(self):
        """Numbers of the octaves, and how much each counts."""
        found = [(i, 1.0) for i in range(self._whole)]
        return found + ([(self._whole, self._part)] if self._part > 0 else [])

    def _sum(self):
        """Of octaves, which noises have as a mean."""
        value = '0'
        for count, share in ((self._whole, 1 - self._part), (self._whole + 1, self._part)):
            if count and share:
                most = share * sum(self._fade ** i for i in range(count))
                noise = self._noise(0, count - 1, self._fade)
                value = self._math('add', value, self._math('multiply_add', noise, text(2 * most),
                                                            text(-most)))
        return value

    def _product(self):
        value = '1'
        for i, share in self._octaves():
            factor = self._math('multiply_add', self._signed(i), text(share * self._fade ** i), '1')
            value = self._math('multiply', value, factor)
        return value

    def _terrain(self):
        value = self._math('add', self._signed(0), text(self._offset))
        for i, share in self._octaves()[1:]:
            raised = self._math('add', self._signed(i), text(self._offset))
            grown = self._math('multiply', raised, value)
            value = self._math('multiply_add', grown, text(share * self._fade ** i), value)
        return value

    def _hybrid(self):
        value, weight = '0', '1'
        for i, share in self._octaves():
            scale = self._fade ** i
            signal = self._math('multiply_add', self._signed(i), text(scale),
                                text(self._offset * scale))
            weighted = self._math('multiply', weight, signal)
            value = self._math('multiply_add', weighted, text(share), value)
            weight = self._program.clamped(self._math('multiply', weighted, text(self._gain)))
        return value

    def _ridges(self):
        value = signal = self._ridge(0)
        for i in range(1, max(self._whole, 1)):
            weight = self._program.clamped(self._math('multiply', signal, text(self._gain)))
            signal = self._math('multiply', self._ridge(i), weight)
            value = self._math('multiply_add', signal, text(self._fade ** i), value)
        return value

    def _ridge(self, octave):
        sharp = self._math('subtract', text(self._offset),
                           self._math('absolute', self._signed(octave)))
        return self._math('multiply', sharp, sharp)
