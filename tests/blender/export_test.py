"""Protects what an export holds: meshes, instances, lights, and what is told as left out."""
import math
import os
import re
import unittest

import bpy

import small_scenes as scenes
from aips_blender.export.film import Film
from aips_blender.export.scene import ExportError, export
from fixture import FOLDER, exported


def vertices_of(text):
    """Sizes of the vertex lists of an export's PLY files."""
    found = []
    for path in re.findall(r'"string filename" \["([^"]+\.ply)"\]', text):
        with open(os.path.join(FOLDER, path), 'rb') as file:
            found.append(int(re.search(rb'element vertex (\d+)', file.read(400)).group(1)))
    return found


def boxes_of_a_collection(name, *places):
    """Instances of a box, which is seen nowhere else, at places along x."""
    part = bpy.data.collections.new('part')
    box = scenes.box(name, 1, scenes.grey(), (0, 0, 0))
    bpy.context.collection.objects.unlink(box)
    part.objects.link(box)
    for x in places:
        empty = scenes.add('place', None, (x, 0, 0))
        empty.instance_type, empty.instance_collection = 'COLLECTION', part


class Meshes(unittest.TestCase):
    def setUp(self):
        scenes.clear()
        scenes.camera()
        scenes.light('POINT', 100, shadow_soft_size=0)

    def test_flat_and_smooth_normals(self):
        scenes.box('flat', 1, scenes.grey(), (0, 0, 0))
        text, _ = exported('flat')
        self.assertEqual(len(vertices_of(text)), 1)
        scenes.ball('smooth', 1, None, (0, 0, 0))
        bpy.data.objects.remove(bpy.data.objects['flat'])
        text, _ = exported('smooth')
        # Smooth: one normal a vertex, and more vertices only where the uv map is cut.
        self.assertLess(vertices_of(text)[0], 49 * 25 + 48)

    def test_modifiers_are_applied(self):
        box = scenes.box('box', 1, scenes.grey(), (0, 0, 0))
        before = vertices_of(exported('plain')[0])[0]
        box.modifiers.new('subdivided', 'SUBSURF').levels = 2
        self.assertGreater(vertices_of(exported('subdivided')[0])[0], 3 * before)

    def test_what_is_used_often_is_an_object(self):
        box = scenes.box('box', 1, scenes.grey(), (0, 0, 0))
        for x in (2, 4):
            scenes.add('copy', box.data, (x, 0, 0))
        text, _ = exported('instances')
        self.assertEqual(len(vertices_of(text)), 1)
        self.assertEqual(text.count('ObjectInstance'), 3)

    def test_instances_of_a_collection(self):
        boxes_of_a_collection('box', 0, 3)
        self.assertEqual(exported('collection')[0].count('ObjectInstance'), 2)

    def test_one_file_for_each_material(self):
        box = scenes.box('box', 1, scenes.grey(), (0, 0, 0))
        box.data.materials.append(scenes.material('other', 'ShaderNodeBsdfDiffuse'))
        box.data.polygons[0].material_index = 1
        self.assertEqual(sorted(vertices_of(exported('slots')[0])), [4, 20])

    def test_what_is_empty_or_hidden_is_not_there(self):
        scenes.add('nothing', bpy.data.meshes.new('nothing'))
        scenes.box('hidden', 1, scenes.grey(), (0, 0, 0)).hide_set(True)
        self.assertNotIn('plymesh', exported('empty')[0])


class Lights(unittest.TestCase):
    def test_lights_hidden_from_the_camera(self):
        scene = scenes.stage()
        scenes.background(scene, (1, 1, 1), 1)
        scenes.light('SUN', 2, angle=0.1)
        scenes.light('AREA', 10).data.cycles.cast_shadow = False
        scenes.light('POINT', 10, shadow_soft_size=0.1).visible_camera = True
        scene.world.cycles_visibility.camera = False
        text, left_out = exported('hidden')
        self.assertEqual(left_out, ['lights without shadows cast them: AREA'])
        shines = [line for line in text.splitlines() if line.startswith(('Area', 'LightSource'))]
        self.assertEqual(['"bool hidden" ["true"]' in line for line in shines],
                         [True, True, True, False])


