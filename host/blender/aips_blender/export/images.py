"""Gives each Blender image a file of linear values that lxsrender reads, beside the scene."""
import os
import shutil

import numpy as np

from .. import exr
from .colours import surface_image

READ_AS_THEY_ARE = ('.exr', '.hdr')  # linear floats


class Images:
    """Files of images, once each: linear ones are copied, others written as linear EXR."""

    def __init__(self, folder, left_out):
        self._folder = folder
        self._left_out = left_out
        self._files = {}

    def file(self, image):
        """Path of a file of linear values, or None where the image cannot be had."""
        key = image.name_full  # libraries may have images of one name
        if key not in self._files:
            self._files[key] = self._find(image)
        return self._files[key]

    def _find(self, image):
        if image.source not in ('FILE', 'GENERATED'):
            self._left_out.add(f'images of the kind {image.source.lower()} are left out',
                               image.name)
            return None
        path = image.filepath_from_user() if image.source == 'FILE' else ''
        # Linear ones are heights, normals and the like, or light, and stay as they are.
        linear = image.colorspace_settings.name in ('Linear', 'Raw', 'Non-Color')
        stem = os.path.join(self._folder, f'{safe_name(image.name)}-{len(self._files)}')
        if linear and path.lower().endswith(READ_AS_THEY_ARE) and os.path.isfile(path) \
                and not image.is_dirty:
            return shutil.copyfile(path, stem + os.path.splitext(path)[1])
        rgba = pixels(image)
        if rgba is None:
            self._left_out.add('images without data are left out', image.name)
            return None
        target = stem + '.exr'
        rgb = np.nan_to_num(rgba[:, :, :3])
        exr.write(target, rgb if linear else surface_image(rgb))
        return target


def pixels(image):
    """Linear RGBA, rows from the top, or None where there are none."""
    width, height = image.size
    if not width or not height:
        return None
    values = np.empty(width * height * image.channels, np.float32)
    image.pixels.foreach_get(values)
    values = values.reshape(height, width, image.channels)[::-1]
    if image.channels < 3:
        values = np.repeat(values[:, :, :1], 3, axis=2)
    # Bytes come as they are stored, floats are linear already.
    if not image.is_float and image.colorspace_settings.name in ('sRGB', 'Filmic sRGB'):
        return srgb_to_linear(values)
    return values


def srgb_to_linear(values):
    """IEC 61966-2-1; alpha stays as it is."""
    linear = np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)
    if values.shape[2] > 3:
        linear[:, :, 3] = values[:, :, 3]
    return linear.astype(np.float32)


def safe_name(name):
    """Letters, digits and a few marks of a name, for files."""
    return ''.join(c if c.isalnum() and c.isascii() or c in '-_.' else '_' for c in name)[:60]
