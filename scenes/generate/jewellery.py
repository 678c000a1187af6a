"""Cut stones, flat facet by flat facet, and the claws of a ring's head.

One unit is a millimetre. Each facet has its own vertices, so that no edge is smoothed.
"""

import math

from mesh import Mesh
from tube import cross, minus, tube

RADIUS = 5.0  # of a brilliant's girdle; scenes scale it
TABLE, CROWN_ANGLE = 0.57, 34.5  # radius of the table's corners, of the girdle's; degrees
GIRDLE, PAVILION_ANGLE = 0.05, 40.75  # height of the girdle; degrees
STAR, LOWER = 0.763, 0.249  # radii where the star facets and the lower halves end


def facet(mesh, points, inside=(0.0, 0.0, -0.5)):
    """A flat polygon that faces away from `inside`."""
    normal = cross(minus(points[1], points[0]), minus(points[2], points[0]))
    outwards = sum(a * b for a, b in zip(normal, minus(points[0], inside))) > 0
    mesh.face(*(mesh.vertex(p) for p in (points if outwards else points[::-1])))


def brilliant():
    """The round brilliant: 33 facets of the crown, 16 of the girdle, 24 of the pavilion.

    The girdle's upper edge is at z = 0. A kite is flat where its corners' heights follow from
    their distance along the kite's axis, which `crown` and `pavilion` give.
    """
    mesh = Mesh()
    half = math.cos(math.pi / 8)
    rise, fall = (math.tan(math.radians(a)) for a in (CROWN_ANGLE, PAVILION_ANGLE))

    def at(step, radius, height):
        angle = step * math.pi / 8
        return (RADIUS * radius * math.cos(angle), RADIUS * radius * math.sin(angle),
                RADIUS * height)

    def crown(along):
        return rise * (1 - along)

    def pavilion(along):
        return -GIRDLE - fall * (1 - along)

    culet = at(0, 0, pavilion(0))
    facet(mesh, [at(2 * k, TABLE, crown(TABLE)) for k in range(8)])
    for k in range(0, 16, 2):
        corner, following = (at(k + d, TABLE, crown(TABLE)) for d in (0, 2))
        before, after = (at(k + d, STAR, crown(STAR * half)) for d in (-1, 1))
        low_before, low_after = (at(k + d, LOWER, pavilion(LOWER * half)) for d in (-1, 1))
        facet(mesh, [corner, following, after])
        facet(mesh, [corner, after, at(k, 1, 0), before])
        facet(mesh, [culet, low_before, at(k, 1, -GIRDLE), low_after])
        for d, tip, low in ((-1, before, low_before), (1, after, low_after)):
            facet(mesh, [tip, at(k, 1, 0), at(k + d, 1, 0)])
            facet(mesh, [low, at(k, 1, -GIRDLE), at(k + d, 1, -GIRDLE)])
            facet(mesh, [at(k, 1, 0), at(k + d, 1, 0), at(k + d, 1, -GIRDLE),
                         at(k, 1, -GIRDLE)])
    return mesh


# Half length, half width, cut of the corners and height of the rings of a step cut.
STEPS = ((2.9, 1.75, 0.8, 1.05), (3.6, 2.45, 1.0, 0.75), (4.0, 2.85, 1.1, 0.3),
         (4.15, 3.0, 1.15, 0.0), (4.15, 3.0, 1.15, -0.25), (3.4, 2.25, 0.9, -1.35),
         (2.5, 1.35, 0.6, -2.35), (1.4, 0.25, 0.2, -3.25))


def step_cut():
    """An oblong stone with cut corners and steps parallel to its girdle."""
    mesh = Mesh()
    rings = []
    for a, b, c, z in STEPS:
        rings.append([(a, c - b, z), (a, b - c, z), (a - c, b, z), (c - a, b, z), (-a, b - c, z),
                      (-a, c - b, z), (c - a, -b, z), (a - c, -b, z)])
    facet(mesh, rings[0])
    facet(mesh, rings[-1])
    for upper, lower in zip(rings, rings[1:]):
        for k in range(8):
            n = (k + 1) % 8
            facet(mesh, [upper[k], upper[n], lower[n], lower[k]])
    return mesh


def claws():
    """Six claws that hold a brilliant of radius 3, its girdle's upper edge at z = 0."""
    mesh = Mesh()
    for k in range(6):
        angle = math.pi * (k + 0.5) / 3
        tube([(r * math.cos(angle), r * math.sin(angle), z)
              for r, z in ((1.1, -4.2), (1.9, -3.0), (2.85, -1.5), (3.42, -0.3), (3.36, 0.25),
                           (3.0, 0.62), (2.6, 0.85))],
             [0.5, 0.46, 0.42, 0.4, 0.38, 0.34, 0.28], 10, mesh)
    return mesh


def files():
    return {"gem-brilliant.ply": brilliant().ply(), "gem-step-cut.ply": step_cut().ply(),
            "ring-claws.ply": claws().ply()}
