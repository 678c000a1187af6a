"""Renders one scene by lxsrender, as the add-on exports it, and by Cycles; compares both images.

Of each there are two or more images with seeds of their own, which tell how noisy their means are.
"""
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
SAMPLES, PASSES = 32, 40  # of one image; means of two or more are compared
MOST_IMAGES = 10
MAP_ROWS = 256  # of the map that steers samples of the world; Cycles' own choice takes long to make


def cycles_image(scene, path):
    scene.render.engine = 'CYCLES'
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.render.resolution_percentage = 100
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode = 'OPEN_EXR', 'RGB'
    settings.color_depth, settings.exr_codec = '32', 'ZIP'
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.use_denoising = 'CPU', SAMPLES, False
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


def exported(path, integrator='aips'):
    """Path of the scene, by `export` alone: render_test goes through the engine."""
    scene_path = path + '.lxs'
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    export(scene_path, bpy.context.evaluated_depsgraph_get(),
           Film(WIDTH, HEIGHT, passes=PASSES, integrator=integrator),
           frame_set=lambda frame, part: scene.frame_set(frame, subframe=part))
    return scene_path


def lxs_image(scene_path, path, seed):
    done = subprocess.run([LXSRENDER, scene_path, '-o', path, '--seed', str(seed), '--strict',
                           '--quiet', '--no-advice', '--no-error-estimate'],
                          capture_output=True, text=True, check=False)
    if done.returncode or 'warning' in done.stderr:
        raise AssertionError(f'lxsrender ended with {done.returncode}: {done.stderr}')
    return exr.read(path).stack('RGB')


def blocks(image):
    rows, columns, channels = image.shape
    return image.reshape(rows // BLOCK, BLOCK, columns // BLOCK, BLOCK, channels).mean((1, 3))


def mean_and_noise(images):
    """Of blocks' brightness: the mean over images, and the standard deviation of that mean."""
    return np.mean(images, axis=0), np.std(images, axis=0, ddof=1) / len(images) ** 0.5


def differences(name, scene, within, integrator='aips'):
    """Relative differences of the blocks' means (of all colours together), ours from Cycles', and
    their noise: one standard deviation, in the root mean square over blocks.

    Images are added until the greatest difference and twice the noise lie within the bound.
    """
    path = os.path.join(FOLDER, name)
    scene_path, ours, theirs = exported(path, integrator), [], []
    while True:
        seed = len(ours) + 1
        ours.append(blocks(lxs_image(scene_path, path + '.exr', seed)).mean(-1))
        scene.cycles.seed = seed
        theirs.append(blocks(cycles_image(scene, path + '-cycles.exr')).mean(-1))
        if seed == 1:
            continue
        (our_mean, our_noise), (mean, noise) = mean_and_noise(ours), mean_and_noise(theirs)
        bright = np.maximum(mean, DARK * mean.mean())
        found = (our_mean - mean) / bright
        noise = float(((our_noise ** 2 + noise ** 2) / bright ** 2).mean() ** 0.5)
        if np.abs(found).max() + 2 * noise < within or seed == MOST_IMAGES:
            return found, noise
