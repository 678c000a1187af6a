"""Protects volumes: what an export has around its shapes and lights, and what is told of them."""
import os
import re
import types
import unittest

import bpy
import numpy as np

import small_scenes as scenes
from aips_blender.export.domains import cached, of_domain
from aips_blender.export.film import Film
from exported_files import meshes_of
from fixture import FOLDER, exported


def link(made, output, socket, of='Principled Volume'):
    """Feeds an input of a volume's node by another node's output: (kind, name of output)."""
    tree = made.node_tree
    kind, name = output
    node = tree.nodes.new(f'ShaderNode{kind}')
    tree.links.new(node.outputs[name], tree.nodes[of].inputs[socket])
    return node


def programs(text):
    return [re.findall(r'"([^"]*)"', program) for program in
            re.findall(r'"string program" \[(.*?)\]', text)]


class Volumes(unittest.TestCase):
    def test_masks_of_one_object_within_a_volume_and_outside(self):
        scenes.clear()
        scenes.camera()
        fog = scenes.volume('fog', 'ShaderNodeVolumeScatter', Density=1)
        scenes.box('around', 3, fog, (0, 0, 0))
        scenes.boxes_of_a_collection('box', 0, 5)
        text, left_out = exported('masks', Film(8, 8, layers=('objects',)))
        self.assertEqual(text.count('ObjectInstance'), 2)
        self.assertEqual(left_out, ['masks tell objects of one name apart by a number: box 2'])
        self.assertEqual(exported('no masks')[1], [])

    def test_what_lies_in_a_volume_has_it_around(self):
        scene = scenes.stage()
        scenes.world_volume(scene, 'ShaderNodeVolumeScatter', Density=0.25, Anisotropy=0.5,
                            Color=(0.4, 0.8, 1, 1))
        fog = scenes.volume('fog', 'ShaderNodeVolumePrincipled', Density=2,
                            Color=(0.5, 0.5, 0.5, 1), Absorption_Color=(0.25, 0.25, 1, 1))
        scenes.box('fog', 3, fog, (2.5, 0, 1.5))
        glass = scenes.material('glass', 'ShaderNodeBsdfGlass', Roughness=0)
        scenes.add_volume(glass, 'ShaderNodeVolumeAbsorption', Density=2, Color=(1, 0.5, 0, 1))
        scenes.ball('inner', 0.5, glass, (2.5, 0, 1))
        scenes.light('POINT', 100, (2.5, 0, 2), shadow_soft_size=0)
        text, left_out = exported('volumes')
        self.assertEqual(left_out, [])
        self.assertIn('VolumeIntegrator "multi"', text)
        found = {name: tuple(float(x) for x in numbers.split()) for name, numbers in re.findall(
            r'MakeNamedVolume "(.*?)" .*?"color sigma_a" \[(.*?)\]', text)}
        self.assertEqual(len(found), 3)
        shapes = re.findall(r'Interior "(.*?)"\nExterior "(.*?)"\n(?:Shape|Light).*?"'
                            r'(?:string name|point from)" \[(.*?)\]', text)
        sides = {name.strip('"'): (found[i], found[e]) for i, e, name in shapes}
        self.assertEqual(sides['wall'], ((0, 0, 0), (0, 0, 0)))
        self.assertEqual(sides['fog'], ((0.5, 0.5, 0), (0, 0, 0)))
        self.assertEqual(sides['inner'], ((0.5, 1.5, 2), (0.5, 0.5, 0)))
        self.assertEqual(sides['2.5 0 2'], ((0.5, 0.5, 0), (0.5, 0.5, 0)))
        self.assertRegex(text, r'"color sigma_s" \[0.1\d* 0.2\d* 0.25\] "color g" \[0.5 0.5 0.5\]')
        self.assertTrue(text.endswith('Exterior "volume 1"\nWorldEnd\n'))  # around the camera

    def test_what_is_not_carried_over_is_told(self):
        scenes.stage()
        fog = scenes.volume('fog', 'ShaderNodeVolumePrincipled')
        scenes.plane('sheet', 1, fog, (0, 0, 1))
        _, left_out = exported('told')
        self.assertEqual(left_out, ['volumes of meshes that are not closed are left out: sheet'])

    def test_volumes_shine(self):
        scenes.stage()
        for name, kind, inputs, sent in (
                ('glow', 'ShaderNodeVolumePrincipled',
                 {'Density': 0, 'Emission_Strength': 2, 'Emission_Color': (1, 0.5, 0.25, 1)},
                 (2, 1, 0.5)),
                ('gas', 'ShaderNodeEmission', {'Strength': 3, 'Color': (0, 1, 0, 1)}, (0, 3, 0)),
                ('ember', 'ShaderNodeVolumePrincipled',
                 {'Density': 0, 'Blackbody_Intensity': 1, 'Temperature': 1000}, None)):
            scenes.clear()
            scenes.camera()
            scenes.box(name, 1, scenes.volume(name, kind, **inputs), (0, 0, 1))
            text, left_out = exported(name)
            self.assertEqual(left_out, [])
            found = re.search(r'"homogeneous".*"color emission" \[(.*?)\]', text)
            numbers = np.array([float(x) for x in found[1].split()])
            if sent is None:  # of Stefan and Boltzmann's law, of luminance 1
                power = 5.670373e-8 * 1e-6 / np.pi * 1000 ** 4
                self.assertAlmostEqual(numbers @ (0.2126, 0.7152, 0.0722) / power, 1, delta=0.01)
                self.assertGreater(numbers[0], 3 * numbers[1])
            else:
                np.testing.assert_allclose(numbers, sent, rtol=1e-5)

    def test_temperatures_that_vary_are_ramps(self):
        scenes.stage()
        fire = scenes.volume('fire', 'ShaderNodeVolumePrincipled', Density=0,
                             Blackbody_Intensity=1)
        node = link(fire, ('Math', 'Value'), 'Temperature')
        node.operation = 'MULTIPLY'
        place = fire.node_tree.nodes.new('ShaderNodeNewGeometry')
        fire.node_tree.links.new(place.outputs['Position'], node.inputs[0])
        node.inputs[1].default_value = 3000
        scenes.box('fire', 1, fire, (0, 0, 1))
        text, left_out = exported('fire')
        self.assertEqual(left_out, [])
        self.assertRegex(text, r'"heterogeneous".*"texture emission"')
        self.assertTrue(any(line.startswith('ramp linear') for program in programs(text)
                            for line in program))

    def test_volumes_that_the_scene_language_has_not_are_told(self):
        scene = scenes.stage()
        fog = scenes.volume('fog', 'ShaderNodeVolumePrincipled', Density=2)
        half = scenes.with_material(scenes.box('half', 1, fog, (0, 0, 1)), scenes.grey())
        half.data.polygons[0].material_index = 1
        cloud = scenes.box('cloud', 1, fog, (2, 0, 1))
        for frame, x in ((0, 2), (2, 3)):
            cloud.location.x = x
            cloud.keyframe_insert('location', frame=frame)
        scene.render.use_motion_blur = True
        scene.frame_set(1)
        _, left_out = exported('odd', frame_set=lambda at, sub: scene.frame_set(at, subframe=sub))
        self.assertEqual(left_out, [
            'volumes of some faces of a mesh lie behind these alone: half',
            'volumes that move hold what is in them as the shutter opens: cloud'])

    def test_what_has_no_inside_surrounds_nothing(self):
        scenes.stage()
        fog = scenes.volume('fog', 'ShaderNodeVolumePrincipled', Density=2)
        scenes.box('flat', 1, fog, (0, 0, 1)).scale = (1, 1, 0)
        clear = scenes.volume('clear', 'ShaderNodeVolumeScatter', Density=0, Anisotropy=0.5)
        scenes.box('empty', 1, clear, (2, 0, 1))
        edge = bpy.data.meshes.new('edge')
        edge.from_pydata([(0, 0, 0), (1, 0, 0)], [], [(0, 1)])
        scenes.add('edge', edge, (0, 0, 2), (0, 0, 0))
        text, left_out = exported('no inside')
        self.assertEqual(left_out, [])
        self.assertNotIn('empty', ' '.join(re.findall(r'Interior.*', text)))


