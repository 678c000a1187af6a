"""Small scenes made in Blender for the tests: one subject each, in an open stage."""
import math

import bpy
import numpy as np


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new('World')
    background(scene, (0, 0, 0), 0.0)
    return scene


def background(scene, rgb, strength):
    scene.world.use_nodes = True
    node = scene.world.node_tree.nodes['Background']
    node.inputs['Color'].default_value = (*rgb, 1)
    node.inputs['Strength'].default_value = strength
    return node


def add(name, data, place=(0, 0, 0), turn=(0, 0, 0)):
    thing = bpy.data.objects.new(name, data)
    thing.location, thing.rotation_euler = place, turn
    bpy.context.collection.objects.link(thing)
    return thing


def material(name, node_type, **inputs):
    """A material of one shader node, with values of its inputs by name (_ for a space)."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes = made.node_tree.nodes
    nodes.clear()
    shader, output = nodes.new(node_type), nodes.new('ShaderNodeOutputMaterial')
    made.node_tree.links.new(shader.outputs[0], output.inputs['Surface'])
    for key, value in inputs.items():
        shader.inputs[key.replace('_', ' ')].default_value = value
    return made


def volume(name, node_type, **inputs):
    """A material without a surface, filled as one volume shader has it."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes = made.node_tree.nodes
    nodes.clear()
    nodes.new('ShaderNodeOutputMaterial')
    return add_volume(made, node_type, **inputs)


def add_volume(made, node_type, **inputs):
    _link_volume(made.node_tree, made.node_tree.nodes['Material Output'], node_type, inputs)
    return made


def world_volume(scene, node_type, **inputs):
    tree = scene.world.node_tree
    _link_volume(tree, tree.nodes['World Output'], node_type, inputs)


def _link_volume(tree, output, node_type, inputs):
    shader = tree.nodes.new(node_type)
    tree.links.new(shader.outputs[0], output.inputs['Volume'])
    for key, value in inputs.items():
        shader.inputs[key.replace('_', ' ')].default_value = value


def grey(value=0.6):
    return material('grey', 'ShaderNodeBsdfDiffuse', Color=(value, value, value, 1))


def with_material(thing, made):
    thing.data.materials.append(made)
    return thing


def plane(name, size, made, place=(0, 0, 0), turn=(0, 0, 0)):
    bpy.ops.mesh.primitive_plane_add(size=size, location=place, rotation=turn)
    return _named(name, made)


def ball(name, radius, made, place, smooth=True):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=48, ring_count=24, radius=radius, location=place)
    if smooth:
        bpy.ops.object.shade_smooth()
    return _named(name, made)


def box(name, size, made, place, turn=(0, 0, 0)):
    bpy.ops.mesh.primitive_cube_add(size=size, location=place, rotation=turn)
    return _named(name, made)


def _named(name, made):
    thing = bpy.context.object
    thing.name = name
    return with_material(thing, made)


def camera(place=(0, -6, 3), turn=(math.radians(65), 0, 0), lens=40):
    data = bpy.data.cameras.new('Camera')
    data.lens = lens
    thing = add('Camera', data, place, turn)
    bpy.context.scene.camera = thing
    return thing


def light(kind, energy, place=(0, 0, 3), turn=(0, 0, 0), **settings):
    data = bpy.data.lights.new(kind, kind)
    data.energy = energy
    for key, value in settings.items():
        setattr(data, key, value)
    return add(kind, data, place, turn)


def stage(subject=None):
    """A floor and a wall of grey, a box on the floor, and the camera before them."""
    scene = clear()
    plane('floor', 8, grey())
    plane('wall', 8, grey(0.5), (0, 2.5, 4), (math.radians(90), 0, 0))
    box('box', 1, subject or material('red', 'ShaderNodeBsdfDiffuse', Color=(0.7, 0.2, 0.1, 1)),
        (-1.2, 0.3, 0.5), (0, 0, 0.4))
    camera()
    return scene


def lit_stage():
    """The stage under a wide lamp and a grey sky, which leave little noise."""
    scene = stage()
    background(scene, (1, 1, 1), 0.6)
    light('AREA', 200, (0.5, -1.5, 4), (0.2, 0.1, 0), size=1.5)
    return scene


