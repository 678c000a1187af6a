"""Runs in Blender, by scripts/blender-benchmark: a caustic by aips and Cycles at equal CPU time.

Errors are relMSE (docs/measured/method.md) of the whole and, as "rest", without the worst 0.1 % of
the pixels, against a long render of either. Blocks tell whether both long renders mean the same.
"""
import os
import resource
import subprocess
import sys

import bpy
import numpy as np

import cycles_agreement as agreement
import small_scenes as scenes
from aips_blender import exr
from aips_blender.export.film import Film
from aips_blender.export.scene import export
from fixture import FOLDER, LXSRENDER

WIDTH, HEIGHT = 192, 128
LONG = 10        # times the short render's time, for references
WORST = 0.001    # share of the pixels that is left out
EPSILON = 0.01   # of the mean's square, added where a pixel is dark


def scene_with_caustic():
    scene = scenes.stage()
    glass = scenes.material('glass', 'ShaderNodeBsdfGlass', Roughness=0, IOR=1.5)
    scenes.ball('ball', 0.8, glass, (0.9, 0.2, 0.8))
    scenes.light('POINT', 400, (-1.5, -1.5, 4), shadow_soft_size=0.25)
    scene.camera.location = (0.8, -4, 2.6)
    return scene


def cpu_seconds(who):
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def by_aips(path, passes):
    before = cpu_seconds(resource.RUSAGE_CHILDREN)
    subprocess.run([LXSRENDER, path + '.lxs', '-o', path + '.exr', '--quiet', '--passes',
                    str(passes), '--seed', str(passes), '--write-every', '0', '--no-advice'],
                   check=True)
    return exr.read(path + '.exr').stack('RGB'), cpu_seconds(resource.RUSAGE_CHILDREN) - before


def by_cycles(scene, path, samples):
    before = cpu_seconds(resource.RUSAGE_SELF)
    agreement.SAMPLES = samples
    scene.cycles.seed = samples
    image = agreement.cycles_image(scene, path + '-cycles.exr')
    return image, cpu_seconds(resource.RUSAGE_SELF) - before


def relmse(image, reference):
    """Of the whole, and of the rest."""
    error = (image - reference) ** 2 / (reference ** 2 + EPSILON * reference.mean() ** 2)
    by_size = np.sort(error.mean(-1).ravel())
    rest = by_size[:len(by_size) - int(WORST * len(by_size))]
    return f'{by_size.mean():.2g} | {rest.mean():.2g}'


def rendered_for(render, seconds, probe):
    """An image of about so many CPU seconds; one of `probe` passes tells how long they take."""
    _, took = render(probe)
    return render(max(int(probe * seconds / took), 2))


def main():
    seconds = float(sys.argv[-1])
    agreement.WIDTH, agreement.HEIGHT = WIDTH, HEIGHT
    scene, path = scene_with_caustic(), os.path.join(FOLDER, 'caustic')
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    export(path + '.lxs', bpy.context.evaluated_depsgraph_get(), Film(WIDTH, HEIGHT))
    renders = {'aips': (lambda count: by_aips(path, count), 8),
               'Cycles': (lambda count: by_cycles(scene, path, count), 16)}
    short = {name: rendered_for(render, seconds, probe)
             for name, (render, probe) in renders.items()}
    long = {name: rendered_for(render, LONG * seconds, 2 * probe)
            for name, (render, probe) in renders.items()}
    print('| | CPU seconds | whole, to long aips | rest | whole, to long Cycles | rest |')
    print('| --- | --- | --- | --- | --- | --- |')
    for name, (image, took) in short.items():
        errors = [relmse(image, long[other][0]) for other in ('aips', 'Cycles')]
        print(f'| {name} | {took:.1f} | {errors[0]} | {errors[1]} |')
    ours, theirs = (agreement.blocks(long[name][0]).mean(-1) for name in ('aips', 'Cycles'))
    off = np.abs(ours / theirs - 1)
    print(f'Long renders: {long["aips"][1]:.0f} and {long["Cycles"][1]:.0f} CPU seconds; blocks differ '
          f'by {100 * np.median(off):.2f} % in the median, {100 * off.max():.1f} % at most', flush=True)


main()
