"""Renders the project's scenes in LuxRender's own process, by aips and by its own integrators."""
import os
import pathlib
import re
import resource
import subprocess
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / 'host/blender'))
from aips_blender import exr  # noqa: E402

SCENES = ROOT / 'scenes'
REPLACED = 'Film Renderer SurfaceIntegrator VolumeIntegrator Sampler PixelFilter Accelerator'.split()
DEPTH = 24  # surfaces of a path, for all integrators
INTEGRATORS = {
    'aips': f'Renderer "aips" SurfaceIntegrator "aips" '
            f'"integer maxeyedepth" [{DEPTH}] "integer maxphotondepth" [{DEPTH}]',
    'bidirectional': f'Renderer "sampler" SurfaceIntegrator "bidirectional" '
                     f'"integer eyedepth" [{DEPTH}] "integer lightdepth" [{DEPTH}]',
    'sppm': f'Renderer "sppm" SurfaceIntegrator "sppm" '
            f'"integer maxeyedepth" [{DEPTH}] "integer maxphotondepth" [{DEPTH}]'}


def without(statement, head):
    """The text without a statement and its parameters, which go on to the next name."""
    return re.sub(rf'^{statement}\b.*?(?=^[A-Z]|\Z)', '', head, flags=re.S | re.M)


def film(name, size, samples, more=''):
    return (f'Film "fleximage" "integer xresolution" [{size[0]}] "integer yresolution" [{size[1]}] '
            f'"string filename" ["{name}"] "integer haltspp" [{samples}] '
            '"bool write_exr" ["true"] "bool write_exr_applyimaging" ["false"] '
            '"bool write_exr_halftype" ["false"] "string write_exr_channels" ["RGB"] '
            '"string write_exr_compressiontype" ["ZIP (lossless)"] "bool write_png" ["false"] '
            '"string tonemapkernel" ["linear"] "integer displayinterval" [3600] '
            f'"integer writeinterval" [3600] "bool write_resume_flm" ["false"] {more}\n')


class Rendered:
    def __init__(self, text, seconds, image):
        self.text = text        # what the console said
        self.seconds = seconds  # CPU seconds
        self.image = image      # rows x columns x RGB, or None


class LuxConsole:
    """`program` is LuxRender's luxconsole, `module` the shared object to preload."""

    def __init__(self, program, module, folder):
        self.program, self.module = (pathlib.Path(file).resolve() for file in (program, module))
        self.folder = pathlib.Path(folder)

    def render(self, scene, integrator, samples, width, parameters='', film_parameters='',
               name='image', threads=2, integrator_text=None,
               volumes='none', arguments=()):
        """A scene of the project by name, or the text of a whole one."""
        text = scene if 'WorldBegin' in scene else (SCENES / f'{scene}.lxs').read_text()
        head, world = text.split('WorldBegin', 1)
        across, down = (int(re.search(rf'"integer {axis}resolution"\s*\[\s*(\d+)', head)[1])
                        for axis in 'xy')
        for statement in REPLACED:
            head = without(statement, head)
        target = self.folder / name
        head += (f'\n{integrator_text or INTEGRATORS[integrator]} {parameters}\n'
                 f'VolumeIntegrator "{volumes}"\nSampler "random"\nAccelerator "qbvh"\n'
                 'PixelFilter "box" "float xwidth" [0.5] "float ywidth" [0.5]\n'
                 + film(target, (width, round(down * width / across)), samples, film_parameters))
        world = world.replace('"meshes/', f'"{SCENES}/meshes/')
        path = target.with_suffix('.lxs')
        path.write_text(f'{head}WorldBegin{world}')
        return self.run(path, ['-t', str(threads), *arguments])

    def environment(self):
        return {**os.environ, 'LD_PRELOAD': str(self.module)}

    def node(self, port, with_aips=True):
        """A node of LuxRender's network on this machine, to be ended by who asked for it."""
        process = subprocess.Popen([self.program, '-s', '-p', str(port)], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   env=self.environment() if with_aips else None)
        while 'listening' not in (line := process.stdout.readline()) and line:
            pass
        return process

    def run(self, path, arguments):
        written = path.with_suffix('.exr')
        written.unlink(missing_ok=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([self.program, *arguments, path], check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=1800,
                              env=self.environment())
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        image = exr.read(written).stack('RGB').astype(float) if written.exists() else None
        return Rendered(done.stdout, after.ru_utime - before.ru_utime, image)


def blocks(image, across=8):
    """Means of blocks, of all colours together."""
    rows, columns = (size // across for size in image.shape[:2])
    whole = image[:rows * across, :columns * across]
    return whole.reshape(across, rows, across, columns, 3).mean((1, 3, 4))


def block_differences(image, reference):
    """Of the means of blocks, relative; a block below a tenth of the image counts as if it were
    that bright."""
    ours, theirs = blocks(image), blocks(reference)
    return (ours - theirs) / np.maximum(theirs, 0.1 * theirs.mean())


def errors(image, reference):
    """relMSE of the whole and without the worst 0.1 % of the pixels (docs/measured/method.md)."""
    dark = (0.01 * reference.mean()) ** 2
    error = ((image - reference) ** 2 / (reference ** 2 + dark)).mean(-1).ravel()
    return error.mean(), np.sort(error)[:-max(1, error.size // 1000)].mean()
