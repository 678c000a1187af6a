"""Writes Targa files: bytes of RGBA as they are, which takes no time."""
import struct

HEADER = '<3B2HB4H2B'
TRUE_COLOR, FROM_THE_TOP = 2, 0x20


def write_targa(path, rgba):
    """Rows from the top x columns x 4 of bytes."""
    height, width, _ = rgba.shape
    with open(path, 'wb') as file:
        file.write(struct.pack(HEADER, 0, 0, TRUE_COLOR, 0, 0, 0, 0, 0, width, height, 32,
                               FROM_THE_TOP | 8))
        file.write(rgba[:, :, [2, 1, 0, 3]].tobytes())
