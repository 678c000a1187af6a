"""What of a program of texture "nodes" is the same everywhere, as far as that is known."""
import math
import re

import numpy as np

LUMINANCE = np.array([0.2126, 0.7152, 0.0722])  # Rec. 709
OPERAND = re.compile(r'r\d+')  # the value of a line


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


def _operands(line):
    """Numbers of the lines that a line reads."""
    return [int(word[1:]) for word in line.split() if OPERAND.fullmatch(word)]


def _values(lines):
    """Of each line three numbers, or None."""
    values = []
    for line in lines:
        known = all(values[i] is not None for i in _operands(line))
        try:
            value = (_once if known else _nothing)(line.split(), values)
        except OverflowError:
            value = None
        # As in lxsrender, what is not finite is 0.
        values.append(value if value is None else np.where(np.isfinite(value), value, 0.0))
    return values


def _nothing(words, values):
    """Nothing where a line multiplies by nothing, or None."""
    if words[:2] != ['vector', 'multiply']:
        return None
    factors = [values[int(w[1:])] if OPERAND.fullmatch(w) else float(w) for w in words[2:4]]
    return np.zeros(3) if any(f is not None and not np.any(f) for f in factors) else None


def folded(lines):
    """Three numbers, or None."""
    value = _values(lines)[-1]
    return None if value is None else tuple(float(x) for x in value)


def shortened(lines):
    """The same program without what does not change or is not read."""
    values, short, names = _values(lines), [], {}

    def add(line):
        short.append(line)
        return f'r{len(short) - 1}'

    def name(i):
        if i not in names:
            names[i] = constant(values[i]) if values[i] is not None else add(' '.join(
                name(int(word[1:])) if OPERAND.fullmatch(word) else word
                for word in lines[i].split()))
        return names[i]

    def constant(value):
        numbers = [f'{x:.6g}' for x in value]
        return numbers[0] if len(set(numbers)) == 1 else add(' '.join(['value', *numbers]))

    name(len(lines) - 1)
    return short
