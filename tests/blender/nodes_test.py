"""Protects what nodes of materials look like: as in Cycles, block by block, on a wall and a ball.

What is compared is light that shines, alike in all directions: no noise, no light from elsewhere.
"""
import os
import re
import unittest

import bpy
import numpy as np

import small_scenes as scenes
from aips_blender import exr
from aips_blender.export.film import Film
from aips_blender.export.scene import export
from cycles_agreement import HEIGHT, WIDTH, blocks, cycles_image
from exported_files import render
from fixture import FOLDER, exported

WITHIN = 0.01   # of the brightest block
PASSES = 64
SAMPLES = 64


class Nodes(unittest.TestCase):
    def setUp(self):
        self.scene = scenes.clear()
        self.made = scenes.material('shown', 'ShaderNodeEmission')
        scenes.plane('wall', 4, self.made, (0, 1, 0), (1.2, 0.2, 0.1)).scale = (1, 0.7, 1)
        scenes.ball('ball', 0.9, self.made, (0.4, -0.6, 0.2))
        scenes.camera((0, -6, 1), (1.4, 0, 0), 50)
        self.tree = self.made.node_tree

    def node(self, kind, links=(), settings=(), **inputs):
        """A node with links to its inputs, by name or number, and values of others."""
        made = self.tree.nodes.new(kind)
        for key, value in dict(settings).items():
            setattr(made, key, value)
        for key, value in inputs.items():
            made.inputs[key.replace('_', ' ')].default_value = value
        for key, output in dict(links).items():
            self.tree.links.new(output, made.inputs[key])
        return made

    def noise(self, links=(), **inputs):
        return self.node('ShaderNodeTexNoise', links, **{'Scale': 3.0, 'Detail': 1.0, **inputs})

    def agrees(self, output, *left_out, within=WITHIN):
        """The image of an output as colour."""
        self.tree.links.new(output, self.tree.nodes['Emission'].inputs['Color'])
        name = self.id().rsplit('.', 1)[1]
        self.scene.render.resolution_x, self.scene.render.resolution_y = WIDTH, HEIGHT
        found = export(os.path.join(FOLDER, name + '.lxs'),
                       bpy.context.evaluated_depsgraph_get(),
                       Film(WIDTH, HEIGHT, passes=PASSES, integrator='path'))
        self.assertEqual(found.left_out, list(left_out))
        ours = blocks(render(name))
        theirs = blocks(cycles_image(self.scene, os.path.join(FOLDER, name + '-cycles.exr'),
                                     SAMPLES))
        worst = np.abs(ours - theirs).max() / theirs.max()
        print(f'[{name}: worst block {100 * worst:.2f} %, mean {theirs.mean():.3f}] ', end='',
              flush=True)
        self.assertGreater(np.ptp(theirs), 0.02)
        self.assertLess(worst, within)

    def test_noise(self):
        self.agrees(self.noise(Distortion=0.7, Detail=2.5).outputs['Color'])

    def test_noise_of_other_dimensions(self):
        place = {'Vector': self.node('ShaderNodeTexCoord').outputs['Generated']}
        fourth = {'W': self.noise().outputs['Fac']}
        self.agrees(self.mean([self.node(
            'ShaderNodeTexNoise', links, {'noise_dimensions': kind}, Scale=4.0,
            Distortion=0.5).outputs['Color']
            for kind, links in (('1D', fourth), ('2D', place), ('4D', {**place, **fourth}))]))

    def fractal(self, kind, **inputs):
        """By node Musgrave, or from 4.1 on the Noise that it became."""
        if hasattr(bpy.types, 'ShaderNodeTexMusgrave'):
            return self.node('ShaderNodeTexMusgrave', settings={'musgrave_type': kind},
                             **{'Scale': 3.0, 'Dimension': 0.8, 'Detail': 3.0, **inputs})
        detail = inputs.pop('Detail', 3.0) - 1
        return self.node('ShaderNodeTexNoise', settings={'noise_type': kind, 'normalize': False},
                         **{'Scale': 3.0, 'Roughness': 2 ** -0.8, 'Detail': detail, **inputs})

    def shown(self, fractal, scale=0.4, shift=0.3):
        """What is mostly from 0 to 1 of a fractal."""
        node = self.node('ShaderNodeMath', {0: fractal.outputs[0]}, {
            'operation': 'MULTIPLY_ADD', 'use_clamp': True})
        node.inputs[1].default_value, node.inputs[2].default_value = scale, shift
        return node.outputs[0]

    def test_sums_and_products_of_octaves(self):
        self.agrees(self.mean([self.shown(self.fractal('FBM', Detail=2.6)),
                               self.shown(self.fractal('MULTIFRACTAL', Detail=2.6))]))

    def test_terrains_and_ridges(self):
        self.agrees(self.mean([
            self.shown(self.fractal('HETERO_TERRAIN', Offset=0.6), 0.4, 0.1),
            self.shown(self.fractal('RIDGED_MULTIFRACTAL', Offset=0.8, Gain=1.6), 0.8, 0.0),
            self.shown(self.fractal('HYBRID_MULTIFRACTAL', Offset=0.5, Gain=1.2), 0.4, 0.1)]))

    def test_noise_by_object_coordinates_that_are_mapped(self):
        mapping = self.node('ShaderNodeMapping', {
            'Vector': self.node('ShaderNodeTexCoord').outputs['Object']},
            Location=(0.3, 0.2, 0.1), Rotation=(0.3, 0.5, 0.7), Scale=(1, 2, 0.5))
        self.agrees(self.node('ShaderNodeTexNoise', {'Vector': mapping.outputs[0]}).outputs['Fac'])

    def test_coordinates_of_another_object(self):
        other = scenes.add('other', None, (0.3, 0.2, 0.5), (0.4, 0.3, 0.2))
        other.scale = (1, 2, 1)
        place = self.node('ShaderNodeTexCoord', settings={'object': other}).outputs['Object']
        self.agrees(self.noise(links={'Vector': place}).outputs['Color'])

    def test_voronoi(self):
        self.agrees(self.node('ShaderNodeTexVoronoi', Scale=4.0).outputs['Distance'])

    def test_voronoi_colours(self):
        self.agrees(self.node('ShaderNodeTexVoronoi', settings={'distance': 'MANHATTAN'},
                              Scale=3.0, Randomness=0.8).outputs['Color'])

    def test_voronoi_edges(self):
        self.agrees(self.node('ShaderNodeTexVoronoi', settings={'feature': 'DISTANCE_TO_EDGE'},
                              Scale=4.0).outputs['Distance'])

    def test_flat_cells(self):
        uv = self.node('ShaderNodeTexCoord').outputs['UV']
        cells = [self.node('ShaderNodeTexVoronoi', {'Vector': uv}, {
            'voronoi_dimensions': '2D', 'feature': feature}, Scale=5.0)
            for feature in ('F1', 'DISTANCE_TO_EDGE', 'SMOOTH_F1')]
        self.agrees(self.mean([cells[0].outputs['Color'], cells[1].outputs['Distance'],
                               cells[2].outputs['Distance']]))

    def test_checker(self):
        self.agrees(self.node('ShaderNodeTexChecker', Scale=3.0, Color1=(0.9, 0.5, 0.1, 1),
                              Color2=(0.1, 0.2, 0.3, 1)).outputs['Color'])

    def test_bricks(self):
        uv = self.node('ShaderNodeTexCoord').outputs['UV']
        self.agrees(self.node('ShaderNodeTexBrick', {'Vector': uv}, {'squash': 0.7}, Scale=4.0,
                              Mortar_Size=0.05, Mortar_Smooth=0.3).outputs['Color'])

    def test_gradient(self):
        self.agrees(self.node('ShaderNodeTexGradient',
                              settings={'gradient_type': 'EASING'}).outputs['Color'])

    def mean(self, outputs):
        """A graph's mean of outputs."""
        last = outputs[0]
        for count, each in enumerate(outputs[1:], 2):
            last = self.node('ShaderNodeMixRGB', {'Color1': last, 'Color2': each},
                             Fac=1 / count).outputs[0]
        return last

    def test_all_gradients(self):
        place = self.node('ShaderNodeTexCoord').outputs['Object']
        self.agrees(self.mean([
            self.node('ShaderNodeTexGradient', {'Vector': place}, {'gradient_type': kind})
            .outputs['Color'] for kind in ('LINEAR', 'QUADRATIC', 'DIAGONAL', 'RADIAL',
                                           'QUADRATIC_SPHERE', 'SPHERICAL')]))

    def test_all_waves(self):
        waves = []
        for kind, at in (('BANDS', 'X'), ('BANDS', 'DIAGONAL'), ('RINGS', 'Z'),
                         ('RINGS', 'SPHERICAL')):
            for profile in ('SAW', 'TRI'):
                waves.append(self.node('ShaderNodeTexWave', settings={
                    'wave_type': kind, f'{kind.lower()}_direction': at, 'wave_profile': profile},
                    Scale=1.0, Phase_Offset=1.5).outputs['Color'])
        self.agrees(self.mean(waves))

    def test_other_cells(self):
        smooth = self.node('ShaderNodeTexVoronoi', settings={'feature': 'SMOOTH_F1'}, Scale=3.0,
                           Smoothness=0.7)
        second = self.node('ShaderNodeTexVoronoi', settings={
            'feature': 'F2', 'distance': 'MINKOWSKI'}, Scale=3.0, Exponent=1.5)
        cubes = self.node('ShaderNodeTexVoronoi', settings={'distance': 'CHEBYCHEV'}, Scale=3.0)
        self.agrees(self.mean([smooth.outputs['Distance'], smooth.outputs['Color'],
                               second.outputs['Distance'], second.outputs['Color'],
                               cubes.outputs['Position']]))

    def test_white_noise_of_snapped_places(self):
        moved = self.node('ShaderNodeVectorMath', {
            0: self.node('ShaderNodeTexCoord').outputs['Generated']})
        moved.inputs[1].default_value = (0.11, 0.12, 0.13)  # planes lie in no border
        snapped = self.node('ShaderNodeVectorMath', {0: moved.outputs[0]}, {'operation': 'SNAP'})
        snapped.inputs[1].default_value = (0.25, 0.25, 0.25)
        self.agrees(self.node('ShaderNodeTexWhiteNoise', {
            'Vector': snapped.outputs[0]}).outputs['Color'])

    def test_parts_of_colours(self):
        parts = self.node('ShaderNodeSeparateColor', {'Color': self.noise().outputs['Color']},
                          {'mode': 'HSV'})
        hue = self.node('ShaderNodeClamp', {'Value': parts.outputs[0]}, {'clamp_type': 'RANGE'},
                        Min=0.7, Max=0.3)
        value = self.node('ShaderNodeMapRange', {'Value': parts.outputs[2]}, {'clamp': True},
                          From_Min=0.3, From_Max=0.7, To_Min=0.8, To_Max=0.2)
        self.agrees(self.node('ShaderNodeCombineColor', {
            0: hue.outputs[0], 1: parts.outputs[1], 2: value.outputs[0]}, {'mode': 'HSV'})
            .outputs[0])

    def test_curves_of_vectors_and_numbers(self):
        place = self.node('ShaderNodeVectorMath', {
            0: self.node('ShaderNodeTexCoord').outputs['Object']}, {'operation': 'ABSOLUTE'})
        vector = self.node('ShaderNodeVectorCurve', {'Vector': place.outputs[0]})
        vector.mapping.curves[0].points.new(0.2, 0.6)
        number = self.node('ShaderNodeFloatCurve', {'Value': vector.outputs[0]})
        number.mapping.curves[0].points.new(0.4, 0.8)
        self.agrees(self.mean([vector.outputs[0], number.outputs[0]]))

    def test_waves(self):
        wave = self.node('ShaderNodeTexWave', settings={'wave_type': 'RINGS'}, Scale=2.0,
                         Distortion=2.0)
        self.agrees(wave.outputs['Color'])

    def test_magic(self):
        self.agrees(self.node('ShaderNodeTexMagic', Scale=2.0, Distortion=1.5).outputs['Color'],
                    within=0.02)  # lights of LuxRender cannot have some of its colours

    def test_ramp(self):
        ramp = self.node('ShaderNodeValToRGB', {'Fac': self.noise().outputs['Fac']})
        ramp.color_ramp.elements[0].position = 0.3
        ramp.color_ramp.elements[1].position = 0.7
        ramp.color_ramp.elements[0].color = (0.8, 0.1, 0.05, 1)
        ramp.color_ramp.elements.new(0.5).color = (0.1, 0.6, 0.2, 1)
        self.agrees(ramp.outputs['Color'])

    def test_ramp_with_smooth_ends(self):
        ramp = self.node('ShaderNodeValToRGB', {'Fac': self.noise().outputs['Fac']})
        ramp.color_ramp.interpolation = 'EASE'
        self.agrees(ramp.outputs['Color'])

    def test_colours_are_changed_one_after_the_other(self):
        last = self.noise().outputs['Color']
        for kind, inputs in (('HueSaturation', {'Hue': 0.7, 'Saturation': 1.6, 'Value': 1.2}),
                             ('BrightContrast', {'Bright': 0.05, 'Contrast': 0.3}),
                             ('Gamma', {'Gamma': 1.4}), ('Invert', {'Fac': 0.6})):
            last = self.node(f'ShaderNode{kind}', {'Color': last}, **inputs).outputs[0]
        self.agrees(last)

    def test_curves(self):
        curves = self.node('ShaderNodeRGBCurve', {'Color': self.noise().outputs['Color']})
        curves.mapping.curves[0].points.new(0.4, 0.7)
        curves.mapping.curves[3].points.new(0.5, 0.3)
        curves.mapping.update()
        self.agrees(curves.outputs['Color'])

    def test_mixes(self):
        first, second = self.noise().outputs['Color'], self.noise(Scale=1.3).outputs['Color']
        last = first
        for how in ('OVERLAY', 'SOFT_LIGHT', 'SCREEN', 'HUE', 'LINEAR_LIGHT', 'BURN'):
            last = self.node('ShaderNodeMixRGB', {'Color1': last, 'Color2': second},
                             {'blend_type': how}, Fac=0.4).outputs[0]
        self.agrees(last)

    def test_mathematics(self):
        value = self.noise().outputs['Fac']
        for how, by in (('MULTIPLY', 7.0), ('PINGPONG', 1.3), ('POWER', 1.7), ('SINE', 0),
                        ('SMOOTH_MAX', 0.3)):
            node = self.node('ShaderNodeMath', {0: value}, {'operation': how})
            node.inputs[1].default_value, node.inputs[2].default_value = by, 0.2
            value = node.outputs[0]
        ranged = self.node('ShaderNodeMapRange', {'Value': value},
                           {'interpolation_type': 'SMOOTHSTEP'}, To_Min=0.1, To_Max=0.9)
        self.agrees(ranged.outputs[0])

    def test_vectors(self):
        place = self.node('ShaderNodeNewGeometry').outputs['Position']
        for how in ('FRACTION', 'NORMALIZE', 'ABSOLUTE'):
            place = self.node('ShaderNodeVectorMath', {0: place}, {'operation': how}).outputs[0]
        parts = self.node('ShaderNodeSeparateXYZ', {0: place})
        self.agrees(self.node('ShaderNodeCombineXYZ', {
            'X': parts.outputs['Y'], 'Y': parts.outputs['X'], 'Z': parts.outputs['Z']}).outputs[0])

    def test_normals(self):
        normal = self.node('ShaderNodeNewGeometry').outputs['Normal']
        self.agrees(self.node('ShaderNodeVectorMath', {0: normal}, {
            'operation': 'ABSOLUTE'}).outputs[0])

    def test_what_is_looked_up_is_distorted(self):
        place = self.node('ShaderNodeMixRGB', {
            'Color1': self.node('ShaderNodeTexCoord').outputs['Generated'],
            'Color2': self.noise().outputs['Color']}, Fac=0.3)
        cells = self.node('ShaderNodeTexVoronoi', {'Vector': place.outputs[0]})
        self.agrees(cells.outputs['Color'])

    def test_images_are_changed(self):
        values = np.random.default_rng(1).random((6, 8, 4)).astype(np.float32)
        values[:, :, 3] = 0.6  # by which Cycles dims the colours where it is not used
        picture = self.node('ShaderNodeTexImage')
        picture.image = scenes.image('picture', values, False)
        self.agrees(self.node('ShaderNodeHueSaturation', {'Color': picture.outputs['Color']},
                              Saturation=0.4, Hue=0.6).outputs[0])

    def test_images_by_other_coordinates(self):
        """Turned, and by generated coordinates."""
        values = np.random.default_rng(1).random((6, 8, 4)).astype(np.float32)
        values[:, :, 3] = 1
        mapping = self.node('ShaderNodeMapping', {
            'Vector': self.node('ShaderNodeTexCoord').outputs['Generated']},
            Rotation=(0.2, 0.1, 0.5), Scale=(1.5, 1, 1))
        picture = self.node('ShaderNodeTexImage', {'Vector': mapping.outputs[0]})
        picture.image = scenes.image('picture', values, False)
        self.agrees(picture.outputs['Color'])

    def test_constants_are_constants(self):
        value = self.node('ShaderNodeValue')
        value.outputs[0].default_value = 3
        tripled = self.node('ShaderNodeMath', {0: value.outputs[0]}, {'operation': 'MULTIPLY'})
        tripled.inputs[1].default_value = 2
        self.tree.links.new(tripled.outputs[0], self.tree.nodes['Emission'].inputs['Strength'])
        found = export(os.path.join(FOLDER, 'constant.lxs'),
                       bpy.context.evaluated_depsgraph_get(), Film(8, 8, passes=1))
        self.assertEqual(found.left_out, [])
        render('constant')
        self.assertAlmostEqual(float(exr.read(os.path.join(FOLDER, 'constant.exr'))
                                     .channels['R'].max()), 6, delta=0.01)

    def test_what_nodes_tell_of_objects(self):
        """Each object, two of one mesh and instances of a collection, has values of its own."""
        mesh = bpy.data.objects['ball'].data
        self.tree.nodes['Emission'].inputs['Strength'].default_value = 1
        for i in range(3):
            other = scenes.add(f'other {i}', mesh, (1.3 * i - 1.3, -0.7, 1.6))
            other.scale, other.pass_index, other.color = (0.4,) * 3, i, (0.2 * i, 0.5, 0.3, 0.4)
            other['shade'] = 0.25 * i
        self.made.pass_index = 2
        placed = [scenes.ball(f'placed {i}', 0.3, self.made, (0, -1.2, i - 1.6)) for i in (0, 1)]
        scenes.instances(placed, -1.2, 1.2)
        info = self.node('ShaderNodeObjectInfo')
        shade = self.node('ShaderNodeAttribute', settings={'attribute_type': 'OBJECT',
                                                           'attribute_name': 'shade'})
        place = self.node('ShaderNodeVectorMath', {0: info.outputs['Location']},
                          {'operation': 'FRACTION'})
        halved = self.node('ShaderNodeMath', {0: info.outputs['Object Index'],
                                              1: info.outputs['Material Index']},
                           {'operation': 'DIVIDE'})
        self.agrees(self.mean([info.outputs['Random'], info.outputs['Color'], shade.outputs['Fac'],
                               place.outputs[0], halved.outputs[0]]))

    def test_instances_that_differ_are_bounded(self):
        scenes.instances([bpy.data.objects['ball']], *range(100))
        self.tree.links.new(self.node('ShaderNodeObjectInfo').outputs['Random'],
                            self.tree.nodes['Emission'].inputs['Color'])
        text, left_out = exported('many')
        self.assertEqual(left_out, ['of instances of a mesh that differ 64 have values of their '
                                    'own: ball'])
        self.assertEqual(len(set(re.findall('MakeNamedMaterial "(.*?)"', text))), 65)
        self.assertEqual(len(set(re.findall(r'"string filename" \["(.*?-ball-.*?)"', text))), 1)

    def test_what_has_no_counterpart_is_told(self):
        random = self.node('ShaderNodeParticleInfo').outputs['Random']
        occluded = self.node('ShaderNodeAmbientOcclusion', Color=(0.5, 0.2, 0.1, 1))
        mixed = self.node('ShaderNodeMixRGB', {'Fac': random, 'Color1': occluded.outputs['Color']})
        self.tree.links.new(mixed.outputs[0], self.tree.nodes['Emission'].inputs['Color'])
        found = export(os.path.join(FOLDER, 'told.lxs'),
                       bpy.context.evaluated_depsgraph_get(), Film(8, 8, passes=1))
        self.assertEqual(found.left_out, [
            'nodes Ambient Occlusion are replaced by their input Color: shown',
            'what node Particle Info tells is taken to be the same everywhere: shown'])
