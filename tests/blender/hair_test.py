"""Protects hair: strands are tubes of their widths, and look as Cycles' from afar."""
import math
import unittest

import bpy
import numpy as np

import small_scenes as scenes
from aips_blender.export import strands
from cycles_agreement import differences
from exported_files import meshes_of
from fixture import exported


def helix(count):
    """One strand that winds about z twice, of radius 0.05 at its root and none at its tip."""
    t = np.linspace(0, 1, count)
    points = np.column_stack([np.cos(4 * np.pi * t), np.sin(4 * np.pi * t), t])
    return strands.Strands(points, 0.005 * (1 - t), np.array([0, count]))


class Tubes(unittest.TestCase):
    def test_faces_look_outwards_and_no_tube_twists(self):
        rows, faces = strands.tubes(helix(40))
        corners = rows[faces]
        normals = np.cross(corners[:, 1, :3] - corners[:, 0, :3],
                           corners[:, 2, :3] - corners[:, 0, :3])
        self.assertGreater((normals * corners[..., 3:6].sum(axis=1)).sum(axis=1).min(), 0)
        # From one ring to the next a normal turns no more than the strand does.
        rings = rows[:, 3:6].reshape(-1, 3, 3)
        self.assertGreater((rings[1:] * rings[:-1]).sum(axis=-1).min(), 0.7)

    def test_strands_of_any_number_of_points_stay_apart(self):
        both = strands.Strands(np.array([(0, 0, 0), (0, 0, 1), (5, 0, 0), (5, 0, 1), (5, 0, 2),
                                         (9, 9, 9), (9, 9, 9)], float),
                               np.full(7, 0.001), np.array([0, 2, 5, 7]),
                               np.array([(0, 0.25), (1, 0.75), (0, 0)]))
        rows, faces = strands.tubes(both)
        self.assertEqual((len(rows), len(faces)), (15, 18))  # what has no length is left out
        self.assertLess(np.ptp(rows[faces][..., 0], axis=1).max(), 0.1)
        self.assertEqual([set(part) for part in np.split(rows[:, 7], [6])], [{0.25}, {0.75}])

    def test_bends_are_round(self):
        corner = strands.Strands(np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (2, 1, 0)], float),
                                 np.full(4, 0.001), np.array([0, 4]))
        rows, _ = strands.tubes(corner)
        self.assertEqual(len(rows), 3 * (3 * strands.MOST_PIECES + 1))


def furry(count, width=0.006):
    """A ball with hair that stands up, and its settings."""
    ball = scenes.ball('furry', 0.5, scenes.material('fur', 'ShaderNodeBsdfDiffuse',
                                                     Color=(0.7, 0.5, 0.3, 1)), (0.8, 0, 0.8))
    system = ball.modifiers.new('hair', 'PARTICLE_SYSTEM').particle_system
    settings = system.settings
    settings.type, settings.count, settings.hair_length = 'HAIR', count, 0.4
    settings.root_radius, settings.tip_radius, settings.radius_scale = 1.0, 0.5, width
    settings.use_close_tip, settings.display_step = False, settings.render_step
    return settings


class Hair(unittest.TestCase):
    def test_particles_are_tubes_of_their_width(self):
        scenes.lit_stage()
        settings = furry(10)
        text, left_out = exported('hair')
        self.assertEqual(left_out, [])
        hair = meshes_of(text)[-1]
        self.assertEqual(len(hair['x']), 10 * 3 * (2 ** settings.display_step + 1))
        place = np.stack([hair[a] for a in 'xyz'], axis=-1).reshape(10, -1, 3, 3)
        side = np.linalg.norm(place[:, :, 0] - place[:, :, 1], axis=-1)
        self.assertAlmostEqual(float(side[:, 0].mean() * 3 / (2 * math.pi)), 0.003, places=5)
        self.assertAlmostEqual(float(side[:, -1].mean() * 3 / (2 * math.pi)), 0.0015, places=5)
        roots = place[:, 0].mean(axis=1)
        np.testing.assert_allclose(np.linalg.norm(roots, axis=1), 0.5, atol=0.01)

    def test_children_and_instances(self):
        scenes.lit_stage()
        settings = furry(10)
        settings.child_type = 'INTERPOLATED'
        setattr(settings, 'child_nbr' if hasattr(settings, 'child_nbr') else 'child_percent', 5)
        bpy.data.objects['furry'].show_instancer_for_render = False
        bpy.data.objects['furry'].show_instancer_for_viewport = False
        scenes.instances([bpy.data.objects['furry']], 0, 3)
        text, left_out = exported('children')
        self.assertEqual(left_out, [])
        self.assertEqual(len(meshes_of(text)[-1]['x']), 50 * 3 * (2 ** settings.display_step + 1))
        self.assertEqual(text.count('ObjectInstance'), 2)

    def test_curves(self):
        scenes.lit_stage()
        scenes.add('none', bpy.data.hair_curves.new('none'))
        bpy.ops.object.curves_random_add()
        thing = bpy.context.object
        text, left_out = exported('curves')
        self.assertEqual(left_out, [])
        count = len(thing.data.curves)
        self.assertGreater(count, 50)
        self.assertEqual(len(meshes_of(text)[-1]['x']) % 3, 0)
        self.assertGreaterEqual(len(meshes_of(text)[-1]['x']), 3 * len(thing.data.points))

    def test_pigments_have_the_colour_of_hair_in_the_mass(self):
        """Cycles' own way from a colour to absorption, turned round."""
        scenes.lit_stage()
        furry(2)
        ball = bpy.data.objects['furry']
        kd = []
        for kind in ('COLOR', 'ABSORPTION', 'MELANIN'):
            made = scenes.material(kind, 'ShaderNodeBsdfHairPrincipled')
            node = made.node_tree.nodes[0]
            node.parametrization = kind
            inputs = {socket.name: socket for socket in node.inputs}  # those that are off, too
            inputs['Color'].default_value = (0.5, 0.25, 0.125, 1)
            inputs['Radial Roughness'].default_value = 0.3
            inputs['Absorption Coefficient'].default_value = [
                (math.log(c) / (5.969 - 0.215 * 0.3 + 2.532 * 0.09 - 10.73 * 0.027 +
                                5.574 * 0.0081 + 0.245 * 0.00243)) ** 2 for c in (0.5, 0.25, 0.125)]
            inputs['Melanin'].default_value = 0.0
            ball.data.materials[0] = made
            text, left_out = exported('pigments')
            self.assertEqual(left_out, ['Principled Hair is approximated by glossy fibres that let '
                                        f'half of their light through: {kind}'])
            kd.append(text.split('glossytranslucent')[1].split('"color Kd" [')[1].split(']')[0])
        self.assertEqual(kd[0], kd[1])
        self.assertEqual(kd[2], '0.5 0.5 0.5')

    @unittest.skipUnless(hasattr(bpy.types.Scene, 'cycles'), 'Cycles is not there')
    def test_a_furry_ball_agrees_with_cycles(self):
        scene = scenes.lit_stage()
        furry(400, 0.03)
        scene.cycles_curves.shape = 'THICK'
        found = differences('fur', scene, 'path')
        print(f'[mean {100 * found.mean():+.2f} %, worst {100 * abs(found).max():.2f} %] ', end='')
        self.assertLess(np.abs(found).max(), 0.03)
