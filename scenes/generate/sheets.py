"""Sheets without thickness, which let light through: a curtain, the leaves of a plant."""

import math

from mesh import Mesh

FOLDS, STEPS, ROWS = 9, 8, 6


def curtain():
    """1 wide along x and 1 high, in folds."""
    mesh = Mesh()
    columns = FOLDS * STEPS
    for row in range(ROWS + 1):
        z = row / ROWS
        depth = 0.042 - 0.016 * z  # folds open downwards
        for column in range(columns + 1):
            t = column / columns
            phase = 2 * math.pi * FOLDS * t + 0.9 * math.sin(5 * t)
            sway = 0.5 * depth * math.sin(7.3 * t + 1.1 * (1 - z))
            mesh.vertex((t - 0.5 + 0.006 * (1 - z) * math.sin(phase * 2),
                         depth * math.sin(phase) + sway, z))
    for row in range(ROWS):
        for column in range(columns):
            k = row * (columns + 1) + column
            mesh.face(k, k + 1, k + columns + 2, k + columns + 1)
    return mesh


def leaves():
    """Eighteen blades that rise from the origin and arch over, 1 long."""
    mesh = Mesh()
    for k in range(18):
        turn = 2.399963 * k  # the golden angle: no two leaves cover each other
        lean = 0.25 + 0.95 * ((k * 7) % 18) / 18
        length = 0.75 + 0.25 * ((k * 5) % 18) / 18
        x = z = 0.0
        rows = []
        for step in range(9):
            t = step / 8
            half = 0.004 + 0.045 * math.sin(math.pi * min(1.0, 0.08 + 0.92 * t)) ** 0.8
            rows.append([mesh.vertex((x * math.cos(turn) - y * math.sin(turn),
                                      x * math.sin(turn) + y * math.cos(turn), z + rise))
                         for y, rise in ((-half, 0.25 * half), (0.0, 0.0), (half, 0.25 * half))])
            tilt = lean * (0.35 + 1.6 * t)
            x += length / 8 * math.sin(tilt)
            z += length / 8 * math.cos(tilt)
        for lower, upper in zip(rows, rows[1:]):
            for a in (0, 1):
                mesh.face(lower[a], lower[a + 1], upper[a + 1], upper[a])
    return mesh


def files():
    return {"curtain.ply": curtain().ply(), "leaves.ply": leaves().ply()}
