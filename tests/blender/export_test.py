"""Protects what an export holds: meshes, instances, lights, and what is told as left out."""
import math
import os
import re
import unittest

import bpy

import small_scenes as scenes
from aips_blender.export.camera import View
from aips_blender.export.film import Film
from aips_blender.export.scene import ExportError, export
from exported_files import lines_of, render, vertices_of
from fixture import FOLDER, exported


def load_tests(loader, tests, _pattern):
    """Those of the other modules about exports, too."""
    tests.addTests(loader.loadTestsFromNames(['export_volumes_test', 'export_materials_test',
                                             'hair_test', 'kept_test']))
    return tests


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
        scenes.boxes_of_a_collection('box', 0, 3)
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


    def test_triangles_without_area_are_left_out_in_silence(self):
        mesh = bpy.data.meshes.new('flat')
        mesh.from_pydata([(0, 0, 1), (1, 0, 1), (1, 1, 1), (2, 0, 1)], [], [(0, 1, 2), (0, 1, 3)])
        scenes.add('flat', mesh)
        scenes.background(bpy.context.scene, (1, 1, 1), 1)
        text, left_out = exported('no area', Film(8, 8, passes=1))
        self.assertEqual((vertices_of(text), left_out), ([3], []))
        render('no area')


class Curves(unittest.TestCase):
    """Blender yields texts and the like as themselves, and again as instances of their meshes."""

    def setUp(self):
        scenes.clear()
        scenes.camera()
        scenes.light('POINT', 100, shadow_soft_size=0)

    def test_each_kind_appears_once(self):
        scenes.text('a', (0, 0, 0))
        bpy.ops.curve.primitive_bezier_curve_add()  # without a bevel there is nothing to see
        for x in (2, 3):
            bpy.ops.object.metaball_add(location=(x, 0, 0))  # both make one mesh
        bpy.ops.surface.primitive_nurbs_surface_sphere_add(location=(6, 0, 0))
        bpy.ops.curve.primitive_bezier_circle_add(location=(9, 0, 0))
        bpy.context.object.data.bevel_depth = 0.1
        bpy.context.object.name = 'circle'
        text, left_out = exported('kinds')
        self.assertEqual(re.findall(r'"string name" \["(.*?)"\]', text),
                         ['text a', 'Mball', 'SurfSphere', 'circle'])
        self.assertEqual(left_out, [])

    def test_texts_of_a_collection_have_their_own_shapes(self):
        scene = bpy.context.scene
        texts = [scenes.text(body, (x, 0, 0)) for x, body in enumerate('i8%')]
        texts[2].keyframe_insert('location', frame=0)
        texts[2].location.x += 1
        texts[2].keyframe_insert('location', frame=2)
        scenes.instances(texts, 0, 5)
        scene.render.use_motion_blur = True
        scene.frame_set(1)
        text, _ = exported('texts', frame_set=lambda at, part: scene.frame_set(at, subframe=part))
        self.assertEqual(len(set(vertices_of(text))), 3)
        self.assertEqual(text.count('ObjectInstance'), 6)
        self.assertEqual(text.count('MotionBegin'), 2)  # of one text at both places


POINTS = {kind: {'shadow_soft_size': 0} for kind in ('POINT', 'SPOT')}


class Flattened(unittest.TestCase):
    def setUp(self):
        self.scene = scenes.clear()
        scenes.background(self.scene, (1, 1, 1), 1)
        scenes.camera((0, 0, 5), (0, 0, 0), lens=36)  # sees two and a half to either side

    def test_what_is_flat_is_seen_and_what_is_a_line_is_not(self):
        black = scenes.grey(0)
        for x, y, scale in ((0, 0, (1, 1, 0)), (2, 0, (0, 0, 0)), (0, 2, (2, 0, 0))):
            scenes.box('box', 1, black, (x, y, 0), (0, 0, 0.3)).scale = scale
        grows = scenes.box('grows', 1, black, (-2, 0, 0))
        for frame, size in ((0, (1, 1, 0)), (2, (0, 0, 0))):
            grows.scale = size
            grows.keyframe_insert('scale', frame=frame)
        self.scene.render.use_motion_blur, self.scene.render.motion_blur_shutter = True, 2
        self.scene.frame_set(1)
        text, _ = exported('flat', Film(40, 40, passes=16, integrator='path'), frame_set=lambda
                           at, part: self.scene.frame_set(at, subframe=part))
        self.assertEqual(text.count('plymesh'), 2)
        image = render('flat').mean(-1)
        self.assertLess(image[18:22, 18:22].max(), 0.01)
        self.assertEqual([float(image[rows, columns].min().round(3)) for rows, columns in
                          ((slice(0, 13), slice(40)), (slice(40), slice(27, 40)))], [1, 1])
        self.assertTrue(0.1 < image[20, 4] < 0.9)  # there for a part of the time

    def test_lights(self):
        for kind in ('POINT', 'SPOT', 'SUN', 'AREA'):
            for scale in ((0, 0, 0), (1, 1, 0), (0, 0, 1), (-1, 2, 3)):
                scenes.light(kind, 10, **POINTS.get(kind, {})).scale = scale
        scenes.plane('floor', 4, scenes.grey())
        text, _ = exported('lamps', Film(8, 8, passes=1))
        self.assertEqual([text.count(f'LightSource "{kind}"') for kind in
                          ('point', 'goniometric', 'distant', 'area')], [4, 2, 2, 2])
        render('lamps')


