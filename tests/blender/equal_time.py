"""Runs in Blender, by scripts/blender-benchmark: a caustic by aips and Cycles at equal CPU time.

Errors are relMSE without the worst 0.1 % of the pixels (docs/measured/method.md), against a long
render of either: an error that both tell alike is no matter of whose reference it is.
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
LONG = 20        # times the short render's time, for references
WORST = 0.001    # share of the pixels that is left out
EPSILON = 0.01   # of the mean's square, added where a pixel is dark


def scene_with_caustic():
    scene = scenes.stage()
    glass = scenes.material('glass', 'ShaderNodeBsdfGlass', Roughness=0, IOR=1.5)
    scenes.ball('ball', 0.8, glass, (0.9, 0.2, 0.8))
    scenes.light('POINT', 400, (-1.5, -1.5, 4), shadow_soft_size=0.1)
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
    error = (image - reference) ** 2 / (reference ** 2 + EPSILON * reference.mean() ** 2)
    worst_first = np.sort(error.mean(-1).ravel())
    return float(worst_first[:len(worst_first) - int(WORST * len(worst_first))].mean())


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
    print('| | CPU seconds | relMSE to long aips | to long Cycles |\n| --- | --- | --- | --- |')
    for name, (image, took) in short.items():
        errors = [relmse(image, long[other][0]) for other in ('aips', 'Cycles')]
        print(f'| {name} | {took:.1f} | {errors[0]:.3g} | {errors[1]:.3g} |')
    between = relmse(long['Cycles'][0], long['aips'][0])
    print(f'| long Cycles | {long["Cycles"][1]:.0f} | {between:.3g} | |', flush=True)


main()
