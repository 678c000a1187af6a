"""The rippled surface of a pool, 8 by 4: a sum of sines with seeded directions and phases."""

import math
import random

from mesh import Mesh

COLUMNS, ROWS = 56, 28
LENGTH, WIDTH = 8.0, 4.0


def waves(seed):
    """Wave vectors, heights and phases; eleven wavelengths from 0.7 to 2.2."""
    source = random.Random(seed)
    result = []
    for k in range(11):
        wavelength = 2.2 * (0.7 / 2.2) ** (k / 10)
        direction = source.random() * 2 * math.pi
        wave = 2 * math.pi / wavelength
        result.append((wave * math.cos(direction), wave * math.sin(direction),
                       0.011 * wavelength, source.random() * 2 * math.pi))
    return result


def surface(seed):
    mesh = Mesh()
    spectrum = waves(seed)
    for j in range(ROWS + 1):
        for i in range(COLUMNS + 1):
            x, y = LENGTH * (i / COLUMNS - 0.5), WIDTH * (j / ROWS - 0.5)
            z = sum(a * math.sin(kx * x + ky * y + phase) for kx, ky, a, phase in spectrum)
            mesh.vertex((x, y, z))
    for j in range(ROWS):
        for i in range(COLUMNS):
            k = j * (COLUMNS + 1) + i
            mesh.face(k, k + 1, k + COLUMNS + 2, k + COLUMNS + 1)
    return mesh


def files(seed):
    return {"water.ply": surface(seed).ply()}
