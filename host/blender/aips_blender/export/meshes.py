"""Turns Blender's evaluated meshes into PLY files, one for each material slot that is used."""
import os

import numpy as np

from . import ply
from .media import CLEAR

BACK = 1e-4  # of the mesh's extent: how far the back of what shines lies behind its front


class MeshParts:
    """Files of a mesh by material slot; of open parts that shine, also those of their backs."""

    def __init__(self, bounds, closed):
        self.files = {}
        self.backs = {}
        self.bounds = bounds    # least and greatest coordinates
        self.closed = closed
        self.triangles = None   # their corners, where something fills the mesh


def _array(collection, attribute, kind, width):
    values = np.empty(len(collection) * width, kind)
    collection.foreach_get(attribute, values)
    return values.reshape(-1, width)


def _corners(mesh):
    """Position, normal and, where there are any, uv and colour of each triangle's corners."""
    mesh.calc_loop_triangles()
    mesh.calc_normals_split()
    triangles = mesh.loop_triangles
    positions = _array(mesh.vertices, 'co', np.float32, 3)
    loops = _array(triangles, 'loops', np.int32, 3).ravel()
    vertices = _array(triangles, 'vertices', np.int32, 3).ravel()
    normals = _array(triangles, 'split_normals', np.float32, 9).reshape(-1, 3)
    columns = [positions[vertices], normals]
    uv = mesh.uv_layers.active
    if uv:
        columns.append(_array(uv.data, 'uv', np.float32, 2)[loops])
    colors = _corner_colors(mesh, loops, vertices)
    if colors is not None:
        columns.append(colors)
    return np.hstack(columns), uv is not None, colors is not None


def _corner_colors(mesh, loops, vertices):
    attribute = mesh.color_attributes.active_color
    if attribute is None or attribute.domain not in ('POINT', 'CORNER'):
        return None
    colors = _array(attribute.data, 'color', np.float32, 4)[:, :3]
    return colors[loops if attribute.domain == 'CORNER' else vertices]


def is_closed(mesh):
    """Whether each edge has two faces."""
    edges = _array(mesh.loops, 'edge_index', np.int32, 1).ravel()
    counts = np.bincount(edges, minlength=len(mesh.edges))
    return len(counts) > 0 and bool((counts == 2).all())


def write_parts(mesh, folder, stem, shader):
    """Writes the mesh's parts as `folder/stem-SLOT.ply`; None where it has no triangle.

    `shader(slot)` is the Shader of a part. Cycles' meshes shine on both sides, LuxRender's on that
    of their normals: open parts get a back.
    """
    if not mesh.polygons:
        return None
    corners, has_uv, has_color = _corners(mesh)
    slots = _array(mesh.loop_triangles, 'material_index', np.int32, 1).ravel()
    if not len(slots):
        return None
    positions = corners[:, :3]
    parts = MeshParts((positions.min(axis=0), positions.max(axis=0)), is_closed(mesh))
    for slot in map(int, np.unique(slots)):
        chosen = corners.reshape(len(slots), 3, -1)[slots == slot].reshape(-1, corners.shape[1])
        rows, triangles = ply.welded(chosen)
        parts.files[slot] = os.path.join(folder, f'{stem}-{slot}.ply')
        _write(parts.files[slot], rows, triangles, has_uv, has_color)
        if shader(slot).medium != CLEAR:
            parts.triangles = positions.reshape(-1, 3, 3).astype(float)
        if not parts.closed and shader(slot).emission is not None:
            parts.backs[slot] = os.path.join(folder, f'{stem}-{slot}-back.ply')
            _write(parts.backs[slot], _turned(rows), triangles[:, ::-1], has_uv, has_color)
    return parts


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
