"""Turned things on tables: a goblet and a tumbler of glass, a vase to be silvered, a finger ring."""

from revolution import arc, revolve, smooth


def goblet():
    """A wine glass, 1 high: foot, stem, and a bowl whose wall has an outside and an inside."""
    outside = smooth([(0.034, 0.46), (0.11, 0.5), (0.2, 0.6), (0.235, 0.72), (0.215, 0.87),
                      (0.185, 0.985)], 3)
    inside = smooth([(0.173, 0.985), (0.203, 0.87), (0.221, 0.72), (0.187, 0.61), (0.1, 0.525),
                     (0.0, 0.51)], 3)
    return revolve([
        [(0.0, 0.0), (0.21, 0.0)],
        arc((0.21, 0.008), 0.008, -90, 90, 4),
        smooth([(0.21, 0.016), (0.1, 0.03), (0.04, 0.07), (0.026, 0.16), (0.024, 0.34),
                (0.034, 0.46)], 3) + outside[1:] + arc((0.179, 0.985), 0.006, 0, 180, 4)[1:]
        + inside[1:],
    ], 40)


def vase():
    """A closed vase, 1 high."""
    return revolve([
        [(0.0, 0.0), (0.14, 0.0)],
        smooth([(0.14, 0.0), (0.19, 0.1), (0.29, 0.3), (0.31, 0.45), (0.22, 0.66), (0.11, 0.8),
                (0.1, 0.88), (0.16, 1.0)], 3),
        smooth([(0.16, 1.0), (0.13, 0.985), (0.07, 0.88), (0.0, 0.85)], 3),
    ], 40)


def ring():
    """A ring of radius 1 inside, flat within and rounded without: its inside makes the caustic."""
    return revolve([
        [(1.0, 0.66), (1.0, 0.44), (1.0, 0.22), (1.0, 0.04)],
        arc((1.04, 0.04), 0.04, 180, 270, 4),
        smooth([(1.04, 0.0), (1.1, 0.01), (1.17, 0.12), (1.19, 0.35), (1.17, 0.58), (1.1, 0.69),
                (1.04, 0.7)], 3),
        arc((1.04, 0.66), 0.04, 90, 180, 4),
    ], 72)


def tumbler():
    """A tumbler, 1 high, filled to 0.72, as the surfaces of a glass of water: glass against air,
    glass against water, water against air. Normals look out of the glass, and up from the water."""
    inside = [(0.4, 0.72), (0.392, 0.6), (0.374, 0.36), (0.358, 0.16)]
    return {
        "tumbler.ply": revolve([
            [(0.0, 0.0), (0.16, 0.004), (0.32, 0.0)],
            smooth([(0.32, 0.0), (0.348, 0.008), (0.366, 0.04), (0.394, 0.36), (0.43, 0.8),
                    (0.442, 0.984)], 4)
            + arc((0.431, 0.984), 0.011, 0, 180, 6)[1:]
            + smooth([(0.42, 0.984), (0.409, 0.84), inside[0]], 4)[1:],
        ], 64),
        "tumbler-wet.ply": revolve([
            smooth(inside + [(0.33, 0.112), (0.25, 0.096), (0.0, 0.09)], 4),
        ], 64),
        "tumbler-water.ply": revolve([
            smooth([inside[0], (0.388, 0.708), (0.36, 0.703), (0.2, 0.7), (0.0, 0.7)], 4),
        ], 64),
    }


def files():
    single = {f"{make.__name__}.ply": make() for make in (goblet, vase, ring)}
    return {name: mesh.ply() for name, mesh in (single | tumbler()).items()}