class Lights(unittest.TestCase):
    def test_lights_hidden_from_the_camera(self):
        scene = scenes.stage()
        scenes.background(scene, (1, 1, 1), 1)
        scenes.light('SUN', 2, angle=0.1)
        area = scenes.light('AREA', 10).data
        if hasattr(area.cycles, 'cast_shadow'):
            area.cycles.cast_shadow = False
        else:  # from Blender 4.2 on
            area.use_shadow = False
        scenes.light('POINT', 10, shadow_soft_size=0.1).visible_camera = True
        scene.world.cycles_visibility.camera = False
        text, left_out = exported('hidden')
        self.assertEqual(left_out, ['lights without shadows cast them: AREA'])
        shines = [line for line in text.splitlines() if line.startswith(('Area', 'LightSource'))]
        self.assertEqual(['"bool hidden" ["true"]' in line for line in shines],
                         [True, True, True, False])


    def test_spots_with_a_radius_are_discs(self):
        """Which send as much light on their axis as without."""
        scenes.stage()
        spot = scenes.light('SPOT', 10, shadow_soft_size=0.5, spot_size=2).data
        text, left_out = exported('disc')
        self.assertEqual(left_out, [])
        gain = re.search(r'AreaLightSource .*"float gain" \[(.*?)\].*"string mapname"', text)
        spot.shadow_soft_size = 0
        without = re.search(r'"goniometric" .*"float gain" \[(.*?)\]', exported('point')[0])
        self.assertAlmostEqual(float(gain.group(1)) * math.pi * 0.25 / 4,
                               float(without.group(1)), places=5)
        self.assertIn('Shape "disk" "float radius" [0.5]', text)


class LeftOut(unittest.TestCase):
    def test_each_kind_is_told_once_by_name(self):
        scenes.stage()
        lamps = [scenes.light('AREA', 10, (x, 0, 3)) for x in (0, 1)]
        for lamp in lamps:
            lamp.visible_camera = True
        made = scenes.material('bumpy', 'ShaderNodeBsdfDiffuse')
        noise = made.node_tree.nodes.new('ShaderNodeWavelength')
        made.node_tree.links.new(noise.outputs['Color'],
                                 made.node_tree.nodes['Diffuse BSDF'].inputs['Color'])
        scenes.box('noisy', 1, made, (2, 0, 0))
        bpy.data.objects['box'].visible_camera = False
        bpy.data.objects['wall'].is_holdout = True
        lamps[0].visible_glossy = lamps[1].visible_glossy = False
        scenes.move_to_collection(scenes.box('cut out', 1, None, (3, 0, 0)), holdout=True)
        scenes.move_to_collection(scenes.box('mirrored', 1, None, (3, 0, 2)), indirect_only=True)
        lens = bpy.context.scene.camera.data
        lens.type, lens.dof.use_dof, lens.dof.aperture_blades = 'ORTHO', True, 6
        text, lines = exported('left out')
        self.assertNotIn('blades', text)
        for line in ('blades of orthographic cameras are left out: Camera',
                     'what is hidden from some rays is seen by all: mirrored, box',
                     'holdouts and shadow catchers are shown as objects: cut out, wall',
                     'lights hidden from some rays shine on all: AREA, AREA.001'):
            self.assertIn(line, lines)
        self.assertTrue(any(line.startswith('nodes Wavelength are replaced by grey')
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


class Cameras(unittest.TestCase):
    def test_field_of_view_is_that_of_the_shorter_axis(self):
        scenes.stage()
        text, _ = exported('fov', Film(64, 32))
        found = float(re.search(r'"float fov" \[([\d.]+)\]', text).group(1))
        expected = 2 * math.atan(36 / 40 / 2 / 2)
        self.assertAlmostEqual(math.radians(found), expected, places=5)
        self.assertIn('Renderer "aips"\nSurfaceIntegrator "aips"', text)

    def test_another_look_at_what_is_written(self):
        scenes.lit_stage()
        for density, size in ((1, 4), (2, 2)):
            fog = scenes.volume('fog', 'ShaderNodeVolumeAbsorption', Density=density)
            scenes.box('fog', size, fog, (0, 0, 3.5))
        path = os.path.join(FOLDER, 'look.lxs')
        result = export(path, bpy.context.evaluated_depsgraph_get(), Film(32, 32))
        before = lines_of(path)
        scenes.clear()  # what Blender has now is not looked at
        place = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 3], [0, 0, 0, 1]]
        view = View('orthographic', (-2, 2, -1, 1), near=0.1, far=100)
        result.look(Film(16, 8, passes=1), view, (place,))
        after = lines_of(path)
        self.assertRegex(' '.join(after[-2:]), 'Exterior "volume [12]" WorldEnd')
        self.assertEqual([line for line in before if line not in after and 'Film' not in line],
                         [line for line in before if line.startswith(('LookAt', 'Camera'))])
        render('look')

    def test_light_groups(self):
        scene = scenes.stage()
        lamp = scenes.light('POINT', 10)
        bpy.ops.scene.view_layer_add_lightgroup()
        name = bpy.context.view_layer.lightgroups[0].name
        lamp.lightgroup = scene.world.lightgroup = name
        scenes.background(scene, (1, 1, 1), 1.0)
        self.assertEqual(exported('groups')[0].count(f'LightGroup "{name}"'), 2)