class Varying(unittest.TestCase):
    def test_what_is_the_same_everywhere_stays_homogeneous(self):
        scenes.stage()
        fog = scenes.volume('fog', 'ShaderNodeVolumeScatter', Color=(0.5, 0.25, 1, 1))
        node = link(fog, ('Math', 'Value'), 'Density', 'Volume Scatter')
        node.operation = 'MULTIPLY'
        node.inputs[0].default_value, node.inputs[1].default_value = 0.5, 4
        scenes.box('fog', 1, fog, (1, 0, 1))
        text, left_out = exported('same')
        self.assertEqual(left_out, [])
        self.assertIn('"homogeneous" "color sigma_a" [0 0 0] "color sigma_s" [1 0.5 2]', text)
        self.assertNotIn('"heterogeneous"', text)

    def test_coordinates_of_objects_are_those_of_each_instance(self):
        scenes.stage()
        for coordinates, count in (('Object', 2), ('Generated', 2), ('Position', 1)):
            fog = scenes.volume('fog', 'ShaderNodeVolumePrincipled')
            if coordinates == 'Position':
                link(fog, ('NewGeometry', coordinates), 'Color')
            else:
                link(fog, ('TexCoord', coordinates), 'Color')
            scenes.instances([scenes.box('fog', 1, fog, (0, 0, 0))], -1, 2)
            text, left_out = exported('coordinates')
            self.assertEqual(left_out, [])
            self.assertEqual(text.count('"heterogeneous"'), count, coordinates)
            self.assertEqual(all(any('affine r0 1 ' in line for line in program)
                                 for program in programs(text)), coordinates != 'Position')
            self.assertNotIn('"local"', text)
            bpy.data.collections.remove(bpy.data.collections['part'])

    def test_media_add_up_where_they_overlap_and_vary(self):
        scene = scenes.stage()
        scenes.world_volume(scene, 'ShaderNodeVolumeScatter', Density=0.25, Color=(1, 1, 1, 1))
        scenes.box('cloud', 1, scenes.cloudy_volume('cloud', 2), (1, 0, 1.5))
        text, left_out = exported('overlap')
        self.assertEqual(left_out, [])
        self.assertIn(['value 0.25 0.25 0.25', 'texture 1', 'vector add r0 r1 0 0'],
                      programs(text))
        self.assertIn('"texture sigma_a" ["nodes"] "texture sigma_s" ["sum of media"]', text)

    def test_mixes_by_textures(self):
        scenes.stage()
        fog = scenes.volume('fog', 'ShaderNodeMixShader')
        tree = fog.node_tree
        mix = tree.nodes['Mix Shader']
        tree.links.new(tree.nodes.new('ShaderNodeTexNoise').outputs['Fac'], mix.inputs[0])
        for i, kind in ((1, 'VolumeAbsorption'), (2, 'VolumeScatter')):
            node = tree.nodes.new(f'ShaderNode{kind}')
            node.inputs['Color'].default_value = (0.5, 0.5, 0.5, 1)
            tree.links.new(node.outputs[0], mix.inputs[i])
        scenes.box('fog', 1, fog, (1, 0, 1))
        text, left_out = exported('mixed')
        self.assertEqual(left_out, [])
        absorbs, scatters = programs(text)
        self.assertEqual(len(absorbs), len(scatters) + 1)
        self.assertTrue(any(line.startswith('math subtract 1 ') for line in absorbs))

    def test_what_varies_but_may_not_is_told(self):
        scenes.stage()
        fog = scenes.volume('fog', 'ShaderNodeVolumePrincipled')
        link(fog, ('TexNoise', 'Fac'), 'Anisotropy')
        scenes.box('fog', 1, fog, (1, 0, 1))
        self.assertEqual(exported('told')[1],
                         ['textures of anisotropies of volumes are left out: fog'])

    def test_other_phase_functions_are_told(self):
        scenes.stage()
        fog = scenes.volume('fog', 'ShaderNodeVolumeScatter', Anisotropy=0.5)
        node = fog.node_tree.nodes['Volume Scatter']
        scenes.box('fog', 1, fog, (1, 0, 1))
        self.assertIn('"color g" [0.5 0.5 0.5]', exported('even')[0])
        if not hasattr(node, 'phase'):
            self.skipTest('this Blender has one phase function')
        node.phase = 'RAYLEIGH'
        text, left_out = exported('rayleigh')
        self.assertIn('"color g" [0 0 0]', text)
        self.assertEqual(left_out, [
            "phase functions but Henyey and Greenstein's are taken for even: fog"])


