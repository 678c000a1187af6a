"""Writes the world: a colour, an image of all directions, or sun and sky."""
import math
import os

import numpy as np

from .. import exr
from . import graph
from .colours import light_color
from .images import pixels
from .lxs_text import color, factor, parameter

CLEAR = 2.2  # turbidity that stands for a dust density of 1
# Radiance of Blender's sky over that of the scene language's model: see docs/start/blender.md.
GAIN = {'PREETHAM': 1.0, 'HOSEK_WILKIE': 1.0, 'NISHITA': 1.0}


class World:
    def __init__(self, text, folder, textures, left_out):
        self._text = text
        self._folder = folder
        self._textures = textures
        self._left_out = left_out

    def write(self, world):
        if world is None:
            return
        found = None
        if world.use_nodes:
            output = graph.output_node(world.node_tree, 'OUTPUT_WORLD')
            if output is None:
                return
            if output.inputs['Volume'].is_linked:
                self._left_out.add("the world's volume is left out", world.name)
            found = graph.source(graph.Place(output.inputs['Surface']))
            if found is None:
                return
            if found.node.type != 'BACKGROUND':
                self._left_out.add('shaders of the world other than Background are left out', world.name)
                return
        self._text.statement('AttributeBegin')
        group = world.original.lightgroup  # not kept up to date in evaluated copies
        if group:
            self._text.statement('LightGroup', group)
        self._background(world, found)
        self._text.statement('AttributeEnd')

    def _background(self, world, found):
        if found is None:
            return self._constant(tuple(world.color), 1.0)
        strength = self._textures.constant_number(found.input('Strength'), 'strengths of the world')
        by = graph.source(found.input('Color'))
        if by and by.node.type == 'TEX_ENVIRONMENT':
            return self._image(world, by, strength)
        if by and by.node.type == 'TEX_SKY':
            return self._sky(world, by.node, strength)
        rgb = self._textures.color(found.input('Color'))
        if isinstance(rgb, str):
            self._left_out.add('textures of the world other than image and sky are left out', world.name)
            rgb = (0.5, 0.5, 0.5)
        return self._constant(rgb, strength)

    def _constant(self, rgb, strength):
        if strength > 0 and any(rgb):
            self._text.statement('LightSource', 'infinite',
                                 parameters=[color('L', light_color(rgb)), factor('gain', strength)])

    def _image(self, world, found, strength):
        node = found.node
        values = pixels(node.image) if node.image else None
        if values is None or node.projection != 'EQUIRECTANGULAR':
            self._left_out.add('worlds without an equirectangular image are left out', world.name)
            return
        path = os.path.join(self._folder, 'world.exr')
        # In the scene language azimuths run the other way round, and begin at +x in place of -x.
        exr.write(path, np.maximum(np.nan_to_num(values[:, ::-1, :3]), 0))
        turn = 180 - math.degrees(self._turn(world, found))
        self._text.statement('Rotate', turn, 0.0, 0.0, 1.0)
        self._text.statement('LightSource', 'infinite', parameters=[
            self._text.file(path, 'mapname'), factor('gain', strength)])

    def _turn(self, world, found):
        """Rotation about z by a node Mapping, radians."""
        before = graph.source(found.input('Vector'))
        if before is None or before.node.type != 'MAPPING':
            return 0.0
        x, y, turn = graph.constant(before.input('Rotation'))
        if x or y or tuple(graph.constant(before.input('Scale'))) != (1.0, 1.0, 1.0):
            self._left_out.add("the world's mapping is left out but for turns about z", world.name)
        return -turn if before.node.vector_type == 'TEXTURE' else turn

    def _sky(self, world, node, strength):
        self._left_out.add('skies follow the models of LuxRender', world.name)
        gain = factor('gain', strength * GAIN[node.sky_type])
        if node.sky_type != 'NISHITA':
            plugin = 'sky' if node.sky_type == 'PREETHAM' else 'sky2'
            self._text.statement('LightSource', plugin, parameters=[
                gain, parameter('vector', 'sundir', tuple(node.sun_direction)),
                factor('turbidity', node.turbidity)])
            return
        height, turn = node.sun_elevation, node.sun_rotation
        towards = (math.sin(turn) * math.cos(height), math.cos(turn) * math.cos(height),
                   math.sin(height))
        plugin = 'sunsky2' if node.sun_disc else 'sky2'
        parameters = [gain, parameter('vector', 'sundir', towards),
                      factor('turbidity', CLEAR * max(node.dust_density, 0.5))]
        if node.sun_disc:
            parameters.append(factor('relsize', math.degrees(node.sun_size) / 0.545))
        self._text.statement('LightSource', plugin, parameters=parameters)
