"""Protects volumes: what an export has around its shapes and lights, and what is told of them."""
import re
import unittest

import bpy

import small_scenes as scenes
from aips_blender.export.film import Film
from fixture import exported


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
        fog = scenes.volume('fog', 'ShaderNodeVolumePrincipled', Emission_Strength=1.0)
        scenes.plane('sheet', 1, fog, (0, 0, 1))
        _, left_out = exported('told')
        self.assertEqual(left_out, ['light of volumes is left out: fog',
                                    'volumes of meshes that are not closed are left out: sheet'])

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
