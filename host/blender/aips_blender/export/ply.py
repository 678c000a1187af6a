"""Writes triangle meshes as binary PLY files with normals and texture coordinates."""
import numpy as np


def write(path, positions, normals, uvs, triangles, colors=None):
    """Arrays of one row a vertex (uvs and colors may be None), and vertices of each triangle."""
    columns = [('x y z', positions), ('nx ny nz', normals)]
    if uvs is not None:
        columns.append(('s t', uvs))
    if colors is not None:
        columns.append(('red green blue', colors))
    names = [name for group, _ in columns for name in group.split()]
    header = ['ply', 'format binary_little_endian 1.0', f'element vertex {len(positions)}']
    header += [f'property float {name}' for name in names]
    header += [f'element face {len(triangles)}', 'property list uchar int vertex_indices',
               'end_header', '']
    faces = np.empty(len(triangles), np.dtype([('count', 'u1'), ('corners', '<i4', 3)]))
    faces['count'], faces['corners'] = 3, triangles
    with open(path, 'wb') as file:
        file.write('\n'.join(header).encode())
        file.write(np.hstack([values for _, values in columns]).astype('<f4').tobytes())
        file.write(faces.tobytes())


def welded(corners):
    """Rows of `corners` (three a triangle) that are alike made one: unique rows, triangles."""
    rows = np.ascontiguousarray(corners, np.float32)
    keys = rows.view(np.dtype((np.void, rows.dtype.itemsize * rows.shape[1]))).ravel()
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    return rows[first], inverse.reshape(-1, 3)