class LeftOut(unittest.TestCase):
    def test_each_kind_is_told_once_by_name(self):
        scenes.stage()
        lamps = [scenes.light('AREA', 10, (x, 0, 3), spread=1.0) for x in (0, 1)]
        for lamp in lamps:
            lamp.visible_camera = True
        made = scenes.material('bumpy', 'ShaderNodeBsdfDiffuse')
        noise = made.node_tree.nodes.new('ShaderNodeTexNoise')
        made.node_tree.links.new(noise.outputs['Color'],
                                 made.node_tree.nodes['Diffuse BSDF'].inputs['Color'])
        scenes.box('noisy', 1, made, (2, 0, 0))
        bpy.data.objects['box'].visible_camera = False
        bpy.data.objects['wall'].is_holdout = True
        lamps[0].visible_glossy = False
        ball = scenes.ball('furry', 0.3, scenes.grey(), (0, 0, 0))
        ball.modifiers.new('hair', 'PARTICLE_SYSTEM').particle_system.settings.type = 'HAIR'
        scenes.add('curls', bpy.data.hair_curves.new('curls'))
        _, lines = exported('left out')
        for line in ('hair is left out: furry, curls',
                     'what is hidden from some rays is seen by all: box',
                     'holdouts and shadow catchers are shown as objects: wall',
                     'lights hidden from some rays shine on all: AREA'):
            self.assertIn(line, lines)
        self.assertIn('spreads of area lights are left out: AREA, AREA.001', lines)
        self.assertTrue(any(line.startswith('nodes Noise Texture are replaced by grey')
                            for line in lines))

    def test_a_folder_that_cannot_be_written(self):
        scenes.stage()
        blocked = os.path.join(FOLDER, 'file')
        with open(blocked, 'w', encoding='utf-8'):
            pass
        with self.assertRaisesRegex(ExportError, 'cannot be written'):
            export(os.path.join(blocked, 'scene.lxs'), bpy.context.evaluated_depsgraph_get(),
                   Film(8, 8))

    def test_no_camera(self):
        scenes.clear()
        with self.assertRaisesRegex(ExportError, 'no camera'):
            exported('no camera')


class Volumes(unittest.TestCase):
    def test_masks_of_one_object_within_a_volume_and_outside(self):
        scenes.clear()
        scenes.camera()
        fog = scenes.volume('fog', 'ShaderNodeVolumeScatter', Density=1)
        scenes.box('around', 3, fog, (0, 0, 0))
        boxes_of_a_collection('box', 0, 5)
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


class Materials(unittest.TestCase):
    def test_groups_and_reroutes_are_looked_through(self):
        scenes.stage()
        group = bpy.data.node_groups.new('paint', 'ShaderNodeTree')
        group.inputs.new('NodeSocketColor', 'Tint')
        group.outputs.new('NodeSocketShader', 'Surface')
        inside, out = group.nodes.new('NodeGroupInput'), group.nodes.new('NodeGroupOutput')
        diffuse = group.nodes.new('ShaderNodeBsdfDiffuse')
        group.links.new(inside.outputs[0], diffuse.inputs['Color'])
        group.links.new(diffuse.outputs[0], out.inputs[0])
        made = bpy.data.materials.new('grouped')
        made.use_nodes = True
        tree = made.node_tree
        node, reroute = tree.nodes.new('ShaderNodeGroup'), tree.nodes.new('NodeReroute')
        node.node_tree = group
        node.inputs['Tint'].default_value = (0.25, 0.25, 0.25, 1)
        tree.links.new(node.outputs[0], reroute.inputs[0])
        tree.links.new(reroute.outputs[0], tree.nodes['Material Output'].inputs['Surface'])
        scenes.box('grouped', 1, made, (2, 0, 0))
        text, left_out = exported('grouped')
        self.assertIn('"grouped" "string type" ["matte"] "color Kd" [0.25 0.25 0.25]', text)
        self.assertEqual(left_out, [])

    def test_emission_of_principled_shines(self):
        scenes.stage()
        made = scenes.material('glows', 'ShaderNodeBsdfPrincipled', Emission=(1, 1, 1, 1),
                               Emission_Strength=3.0)
        scenes.box('glows', 1, made, (2, 0, 0))
        self.assertRegex(exported('glows')[0], r'AreaLightSource "area" "color L" \[3 3 3\]')


class Cameras(unittest.TestCase):
    def test_field_of_view_is_that_of_the_shorter_axis(self):
        scenes.stage()
        text, _ = exported('fov', Film(64, 32))
        found = float(re.search(r'"float fov" \[([\d.]+)\]', text).group(1))
        expected = 2 * math.atan(36 / 40 / 2 / 2)
        self.assertAlmostEqual(math.radians(found), expected, places=5)

    def test_light_groups(self):
        scene = scenes.stage()
        lamp = scenes.light('POINT', 10)
        bpy.ops.scene.view_layer_add_lightgroup()
        name = bpy.context.view_layer.lightgroups[0].name
        lamp.lightgroup = scene.world.lightgroup = name
        scenes.background(scene, (1, 1, 1), 1.0)
        self.assertEqual(exported('groups')[0].count(f'LightGroup "{name}"'), 2)