def image(name, values, linear):
    """An image of rows x columns x 4 values, the first row at the bottom."""
    made = bpy.data.images.new(name, values.shape[1], values.shape[0], float_buffer=linear)
    made.pixels.foreach_set(values.ravel())
    return made


def world_image(scene, values, turn):
    """A world of linear values by direction, turned about z by a node Mapping."""
    tree = scene.world.node_tree
    texture = tree.nodes.new('ShaderNodeTexEnvironment')
    texture.image = image('sky', values, True)
    tree.links.new(texture.outputs[0], background(scene, (1, 1, 1), 1).inputs['Color'])
    _mapping(tree, texture, 'Generated').inputs['Rotation'].default_value = (0, 0, turn)


def preetham_sky(scene, towards, turbidity, strength):
    """Preetham's sky with the sun, which is not seen, in the direction `towards`."""
    tree = scene.world.node_tree
    sky = tree.nodes.new('ShaderNodeTexSky')
    sky.sky_type, sky.sun_direction, sky.turbidity = 'PREETHAM', towards, turbidity
    tree.links.new(sky.outputs[0], background(scene, (1, 1, 1), strength).inputs['Color'])


def image_material(values, scale, shift):
    """A diffuse material of sRGB values, looked up by a node Mapping of the uv."""
    made = material('picture', 'ShaderNodeBsdfDiffuse')
    tree = made.node_tree
    texture = tree.nodes.new('ShaderNodeTexImage')
    texture.image = image('picture', values, False)
    tree.links.new(texture.outputs['Color'], tree.nodes['Diffuse BSDF'].inputs['Color'])
    mapping = _mapping(tree, texture, 'UV')
    mapping.inputs['Scale'].default_value, mapping.inputs['Location'].default_value = scale, shift
    return made


def checker_material():
    """Squares of two greys, looked up by a node Mapping of the uv."""
    made = material('checker', 'ShaderNodeBsdfDiffuse')
    tree = made.node_tree
    texture = tree.nodes.new('ShaderNodeTexChecker')
    texture.inputs['Color1'].default_value = (0.7, 0.7, 0.7, 1)
    texture.inputs['Color2'].default_value = (0.2, 0.2, 0.2, 1)
    texture.inputs['Scale'].default_value = 3
    tree.links.new(texture.outputs['Color'], tree.nodes['Diffuse BSDF'].inputs['Color'])
    mapping = _mapping(tree, texture, 'UV')
    mapping.inputs['Scale'].default_value = (1, 2, 1)
    mapping.inputs['Location'].default_value = (0.1, 0, 0)
    return made


def bumpy_material(heights, distance):
    """Grey with a bump of the given heights, 0 to 1, times a distance."""
    made = grey()
    tree = made.node_tree
    values = np.repeat(heights[:, :, None], 4, axis=2).astype(np.float32)
    texture, bump = tree.nodes.new('ShaderNodeTexImage'), tree.nodes.new('ShaderNodeBump')
    texture.image = bpy.data.images.new('heights', *heights.shape, float_buffer=True, is_data=True)
    texture.image.pixels.foreach_set(values.ravel())
    bump.inputs['Strength'].default_value, bump.inputs['Distance'].default_value = 1, distance
    tree.links.new(texture.outputs['Color'], bump.inputs['Height'])
    tree.links.new(bump.outputs[0], tree.nodes['Diffuse BSDF'].inputs['Normal'])
    return made


def _mapping(tree, texture, coordinates):
    mapping, source = tree.nodes.new('ShaderNodeMapping'), tree.nodes.new('ShaderNodeTexCoord')
    tree.links.new(source.outputs[coordinates], mapping.inputs['Vector'])
    tree.links.new(mapping.outputs[0], texture.inputs['Vector'])
    return mapping


def half_transparent(share):
    """A mix of diffuse and, by the share, transparent."""
    made = material('mix', 'ShaderNodeMixShader', Fac=share)
    tree = made.node_tree
    mix = tree.nodes['Mix Shader']
    diffuse = tree.nodes.new('ShaderNodeBsdfDiffuse')
    diffuse.inputs['Color'].default_value = (0.2, 0.5, 0.2, 1)
    tree.links.new(diffuse.outputs[0], mix.inputs[1])
    tree.links.new(tree.nodes.new('ShaderNodeBsdfTransparent').outputs[0], mix.inputs[2])
    return made
