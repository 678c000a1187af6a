"""Protects scripts/slurm: the tasks of an array, run as Slurm would run them, leave parts that merge,
and frames that begin with what the first learned; a task that is put back into the queue goes on from
its checkpoint. Arguments: the folder of scripts, lxsrender, the folder of scenes."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

SMALL = ['--integrator', 'aips', '--width', '24']
INTERRUPTED = 130


class Tasks:
    def __init__(self, scripts, program):
        self.scripts, self.program = scripts, program

    def begin(self, script, number, *arguments):
        """In a group of its own, which Slurm's signals reach as a whole."""
        return subprocess.Popen(['bash', self.scripts / script, *arguments, *SMALL], text=True,
                                stderr=subprocess.PIPE, start_new_session=True,
                                env=dict(os.environ, SLURM_ARRAY_TASK_ID=str(number), LXSRENDER=self.program))

    def run(self, script, number, *arguments):
        """What it says."""
        task = self.begin(script, number, *arguments)
        said = task.communicate()[1]
        if task.returncode:
            sys.exit(f'{script} ended with {task.returncode}:\n{said}')
        return said


def parts_merge(tasks, scenes, folder):
    for number in (1, 2):
        tasks.run('seeds.sbatch', number, scenes / 'cornell-box.lxs', folder / 'parts/part', '--passes', '1')
    parts = sorted(folder.glob('parts/part_*.exr'))
    subprocess.run([tasks.program.with_name('lxsmerge'), *parts, '-o', folder / 'whole.exr'], check=True)
    if list(folder.glob('parts/*.state')):
        sys.exit('a task that has ended well left its checkpoint')


def a_task_put_back_goes_on(tasks, scenes, folder):
    command = ['seeds.sbatch', 1, scenes / 'cornell-box.lxs', folder / 'back/part']
    task = tasks.begin(*command, '--passes', '1000000')
    while not (folder / 'back/part_1.png').exists() and task.poll() is None:
        time.sleep(0.01)
    os.killpg(task.pid, signal.SIGTERM)
    said = task.communicate()[1]
    # Slurm kills what a task has left when its shell ends: there must be nothing.
    if task.returncode != INTERRUPTED or not (folder / 'back/part_1.state').exists():
        sys.exit(f'a task that was to end left no checkpoint, and {task.returncode}:\n{said}')
    said = tasks.run(*command, '--passes', '1')
    if 'resumed from' not in said:
        sys.exit(f'a task that was put back began anew:\n{said}')


def frames_learn_from_the_first(tasks, scenes, folder):
    shot = folder / 'shot'
    shot.mkdir()
    for frame in (9, 10):
        (shot / f'frame_{frame}.lxs').write_text((scenes / 'cornell-box.lxs').read_text())
    for number in (1, 2):
        tasks.run('frames.sbatch', number, shot, folder / 'images', '--passes', '1')
    images = sorted(path.name for path in (folder / 'images').iterdir())
    expected = ['first.learned', 'frame_10.exr', 'frame_10.png', 'frame_9.exr', 'frame_9.png']
    if images != expected:
        sys.exit(f'found {images}')


def main():
    scripts, program, scenes = (pathlib.Path(word) for word in sys.argv[1:])
    tasks = Tasks(scripts, program)
    for holds in parts_merge, a_task_put_back_goes_on, frames_learn_from_the_first:
        with tempfile.TemporaryDirectory() as folder:
            holds(tasks, scenes, pathlib.Path(folder))


if __name__ == '__main__':
    main()
