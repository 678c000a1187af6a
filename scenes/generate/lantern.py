"""One of twelve equal sectors of a pierced metal lantern, an onion about 1.3 high.

A sector is a column of patches, each with one hole; a patch is bent onto the lantern's
surface, outside and inside, and the two are joined around the hole.
"""

import math

from mesh import Mesh

SECTORS = 12
POINTS = 24  # around a hole
THICKNESS = 0.025
# Lower and upper height of each patch, and its hole's half width and half height (of the patch).
PATCHES = ((-0.62, -0.44, 0.22, 0.2), (-0.44, -0.16, 0.36, 0.34), (-0.16, 0.2, 0.3, 0.4),
           (0.2, 0.48, 0.36, 0.34), (0.48, 0.68, 0.22, 0.24))


def radius(height):
    """Onion: a sphere below, drawn out towards the top."""
    t = (height + 0.68) / 1.42
    return 0.62 * math.sin(math.pi * min(max(t, 0.0), 1.0)) ** 0.62 * (1.12 - 0.3 * t) + 0.05


def surface(u, height, depth):
    """Point and normal of the lantern at `u` sectors around, `depth` under the outside."""
    angle = 2 * math.pi * u / SECTORS
    slope = (radius(height + 1e-4) - radius(height - 1e-4)) / 2e-4
    length = math.hypot(1, slope)
    normal = (math.cos(angle) / length, math.sin(angle) / length, -slope / length)
    r = radius(height)
    point = (r * math.cos(angle), r * math.sin(angle), height)
    return tuple(p - depth * n for p, n in zip(point, normal)), normal


def loops(half_width, half_height):
    """Closed curves in the unit square from the hole (an almond) to the square's own edge."""
    hole, edge = [], []
    for k in range(POINTS):
        angle = 2 * math.pi * (k + 0.5) / POINTS
        c, s = math.cos(angle), math.sin(angle)
        pointed = 1 - 0.25 * abs(s) ** 3
        hole.append((0.5 + half_width * c * pointed, 0.5 + half_height * s))
        reach = 0.5 / max(abs(c), abs(s))
        edge.append((0.5 + c * reach, 0.5 + s * reach))
    # The corners of the square lie between two points; move the nearest ones there.
    for k in range(POINTS):
        x, y = edge[k]
        if k % (POINTS // 4) == POINTS // 8:
            edge[k] = (float(round(x)), float(round(y)))
    middle = [((a + c) / 2, (b + d) / 2) for (a, b), (c, d) in zip(hole, edge)]
    return [hole, middle, edge]


def sheet(mesh, curves, low, high, depth, outwards):
    """One side of a patch."""
    rows = []
    for curve in curves:
        row = []
        for u, v in curve:
            point, normal = surface(u, low + (high - low) * v, depth)
            row.append(mesh.vertex(point, normal if outwards else tuple(-n for n in normal)))
        rows.append(row)
    for inner, outer in zip(rows, rows[1:]):
        for k in range(POINTS):
            n = (k + 1) % POINTS
            face = (inner[k], outer[k], outer[n], inner[n])
            mesh.face(*(face if outwards else face[::-1]))


def rim(mesh, hole, low, high):
    """The wall of a hole, between outside and inside."""
    rows = []
    for depth in (0.0, THICKNESS):
        row = []
        for u, v in hole:
            point, _ = surface(u, low + (high - low) * v, depth)
            centre, _ = surface(0.5, (low + high) / 2, depth)
            towards = [c - p for c, p in zip(centre, point)]
            length = math.sqrt(sum(t * t for t in towards))
            row.append(mesh.vertex(point, tuple(t / length for t in towards)))
        rows.append(row)
    for k in range(POINTS):
        n = (k + 1) % POINTS
        mesh.face(rows[0][k], rows[0][n], rows[1][n], rows[1][k])


def sector():
    mesh = Mesh()
    for low, high, half_width, half_height in PATCHES:
        curves = loops(half_width, half_height)
        sheet(mesh, curves, low, high, 0.0, True)
        sheet(mesh, curves, low, high, THICKNESS, False)
        rim(mesh, curves[0], low, high)
    return mesh


def files():
    return {"lantern-sector.ply": sector().ply()}
