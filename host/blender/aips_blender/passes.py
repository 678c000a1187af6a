"""Which passes a render has, and which channels of lxsrender's EXR each is made of."""
import dataclasses

import numpy as np

from . import murmur


@dataclasses.dataclass(frozen=True)
class Pass:
    name: str          # in Blender
    channels: tuple    # in the EXR
    letters: str       # of Blender's channels; masks have small ones, as Cycles'
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
MASKS = {'objects': 'CryptoObject', 'materials': 'CryptoMaterial'}  # Cryptomatte, by layer
LEVELS_A_PASS = 2       # ids with their coverages that one pass of four channels holds
MOST_LEVELS = 6         # of lxsrender


def chosen(settings, light_groups):
    """Passes beside Combined: those that settings name, then one a light group."""
    found = [each for key, each in BY_SETTING.items() if key in settings]
    return found + [_color(group, group) for group in light_groups]


def layers(passes):
    """What lxsrender is to be asked for."""
    return tuple(dict.fromkeys(p.layer for p in passes if p.layer))


def masks(wanted, levels):
    """Passes of the masks whose layers are wanted, for so many levels."""
    count = -(-min(levels, MOST_LEVELS) // LEVELS_A_PASS)
    found = []
    for layer, stem in MASKS.items():
        for i in range(count if layer in wanted else 0):
            name = f'{stem}{i:02}'
            found.append(Pass(name, tuple(f'{name}.{c}' for c in 'RGBA'), 'rgba', 'COLOR', layer))
    return found


def mask_texts(texts, view_layer):
    """What an image's header tells of masks, as Blender has it: keys and texts.

    Blender's masks are named by their view layer too.
    """
    told = {}
    for key, stem in texts.items():
        if not (key.startswith('cryptomatte/') and key.endswith('/name')):
            continue
        own = f'{view_layer}.{stem}'
        for what in ('hash', 'conversion', 'manifest', 'name'):
            text = own if what == 'name' else texts[key[:-len('name')] + what]
            told[f'cryptomatte/{murmur.hash_of(own):08x}'[:-1] + f'/{what}'] = text
    return told


def pixels(image, wanted):
    """Floats of a pass as Blender wants them: rows from the bottom, one pixel after another.

    Combined is denoised where the image is.
    """
    denoised = wanted is COMBINED and DENOISED[0] in image.channels
    values = image.stack(DENOISED if denoised else wanted.channels)
    if wanted.letters == 'RGBA':
        alpha = image.channels.get('A', np.ones_like(values[:, :, 0]))
        values = np.dstack([values, alpha])
    return np.ascontiguousarray(values[::-1], np.float32).reshape(-1, len(wanted.letters))
