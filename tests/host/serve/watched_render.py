"""A render by lxsrender --serve, as its watchers meet it."""
import http.client
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

LXSRENDER = sys.argv[1] if len(sys.argv) > 1 else 'build/release/bin/lxsrender'
SKIPPED = 77  # to ctest: this test can't be run here
PATIENCE = 60  # seconds, for machines that are busy

SCENE = '''LookAt 0 -5 1  0 0 0  0 0 1
Camera "perspective" "float fov" [40]
Film "fleximage" "integer xresolution" [%(width)d] "integer yresolution" [%(height)d]
  "string filename" ["out"]
WorldBegin
AttributeBegin
AreaLightSource "area" "color L" [20 18 15]
Translate 0 0 4
Shape "sphere" "float radius" [0.5]
AttributeEnd
AttributeBegin
AreaLightSource "area" "color L" [2 3 5]
Translate -3 -1 2
Shape "sphere" "float radius" [0.4]
AttributeEnd
MakeNamedMaterial "ground" "string type" ["matte"] "color Kd" [0.6 0.6 0.6]
NamedMaterial "ground"
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3]
  "point P" [-4 -4 -1  4 -4 -1  4 4 -1  -4 4 -1]
MakeNamedMaterial "ball" "string type" ["glass"]
NamedMaterial "ball"
Shape "sphere" "float radius" [1]
WorldEnd
'''


class WatchedRender:
    """A running lxsrender in a folder of its own; ended at the end of the block."""

    def __init__(self, *options, width=32, height=24):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        (self.path / 'scene.lxs').write_text(SCENE % {'width': width, 'height': height})
        self.messages = self.path / 'messages'
        with self.messages.open('w') as messages:
            self.process = subprocess.Popen([LXSRENDER, 'scene.lxs', '--serve', *options],
                                            cwd=self.path, stdin=subprocess.DEVNULL,
                                            stdout=subprocess.DEVNULL, stderr=messages)
        self.port, self.token = self._link()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.folder.cleanup()

    def _link(self):
        found = wait_for(lambda: re.search(r'http://127\.0\.0\.1:(\d+)/(\w+)/',
                                           self.messages.read_text()))
        return int(found[1]), found[2]

    @property
    def link(self):
        return f'http://127.0.0.1:{self.port}/{self.token}/'

    def ask(self, what, method='GET', token=None, headers=None):
        """Status and body."""
        connection = http.client.HTTPConnection('127.0.0.1', self.port, timeout=PATIENCE)
        try:
            path = f'/{self.token if token is None else token}/{what}'
            connection.request(method, path, headers=headers or {})
            reply = connection.getresponse()
            return reply.status, reply.read()
        finally:
            connection.close()

    def order(self, what):
        status, body = self.ask(what, 'POST', headers={'Origin': f'http://127.0.0.1:{self.port}'})
        assert status == 200, (status, body)
        return json.loads(body)

    def state(self):
        status, body = self.ask('state')
        assert status == 200, (status, body)
        return json.loads(body)

    def wait_for_state(self, holds):
        return wait_for(lambda: (lambda state: state if holds(state) else None)(self.state()))

    def interrupt(self):
        self.process.send_signal(signal.SIGINT)

    def end(self):
        """Exit code and messages."""
        return self.process.wait(timeout=PATIENCE), self.messages.read_text()


def wait_for(something):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        found = something()
        if found:
            return found
        time.sleep(0.05)
    raise AssertionError(f'not within {PATIENCE} s')


def has_page():
    """Whether this lxsrender was built with a page."""
    asked = subprocess.run([LXSRENDER, '--serve', '0', '--list-plugins'], capture_output=True,
                           text=True, check=False)
    return 'has no page' not in asked.stderr


def main():
    if not has_page():
        print('skipped: lxsrender was built without the page of --serve (AIPS_SERVE)')
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
