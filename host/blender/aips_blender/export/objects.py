"""Tells what of Blender's objects, beside their shapes and materials, is not carried over."""
from . import versions

GEOMETRY = {'MESH', 'CURVE', 'CURVES', 'SURFACE', 'FONT', 'META', 'VOLUME'}
# Modifiers that mostly change a mesh from frame to frame.
DEFORMS = {'ARMATURE', 'CLOTH', 'HOOK', 'MESH_CACHE', 'MESH_SEQUENCE_CACHE', 'OCEAN', 'SOFT_BODY',
           'WAVE'}
KINDS_OF_RAYS = ('camera', 'diffuse', 'glossy', 'transmission', 'volume_scatter', 'shadow')
NOTHING = {'EMPTY', 'CAMERA', 'ARMATURE', 'LATTICE', 'LIGHT_PROBE', 'SPEAKER', 'LIGHT'}


class Objects:
    def __init__(self, view_layer, left_out):
        self._view_layer = view_layer
        self._left_out = left_out

    def tell(self, instance, blurs):
        """`blurs`: whether the shutter is open for a time."""
        thing = instance.object
        if blurs and any(m.type in DEFORMS for m in thing.modifiers):
            self._left_out.add("deformation within the shutter's time is left out", thing.name)
        if thing.type in GEOMETRY:
            self._tell_geometry(thing, instance.parent if instance.is_instance else thing)
        elif thing.type == 'LIGHT':
            self._tell_light(thing)
        elif thing.type not in NOTHING:
            self._left_out.add(f'objects of type {thing.type.lower()} are left out', thing.name)

    def _tell_geometry(self, thing, parent):
        """Of collections and of what places an object too."""
        chain = [each.original for each in (thing, parent) if each]
        if not all(getattr(thing, f'visible_{kind}') for kind in KINDS_OF_RAYS) or \
                any(each.indirect_only_get(view_layer=self._view_layer) for each in chain):
            self._left_out.add('what is hidden from some rays is seen by all', thing.name)
        if thing.is_shadow_catcher or \
                any(each.holdout_get(view_layer=self._view_layer) for each in chain):
            self._left_out.add('holdouts and shadow catchers are shown as objects', thing.name)

    def _tell_light(self, thing):
        """All but what is hidden from the camera, which is carried over."""
        if not all(getattr(thing, f'visible_{kind}') for kind in KINDS_OF_RAYS[1:]):
            self._left_out.add('lights hidden from some rays shine on all', thing.name)
        if not versions.casts_shadow(thing.data):
            self._left_out.add('lights without shadows cast them', thing.name)
