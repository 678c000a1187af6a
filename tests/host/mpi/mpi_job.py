"""Starts lxsrender under mpirun; common ground of the tests of --mpi."""
import os
import pathlib
import shutil
import subprocess
import sys

NO_MPI = 'this lxsrender has no MPI: build it where Open MPI is installed, with -DAIPS_MPI=ON'


class Jobs:
    """Of the program and the folder of scenes that the test's arguments name."""

    def __init__(self, folder):
        self.program, self.scenes = sys.argv[1:]
        self.folder = pathlib.Path(folder)
        self.skip_without_mpi()
        # Containers run tests as root, and have fewer processors than ranks.
        self.environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT='1',
                                OMPI_ALLOW_RUN_AS_ROOT_CONFIRM='1',
                                OMPI_MCA_rmaps_base_oversubscribe='1',
                                # The same of Open MPI 5.
                                PRTE_MCA_rmaps_default_mapping_policy=':oversubscribe',
                                OMPI_MCA_hwloc_base_binding_policy='none',
                                OMPI_MCA_btl='self,vader')

    def skip_without_mpi(self):
        built = pathlib.Path(self.program).parent.parent / 'mpi' / 'mpi.so'
        if not built.exists():
            done = self.alone('glass-ball', '--mpi')
            expect(done.returncode == 2 and NO_MPI in done.stderr, done.stderr)
        if built.exists() and shutil.which('mpirun'):
            return
        print('skipped: no MPI in this build, or no mpirun (scripts/setup mpi, -DAIPS_MPI=ON)')
        sys.exit(77)

    def command(self, scene, name, *options):
        return [self.program, '--mpi', self.path(scene), '--threads', '1', '-o',
                str(self.folder / name), *options]

    def path(self, scene):
        return scene if scene.endswith('.lxs') else f'{self.scenes}/{scene}.lxs'

    def alone(self, scene, *options):
        return subprocess.run([self.program, self.path(scene), *options], capture_output=True,
                              text=True, timeout=100)

    def start(self, *ranks_and_commands):
        """mpirun with so many ranks of a command, and so many of another."""
        words = ['mpirun']
        for i in range(0, len(ranks_and_commands), 2):
            words += [':'] * (i > 0) + ['-n', str(ranks_and_commands[i])] + ranks_and_commands[i + 1]
        return subprocess.Popen(words, env=self.environment, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def run(self, *ranks_and_commands):
        job = self.start(*ranks_and_commands)
        out, errors = job.communicate(timeout=100)
        return subprocess.CompletedProcess(job.args, job.returncode, out, errors)

    def bytes(self, name):
        return (self.folder / name).read_bytes()


def expect(holds, otherwise):
    if not holds:
        sys.exit(f'failed: {otherwise}')
