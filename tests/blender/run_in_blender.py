#!/usr/bin/env python3
"""Runs test modules in a real Blender without a window and without the user's settings.

    run_in_blender.py --lxsrender build/release/bin/lxsrender export_test render_test

Ends with 77, which ctest takes for skipped, where there is no Blender: scripts/setup blender.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SKIPPED = 77


def environment(folder, blender):
    """The user's settings and add-ons are out of reach, temporary files in the folder."""
    # Packaged Blenders look for their Python's library beside the first python3 on PATH.
    path = os.pathsep.join([str(pathlib.Path(blender).parent), os.environ.get('PATH', '')])
    return {**os.environ, 'PATH': path, 'BLENDER_USER_CONFIG': folder,
            'BLENDER_USER_SCRIPTS': folder, 'BLENDER_USER_EXTENSIONS': folder,
            'TMPDIR': folder, 'AIPS_TEST_FOLDER': folder}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--lxsrender', type=pathlib.Path, required=True)
    parser.add_argument('--blender', default='blender')
    parser.add_argument('tests', nargs='+', help='modules of this folder, or module.Class.test')
    arguments = parser.parse_args()
    blender = shutil.which(arguments.blender)
    if blender is None:
        print('skipped: there is no Blender; scripts/setup blender installs it')
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix='aips-blender-') as folder:
        return subprocess.run(
            [blender, '-b', '-noaudio', '--factory-startup', '--python-exit-code', '1',
             '--python', str(HERE / 'in_blender.py'), '--', str(arguments.lxsrender.resolve()),
             *arguments.tests],
            env=environment(folder, blender), cwd=folder, check=False).returncode


if __name__ == '__main__':
    sys.exit(main())
