"""Reads what an export has written, and lets lxsrender render it."""
import os
import re
import subprocess

import numpy as np

from aips_blender import exr
from fixture import FOLDER, LXSRENDER


def lines_of(path):
    with open(path, encoding='utf-8') as file:
        return file.read().splitlines()


def render(name):
    """The image of a scene, about which lxsrender has nothing to say."""
    path = os.path.join(FOLDER, name)
    done = subprocess.run([LXSRENDER, path + '.lxs', '-o', path + '.exr', '--strict', '--quiet',
                           '--no-advice', '--no-error-estimate'],
                          capture_output=True, text=True, check=False)
    if done.returncode or done.stderr:
        raise AssertionError(f'lxsrender ended with {done.returncode}: {done.stderr}')
    return exr.read(path + '.exr').stack('RGB')


def meshes_of(text):
    """Of each of an export's PLY files, in their order, its columns by name."""
    return [_columns(os.path.join(FOLDER, path)) for path in
            re.findall(r'"string filename" \["([^"]+\.ply)"\]', text)]


def vertices_of(text):
    """Sizes of their vertex lists."""
    return [len(mesh['x']) for mesh in meshes_of(text)]


def _columns(path):
    with open(path, 'rb') as file:
        head, data = file.read().split(b'end_header\n', 1)
    names = re.findall(r'property float (\w+)', head.decode())
    count = int(re.search(rb'element vertex (\d+)', head).group(1))
    rows = np.frombuffer(data, '<f4', count * len(names)).reshape(count, -1)
    return dict(zip(names, rows.T))
