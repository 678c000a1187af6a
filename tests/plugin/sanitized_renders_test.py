#!/usr/bin/env python3
"""Protects the memory of whole renders by the module `aips`, under the address and
undefined-behaviour sanitizers.

    sanitized_renders_test.py LXSRENDER SCENES

Renders small images with the aips.so in the folder that AIPS_SANITIZED_PLUGINS names, which is built
with the sanitizers (.ci/run); lxsrender itself need not be. Exit code 77: nothing is named.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FOG = '''Film "fleximage" "integer xresolution" [16] "integer yresolution" [12]
LookAt 0 -4 1  0 0 1  0 0 1
Camera "perspective" "float fov" [40]
SurfaceIntegrator "aips"
WorldBegin
MakeNamedVolume "fog" "homogeneous" "color sigma_s" [0.2 0.2 0.2] "color sigma_a" [0.05 0.05 0.05]
Exterior "fog"
LightSource "point" "point from" [0 0 3]
Material "matte"
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-3 -3 0 3 -3 0 3 3 0 -3 3 0]
Interior ""
Material "glass"
Translate 0 0 1
Shape "sphere" "float radius" [0.5]
WorldEnd
'''
# What each render is to reach, and its further arguments.
RENDERS = [
    ('cornell-box', []),
    *[('cornell-box', ['--set', 'aips.photonperpass=20000', '--set', f'aips.guide={guide}'])
      for guide in ('adaptive', 'paper', 'none')],
    *[('cornell-box', ['--integrator', method, '--set', f'{method}.photonperpass=20000'])
      for method in ('sppm', 'ppm', 'exphotonmap')],
    ('glass-ball', []),  # chains of glass
    ('pool', []),        # emitter paths, caustics
    ('prism', []),       # wavelengths
    ('hall', []),        # learned lights
    ('daylight', []),    # sun and sky
    ('fog', []),         # beams
]


def small(text):
    """The scene with a small film."""
    text = re.sub(r'("integer xresolution" *\[) *\d+', r'\g<1>16', text)
    return re.sub(r'("integer yresolution" *\[) *\d+', r'\g<1>12', text)


def environment(module):
    """Loads the sanitizer that the module was linked with before all else."""
    libraries = subprocess.run(['ldd', module], check=True, text=True, capture_output=True).stdout
    runtime = re.search(r'=> (\S*libasan\S*)', libraries)
    if not runtime:
        sys.exit(f'{module} is not linked with the address sanitizer')
    # What libraries keep to the end of a process is no leak of ours.
    return dict(os.environ, LD_PRELOAD=runtime[1], ASAN_OPTIONS='detect_leaks=0',
                UBSAN_OPTIONS='print_stacktrace=1')


def main():
    folder = os.environ.get('AIPS_SANITIZED_PLUGINS')
    if not folder:
        print('AIPS_SANITIZED_PLUGINS names no folder')
        sys.exit(77)
    lxsrender, scenes = sys.argv[1], pathlib.Path(sys.argv[2])
    sanitized = environment(pathlib.Path(folder) / 'aips.so')
    run = [lxsrender, '--plugin-path', folder]
    known = subprocess.run([*run, '--list-plugins'], env=sanitized, text=True, capture_output=True)
    if f'{pathlib.Path(folder).resolve()}/aips.so' not in known.stdout:
        sys.exit(f'the module is not loaded:\n{known.stdout}{known.stderr}')
    failed = 0
    with tempfile.TemporaryDirectory() as work:
        (pathlib.Path(work) / 'meshes').symlink_to(scenes / 'meshes')
        for name, arguments in RENDERS:
            text = FOG if name == 'fog' else (scenes / f'{name}.lxs').read_text()
            (pathlib.Path(work) / f'{name}.lxs').write_text(small(text))
            render = [*run, f'{name}.lxs', '--passes', '4', '-o', 'x.exr', *arguments]
            if name == 'cornell-box' and not arguments:  # and what is saved, and read again
                render += ['--checkpoint', 'x.ckpt', '--learned-out', 'x.learned']
            renders = [render]
            if '--checkpoint' in render:
                renders.append([*run, f'{name}.lxs', '--passes', '6', '-o', 'x.exr', '--checkpoint', 'x.ckpt',
                                '--resume'])
                renders.append([*run, f'{name}.lxs', '--passes', '2', '-o', 'x.exr', '--learned-in',
                                'x.learned', '--seed', '1'])
            for command in renders:
                ended = subprocess.run(command, cwd=work, env=sanitized, text=True,
                                       capture_output=True, errors='replace')
                if ended.returncode != 0:
                    failed += 1
                    print(f'{" ".join(command)}: exit code {ended.returncode}\n{ended.stderr[-6000:]}')
    print(f'{len(RENDERS)} scenes, {failed} renders failed')
    sys.exit(1 if failed else 0)


if __name__ == '__main__':
    main()
