"""Protects F12: the image and its passes in Blender, cancelling, borders, messages of failures."""
import sys
import tempfile
import time
import unittest
from unittest import mock

import bpy
import numpy as np

import fixture
import small_scenes as scenes
from aips_blender import command, engine, exr, murmur
from fixture import FOLDER
from small_render import render, small_scene


def load_tests(loader, tests, _pattern):
    """Those of the menu and of the viewport, too."""
    tests.addTests(loader.loadTestsFromNames(['menu_test', 'viewport_test']))
    return tests


def matte(image, layer, name):
    """Share of each pixel that a mask's passes give to a name."""
    names = [f'{layer}{i:02}' for i in range(3)]
    ids, covers = ([image.channels[f'{n}.{c}'] for n in names for c in pair]
                   for pair in ('rb', 'ga'))
    found = [np.ascontiguousarray(i).view(np.uint32) == murmur.hash_of(name) for i in ids]
    return sum(f * c for f, c in zip(found, covers))


def add_matte_node(scene, name):
    """Lets the compositor show the matte of an object in place of the image."""
    scene.use_nodes = True
    nodes = scene.node_tree.nodes
    nodes.clear()
    nodes.new('CompositorNodeRLayers')  # without it nothing is rendered
    node, out = nodes.new('CompositorNodeCryptomatteV2'), nodes.new('CompositorNodeComposite')
    node.source, node.scene, node.matte_id = 'RENDER', scene, name
    scene.node_tree.links.new(node.outputs['Matte'], out.inputs['Image'])


class Renders(unittest.TestCase):
    def test_passes_are_layers(self):
        scene = small_scene(5)
        scene.aips.layers = {'albedo', 'normal', 'depth', 'direct', 'indirect', 'caustics', 'error'}
        scene.aips.denoise = scene.aips.explain = True
        bpy.ops.scene.view_layer_add_lightgroup()
        group = bpy.context.view_layer.lightgroups[0].name
        bpy.data.objects['AREA'].lightgroup = group
        image = exr.read(render('layers.exr'))
        layer = bpy.context.view_layer.name
        parts = [image.stack([f'{layer}.{p}.{c}' for c in 'RGB']) for p in
                 ('Noisy Image', 'Direct', 'Indirect', 'Caustics', group, 'Albedo', 'Combined')]
        noisy, direct, indirect, caustics, grouped, albedo, combined = parts
        np.testing.assert_allclose(direct + indirect + caustics, noisy, atol=1e-3)
        self.assertTrue(0 < grouped.mean() < noisy.mean())
        self.assertAlmostEqual(float(combined.mean() / noisy.mean()), 1, delta=0.1)
        self.assertAlmostEqual(float(np.median(albedo[-4:])), 0.6, places=2)  # the floor, below
        self.assertGreater(image.channels[f'{layer}.Normal.Z'][-1].min(), 0.9)
        depth = image.channels[f'{layer}.Depth.Z']
        self.assertLess(depth[-1].max(), depth[0].min())
        self.assertIn('photons brought', bpy.data.texts['aips explains'].as_string())

    def test_masks_are_cryptomatte(self):
        scene = small_scene(4)
        scenes.add('second box', bpy.data.objects['box'].data, (1.2, 0.3, 0.5))
        layer = bpy.context.view_layer
        layer.use_pass_cryptomatte_object = layer.use_pass_cryptomatte_material = True
        add_matte_node(scene, 'second box')
        image = exr.read(render('masks.exr'))
        floor, wall, left, right = (matte(image, f'{layer.name}.CryptoObject', name)
                                    for name in ('floor', 'wall', 'box', 'second box'))
        np.testing.assert_allclose(floor[-1], 1, atol=1e-3)
        # At the wall's edge, to the left, nothing is seen.
        np.testing.assert_allclose((floor + wall + left + right)[:, 2:], 1, atol=1e-3)
        self.assertGreater(left[:, :24].sum(), 20)
        self.assertGreater(right[:, 24:].sum(), 20)
        self.assertEqual(float(left[:, 30:].sum() + right[:, :18].sum()), 0)
        red = matte(image, f'{layer.name}.CryptoMaterial', 'red')
        np.testing.assert_allclose(red, left + right, atol=1e-3)
        # Blender's own node finds the object by its name.
        shown = image.channels['Composite.Combined.R']
        np.testing.assert_allclose(shown, right, atol=1e-3)
        names = {text: key for key, text in image.texts.items() if key.endswith('/name')}
        key = names[f'{layer.name}.CryptoObject'].replace('/name', '/manifest')
        self.assertIn(f'"second box":"{murmur.hash_of("second box"):08x}"', image.texts[key])

    def test_a_border_is_rendered_alone(self):
        scene = small_scene(64)
        whole = exr.read(render('whole.exr', 'OPEN_EXR')).stack('RGB')
        scene.render.use_border = scene.render.use_crop_to_border = True
        scene.render.border_min_x, scene.render.border_max_x = 0.26, 0.74
        scene.render.border_min_y, scene.render.border_max_y = 0.1, 0.6
        part = exr.read(render('border.exr', 'OPEN_EXR')).stack('RGB')
        rows, columns = part.shape[:2]
        x, y = int(0.26 * 48), 32 - int(0.6 * 32)
        same = whole[y:y + rows, x:x + columns]
        for found, expected in zip(np.array_split(part, 4), np.array_split(same, 4)):
            self.assertAlmostEqual(float(found.mean() / expected.mean()), 1, delta=0.05)

    def has_no_black_edge(self, size):
        image = exr.read(render('edges.exr', 'OPEN_EXR')).stack('RGB')
        self.assertEqual(image.shape[:2], (size, size))
        self.assertTrue(image[:, -1].any() and image[0].any())

    def test_sizes_and_borders_are_blenders_own(self):
        scene = small_scene(1)
        scene.render.resolution_x = scene.render.resolution_y = 100
        scene.render.resolution_percentage = 29
        self.has_no_black_edge(29)
        scene.render.resolution_percentage = 100
        scene.render.use_border = scene.render.use_crop_to_border = True
        for share in (0.7, 0.9):
            scene.render.border_min_x = scene.render.border_min_y = share - 0.2
            scene.render.border_max_x = scene.render.border_max_y = share
            self.has_no_black_edge(20)

    def test_two_view_layers(self):
        scene = small_scene()
        scene.view_layers.new('second')
        self.assertIn('second.Combined.R', exr.read(render('two.exr')).channels)


