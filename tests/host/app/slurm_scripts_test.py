"""Protects scripts/slurm: the tasks of an array, run as Slurm would run them, leave parts that merge,
and frames that begin with what the first learned. Arguments: the folder of scripts, lxsrender, the
folder of scenes."""
import os
import pathlib
import subprocess
import sys
import tempfile

SMALL = ['--integrator', 'aips', '--width', '24', '--passes', '1', '--quiet']


def main():
    scripts, program, scenes = (pathlib.Path(word) for word in sys.argv[1:])

    def task(script, number, *arguments):
        subprocess.run(['bash', scripts / script, *arguments, *SMALL], check=True, text=True,
                       env=dict(os.environ, SLURM_ARRAY_TASK_ID=str(number), LXSRENDER=program))

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for number in (1, 2):
            task('seeds.sbatch', number, scenes / 'cornell-box.lxs', folder / 'parts/part')
        parts = sorted(folder.glob('parts/part_*.exr'))
        subprocess.run([program.with_name('lxsmerge'), *parts, '-o', folder / 'whole.exr'],
                       check=True)
        if list(folder.glob('parts/*.state')):
            sys.exit('a task that has ended well left its checkpoint')
        shot = folder / 'shot'
        shot.mkdir()
        for frame in (9, 10):
            (shot / f'frame_{frame}.lxs').write_text((scenes / 'cornell-box.lxs').read_text())
        for number in (1, 2):
            task('frames.sbatch', number, shot, folder / 'images')
        images = sorted(path.name for path in (folder / 'images').iterdir())
        expected = ['first.learned', 'frame_10.exr', 'frame_10.png', 'frame_9.exr', 'frame_9.png']
        if images != expected:
            sys.exit(f'found {images}')


if __name__ == '__main__':
    main()
