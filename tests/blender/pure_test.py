"""Protects the parts of the add-on that know nothing of Blender: files, texts, process."""
import os
import sys
import time
import unittest
from types import SimpleNamespace
from unittest import mock

import numpy as np

from aips_blender import command, exr, murmur, passes, process, reasons, status
from aips_blender.export import colours, lights, ply, versions
from aips_blender.export.camera import View, window_of
from aips_blender.export.film import Film
from aips_blender.export.folded import folded, shortened
from aips_blender.export.left_out import LeftOut
from aips_blender.export.lxs_text import LxsText, parameter
from aips_blender.export.media import CLEAR, Medium, both
from aips_blender.export.shapes import Placed
from aips_blender.export.spaces import Space, Spaces
from fixture import FOLDER


class Exr(unittest.TestCase):
    def test_what_is_written_is_read(self):
        rgb = np.random.default_rng(1).random((5, 7, 3)).astype(np.float32)
        path = os.path.join(FOLDER, 'written.exr')
        exr.write(path, rgb)
        np.testing.assert_array_equal(exr.read(path).stack('RGB'), rgb)

    def test_a_damaged_file_has_a_clear_message(self):
        path = os.path.join(FOLDER, 'damaged.exr')
        exr.write(path, np.ones((4, 4, 3), np.float32))
        with open(path, 'rb') as file:
            data = file.read()
        for length in (0, 3, 20, 200, len(data) - 8):
            with open(path, 'wb') as file:
                file.write(data[:length])
            with self.assertRaisesRegex(exr.ExrError, 'damaged.exr is not an EXR file'):
                exr.read(path)


def has(**paths):
    """Something with settings by their paths, in which __ stands for a dot."""
    made = SimpleNamespace()
    for path, value in paths.items():
        *owners, name = path.split('__')
        at = made
        for owner in owners:
            at.__dict__.setdefault(owner, SimpleNamespace())
            at = getattr(at, owner)
        setattr(at, name, value)
    return made


class Versions(unittest.TestCase):
    """What Blender's versions keep in different places is found in each."""

    def test_what_was_cycles_own_is_found_in_its_new_place_too(self):
        for read, old, new, value in (
                (versions.motion_blur_position, 'cycles__motion_blur_position',
                 'render__motion_blur_position', 'START'),
                (versions.panorama_type, 'cycles__panorama_type', 'panorama_type',
                 'EQUIRECTANGULAR'),
                (versions.casts_shadow, 'cycles__cast_shadow', 'use_shadow', False)):
            for path in (old, new):
                self.assertEqual(read(has(**{'render__engine': '', path: value})), value)
        # Until it was Cycles' too, the second was Eevee's alone.
        self.assertTrue(versions.casts_shadow(has(cycles__cast_shadow=True, use_shadow=False)))

    def test_exposure_and_temperature_of_lights(self):
        self.assertEqual(versions.light_scale(has()), (1, 1, 1))
        bright = versions.light_scale(has(exposure=1.0, use_temperature=True, temperature=3500.0))
        np.testing.assert_allclose(bright, (3.13, 1.79, 0.81), atol=0.02)
        self.assertEqual(versions.light_scale(has(exposure=-1, use_temperature=False)), (0.5,) * 3)

    def test_nodes_that_nobody_switches_on(self):
        self.assertTrue(versions.uses_nodes(has(node_tree=1)))
        self.assertFalse(versions.uses_nodes(has(node_tree=None)))
        self.assertFalse(versions.uses_nodes(has(node_tree=1, use_nodes=False)))


class Reasons(unittest.TestCase):
    def test_one_line_whatever_was_raised(self):
        self.assertEqual(reasons.reason(exr.ExrError('as it is')), 'as it is')
        try:
            raise KeyError('Specular')
        except KeyError as error:
            with mock.patch('traceback.print_exception') as printed:
                said = reasons.reason(error)
        self.assertRegex(said, r"^KeyError: 'Specular' \(test_one_line.*, line \d+\); the console")
        printed.assert_called_once()


