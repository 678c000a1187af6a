"""The value of a program of texture "nodes" that is the same everywhere, as far as it is known."""
import math

import numpy as np

LUMINANCE = np.array([0.2126, 0.7152, 0.0722])  # Rec. 709


def _divided(a, b):
    return a / b if b else 0.0


MATH = {
    'add': lambda a, b, c: a + b, 'subtract': lambda a, b, c: a - b,
    'multiply': lambda a, b, c: a * b, 'divide': lambda a, b, c: _divided(a, b),
    'multiply_add': lambda a, b, c: a * b + c, 'minimum': lambda a, b, c: min(a, b),
    'maximum': lambda a, b, c: max(a, b), 'absolute': lambda a, b, c: abs(a),
    'less_than': lambda a, b, c: float(a < b), 'greater_than': lambda a, b, c: float(a > b),
    'power': lambda a, b, c: a ** b if a > 0 or a < 0 and b == int(b) else float(b == 0),
    'sqrt': lambda a, b, c: max(a, 0.0) ** 0.5, 'floor': lambda a, b, c: math.floor(a),
    'sine': lambda a, b, c: math.sin(a), 'cosine': lambda a, b, c: math.cos(a),
    'radians': lambda a, b, c: math.radians(a), 'degrees': lambda a, b, c: math.degrees(a),
}
VECTOR = {
    'add': lambda a, b, c: a + b, 'subtract': lambda a, b, c: a - b,
    'multiply': lambda a, b, c: a * b, 'multiply_add': lambda a, b, c: a * b + c,
    'divide': lambda a, b, c: np.array([_divided(x, y) for x, y in zip(a, b)]),
    'minimum': lambda a, b, c: np.minimum(a, b), 'maximum': lambda a, b, c: np.maximum(a, b),
}
MIX = {'mix': lambda a, b: b, 'add': lambda a, b: a + b, 'multiply': lambda a, b: a * b,
       'subtract': lambda a, b: a - b, 'darken': np.minimum, 'lighten': np.maximum,
       'difference': lambda a, b: abs(a - b)}


def _ramp(constant, at, table):
    stops = np.array(table).reshape(-1, 4)
    if constant:
        return stops[max(np.searchsorted(stops[:, 0], at, 'right') - 1, 0), 1:]
    return np.array([np.interp(at, stops[:, 0], stops[:, c]) for c in (1, 2, 3)])


def _once(words, values):
    """The value of one line, or None."""
    name, *rest = words

    def operand(word):
        return values[int(word[1:])] if word[0] == 'r' else np.full(3, float(word))

    if name in ('value', 'combine'):
        return np.array([operand(w)[0] for w in rest])
    if name == 'math' and rest[0] in MATH:
        return np.full(3, MATH[rest[0]](*(float(operand(w)[0]) for w in rest[1:])))
    if name == 'vector' and rest[0] in VECTOR:
        return VECTOR[rest[0]](*map(operand, rest[1:4]))
    if name == 'mix' and rest[0] in MIX:
        by, a, b = map(operand, rest[1:])
        return a + by[0] * (MIX[rest[0]](a, b) - a)
    if name == 'luminance':
        return np.full(3, operand(rest[0]) @ LUMINANCE)
    if name == 'average':
        return np.full(3, operand(rest[0]).mean())
    if name == 'channel':
        return np.full(3, operand(rest[1])['xyz'.index(rest[0])])
    if name == 'clamp':
        value, least, most = map(operand, rest)
        return np.minimum(np.maximum(value, least), most)
    if name == 'gamma':
        value, power = map(operand, rest)
        return np.where(value > 0, np.maximum(value, 1e-30) ** power[0], value)
    if name == 'invert':
        by, value = map(operand, rest)
        return value + by[0] * (1 - 2 * value)
    if name == 'ramp':
        return _ramp(rest[0] == 'constant', operand(rest[1])[0], list(map(float, rest[2:])))
    return None


def folded(lines):
    """Three numbers, or None."""
    values = []
    for line in lines:
        values.append(_once(line.split(), values))
        if values[-1] is None:
            return None
    return tuple(float(x) for x in values[-1])
