"""Renders one scene by lxsrender, as the add-on exports it, and by Cycles; compares both images."""
import os
import subprocess

import bpy
import numpy as np

from aips_blender import exr
from aips_blender.export.film import Film
from aips_blender.export.scene import export
from fixture import FOLDER, LXSRENDER

WIDTH, HEIGHT, BLOCK = 96, 64, 16  # pixels
DARK = 0.1    # share of the image's mean below which a block counts as if it were that bright
SAMPLES, PASSES = 256, 160
MAP_ROWS = 256  # of the map that steers samples of the world; Cycles' own choice takes long to make


def cycles_image(scene, path, samples=SAMPLES):
    scene.render.engine = 'CYCLES'
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.render.resolution_percentage = 100
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode = 'OPEN_EXR', 'RGB'
    settings.color_depth, settings.exr_codec = '32', 'ZIP'
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.use_denoising = 'CPU', samples, False
    cycles.use_adaptive_sampling = False
    cycles.sample_clamp_indirect = cycles.blur_glossy = cycles.light_sampling_threshold = 0
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = 16
    cycles.transmission_bounces = cycles.transparent_max_bounces = cycles.volume_bounces = 16
    if scene.world:
        scene.world.cycles.sampling_method = 'MANUAL'
        scene.world.cycles.sample_map_resolution = MAP_ROWS
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    return exr.read(path).stack('RGB')


def lxs_image(path, integrator):
    """The image, by `export` alone: render_test goes through the engine."""
    scene_path = path.replace('.exr', '.lxs')
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    export(scene_path, bpy.context.evaluated_depsgraph_get(),
           Film(WIDTH, HEIGHT, passes=PASSES, integrator=integrator),
           frame_set=lambda frame, part: scene.frame_set(frame, subframe=part))
    done = subprocess.run([LXSRENDER, scene_path, '-o', path, '--strict', '--quiet', '--no-advice',
                           '--no-error-estimate'],
                          capture_output=True, text=True, check=False)
    if done.returncode or 'warning' in done.stderr:
        raise AssertionError(f'lxsrender ended with {done.returncode}: {done.stderr}')
    return exr.read(path).stack('RGB')


def blocks(image):
    rows, columns, channels = image.shape
    return image.reshape(rows // BLOCK, BLOCK, columns // BLOCK, BLOCK, channels).mean((1, 3))


def differences(name, scene, integrator='aips'):
    """Relative differences of the blocks' means (of all colours together), ours from Cycles'."""
    path = os.path.join(FOLDER, name)
    ours, theirs = (blocks(image).mean(-1) for image in
                    (lxs_image(path + '.exr', integrator),
                     cycles_image(scene, path + '-cycles.exr')))
    return (ours - theirs) / np.maximum(theirs, DARK * theirs.mean())