class Text(unittest.TestCase):
    def test_numbers_strings_and_bools(self):
        self.assertEqual(parameter('float', 'a', 0.1), '"float a" [0.1]')
        self.assertEqual(parameter('integer', 'a', (1, 2)), '"integer a" [1 2]')
        self.assertEqual(parameter('bool', 'a', True), '"bool a" ["true"]')
        self.assertEqual(parameter('string', 'a', 'say "x"\n\\'), '"string a" ["say \'x\' /"]')

    def test_names_are_given_once(self):
        text = LxsText(FOLDER)
        self.assertEqual([text.free_name('a') for _ in range(3)], ['a', 'a 2', 'a 3'])
        self.assertEqual(text.free_name('a', 'material'), 'a')

    def test_matrices_are_written_by_columns(self):
        text = LxsText(FOLDER)
        text.matrix('Transform', [[1, 0, 0, 7], [0, 1, 0, 8], [0, 0, 1, 9], [0, 0, 0, 1]])
        self.assertEqual(text.lines, ['Transform [1 0 0 0 0 1 0 0 0 0 1 0 7 8 9 1]'])

    def test_left_out_names_each_kind_once(self):
        left_out = LeftOut()
        for name in ('a', 'b', 'a', 'c', 'd', 'e', 'f', 'g'):
            left_out.add('hair is left out', name)
        self.assertEqual(left_out.lines(), ['hair is left out: a, b, c, d, e and 2 more'])


class Formulas(unittest.TestCase):
    def test_light_colours_shine_as_wanted(self):
        for wanted in ((1, 1, 1), (1, 0.5, 0.2), (0.3, 0.4, 0.9), (2, 3, 1)):
            shown = colours.shown(np.array(colours.light_color(wanted)), colours.LIGHTS)
            np.testing.assert_allclose(shown, wanted, atol=1e-5)

    def test_images_have_the_colours_of_surfaces(self):
        values = np.array([[[0.8, 0.3, 0.2], [0.2, 0.2, 0.2]], [[0.1, 0.5, 0.9], [0.3, 0.6, 0.3]]])
        image = colours.written(values, colours.SURFACES, np.inf)
        np.testing.assert_allclose(colours.shown(image, colours.SURFACES), values, atol=1e-5)
        np.testing.assert_allclose(image[0, 0], colours.surface_color(values[0, 0]), atol=1e-6)

    def test_mean_of_a_narrow_spot(self):
        rim = np.cos(0.3)
        flat = lights.sphere_mean(np.where(lights.spot_profile(rim, 0.0, 8192, True) > 0, 1.0, 0.0))
        self.assertAlmostEqual(flat, (1 - rim) / 2, places=4)

    def test_welded_corners_give_the_same_triangles(self):
        corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0], [1, 1, 0], [0, 1, 0]],
                           float)
        rows, triangles = ply.welded(corners)
        self.assertEqual(len(rows), 4)
        np.testing.assert_array_equal(rows[triangles.ravel()], corners)

    def test_window_of_a_projection(self):
        # 90 degrees wide, twice as wide as high, shifted by a quarter of its width to the right
        matrix = [[1, 0, 0.5, 0], [0, 2, 0, 0], [0, 0, -1, 0], [0, 0, -1, 0]]
        self.assertEqual(window_of(matrix, False), (-0.5, 1.5, -0.5, 0.5))
        found = View('perspective', (-0.5, 1.5, -0.5, 0.5)).parameters()
        self.assertIn('"float screenwindow" [-1 3 -1 1]', found)


class Masks(unittest.TestCase):
    def test_hashes_of_masks(self):
        # Those of the specification's example, and of the empty text.
        self.assertEqual([murmur.hash_of(t) for t in ('', 'hello', 'hello, world')],
                         [0, 0x248bfa47, 0x149bbb7f])

    def test_the_image_so_far_has_names_of_masks_for_blender(self):
        texts = {'cryptomatte/1234567/name': 'CryptoObject', 'cryptomatte/1234567/hash': 'm',
                 'cryptomatte/1234567/conversion': 'u', 'cryptomatte/1234567/manifest': '{}',
                 'other': 'x'}
        told = passes.mask_texts(texts, 'View')
        key = f'cryptomatte/{murmur.hash_of("View.CryptoObject"):08x}'[:-1]
        self.assertEqual(told, {f'{key}/name': 'View.CryptoObject', f'{key}/hash': 'm',
                                f'{key}/conversion': 'u', f'{key}/manifest': '{}'})


