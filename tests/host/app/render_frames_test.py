"""Protects scripts/render-frames: frames in the order of their numbers, each a warm start from the one before;
a second call passes over what is done; the first frame that fails ends it. Arguments: the script,
lxsrender."""
import os
import pathlib
import subprocess
import sys
import tempfile

SCENE = '''LookAt 0 -5 0  0 0 0  0 0 1
Camera "perspective" "float fov" [40]
Film "fleximage" "integer xresolution" [8] "integer yresolution" [6]
WorldBegin
LightSource "point" "point from" [%g -5 3] "color L" [40 40 40]
LightSource "point" "point from" [-1 -5 3] "color L" [40 40 40]
Shape "sphere"
WorldEnd
'''


def main():
    script, program = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for number in (2, 9, 10):
            (folder / f'f{number}.lxs').write_text(SCENE % number)

        def run(*options):
            ended = subprocess.run(
                [sys.executable, script, folder, '--lxsrender', program, *options, '--', '--integrator', 'path',
                 '--passes', '2', '--quiet'], capture_output=True, text=True)
            return ended.returncode, ended.stderr

        code, text = run()
        assert code == 0, text
        assert [line.split(': ')[1] for line in text.splitlines() if line.startswith('frame ')] == \
            ['f2.lxs', 'f9.lxs', 'f10.lxs'], text
        assert '3 frames are done, 0 of them were before' in text, text
        images = {path.name: path.read_bytes() for path in folder.glob('*.exr')}
        assert len(set(images.values())) == 3, 'frames with the same noise'

        # What is lost is made again, and is the same.
        os.remove(folder / 'f9.done')
        (folder / 'f9.exr').write_bytes(b'')
        code, text = run()
        assert code == 0 and 'frame 2 of 3: f9.lxs' in text and '2 of them were before' in text, text
        assert (folder / 'f9.exr').read_bytes() == images['f9.exr']

        code, text = run('--out', folder / 'cold', '--cold')
        assert code == 0 and not list((folder / 'cold').glob('*.learned')), text

        (folder / 'f9.lxs').write_text('Nonsense')
        code, text = run()
        assert code == 3 and "f9.lxs' ended with exit code 3; the frames before it are done" in text, text
        assert (folder / 'f10.exr').read_bytes() == images['f10.exr']

        code, text = run('--lxsrender', folder / 'nothing-here')
        assert code == 2, text
        (folder / 'empty').mkdir()
        ended = subprocess.run([sys.executable, script, folder / 'empty'], capture_output=True, text=True)
        assert ended.returncode == 2 and 'there is no scene file' in ended.stderr, ended.stderr
        ended = subprocess.run([sys.executable, script, folder, '--', '--learned-in', 'a'],
                               capture_output=True, text=True)
        assert ended.returncode == 2 and '--learned-in is given by render-frames itself' in ended.stderr, ended.stderr


if __name__ == '__main__':
    main()
