"""Protects what is kept between exports: what has changed alone is written anew, none is stale."""
import os
import unittest

import bpy

import small_scenes as scenes
from aips_blender.export.film import Film
from aips_blender.export.kept import Kept
from aips_blender.export.scene import export
from exported_files import meshes_of
from fixture import FOLDER


class Keeps(unittest.TestCase):
    def setUp(self):
        scenes.lit_stage()
        self.kept = Kept()
        self.addCleanup(self.kept.end)
        self.box = bpy.data.objects['box']

    def exported(self):
        """Names and times of the meshes' files after an export, by what they begin with, and its
        text."""
        path = os.path.join(FOLDER, 'kept.lxs')
        export(path, bpy.context.evaluated_depsgraph_get(), Film(8, 8, passes=1), kept=self.kept)
        with open(path, encoding='utf-8') as file:
            text = file.read()
        times = {entry.name: entry.stat().st_mtime_ns for entry in os.scandir(self.kept.folder)}
        return times, text

    def changed(self, before):
        """How many files are new, and how many are gone, by the next export but one."""
        self.exported()
        after, _ = self.exported()
        self.assertFalse([n for n in set(before) & set(after) if before[n] != after[n]])
        return len(set(after) - set(before)), len(set(before) - set(after))

    def test_an_unchanged_scene_writes_no_mesh(self):
        before, text = self.exported()
        self.assertEqual(len(before), 2)  # floor and wall are alike
        self.assertEqual(self.changed(before), (0, 0))
        self.assertEqual(self.exported()[1], text)

    def test_what_moves_writes_no_mesh(self):
        before, _ = self.exported()
        self.box.location.x += 1
        bpy.context.view_layer.update()
        self.assertEqual(self.changed(before), (0, 0))

    def test_what_changes_is_written_anew(self):
        for change in (
                lambda: setattr(self.box.data.vertices[0], 'co', (-2, -2, -2)),
                lambda: self.box.data.polygons.foreach_set('use_smooth', [True] * 6),
                lambda: self.box.data.uv_layers.active.data.foreach_set('uv', [0.5] * 48),
                lambda: setattr(self.box.modifiers.new('fine', 'SUBSURF'), 'levels', 2)):
            before, _ = self.exported()
            change()
            self.box.data.update()
            bpy.context.view_layer.update()
            self.assertEqual(self.changed(before), (1, 1))

    def test_what_a_material_reads_is_written_anew(self):
        before, text = self.exported()
        self.assertFalse(any('red' in mesh for mesh in meshes_of(text)))
        self.box.data.color_attributes.new('paint', 'FLOAT_COLOR', 'POINT')
        tree = self.box.data.materials[0].node_tree
        node = tree.nodes.new('ShaderNodeVertexColor')
        tree.links.new(node.outputs[0], tree.nodes['Diffuse BSDF'].inputs['Color'])
        bpy.context.view_layer.update()
        self.assertEqual(self.changed(before), (1, 1))
        self.assertTrue(any('red' in mesh for mesh in meshes_of(self.exported()[1])))

    def test_what_is_told_of_a_mesh_is_told_again(self):
        self.box.data.attributes.new('odd', 'FLOAT', 'POINT')
        tree = self.box.data.materials[0].node_tree
        node = tree.nodes.new('ShaderNodeVertexColor')
        node.layer_name = 'odd'
        tree.links.new(node.outputs[0], tree.nodes['Diffuse BSDF'].inputs['Color'])
        for _ in range(2):
            found = export(os.path.join(FOLDER, 'told.lxs'),
                           bpy.context.evaluated_depsgraph_get(), Film(8, 8), kept=self.kept)
            self.assertEqual(found.left_out, ['attributes that are no colours are taken for white: '
                                              'box'])
