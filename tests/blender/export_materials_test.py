"""Protects materials, textures and images of an export, and what shines."""
import os
import re
import unittest

import bpy
import numpy as np

import small_scenes as scenes
from aips_blender import exr
from aips_blender.export.film import Film
from exported_files import meshes_of, render
from fixture import FOLDER, exported


class Materials(unittest.TestCase):
    def test_groups_and_reroutes_are_looked_through(self):
        scenes.stage()
        group = bpy.data.node_groups.new('paint', 'ShaderNodeTree')
        scenes.add_group_socket(group, 'Tint', 'NodeSocketColor')
        scenes.add_group_socket(group, 'Surface', 'NodeSocketShader', output=True)
        inside, out = group.nodes.new('NodeGroupInput'), group.nodes.new('NodeGroupOutput')
        diffuse = group.nodes.new('ShaderNodeBsdfDiffuse')
        group.links.new(inside.outputs[0], diffuse.inputs['Color'])
        group.links.new(diffuse.outputs[0], out.inputs[0])
        made = bpy.data.materials.new('grouped')
        made.use_nodes = True
        tree = made.node_tree
        node, reroute = tree.nodes.new('ShaderNodeGroup'), tree.nodes.new('NodeReroute')
        node.node_tree = group
        node.inputs['Tint'].default_value = (0.25, 0.25, 0.25, 1)
        tree.links.new(node.outputs[0], reroute.inputs[0])
        tree.links.new(reroute.outputs[0], tree.nodes['Material Output'].inputs['Surface'])
        scenes.box('grouped', 1, made, (2, 0, 0))
        text, left_out = exported('grouped')
        self.assertIn('"grouped" "string type" ["matte"] "color Kd" [0.25 0.25 0.25]', text)
        self.assertEqual(left_out, [])

    def test_principled_by_its_sockets_of_either_version(self):
        """What shines back straight on: by Specular alone in Blender 3, by index too from 4 on."""
        scenes.stage()
        made = scenes.material('coated', 'ShaderNodeBsdfPrincipled', Specular=0.25, IOR=2.0)
        scenes.box('coated', 1, made, (2, 0, 0))
        by_index = 'Specular IOR Level' in made.node_tree.nodes[0].inputs
        share = 2 * 0.25 / 9 if by_index else 0.02
        text, left_out = exported('coated')
        self.assertEqual(left_out, [])
        found = re.search(r'"coated" "string type" \["glossy"\].*"color Ks" \[(.*?)\]', text)
        np.testing.assert_allclose([float(c) for c in found.group(1).split()], share, rtol=1e-5)

    def test_muted_links_are_none(self):
        scenes.stage()
        made = scenes.material('muted', 'ShaderNodeBsdfDiffuse', Color=(0.25, 0.25, 0.25, 1))
        feed(made, 'Diffuse BSDF', 'Color', 'ShaderNodeTexNoise').is_muted = True
        scenes.box('muted', 1, made, (2, 0, 0))
        text, left_out = exported('muted')
        self.assertIn('"muted" "string type" ["matte"] "color Kd" [0.25 0.25 0.25]', text)
        self.assertEqual(left_out, [])

    def test_view_layers_without_sky_and_with_one_material(self):
        scene = scenes.stage()
        scenes.background(scene, (1, 1, 1), 1)
        scenes.world_volume(scene, 'ShaderNodeVolumeScatter', Density=0.25)
        layer = bpy.context.view_layer
        layer.use_sky, layer.material_override = False, scenes.material(
            'all', 'ShaderNodeEmission')
        text, left_out = exported('override', Film(8, 8, passes=1))
        self.assertEqual((text.count('LightSource "infinite"'), text.count('Volume')), (0, 0))
        self.assertEqual(set(re.findall('NamedMaterial "(.*?)"', text)), {'all'})
        self.assertEqual(left_out, [])
        self.assertGreater(render('override').min(), 0.9)

    def test_worlds_of_mixed_shaders_and_patterns(self):
        """What lights most is taken, and a night sky stays dark."""
        scene = scenes.stage()
        night = scenes.background(scene, (1, 1, 1), 2)
        tree = scene.world.node_tree
        ramp = feed(scene.world, 'Background', 'Color', 'ShaderNodeValToRGB').from_node
        ramp.color_ramp.elements[0].color = (0.25, 0.25, 0.25, 1)
        feed(scene.world, ramp.name, 'Fac', 'ShaderNodeTexNoise')
        mix, seen = tree.nodes.new('ShaderNodeMixShader'), tree.nodes.new('ShaderNodeBackground')
        for output, place in ((tree.nodes.new('ShaderNodeLightPath').outputs[0], mix.inputs[0]),
                              (night.outputs[0], mix.inputs[1]), (seen.outputs[0], mix.inputs[2]),
                              (mix.outputs[0], tree.nodes['World Output'].inputs['Surface'])):
            tree.links.new(output, place)
        text, left_out = exported('night')
        self.assertIn('LightSource "infinite" "color L" [0.25 0.25 0.25] "float gain" [2]', text)
        self.assertEqual(left_out, [
            'of mixed shaders of the world one is taken: World',
            'of textures of the world other than image and sky the darker colour is taken: World'])

    def test_what_is_not_carried_over_is_told(self):
        scenes.stage()
        odd = scenes.material('odd', 'ShaderNodeBsdfAnisotropic', Anisotropy=0.5)
        shader = odd.node_tree.nodes[0].name
        bump = feed(odd, shader, 'Normal', 'ShaderNodeBump').from_node
        heights = feed(odd, bump.name, 'Height', 'ShaderNodeTexImage').from_node
        heights.image = bpy.data.images.new('heights', 4, 4, float_buffer=True)
        feed(odd, bump.name, 'Normal', 'ShaderNodeNormalMap')
        mapping = feed(odd, heights.name, 'Vector', 'ShaderNodeMapping').from_node
        feed(odd, mapping.name, 'Vector', 'ShaderNodeUVMap')
        feed(odd, mapping.name, 'Rotation', 'ShaderNodeCombineXYZ')
        feed(odd, mapping.name, 'Scale', 'ShaderNodeValue').from_node.outputs[0].default_value = 3
        color = feed(odd, shader, 'Color', 'ShaderNodeAttribute').from_node
        color.attribute_type, color.attribute_name = 'VIEW_LAYER', 'color'
        scenes.box('odd', 1, odd, (2, 0, 0))
        scenes.preetham_sky(bpy.context.scene, (0, 0, 1), 3, 1)
        world = bpy.context.scene.world
        feed(world, 'Sky Texture', 'Vector', 'ShaderNodeMapping')
        text, left_out = exported('odd')
        self.assertIn('vector multiply r0 3', text)
        self.assertEqual(left_out, [
            'anisotropy goes along u: odd',
            'linked rotations of node Mapping are taken as they are set: odd',
            'nodes Attribute are replaced by grey: odd',
            'normals that a node Bump is given are left out: odd',
            "the world's coordinates by nodes are left out: World"])


