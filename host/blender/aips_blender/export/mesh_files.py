"""Keeps the meshes of an export: each with its materials is written once."""
import dataclasses
import os

import bpy

from . import kept, meshes, strands, volume_objects
from .domains import settings_of
from .images import safe_name
from .media import CLEAR
from .object_info import values_of
from .shapes import Mesh


MOST_VARIANTS = 64  # of a mesh, whose triangles each has for itself


def box_of(mesh):
    """Least corner and size of the box that generated coordinates span."""
    place, half = mesh.texspace_location, mesh.texspace_size
    return tuple(p - h for p, h in zip(place, half)), tuple(2 * h or 1.0 for h in half)


def _needs(shader):
    """What of a shader decides which files a mesh has."""
    return shader.layers, shader.emission is not None, shader.opaque, shader.medium != CLEAR


class MeshFiles:
    """`kept`: a Kept that goes from one export to the next, or None; `work(what, *arguments)` does
    what is slow; `noted`: whether `kept` is told of what changes."""

    def __init__(self, folder, materials, left_out, work, kept=None, noted=False):
        self._folder = folder
        self._work = work
        self._noted = noted
        self._kept = kept
        self._materials = materials
        self._left_out = left_out
        self.known = {}  # Mesh by key; None where there is no triangle
        self._variants = {}  # of a key the keys of its mesh for all objects, by their values

    def of(self, thing, info):
        """Key of an object's mesh with its materials, written where it is new; or None. `info` is
        the object's ObjectInfo."""
        return self._of_kind(thing, info, self._written)

    def volume(self, thing, info):
        """Likewise of an object of type volume."""
        return self._of_kind(thing, info, self._box)

    def _of_kind(self, thing, info, write):
        slots = tuple(s.material.name_full if s.material else '' for s in thing.material_slots)
        key = (thing.data.as_pointer(), slots)
        if key not in self.known:
            self.known[key] = write(thing, info)
            if self.known[key]:
                self._variants[key] = {self._values(key, info): key}
        if not self.known[key]:
            return None
        variants, own = self._variants[key], self._values(key, info)
        if own not in variants and len(variants) == MOST_VARIANTS:
            self._left_out.add(f'of instances of a mesh that differ {MOST_VARIANTS} have values of '
                               'their own', thing.name)
            own = list(variants)[hash(own) % MOST_VARIANTS]
        if own not in variants:
            variants[own] = (*key, own)
            self.known[variants[own]] = self._variant(thing, info, self.known[key])
        return variants[own]

    def _values(self, key, info):
        """What tells one object with a mesh and materials from another one."""
        names = frozenset().union(*(s.of_object for s in self.known[key].shaders.values()))
        return values_of(info, names)

    def _variant(self, thing, info, mesh):
        """The same mesh with materials for another object."""
        made = {slot: self._shader(thing, slot, info) for slot in mesh.parts.files}
        if any(_needs(made[slot]) != _needs(s) for slot, s in mesh.shaders.items()):
            return self._written(thing, info)
        return dataclasses.replace(mesh, shaders=made)

    def _shader(self, thing, slot, info):
        materials = [s.material for s in thing.material_slots] or [None]
        fills = isinstance(thing.data, bpy.types.Volume)
        box = box_of(thing.data) if hasattr(thing.data, 'texspace_size') else \
            volume_objects.box_of(thing) if fills else None
        return self._materials.shader(materials[min(slot, len(materials) - 1)], box, info, fills)

    def _box(self, thing, info):
        """The Mesh around a volume, or None where there is nothing in it."""
        shader = self._shader(thing, 0, info)
        if shader.medium == CLEAR:
            return None
        path = os.path.join(self._folder, f'{len(self.known)}-{safe_name(thing.name)}.ply')
        return Mesh(thing.name, volume_objects.write_box(thing, path, self._work), {0: shader})

    def hair(self, thing, info, system, number, for_render):
        """Key of one of an object's systems of hair; or None."""
        settings = system.settings
        return self._tubes(thing, info, ('hair', thing.original.as_pointer(), number),
                           settings.material - 1,
                           lambda: strands.of_particles(thing, system, for_render))

    def curves(self, thing, info):
        """Key of an object of hair curves; or None."""
        return self._tubes(thing, info, ('curves', thing.data.as_pointer()), 0,
                           lambda: strands.of_curves(thing.data))

    def _tubes(self, thing, info, key, slot, read):
        """`read()` gives Strands, or None."""
        if key not in self.known:
            found = read()
            made = strands.tubes(found) if found else None
            self.known[key] = made and self._of_tubes(thing, info, slot, *made)
        return key if self.known[key] else None

    def _of_tubes(self, thing, info, slot, rows, faces):
        slot = max(min(slot, len(thing.material_slots) - 1), 0)
        shader = self._shader(thing, slot, info)
        parts = meshes.write_tubes(rows, faces, self._folder,
                                   f'{len(self.known)}-{safe_name(thing.name)}', slot, shader,
                                   self._work)
        return Mesh(thing.name, parts, {slot: dataclasses.replace(shader, medium=CLEAR)})

    def _written(self, thing, info):
        def shader(slot):
            return self._shader(thing, slot, info)

        def tell(what):
            self._left_out.add(what, thing.name)

        parts = self._unchanged(info.names, shader, tell)
        if parts is None:
            mesh = thing.to_mesh()
            try:
                parts = mesh and self._parts(mesh, thing, info.names, shader, tell)
            finally:
                thing.to_mesh_clear()
        if parts is None:
            return None
        shaders = {slot: shader(slot) for slot in parts.files}
        if parts.triangles is not None and not self._may_be_filled(thing, parts, info.grids):
            parts.triangles = None
            shaders = {slot: dataclasses.replace(s, medium=CLEAR) for slot, s in shaders.items()}
        return Mesh(thing.name, parts, shaders)

    def _unchanged(self, names, shader, tell):
        """MeshParts of what has not changed since the last export, or None."""
        found = names and self._kept and self._noted and self._kept.unchanged(names)
        known = self._kept.of(self._key_of(*found, shader)) if found else None
        return self._told(known, tell) if known else None

    @staticmethod
    def _told(known, tell):
        parts, told = known
        for what in told:
            tell(what)
        return dataclasses.replace(parts)

    @staticmethod
    def _key_of(content, slots, shader):
        return content, tuple((slot, *_needs(shader(slot))) for slot in slots)

    def _parts(self, mesh, thing, names, shader, tell):
        """MeshParts, those of the export before where they are the same."""
        content = self._kept and mesh.polygons and (
            self._kept.new() if self._noted and names else kept.content(mesh))
        stem = f'{len(self.known)}-{safe_name(thing.name)}'
        if not content:
            return meshes.write_parts(mesh, self._folder, stem, shader, tell, self._work)
        slots = kept.used_slots(mesh)
        key = self._key_of(content, slots, shader)
        known = self._kept.of(key)
        if known is None:
            told = []

            def work(what, *arguments):
                self._work(self._or_drop, key, what, *arguments)

            known = (meshes.write_parts(mesh, self._kept.folder, f'{content}-{stem}', shader,
                                        told.append, work), told)
            if known[0] is None:
                return None
            self._kept.keep(key, *known)
        self._kept.note(names, (content, slots))
        return self._told(known, tell)

    def _or_drop(self, key, what, *arguments):
        try:
            what(*arguments)
        except BaseException:
            self._kept.drop(key)
            raise

    def _may_be_filled(self, thing, parts, grids):
        """Whether the volume of a mesh's material can be carried over."""
        if not parts.closed:
            self._left_out.add('volumes of meshes that are not closed are left out', thing.name)
            return False
        if grids is None and settings_of(thing):
            self._left_out.add('smoke that is not in files of its cache is left out', thing.name)
            return False
        return True
