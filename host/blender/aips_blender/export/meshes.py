"""Turns Blender's evaluated meshes into PLY files, one for each material slot that is used."""
import os

import numpy as np

from . import ply


class MeshParts:
    """Files of a mesh by material slot, and whether the mesh is closed."""

    def __init__(self, files, closed):
        self.files = files
        self.closed = closed


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
    columns = [positions[vertices], _array(triangles, 'split_normals', np.float32, 9).reshape(-1, 3)]
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


def write_parts(mesh, folder, stem):
    """Writes the mesh's parts as `folder/stem-SLOT.ply`; None where it has no triangle."""
    if not mesh.polygons:
        return None
    corners, has_uv, has_color = _corners(mesh)
    slots = _array(mesh.loop_triangles, 'material_index', np.int32, 1).ravel()
    files = {}
    for slot in np.unique(slots):
        chosen = corners.reshape(len(slots), 3, -1)[slots == slot].reshape(-1, corners.shape[1])
        rows, triangles = ply.welded(chosen)
        path = os.path.join(folder, f'{stem}-{slot}.ply')
        uvs = rows[:, 6:8] if has_uv else None
        ply.write(path, rows[:, 0:3], rows[:, 3:6], uvs, triangles,
                  rows[:, -3:] if has_color else None)
        files[int(slot)] = path
    return MeshParts(files, is_closed(mesh))