class Files(unittest.TestCase):
    def setUp(self):
        self.scene = scenes.stage()
        self.path = scenes.vdb_of_a_ball(os.path.join(FOLDER, 'ball.vdb'))
        self.smoke = scenes.volume_of_file(self.path)
        self.made = scenes.volume('smoke', 'ShaderNodeVolumePrincipled', Density=6,
                                  Color=(1, 1, 1, 1))
        self.smoke.data.materials.append(self.made)

    def grids(self, text):
        """Of each grid that is read its file, its name and the place of its origin."""
        found = re.findall(r'ConcatTransform \[([^]]*)\]\nTexture ".*?" "(float|color)" '
                           r'"densitygrid" "string filename" \["(.*?)"\] '
                           r'"string gridname" \["(.*?)"\]\nTransformEnd', text)
        return [(kind, path, name, np.array(matrix.split(), float).reshape(4, 4).T)
                for matrix, kind, path, name in found]

    def test_grids_lie_where_the_object_is(self):
        self.smoke.location, self.smoke.scale = (1, 0, 2), (2, 2, 2)
        text, left_out = exported('file')
        self.assertEqual(left_out, [])
        (kind, path, name, matrix), = self.grids(text)
        self.assertEqual((kind, path, name), ('float', 'ball.vdb', 'density'))
        np.testing.assert_allclose(matrix[:3, :3], 2 * np.eye(3), atol=1e-6)
        np.testing.assert_allclose(matrix[:3, 3], (1.1, 0.1, 2.1), atol=1e-6)  # half a voxel on
        scatters, = programs(text)
        self.assertEqual(scatters[:4], ['texture 1', 'vector multiply 6 r0 0 0',
                                        'vector multiply 1 r1 0 0', 'vector divide r2 2 0 0'])
        self.assertIn('"color sigma_a" [0 0 0]', text)  # white smoke absorbs nothing
        self.assertRegex(text, r'"border of volumes"\nInterior "volume 1"\nShape')
        box = meshes_of(text)[-1]
        for axis in 'xyz':
            self.assertLess(box[axis].min(), -0.5)
            self.assertGreater(box[axis].max(), 0.5)
        self.smoke.data.render.space = 'WORLD'
        self.assertNotIn('vector divide', exported('world')[0])

    def test_instances_have_their_own_places(self):
        scenes.instances([self.smoke], -1, 2)
        places = [matrix[0, 3] for *_, matrix in self.grids(exported('instances')[0])]
        np.testing.assert_allclose(places, (-0.95, 2.05), atol=1e-6)

    def test_grids_by_the_nodes_that_name_them(self):
        by_info = scenes.volume('info', 'ShaderNodeVolumeScatter')
        link(by_info, ('VolumeInfo', 'Density'), 'Density', 'Volume Scatter')
        by_name = scenes.volume('name', 'ShaderNodeVolumeScatter')
        link(by_name, ('Attribute', 'Fac'), 'Density', 'Volume Scatter').attribute_name = 'density'
        nothing = scenes.volume('none', 'ShaderNodeVolumeScatter')
        link(nothing, ('Attribute', 'Fac'), 'Density', 'Volume Scatter').attribute_name = 'other'
        for made, count in ((by_info, 1), (by_name, 1), (nothing, 0)):
            self.smoke.data.materials[0] = made
            text, left_out = exported('named')
            self.assertEqual(left_out, [])
            self.assertEqual((len(self.grids(text)), text.count('"heterogeneous"')),
                             (count, count), made.name)

    def test_without_a_material_smoke_is_grey(self):
        self.smoke.data.materials.clear()
        text, left_out = exported('plain')
        self.assertEqual(left_out, [])
        self.assertEqual([program[1] for program in programs(text)],
                         ['vector multiply 0.5 r0 0 0'] * 2)

    def test_frames_of_sequences(self):
        os.replace(self.path, os.path.join(FOLDER, 'ball_0007.vdb'))
        data = self.smoke.data
        data.filepath = os.path.join(FOLDER, 'ball_0001.vdb')
        data.is_sequence, data.frame_duration = True, 10
        self.scene.frame_set(7)
        text, left_out = exported('frame')
        self.assertEqual(left_out, [])
        self.assertEqual(self.grids(text)[0][1], 'ball_0007.vdb')
        self.scene.frame_set(6)
        self.assertEqual(exported('missing')[1],
                         ['volumes whose files cannot be read are left out: smoke'])

    def test_what_modifiers_make_is_written(self):
        self.smoke.data.filepath = ''
        scenes.ball('source', 0.5, scenes.grey(), (0, 0, 1))
        made = self.smoke.modifiers.new('made', 'MESH_TO_VOLUME')
        made.object = bpy.data.objects['source']
        text, left_out = exported('written')
        self.assertEqual(left_out, [])
        (_, path, name, _), = self.grids(text)
        self.assertEqual(name, 'density')
        self.assertTrue(os.path.isfile(os.path.join(FOLDER, path)), path)


