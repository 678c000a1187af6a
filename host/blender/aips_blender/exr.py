"""Reads the OpenEXR files that lxsrender writes, and writes maps of floats for it to read.

Only what is needed: scan lines, 16- and 32-bit float channels, no compression or ZIP.
File layout: the OpenEXR project's "OpenEXR File Layout".
"""
import struct
import zlib

import numpy as np

from .reasons import Told

MAGIC = 20000630
VERSION = 2
TYPES = {1: np.dtype('<f2'), 2: np.dtype('<f4')}
LINES_PER_BLOCK = {0: 1, 2: 1, 3: 16}  # none, ZIPS, ZIP


class ExrError(Told):
    """The file is not one that this module reads."""


class Image:
    """Channels by name, each an array of rows from the top; texts of the header by name."""

    def __init__(self, channels, texts):
        self.channels = channels
        self.texts = texts

    def stack(self, names):
        """The named channels as rows x columns x channels; zero where one is missing."""
        shape = next(iter(self.channels.values())).shape
        zero = np.zeros(shape, np.float32)
        return np.stack([self.channels.get(name, zero) for name in names], axis=-1)


def read(path):
    with open(path, 'rb') as file:
        data = file.read()
    try:
        return _decode(data)
    except (struct.error, IndexError, KeyError, ValueError, zlib.error) as error:
        raise ExrError(f'{path} is not an EXR file that can be read: {error}') from error


def _decode(data):
    magic, version = struct.unpack_from('<iI', data)
    if magic != MAGIC or version & 0x200:
        raise ValueError('wrong magic number, or tiles')
    header, at = _header(data)
    x0, y0, x1, y1 = struct.unpack('<4i', header['dataWindow'][1])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    channels = _channel_list(header['channels'][1])
    pixels = {name: np.zeros((height, width), np.float32) for name, _ in channels}
    compression = header['compression'][1][0]
    lines = LINES_PER_BLOCK[compression]
    blocks = -(-height // lines)
    for offset in struct.unpack_from(f'<{blocks}Q', data, at):
        row, size = struct.unpack_from('<ii', data, offset)
        rows = range(row - y0, min(row - y0 + lines, height))
        block = data[offset + 8:offset + 8 + size]
        _fill(pixels, channels, rows, width, _unpacked(block, compression, channels, rows, width))
    texts = {name: value.decode('utf-8', 'replace')
             for name, (kind, value) in header.items() if kind == 'string'}
    return Image(pixels, texts)


def _header(data):
    """Attributes by name as (type, bytes), and where the table of offsets begins."""
    at, found = 8, {}
    while data[at]:
        name, at = _word(data, at)
        kind, at = _word(data, at)
        size, = struct.unpack_from('<i', data, at)
        found[name] = (kind, data[at + 4:at + 4 + size])
        at += 4 + size
    return found, at + 1


def _word(data, at):
    end = data.index(0, at)
    return data[at:end].decode(), end + 1


def _channel_list(data):
    at, found = 0, []
    while data[at]:
        name, at = _word(data, at)
        found.append((name, TYPES[struct.unpack_from('<i', data, at)[0]]))
        at += 16
    return found


def _unpacked(block, compression, channels, rows, width):
    size = sum(kind.itemsize for _, kind in channels) * width * len(rows)
    if compression == 0 or len(block) == size:
        return block
    coded = np.frombuffer(zlib.decompress(block), np.uint8)
    # Undoes the differences, then the two halves of even and odd bytes.
    summed = (np.cumsum(coded, dtype=np.uint64) - 128 * np.arange(len(coded), dtype=np.uint64))
    summed = (summed & 0xff).astype(np.uint8)
    plain = np.empty_like(summed)
    half = (len(summed) + 1) // 2
    plain[0::2], plain[1::2] = summed[:half], summed[half:]
    return plain.tobytes()


def _fill(pixels, channels, rows, width, block):
    at = 0
    for row in rows:
        for name, kind in channels:
            pixels[name][row] = np.frombuffer(block, kind, width, at)
            at += width * kind.itemsize


def write(path, values):
    """Writes rows (from the top) x columns x 3 or 4 as 32-bit floats without compression."""
    height, width, count = values.shape
    window = struct.pack('<4i', 0, 0, width - 1, height - 1)
    names = (b'A', b'B', b'G', b'R')[4 - count:]
    channels = b''.join(struct.pack('<2siB3xii', name, 2, 0, 1, 1) for name in names)
    attributes = (('channels', 'chlist', channels + b'\0'), ('compression', 'compression', b'\0'),
                  ('dataWindow', 'box2i', window), ('displayWindow', 'box2i', window),
                  ('lineOrder', 'lineOrder', b'\0'),
                  ('pixelAspectRatio', 'float', struct.pack('<f', 1)),
                  ('screenWindowCenter', 'v2f', struct.pack('<2f', 0, 0)),
                  ('screenWindowWidth', 'float', struct.pack('<f', 1)))
    head = struct.pack('<iI', MAGIC, VERSION)
    for name, kind, value in attributes:
        head += b'\0'.join((name.encode(), kind.encode(), struct.pack('<i', len(value)) + value))
    head += b'\0'
    line = 4 * count * width
    first = len(head) + 8 * height
    offsets = first + (line + 8) * np.arange(height, dtype='<u8')
    planes = np.ascontiguousarray(values[:, :, ::-1].transpose(0, 2, 1), '<f4')
    with open(path, 'wb') as file:
        file.write(head + offsets.tobytes())
        for row in range(height):
            file.write(struct.pack('<ii', row, line) + planes[row].tobytes())
