"""Says in which file lxsrender finds each of Blender's images, and how it is to read it.

Files on disk are read where they lie. What is packed is written as it is stored, and pixels that
are in no file as they are; files of one content have one name, and are written once.
"""
import dataclasses
import hashlib
import os

import numpy as np

from .. import exr
from .lxs_text import fits_string, parameter
from .targa import write_targa

# Endings of the formats that lxsrender and Blender read alike.
READ_AS_THEY_ARE = {'.exr', '.hdr', '.png', '.jpg', '.jpeg', '.tif', '.tiff', '.bmp', '.tga',
                    '.webp', '.jp2', '.sgi'}
DATA = {'Raw', 'Non-Color', 'Generic Data'}
LINEAR = DATA | {'Linear', 'Linear Rec.709'}  # the first of Blender 3
SRGB = 'sRGB'


@dataclasses.dataclass(frozen=True)
class ImageFile:
    path: str
    srgb: bool  # whether its values are stored by sRGB's curve, in place of linearly
    times_alpha: bool = False  # whether its colours count by its alpha, unless that is used apart

    def color_space(self):
        return parameter('string', 'colorspace', 'srgb') if self.srgb else \
            parameter('float', 'gamma', 1.0)


class Images:
    """Files of images, once each; `folder` is for those that have to be written."""

    def __init__(self, folder, left_out):
        self._folder = folder
        self._left_out = left_out
        self._known = {}

    def file(self, image, user=None):
        """The ImageFile of an image, or None where it cannot be had, which is told; `user` says
        which of a sequence."""
        sequence = image.source == 'SEQUENCE' and user is not None
        # Libraries may have images of one name.
        key = (image.name_full, user.frame_current if sequence else 0)
        if key not in self._known:
            self._known[key] = self._find(image, user if sequence else None)
            if self._known[key] is None:
                self._left_out.add('images that cannot be read are magenta', image.name)
        return self._known[key]

    def _find(self, image, user):
        if image.source == 'TILED':
            self._left_out.add('of tiled images the first tile is taken', image.name)
        space = image.colorspace_settings.name
        known = space == SRGB or space in LINEAR
        if image.source in ('FILE', 'SEQUENCE', 'TILED') and known and not image.is_dirty:
            found = self._stored(image, user)
            if found:
                return ImageFile(found, space == SRGB, _is_straight(image, space))
        return self._pixels(image, space)

    def _stored(self, image, user):
        """Path of what is on disk or packed, or None."""
        path = image.filepath_from_user(image_user=user) if user else image.filepath_from_user()
        path = path.replace('<UDIM>', '1001')
        ending = os.path.splitext(path or image.name)[1].lower()
        if ending not in READ_AS_THEY_ARE:
            return None
        if image.packed_file:
            data = image.packed_file.data
            return self._once(image.name, ending, data, lambda to: _write(to, data))
        if not os.path.isfile(path):
            return None
        if fits_string(path):
            return path
        with open(path, 'rb') as file:
            data = file.read()
        return self._once(image.name, ending, data, lambda to: _write(to, data))

    def _pixels(self, image, space):
        values = pixels(image)
        if values is None:
            return None
        if image.is_float:  # which Blender has made linear, whatever the file has
            values = np.nan_to_num(values)
            path = self._once(image.name, '.exr', values, lambda to: exr.write(to, values))
            return ImageFile(path, False)
        if space != SRGB and space not in LINEAR:
            self._left_out.add(f'images of the colour space {space} are taken for sRGB', image.name)
        stored = np.rint(np.clip(values, 0, 1) * 255).astype(np.uint8)
        path = self._once(image.name, '.tga', stored, lambda to: write_targa(to, stored))
        return ImageFile(path, space not in LINEAR, _is_straight(image, space))

    def _once(self, name, ending, data, write):
        digest = hashlib.blake2b(data, digest_size=8).hexdigest()
        stem = safe_name(os.path.splitext(name)[0])
        path = os.path.join(self._folder, f'{stem}-{digest}{ending}')
        if not os.path.exists(path):
            write(path + '.part')
            os.replace(path + '.part', path)
        return path


def _is_straight(image, space):
    return image.alpha_mode == 'STRAIGHT' and space not in DATA


def _write(path, data):
    with open(path, 'wb') as file:
        file.write(data)


def pixels(image):
    """RGBA, rows from the top, or None where there are none: linear if the image is of floats, else
    as they are stored, from 0 to 1."""
    width, height = image.size
    if not width or not height:
        return None
    values = np.empty(width * height * image.channels, np.float32)
    image.pixels.foreach_get(values)
    values = values.reshape(height, width, image.channels)[::-1]
    if image.channels < 4:
        opaque = np.ones((height, width, 1), np.float32)
        colors = values[:, :, :3] if image.channels == 3 else np.repeat(values[:, :, :1], 3, axis=2)
        values = np.concatenate([colors, opaque], axis=2)
    return np.ascontiguousarray(values)


def safe_name(name):
    """Letters, digits and a few marks of a name, for files."""
    return ''.join(c if c.isalnum() and c.isascii() or c in '-_.' else '_' for c in name)[:60]