TETRAHEDRON = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]], float)
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
FOG = Medium((0.1, 0.2, 0.3), (0.4, 0.5, 0.6), 0.5)
HAZE = Medium(scatters=(0.1, 0.1, 0.1))


def moved(x, y, z):
    return np.array([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]], float)


class InVolumes(unittest.TestCase):
    def setUp(self):
        self.left_out = LeftOut()
        self.spaces = Spaces(CLEAR, self.left_out)
        self.fog = Placed('fog', None, (moved(5, 0, 0),))
        corners = TETRAHEDRON[np.array(FACES)]
        self.spaces.add(Space(self.fog, FOG, corners, moved(5, 0, 0)))

    def small(self, *place):
        return self.around_small(self.spaces, place)

    @staticmethod
    def around_small(spaces, place):
        return spaces.around(Placed('small', None, (moved(*place),)),
                             (np.zeros(3), np.full(3, 0.2)))

    def test_points_within_a_mesh(self):
        inside = [(5.3, 0.3, 0.3), (5.1, 0.1, 1.7)]
        outside = [(5.8, 0.8, 0.8), (4.9, 0.3, 0.3), (0.3, 0.3, 0.3)]
        self.assertEqual([self.spaces.at(p) for p in inside], [FOG, FOG])
        self.assertEqual([self.spaces.at(p) for p in outside], [CLEAR] * 3)

    def test_things_lie_within_or_outside(self):
        self.assertEqual(self.small(5.2, 0.2, 0.2), FOG)
        self.assertEqual(self.small(5, 0, 0), FOG)  # touches the border from within
        self.assertEqual(self.small(8, 0, 0), CLEAR)
        self.assertEqual(self.left_out.lines(), [])
        partly = (4.9, 0.2, 0.2)
        self.assertEqual(self.small(*partly), CLEAR)
        self.assertEqual(self.left_out.lines(), [])  # nothing is declared: rays stay in the fog
        haze = Spaces(HAZE, self.left_out)
        haze.add(Space(self.fog, FOG, TETRAHEDRON[np.array(FACES)], moved(5, 0, 0)))
        self.assertEqual(self.around_small(haze, partly), HAZE)
        self.assertEqual(self.left_out.lines(),
                         ['what lies partly in a volume is taken to lie outside: small'])

    def test_a_volume_does_not_surround_itself(self):
        box = TETRAHEDRON.min(axis=0), TETRAHEDRON.max(axis=0)
        self.assertEqual(self.spaces.around(self.fog, box), CLEAR)

    def test_coefficients_add_up(self):
        self.assertEqual(both(FOG, CLEAR), FOG)
        twice = both(FOG, Medium((0.1, 0, 0), (0.4, 0.5, 0.6), -0.1))
        np.testing.assert_allclose(twice.absorbs, (0.2, 0.2, 0.3))
        np.testing.assert_allclose(twice.scatters, (0.8, 1, 1.2))
        self.assertAlmostEqual(twice.cosine, 0.2)


class Programs(unittest.TestCase):
    def test_constants_are_worked_out_and_what_is_not_read_goes(self):
        program = ['value 1 2 3', 'math add 2 1 0', 'vector multiply r0 r1 0 0', 'uv', 'position',
                   'vector multiply r4 r2 0 0', 'value 0 0 0', 'vector multiply r4 r6 0 0',
                   'mix mix r1 r5 r7']
        self.assertIsNone(folded(program))
        self.assertEqual(shortened(program), ['position', 'value 3 6 9',
                                              'vector multiply r0 r1 0 0', 'mix mix 3 r2 0'])
        self.assertEqual(folded(program[:3]), (3, 6, 9))

    def test_what_is_too_great_is_left_to_lxsrender(self):
        self.assertIsNone(folded(['math power 1e30 20 0']))