class Films(unittest.TestCase):
    def test_transparent_backgrounds_have_alpha(self):
        """Also beside the sky, which is seen in a mirror all the same."""
        scene = small_scene(8)
        wall = bpy.data.objects['wall']
        bpy.data.objects.remove(wall)
        scenes.ball('mirror', 0.6, scenes.material('mirror', 'ShaderNodeBsdfGlossy', Roughness=0),
                    (0.9, 0, 0.6))
        scene.render.film_transparent = True
        scene.render.image_settings.color_mode = 'RGBA'
        image = exr.read(render('transparent.exr', 'OPEN_EXR'))
        alpha = image.channels['A']
        self.assertEqual((alpha[0].max(), alpha[-1].min()), (0, 1))
        self.assertEqual(image.stack('RGB')[0].max(), 0)
        self.assertGreater(image.channels['G'][16, 31], 0.3)  # the sky in the mirror

    @unittest.skipUnless(hasattr(bpy.types.Scene, 'cycles'), 'Cycles is not there')
    def test_exposure_multiplies_the_image(self):
        scene = small_scene(32)
        shines = scenes.material('sheet', 'ShaderNodeEmission', Strength=2)
        scenes.plane('sheet', 1, shines, (0.9, 0.2, 1.6), (1.2, 0.3, 0))
        once, twice = [], []
        for found in (once, twice):
            found.append(exr.read(render('exposed.exr', 'OPEN_EXR')).stack('RGB').mean((0, 1)))
            scene.cycles.film_exposure = 2
        np.testing.assert_allclose(twice[0], 2 * once[0], rtol=0.02)

    def test_both_eyes_see(self):
        """The right one stands to the right, so that near things are farther to the left."""
        scene = small_scene(8)
        stereo = scene.camera.data.stereo
        stereo.interocular_distance, stereo.convergence_distance = 1, 6.7
        scene.render.use_multiview = True
        for mode in ('PARALLEL', 'OFFAXIS'):
            stereo.convergence_mode = mode
            path = render('eyes.exr', 'OPEN_EXR').replace('.exr', '')
            images = [exr.read(f'{path}_{eye}.exr').channels for eye in 'LR']
            boxes = [np.argwhere(image['R'] - 2 * image['B'] > 0.05)[:, 1] for image in images]
            self.assertGreater(min(map(len, boxes)), 20)
            moved = boxes[0].mean() - boxes[1].mean()
            print(f'[{mode}: {moved:.2f}] ', end='')
            # Of 48 pixels an image at the distance of the box, 6.6, is 5.9 wide.
            self.assertAlmostEqual(moved, {'PARALLEL': 8.1, 'OFFAXIS': 0}[mode], delta=0.7)


