"""Protects images of the module of Python: the bits of lxsrender's, arrays that are no copies and
outlive what made them, statistics that are those of --stats."""
import gc
import json
import sys
import threading

import module_fixture as fixture
import numpy as np
from module_fixture import ROOT, SCENES, lxs

sys.path.insert(0, str(ROOT / 'host/blender'))
from aips_blender import exr  # noqa: E402

ROOM = {'integrator': 'aips', 'width': 48, 'seed': 7, 'set': {'aips.photonperpass': 5000}}
ROOM_OPTIONS = ('--integrator', 'aips', '--width', '48', '--seed', '7', '--set',
                'aips.photonperpass=5000')


class Images(fixture.InFolder):
    def saved(self, result):
        result.save(self.folder / 'saved.exr')
        return (self.folder / 'saved.exr').read_bytes()

    def test_file_is_that_of_lxsrender(self):
        expected = self.by_lxsrender(SCENES / 'room.lxs', *ROOM_OPTIONS, '--passes', '4',
                                     '--layers', 'all', '--denoise')
        result = lxs.load(SCENES / 'room.lxs', layers='all', denoise=True, **ROOM).render(passes=4)
        self.assertEqual(self.saved(result), expected)

    def test_arrays_are_what_the_file_has(self):
        result = lxs.load(SCENES / 'room.lxs', layers=['albedo', 'depth', 'objects'],
                          **ROOM).render(passes=3)
        result.save(self.folder / 'saved.exr')
        file = exr.read(self.folder / 'saved.exr')
        self.assertEqual(result.image.dtype, np.float32)
        np.testing.assert_array_equal(result.image, file.stack('RGB'))
        layers = result.layers
        self.assertLessEqual({'error', 'albedo', 'depth', 'CryptoObject00.A'}, set(layers))
        np.testing.assert_array_equal(layers['albedo'],
                                      file.stack(['albedo.R', 'albedo.G', 'albedo.B']))
        np.testing.assert_array_equal(layers['depth'], file.channels['depth.Z'])
        np.testing.assert_array_equal(layers['CryptoObject00.A'],
                                      file.channels['CryptoObject00.A'])
        self.assertEqual(sum(3 if layer.ndim == 3 else 1 for layer in layers.values()) + 3,
                         len(file.channels))

    def test_parts_of_the_image_and_groups_sum_to_it(self):
        scene = self.small_scene(world=fixture.WORLD + 'LightGroup "second"\n'
                                 'LightSource "point" "point from" [-2 -3 1]\n')
        result = lxs.load(scene, integrator='path').render(passes=2)
        self.assertIn('second', result.layers)
        groups = result.layers['default'] + result.layers['second']
        np.testing.assert_allclose(groups, result.image, rtol=1e-5, atol=1e-7)

    def test_arrays_are_no_copies_and_outlive_their_result(self):
        result = lxs.load(SCENES / 'room.lxs', **ROOM).render(passes=3)
        expected = result.image.copy()
        error = result.layers['error'].copy()
        image, layers = result.image, result.layers
        for array, again in ((image, result.image), (layers['error'], result.layers['error']),
                             (result.display, result.display)):
            self.assertTrue(np.shares_memory(array, again))
            self.assertFalse(array.flags.owndata)
            self.assertFalse(array.flags.writeable)
            with self.assertRaises(ValueError):
                array.flags.writeable = True
        del result, again, array
        gc.collect()
        junk = [np.full(image.shape, 7.0, np.float32) for _ in range(50)]
        np.testing.assert_array_equal(image, expected)
        np.testing.assert_array_equal(layers['error'], error)
        del junk

    def test_display_is_the_png_in_brightness(self):
        result = lxs.load(SCENES / 'room.lxs', **ROOM).render(passes=2)
        self.assertEqual(result.display.dtype, np.uint8)
        self.assertEqual(result.display.shape, result.image.shape)
        bright = result.image.sum(axis=2) > np.median(result.image.sum(axis=2))
        self.assertGreater(result.display[bright].mean(), result.display[~bright].mean())

    def test_statistics_are_those_of_lxsrender(self):
        file = self.folder / 'stats.json'
        self.by_lxsrender(SCENES / 'room.lxs', *ROOM_OPTIONS, '--passes', '3', '--stats', file)
        expected = json.loads(file.read_text())
        found = lxs.load(SCENES / 'room.lxs', **ROOM).render(passes=3).statistics
        self.assertEqual(list(found), list(expected))
        for key in ('version', 'interrupted', 'settings', 'scene', 'image', 'estimated error',
                    'refused', 'advice'):
            self.assertEqual(found[key], expected[key], key)
        for key in ('counts', 'account', 'aips'):
            self.assertEqual(list(found[key]), list(expected[key]), key)
        self.assertEqual(found['counts']['rays'], expected['counts']['rays'])
        self.assertEqual(set(expected['seconds']) - set(found['seconds']), {'checkpoint', 'write'})
        self.assertGreater(found['seconds']['render'], 0)

    def test_going_on_gives_the_same_bits(self):
        scene = lxs.load(SCENES / 'room.lxs', **ROOM)
        half = scene.render(passes=2)
        before = half.image.copy()
        whole = scene.render(passes=4)
        np.testing.assert_array_equal(half.image, before)
        self.assertFalse(np.array_equal(half.image, whole.image))
        self.assertEqual((half.passes, whole.passes), (2, 4))
        self.assertEqual(self.saved(whole),
                         self.saved(lxs.load(SCENES / 'room.lxs', **ROOM).render(passes=4)))

    def test_renders_at_the_same_time_have_their_own_bits(self):
        alone = [lxs.load(SCENES / 'room.lxs', **{**ROOM, 'seed': seed}).render(passes=2).image
                 for seed in (1, 2)]
        found = [None, None]

        def render(i):
            found[i] = lxs.load(SCENES / 'room.lxs',
                                **{**ROOM, 'seed': i + 1}).render(passes=2).image

        threads = [threading.Thread(target=render, args=(i,)) for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for i in range(2):
            np.testing.assert_array_equal(found[i], alone[i])

    def test_scenes_of_pbrt(self):
        scene = self.write('ball.pbrt', fixture.PBRT)
        expected = self.by_lxsrender(scene, '--passes', '2')
        self.assertEqual(self.saved(lxs.load(scene).render(passes=2)), expected)

    def test_textures(self):
        self.by_lxsrender(SCENES / 'room.lxs', *ROOM_OPTIONS, '--passes', '1')
        scene = self.small_scene(world=fixture.WORLD.replace(
            'Material "matte"', 'Texture "t" "color" "imagemap" "string filename" ["out.png"]\n'
            'Material "matte" "texture Kd" ["t"]'))
        image = lxs.load(scene, integrator='path').render(passes=1).image
        self.assertGreater(len(np.unique(image / (image.sum(axis=2, keepdims=True) + 1e-9))), 20)


if __name__ == '__main__':
    fixture.main()
