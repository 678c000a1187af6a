"""Gives objects of type volume a mesh: a box around their grids, which nothing is seen of."""
import numpy as np

from . import ply
from .grids import bounds, reach
from .meshes import MeshParts

FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def box_of(thing):
    """Least corner and size of the box of a volume's grids, by which generated coordinates go."""
    least, most = bounds(thing)
    return tuple(map(float, least)), tuple(float(s) or 1.0 for s in most - least)


def write_box(thing, path, work):
    """The MeshParts of an object's box, with all that its grids reach."""
    least, most = ends = np.array(reach(thing))
    points = np.array([ends[(x, y, z), (0, 1, 2)] for z in (0, 1) for y in (0, 1) for x in (0, 1)])
    triangles = np.array([[f[i] for i in at] for f in FACES for at in ((0, 1, 2), (0, 2, 3))])
    work(_write, path, points, triangles)
    return MeshParts((least, most), True, {0: path}, triangles=points[triangles])


def _write(path, points, triangles):
    """Each face has corners of its own, for its normal."""
    rows = points[triangles].reshape(-1, 3)
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    ply.write(path, rows, np.repeat(normals, 3, axis=0), None,
              np.arange(len(rows)).reshape(-1, 3))
