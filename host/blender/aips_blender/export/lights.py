"""Writes Blender's lights, whose watts become intensity, radiance or irradiance.

Units, as Cycles has them and tests/blender compares: with power P a point or spot light has the
intensity P / (4 pi) per steradian, a sphere of radius r the radiance P / (4 pi^2 r^2), an area
light of area A the radiance P / (pi A), of Blender 3 P / (4 A), a sun of strength E the irradiance
E; spots of Blender 3 fade by the cosine, too. In the scene language
a colour L of 1 is a radiance, or an intensity, of 1; of light "distant" see _sun.
"""
import math
import os

import numpy as np

from .. import exr
from . import graph, transforms, versions
from .colours import light_color
from .lxs_text import color, factor, parameter

LEAST_SUN_ANGLE = 1e-4   # radians of half angle; below it the sun's rays are parallel
PARALLEL = 2.0 ** -16    # 1 - cosine of the cone that light "distant" takes for a theta of 0
ROWS = 4096              # of a map of intensity by angle, over the half turn


class Lights:
    """`exposure` multiplies what shines."""

    def __init__(self, text, folder, textures, left_out, exposure):
        self._exposure = exposure
        self._text = text
        self._folder = folder
        self._textures = textures
        self._left_out = left_out

    def write(self, name, light, matrix, seen, group):
        """One light, within the attributes of its own; `seen`: whether Cycles' camera sees it."""
        make = {'POINT': self._point, 'SPOT': self._spot, 'SUN': self._sun,
                'AREA': self._area}[light.type]
        if not versions.setting(True, (light, 'normalize')):
            self._left_out.add('lights with Normalize off are taken as if it were on', name)
        rgb = light_color([c * f * s * self._exposure for c, f, s in zip(
            light.color, self._node_factor(light), versions.light_scale(light))])
        if group:
            self._text.statement('LightGroup', group)
        make(name, light, matrix, rgb, seen)

    def _node_factor(self, light):
        """What the nodes of a light multiply its colour by."""
        self._left_out.reading = light.name
        output = None
        if versions.uses_nodes(light):
            output = graph.output_node(light.node_tree, 'OUTPUT_LIGHT')
        if output is None:
            return (1.0, 1.0, 1.0)
        found = graph.source(graph.Place(output.inputs['Surface']))
        if found is None or found.node.type != 'EMISSION':
            self._left_out.add('nodes of lights other than Emission are left out', light.name)
            return (1.0, 1.0, 1.0)
        tint = self._textures.color(found.input('Color'))
        if isinstance(tint, str):
            self._left_out.add('textures of lights are left out', light.name)
            tint = (1.0, 1.0, 1.0)
        strength = self._textures.constant_number(found.input('Strength'), 'strengths of lights')
        return tuple(c * strength for c in tint)

    def _shape_emits(self, rgb, radiance, seen, profile=None):
        """What makes the shape that follows shine and block no light, as Cycles' lights.

        It sends as much light as one of a radiance, with `profile` of this intensity by angle.
        """
        self._text.statement('AreaLightSource', 'area', parameters=[
            color('L', rgb), factor('gain', radiance), factor('power', 0.0),
            factor('efficacy', 0.0), *hidden(not seen), *self._map(profile)])
        self._text.statement('Material', 'null')

    def _map(self, profile):
        """The parameter of a map of intensity by polar angle, or nothing."""
        if profile is None:
            return []
        stem = self._text.free_name('profile').replace(' ', '-')
        path = os.path.join(self._folder, stem + '.exr')
        exr.write(path, np.repeat(profile[:, None, None], 3, axis=2).repeat(2, axis=1))
        return [self._text.file(path, 'mapname')]

    def _point(self, name, light, matrix, rgb, seen):
        place = tuple(matrix[row][3] for row in range(3))
        radius = light.shadow_soft_size
        if radius <= 0:
            self._text.statement('LightSource', 'point', parameters=[
                color('L', rgb), factor('gain', light.energy / (4 * math.pi)),
                parameter('point', 'from', place)])
            return
        self._text.statement('Translate', *map(float, place))
        self._shape_emits(rgb, light.energy / (4 * math.pi ** 2 * radius ** 2), seen)
        self._text.statement('Shape', 'sphere', parameters=[
            factor('radius', radius), parameter('string', 'name', name)])

    def _spot(self, name, light, matrix, rgb, seen):
        """A map of intensity by direction, as light "spot" has another falloff than Cycles; of one
        with a radius that of a disc."""
        frame = transforms.around_axis(matrix)
        if frame is None:
            return
        profile = spot_profile(math.cos(light.spot_size / 2), light.spot_blend, ROWS,
                               by_cosine=versions.BLENDER_3)
        # "goniometric" sends 4 pi L however narrow the map; the map's top is +z, a spot's axis -z.
        self._text.matrix('ConcatTransform', frame)
        self._text.statement('Rotate', 180.0, 1.0, 0.0, 0.0)
        mean, radius = light.energy / (4 * math.pi) * sphere_mean(profile), light.shadow_soft_size
        if radius > 0:
            self._shape_emits(rgb, 4 * mean / (math.pi * radius ** 2), seen, profile)
            self._text.statement('Shape', 'disk', parameters=[
                factor('radius', radius), parameter('string', 'name', name)])
            return
        self._text.statement('LightSource', 'goniometric', parameters=[
            color('L', rgb), factor('gain', mean), *self._map(profile)])

    def _sun(self, _name, light, matrix, rgb, seen):
        """L of light "distant" is the irradiance times the solid angle of its cone."""
        theta = min(light.angle / 2, math.pi / 2)
        parallel = theta < LEAST_SUN_ANGLE
        cone = 2 * math.pi * (PARALLEL if parallel else 1 - math.cos(theta))
        towards = tuple(-matrix[row][2] for row in range(3))
        if not any(towards):
            return
        self._text.statement('LightSource', 'distant', parameters=[
            color('L', rgb), factor('gain', light.energy * cone),
            factor('theta', 0.0 if parallel else math.degrees(theta)),
            parameter('point', 'from', (0.0, 0.0, 0.0)), parameter('point', 'to', towards),
            *hidden(not seen)])

    def _area(self, name, light, matrix, rgb, seen):
        if versions.setting(False, (light, 'cycles.is_portal')):
            return
        height = light.size_y if light.shape in ('RECTANGLE', 'ELLIPSE') else light.size
        flat = light.shape in ('DISK', 'ELLIPSE')
        edges = [math.sqrt(sum(matrix[row][axis] ** 2 for row in range(3))) for axis in (0, 1)]
        area = light.size * height * edges[0] * edges[1] * (math.pi / 4 if flat else 1)
        if area <= 0 or not transforms.is_seen(matrix):
            return
        self._text.matrix('ConcatTransform', transforms.placeable((matrix,), (1.0, 1.0, 0.0))[0])
        # Lights shine along -z, shapes along +z.
        self._text.statement('Rotate', 180.0, 1.0, 0.0, 0.0)
        self._text.statement('Scale', light.size / 2, height / 2, 1.0)
        share = 4 if versions.BLENDER_3 else math.pi
        narrow = light.spread < math.pi - 1e-3
        self._shape_emits(rgb, light.energy / (share * area), seen,
                          spread_profile(light.spread, ROWS) if narrow else None)
        if flat:
            self._text.statement('Shape', 'disk', parameters=[parameter('string', 'name', name)])
            return
        self._text.statement('Shape', 'trianglemesh', parameters=[
            parameter('integer', 'triindices', (0, 1, 2, 0, 2, 3)),
            parameter('point', 'P', (-1.0, -1.0, 0.0, 1.0, -1.0, 0.0,
                                     1.0, 1.0, 0.0, -1.0, 1.0, 0.0)),
            parameter('string', 'name', name)])


