"""Materials made in Blender for the small scenes of the tests."""
import bpy
import numpy as np


# Names of sockets in Blender 3, and from 4 on.
RENAMED = {'Specular': 'Specular IOR Level', 'Transmission': 'Transmission Weight',
           'Emission': 'Emission Color', 'Clearcoat': 'Coat Weight',
           'Clearcoat Roughness': 'Coat Roughness', 'Subsurface': 'Subsurface Weight',
           'Sheen': 'Sheen Weight'}


def socket(node, name):
    """An input by its name in Blender 3."""
    return node.inputs[name if name in node.inputs else RENAMED[name]]


def add_group_socket(group, name, kind, output=False):
    """Gives a node group a socket."""
    if hasattr(group, 'interface'):  # from Blender 4 on
        group.interface.new_socket(name, in_out='OUTPUT' if output else 'INPUT', socket_type=kind)
    else:
        (group.outputs if output else group.inputs).new(kind, name)


def material(name, node_type, **inputs):
    """A material of one shader node, with values of its inputs by name (_ for a space), which are
    those of Blender 3."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes = made.node_tree.nodes
    nodes.clear()
    shader, output = nodes.new(node_type), nodes.new('ShaderNodeOutputMaterial')
    made.node_tree.links.new(shader.outputs[0], output.inputs['Surface'])
    for key, value in inputs.items():
        socket(shader, key.replace('_', ' ')).default_value = value
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
    link_volume(made.node_tree, made.node_tree.nodes['Material Output'], node_type, inputs)
    return made


def link_volume(tree, output, node_type, inputs):
    shader = tree.nodes.new(node_type)
    tree.links.new(shader.outputs[0], output.inputs['Volume'])
    for key, value in inputs.items():
        shader.inputs[key.replace('_', ' ')].default_value = value


def cloudy_volume(name, density):
    """A volume of noise in object coordinates, between none and `density`; its colour is one below
    and another one above."""
    made = volume(name, 'ShaderNodeVolumePrincipled', Anisotropy=0.3)
    tree = made.node_tree
    place, noise, ramp, range_, axes = (tree.nodes.new(f'ShaderNode{kind}') for kind in (
        'TexCoord', 'TexNoise', 'ValToRGB', 'MapRange', 'SeparateXYZ'))
    noise.inputs['Scale'].default_value, noise.inputs['Detail'].default_value = 2.5, 1
    for key, value in (('From Min', 0.45), ('From Max', 0.65), ('To Max', density)):
        range_.inputs[key].default_value = value
    ramp.color_ramp.elements[0].color = (0.9, 0.4, 0.2, 1)
    ramp.color_ramp.elements[1].color = (0.5, 0.8, 0.9, 1)
    shader = tree.nodes['Principled Volume'].inputs
    for output, to in ((place.outputs['Object'], noise.inputs['Vector']),
                       (noise.outputs['Fac'], range_.inputs['Value']),
                       (range_.outputs[0], shader['Density']),
                       (place.outputs['Generated'], axes.inputs[0]),
                       (axes.outputs['Z'], ramp.inputs['Fac']),
                       (ramp.outputs['Color'], shader['Color'])):
        tree.links.new(output, to)
    return made


def grey(value=0.6):
    return material('grey', 'ShaderNodeBsdfDiffuse', Color=(value, value, value, 1))


def blackbody_material(kelvin, strength):
    made = material('hot', 'ShaderNodeEmission', Strength=strength)
    tree = made.node_tree
    node = tree.nodes.new('ShaderNodeBlackbody')
    node.inputs['Temperature'].default_value = kelvin
    tree.links.new(node.outputs[0], tree.nodes['Emission'].inputs['Color'])
    return made


def image(name, values, linear):
    """An image of rows x columns x 4 values, the first row at the bottom."""
    made = bpy.data.images.new(name, values.shape[1], values.shape[0], float_buffer=linear)
    made.pixels.foreach_set(values.ravel())
    return made


def image_material(values, scale, shift):
    """A diffuse material of sRGB values, looked up by a node Mapping of the uv."""
    made = material('picture', 'ShaderNodeBsdfDiffuse')
    tree = made.node_tree
    texture = tree.nodes.new('ShaderNodeTexImage')
    texture.image = image('picture', values, False)
    tree.links.new(texture.outputs['Color'], tree.nodes['Diffuse BSDF'].inputs['Color'])
    before = mapping(tree, texture, 'UV')
    before.inputs['Scale'].default_value, before.inputs['Location'].default_value = scale, shift
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
    before = mapping(tree, texture, 'UV')
    before.inputs['Scale'].default_value = (1, 2, 1)
    before.inputs['Location'].default_value = (0.1, 0, 0)
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


def mapping(tree, texture, coordinates):
    """A node Mapping before a texture, after coordinates of that name."""
    before, source = tree.nodes.new('ShaderNodeMapping'), tree.nodes.new('ShaderNodeTexCoord')
    tree.links.new(source.outputs[coordinates], before.inputs['Vector'])
    tree.links.new(before.outputs[0], texture.inputs['Vector'])
    return before


def gloss_by_fresnel(name, index, roughness, below, **inputs):
    """Glossy over another shader, whose inputs these are, by node Fresnel."""
    made = material(name, 'ShaderNodeMixShader')
    tree = made.node_tree
    for i, kind, values in ((0, 'Fresnel', {'IOR': index}), (1, below, inputs),
                            (2, 'BsdfGlossy', {'Roughness': roughness})):
        node = tree.nodes.new(f'ShaderNode{kind}')
        for key, value in values.items():
            node.inputs[key].default_value = value
        tree.links.new(node.outputs[0], tree.nodes['Mix Shader'].inputs[i])
    return made


def half_transparent(share, node_type='ShaderNodeBsdfDiffuse', **inputs):
    """A mix of a shader, diffuse unless told otherwise, and, by the share, transparent."""
    made = material('mix', 'ShaderNodeMixShader', Fac=share)
    tree = made.node_tree
    mix, shader = tree.nodes['Mix Shader'], tree.nodes.new(node_type)
    for key, value in (inputs or {'Color': (0.2, 0.5, 0.2, 1)}).items():
        shader.inputs[key].default_value = value
    tree.links.new(shader.outputs[0], mix.inputs[1])
    tree.links.new(tree.nodes.new('ShaderNodeBsdfTransparent').outputs[0], mix.inputs[2])
    return made
