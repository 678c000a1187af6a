"""Writes one LuxRender material for each of Blender's simple shader nodes.

Cycles' GGX width is roughness squared, and the scene language's `uroughness` has the same meaning.
"""
import dataclasses
import math

from . import graph
from .colours import surface_color
from .layers import Layers
from .lxs_text import color as color_as_written, factor, parameter
from .media import CLEAR, Medium

SMOOTH = 1e-4      # GGX width below which a surface is taken for smooth
FACETS = parameter('string', 'distribution', 'ggx')  # Cycles' too
# Both sides are coated, and white loses nothing between the facets and under the coating.
CONSERVING = parameter('bool', 'conserving', True)
BLACK, WHITE = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
REFLECTANCE_OF_HAIR = 0.046  # of an index of 1.55 at normal incidence
WIDTH_OF_HAIR = 0.3          # of its highlight along the fibre, about
RADIAL_ROUGHNESS = 0.3       # unless it is set
# Absorption of the pigments, and what of it darkens hair in the mass by its roughness (Chiang and
# others 2016), as Cycles has them.
EUMELANIN, PHEOMELANIN = (0.506, 0.841, 1.653), (0.343, 0.733, 1.924)
ALBEDO_BY_ROUGHNESS = (5.969, -0.215, 2.532, -10.73, 5.574, 0.245)


def color(name, value):
    """The parameter of a colour that a surface is to have."""
    return color_as_written(name, surface_color(value))


@dataclasses.dataclass
class Shader:
    """A named material of the scene language, with what else Blender's material says."""
    name: str
    emission: object = None   # radiance, if there is any
    medium: Medium = CLEAR    # fills meshes that have it all over
    opaque: bool = True       # no light comes through
    layers: Layers = Layers()
    of_object: frozenset = frozenset()  # names of values of ObjectInfo that it depends on
    hidden: bool = False      # the camera does not see it shine


