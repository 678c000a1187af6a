"""Protects File > Export: the file is there where it says so, and nothing else is written."""
import os
import unittest
from unittest import mock

import bpy

from aips_blender import engine
from fixture import FOLDER
from small_render import small_scene


class Exports(unittest.TestCase):
    def exported(self, name):
        """Text of an export by the menu."""
        path = os.path.join(FOLDER, name)
        self.assertEqual(bpy.ops.export_scene.aips_lxs(filepath=path), {'FINISHED'})
        with open(path, encoding='utf-8') as file:
            return file.read()

    def test_settings_for_renders_are_used(self):
        scene = small_scene()
        modifier = bpy.data.objects['box'].modifiers.new('subdivided', 'SUBSURF')
        modifier.levels, modifier.render_levels = 0, 3
        scene.render.engine = 'CYCLES'
        self.exported('menu.lxs')
        self.assertEqual(scene.render.engine, 'CYCLES')
        sizes = [os.path.getsize(os.path.join(FOLDER, 'menu-files', f))
                 for f in os.listdir(os.path.join(FOLDER, 'menu-files')) if 'box' in f]
        self.assertGreater(sizes[0], 10000)

    def test_nodes_that_take_no_render_are_left_aside(self):
        scene = small_scene()
        scene.use_nodes = True
        nodes = scene.node_tree.nodes
        nodes.clear()
        nodes.new('CompositorNodeComposite')
        self.exported('nodes.lxs')
        self.assertTrue(scene.render.use_compositing)

    def test_strips_are_left_aside(self):
        scene = small_scene()
        scene.sequence_editor_create().sequences.new_effect('strip', 'COLOR', 1, 1, frame_end=9)
        self.exported('strips.lxs')
        self.assertTrue(scene.render.use_sequencer)

    def test_files_of_the_compositor_are_not_written_over(self):
        scene = small_scene()
        scene.use_nodes = True
        nodes = scene.node_tree.nodes
        out = nodes.new('CompositorNodeOutputFile')
        out.base_path, out.file_slots[0].path = FOLDER, 'kept'
        scene.node_tree.links.new(nodes['Render Layers'].outputs['Image'], out.inputs[0])
        kept = os.path.join(FOLDER, f'kept{scene.frame_current:04}.png')
        with open(kept, 'w', encoding='utf-8') as file:
            file.write("the user's own")
        self.exported('files.lxs')
        with open(kept, encoding='utf-8') as file:
            self.assertEqual(file.read(), "the user's own")

    def test_the_active_view_layer_alone_is_exported(self):
        scene = small_scene()
        own, other = bpy.context.view_layer, scene.view_layers.new('second')
        hidden = bpy.data.collections.new('hidden')
        scene.collection.children.link(hidden)
        box = bpy.data.objects['box']
        hidden.objects.link(box)
        scene.collection.objects.unlink(box)
        other.layer_collection.children['hidden'].exclude = True
        own.use = False
        self.assertIn('-box', self.exported('first.lxs'))
        bpy.context.window.view_layer = other
        self.assertNotIn('-box', self.exported('second.lxs'))
        self.assertEqual((own.use, other.use), (False, True))

    def test_an_export_that_is_not_made_is_an_error(self):
        small_scene()
        path = os.path.join(FOLDER, 'never.lxs')
        with mock.patch.object(engine.AipsRenderEngine, '_export'):
            with self.assertRaisesRegex(RuntimeError, 'never.lxs is not written'):
                bpy.ops.export_scene.aips_lxs(filepath=path)
        bpy.data.objects.remove(bpy.context.scene.camera)
        with self.assertRaisesRegex(RuntimeError, 'camera'):
            bpy.ops.export_scene.aips_lxs(filepath=path)
        self.assertFalse(os.path.exists(path))

    def test_motion_blur_is_exported(self):
        scene = small_scene()
        for name, frame, x in (('box', 0, -2), ('box', 2, 0), ('Camera', 0, 0), ('Camera', 2, 1)):
            bpy.data.objects[name].location.x = x
            bpy.data.objects[name].keyframe_insert('location', index=0, frame=frame)
        scene.render.use_motion_blur = True
        bpy.data.objects['box'].modifiers.new('bones', 'ARMATURE')
        scene.frame_set(1)
        self.assertEqual(self.exported('moving.lxs').count('MotionBegin'), 2)
