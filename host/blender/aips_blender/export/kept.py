"""Keeps what exports have written of meshes, so that the next one writes what has changed alone.

Meshes are told apart by their content: nothing is to be said when one changes.
"""
import atexit
import hashlib
import shutil
import tempfile
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from .corners import array, uv_of


class Kept:
    """Files of meshes by content; those that an export has not used go as it ends.

    One `worker` writes them all: what is written last is written when all is.
    """

    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix='aips-meshes-')
        self.worker = ThreadPoolExecutor(1)
        self._parts, self._used = {}, {}
        self._count = 0
        self._unchanged = {}  # content and slots by names of an object and its data
        atexit.register(self.end)

    def begin(self):
        """An export begins, of one that was broken off too."""
        self._used = {}

    def done(self):
        """An export has ended: what it has not used goes."""
        for key in set(self._parts) - set(self._used):
            self._parts.pop(key)[0].remove()

    def of(self, key):
        """What was kept, or None."""
        if key in self._parts:
            self._used[key] = True
        return self._parts.get(key)

    def keep(self, key, parts, told):
        self._parts[key], self._used[key] = (parts, told), True

    def drop(self, key):
        """Its files could not be written."""
        self._parts.pop(key, None)

    def unchanged(self, names):
        """Content and used slots of a mesh that `changed` was not told of since, or None."""
        return self._unchanged.get(names)

    def new(self):
        """A content of its own, for what is known to have changed."""
        self._count += 1
        return f'new-{self._count}'

    def note(self, names, content_and_slots):
        if names:
            self._unchanged[names] = content_and_slots

    def changed(self, name):
        """What is of this name, an object or its data, has another shape."""
        for names in [names for names in self._unchanged if name in names]:
            del self._unchanged[names]

    def end(self):
        self.worker.shutdown(wait=False)
        shutil.rmtree(self.folder, ignore_errors=True)
        atexit.unregister(self.end)


def used_slots(mesh):
    """Numbers of the material slots that a mesh has faces of."""
    return list(map(int, np.unique(array(mesh.polygons, 'material_index', np.int32, 1))))


def content(mesh):
    """Text that tells meshes apart, or None where that would take long."""
    if hasattr(mesh, 'calc_normals_split') and mesh.has_custom_normals:
        return None
    digest = hashlib.blake2b(digest_size=12)
    for values in _arrays(mesh):
        digest.update(repr(values).encode() if isinstance(values, tuple) else
                      np.ascontiguousarray(values))
    return digest.hexdigest()


def _arrays(mesh):
    yield array(mesh.vertices, 'co', np.float32, 3)
    yield array(mesh.loops, 'vertex_index', np.int32, 1)
    yield array(mesh.polygons, 'loop_start', np.int32, 1)
    yield array(mesh.polygons, 'material_index', np.int32, 1)
    if hasattr(mesh, 'corner_normals'):
        yield array(mesh.corner_normals, 'vector', np.float32, 3)
    else:
        yield array(mesh.polygons, 'use_smooth', bool, 1)
        yield (mesh.use_auto_smooth, mesh.auto_smooth_angle)
        if mesh.use_auto_smooth:
            yield array(mesh.edges, 'use_edge_sharp', bool, 1)
            yield array(mesh.edges, 'vertices', np.int32, 2)
    for layer in mesh.uv_layers:
        yield (layer.name, layer.active_render)
        yield uv_of(layer)
    for layer in mesh.color_attributes:
        yield (layer.name, layer.domain, layer.data_type)
        yield array(layer.data, 'color', np.float32, 4)
    yield (mesh.color_attributes.render_color_index, tuple(mesh.attributes.keys()))