class Furnace(unittest.TestCase):
    def test_white_metals_and_coats_lose_no_light(self):
        """A white ball before a white world is not seen, however rough."""
        for rough in (0.0, 0.5, 1.0):
            for metallic in (0, 1):
                scene = scenes.clear()
                scenes.background(scene, (1, 1, 1), 1)
                made = scenes.material('white', 'ShaderNodeBsdfPrincipled', Roughness=rough,
                                       Base_Color=(1, 1, 1, 1), Metallic=metallic)
                made.node_tree.nodes[0].distribution = 'MULTI_GGX'
                scenes.ball('ball', 1, made, (0, 0, 0))
                scenes.camera((0, -4, 0), (1.5708, 0, 0), 50)
                exported('furnace', Film(32, 32, passes=64, integrator='path'))
                image = render('furnace').mean(-1)
                found = image.reshape(8, 4, 8, 4).mean((1, 3))
                print(f'[{rough} {metallic}: {abs(found - 1).max():.3f}] ', end='')
                self.assertLess(abs(found - 1).max(), 0.02)


class ByAngle(unittest.TestCase):
    def test_gloss_by_fresnel_over_what_is_transparent_is_a_pane(self):
        scenes.stage()
        scenes.box('pane', 1, scenes.gloss_by_fresnel('pane', 1.5, 0, 'BsdfTransparent'), (2, 0, 0))
        text, left_out = exported('pane')
        self.assertEqual(left_out, [])
        self.assertRegex(text, '"pane" "string type" ..glass.. .*"float index" .1.5. '
                               '"bool architectural" ..true..')

    def test_other_mixes_have_their_mean(self):
        """By the light of all directions: of Facing as it is set a third."""
        for node, output, share in (('Fresnel', 0, 0.0918), ('LayerWeight', 'Facing', 1 / 3)):
            scenes.stage()
            made = scenes.half_transparent(0.5)
            by = made.node_tree.nodes.new(f'ShaderNode{node}')
            by.inputs[0].default_value = {'Fresnel': 1.5}.get(node, 0.5)
            made.node_tree.links.new(by.outputs[output],
                                     made.node_tree.nodes['Mix Shader'].inputs[0])
            scenes.box('box', 1, made, (2, 0, 0))
            text, left_out = exported('angle')
            self.assertEqual(left_out, [f'what differs by angle has its mean: {made.name}'])
            found = re.search(r'\["mix"\].*"float amount" \[(.*?)\]', text)
            self.assertAlmostEqual(float(found.group(1)), share, places=3)