def hidden(from_camera):
    """The parameter that hides a light from the camera, or nothing."""
    return [parameter('bool', 'hidden', True)] if from_camera else []


def spot_profile(rim, blend, rows, by_cosine):
    """Cycles' falloff by polar angle from the axis, at the middles of rows; `rim` is a cosine.

    Where the intensity goes by the cosine too, it is P / (4 pi) on the axis alone.
    """
    cosine = np.cos(np.pi * (np.arange(rows) + 0.5) / rows)
    width = (1 - rim) * blend
    share = np.clip((cosine - rim) / width, 0, 1) if width > 0 else (cosine > rim).astype(float)
    smooth = share * share * (3 - 2 * share)
    return np.where(cosine > rim, smooth * (cosine if by_cosine else 1), 0).astype(np.float32)


def spread_profile(spread, rows):
    """Of an area light behind Cycles' grid of slats, likewise: none beyond half the spread."""
    half = max(spread / 2, math.radians(0.5))
    angle = np.pi * (np.arange(rows) + 0.5) / rows
    front = np.minimum(angle, np.pi / 2 - 1e-6)
    return (np.maximum(math.tan(half) - np.tan(front), 0) * np.cos(front)).astype(np.float32)


def sphere_mean(profile):
    """Mean over the sphere of values by polar angle, at the middles of rows."""
    angles = np.pi * (np.arange(len(profile)) + 0.5) / len(profile)
    return float((profile * np.sin(angles)).sum() / np.sin(angles).sum())
