"""The colours to write so that lights and surfaces have given ones.

lxsrender takes a colour for the weights of LuxRender's seven spectra, as LuxRender does
(docs/understand/colours.md): a light of colour 1 0 0 shines as 0.95 0 0, a surface of 0.8 0.01 0.01
reflects 0.81 0.007 0.012. In Blender colours are plain products of RGB. Here the first is undone.
"""
import numpy as np

# By which channels are 1: what is shown in Rec. 709, as lxsrender shows it beside grey.
LIGHTS = {
    (1, 1, 1): (1, 1, 1), (1, 0, 0): (0.9515, -0.0042, -0.0009),
    (0, 1, 0): (0.0421, 1.0058, 0.0101), (0, 0, 1): (-0.0023, -0.0024, 0.9966),
    (0, 1, 1): (0.0444, 1.0054, 0.9979), (1, 0, 1): (0.9466, -0.0065, 0.9981),
    (1, 1, 0): (1.0078, 0.9984, 0.0138),
}
SURFACES = {
    (1, 1, 1): (1, 1, 1), (1, 0, 0): (1.0117, -0.0040, 0.0022),
    (0, 1, 0): (-0.0072, 1.0037, 0.0167), (0, 0, 1): (-0.0050, -0.0015, 0.9820),
    (0, 1, 1): (-0.0010, 1.0012, 0.9939), (1, 0, 1): (1.0233, -0.0107, 0.9903),
    (1, 1, 0): (1.0013, 1.0014, 0.0233),
}
STEPS = 6  # each leaves a twentieth of the difference


def shown(rgb, bases):
    """What colours are shown as: arrays whose last axis is that of the channels."""
    order = np.argsort(rgb, axis=-1)
    least, middle, most = np.moveaxis(np.take_along_axis(rgb, order, -1), -1, 0)[..., None]
    table = np.zeros((2, 3, 3))  # two channels or one; by the channel that lacks or stands alone
    for channel in range(3):
        table[0, channel] = bases[tuple(int(i != channel) for i in range(3))]
        table[1, channel] = bases[tuple(int(i == channel) for i in range(3))]
    pairs, single = table[0][order[..., 0]], table[1][order[..., 2]]
    return least + (middle - least) * pairs + (most - middle) * single


def written(wanted, bases, most):
    """Colours from 0 to `most` that are shown as wanted, or as near as these come."""
    wanted = np.asarray(wanted, np.float32)
    rgb = wanted.copy()
    for _ in range(STEPS):
        rgb = np.clip(rgb + wanted - shown(rgb, bases), 0, most)
    return rgb.astype(np.float32)


def light_color(wanted):
    """Of a light that shines with `wanted`."""
    return tuple(float(c) for c in written(wanted, LIGHTS, np.inf))


def surface_color(wanted, most=1):
    """Of a surface that reflects or transmits `wanted`, three numbers; a texture's name stays.

    Textures that shine are taken for surfaces, too, of any brightness.
    """
    if isinstance(wanted, str) or wanted[0] == wanted[1] == wanted[2]:
        return wanted
    return tuple(float(c) for c in written(wanted, SURFACES, most))