class ByRay(unittest.TestCase):
    """Mixes by node Light Path: what the camera sees, unless it is what shines."""

    def mixed(self, output, first, second):
        """Text and what is left out of a box that mixes two nodes by an output; the box's name is
        that of its material."""
        scenes.stage()
        made = scenes.material('mixed', 'ShaderNodeMixShader')
        tree = made.node_tree
        mix = tree.nodes['Mix Shader']
        by = tree.nodes.new('ShaderNodeLightPath')
        tree.links.new(by.outputs[output], mix.inputs[0])
        for i, kind in enumerate((first, second), 1):
            if kind:
                tree.links.new(tree.nodes.new(f'ShaderNode{kind}').outputs[0], mix.inputs[i])
        scenes.box('mixed', 1, made, (2, 0, 0))
        text, left_out = exported('mixed')
        return text, [line for line in left_out if 'Light Path' in line]

    def test_lights_that_the_camera_does_not_see(self):
        for seen in ('BsdfTransparent', None):
            text, left_out = self.mixed('Is Camera Ray', 'Emission', seen)
            self.assertEqual(left_out, [])
            self.assertRegex(text, '"mixed: unseen" "string type" ..null..')
            self.assertRegex(text, 'NamedMaterial "mixed: unseen"\n'
                                   'AreaLightSource .* "bool hidden" ..true..')

    def test_surfaces_are_those_that_the_camera_sees(self):
        for output, kinds in (('Is Camera Ray', ('BsdfTransparent', 'BsdfTranslucent')),
                              ('Is Shadow Ray', ('BsdfTranslucent', 'BsdfTransparent')),
                              ('Is Diffuse Ray', ('BsdfTranslucent', 'Emission'))):
            text, left_out = self.mixed(output, *kinds)
            self.assertIn('MakeNamedMaterial "mixed" "string type" ["mattetranslucent"]', text)
            self.assertEqual(left_out, ['what differs by kind of ray (Light Path) is left out, '
                                        'all rays see what the camera does: mixed'])

    def test_strengths_are_those_that_light(self):
        scenes.stage()
        made = scenes.material('lamp', 'ShaderNodeEmission')
        by = feed(made, 'Emission', 'Strength', 'ShaderNodeMath').from_node
        feed(made, by.name, 0, 'ShaderNodeLightPath')
        by.operation, by.inputs[1].default_value, by.inputs[2].default_value = \
            'MULTIPLY_ADD', -3, 4
        scenes.box('lamp', 1, made, (2, 0, 0))
        self.assertRegex(exported('lamp')[0], r'AreaLightSource "area" "color L" \[4 4 4\]')


