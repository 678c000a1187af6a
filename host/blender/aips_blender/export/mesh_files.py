"""Keeps the meshes of an export: each with its materials is written once."""
import dataclasses

from . import kept, meshes, strands
from .images import safe_name
from .media import CLEAR
from .shapes import Mesh


def box_of(mesh):
    """Least corner and size of the box that generated coordinates span."""
    place, half = mesh.texspace_location, mesh.texspace_size
    return tuple(p - h for p, h in zip(place, half)), tuple(2 * h or 1.0 for h in half)


class MeshFiles:
    """`kept`: a Kept that goes from one export to the next, or None."""

    def __init__(self, folder, materials, left_out, kept=None):
        self._folder = folder
        self._kept = kept
        self._materials = materials
        self._left_out = left_out
        self.known = {}  # Mesh by key; None where there is no triangle

    def of(self, thing):
        """Key of an object's mesh with its materials, written where it is new; or None."""
        slots = tuple(s.material.name_full if s.material else '' for s in thing.material_slots)
        key = (thing.data.as_pointer(), slots)
        if key not in self.known:
            self.known[key] = self._written(thing)
        return key if self.known[key] else None

    def hair(self, thing, system, number, for_render):
        """Key of one of an object's systems of hair; or None."""
        settings = system.settings
        return self._tubes(thing, ('hair', thing.original.as_pointer(), number),
                           settings.material - 1,
                           lambda: strands.of_particles(thing, system, for_render))

    def curves(self, thing):
        """Key of an object of hair curves; or None."""
        return self._tubes(thing, ('curves', thing.data.as_pointer()), 0,
                           lambda: strands.of_curves(thing.data))

    def _tubes(self, thing, key, slot, read):
        """`read()` gives Strands, or None."""
        if key not in self.known:
            found = read()
            made = strands.tubes(found) if found else None
            self.known[key] = made and self._of_tubes(thing, slot, *made)
        return key if self.known[key] else None

    def _of_tubes(self, thing, slot, rows, faces):
        materials = [s.material for s in thing.material_slots] or [None]
        slot = min(max(slot, 0), len(materials) - 1)
        shader = self._materials.shader(materials[slot])
        parts = meshes.write_tubes(rows, faces, self._folder,
                                   f'{len(self.known)}-{safe_name(thing.name)}', slot, shader)
        return Mesh(thing.name, parts, {slot: dataclasses.replace(shader, medium=CLEAR)})

    def _written(self, thing):
        materials = [s.material for s in thing.material_slots] or [None]

        box = box_of(thing.data)

        def shader(slot):
            return self._materials.shader(materials[min(slot, len(materials) - 1)], box)

        def tell(what):
            self._left_out.add(what, thing.name)

        mesh = thing.to_mesh()
        try:
            parts = mesh and self._parts(mesh, safe_name(thing.name), shader, tell)
        finally:
            thing.to_mesh_clear()
        if parts is None:
            return None
        shaders = {slot: shader(slot) for slot in parts.files}
        if parts.triangles is not None and not self._may_be_filled(thing, parts):
            parts.triangles = None
            shaders = {slot: dataclasses.replace(s, medium=CLEAR) for slot, s in shaders.items()}
        return Mesh(thing.name, parts, shaders)

    def _parts(self, mesh, name, shader, tell):
        """MeshParts, those of the export before where they are the same."""
        content = self._kept and mesh.polygons and kept.content(mesh)
        if not content:
            return meshes.write_parts(mesh, self._folder, f'{len(self.known)}-{name}', shader, tell)
        made = [(slot, shader(slot)) for slot in kept.used_slots(mesh)]
        key = (content, tuple((slot, s.layers, s.emission is not None, s.opaque, s.medium != CLEAR)
                              for slot, s in made))
        known = self._kept.of(key)
        if known is None:
            told = []
            stem = f'{content}-{len(self.known)}-{name}'
            known = (meshes.write_parts(mesh, self._kept.folder, stem, shader, told.append), told)
            if known[0] is None:
                return None
            self._kept.keep(key, *known)
        for what in known[1]:
            tell(what)
        return dataclasses.replace(known[0])

    def _may_be_filled(self, thing, parts):
        """Whether the volume of a mesh's material can be carried over."""
        if not parts.closed:
            self._left_out.add('volumes of meshes that are not closed are left out', thing.name)
            return False
        if any(m.type == 'FLUID' and m.fluid_type == 'DOMAIN' for m in thing.modifiers):
            self._left_out.add('smoke and fire are left out', thing.name)
            return False
        return True
