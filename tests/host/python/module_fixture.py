"""The module of Python as it was built; common ground of its tests. Called with the folder of the
package, lxsrender, and the project's folder. Ends with 77 where the module is not built."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

BUILT, LXSRENDER, ROOT = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
SCENES = ROOT / 'scenes'
SKIPPED = 77

if not list(BUILT.glob('lxs/_lxs*.so')):
    print('skipped: the module of Python is not built: it needs pybind11, Python\'s headers and '
          'numpy (scripts/setup python)')
    sys.exit(SKIPPED)
sys.path.insert(0, str(BUILT))
import lxs  # noqa: E402

FILM = 'Film "fleximage" "integer xresolution" [24] "integer yresolution" [16]\n'
WORLD = ('LookAt 0 -4 0  0 0 0  0 0 1\nCamera "perspective"\nWorldBegin\n'
         'LightSource "point" "point from" [1 -3 2] "color L" [9 9 9]\n'
         'Material "matte"\nShape "sphere"\n')
PBRT = ('Film "rgb" "integer xresolution" 24 "integer yresolution" 16\n'
        'LookAt 0 0 4  0 0 0  0 1 0\nCamera "perspective" "float fov" 40\nWorldBegin\n'
        'LightSource "point" "float scale" 30 "point3 from" [1 2 3]\nShape "sphere"\n')


class InFolder(unittest.TestCase):
    """A test with a folder for what it writes."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name

    def small_scene(self, before=FILM, world=WORLD):
        return self.write('scene.lxs', before + world + 'WorldEnd\n')

    def by_lxsrender(self, scene, *options):
        """Renders to out.exr; the bytes of it."""
        subprocess.run([LXSRENDER, scene, *options, '-o', self.folder / 'out.exr', '--quiet'],
                       check=True, cwd=self.folder)
        return (self.folder / 'out.exr').read_bytes()


def main():
    unittest.main(argv=sys.argv[:1])
