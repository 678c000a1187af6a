"""Round tubes along curves, closed at both ends, and curves for them."""

import math

from mesh import Mesh


def minus(p, q):
    return tuple(a - b for a, b in zip(p, q))


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def unit(p):
    length = math.sqrt(sum(a * a for a in p))
    return tuple(a / length for a in p)


def tube(points, radii, segments=12, mesh=None):
    """A tube around `points`; `radii` is one number, or one for each point."""
    mesh = mesh or Mesh()
    if isinstance(radii, (int, float)):
        radii = [radii] * len(points)
    rings, side = [], None
    for k, (point, radius) in enumerate(zip(points, radii)):
        forward = unit(minus(points[min(k + 1, len(points) - 1)], points[max(k - 1, 0)]))
        if side is None:
            side = unit(cross(forward, (1, 0, 0) if abs(forward[0]) < 0.8 else (0, 1, 0)))
        up = unit(cross(forward, side))
        side = cross(up, forward)
        ring = []
        for s in range(segments):
            angle = 2 * math.pi * s / segments
            a, b = radius * math.cos(angle), radius * math.sin(angle)
            ring.append(tuple(p + a * x + b * y for p, x, y in zip(point, side, up)))
        rings.append(ring)
    rows = [[mesh.vertex(p) for p in ring] for ring in rings]
    for lower, upper in zip(rows, rows[1:]):
        for s in range(segments):
            n = (s + 1) % segments
            mesh.face(lower[s], lower[n], upper[n], upper[s])
    for ring, turn in ((rings[0], -1), (rings[-1], 1)):  # the ends' edges stay sharp
        mesh.face(*(mesh.vertex(p) for p in ring[::turn]))
    return mesh


def circle(centre, radius, start, end, steps, plane):
    """Points of an arc; degrees from the first towards the second axis of `plane`."""
    points = []
    for k in range(steps + 1):
        angle = math.radians(start + (end - start) * k / steps)
        point = list(centre)
        point[plane[0]] += radius * math.cos(angle)
        point[plane[1]] += radius * math.sin(angle)
        points.append(tuple(point))
    return points
