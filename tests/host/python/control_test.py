"""Protects what Python tells a render, and is told by it: settings, progress, its end by on_pass
and by Ctrl-C, errors with their place, messages."""
import os
import signal
import threading
import time

import module_fixture as fixture
import numpy as np
from module_fixture import SCENES, lxs

ROOM = {'integrator': 'aips', 'width': 48, 'set': {'aips.photonperpass': 3000}}


class Settings(fixture.InFolder):
    def test_set_takes_the_place_of_the_scenes(self):
        def photons(**options):
            return lxs.load(SCENES / 'room.lxs', width=32, seed=1,
                            **options).render(passes=2).statistics['counts']['photon paths']
        fixed = {'aips.guide': 'none', 'aips.photonperpass': 1000}
        self.assertEqual(photons(set=fixed), 2000)
        self.assertEqual(photons(set={**fixed, 'aips.photonperpass': np.int64(3000)}), 6000)
        self.assertEqual(photons(integrator='path'), 0)

    def test_values_of_all_types(self):
        settings = lxs.load(SCENES / 'room.lxs', width=8, set={
            'aips.debuglayers': True, 'aips.alpha': 0.5, 'aips.guide': 'none',
            'aips.photonperpass': 500})
        result = settings.render(passes=1)
        self.assertIn('photondensity', result.layers)
        self.assertEqual(result.statistics['settings']['set'],
                         ['aips.debuglayers=true', 'aips.alpha=0.5', 'aips.guide=none',
                          'aips.photonperpass=500'])

    def test_size_and_threads(self):
        image = lxs.load(SCENES / 'room.lxs', width=20, height=10, threads=1,
                         integrator='path').render(passes=1)
        self.assertEqual(image.image.shape, (10, 20, 3))
        self.assertEqual(image.statistics['settings']['threads'], 1)

    def test_budgets(self):
        scene = lxs.load(self.small_scene(fixture.FILM.replace('\n', ' "integer haltspp" [3]\n')),
                         integrator='path')
        self.assertEqual(scene.render().passes, 3)
        self.assertGreater(scene.render(seconds=0.2).passes, 3)
        result = lxs.load(self.small_scene(), integrator='path').render(target_error=0.9)
        self.assertLessEqual(result.error, 0.9)

    def test_arguments_out_of_range(self):
        for options in ({'threads': -1}, {'width': 0}, {'height': 70000}, {'seed': -1},
                        {'set': {'guide': 'none'}}):
            with self.assertRaises(ValueError, msg=options):
                lxs.load(SCENES / 'room.lxs', **options)
        scene = lxs.load(SCENES / 'room.lxs', **ROOM)
        for options in ({'passes': 0}, {'seconds': 0}, {'target_error': -1}):
            with self.assertRaises(ValueError, msg=options):
                scene.render(**options)
        with self.assertRaisesRegex(RuntimeError, 'no pass yet'):
            scene.result()
        scene = lxs.load(SCENES / 'room.lxs', error_estimate=False, **ROOM)
        with self.assertRaisesRegex(ValueError, 'error_estimate'):
            scene.render(target_error=0.1)
        result = scene.render(passes=3)
        self.assertIsNone(result.error)
        self.assertNotIn('error', result.layers)


