"""Protects scripts/try-scenes: one scene that loads, with a file missing; one that does not; one that
is black; one of pbrt. Arguments: the script, the build folder."""
import pathlib
import subprocess
import sys
import tempfile

FILM = '''Film "fleximage" "integer xresolution" [200] "integer yresolution" [150]
Camera "perspective"
'''
BALL = 'Translate 0 0 4\nShape "sphere"\n'
SCENES = {
    'good/ball.lxs': FILM + 'WorldBegin\nLightSource "point"\nShape "plymesh" "string filename" '
                            '["a.ply"]\nShape "plymesh" "string filename" ["b.ply"]\n' + BALL +
                     'WorldEnd\n',
    'bad.lxs': FILM + 'WorldBegin\nLightSource "point"\nShapes "sphere"\nRotate 1 0 0 0\n' + BALL +
               'WorldEnd\n',
    'other.pbrt': 'WorldBegin\nLightSource "infinite"\nShape "sphere" "float radios" 1\n',
    'part.pbrt': 'Shape "sphere"\n',
    'dark.lxs': FILM + 'WorldBegin\nLightSource "point" "color L" [0 0 0]\n' + BALL + 'WorldEnd\n',
}
EXPECTED = {
    'bad.lxs': ['no', '', '-', '', '2'],
    'dark.lxs': ['yes', '', 'black', '1', ''],
    'other.pbrt': ['yes', '', 'black', '2', ''],
    'good/ball.lxs': ['yes', '2', 'ok', '1', ''],
}


def main():
    script, build = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        for name, text in SCENES.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)
        run = subprocess.run(
            [sys.executable, script, folder, '--build', build, '--width', '20', '--passes', '1',
             '--', '--integrator', 'path'], capture_output=True, text=True)
    rows = {}
    for line in run.stdout.splitlines():
        cells = [cell.strip() for cell in line.strip('|').split('|')]
        rows[cells[0]] = cells[1:-1]
    wrong = [name for name, cells in EXPECTED.items() if rows.get(name) != cells]
    summary = '4 scenes: 3 loaded, 1 of them without some file; 2 black, 0 white; 1 not loaded'
    if run.returncode == 1 and not wrong and summary in run.stdout:
        return
    print(run.stdout, run.stderr, f'rows that are not as expected: {wrong}', sep='\n')
    sys.exit(1)


if __name__ == '__main__':
    main()
