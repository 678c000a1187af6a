"""A washbasin, the spout of its tap, and the glass cover of a lamp. One unit is a metre."""

from revolution import arc, revolve, smooth
from tube import circle, tube


def basin():
    """A bowl that stands on a washstand: 0.4 wide, 0.13 high, its wall 12 mm thick."""
    return revolve([
        [(0.0, 0.0), (0.11, 0.0)],
        smooth([(0.11, 0.0), (0.15, 0.012), (0.186, 0.055), (0.2, 0.124)], 4)
        + arc((0.194, 0.124), 0.006, 0, 180, 4)[1:]
        + smooth([(0.188, 0.124), (0.174, 0.06), (0.142, 0.024), (0.1, 0.013), (0.03, 0.011),
                  (0.0, 0.0108)], 4)[1:],
    ], 48)


def cover():
    """The cover of a lamp, open below: 0.1 wide, 0.15 high, of glass 4 mm thick."""
    outside = smooth([(0.05, 0.0), (0.0505, 0.04), (0.0495, 0.1), (0.038, 0.134),
                      (0.018, 0.1475), (0.0, 0.15)], 4)
    inside = smooth([(0.0, 0.146), (0.0165, 0.1435), (0.0345, 0.131), (0.0455, 0.1),
                     (0.0465, 0.04), (0.046, 0.0)], 4)
    return revolve([outside, inside, [(0.046, 0.0), (0.05, 0.0)]], 40)


def spout():
    """Up, over in a half circle, and down a little: the outlet is 0.15 in front (towards -y)."""
    return tube([(0, 0, 0), (0, 0, 0.09), (0, 0, 0.18), (0, 0, 0.21)]
                + circle((0, -0.075, 0.22), 0.075, 0, 180, 14, (1, 2)) + [(0, -0.15, 0.19)],
                0.0125, 20)


def files():
    return {"basin.ply": basin().ply(), "lamp-cover.ply": cover().ply(),
            "tap-spout.ply": spout().ply()}
