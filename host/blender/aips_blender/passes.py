"""Which passes a render has, and which channels of lxsrender's EXR each is made of."""
import dataclasses

import numpy as np


@dataclasses.dataclass(frozen=True)
class Pass:
    name: str          # in Blender
    channels: tuple    # in the EXR
    letters: str       # of Blender's channels
    kind: str          # COLOR, VECTOR or VALUE
    layer: str = ''    # what lxsrender is asked for; '' for what it writes anyway


def _color(name, stem, layer=''):
    return Pass(name, tuple(f'{stem}.{c}' for c in 'RGB'), 'RGB', 'COLOR', layer)


COMBINED = Pass('Combined', ('R', 'G', 'B'), 'RGBA', 'COLOR')
NOISY = Pass('Noisy Image', ('R', 'G', 'B'), 'RGB', 'COLOR')
DENOISED = ('denoised.R', 'denoised.G', 'denoised.B')
BY_SETTING = {
    'albedo': _color('Albedo', 'albedo', 'albedo'),
    'normal': Pass('Normal', ('normal.X', 'normal.Y', 'normal.Z'), 'XYZ', 'VECTOR', 'normal'),
    'depth': Pass('Depth', ('depth.Z',), 'Z', 'VALUE', 'depth'),
    'direct': _color('Direct', 'direct', 'direct'),
    'indirect': _color('Indirect', 'indirect', 'indirect'),
    'caustics': _color('Caustics', 'caustics', 'caustics'),
    'error': _color('Error', 'error'),
}


def chosen(settings, light_groups):
    """Passes beside Combined: those that settings name, then one a light group."""
    found = [each for key, each in BY_SETTING.items() if key in settings]
    return found + [_color(group, group) for group in light_groups]


def layers(passes):
    """What lxsrender is to be asked for."""
    return tuple(p.layer for p in passes if p.layer)


def pixels(image, wanted):
    """Floats of a pass as Blender wants them: rows from the bottom, one pixel after another.

    Combined is denoised where the image is.
    """
    denoised = wanted is COMBINED and DENOISED[0] in image.channels
    values = image.stack(DENOISED if denoised else wanted.channels)
    if wanted.letters == 'RGBA':
        values = np.concatenate([values, np.ones_like(values[:, :, :1])], axis=2)
    return np.ascontiguousarray(values[::-1], np.float32).reshape(-1, len(wanted.letters))
