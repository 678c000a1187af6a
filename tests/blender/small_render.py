"""A small scene set for a render by aips, and the render."""
import os

import bpy

import fixture
import small_scenes as scenes
from fixture import FOLDER


def render(name, file_format='OPEN_EXR_MULTILAYER'):
    scene = bpy.context.scene
    scene.render.engine = 'AIPS'
    scene.render.image_settings.file_format = file_format
    scene.render.image_settings.color_depth = '32' if 'EXR' in file_format else '8'
    scene.render.image_settings.exr_codec = 'ZIP'
    scene.render.filepath = os.path.join(FOLDER, name)
    bpy.ops.render.render(write_still=True)
    return scene.render.filepath


def small_scene(passes=4):
    scene = scenes.lit_stage()
    fixture.enable()
    scene.render.resolution_x, scene.render.resolution_y = 48, 32
    scene.render.resolution_percentage = 100
    scene.aips.until, scene.aips.passes = 'PASSES', passes
    return scene