class Shining(unittest.TestCase):
    def shapes(self, name):
        """Shapes that shine, and their materials."""
        text, left_out = exported(name)
        self.assertEqual(left_out, [])
        return re.findall(r'\n(?:Named)?Material "(.*?)"\n(?:Area.*\n)?Shape', text)

    def test_emission_of_principled_shines(self):
        scenes.stage()
        made = scenes.material('glows', 'ShaderNodeBsdfPrincipled', Emission=(1, 1, 1, 1),
                               Emission_Strength=3.0, Alpha=0.5)
        scenes.box('glows', 1, made, (2, 0, 0))
        self.assertRegex(exported('glows')[0], r'AreaLightSource "area" "color L" \[1.5 1.5 1.5\]')

    def test_black_bodies_shine_as_cycles_ones(self):
        scenes.stage()
        scenes.box('hot', 1, scenes.blackbody_material(3500, 2), (2, 0, 0))
        lamp = scenes.light('POINT', 10, shadow_soft_size=0).data
        lamp.use_nodes = True
        node = lamp.node_tree.nodes.new('ShaderNodeBlackbody')
        node.inputs[0].default_value = 3500
        lamp.node_tree.links.new(node.outputs[0], lamp.node_tree.nodes['Emission'].inputs['Color'])
        text, left_out = exported('hot')
        self.assertEqual(left_out, [])
        shines = re.findall(r'LightSource "(?:area|point)" "color L" \[(.*?)\]', text)
        once, twice = sorted([float(x) for x in rgb.split()] for rgb in shines)
        np.testing.assert_allclose(twice, np.multiply(once, 2), rtol=1e-4)
        # Cycles has 1.564, 0.893, 0.406; of red lxsrender shows less than is written.
        np.testing.assert_allclose(once, (1.6, 0.89, 0.406), atol=0.02)

    def test_closed_meshes_have_a_back_only_where_it_can_be_seen(self):
        scenes.stage()
        shines = scenes.material('lamp', 'ShaderNodeEmission')
        lamp = scenes.box('lamp', 0.8, shines, (2, 0, 3))
        self.assertEqual(self.shapes('outwards').count('null'), 0)
        lamp.data.flip_normals()
        self.assertEqual(self.shapes('inwards').count('null'), 1)
        lamp.data.flip_normals()
        inner = scenes.box('inner', 0.2, scenes.grey(), (2, 0, 3))
        self.assertEqual(self.shapes('around').count('null'), 1)
        inner.location.x = 0
        lamp.data.materials.append(scenes.grey())
        lamp.data.polygons[0].material_index = 1
        self.assertEqual(self.shapes('partly').count('null'), 1)
        lamp.data.polygons[0].material_index = 0
        lamp.data.materials[0] = scenes.half_transparent(0.5, 'ShaderNodeEmission')
        self.assertEqual(self.shapes('through').count('null'), 1)


