"""Finds the grids of smoke in the cache of its domain, a mesh with Blender's modifier Fluid.

Files have coordinates in the world's units, from the domain's least corner on.
"""
import os

import numpy as np

from .grids import MIDDLE, Grid, Grids, bounds
from .lxs_text import fits_string

# Folder, beginning of the file's name, and ending of the grids' names: with details by noise first.
CACHES = (('noise', 'fluid_noise', '_noise'), ('data', 'fluid_data', ''))
NAMES = ('density', 'flame')
LACKING = ('color', 'heat', 'temperature', 'velocity')  # parts, or numbers of another range


def settings_of(thing):
    """The settings of an object that is a domain of gas, or None; those of liquid are meshes."""
    for modifier in thing.modifiers:
        if modifier.type == 'FLUID' and modifier.fluid_type == 'DOMAIN':
            settings = modifier.domain_settings
            return settings if settings.domain_type == 'GAS' else None
    return None


def cached(folder, frame, by_noise):
    """Path of the file of a frame, and the ending of its grids' names; None where there is none."""
    for part, begin, ending in CACHES[0 if by_noise else 1:]:
        path = '/'.join([folder.replace(os.sep, '/'), part, f'{begin}_{frame:04d}.vdb'])
        if os.path.isfile(path) and fits_string(path):
            return path, ending
    return None


def of_domain(thing, settings, folder, frame):
    """The Grids of a domain of this cache, or None."""
    found = cached(folder, frame, settings.use_noise)
    if found is None:
        return None
    path, ending = found
    least, most = bounds(thing)
    size = most - least
    cells = np.array(tuple(settings.domain_resolution), float)
    length = (size * np.array(tuple(thing.matrix_world.to_scale()))).max()
    if not (cells > 0).all() or not length > 0:
        return None
    voxel = length / cells.max()
    to_object = np.diag([*(size / (cells * voxel)), 1.0])
    to_object[:3, 3] = least
    middle = MIDDLE * voxel / (settings.noise_scale if ending else 1)
    burns = len(getattr(settings, 'flame_grid', ())) > 0
    names = NAMES if burns else NAMES[:1]
    return Grids(path, tuple((name, Grid(name + ending, False, (middle,) * 3)) for name in names),
                 tuple(map(tuple, to_object)), LACKING)
