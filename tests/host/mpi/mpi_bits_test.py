"""Protects: the files of lxsrender --mpi are those of one process, byte for byte, with any number of
ranks, and where a render goes on with another number of them; by whole passes, those of lxsmerge."""
import pathlib
import subprocess
import tempfile

from mpi_job import Jobs, expect

# With a lamp in glass, which emitter paths and eye paths share; and with a guide that learns.
RENDERS = {
    'glass-ball': ('--integrator', 'aips', '--width', '64', '--passes', '5'),
    'ajar-door': ('--integrator', 'aips', '--width', '48', '--passes', '5', '--set',
                  'aips.guidescout=false', '--set', 'aips.photonperpass=60000'),
}


def same_files(jobs):
    for scene, options in RENDERS.items():
        done = jobs.alone(scene, *options, '-o', str(jobs.folder / 'alone.exr'))
        expect(done.returncode == 0, done.stderr)
        for ranks in (1, 2, 3, 5) if scene == 'glass-ball' else (1, 2, 3):
            done = jobs.run(ranks, jobs.command(scene, 'job.exr', *options))
            expect(done.returncode == 0, done.stderr)
            for suffix in ('exr', 'png'):
                expect(jobs.bytes(f'job.{suffix}') == jobs.bytes(f'alone.{suffix}'),
                       f'{scene} on {ranks} ranks has another {suffix}')


def goes_on_with_another_number(jobs):
    options = [word for word in RENDERS['ajar-door']]
    state = ['--checkpoint', str(jobs.folder / 'state'), '--resume']
    passes = options.index('--passes') + 1
    for ranks, until in ((3, '2'), (2, '4'), (1, '5')):
        options[passes] = until
        done = jobs.run(ranks, jobs.command('ajar-door', 'job.exr', *options, *state))
        expect(done.returncode == 0, done.stderr)
    jobs.alone('ajar-door', *options, '-o', str(jobs.folder / 'alone.exr'), '--checkpoint',
               str(jobs.folder / 'other state'))
    expect(jobs.bytes('job.exr') == jobs.bytes('alone.exr'), 'resumed with another number of ranks')


def passes_are_merged(jobs):
    scene, size = 'glass-ball', ('--integrator', 'path', '--width', '48')
    parts = []
    for seed, passes in ((7, 2), (8, 1)):
        parts.append(str(jobs.folder / f'{seed}.exr'))
        jobs.alone(scene, *size, '--seed', str(seed), '--passes', str(passes), '-o', parts[-1])
    merge = pathlib.Path(jobs.program).with_name('lxsmerge')
    subprocess.run([merge, *parts, '-o', jobs.folder / 'merged.exr', '--quiet'], check=True)
    options = [*size, '--seed', '7', '--passes', '3', '--mpi-split', 'passes']
    done = jobs.run(2, jobs.command(scene, 'split.exr', *options))
    expect(done.returncode == 0, done.stderr)
    expect(jobs.bytes('split.exr') == jobs.bytes('merged.exr'), '--mpi-split passes is no lxsmerge')
    expect(not list(jobs.folder.glob('*_part*')), 'parts are left')


def main():
    with tempfile.TemporaryDirectory() as folder:
        jobs = Jobs(folder)
        same_files(jobs)
        goes_on_with_another_number(jobs)
        passes_are_merged(jobs)


if __name__ == '__main__':
    main()
