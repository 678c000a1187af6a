"""Protects: a triangle takes at most 1.3 times the memory that it takes Embree alone, the scenes of
scripts/big-scenes, instanced and textured ones too, are rendered, textures in no more than their cache, and builds of
hierarchies are reckoned for more processors.

    big_scenes_test.py BUILD
"""
import importlib.machinery
import importlib.util
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv.pop(1))


def script():
    loader = importlib.machinery.SourceFileLoader('big_scenes', str(ROOT / 'scripts/big-scenes'))
    spec = importlib.util.spec_from_loader('big_scenes', loader)
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


big_scenes = script()


class BigScenes(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def peaks(self, triangles):
        """Bytes of lxsrender and of Embree alone, and the number of triangles."""
        count = big_scenes.write_mesh(self.folder, triangles)
        ours = big_scenes.lxsrender(BUILD, self.folder, '--passes', 1)
        alone = big_scenes.bare(BUILD, self.folder, 0, False)
        self.assertEqual(alone['triangles'], count)
        self.assertEqual(alone['hits'], big_scenes.WIDTH * big_scenes.HEIGHT)
        self.assertEqual(ours['scene']['triangles'], count)
        return ours['peak memory bytes'], alone['peak memory bytes'], count

    def test_a_triangle_takes_little_more_than_embree_needs(self):
        small, large = self.peaks(250_000), self.peaks(2_000_000)
        ours, alone, triangles = (b - a for a, b in zip(small, large))
        self.assertLessEqual(ours, 1.3 * alone,
                             f'{ours / triangles:.1f} bytes a triangle, Embree alone {alone / triangles:.1f}')

    def test_instances_are_placed_as_embree_places_them(self):
        count = big_scenes.write_instances(self.folder, 200_000, 100)
        ours = big_scenes.lxsrender(BUILD, self.folder, '--passes', 1)
        alone = big_scenes.bare(BUILD, self.folder, 1, True)
        self.assertGreater(alone['hits'], 0.7 * big_scenes.WIDTH * big_scenes.HEIGHT)
        self.assertEqual(ours['scene']['triangles'], count / 100)

    def test_a_build_is_divided_among_processors(self):
        big_scenes.write_mesh(self.folder, 200_000)
        reckoned = json.loads(subprocess.run([BUILD / 'bin/build-span', self.folder / 'terrain.ply'], check=True,
                                             capture_output=True).stdout)
        self.assertGreater(reckoned['tasks'], 1000)
        # Half a dozen on a machine that others keep busy; 1 where tasks begin one after the other.
        self.assertGreater(reckoned['seconds']['1'], 3 * reckoned['seconds']['64'])

    def test_textures_are_read(self):
        self.assertEqual(big_scenes.write_textures(self.folder, 1, side=256), 5)
        ours = big_scenes.lxsrender(BUILD, self.folder, '--passes', 1)
        self.assertTrue(ours['scene']['image textures'])
        self.assertEqual(ours['image']['appearance'], 'varied')

    def test_textures_beyond_their_cache_add_no_memory(self):
        cache, texels = 512 * big_scenes.MIB, 384 * big_scenes.MIB
        self.assertEqual(big_scenes.write_textures(self.folder, texels / big_scenes.MIB, times=8), 4)
        ours = big_scenes.lxsrender(BUILD, self.folder, '--passes', 1, '--width', 800)
        # As floats they have three times the cache, and nearly all of it is read.
        self.assertGreater(ours['peak memory bytes'], cache)
        self.assertLess(ours['peak memory bytes'], cache + texels)


if __name__ == '__main__':
    unittest.main()
