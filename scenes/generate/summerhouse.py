"""An octagonal pavilion: posts, beams, rafters and railings of timber, and its roof."""

import math

from mesh import Mesh

SIDES = 8
POST_RADIUS, EAVES_RADIUS = 2.2, 2.75  # of the corners, from the middle
BEAM_HEIGHT, EAVES_HEIGHT, APEX_HEIGHT = 2.35, 2.42, 3.75
ENTRANCE = 6  # the side without a railing, which faces -y


def corner(side, radius, height):
    angle = 2 * math.pi * (side + 0.5) / SIDES
    return (radius * math.cos(angle), radius * math.sin(angle), height)


def bar(mesh, start, end, width, height):
    """A straight timber, upright in cross section, from `start` to `end`."""
    direction = [e - s for s, e in zip(start, end)]
    length = math.sqrt(sum(d * d for d in direction))
    forward = [d / length for d in direction]
    level = math.hypot(forward[0], forward[1])
    side = ([-forward[1] / level, forward[0] / level, 0.0] if level > 1e-9 else [0.0, 1.0, 0.0])
    up = [forward[1] * side[2] - forward[2] * side[1], forward[2] * side[0] - forward[0] * side[2],
          forward[0] * side[1] - forward[1] * side[0]]

    def place(point):
        a, b, c = point
        return tuple(s + a * f + b * w + c * u for s, f, w, u in zip(start, forward, side, up))

    mesh.box((0, -width / 2, -height / 2), (length, width / 2, height / 2), place)


def timber():
    mesh = Mesh()
    for side in range(SIDES):
        here, there = side, side + 1
        bar(mesh, corner(here, POST_RADIUS, 0.2), corner(here, POST_RADIUS, BEAM_HEIGHT), 0.13,
            0.13)
        bar(mesh, corner(here, POST_RADIUS, BEAM_HEIGHT - 0.07),
            corner(there, POST_RADIUS, BEAM_HEIGHT - 0.07), 0.1, 0.16)
        bar(mesh, corner(here, EAVES_RADIUS, EAVES_HEIGHT - 0.09),
            corner(here, 0.1, APEX_HEIGHT - 0.12), 0.08, 0.12)
        if (side + 1) % SIDES != ENTRANCE:
            railing(mesh, here, there)
    return mesh


def railing(mesh, here, there):
    for height in (0.35, 1.05):
        bar(mesh, corner(here, POST_RADIUS, height), corner(there, POST_RADIUS, height), 0.06,
            0.07)
    for k in range(1, 8):
        foot, head = (
            tuple(a + (b - a) * k / 8 for a, b in zip(corner(here, POST_RADIUS, height),
                                                      corner(there, POST_RADIUS, height)))
            for height in (0.35, 1.05))
        bar(mesh, foot, head, 0.035, 0.035)


def roof():
    """Eight slopes, each with an outside and an underside 0.05 below it, and the eaves' edge."""
    mesh = Mesh()
    for drop in (0.0, 0.05):
        apex = mesh.vertex((0.0, 0.0, APEX_HEIGHT - drop))
        rim = [mesh.vertex(corner(side, EAVES_RADIUS, EAVES_HEIGHT - drop))
               for side in range(SIDES)]
        for k in range(SIDES):
            n = (k + 1) % SIDES
            mesh.face(*((rim[k], rim[n], apex) if drop == 0 else (rim[n], rim[k], apex)))
    outer, inner = 1, SIDES + 2
    for k in range(SIDES):
        n = (k + 1) % SIDES
        mesh.face(inner + k, inner + n, outer + n, outer + k)
    return mesh


def platform():
    """The floor, an octagonal prism, and a step before the entrance."""
    mesh = Mesh()
    low, high = ([mesh.vertex(corner(side, 2.45, height)) for side in range(SIDES)]
                 for height in (0.0, 0.2))
    middle = mesh.vertex((0.0, 0.0, 0.2))
    for k in range(SIDES):
        n = (k + 1) % SIDES
        mesh.face(low[k], low[n], high[n], high[k])
        mesh.face(high[k], high[n], middle)
    mesh.box((-0.7, -2.7, 0.0), (0.7, -2.27, 0.1))
    return mesh


def files():
    return {f"summerhouse-{make.__name__}.lxs": make().shape()
            for make in (timber, roof, platform)}
