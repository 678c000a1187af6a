"""Runs lxsrender in a process of its own and reads what it says."""
import collections
import ctypes
import os
import re
import shutil
import signal
import subprocess
import sys
import threading

from .reasons import Told

LINES_KEPT = 1000      # the latest; errors and the statistics of --explain come at the end
WARNINGS_KEPT = 500    # the first; of the scene there are a hundred kinds at most
# Of a line of progress: passes, and from the third the error in percent.
PROGRESS = re.compile(r'pass (\d+)(?: of \d+)?, [\d:]+ gone(?:.*?, error ([\d.e+-]+) %)?')
SECONDS_TO_END = 60   # of the last image, which may be denoised
SECONDS_TO_CANCEL = 1.5  # after an interrupt; then the image so far is all
INTERRUPTED = 130     # lxsrender's exit code after an interrupt, with the image written


class NotFound(Told):
    """There is no lxsrender; the text says where it was looked for."""


def find(preferred):
    """Path of lxsrender: the preferred one, or that on PATH."""
    if preferred:
        path = os.path.abspath(os.path.expanduser(preferred))
        if os.path.isfile(path) and os.access(path, os.X_OK):
            return path
        raise NotFound(f'{path} is no program that can be run: see "lxsrender" in the preferences '
                       'of the add-on aips')
    path = shutil.which('lxsrender')
    if path is None:
        raise NotFound('lxsrender is not on PATH, and the preferences of the add-on aips name none')
    return path


DEATH_OF_PARENT = 1  # Linux, prctl(2): PR_SET_PDEATHSIG


def _end_with_blender():
    """In the new process: where Blender is killed, the render ends as if interrupted."""
    ctypes.CDLL(None).prctl(DEATH_OF_PARENT, signal.SIGINT)


class Log:
    """What lxsrender has said, in little memory however long it renders.

    Lines of progress come without end, the scene's warnings before them: neither is to push the
    other out.
    """

    def __init__(self):
        self._lines = collections.deque(maxlen=LINES_KEPT)
        self._warnings = {}  # in their order; some are repeated with each image
        self._more = 0
        self.progress = ''   # the latest line of it

    def add(self, line):
        if PROGRESS.match(line):
            self.progress = line
        elif 'warning:' not in line:
            self._lines.append(line)
        elif len(self._warnings) < WARNINGS_KEPT:
            self._warnings[line] = None
        elif line not in self._warnings:
            self._more += 1

    def lines(self):
        """All but warnings and progress."""
        return list(self._lines)

    def warnings(self):
        """Each of them once."""
        more = [f'warning: and {self._more} more'] if self._more else []
        return list(self._warnings) + more


class Process:
    """A render that goes on, and its log."""

    def __init__(self, arguments, folder):
        on_linux = _end_with_blender if sys.platform.startswith('linux') else None
        # A session of its own, so that an interrupt at Blender's terminal does not reach it first.
        self._process = subprocess.Popen(arguments, cwd=folder, stdin=subprocess.DEVNULL,
                                         stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                         text=True, errors='replace', start_new_session=True,
                                         preexec_fn=on_linux)
        self.log = Log()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        for line in self._process.stderr:
            self.log.add(line.rstrip('\n'))

    def running(self):
        return self._process.poll() is None

    def interrupt(self):
        """Asks it to end after the pass, with the image written."""
        if self.running():
            self._process.send_signal(signal.SIGINT)

    def kill(self):
        """Ends it at once; nothing more is written."""
        if self.running():
            self._process.kill()
        self.wait()

    def wait(self, seconds=SECONDS_TO_END):
        """Waits for its end, and ends it where that takes longer; its exit code."""
        try:
            self._process.wait(seconds)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join(1)
        return self._process.returncode


def failure(code, lines):
    """What went wrong, from an exit code and the log's lines; None where the image is written."""
    if code in (0, INTERRUPTED):
        return None
    errors = [line for line in lines if 'error:' in line]
    first = (lines or ['no word of why'])[0]
    said = '; '.join(e.split('error: ', 1)[-1] for e in errors[:3]) or first
    return f'lxsrender ended with exit code {code}: {said}'
