"""Protects the viewport's preview, without a window: its view, and what is written anew for it."""
import os
import time
import unittest
from types import SimpleNamespace
from unittest import mock

import bpy
from mathutils import Matrix

import fixture
import small_scenes as scenes
from aips_blender import viewport
from aips_blender.export import meshes

PATIENCE = 30  # seconds


class Engine:
    """Stands for Blender's engine."""
    said = ''

    def update_stats(self, _head, text):
        self.said = text

    def tag_redraw(self):
        pass

    def bind_display_space_shader(self, _scene):
        pass

    def unbind_display_space_shader(self):
        pass


def context(place, window, perspective=True, width=48, height=32):
    """A viewport with its camera at a place, and a matrix for what it shows."""
    return SimpleNamespace(
        region=SimpleNamespace(width=width, height=height),
        region_data=SimpleNamespace(view_matrix=place.inverted(), window_matrix=window,
                                    is_perspective=perspective),
        space_data=SimpleNamespace(clip_start=0.1, clip_end=100))


def box_window(half, depth):
    """Blender's matrix of an orthographic viewport, seen from `depth` behind to `depth` before."""
    return Matrix(((1 / half, 0, 0, 0), (0, 1.5 / half, 0, 0), (0, 0, -1 / depth, 0),
                   (0, 0, 0, 1)))


class Views(unittest.TestCase):
    def test_orthographic_viewports_show_what_is_behind_their_eye(self):
        turned = Matrix.Rotation(1, 4, 'X') @ Matrix.Translation((1, 2, 3))
        view, place = viewport.seen_by(context(turned, box_window(4, 50), False))
        self.assertEqual((view.kind, view.near), ('orthographic', 0))
        self.assertAlmostEqual(view.far, 100, places=3)
        moved = turned.inverted() @ place
        self.assertAlmostEqual((moved.translation - Matrix.Translation((0, 0, 50)).translation)
                               .length, 0, places=3)

    def test_what_a_camera_clips_stays_clipped(self):
        # From 1 to 9 before it.
        window = Matrix(((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, -2 / 8, -10 / 8), (0, 0, 0, 1)))
        view, place = viewport.seen_by(context(Matrix(), window, False))
        self.assertAlmostEqual(view.near, 1, places=5)
        self.assertAlmostEqual(view.far, 9, places=5)
        self.assertEqual(place, Matrix())


