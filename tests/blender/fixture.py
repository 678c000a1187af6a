"""What tests in Blender have in common: the program, a folder, and the add-on switched on."""
import os
import sys

import addon_utils
import bpy

from aips_blender.export.film import Film
from aips_blender.export.scene import export

LXSRENDER = sys.argv[sys.argv.index('--') + 1]
FOLDER = os.environ['AIPS_TEST_FOLDER']
ADD_ON = 'aips_blender'


def enable(program=LXSRENDER):
    """The add-on is on; to be called after each reading of a file or of factory settings."""
    addon_utils.enable(ADD_ON, default_set=True)
    bpy.context.preferences.addons[ADD_ON].preferences.program = program


def exported(name, film=Film(32, 32, passes=1), frame_set=None):
    """Text of the present scene's export, and what is left out."""
    path = os.path.join(FOLDER, name + '.lxs')
    result = export(path, bpy.context.evaluated_depsgraph_get(), film, frame_set)
    with open(path, encoding='utf-8') as file:
        return file.read(), result.left_out
