"""Tells in which volumes things lie: those of closed meshes around them, and the world's.

The scene language asks each surface for the media on both of its sides; Blender has a volume
within each mesh of such a material, and these overlap.
"""
import numpy as np

from .media import CLEAR, both

DIRECTION = np.array([0.4117, 0.2339, 0.8808])  # along no edge or face that is likely
LEAST_OVERLAP = 1e-5  # of the extent, below which boxes only touch
SHRUNK = 1e-3         # share by which boxes are made smaller before they are looked for


class Space:
    """The inside of a closed mesh at its place."""

    def __init__(self, placed, medium, triangles, matrix):
        self.placed = placed
        self.medium = medium
        self._triangles = triangles
        self._to_mesh = np.linalg.inv(matrix)
        self.box = box_of(transformed(triangles.reshape(-1, 3), matrix))

    def holds(self, points):
        """Which of the points lie inside."""
        inside = ((points > self.box[0]) & (points < self.box[1])).all(axis=1)
        for i in np.flatnonzero(inside):
            inside[i] = self._crossings(transformed(points[i:i + 1], self._to_mesh)[0]) % 2 == 1
        return inside

    def _crossings(self, origin):
        """Moeller and Trumbore 1997: how often a ray from there meets the mesh."""
        a, b, c = (self._triangles[:, i] for i in range(3))
        ab, ac, to = b - a, c - a, origin - a
        across = np.cross(DIRECTION, ac)
        scale = (ab * across).sum(axis=1)
        scale[scale == 0] = np.inf
        u = (to * across).sum(axis=1) / scale
        turned = np.cross(to, ab)
        v = turned @ DIRECTION / scale
        far = (ac * turned).sum(axis=1) / scale
        return int(((u >= 0) & (v >= 0) & (u + v <= 1) & (far > 0)).sum())


class Spaces:
    def __init__(self, world, left_out):
        self.world = world  # the Medium of the world
        self._spaces = []
        self._left_out = left_out

    def add(self, space):
        self._spaces.append(space)

    def scatter(self):
        return any(m.is_scattering() for m in [self.world] + [s.medium for s in self._spaces])

    def at(self, point):
        """The medium at a point."""
        return self._within([s for s in self._spaces if s.holds(np.array([point], float))[0]])

    def around(self, placed, bounds):
        """The medium around something placed; `bounds` are least and greatest of its mesh."""
        if not self._spaces:
            return self.world
        corners = transformed(corners_of(bounds), np.array(placed.matrices[0], float))
        box = box_of(corners)
        others = [space for space in self._spaces if space.placed is not placed]
        holding = [space for space in others if space.holds(corners).all()]
        found = self._within(holding)
        # Where nothing is declared of a surface, rays stay in what they are in.
        is_declared = found != CLEAR or len(others) < len(self._spaces)
        if is_declared and any(_overlap(space.box, box) and not _within_box(space.box, box)
                               for space in others if space not in holding):
            self._left_out.add('what lies partly in a volume is taken to lie outside',
                               placed.name)
        return found

    def _within(self, spaces):
        found = self.world
        for space in spaces:
            found = both(found, space.medium)
        return found


def transformed(points, matrix):
    matrix = np.asarray(matrix, float)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def box_of(points):
    return points.min(axis=0), points.max(axis=0)


def corners_of(bounds):
    """Corners of a box, a little within it: what stands on a volume's floor lies in it."""
    corners = np.array([[bounds[i][0], bounds[j][1], bounds[k][2]]
                        for i in (0, 1) for j in (0, 1) for k in (0, 1)], float)
    middle = corners.mean(axis=0)
    return middle + (1 - SHRUNK) * (corners - middle)


def _overlap(a, b):
    """Whether boxes, which may be flat, do more than touch."""
    least = LEAST_OVERLAP * np.maximum(a[1] - a[0], b[1] - b[0]).max()
    return bool((a[1] > b[0] + least).all() and (b[1] > a[0] + least).all())


def _within_box(inner, outer):
    least = LEAST_OVERLAP * (outer[1] - outer[0]).max()
    return bool((inner[0] >= outer[0] - least).all() and (inner[1] <= outer[1] + least).all())