class Previews(unittest.TestCase):
    def setUp(self):
        self.scene = scenes.lit_stage()
        fixture.enable()
        self.drawn = []  # images
        for name, instead in (('SECONDS_OF_PEACE', 0), ('_texture', self.drawn.append),
                              ('draw_texture_2d', None)):
            patch = mock.patch.object(viewport, name, instead)
            patch.start()
            self.addCleanup(patch.stop)
        self.engine, self.preview = Engine(), viewport.Preview()
        self.addCleanup(self.preview._state.end)
        self.depsgraph = bpy.context.evaluated_depsgraph_get()
        self.camera = self.scene.camera.matrix_world.copy()
        self.window = self.scene.camera.calc_matrix_camera(self.depsgraph, x=48, y=32)

    def draw(self, seen):
        """Draws until a new render has an image; the arguments of that render."""
        before, begun = len(self.drawn), time.monotonic()
        running = self.preview._state.running
        while len(self.drawn) == before or self.preview._state.running is running:
            self.preview.draw(self.engine, seen, self.depsgraph)
            self.assertLess(time.monotonic() - begun, PATIENCE, self.engine.said)
            time.sleep(0.05)
        return self.preview._state.running._process.args

    def test_another_view_writes_no_mesh_again(self):
        self.preview.change()
        with mock.patch.object(viewport, 'Exporting', wraps=viewport.Exporting) as export:
            first = self.draw(context(self.camera, self.window))
            scene_file = first[1]
            meshes = files(scene_file.replace('.lxs', '-files'))
            text = text_of(scene_file)
            aside = self.camera @ Matrix.Translation((0.5, 0, 0))
            second = self.draw(context(aside, self.window))
            third = self.draw(context(aside, self.window, height=48))
            self.assertEqual(export.call_count, 1)
            self.assertEqual([a[1] for a in (second, third)], [scene_file] * 2)
            self.assertEqual(files(scene_file.replace('.lxs', '-files')), meshes)
            self.assertNotEqual(text_of(scene_file), text)
            self.assertEqual(self.drawn[-1].channels['R'].shape, (48, 48))
            images = [a[a.index('-o') + 1] for a in (first, second, third)]
            self.assertEqual([os.path.exists(os.path.dirname(i)) for i in images],
                             [False, False, True])
            self.preview.change()
            fourth = self.draw(context(aside, self.window))
            self.assertEqual(export.call_count, 2)
            self.assertNotEqual(fourth[1], scene_file)
            self.assertFalse(os.path.exists(os.path.dirname(scene_file)))

    def test_an_export_goes_on_in_slices(self):
        """A mesh at a time; what changes meanwhile is exported anew, of what is written by then
        only what has changed."""
        for i in range(5):
            scenes.ball(f'ball {i}', 0.2 + 0.01 * i, None, (i - 2, -1, 1))
        self.depsgraph = bpy.context.evaluated_depsgraph_get()
        seen = context(self.camera, self.window)
        written = []
        with mock.patch.object(viewport, 'SLICE', 0), \
                mock.patch.object(meshes, 'write_parts', wraps=meshes.write_parts) as write:
            self.preview.change()
            for _ in range(4):
                self.preview.draw(self.engine, seen, self.depsgraph)
                written.append(write.call_count)
            self.assertEqual(written, [1, 2, 3, 4])
            self.assertEqual(self.engine.said, 'aips: exporting the scene')
            self.assertIsNone(self.preview._state.running)
            first = bpy.data.objects['ball 0']
            first.data.vertices[0].co.z = 3
            first.data.update()
            self.depsgraph.update()
            self.preview.change([SimpleNamespace(id=first, is_updated_geometry=True)])
            found = self.draw(seen)
            self.assertEqual(write.call_count, 9)  # ball 0 comes twice
        self.assertEqual(text_of(found[1]).count('"plymesh"'), 8)

    def test_what_has_not_changed_is_not_read_again(self):
        self.preview.change()
        seen = context(self.camera, self.window)
        self.draw(seen)
        box = bpy.data.objects['box']
        box.location.x += 1
        self.depsgraph.update()
        for changed, reads in ((False, 0), (True, 1)):
            self.preview.change([SimpleNamespace(id=box, is_updated_geometry=changed)])
            with mock.patch.object(meshes, 'write_parts', wraps=meshes.write_parts) as write:
                self.draw(seen)
            self.assertEqual(write.call_count, reads)

    def test_what_nobody_foresaw_is_told(self):
        self.preview.change()
        with mock.patch.object(viewport, 'Exporting', side_effect=KeyError('Specular')):
            self.preview.draw(self.engine, context(self.camera, self.window), self.depsgraph)
        self.assertRegex(self.engine.said, "aips: KeyError: 'Specular'")

    def test_settings_are_heeded(self):
        self.scene.aips.integrator, self.scene.aips.eye_depth = 'path', 5
        bpy.context.preferences.addons[fixture.ADD_ON].preferences.threads = 1
        self.preview.change()
        arguments = self.draw(context(self.camera, self.window))
        self.assertIn('--threads 1', ' '.join(arguments))
        self.assertIn('SurfaceIntegrator "path" "integer maxdepth" [5]', text_of(arguments[1]))

    def test_an_orthographic_view_from_within(self):
        """The eye is below the floor, on which it looks from above; nothing else is bright."""
        scenes.background(self.scene, (0, 0, 0), 0)
        bpy.context.view_layer.update()
        self.preview.change()
        self.draw(context(Matrix.Translation((0, 0, -1)), box_window(1, 50), False))
        self.assertGreater(self.drawn[-1].channels['R'].mean(), 0.1)


def files(folder):
    """Names and times of a folder's files."""
    return {entry.name: entry.stat().st_mtime_ns for entry in os.scandir(folder)}


def text_of(path):
    with open(path, encoding='utf-8') as file:
        return file.read()