class Shaders:
    def __init__(self, text, textures, left_out):
        self.text = text
        self.textures = textures
        self.left_out = left_out

    def named(self, wanted, kind, parameters=()):
        name = self.text.free_name(wanted, 'material')
        self.text.statement('MakeNamedMaterial', name,
                            parameters=[parameter('string', 'type', kind), *parameters])
        return name

    def width(self, found):
        """GGX width of a node's roughness: a number or a texture's name."""
        rough = self.textures.number(found.input('Roughness'))
        if isinstance(rough, str):
            name = self.text.free_name(f'{rough} squared')
            self.text.statement('Texture', name, 'float', 'scale',
                                parameters=[factor('tex1', rough), factor('tex2', rough)])
            return name
        return rough * rough

    def bump(self, found):
        """The parameter bumpmap of what feeds a node's normal, or nothing."""
        place = found.input('Normal')
        before = graph.source(place) if place else None
        if before is None:
            return []
        if before.node.type == 'NORMAL_MAP':
            return self._normal_map(before)
        if before.node.type == 'BUMP':
            return self._bump_map(before)
        self.left_out.add(f'normals by node {before.node.bl_label} are left out')
        return []

    def _bump_map(self, before):
        height = self.textures.number(before.input('Height'))
        if not isinstance(height, str):
            return self.bump(before)  # the normals that it hands on
        if graph.source(before.input('Normal')):
            self.left_out.add('normals that a node Bump is given are left out')
        scale = self.textures.constant_number(before.input('Strength'), 'strengths of bumps') * \
            self.textures.constant_number(before.input('Distance'), 'distances of bumps')
        name = self.text.free_name('bump')
        self.text.statement('Texture', name, 'float', 'scale', parameters=[
            factor('tex1', height), factor('tex2', -scale if before.node.invert else scale)])
        return [factor('bumpmap', name)]

    def _normal_map(self, before):
        found = graph.source(before.input('Color'))
        file = None
        if found and found.node.type == 'TEX_IMAGE' and found.node.image:
            file = self.textures.image_file(found.node)
        if before.node.space != 'TANGENT' or file is None:
            self.left_out.add('normal maps not of an image in tangent space are left out')
            return []
        if self.textures.number(before.input('Strength')) != 1.0:
            self.left_out.add('strengths of normal maps are taken for 1')
        # Its tangents lie along the file's first.
        if self.textures.coordinates.place_of(before.node.uv_map) or \
                not self.textures.is_placed_by_uv(found):
            self.left_out.add('normal maps by another uv map than the first are by that one')
        name = self.text.free_name('normal map')
        self.text.statement('Texture', name, 'float', 'normalmap', parameters=[
            self.text.file(file.path), file.color_space(), *self.textures.mapping(found)])
        return [factor('bumpmap', name)]

    def diffuse(self, found, name):
        rough = self.textures.constant_number(found.input('Roughness'), 'roughness of diffuse')
        if rough:
            self.left_out.add("roughness of diffuse is approximated by LuxRender's sigma", name)
        # Both are Oren and Nayar's, whose deviation LuxRender has in degrees.
        sigma = math.degrees(rough)
        return Shader(self.named(name, 'matte', [
            color('Kd', self.textures.color(found.input('Color'))), factor('sigma', sigma),
            *self.bump(found)]))

    def glossy(self, found, name):
        tint = self.textures.color(found.input('Color'))
        width = 0.0 if found.node.distribution == 'SHARP' else self.width(found)
        return Shader(self.metal_of(found, name, tint, self.stretched(found, width, 'Rotation'),
                                    self.bump(found)))

    def metal_of(self, found, name, tint, width, bump):
        """By facets alone, or without what these lose, as a node has it."""
        smooth = isinstance(width, float) and width < SMOOTH
        if smooth or isinstance(width, tuple) or found.node.distribution != 'MULTI_GGX':
            return self.metal(name, tint, width, bump)
        return self.named(name, 'glossy', [color('Kd', BLACK), color('Ks', tint), CONSERVING,
                                           *self.roughness(width), *bump])

    def stretched(self, found, width, rotation):
        """A node's width, or where it has an anisotropy widths along its tangent and across."""
        place = found.input('Anisotropy', 'Anisotropic')
        by = self.textures.constant_number(place, 'anisotropy') if place else 0.0
        if by == 0.0:
            return width
        if isinstance(width, str) or width < SMOOTH:
            self.left_out.add('anisotropy of smooth surfaces and of textures is left out')
            return width
        turn = found.input(rotation)
        if turn and self.textures.number(turn) != 0.0:
            self.left_out.add('rotations of anisotropy are left out')
        tangent = graph.source(found.input('Tangent'))
        if not (tangent and tangent.node.type == 'TANGENT' and
                tangent.node.direction_type == 'UV_MAP'):
            self.left_out.add('anisotropy goes along u')
        if place.socket.name == 'Anisotropic':  # of Principled
            aspect = (1 - 0.9 * min(max(by, 0.0), 1.0)) ** 0.5
            return width / aspect, width * aspect
        by = min(max(by, -0.99), 0.99)
        return (width / (1 + by), width * (1 + by)) if by < 0 else (width * (1 - by),
                                                                    width / (1 - by))

    def coat(self, found, name, base, reflectance):
        """A glossy node over a material, by a dielectric's share of this at normal incidence."""
        tint = self.textures.product(self.textures.color(found.input('Color')), reflectance)
        return self.named(name, 'glossycoating', [
            parameter('string', 'basematerial', base), color('Ks', tint),
            *self.roughness(self.width(found)), *self.bump(found)])

    def is_smooth(self, found):
        width = 0.0 if found.node.distribution == 'SHARP' else self.width(found)
        return not isinstance(width, str) and width < SMOOTH

    def glass_of(self, gloss, refraction, name):
        """The two nodes of which glass is put together."""
        width = 0.0 if refraction.node.distribution == 'SHARP' else self.width(refraction)
        return Shader(self.dielectric(
            name, self.textures.color(gloss.input('Color')),
            self.textures.color(refraction.input('Color')), self._index(refraction), width,
            self.bump(refraction)), opaque=False)

    def pane(self, gloss, transparent, index, name):
        """Gloss over what lets light straight through."""
        return Shader(self.named(name, 'glass', [
            color('Kr', self.textures.color(gloss.input('Color'))),
            color('Kt', self.textures.color(transparent.input('Color'))), factor('index', index),
            parameter('bool', 'architectural', True)]), opaque=False)

    def metal(self, name, tint, width, bump):
        """A mirror where it is smooth, else facets that reflect tint at normal incidence."""
        if isinstance(width, float) and width < SMOOTH:
            return self.named(name, 'mirror', [color('Kr', tint), *bump])
        fresnel = self.text.free_name(f'{name}: fresnel')
        self.text.statement('Texture', fresnel, 'fresnel', 'fresnelcolor',
                            parameters=[color('Kr', tint)])
        return self.named(name, 'metal2', [parameter('texture', 'fresnel', fresnel), FACETS,
                                           *self.roughness(width), *bump])

    @staticmethod
    def roughness(width):
        along, across = width if isinstance(width, tuple) else (width, width)
        return [factor('uroughness', along), factor('vroughness', across)]

    def glass(self, found, name):
        tint = self.textures.color(found.input('Color'))
        reflected = BLACK if found.node.type == 'BSDF_REFRACTION' else tint
        width = 0.0 if found.node.distribution == 'SHARP' else self.width(found)
        return Shader(self.dielectric(name, reflected, tint, self._index(found), width,
                                      self.bump(found)), opaque=False)

    def _index(self, found):
        return self.textures.constant_number(found.input('IOR'), 'index of refraction')

    def dielectric(self, name, reflected, refracted, index, width, bump):
        parts = [color('Kr', reflected), color('Kt', refracted), factor('index', index), *bump]
        if not isinstance(width, str) and width < SMOOTH:
            return self.named(name, 'glass', parts)
        return self.named(name, 'roughglass', [*parts, FACETS, *self.roughness(width)])

    def transparent(self, found, name):
        tint = self.textures.color(found.input('Color'))
        if tint == WHITE:
            return Shader(self.null(name), opaque=False)
        # Of index 1 nothing is reflected, and light goes straight on.
        return Shader(self.named(name, 'glass', [
            color('Kr', BLACK), color('Kt', tint), factor('index', 1.0),
            parameter('bool', 'architectural', True)]), opaque=False)

    def null(self, name):
        return self.named(name, 'null')

    def translucent(self, found, name):
        return Shader(self.named(name, 'mattetranslucent', [
            color('Kr', BLACK), color('Kt', self.textures.color(found.input('Color'))),
            *self.bump(found)]), opaque=False)

    def velvet(self, found, name):
        self.left_out.add("velvet is approximated by LuxRender's", name)
        return Shader(self.named(name, 'velvet',
                                 [color('Kd', self.textures.color(found.input('Color')))]))

    def metallic(self, found, name):
        """Node Metallic BSDF of Blender 4.3, by its colour at normal incidence."""
        if found.node.fresnel_type == 'F82':
            tint, neutral = self.textures.color(found.input('Base Color')), WHITE
        else:
            index, extinction = (graph.constant(found.input(what)) for what in
                                 ('IOR', 'Extinction'))
            tint, neutral = tuple(((n - 1) ** 2 + k * k) / ((n + 1) ** 2 + k * k)
                                  for n, k in zip(index, extinction)), None
        edge = found.input('Edge Tint')
        if edge and self.textures.color(edge) != neutral:
            self.left_out.add('tinted edges of metals are left out', name)
        width = self.stretched(found, self.width(found), 'Rotation')
        return Shader(self.metal_of(found, name, tint, width, self.bump(found)))

    def scattering(self, found, name):
        self.left_out.add('scattering below the surface is replaced by diffuse', name)
        return Shader(self.named(name, 'matte',
                                 [color('Kd', self.textures.color(found.input('Color')))]))

    def hair(self, found, name):
        """Glossy fibres that let half of their light through, of the hair's colour in the mass."""
        self.left_out.add('Principled Hair is approximated by glossy fibres that let half of their '
                          'light through', name)
        tint = self.textures.product(self._hair_color(found), 0.5)
        return Shader(self.named(name, 'glossytranslucent', [
            color('Kd', tint), color('Kt', tint), color('Ks', (REFLECTANCE_OF_HAIR,) * 3),
            *self.roughness(WIDTH_OF_HAIR)]), opaque=False)

    def _hair_color(self, found):
        if found.node.parametrization == 'COLOR':
            return self.textures.color(found.input('Color'))
        if found.node.parametrization == 'ABSORPTION':
            absorbed = graph.constant(found.input('Absorption Coefficient'))
        else:
            melanin, red = (self.textures.constant_number(found.input(what), 'melanin')
                            for what in ('Melanin', 'Melanin Redness'))
            amount = -math.log(max(1 - melanin, 1e-4))
            absorbed = tuple(amount * ((1 - red) * dark + red * light)
                             for dark, light in zip(EUMELANIN, PHEOMELANIN))
        place = found.input('Radial Roughness')  # of one of two models from 4.0 on
        around = self.textures.constant_number(place, 'roughness of hair') if place else \
            RADIAL_ROUGHNESS
        scale = sum(c * around ** i for i, c in enumerate(ALBEDO_BY_ROUGHNESS))
        return tuple(math.exp(-scale * max(a, 0.0) ** 0.5) for a in absorbed)

    def fibre(self, found, name):
        """Node Hair BSDF, one of its two parts."""
        self.left_out.add('Hair BSDF is approximated by glossy or translucent surfaces', name)
        if found.node.component == 'Transmission':
            return Shader(self.named(name, 'mattetranslucent', [
                color('Kr', BLACK), color('Kt', self.textures.color(found.input('Color')))]),
                opaque=False)
        rough = self.textures.constant_number(found.input('RoughnessU'), 'roughness of hair')
        return Shader(self.metal(name, self.textures.color(found.input('Color')), rough * rough,
                                 []))

    def emission(self, found, name):
        with self.textures.lighting():
            strength = self.textures.constant_number(found.input('Strength'),
                                                     'strengths of emission')
            light = self.textures.product(self.textures.color(found.input('Color')), strength)
        return Shader(self.black(name), None if light == BLACK else light)

    def black(self, name):
        return self.named(name, 'matte', [color('Kd', BLACK)])
