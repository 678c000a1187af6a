"""What the user sets in Blender's panels, and what follows of it for export and command line."""
import bpy
import numpy as np
from bpy.props import (BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty,
                       StringProperty)

from . import passes
from .export.film import CYCLES_FILTER, Film
from .export.lxs_text import parameter
from .export.versions import setting

LAYERS = [(key, each.name, f'The pass {each.name}') for key, each in passes.BY_SETTING.items()]


def _passes_change(_settings, context):
    context.view_layer.update_render_passes()


class AipsSceneSettings(bpy.types.PropertyGroup):
    until: EnumProperty(
        name='Render until', default='ERROR',
        items=[('ERROR', 'Target error', 'The estimated error of the image is reached'),
               ('TIME', 'Time', 'The time has gone by'),
               ('PASSES', 'Passes', 'So many passes are rendered')])
    target_error: FloatProperty(
        name='Error', default=0.05, min=0.001, max=1, subtype='FACTOR', precision=3,
        description='Estimated error at which the render ends: 0.05 is a twentieth of a brightness')
    seconds: IntProperty(name='Seconds', default=60, min=1, subtype='TIME_ABSOLUTE',
                         description='Seconds after which the render ends')
    passes: IntProperty(name='Passes', default=64, min=1, description='Passes to render')
    longest: IntProperty(name='At most', default=600, min=1,
                         description='Seconds after which a render by error ends in any case')
    integrator: EnumProperty(
        name='Integrator', default='aips',
        items=[('aips', 'aips', 'Guided photons, for caustics and light by many bounces'),
               ('path', 'path', 'Path tracing, for scenes without caustics'),
               ('sppm', 'sppm', "LuxRender's photon mapping")])
    layers: EnumProperty(name='Passes', items=LAYERS, options={'ENUM_FLAG'}, default=set(),
                         update=_passes_change)
    denoise: BoolProperty(name='Denoise',
                          description='Take noise out of the image; the pass Noisy Image keeps it',
                          update=_passes_change)
    explain: BoolProperty(name='Explain', description='Say at the end what became of the light')
    seed: IntProperty(name='Seed', min=0, description='Seed of all random numbers')
    eye_depth: IntProperty(name='Eye depth', default=16, min=1, max=1024,
                           description='Most surfaces that an eye path meets')
    photon_depth: IntProperty(name='Photon depth', default=16, min=1, max=1024,
                              description='Most surfaces that a photon path meets')
    photons: IntProperty(name='Photons per pass', min=0, description='0: as many as noise asks for')
    guide: EnumProperty(
        name='Guide', default='adaptive',
        items=[('adaptive', 'Adaptive', 'Photons follow what the camera needs'),
               ('paper', 'Paper', 'The guide of the published method'),
               ('none', 'None', 'Photons are not guided')])
    update_interval: IntProperty(name='Update every', default=2, min=1, max=3600,
                                 description='Seconds between two images so far; more where '
                                             'writing one takes long')
    extra: StringProperty(name='More options',
                          description='Options of lxsrender, as on the command line')


def _depth(name, depth):
    """Unless a depth is given, specular surfaces do not count."""
    return () if depth == 16 else (parameter('integer', name, depth),)


def integrator_options(settings):
    """Parameters of the integrator as text; those that have their defaults are left out."""
    if settings.integrator == 'path':
        return _depth('maxdepth', settings.eye_depth)
    options = [*_depth('maxeyedepth', settings.eye_depth),
               *_depth('maxphotondepth', settings.photon_depth)]
    if settings.photons:
        options.append(parameter('integer', 'photonperpass', settings.photons))
    if settings.integrator == 'aips' and settings.guide != 'adaptive':
        options.append(parameter('string', 'guide', settings.guide))
    return tuple(options)


def size(render):
    """Pixels of the whole image, by Blender's own arithmetic: a row more or less is not taken."""
    share = render.resolution_percentage
    return tuple(max(side * share // 100, 1) for side in (render.resolution_x,
                                                          render.resolution_y))


def border(render):
    """First and last pixel beyond, x0 x1 y0 y1, of what Blender renders; y from below.

    Blender multiplies in 32 bits, which makes 70 of 0.7 x 100 where 64 bits make 69.
    """
    width, height = size(render)
    if not render.use_border:
        return 0, width, 0, height
    return tuple(int(np.float32(share) * np.float32(of)) for share, of in (
        (render.border_min_x, width), (render.border_max_x, width),
        (render.border_min_y, height), (render.border_max_y, height)))


def crop(render):
    """The border as shares of the image, x0 x1 y0 y1 from the upper left.

    lxsrender rounds up to whole pixels; a quarter less makes that certain.
    """
    width, height = size(render)
    x0, x1, y0, y1 = border(render)
    pixels = ((x0, width), (x1, width), (height - y1, height), (height - y0, height))
    return tuple(max(at - 0.25, 0) / of if at < of else 1.0 for at, of in pixels)


def passes_of(scene, view_layer):
    """Passes beside Combined that lxsrender is asked for or writes anyway."""
    wanted = [layer for layer, asked in (('objects', view_layer.use_pass_cryptomatte_object),
                                         ('materials', view_layer.use_pass_cryptomatte_material))
              if asked]
    return passes.chosen(scene.aips.layers, light_groups(view_layer)) + \
        passes.masks(wanted, view_layer.pass_cryptomatte_depth)


def film_of(scene, view_layer):
    settings = scene.aips
    width, height = size(scene.render)
    by = settings.until
    return Film(width, height, crop(scene.render),
                passes.layers(passes_of(scene, view_layer)),
                settings.passes if by == 'PASSES' else 0,
                {'TIME': settings.seconds, 'ERROR': settings.longest}.get(by, 0),
                settings.target_error if by == 'ERROR' else 0.0,
                settings.integrator, integrator_options(settings), setting(
                    CYCLES_FILTER, (scene, 'cycles.filter_width')),
                transparent=scene.render.film_transparent)


def light_groups(view_layer):
    return [group.name for group in view_layer.lightgroups]


def register():
    bpy.utils.register_class(AipsSceneSettings)
    bpy.types.Scene.aips = PointerProperty(type=AipsSceneSettings)


def unregister():
    del bpy.types.Scene.aips
    bpy.utils.unregister_class(AipsSceneSettings)