class Layers(unittest.TestCase):
    def setUp(self):
        scenes.clear()
        scenes.camera()
        scenes.light('POINT', 100, shadow_soft_size=0)
        self.box = scenes.box('box', 1, scenes.grey(), (0, 0, 0))
        data = self.box.data
        data.uv_layers.new(name='second').data.foreach_set('uv', [0.25] * 48)
        data.uv_layers['second'].active_render = True
        for name, value in (('first', 0.25), ('second', 0.5)):
            data.color_attributes.new(name, 'FLOAT_COLOR', 'POINT').data.foreach_set(
                'color', [value] * 32)
        data.color_attributes.active_color_index = 0
        data.color_attributes.render_color_index = 1

    def mesh(self, name, *told):
        text, left_out = exported(name)
        self.assertEqual(left_out, list(told))
        return meshes_of(text)[0]

    def reads(self, socket, node_type, **settings):
        """Lets the box's material read something."""
        node = feed(self.box.data.materials[0], 'Diffuse BSDF', socket, node_type).from_node
        for key, value in settings.items():
            setattr(node, key, value)
        return node

    def test_uv_maps(self):
        self.assertEqual(set(self.mesh('rendered')['s']), {0.25})
        picture = self.reads('Color', 'ShaderNodeTexImage',
                             image=bpy.data.images.new('picture', 4, 4))
        named = feed(self.box.data.materials[0], picture.name, 'Vector', 'ShaderNodeUVMap')
        named.from_node.uv_map = 'UVMap'
        self.assertNotEqual(set(self.mesh('named')['s']), {0.25})
        bump = self.reads('Normal', 'ShaderNodeNormalMap', uv_map='second')
        normals = feed(self.box.data.materials[0], bump.name, 'Color', 'ShaderNodeTexImage')
        normals.from_node.image = picture.image
        told = ['normal maps by another uv map than the first are by that one: grey',
                'of the uv maps and colours that a material reads two are taken: grey']
        both = self.mesh('both', *told)
        self.assertEqual((both['s'].max(), set(both['red']), set(both['blue'])),
                         (0.875, {0.25}, {0}))

    def test_a_uv_map_that_is_not_there(self):
        picture = self.reads('Color', 'ShaderNodeTexImage',
                             image=bpy.data.images.new('picture', 4, 4))
        feed(self.box.data.materials[0], picture.name, 'Vector', 'ShaderNodeUVMap') \
            .from_node.uv_map = 'third'
        told = 'uv maps that are not there are replaced by the one for renders: box'
        self.assertEqual(set(self.mesh('third', told)['s']), {0.25})

    def test_colours(self):
        self.assertNotIn('red', self.mesh('unread'))
        node = self.reads('Color', 'ShaderNodeVertexColor')
        self.assertEqual(set(self.mesh('rendered')['red']), {0.5})
        node.layer_name = 'first'
        self.assertEqual(set(self.mesh('named')['red']), {0.25})
        node.layer_name = 'third'
        self.assertEqual(set(self.mesh('none')['red']), {0})
        self.box.data.attributes.new('third', 'FLOAT', 'POINT')
        told = 'attributes that are no colours are taken for white: box'
        self.assertNotIn('red', self.mesh('no colour', told))


