#!/usr/bin/env python3
"""Protects the add-on's zip: Blender installs it, switches it on, renders, and switches it off.

Blender 4.2 and later install it as an extension, whose manifest they find to be valid.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from run_in_blender import SKIPPED, environment

ROOT = pathlib.Path(__file__).resolve().parents[2]
IN_BLENDER = '''
import bpy
if bpy.app.version < (4, 2, 0):
    name = 'aips_blender'
    bpy.ops.preferences.addon_install(filepath={zip!r})
    bpy.ops.preferences.addon_enable(module=name)
else:
    name = 'bl_ext.user_default.aips_blender'
    bpy.ops.extensions.package_install_files(filepath={zip!r}, repo='user_default',
                                             enable_on_install=True)
bpy.context.preferences.addons[name].preferences.program = {lxsrender!r}
scene = bpy.context.scene
scene.render.engine, scene.render.filepath = 'AIPS', {image!r}
scene.render.resolution_x, scene.render.resolution_y = 32, 24
scene.aips.until, scene.aips.passes = 'PASSES', 2
bpy.ops.render.render(write_still=True)
bpy.ops.preferences.addon_disable(module=name)
assert not hasattr(bpy.types.Scene, 'aips')
'''


def has_extensions(blender):
    said = subprocess.run([blender, '--version'], capture_output=True, text=True, check=True).stdout
    major, minor = re.search(r'Blender (\d+)\.(\d+)', said).groups()
    return (int(major), int(minor)) >= (4, 2)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--lxsrender', type=pathlib.Path, required=True)
    lxsrender = parser.parse_args().lxsrender.resolve()
    blender = shutil.which('blender')
    if blender is None:
        print('skipped: there is no Blender; scripts/setup blender installs it')
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix='aips-blender-') as name:
        folder = pathlib.Path(name)
        first, second, image = folder / 'a.zip', folder / 'b.zip', folder / 'image.png'
        for path in (first, second):
            subprocess.run([sys.executable, str(ROOT / 'scripts/blender-addon'), '-o', str(path)],
                           check=True)
        assert first.read_bytes() == second.read_bytes(), 'the same files make other bytes'
        if has_extensions(blender):
            subprocess.run([blender, '--command', 'extension', 'validate', str(first)],
                           env=environment(name, blender), check=True)
        script = IN_BLENDER.format(zip=str(first), lxsrender=str(lxsrender), image=str(image))
        code = subprocess.run(
            [blender, '-b', '-noaudio', '--factory-startup', '--python-exit-code', '1',
             '--python-expr', script], env=environment(name, blender), check=False).returncode
        return code or int(not image.exists())


if __name__ == '__main__':
    sys.exit(main())
