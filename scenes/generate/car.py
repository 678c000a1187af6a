"""A small round car, 4.2 long: its front is at +x, its middle at 0, the road at z = 0.

The body is a sheet of cross sections along x, open below and under the cabin; its lower edge
follows the wheels' arches. The cabin stands on it, a stack of rings whose cells are panes or paint.
"""

import math

from mesh import Mesh
from revolution import arc, revolve, smooth
from tube import circle, tube

HALF_LENGTH, HALF_WIDTH = 2.1, 0.84
AXLE, WHEEL_HEIGHT, ARCH = 1.28, 0.31, 0.36  # of the wheels, +-x and z; radius of the arches
SILL = 0.19
SHOULDER = 3.0  # exponent of the shoulder's curve: 2 is round, more is squarer

# Along x: height of the middle of bonnet, deck and boot; height of the widest place; lower edge.
TOP = ((-2.1, 0.46), (-2.06, 0.6), (-1.95, 0.73), (-1.75, 0.82), (-1.3, 0.92), (-0.6, 0.96),
       (0.3, 0.95), (0.9, 0.93), (1.4, 0.87), (1.75, 0.79), (1.95, 0.68), (2.06, 0.55),
       (2.1, 0.44))
WIDEST = ((-2.1, 0.4), (-1.95, 0.55), (-1.7, 0.68), (-1.3, 0.7), (0.0, 0.66), (1.3, 0.7),
          (1.7, 0.66), (1.95, 0.52), (2.1, 0.38))
EDGE = ((-2.1, 0.34), (-1.9, 0.27), (-1.65, 0.24), (-0.9, SILL), (0.9, SILL), (1.65, 0.22),
        (1.9, 0.25), (2.1, 0.32))

# Rings of the cabin: height, half length, half width; the panes end at the fifth.
CABIN = ((0.86, 1.25, 0.75), (0.95, 1.17, 0.735), (1.06, 1.07, 0.71), (1.17, 0.96, 0.675),
         (1.27, 0.84, 0.63), (1.335, 0.73, 0.575), (1.38, 0.6, 0.49), (1.41, 0.43, 0.36),
         (1.428, 0.23, 0.19), (1.433, 0.0, 0.0))
CABIN_MIDDLE, CABIN_COLUMNS, PANE_ROWS = -0.3, 64, 4
# Columns (of 64, from the front) that are panes, on one side: windscreen, door, rear side, rear.
PANES = ((0, 7), (9, 17), (18, 23), (26, 32))
HOLE = (-1.2, 0.75, 2)  # the cabin's opening in the deck: from x to x, rows beside the middle


def along(curve, x):
    """A cubic through the points of `curve`."""
    x = min(max(x, curve[0][0]), curve[-1][0])
    k = next(k for k in range(len(curve) - 1) if x <= curve[k + 1][0])
    (x0, y0), (x1, y1) = curve[k], curve[k + 1]
    slopes = []
    for j in (k, k + 1):
        (xa, ya), (xb, yb) = curve[max(j - 1, 0)], curve[min(j + 1, len(curve) - 1)]
        slopes.append((yb - ya) / (xb - xa) * (x1 - x0))
    t = (x - x0) / (x1 - x0)
    return ((2 * t ** 3 - 3 * t * t + 1) * y0 + (t ** 3 - 2 * t * t + t) * slopes[0]
            + (3 * t * t - 2 * t ** 3) * y1 + (t ** 3 - t * t) * slopes[1])


class Merged(Mesh):
    """Points within half a millimetre are one vertex, and faces without extent are left out."""

    def __init__(self):
        super().__init__()
        self.known = {}

    def at(self, point):
        key = tuple(round(c * 2000) for c in point)
        if key not in self.known:
            self.known[key] = self.vertex(point)
        return self.known[key]

    def patch(self, *points):
        corners = []
        for corner in map(self.at, points):
            if corner not in corners:
                corners.append(corner)
        if len(corners) > 2:
            self.face(*corners)


def used(mesh):
    """The same faces without the vertices that none of them has."""
    result, number = Mesh(), {}
    for face in mesh.faces:
        for k in face:
            if k not in number:
                number[k] = result.vertex(mesh.vertices[k])
        result.face(*(number[k] for k in face))
    return result


def half_width(x):
    return HALF_WIDTH * max(0.0, 1 - abs(x / HALF_LENGTH) ** 4) ** 0.25


def lower_edge(x):
    for axle in (-AXLE, AXLE):
        if abs(x - axle) < ARCH + 1e-6:
            return WHEEL_HEIGHT + math.sqrt(max(0.0, ARCH ** 2 - (x - axle) ** 2))
    return along(EDGE, x)


def stations():
    """Places along x of the cross sections, close where the outline bends."""
    ends = []
    for k in range(11):
        t = math.tan(math.radians(4.5 * k))
        ends.append(HALF_LENGTH / (1 + t ** 4) ** 0.25)
    arch = [AXLE + ARCH * math.cos(math.pi * k / 14) for k in range(15)]
    arch = [AXLE + ARCH + 0.015] + arch + [AXLE - ARCH - 0.015]
    front = ends + arch + [0.75, 0.6, 0.4, 0.2]
    return [-x for x in front] + [0.0] + front[::-1]


