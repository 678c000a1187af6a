"""Finds settings where Blender's versions, from 3.4 to 5.x, keep them."""
import bpy

from .blackbody import blackbody

BLENDER_3 = bpy.app.version < (4, 0)


def setting(default, *places):
    """The first setting that exists, of pairs of an owner, which may be None, and a path in it."""
    for owner, path in places:
        for name in path.split('.'):
            owner = getattr(owner, name, None)
        if owner is not None:
            return owner
    return default


def motion_blur_position(scene):
    return setting('CENTER', (scene.render, 'motion_blur_position'),  # 4.2
                   (scene, 'cycles.motion_blur_position'))


def panorama_type(camera):
    return setting('', (camera, 'panorama_type'),  # 4.x
                   (camera, 'cycles.panorama_type'))


def casts_shadow(light):
    """As Cycles has it: `use_shadow` was that of Eevee alone before it had Cycles' place too."""
    return setting(True, (light, 'cycles.cast_shadow'), (light, 'use_shadow'))


def film_exposure(scene):
    """What Cycles multiplies the whole image by."""
    return float(setting(1.0, (scene, 'cycles.film_exposure')))


def light_scale(light):
    """What 4.5 multiplies a light's colour by, beside its power: exposure and temperature."""
    scale = 2.0 ** setting(0.0, (light, 'exposure'))
    tinted = setting(False, (light, 'use_temperature'))
    return tuple(scale * c for c in (blackbody(light.temperature) if tinted else (1.0, 1.0, 1.0)))


def uses_nodes(owner):
    """Whether a material, world or light has nodes; from 5.0 all of them have."""
    return bool(setting(True, (owner, 'use_nodes'))) and owner.node_tree is not None


def set_pixels(render_pass, values):
    """Of a pass of a render's result: an array of one row a pixel."""
    try:
        render_pass.rect.foreach_set(values.ravel())
    except TypeError:
        render_pass.rect.foreach_set(values)  # Blender 3 counts pixels, not their channels