class Passes(fixture.InFolder):
    def test_progress(self):
        told = []
        lxs.load(SCENES / 'room.lxs', **ROOM).render(
            passes=4, on_pass=lambda p: told.append((p.passes, p.seconds, p.rays, p.error,
                                                     p.image.mean())))
        self.assertEqual([figures[0] for figures in told], [1, 2, 3, 4])
        for before, after in zip(told, told[1:]):
            self.assertLess(before[1], after[1])
            self.assertLess(before[2], after[2])
        self.assertIsNone(told[1][3])
        self.assertGreater(told[3][3], 0)
        self.assertGreater(min(figures[4] for figures in told), 0)

    def test_interval(self):
        told = []
        lxs.load(SCENES / 'room.lxs', **ROOM).render(
            passes=3, interval=1000, on_pass=lambda p: told.append(p.passes))
        self.assertEqual(told, [1, 3])

    def test_false_stops(self):
        scene = lxs.load(SCENES / 'room.lxs', **ROOM)
        result = scene.render(passes=50, on_pass=lambda p: p.passes < 2)
        self.assertEqual((result.passes, result.stopped), (2, True))
        self.assertTrue(result.statistics['interrupted'])
        result = scene.render(passes=3, on_pass=lambda p: 0)  # not False
        self.assertEqual((result.passes, result.stopped), (3, False))

    def test_what_it_raises_is_raised(self):
        def fail(progress):
            raise KeyError(progress.passes)
        scene = lxs.load(SCENES / 'room.lxs', **ROOM)
        with self.assertRaisesRegex(KeyError, '1'):
            scene.render(passes=9, on_pass=fail)
        self.assertEqual(scene.result().passes, 1)
        self.assertEqual(scene.render(passes=2).passes, 2)

    def test_results_and_renders_within_it(self):
        images, errors = [], []
        scene = lxs.load(SCENES / 'room.lxs', **ROOM)

        def look(progress):
            images.append(scene.result().image.copy())
            try:
                scene.render(passes=9)
            except RuntimeError as error:
                errors.append(str(error))

        last = scene.render(passes=2, on_pass=look)
        np.testing.assert_array_equal(images[1], last.image)
        self.assertEqual(len(errors), 2)

    def test_control_c(self):
        scene = lxs.load(SCENES / 'room.lxs', **ROOM)
        timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            scene.render(seconds=60)
        self.assertLess(time.monotonic() - start, 5)
        passes = scene.result().passes
        self.assertGreater(passes, 0)
        self.assertEqual(scene.render(passes=passes + 1).passes, passes + 1)
        self.assertEqual(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_other_threads_run_meanwhile(self):
        # One pass that takes long: with the interpreter held nobody else would have a turn.
        scene = lxs.load(SCENES / 'room.lxs', width=200, integrator='aips',
                         set={'aips.photonperpass': 400000})
        ended, turns = threading.Event(), []

        def look():
            while not ended.wait(0.001):
                turns.append(None)

        watcher = threading.Thread(target=look)
        watcher.start()
        before = len(turns)
        scene.render(passes=1)
        during = len(turns) - before
        ended.set()
        watcher.join()
        self.assertGreater(during, 10)


class Errors(fixture.InFolder):
    def refused(self, scene, **options):
        with self.assertRaises(lxs.InputError) as caught:
            lxs.load(scene, **options)
        return caught.exception

    def test_place_and_message(self):
        scene = self.write('scene.lxs', fixture.FILM + fixture.WORLD.replace(
            '"perspective"', '"perspectiv"') + 'Shape "sphere" "float radius" ["a"]\nWorldEnd\n')
        with self.assertLogs('lxs', 'WARNING') as logs:
            error = self.refused(scene)
        self.assertIn('"radius" takes', logs.output[0])
        self.assertNotIn('radius', str(error))
        self.assertIsInstance(error, RuntimeError)
        self.assertEqual((error.file, error.line, error.column), (str(scene), 3, 8))
        self.assertIn('unknown Camera "perspectiv"', error.message)
        self.assertTrue(str(error).startswith(f'{scene}:3:8: error: unknown Camera'), error)
        self.assertIn('^', str(error))

    def test_all_errors_are_told(self):
        with self.assertNoLogs('lxs', 'WARNING'):
            error = self.refused(self.small_scene(
                fixture.FILM + 'SurfaceIntegrator "aips" "string guide" ["a"]\n',
                fixture.WORLD.replace('"perspective"', '"perspectiv"')))
        self.assertIn('"a"', error.message)
        self.assertIn('"perspectiv"', str(error))
        self.assertIn('2 errors', str(error))

    def test_setting_has_no_place(self):
        error = self.refused(SCENES / 'room.lxs', set={'aips.gide': 'none'})
        self.assertEqual((error.file, error.line, error.column), (None, None, None))
        self.assertIn('unknown aips parameter "gide"', error.message)
        error = self.refused(SCENES / 'room.lxs', integrator='aisp')
        self.assertIn('did you mean "aips"', str(error))

    def test_no_file(self):
        error = self.refused(self.folder / 'none.lxs')
        self.assertIn('none.lxs', str(error))
        self.assertIsNone(error.line)

    def test_syntax_of_pbrt(self):
        scene = self.write('ball.pbrt', fixture.PBRT + 'Shape "sphere" "float radius" [a]\n')
        error = self.refused(scene)
        self.assertEqual((error.file, error.line), (str(scene), 7))

    def test_names_of_any_bytes(self):
        name = os.fsdecode(b'\xff\xfe.lxs')
        with self.assertRaises(lxs.InputError) as caught:
            lxs.load(self.write(name, fixture.FILM + fixture.WORLD.replace('"persp', '"perps')))
        self.assertEqual(caught.exception.file, str(self.folder / name))
        self.write(name, fixture.FILM + fixture.WORLD + 'WorldEnd\n')
        lxs.load(self.folder / name).render(passes=1).save(self.folder / (name + '.exr'))
        self.assertTrue((self.folder / (name + '.exr')).exists())

    def test_files_that_cant_be_written(self):
        result = lxs.load(self.small_scene(), integrator='path').render(passes=1)
        with self.assertRaisesRegex(OSError, 'none/out.exr'):
            result.save(self.folder / 'none/out.exr')
        self.assertEqual(sorted(os.listdir(self.folder)), ['scene.lxs'])

    def test_plugins_that_cant_be_loaded(self):
        self.write('broken.so', 'no module')
        with self.assertRaisesRegex(lxs.PluginError, 'broken.so'):
            lxs.load(self.small_scene(), plugin_paths=[self.folder])

    def test_warnings_are_logged(self):
        scene = self.small_scene(fixture.FILM + 'Sampler "random" "integer pixelsample" [1]\n')
        with self.assertLogs('lxs', 'INFO') as logs:
            lxs.load(scene, integrator='path').render(passes=1)
        warnings = [record.getMessage() for record in logs.records
                    if record.levelname == 'WARNING']
        self.assertTrue(any('pixelsample' in text for text in warnings), warnings)
        self.assertTrue(any(record.levelname == 'INFO' and '1 light' in record.getMessage()
                            for record in logs.records))
        with self.assertRaises(lxs.InputError):
            lxs.load(scene, integrator='path', strict=True)


if __name__ == '__main__':
    fixture.main()