def section(x):
    """Half a cross section, from the middle of the top to the edge that is turned inwards."""
    width, top, widest, edge = (half_width(x), along(TOP, x), along(WIDEST, x), lower_edge(x))
    points = []
    for k in range(9):
        angle = math.pi / 2 * k / 8
        points.append((width * math.sin(angle) ** (2 / SHOULDER),
                       widest + (top - widest) * max(0.0, math.cos(angle)) ** (2 / SHOULDER)))
    for k in range(1, 6):
        t = k / 5
        points.append((width * (1 - 0.045 * t * t * (widest - edge) / 0.5),
                       widest + (edge - widest) * t))
    points.append((max(0.0, points[-1][0] - 0.04), edge + 0.003))
    return points


def body():
    mesh = Merged()
    xs = stations()
    sections = [section(x) for x in xs]
    for k in range(len(xs) - 1):
        cut = HOLE[0] < (xs[k] + xs[k + 1]) / 2 < HOLE[1]
        for j in range(len(sections[k]) - 1):
            if cut and j < HOLE[2]:
                continue
            for side in (1, -1):
                corners = [(xs[i], side * sections[i][row][0], sections[i][row][1])
                           for i, row in ((k, j), (k + 1, j), (k + 1, j + 1), (k, j + 1))]
                mesh.patch(*(corners[::-1] if side > 0 else corners))
    return mesh


def cabin_point(row, column):
    height, length, width = CABIN[row]
    angle = 2 * math.pi * column / CABIN_COLUMNS
    c, s = math.cos(angle), math.sin(angle)
    r = (c ** 4 + s ** 4) ** -0.25
    return (CABIN_MIDDLE + length * r * c, width * r * s, height)


def cabin(panes):
    """The panes of the cabin, or its pillars and roof."""
    mesh = Merged()
    for row in range(len(CABIN) - 1):
        for column in range(CABIN_COLUMNS):
            mirrored = min(column, CABIN_COLUMNS - 1 - column)
            is_pane = row < PANE_ROWS and any(a <= mirrored < b for a, b in PANES)
            if is_pane == panes:
                mesh.patch(*(cabin_point(r, c % CABIN_COLUMNS)
                             for r, c in ((row, column), (row, column + 1),
                                          (row + 1, column + 1), (row + 1, column))))
    return used(mesh)


def tyre():
    """Around the z axis, radius 0.31, 0.17 wide."""
    return revolve([
        smooth([(0.2, -0.07), (0.24, -0.085), (0.285, -0.08), (0.306, -0.06), (0.31, -0.03),
                (0.31, 0.03), (0.306, 0.06), (0.285, 0.08), (0.24, 0.085), (0.2, 0.07)], 3),
        [(0.2, 0.07), (0.2, -0.07)],
    ], 40)


def rim():
    """The wheel's dish and cap, seen from +z, with a closed back."""
    return revolve([
        [(0.0, -0.06), (0.203, -0.06)], [(0.203, -0.06), (0.203, 0.066)],
        arc((0.197, 0.066), 0.006, 0, 90, 3)
        + smooth([(0.197, 0.072), (0.186, 0.068), (0.176, 0.04), (0.15, 0.03), (0.11, 0.036),
                  (0.085, 0.05)], 3)[1:],
        smooth([(0.085, 0.05), (0.07, 0.066), (0.04, 0.078), (0.0, 0.082)], 3),
    ], 40)


def reflector():
    """A headlamp's bowl, open towards +z, its inside facing out: a parabola, focus at z = 0.03."""
    return revolve([[(0.0, 0.0)] + [(0.01 * k, 0.01 * k * 0.01 * k / 0.12) for k in range(1, 10)]],
                   32)


def lens():
    """The headlamp's glass: a closed disk, 5 mm thick, domed outwards, radius 0.092."""
    outside = smooth([(0.092, 0.0), (0.088, 0.012), (0.07, 0.024), (0.04, 0.032), (0.0, 0.035)], 3)
    inside = smooth([(0.0, 0.03), (0.038, 0.027), (0.066, 0.02), (0.083, 0.0085), (0.087, 0.0)],
                    3)
    return revolve([outside, inside, [(0.087, 0.0), (0.092, 0.0)]], 32)


def bumper():
    """A bar around the front (and, turned over, the rear), 5 cm outside the body."""
    points = []
    for k in range(-12, 13):
        angle = math.radians(5 * k)
        c, s = math.cos(angle), math.sin(angle)
        r = (c ** 4 + s ** 4) ** -0.25
        points.append(((HALF_LENGTH + 0.07) * r * c, (HALF_WIDTH + 0.03) * r * s, 0.4))
    return tube(points, 0.036, 12)


def steering_wheel():
    """Around the z axis, radius 0.18: a ring of tubes and one spoke across."""
    mesh = tube(circle((0, 0, 0), 0.18, 0, 360, 28, (0, 1)), 0.013, 8)
    return tube([(-0.18, 0, 0), (0, 0, -0.03), (0.18, 0, 0)], 0.012, 8, mesh)


def files():
    made = {"body": body(), "roof": cabin(False), "panes": cabin(True), "tyre": tyre(),
            "rim": rim(), "reflector": reflector(), "lens": lens(), "bumper": bumper(),
            "steering-wheel": steering_wheel()}
    return {f"car-{name}.ply": mesh.ply() for name, mesh in made.items()}
