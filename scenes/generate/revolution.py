"""Surfaces of revolution around the z axis, and the curves that their profiles are made of."""

import math

from mesh import Mesh


def smooth(points, steps=3):
    """Catmull-Rom curve through (radius, height) points, `steps` pieces between neighbours."""
    extended = [points[0], *points, points[-1]]
    curve = []
    for a, b, c, d in zip(extended, extended[1:], extended[2:], extended[3:]):
        for k in range(steps):
            t = k / steps
            curve.append(tuple(
                0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t
                       + (3 * q - p - 3 * r + s) * t ** 3)
                for p, q, r, s in zip(a, b, c, d)))
    curve.append(points[-1])
    return [(max(radius, 0.0), height) for radius, height in curve]


def arc(centre, radius, start, end, steps):
    """Arc in the (radius, height) plane; degrees from the +radius direction."""
    angles = [math.radians(start + (end - start) * k / steps) for k in range(steps + 1)]
    points = [(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a))
              for a in angles]
    return [(0.0 if abs(r) < 1e-9 else r, z) for r, z in points]


def ball(neck, radius, steps):
    """Arc of a ball that sits on the (radius, height) point `neck`, up to the axis."""
    rise = math.sqrt(radius * radius - neck[0] * neck[0])
    start = -math.degrees(math.asin(rise / radius))
    return [neck, *arc((0.0, neck[1] + rise), radius, start, 90, steps)[1:]]


def revolve(sections, segments, mesh=None):
    """Turns profile sections around the z axis.

    Each section is a list of (radius, height), outside to its right when walked in order;
    sections share no vertices, so that the edge between two stays sharp.
    """
    mesh = mesh or Mesh()
    for section in sections:
        rings = [ring(mesh, point, segments) for point in section]
        for lower, upper in zip(rings, rings[1:]):
            connect(mesh, lower, upper, segments)
    return mesh


def ring(mesh, point, segments):
    """Vertices of one circle; a single one on the axis."""
    radius, height = point
    if radius == 0:
        return [mesh.vertex((0.0, 0.0, height))]
    return [
        mesh.vertex((radius * math.cos(angle), radius * math.sin(angle), height))
        for angle in (2 * math.pi * k / segments for k in range(segments))
    ]


def connect(mesh, lower, upper, segments):
    for k in range(segments):
        following = (k + 1) % segments
        if len(lower) == 1 and len(upper) == 1:
            continue
        if len(lower) == 1:
            mesh.face(lower[0], upper[following], upper[k])
        elif len(upper) == 1:
            mesh.face(lower[k], lower[following], upper[0])
        else:
            mesh.face(lower[k], lower[following], upper[following], upper[k])
