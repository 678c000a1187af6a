"""Small scenes made in Blender for the tests: one subject each, in an open stage."""
import math

import bpy

from small_materials import (  # some for the tests, which find all here
    add_group_socket, add_volume, blackbody_material, bumpy_material, checker_material,
    cloudy_volume, gloss_by_fresnel, grey, half_transparent, image, image_material, link_volume,
    mapping, material, socket, volume)


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


def world_volume(scene, node_type, **inputs):
    tree = scene.world.node_tree
    link_volume(tree, tree.nodes['World Output'], node_type, inputs)


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


def text(body, place):
    thing = add(f'text {body}', bpy.data.curves.new(body, 'FONT'), place)
    thing.data.body = body
    return thing


def instances(things, *places):
    """Lets things be seen at places along x alone, as instances of a collection."""
    part = bpy.data.collections.new('part')
    for thing in things:
        bpy.context.collection.objects.unlink(thing)
        part.objects.link(thing)
    for x in places:
        empty = add('place', None, (x, 0, 0))
        empty.instance_type, empty.instance_collection = 'COLLECTION', part


def move_to_collection(thing, **settings):
    """Into a new one, with settings of the view layer for it."""
    collection = bpy.data.collections.new(thing.name)
    bpy.context.scene.collection.children.link(collection)
    bpy.context.collection.objects.unlink(thing)
    collection.objects.link(thing)
    layer = bpy.context.view_layer.layer_collection.children[collection.name]
    for key, value in settings.items():
        setattr(layer, key, value)


def boxes_of_a_collection(name, *places):
    instances([box(name, 1, grey(), (0, 0, 0))], *places)


def vdb_of_a_ball(path):
    """Writes an OpenVDB file by Blender's modifier: a coarse grid of a ball of density 1 and radius
    0.5, thinner at its rim."""
    source = ball('source', 0.5, grey(), (0, 0, 0))
    fog = add('fog', bpy.data.volumes.new('fog'))
    made = fog.modifiers.new('made', 'MESH_TO_VOLUME')
    made.object, made.density, made.interior_band_width = source, 1, 0.25
    made.resolution_mode, made.voxel_size = 'VOXEL_SIZE', 0.1
    fog.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.grids.save(path)
    for each in (source, fog):
        bpy.data.objects.remove(each)
    return path


def volume_of_file(path):
    data = bpy.data.volumes.new('smoke')
    data.filepath = path
    return add('smoke', data)


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


def room():
    """A closed box around the camera, whose ceiling shines as a black body does; in it a sheet
    that shines and is half transparent, and a ball that shines and is partly there."""
    scene = clear()
    walls = box('room', 4, grey(0.5), (0, 0, 2))
    walls.data.materials.append(blackbody_material(2700, 1.5))
    ceiling = max(walls.data.polygons, key=lambda face: face.center.z)
    ceiling.material_index = 1
    sheet = half_transparent(0.5, 'ShaderNodeEmission', Color=(0.3, 0.6, 0.9, 1), Strength=1.2)
    plane('sheet', 1.2, sheet, (-0.6, 0.6, 1.2), (1.2, 0, 0.5))
    fades = material('fades', 'ShaderNodeBsdfPrincipled', Base_Color=(0.3, 0.3, 0.3, 1), Alpha=0.3,
                     Specular=0, Emission=(1, 0.6, 0.3, 1), Emission_Strength=1.5)
    ball('ball', 0.5, fades, (0.8, 0.5, 0.7))
    camera((0, -1.9, 1.6), (math.radians(85), 0, 0), lens=22)
    return scene


def world_image(scene, values, turn):
    """A world of linear values by direction, turned about z by a node Mapping."""
    tree = scene.world.node_tree
    texture = tree.nodes.new('ShaderNodeTexEnvironment')
    texture.image = image('sky', values, True)
    tree.links.new(texture.outputs[0], background(scene, (1, 1, 1), 1).inputs['Color'])
    mapping(tree, texture, 'Generated').inputs['Rotation'].default_value = (0, 0, turn)


def preetham_sky(scene, towards, turbidity, strength):
    """Preetham's sky with the sun, which is not seen, in the direction `towards`."""
    tree = scene.world.node_tree
    sky = tree.nodes.new('ShaderNodeTexSky')
    sky.sky_type, sky.sun_direction, sky.turbidity = 'PREETHAM', towards, turbidity
    tree.links.new(sky.outputs[0], background(scene, (1, 1, 1), strength).inputs['Color'])
