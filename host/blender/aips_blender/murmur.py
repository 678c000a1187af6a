"""MurmurHash3 (Appleby), by which the Cryptomatte specification names masks in files."""

BITS = 0xffffffff


def _turned(value, by):
    return (value << by | value >> 32 - by) & BITS


def _scrambled(block):
    return _turned(block * 0xcc9e2d51 & BITS, 15) * 0x1b873593 & BITS


def hash_of(text):
    """The variant x86_32 with seed 0, of a text in UTF-8."""
    data = text.encode()
    whole = len(data) // 4 * 4
    value = 0
    for at in range(0, whole, 4):
        value ^= _scrambled(int.from_bytes(data[at:at + 4], 'little'))
        value = (_turned(value, 13) * 5 + 0xe6546b64) & BITS
    if whole < len(data):
        value ^= _scrambled(int.from_bytes(data[whole:], 'little'))
    value ^= len(data)
    for shift, factor in ((16, 0x85ebca6b), (13, 0xc2b2ae35)):
        value = (value ^ value >> shift) * factor & BITS
    return value ^ value >> 16
