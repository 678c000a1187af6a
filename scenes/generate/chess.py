"""Chess pieces: five turned on a lathe, the knight's head swept along a curve.

One unit is a centimetre; squares are 5 wide.
"""

import math

from mesh import Mesh
from revolution import arc, ball, revolve, smooth

SEGMENTS = 32


def foot(radius):
    """Bottom, rounded rim and step that all pieces stand on; ends at (0.62 radius, 1.1)."""
    return [
        [(0.0, 0.0), (radius - 0.1, 0.0)],
        smooth([(radius - 0.1, 0.0), (radius, 0.12), (radius, 0.45), (0.9 * radius, 0.7)], 3),
        smooth([(0.9 * radius, 0.7), (0.76 * radius, 0.8), (0.62 * radius, 1.1)], 3),
    ]


def collar(radius, height, below, above):
    """A thin disk around the neck."""
    return [
        [(below, height), (radius - 0.08, height + 0.06)],
        arc((radius - 0.08, height + 0.16), 0.1, -90, 90, 4),
        [(radius - 0.08, height + 0.26), (above, height + 0.3)],
    ]


def pawn():
    return revolve(
        foot(1.5) + [smooth([(0.93, 1.1), (0.66, 1.7), (0.5, 2.6), (0.46, 3.2)])]
        + collar(0.95, 3.2, 0.46, 0.5)
        + [ball((0.5, 3.5), 0.83, 10)], SEGMENTS)


def rook():
    return revolve(
        foot(1.7) + [smooth([(1.054, 1.1), (0.85, 1.8), (0.78, 3.0), (0.82, 3.7)])]
        + collar(1.12, 3.7, 0.82, 0.9)
        + [smooth([(0.9, 4.0), (1.02, 4.25), (1.2, 4.45)], 3),
           [(1.2, 4.45), (1.2, 5.3)], [(1.2, 5.3), (0.82, 5.3)], [(0.82, 5.3), (0.82, 4.8)],
           [(0.82, 4.8), (0.0, 4.8)]], SEGMENTS)


def bishop():
    return revolve(
        foot(1.7) + [smooth([(1.054, 1.1), (0.74, 1.9), (0.55, 3.2), (0.5, 4.3)])]
        + collar(1.05, 4.3, 0.5, 0.52)
        + [smooth([(0.52, 4.6), (0.8, 5.05), (0.86, 5.5), (0.66, 6.1), (0.3, 6.7), (0.17, 6.9)]),
           ball((0.17, 6.9), 0.235, 6)], SEGMENTS)


def queen():
    return revolve(
        foot(1.9) + [smooth([(1.178, 1.1), (0.8, 2.1), (0.58, 3.8), (0.56, 5.6)])]
        + collar(1.2, 5.6, 0.56, 0.6)
        + [smooth([(0.6, 5.9), (0.72, 6.6), (1.05, 7.35), (1.16, 7.5)]),
           smooth([(1.16, 7.5), (1.0, 7.45), (0.8, 7.62), (0.4, 7.86), (0.22, 7.92)], 3),
           ball((0.22, 7.92), 0.31, 6)], SEGMENTS)


def king():
    body = revolve(
        foot(1.9) + [smooth([(1.178, 1.1), (0.82, 2.1), (0.6, 3.9), (0.6, 5.9)])]
        + collar(1.25, 5.9, 0.6, 0.66)
        + [smooth([(0.66, 6.2), (0.82, 7.0), (1.06, 7.7), (1.08, 7.85)]),
           smooth([(1.08, 7.85), (0.85, 8.12), (0.4, 8.3), (0.0, 8.34)], 3)], SEGMENTS)
    cross = ((-0.14, 8.36, 0.14, 9.5), (-0.46, 8.8, -0.15, 9.08), (0.15, 8.8, 0.46, 9.08))
    for x0, z0, x1, z1 in cross:
        sharp_box(body, (x0, -0.13, z0), (x1, 0.13, z1))
    return body


def sharp_box(mesh, low, high):
    """A box in a mesh that is smoothed: each side has its own vertices."""
    box = Mesh()
    box.box(low, high)
    for side in box.faces:
        mesh.face(*(mesh.vertex(box.vertices[k]) for k in side))


# Stations of the knight's head: spine x, z; inclination of the spine, degrees from the vertical;
# half axes across the spine, in the plane of symmetry and out of it.
KNIGHT = (
    (0.0, 1.75, 0, 0.92, 0.80), (0.08, 2.3, 4, 0.98, 0.66), (0.18, 3.0, 6, 1.02, 0.56),
    (0.2, 3.7, 0, 1.0, 0.5), (0.1, 4.4, -12, 0.92, 0.46), (-0.05, 4.95, -35, 0.82, 0.46),
    (-0.42, 5.25, -68, 0.7, 0.46), (-0.9, 5.1, -100, 0.56, 0.42), (-1.35, 4.75, -122, 0.42, 0.36),
    (-1.72, 4.4, -128, 0.36, 0.31), (-1.9, 4.22, -130, 0.22, 0.2))


def knight():
    mesh = revolve(
        foot(1.7) + [[(1.054, 1.1), (1.02, 1.6)], [(1.02, 1.6), (0.0, 1.6)]], SEGMENTS)
    rings = [[mesh.vertex((0.0, 0.0, 1.64))]]
    rings += [station_ring(mesh, *station) for station in KNIGHT]
    rings.append([mesh.vertex((-1.98, 0.0, 4.15))])
    for lower, upper in zip(rings, rings[1:]):
        sweep(mesh, lower, upper)
    for side in (-1, 1):
        ear(mesh, side)
    return mesh


def station_ring(mesh, x, z, tilt, across, sideways, segments=24):
    cosine, sine = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
    vertices = []
    for k in range(segments):
        angle = 2 * math.pi * k / segments
        a, b = across * math.cos(angle), sideways * math.sin(angle)
        vertices.append(mesh.vertex((x + a * cosine, b, z - a * sine)))
    return vertices


def sweep(mesh, lower, upper):
    count = max(len(lower), len(upper))
    for k in range(count):
        n = (k + 1) % count
        if len(lower) == 1:
            mesh.face(lower[0], upper[n], upper[k])
        elif len(upper) == 1:
            mesh.face(lower[k], lower[n], upper[0])
        else:
            mesh.face(lower[k], lower[n], upper[n], upper[k])


def ear(mesh, side):
    """A slim pyramid that ends just above the head."""
    base = [(0.32, 0.14), (0.62, 0.2), (0.5, 0.42), (0.24, 0.34)]
    corners = [(x - 0.2, side * y, 5.78) for x, y in base]
    tip = (0.22, side * 0.3, 6.45)
    order = corners if side > 0 else corners[::-1]
    mesh.face(*(mesh.vertex(p) for p in reversed(order)))
    for p, q in zip(order, order[1:] + order[:1]):
        mesh.face(mesh.vertex(p), mesh.vertex(q), mesh.vertex(tip))


def files():
    pieces = {"pawn": pawn, "rook": rook, "knight": knight, "bishop": bishop, "queen": queen,
              "king": king}
    return {f"chess-{name}.ply": make().ply() for name, make in pieces.items()}