class Fails(unittest.TestCase):
    def fails(self, words):
        with self.assertRaisesRegex(RuntimeError, words):
            render('fails.exr')

    def test_no_program(self):
        small_scene()
        fixture.enable('/nowhere/lxsrender')
        self.fails('/nowhere/lxsrender is no program that can be run')

    def test_the_programs_own_message_is_shown(self):
        scene = small_scene()
        scene.aips.extra = '--no-such-option'
        self.fails('lxsrender ended with exit code 2: .*no-such-option')

    def test_options_that_cannot_be_read(self):
        scene = small_scene()
        scene.aips.extra = '"open'
        self.fails('More options')

    def test_another_size_than_blenders(self):
        scene = small_scene()
        scene.aips.extra = '--width 24'
        self.fails("lxsrender's image has 24 x 16 pixels, Blender's 48 x 32")

    def test_no_camera(self):
        scene = small_scene()
        bpy.data.objects.remove(scene.camera)
        self.fails('camera')

    def test_what_nobody_foresaw(self):
        small_scene()
        with mock.patch.object(engine, 'Exporting', side_effect=KeyError('Specular')):
            self.fails("aips: KeyError: 'Specular' .* the console has more")


class Asked:
    """Stands for Blender's engine: asks to stop once there is an image, and keeps what comes."""

    def __init__(self):
        self.images, self.said = 0, []

    def test_break(self):
        return self.images > 0

    def update_result(self, _result):
        self.images += 1

    def update_stats(self, _head, text):
        self.said.append(text)

    def update_progress(self, share):
        assert 0 <= share <= 1

    def begin_result(self, *_size, layer, view):
        return Result()

    def end_result(self, _result):
        self.said.append('ended')

    def report(self, kind, text):
        self.said.append(f'{kind} {text}')

    frame_set = None


class Result:
    """Without passes: nothing is kept of the image."""

    class Layer:
        passes = ()
    layers = [Layer()]
    resolution_x, resolution_y = 48, 32


class Cancels(unittest.TestCase):
    def test_cancel_ends_soon_and_keeps_the_image(self):
        small_scene(1_000_000)
        asked = Asked()
        begun = time.monotonic()
        engine.Render(asked, bpy.context.evaluated_depsgraph_get(), FOLDER).run()
        self.assertLess(time.monotonic() - begun, 30)
        self.assertGreaterEqual(asked.images, 1)
        self.assertEqual(asked.said[-1], 'ended')
        self.assertFalse([s for s in asked.said if 'ERROR' in s])


    def test_a_program_that_goes_on_is_ended(self):
        """Within two seconds, and what it has written by then is kept."""
        small_scene(1)
        asked = Asked()
        asked.test_break = lambda: any('first pass' in said for said in asked.said)
        found = engine.Render(asked, bpy.context.evaluated_depsgraph_get(), FOLDER)
        begun = time.monotonic()
        with mock.patch.object(found, '_arguments', lambda _path: [sys.executable, '-c', DEAF]):
            found.run()
        self.assertLess(time.monotonic() - begun, 4)
        self.assertEqual(asked.said[-1], 'ended')
        self.assertFalse([s for s in asked.said if 'ERROR' in s])

    def test_an_export_is_broken_off(self):
        small_scene(1)
        asked = Asked()
        asked.test_break = lambda: True
        engine.Render(asked, bpy.context.evaluated_depsgraph_get(), FOLDER).run()
        self.assertEqual(asked.said, ['aips: exporting the scene'])


DEAF = """
import signal, time
signal.signal(signal.SIGINT, signal.SIG_IGN)
time.sleep(60)
"""
PRINTS = '''
import sys, time
print('pass 46 of 110, 0:11 gone, about 0:15 left, error 13.5 %', file=sys.stderr, flush=True)
time.sleep(1)
'''


class Patient(Asked):
    """Waits for the end."""

    def test_break(self):
        return False


class Tells(unittest.TestCase):
    def rendered(self, arguments=None):
        """A render with a folder of its own, which has ended; what it told."""
        asked = Patient()
        with tempfile.TemporaryDirectory(dir=FOLDER) as folder:
            found = engine.Render(asked, bpy.context.evaluated_depsgraph_get(), folder)
            with mock.patch.object(found, '_arguments', arguments or found._arguments):
                found.run()
        return asked.said

    def test_progress_comes_without_images(self):
        small_scene(110)
        said = self.rendered(lambda _path: [sys.executable, '-c', PRINTS])
        self.assertTrue([s for s in said if 'pass 46 of 110, error 14 %' in s], said)

    def test_images_so_far_are_not_denoised(self):
        small_scene(100).aips.denoise = True
        seen = []

        def fill(_result, image, _found):
            seen.append(image)

        with mock.patch.object(engine, '_fill', fill), \
                mock.patch.object(command, 'write_every', return_value=1e-9):
            self.rendered()
        self.assertEqual(seen[-1].texts['passes'], '100')
        self.assertIn('denoised.R', seen[-1].channels)
        so_far = [image for image in seen if int(image.texts['passes']) in range(4, 100)]
        self.assertTrue(so_far)
        self.assertFalse([image for image in so_far if 'denoised.R' in image.channels])
