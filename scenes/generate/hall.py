"""Thirty rooms, six by five, with a doorway between any two neighbours and a lamp in each.

Room (i, j) spans 4 by 4 around (4 i, 4 j); the room at (0, 0) is the one that is seen.
"""

import random

from mesh import Mesh, number, numbers

COLUMNS, ROWS = range(-3, 3), range(-2, 3)
SIZE, HEIGHT, HALF_WALL = 4.0, 2.8, 0.08
DOOR_FROM, DOOR_TO, DOOR_HEIGHT = 0.95, 1.75, 2.05  # along the wall from the room's middle
PANEL = 0.35  # half side of a lamp


def wall(mesh, middle, along_x, doorway):
    """One side of a room: three boxes around a doorway, or one."""
    half = SIZE / 2
    if doorway:
        pieces = ((-half, DOOR_FROM, 0, HEIGHT), (DOOR_TO, half, 0, HEIGHT),
                  (DOOR_FROM, DOOR_TO, DOOR_HEIGHT, HEIGHT))
    else:
        pieces = ((-half, half, 0, HEIGHT),)
    for start, end, low, high in pieces:
        x, y = middle
        if along_x:
            mesh.box((x + start, y - HALF_WALL, low), (x + end, y + HALF_WALL, high))
        else:
            mesh.box((x - HALF_WALL, y + start, low), (x + HALF_WALL, y + end, high))


def walls():
    mesh = Mesh()
    for j in ROWS:
        for i in COLUMNS:
            x, y = SIZE * i, SIZE * j
            wall(mesh, (x - SIZE / 2, y), False, i != COLUMNS[0])
            wall(mesh, (x, y - SIZE / 2), True, j != ROWS[0])
        wall(mesh, (SIZE * COLUMNS[-1] + SIZE / 2, SIZE * j), False, False)
    for i in COLUMNS:
        wall(mesh, (SIZE * i, SIZE * ROWS[-1] + SIZE / 2), True, False)
    return mesh


def lamps(seed):
    """A square under each ceiling, facing down, of its own colour and brightness."""
    source = random.Random(seed)
    lines = []
    for j in ROWS:
        for i in COLUMNS:
            warm, level = source.random(), 8 + 14 * source.random()
            if (i, j) == (0, 0):
                warm, level = 0.6, 12
            colour = (level, level * (0.95 - 0.15 * warm), level * (0.9 - 0.4 * warm))
            lines += ["AttributeBegin", f"  Translate {numbers((SIZE * i, SIZE * j, HEIGHT))}",
                      f'  AreaLightSource "area" "color L" [{numbers(colour, 3)}]',
                      '    "float power" [0] "float efficacy" [0]', panel(), "AttributeEnd"]
    return "\n".join(lines) + "\n"


def panel():
    p, z = number(PANEL), "-0.01"
    return (f'  Shape "trianglemesh" "integer quadindices" [0 3 2 1] "point P" '
            f"[-{p} -{p} {z}  {p} -{p} {z}  {p} {p} {z}  -{p} {p} {z}]")


def files(seed):
    return {"hall-walls.lxs": walls().shape(), "hall-lamps.lxs": lamps(seed)}