class Status(unittest.TestCase):
    def test_share_follows_the_nearest_bound(self):
        film = Film(1, 1, passes=10, seconds=100, error=0.05)
        self.assertEqual(status.share(film, {}, 20), 0.2)
        self.assertEqual(status.share(film, {'passes': '5', 'relMSE': '0.01'}, 20), 0.5)

    def test_line(self):
        self.assertEqual(status.text(Film(1, 1, error=0.05), {'passes': '5', 'relMSE': '0.01'}, 63),
                         'aips: pass 5, error 10 %, 5 % wanted, 1:03 gone')

    def test_progress_is_told_where_it_is_newer_than_the_image(self):
        image = {'passes': '5', 'relMSE': '0.01', 'seed': '1'}
        for line in ('', 'pass 5 of 9, 0:11 gone, about 0:15 left, error 2 %', 'wrote a.exr',
                     'pass 4, 1:00:11 gone'):
            self.assertEqual(status.newer(image, line), image)
        for line in ('pass 46 of 110, 0:11 gone, about 0:15 left, error 13.5 %',
                     'pass 46, 1:02:11 gone, about 9:49 left, error 13.5 %, 5 % in about 2:03',
                     'pass 46, 0:11 gone, error 13.5 %, 1.2 M rays/s, memory 90 MB'):
            told = status.newer(image, line)
            self.assertEqual((told['passes'], told['seed']), ('46', '1'))
            self.assertAlmostEqual(status.error_of(told), 0.135)
        self.assertEqual(status.newer({}, 'pass 1, 0:01 gone'), {'passes': '1'})
        huge = status.newer({}, 'pass 3, 0:01 gone, about 9:59 left, error 1.2e+03 %')
        self.assertAlmostEqual(status.error_of(huge), 12)

    def test_writing_takes_a_small_share(self):
        self.assertEqual(command.write_every(100, 2), 2)
        self.assertAlmostEqual(command.write_every(1920 * 1080, 2), 20.7, places=1)

    def test_the_last_image_alone_is_denoised(self):
        self.assertIn('--denoise=last', command.arguments('lxsrender', 'a', 'b', denoise=True))

    def test_combined_is_denoised_where_the_image_is(self):
        one = np.ones((1, 1), np.float32)
        image = exr.Image({'R': one, 'G': one, 'B': one, 'denoised.R': 2 * one}, {})
        self.assertEqual(list(passes.pixels(image, passes.COMBINED)[0]), [2, 0, 0, 1])
        self.assertEqual(list(passes.pixels(image, passes.NOISY)[0]), [1, 1, 1])
        del image.channels['denoised.R']
        self.assertEqual(list(passes.pixels(image, passes.COMBINED)[0]), [1, 1, 1, 1])


class Processes(unittest.TestCase):
    def test_a_program_that_is_not_there(self):
        with self.assertRaisesRegex(process.NotFound, '/nowhere is no program that can be run'):
            process.find('/nowhere')

    def test_failure_tells_the_programs_own_words(self):
        self.assertIsNone(process.failure(130, []))
        self.assertEqual(process.failure(2, ['error: no such option']),
                         'lxsrender ended with exit code 2: no such option')

    def test_a_long_render_loses_no_warning_and_no_error(self):
        log = process.Log()
        said = [f'warning: {i}' for i in range(200)]
        for line in ['scene: 3 triangles', *said, 'error: first']:
            log.add(line)
        for i in range(10_000):
            log.add(f'pass {i}, 0:11 gone')
            log.add('warning: cannot write a.exr; rendering goes on')
        self.assertEqual(log.warnings(), said + ['warning: cannot write a.exr; rendering goes on'])
        self.assertEqual(log.lines(), ['scene: 3 triangles', 'error: first'])
        self.assertEqual(log.progress, 'pass 9999, 0:11 gone')

    def test_logs_are_bounded(self):
        log = process.Log()
        for i in range(10_000):
            log.add(f'warning: {i}')
            log.add(f'line {i}')
        self.assertEqual(len(log.lines()), process.LINES_KEPT)
        self.assertEqual(log.lines()[-1], 'line 9999')
        left = 10_000 - process.WARNINGS_KEPT
        self.assertEqual(log.warnings()[-2:], [f'warning: {process.WARNINGS_KEPT - 1}',
                                               f'warning: and {left} more'])

    def test_an_interrupt_ends_it(self):
        program = 'import sys, time; print("ready", file=sys.stderr, flush=True); time.sleep(60)'
        running = process.Process([sys.executable, '-c', program], FOLDER)
        while running.running() and not running.log.lines():
            time.sleep(0.05)
        running.interrupt()
        self.assertNotEqual(running.wait(), 0)
        self.assertTrue(any('KeyboardInterrupt' in line for line in running.log.lines()))