class Images(unittest.TestCase):
    def shown(self, picture, output='Color', socket='Color'):
        """A diffuse box with an image, which a node shows."""
        scenes.lit_stage()
        made = scenes.grey()
        link = feed(made, 'Diffuse BSDF', socket, 'ShaderNodeTexImage')
        node = link.from_node
        made.node_tree.links.new(node.outputs[output], link.to_socket)
        node.image = picture() if callable(picture) else picture
        scenes.box('box', 1, made, (2, 0, 0))
        return node.image

    def texture(self, name):
        """The line of the image's texture, and its file."""
        text, left_out = exported(name)
        self.assertEqual(left_out, [])
        line = next(t for t in text.splitlines() if '"imagemap"' in t)
        return line, os.path.join(FOLDER, re.search(r'filename" \["(.*?)"\]', line).group(1))

    def on_disk(self, name):
        """Path of a PNG file that lies elsewhere."""
        path = os.path.join(FOLDER, 'elsewhere', name)
        made = scenes.image(name, np.full((4, 4, 4), 0.5, np.float32), False)
        made.filepath_raw, made.file_format = path, 'PNG'
        made.save()
        bpy.data.images.remove(made)
        return path

    def test_files_on_disk_are_read_where_they_lie(self):
        for name in ('paint.png', 'what "they" call it.png'):
            path = self.on_disk(name)
            self.shown(lambda: bpy.data.images.load(path))
            line, file = self.texture('disk')
            self.assertIn('"string colorspace" ["srgb"] "bool plaincolors" ["true"]', line)
            self.assertEqual(file == path, '"' not in name)
            with open(path, 'rb') as given, open(file, 'rb') as found:
                self.assertEqual(given.read(), found.read())
            self.assertIsNotNone(render('disk'))

    def test_packed_files_are_written_once_as_they_are_stored(self):
        path = self.on_disk('packed.png')
        picture = self.shown(lambda: bpy.data.images.load(path))
        picture.pack()
        os.remove(path)
        _, file = self.texture('packed')
        self.assertEqual(os.path.dirname(file), os.path.join(FOLDER, 'packed-files'))
        written = os.stat(file).st_mtime_ns
        self.assertEqual(self.texture('packed')[1], file)
        self.assertEqual(os.stat(file).st_mtime_ns, written)
        render('packed')

    def test_data_and_linear_files_are_linear(self):
        path = self.on_disk('data.png')
        self.shown(lambda: bpy.data.images.load(path)).colorspace_settings.name = 'Non-Color'
        self.assertIn('"float gamma" [1]', self.texture('data')[0])

    def test_pixels_that_are_in_no_file(self):
        values = np.full((2, 4, 4), 0.5, np.float32)
        values[0, 0] = (1, 0, 0.2, 0.4)
        self.shown(lambda: scenes.image('made', values, False))
        line, file = self.texture('made')
        self.assertTrue(file.endswith('.tga'))
        with open(file, 'rb') as data:
            self.assertEqual(data.read()[-16:-12], bytes((51, 0, 255, 102)))  # the last row begins
        self.assertIn('"srgb"', line)
        self.shown(lambda: scenes.image('floats', values, True))
        image = exr.read(self.texture('floats')[1]).stack('RGBA')
        np.testing.assert_allclose(image[1, 0], values[0, 0], atol=1e-6)

    def test_alpha_is_a_channel(self):
        for socket, kind in (('Roughness', 'float'), ('Color', 'color')):
            picture = self.shown(lambda: scenes.image(
                'made', np.full((2, 2, 4), 0.25, np.float32), False), 'Alpha', socket)
            text, _ = exported('alpha')
            self.assertRegex(text, r'"float" "imagemap".*"string channel" \["alpha"\]')
            self.assertEqual('"grey" "color" "mix" "texture amount" ["made"]' in text,
                             kind == 'color')
        picture.alpha_mode = 'NONE'
        self.assertNotIn('imagemap', exported('opaque')[0])

    def test_missing_images_are_magenta_and_told(self):
        path = self.on_disk('gone.png')
        self.shown(lambda: bpy.data.images.load(path))
        os.remove(path)
        text, left_out = exported('gone')
        self.assertEqual(left_out, ['images that cannot be read are magenta: gone.png'])
        self.assertRegex(text, r'"color Kd" \[0\.9\d* 0\.01\d* 1\]')  # which is shown as magenta

    def test_images_of_one_name_in_two_libraries(self):
        scenes.lit_stage()
        for shade in (0.25, 0.5):
            picture = bpy.data.images.new('picture', 4, 4, float_buffer=True)
            picture.pixels.foreach_set([shade] * 64)
            picture.pack()
            path = os.path.join(FOLDER, f'{shade}.blend')
            bpy.data.libraries.write(path, {picture})
            bpy.data.images.remove(picture)
            with bpy.data.libraries.load(path, link=True) as (_, linked):
                linked.images = ['picture']
            made = scenes.grey()
            feed(made, 'Diffuse BSDF', 'Color', 'ShaderNodeTexImage').from_node.image = \
                linked.images[0]
            scenes.box('box', 1, made, (2, 0, 0))
        text, _ = exported('libraries', Film(8, 8, passes=1))
        names = re.findall(r'"imagemap" "string filename" \["(.*?)"\]', text)
        self.assertEqual(len(set(names)), 2)
        render('libraries')


def feed(made, node, socket, node_type):
    """The link from a new node's first output to a socket of a node of a material or world."""
    tree = made.node_tree
    return tree.links.new(tree.nodes.new(node_type).outputs[0], tree.nodes[node].inputs[socket])
