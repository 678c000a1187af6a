"""Makes transforms that flatten space such as can be inverted, which lxsrender asks for."""
import numpy as np

FLAT = 1e-4        # of its extent: how thick what is flattened becomes, and how small a point
SINGULAR = 1e-7    # of the greatest singular value, below which one is rounding alone


def is_singular(matrix):
    """Whether it flattens space."""
    a, b, c = (tuple(row)[:3] for row in list(matrix)[:3])
    volume = (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
              a[2] * (b[0] * c[1] - b[1] * c[0]))
    norm = sum(x * x for row in (a, b, c) for x in row) ** 0.5
    # The least singular value by the greatest is no less than that: most need no decomposition.
    if abs(volume) > SINGULAR * norm ** 3:
        return False
    sizes = _sizes(matrix)
    return not sizes[2] > SINGULAR * sizes[0]


def is_seen(matrix):
    """Whether more than a line or a point is left of space."""
    if not is_singular(matrix):
        return True
    sizes = _sizes(matrix)
    return bool(sizes[1] > SINGULAR * sizes[0])


def placeable(matrices, extents):
    """Matrices as lxsrender takes them of something of these extents; one of them is seen.

    What is flattened to a plane becomes as good as flat. What is a line or a point at one end of
    the shutter's time is small there, of the shape that it has at the other.
    """
    if not any(map(is_singular, matrices)):
        return matrices
    found = [_thick(np.array(m, float), extents) if is_seen(m) else None for m in matrices]
    shape = next(m for m in found if m is not None)
    return tuple(_small(shape, given) if m is None else m for m, given in zip(found, matrices))


def _sizes(matrix):
    return np.linalg.svd(np.array(matrix, float)[:3, :3], compute_uv=False)


def _thick(matrix, extents):
    if not is_singular(matrix):
        return matrix
    left, sizes, right = np.linalg.svd(matrix[:3, :3])
    # What has no thickness of its own is not squeezed.
    own = np.abs(right[2]) @ extents
    sizes[2] = sizes[0] * min(FLAT * max(extents) / own if own > 0 else 1, 1)
    # What is flat has no handedness: it may as well not be mirrored.
    left[:, 2] *= np.linalg.det(left) * np.linalg.det(right)
    thick = matrix.copy()
    thick[:3, :3] = left * sizes @ right
    return thick


def _small(shape, given):
    small = np.array(given, float)
    small[:3, :3] = FLAT * shape[:3, :3]
    return small


def around_axis(matrix):
    """Place and third axis of a matrix, with other axes square to it; None without that axis."""
    given = np.array(matrix, float)
    length = np.linalg.norm(given[:3, 2])
    if not length > 0:
        return None
    axis = given[:3, 2] / length
    across = np.cross(np.eye(3)[np.argmin(np.abs(axis))], axis)
    across /= np.linalg.norm(across)
    given[:3, :3] = np.column_stack([across, np.cross(axis, across), axis])
    return given
