#!/usr/bin/env python3
"""aips in LuxRender's own process: its images, and what it refuses.

    in_luxrender_test.py LUXCONSOLE MODULE

Ends with 77, which ctest takes for skipped, where LuxRender's console or numpy is missing.
"""
import pathlib
import socket
import sys
import tempfile
import unittest

SKIPPED = 77
try:
    from luxconsole import LuxConsole, block_differences
    import numpy as np
except ImportError as missing:
    print(f'skipped: {missing}')
    sys.exit(SKIPPED)

WIDTH = 96
GROUPS = '''Film "fleximage" "integer xresolution" [96] "integer yresolution" [64]
LookAt 0 -6 3  0 0 0  0 0 1
Camera "perspective" "float fov" [40]
WorldBegin
AttributeBegin
Material "matte" "color Kd" [0.6 0.6 0.6]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-4 -4 0  4 -4 0  4 4 0  -4 4 0]
AttributeEnd
LightGroup "left"
AttributeBegin
Translate -2 0 2
AreaLightSource "area" "color L" [9 8 7] "float power" [0] "float efficacy" [0]
Shape "sphere" "float radius" [0.3]
AttributeEnd
LightGroup "right"
AttributeBegin
Translate 2 0 2
AreaLightSource "area" "color L" [3 5 9] "float power" [0] "float efficacy" [0]
Shape "sphere" "float radius" [0.3]
AttributeEnd
WorldEnd
'''
HAZE = GROUPS.replace('WorldBegin', '''WorldBegin
MakeNamedVolume "haze" "homogeneous" "float fresnel" [1] "color sigma_a" [0 0 0]
  "color sigma_s" [0.1 0.1 0.1] "color g" [0 0 0]
Exterior "haze"
''')
CLOUD = HAZE.replace('"homogeneous"', '"heterogeneous" "float stepsize" [0.5]').replace(
    '"color sigma_s" [0.1 0.1 0.1]', '"color sigma_s" [0 0 0]')


class InLuxRender(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix='aips-luxrender-')
        cls.lux = LuxConsole(PROGRAM, MODULE, cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def agree(self, scene, passes, samples, most, **more):
        """Means of blocks: their mean difference and the median of its sizes."""
        ours = self.lux.render(scene, 'aips', passes, WIDTH, **more)
        theirs = self.lux.render(scene, 'bidirectional', samples, WIDTH)
        self.assertIsNotNone(ours.image, ours.text)
        self.assertIsNotNone(theirs.image, theirs.text)
        self.assertNotIn('left out', ours.text)
        difference = block_differences(ours.image, theirs.image)
        self.assertLess(np.median(np.abs(difference)), most, difference)
        self.assertLess(abs(np.median(difference)), most, difference)
        return ours

    def test_a_box_with_a_glass_ball(self):
        """Protects radiance, photons, colours and refraction."""
        self.agree('cornell-box', 96, 150, 0.02)

    def test_light_groups(self):
        """Protects groups: both lamps are in the image, each in its own buffer."""
        ours = self.agree(GROUPS, 48, 100, 0.02)
        self.assertNotIn('ERROR', ours.text)

    def test_photons_alone(self):
        """Protects emission: without shadow rays the image is the same."""
        self.agree(GROUPS, 48, 100, 0.03, parameters='"bool directlightsampling" ["false"]')

    def test_a_film_goes_on(self):
        """Protects resuming: the film that was written is added to, by other samples."""
        resume = dict(name='resumed')
        flm = '"bool write_resume_flm" ["true"] "bool restart_resume_flm" ["false"]'
        first = self.lux.render(GROUPS, 'aips', 8, WIDTH, film_parameters=flm, **resume)
        both = self.lux.render(GROUPS, 'aips', 24, WIDTH, film_parameters=flm, **resume)
        whole = self.lux.render(GROUPS, 'aips', 192, WIDTH)
        self.assertTrue((pathlib.Path(self.folder.name) / 'resumed.flm').exists())
        error = [np.mean(np.abs(i.image - whole.image)) for i in (first, both)]
        self.assertLess(error[1], 0.8 * error[0])

    def test_threads(self):
        """Protects the bits: they are the same for any number of threads."""
        one, three = (self.lux.render('cornell-box', 'aips', 4, WIDTH, threads=n).image
                      for n in (1, 3))
        self.assertIsNotNone(one)
        self.assertIsNotNone(three)
        self.assertTrue(np.array_equal(one, three))

    def test_refusals(self):
        """Protects users: one clear message, and no image."""
        haze = self.lux.render(HAZE, 'aips', 4, WIDTH, name='haze', volumes='multi')
        self.assertIn('volumes that scatter', haze.text)
        self.assertIsNone(haze.image, haze.text)
        # It might scatter anywhere, and is not asked.
        cloud = self.lux.render(CLOUD, 'aips', 4, WIDTH, name='cloud', volumes='multi')
        self.assertIn('heterogeneous', cloud.text)
        self.assertIsNone(cloud.image, cloud.text)
        clear = self.lux.render(CLOUD, 'aips', 4, WIDTH, name='clear', volumes='emission')
        self.assertIsNotNone(clear.image, clear.text)
        alone = self.lux.render(GROUPS, 'aips', 4, WIDTH, name='alone',
                                integrator_text='Renderer "aips" SurfaceIntegrator "path"')
        self.assertIn('Renderer "aips" needs SurfaceIntegrator "aips"', alone.text)
        self.assertIsNone(alone.image, alone.text)
        other = self.lux.render(GROUPS, 'aips', 4, WIDTH, name='other',
                                integrator_text='Renderer "sampler" SurfaceIntegrator "aips"')
        self.assertIn('SurfaceIntegrator "aips" needs Renderer "aips"', other.text)
        mode = self.lux.render(GROUPS, 'aips', 4, WIDTH, name='mode',
                               parameters='"string mode" ["photonmap"]')
        self.assertIn('photonmap', mode.text)
        self.assertIsNone(mode.image, mode.text)

    def with_node(self, **of_node):
        """A render of which a node of LuxRender's network wants a part."""
        with socket.socket() as free:
            free.bind(('127.0.0.1', 0))
            port = free.getsockname()[1]
        node = self.lux.node(port, **of_node)
        try:
            return self.lux.render(GROUPS, 'aips', 4, WIDTH, name='network',
                                   arguments=['-u', f'127.0.0.1:{port}'])
        finally:
            node.kill()
            node.communicate()

    def test_network(self):
        """Protects users: a node of LuxRender's network is refused, not waited for. It may join
        before the first pass or later; what was rendered by then is kept, and is all."""
        for with_aips in (True, False):
            refused = self.with_node(with_aips=with_aips)
            self.assertIn('renders on one machine', refused.text)
            self.assertNotIn('Getting samples', refused.text)
            nothing = 'nothing is rendered' in refused.text
            self.assertEqual(refused.image is None, nothing, refused.text)


if __name__ == '__main__':
    if len(sys.argv) < 3 or not pathlib.Path(sys.argv[1]).is_file():
        print('skipped: no luxconsole; configure with -DAIPS_LUXRENDER="SOURCE;BUILD"')
        sys.exit(SKIPPED)
    PROGRAM, MODULE = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
