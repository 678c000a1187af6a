"""Turns Blender's evaluated meshes into PLY files, one for each material slot that is used."""
import contextlib
import dataclasses
import os

import numpy as np

from . import ply
from .corners import Corners, array
from .media import CLEAR

LEAST_SINE = 1e-12  # of triangles, as in lxsrender
BACK = 1e-4  # of the mesh's extent: how far the back of what shines lies behind its front


@dataclasses.dataclass
class MeshParts:
    """Files of a mesh by material slot; of parts that shine also those of their backs."""
    bounds: tuple                 # least and greatest coordinates
    closed: bool                  # where that is asked for: something fills it, or it shines
    files: dict = dataclasses.field(default_factory=dict)
    backs: dict = dataclasses.field(default_factory=dict)
    shines_outwards: bool = False  # alone: no back can be seen, but from within
    triangles: object = None      # their corners, where something fills the mesh

    def remove(self):
        """The files go."""
        for path in [*self.files.values(), *self.backs.values()]:
            with contextlib.suppress(OSError):
                os.remove(path)


def is_closed(mesh):
    """Whether each edge has two faces."""
    edges = array(mesh.loops, 'edge_index', np.int32, 1).ravel()
    counts = np.bincount(edges, minlength=len(mesh.edges))
    return len(counts) > 0 and bool((counts == 2).all())


def _turns_one_way(mesh):
    """Whether the normals of neighbouring faces, two an edge, lie on one side."""
    edges = array(mesh.loops, 'edge_index', np.int32, 1).ravel()
    begins = array(mesh.loops, 'vertex_index', np.int32, 1).ravel()
    forwards = begins == array(mesh.edges, 'vertices', np.int32, 2)[edges, 0]
    return bool((np.bincount(edges, forwards, len(mesh.edges)) == 1).all())


def _shines_outwards(mesh, shaders, positions):
    """Whether a closed mesh does so alone: all of it shines, and nothing is seen through it."""
    if not all(made.emission is not None and made.opaque for made in shaders):
        return False
    return _turns_one_way(mesh) and _signed_volume(positions) > 0


def _signed_volume(positions):
    """Volume of a closed mesh by its triangles' corners, below 0 where normals turn inwards."""
    a, b, c = np.moveaxis(positions.reshape(-1, 3, 3).astype(float) - positions[0], 1, 0)
    return float((a * np.cross(b, c)).sum() / 6)


def write_parts(mesh, folder, stem, shader, tell, work):
    """Writes the mesh's parts as `folder/stem-SLOT.ply`; None where it has no triangle.

    `shader(slot)` is the Shader of a part; `tell(what)` says what of the mesh is left out. What is
    slow and needs no mesh of Blender's is handed to `work(what, *arguments)`.
    Cycles' meshes shine on both sides, LuxRender's on that of their normals: what shines gets a
    back.
    """
    corners = Corners(mesh) if mesh.polygons else None
    if corners is None or not corners.slots:
        return None
    used = {slot: shader(slot) for slot in corners.slots}
    filled = any(made.medium != CLEAR for made in used.values())
    shines = any(made.emission is not None for made in used.values())
    parts = MeshParts(corners.bounds(), (filled or shines) and is_closed(mesh))
    for slot, made in used.items():
        _add(parts, slot, os.path.join(folder, f'{stem}-{slot}'), made)
        work(_write_corners, parts.files[slot], parts.backs.get(slot), corners, slot,
             corners.read(made.layers, tell))
    if filled:
        parts.triangles = corners.positions.reshape(-1, 3, 3).astype(float)
    parts.shines_outwards = parts.closed and shines and \
        _shines_outwards(mesh, used.values(), corners.positions)
    return parts


def write_tubes(rows, faces, folder, stem, slot, made, work):
    """MeshParts of hair, which is of one material, a Shader."""
    parts = MeshParts((rows[:, :3].min(axis=0), rows[:, :3].max(axis=0)), False)
    _add(parts, slot, os.path.join(folder, stem), made)
    work(_write_sides, parts.files[slot], parts.backs.get(slot), rows, faces, rows.shape[1] > 6,
         False)
    return parts


def _add(parts, slot, stem, made):
    """Names one part's file or files."""
    parts.files[slot] = f'{stem}.ply'
    if made.emission is not None:
        parts.backs[slot] = f'{stem}-back.ply'


def _write_corners(path, back, corners, slot, read):
    chosen, has_uv, has_color = corners.rows(slot, read)
    rows, faces = ply.welded(_with_area(chosen))
    _write_sides(path, back, rows, faces, has_uv, has_color)


def _with_area(corners):
    """Without triangles that have none, of which nothing is to be said: many meshes hold some."""
    a, b, c = np.moveaxis(corners[:, :3].reshape(-1, 3, 3).astype(float), 1, 0)
    longest = np.max([((q - p) ** 2).sum(axis=1) for p, q in ((a, b), (b, c), (c, a))], axis=0)
    there = np.linalg.norm(np.cross(b - a, c - a), axis=1) > LEAST_SINE * longest
    return corners[np.repeat(there, 3)] if there.any() else corners


def _write_sides(path, back, rows, faces, has_uv, has_color):
    _write(path, rows, faces, has_uv, has_color)
    if back:
        _write(back, _turned(rows), faces[:, ::-1], has_uv, has_color)


def _turned(rows):
    """The same surface from behind, a little off its front."""
    turned = rows.copy()
    extent = np.ptp(rows[:, 0:3], axis=0).max()
    turned[:, 0:3] -= BACK * extent * rows[:, 3:6]
    turned[:, 3:6] = -rows[:, 3:6]
    return turned


def _write(path, rows, triangles, has_uv, has_color):
    ply.write(path, rows[:, 0:3], rows[:, 3:6], rows[:, 6:8] if has_uv else None, triangles,
              rows[:, -3:] if has_color else None)