class Domains(unittest.TestCase):
    """By stand-ins for Blender's settings: not every Blender without a window can simulate."""

    def files(self, *names):
        folder = os.path.join(FOLDER, 'cache')
        for name in names:
            path = os.path.join(folder, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            open(path, 'wb').close()
        return folder

    def test_files_of_a_frame(self):
        folder = self.files('data/fluid_data_0003.vdb', 'noise/fluid_noise_0003.vdb',
                            'data/fluid_data_0004.vdb')
        found = [cached(folder, frame, by_noise) for frame, by_noise in
                 ((3, True), (3, False), (4, True), (5, False))]
        self.assertEqual([each and (os.path.relpath(each[0], folder), each[1]) for each in found],
                         [('noise/fluid_noise_0003.vdb', '_noise'),
                          ('data/fluid_data_0003.vdb', ''),
                          ('data/fluid_data_0004.vdb', ''), None])

    def test_a_domain_is_filled_by_its_grid(self):
        scenes.clear()
        box = scenes.box('domain', 2, scenes.grey(), (5, 0, 0))
        box.scale = (1, 1, 2)
        bpy.context.view_layer.update()
        settings = types.SimpleNamespace(use_noise=True, noise_scale=2, flame_grid=(),
                                         domain_resolution=(16, 16, 32))
        folder = self.files('data/fluid_data_0001.vdb', 'noise/fluid_noise_0001.vdb')
        grids = of_domain(box, settings, folder, 1)
        self.assertEqual([name for name, _ in grids.by_name], ['density'])
        self.assertEqual(grids.named('density').name, 'density_noise')
        self.assertIn('color', grids.lacking)
        to_object = np.array(grids.to_object)
        # The file is as large as the domain in the world, from 0 on; cells are 1 / 8 wide.
        np.testing.assert_allclose(to_object @ (0, 0, 0, 1), (-1, -1, -1, 1))
        np.testing.assert_allclose(to_object @ (2, 2, 4, 1), (1, 1, 1, 1))
        np.testing.assert_allclose(grids.named('density').shift, 1 / 32)

    def test_smoke_without_a_cache_is_told(self):
        scenes.stage()
        box = scenes.box('domain', 2, scenes.cloudy_volume('smoke', 1), (0, 0, 1))
        domain = box.modifiers.new('fluid', 'FLUID')
        domain.show_viewport = domain.show_render = False
        domain.fluid_type = 'DOMAIN'
        self.assertEqual(exported('domain')[1],
                         ['smoke that is not in files of its cache is left out: domain'])
