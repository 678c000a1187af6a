"""Writes the world: a colour, an image of all directions, or sun and sky."""
import math

from . import graph, versions
from .colours import light_color
from .lights import hidden
from .lxs_text import color, factor, parameter
from .media import CLEAR
from .volume_shaders import MediumNodes

KINDS_OF_RAYS = ('diffuse', 'glossy', 'transmission', 'scatter')
SRGB_GAMMA = 2.2  # of the scene language, which has no sRGB curve for lights
CLEAR_SKY = 2.2  # turbidity that stands for a dust density of 1
# Radiance of Cycles' skies over that of LuxRender's models, and of its sun: measured with the sun
# at 15, 45 and 80 degrees. Preetham's is the same model; of Hosek's and Nishita's see the manual.
SKY_GAIN = {'PREETHAM': 5.99e-5, 'HOSEK_WILKIE': 1.65e-5, 'NISHITA': 7.0e-4}
RENAMED_SKIES = {'SINGLE_SCATTERING': 'NISHITA', 'MULTIPLE_SCATTERING': 'NISHITA'}  # 5.0
SUN_GAIN = 1.33e-3
SUN_DEGREES = 0.545  # width of the sun's disk that a relsize of 1 stands for


class World:
    """`exposure` multiplies what shines."""

    def __init__(self, text, folder, textures, left_out, exposure):
        self._exposure = exposure
        self._text = text
        self._folder = folder
        self._textures = textures
        self._left_out = left_out
        self._hidden = []  # the parameter that hides it from the camera, if it is

    def medium(self, world):
        """The Medium that fills the world."""
        output = world and versions.uses_nodes(world) and \
            graph.output_node(world.node_tree, 'OUTPUT_WORLD')
        if not output:
            return CLEAR
        return MediumNodes(self._textures, self._left_out).of(
            graph.Place(output.inputs['Volume']), world.name)

    def write(self, world, media, medium):
        """The light of the world, which comes through its medium."""
        if world is None:
            return
        self._left_out.reading = world.name
        found = None
        if versions.uses_nodes(world):
            output = graph.output_node(world.node_tree, 'OUTPUT_WORLD')
            if output is None:
                return
            found = self._lit_by(graph.Place(output.inputs['Surface']), world)
            if found is None:
                return
            if found.node.type != 'BACKGROUND':
                self._left_out.add('shaders of the world other than Background are left out',
                                   world.name)
                return
        visibility = getattr(world, 'cycles_visibility', None)
        if visibility and not all(getattr(visibility, kind) for kind in KINDS_OF_RAYS):
            self._left_out.add('lights hidden from some rays shine on all', world.name)
        self._hidden = hidden(visibility and not visibility.camera)
        self._text.statement('AttributeBegin')
        group = world.original.lightgroup  # not kept up to date in evaluated copies
        if group:
            self._text.statement('LightGroup', group)
        media.sides(medium, medium)
        with self._textures.lighting():
            self._background(world, found)
        self._text.statement('AttributeEnd')

    def _lit_by(self, place, world):
        """The node that lights the world: of mixes and sums that which does so most."""
        found = graph.source(place)
        while found and found.node.type in ('MIX_SHADER', 'ADD_SHADER'):
            self._left_out.add('of mixed shaders of the world one is taken', world.name)
            parts = [graph.source(graph.Place(s, found.groups)) for s in found.node.inputs
                     if s.type == 'SHADER']
            second = found.node.type == 'MIX_SHADER' and self._is_second(found.input('Fac'))
            found = parts[second] or parts[not second]
        return found

    def _is_second(self, place):
        """Whether the second of a mix lights the scene; what the camera sees does not."""
        by = graph.source(place)
        if by and by.node.type == 'LIGHT_PATH':
            return by.output.name != 'Is Camera Ray'
        share = self._textures.number(place)
        return not isinstance(share, str) and share > 0.5

    def _background(self, world, found):
        if found is None:
            return self._constant(tuple(world.color), self._exposure)
        strength = self._exposure * self._textures.constant_number(
            found.input('Strength'), 'strengths of the world')
        by = graph.source(found.input('Color'))
        seen = by and graph.first_before(by, ('TEX_ENVIRONMENT', 'TEX_SKY'))
        if seen:
            if seen.node != by.node:
                self._left_out.add('nodes behind the image or sky of the world are left out',
                                   world.name)
            write = self._image if seen.node.type == 'TEX_ENVIRONMENT' else self._sky
            return write(world, seen, strength)
        rgb = self._textures.color(found.input('Color'))
        if isinstance(rgb, str):
            self._left_out.add('of textures of the world other than image and sky the darker '
                               'colour is taken', world.name)
            rgb = graph.darkest(by)
        return self._constant(rgb, strength)

    def _constant(self, rgb, strength):
        if strength > 0 and any(rgb):
            self._text.statement('LightSource', 'infinite',
                                 parameters=[color('L', light_color(rgb)),
                                             factor('gain', strength), *self._hidden])

    def _image(self, world, found, strength):
        node = found.node
        file = self._textures.image_file(node) if node.image else None
        if file is None or node.projection != 'EQUIRECTANGULAR':
            self._left_out.add('worlds without an equirectangular image are left out', world.name)
            return
        turn = 180 - math.degrees(self._turn(world, found))
        self._text.statement('Rotate', turn, 0.0, 0.0, 1.0)
        # In the scene language azimuths run the other way round, and begin at +x in place of -x.
        self._text.statement('Scale', 1.0, -1.0, 1.0)
        self._text.statement('LightSource', 'infinite', parameters=[
            self._text.file(file.path, 'mapname'), factor('gain', strength),
            factor('gamma', SRGB_GAMMA if file.srgb else 1.0), *self._hidden])

    def _turn(self, world, found):
        """Rotation about z by a node Mapping, radians."""
        before = graph.source(found.input('Vector'))
        if before is None or before.node.type != 'MAPPING':
            self._tell_directions(before, world)
            return 0.0
        self._tell_directions(graph.source(before.input('Vector')), world)
        (x, y, turn), scale, shift = (self._textures.coordinates.vector(before, what)
                                      for what in ('Rotation', 'Scale', 'Location'))
        if x or y or any(shift) or tuple(scale) != (1.0, 1.0, 1.0):
            self._left_out.add("the world's mapping is left out but for turns about z", world.name)
        return -turn if before.node.vector_type == 'TEXTURE' else turn

    def _tell_directions(self, before, world):
        """Of what feeds the coordinates of the world, which should be directions as they are."""
        if before and not (before.node.type == 'TEX_COORD' and before.output.name == 'Generated'):
            self._left_out.add("the world's coordinates by nodes are left out", world.name)

    def _sky(self, world, found, strength):
        node = found.node
        place = found.input('Vector')  # Nishita's with a sun has none
        self._tell_directions(graph.source(place) if place else None, world)
        kind = RENAMED_SKIES.get(node.sky_type, node.sky_type)
        gain = strength * SKY_GAIN[kind]
        if kind == 'PREETHAM':
            return self._sky_light('sky', node.sun_direction, node.turbidity, gain)
        self._left_out.add("skies are approximated by LuxRender's", world.name)
        if kind == 'HOSEK_WILKIE':
            return self._sky_light('sky2', node.sun_direction, node.turbidity, gain)
        height, turn = node.sun_elevation, node.sun_rotation
        towards = (math.sin(turn) * math.cos(height), math.cos(turn) * math.cos(height),
                   math.sin(height))
        dust = versions.setting(1.0, (node, 'aerosol_density'), (node, 'dust_density'))
        haze = CLEAR_SKY * max(dust, 0.5)
        self._sky_light('sky2', towards, haze, gain)
        if node.sun_disc:
            self._text.statement('LightSource', 'sun', parameters=[
                factor('gain', strength * node.sun_intensity * SUN_GAIN),
                parameter('vector', 'sundir', towards), factor('turbidity', haze),
                factor('relsize', math.degrees(node.sun_size) / SUN_DEGREES), *self._hidden])

    def _sky_light(self, plugin, towards, turbidity, gain):
        self._text.statement('LightSource', plugin, parameters=[
            factor('gain', gain), parameter('vector', 'sundir', tuple(towards)),
            factor('turbidity', turbidity), *self._hidden])
