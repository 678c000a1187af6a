"""Says which OpenVDB file holds the grids of a volume, and reads them by textures "densitygrid".

Files are read where they lie, for the frame. What modifiers or nodes make of a volume is in no
file: it is written.
"""
import dataclasses
import os

import numpy as np

from .images import safe_name
from .lxs_text import factor, fits_string, parameter

MIDDLE = 0.5  # of a voxel: there Cycles has the values that OpenVDB has at its index
COLORS = {'VECTOR_FLOAT', 'VECTOR_DOUBLE'}
NUMBERS = {'FLOAT', 'DOUBLE', 'INT', 'INT64', 'BOOLEAN'}


@dataclasses.dataclass(frozen=True)
class Grid:
    name: str        # in the file
    is_color: bool
    shift: tuple     # from where the file has a value to where Cycles has it


@dataclasses.dataclass(frozen=True)
class Grids:
    """Of one file. `to_object` leads from the file's space to the object's, four rows."""
    path: str
    by_name: tuple                # pairs of a name by which nodes ask, and a Grid
    to_object: tuple = tuple(map(tuple, np.eye(4)))
    lacking: tuple = ()           # names of grids that Blender has, and the file has otherwise
    by_size: bool = False         # whether density is for each length in the object's space

    def named(self, name):
        return dict(self.by_name).get(name)


def of_volume(thing, folder, number):
    """The Grids of an evaluated object of type volume; None where its file cannot be read."""
    grids = thing.data.grids
    if not grids.load() or not len(grids):
        return None
    path = grids.frame_filepath.replace(os.sep, '/')
    if not path or thing.modifiers or not fits_string(path):
        path = os.path.join(folder, f'{number}-{safe_name(thing.name)}.vdb')
        if not grids.save(path):
            return None
    found = tuple((grid.name, Grid(grid.name, grid.data_type in COLORS, _middle(grid)))
                  for grid in grids if grid.data_type in COLORS | NUMBERS)
    return Grids(path, found, by_size=thing.data.render.space == 'OBJECT')


def _middle(grid):
    """From a voxel's corner to its middle."""
    voxel = np.array(grid.matrix_object, float)
    return tuple(MIDDLE * voxel[:3, :3].sum(axis=1))


def reach(thing):
    """Least and greatest place where a volume may have values: Blender's box, which ends at the
    indices of voxels, moved to their middles, and a voxel on by interpolation."""
    voxels = [np.abs(np.array(grid.matrix_object, float)[:3, :3]).sum(axis=1)
              for grid in thing.data.grids]
    voxel = np.max(voxels, axis=0)
    least, most = bounds(thing)
    return least - (1 - MIDDLE) * voxel, most + (1 + MIDDLE) * voxel


def bounds(thing):
    """Least and greatest corner of an object's box in its own space."""
    corners = np.array([tuple(corner) for corner in thing.bound_box])
    return corners.min(axis=0), corners.max(axis=0)


class GridTextures:
    """Textures of grids, each once at each place."""

    def __init__(self, text):
        self._text = text
        self._known = {}

    def of(self, grids, grid, matrix):
        """The name of the colour texture of a grid of an object that is placed by `matrix`."""
        key = grids.path, grid, grids.to_object, matrix
        if key not in self._known:
            self._known[key] = self._written(grids, grid, matrix)
        return self._known[key]

    def _written(self, grids, grid, matrix):
        text = self._text
        moved = np.eye(4)
        moved[:3, 3] = grid.shift
        text.statement('TransformBegin')
        text.matrix('ConcatTransform', np.array(matrix) @ np.array(grids.to_object) @ moved)
        name = text.free_name(f'grid {grid.name}')
        text.statement('Texture', name, 'color' if grid.is_color else 'float', 'densitygrid',
                       parameters=[text.file(grids.path),
                                   parameter('string', 'gridname', grid.name)])
        text.statement('TransformEnd')
        if grid.is_color:
            return name
        grey = text.free_name(f'grey {name}')
        text.statement('Texture', grey, 'color', 'mix', parameters=[factor('amount', name)])
        return grey
