#!/usr/bin/env python3
"""Protects lxsrender --serve from outside: who is answered, that the render pauses, goes on, ends and
saves when it is told to, and that being watched changes no bit of its image.

    serve_test.py LXSRENDER
"""
import socket
import struct
import subprocess
import threading
import time
import unittest

from watched_render import LXSRENDER, SCENE, WatchedRender, main

LONG = ('--integrator', 'path', '--passes', '100000000')


def passes(state):
    return (state['render'] or {}).get('passes', 0)


class Answers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.render = WatchedRender(*LONG).__enter__()
        cls.render.wait_for_state(lambda state: passes(state) > 8)

    @classmethod
    def tearDownClass(cls):
        cls.render.__exit__()

    def status(self, *arguments, **options):
        return self.render.ask(*arguments, **options)[0]

    def test_page(self):
        status, body = self.render.ask('')
        self.assertEqual(status, 200)
        self.assertIn(b'<title>lxsrender</title>', body)

    def test_other_tokens(self):
        for token in ('', '0' * 32, self.render.token[:-1], self.render.token + '0', '..'):
            self.assertEqual(self.status('state', token=token), 403, token)

    def test_other_hosts_and_origins(self):
        for headers in ({'Host': 'evil.example'}, {'Host': f'evil.example:{self.render.port}'},
                        {'Origin': 'http://evil.example'}, {'Origin': 'null'},
                        {'Sec-Fetch-Site': 'cross-site'}):
            self.assertEqual(self.status('state', headers=headers), 403, headers)
            self.assertEqual(self.status('stop', 'POST', headers=headers), 403, headers)
        self.assertEqual(self.status('stop', 'POST'), 403)
        self.assertFalse(self.render.state()['stop'])

    def test_no_other_file(self):
        for what in ('../', 'scene.lxs', '..%2f..%2fetc/passwd', 'page.html', 'state/'):
            self.assertEqual(self.status(what), 404, what)
        self.assertEqual(self.status('state', 'DELETE',
                                     headers={'Origin': f'http://127.0.0.1:{self.render.port}'}), 405)

    def test_listens_on_this_machine_alone(self):
        with open('/proc/net/tcp', encoding='ascii') as table:
            local = [line.split()[1] for line in table if line.split()[3] == '0A']
        mine = [place for place in local if int(place.split(':')[1], 16) == self.render.port]
        self.assertEqual(mine, [f'0100007F:{self.render.port:04X}'])

    def raw(self, data):
        with socket.create_connection(('127.0.0.1', self.render.port), timeout=30) as connection:
            connection.sendall(data)
            connection.shutdown(socket.SHUT_WR)
            try:
                return connection.recv(65536)
            except ConnectionResetError:
                return b''

    def test_what_is_no_request(self):
        host = f'Host: 127.0.0.1:{self.render.port}\r\n'.encode()
        self.assertIn(b' 400 ', self.raw(b'\x00\xff rubbish\r\n\r\n'))
        self.assertIn(b' 400 ', self.raw(b'GET / HTTP/9.9\r\n\r\n'))
        self.assertEqual(self.raw(b''), b'')
        self.assertIn(b' 400 ', self.raw(b'GET / HT'))
        self.assertIn(b' 431 ', self.raw(b'GET / HTTP/1.1\r\n' + host + b'X: ' + b'y' * 20000))
        body = b'POST / HTTP/1.1\r\n' + host + b'Content-Length: 1000000\r\n\r\n'
        self.assertIn(b' 413 ', self.raw(body + b'z' * 1000))
        self.assertGreater(passes(self.render.state()), 8)

    def test_many_silent_connections(self):
        """What only connects takes a place until it is closed; afterwards there is one again."""
        silent = [socket.create_connection(('127.0.0.1', self.render.port)) for _ in range(40)]
        for connection in silent:
            connection.close()
        self.assertGreater(passes(self.render.wait_for_state(lambda state: state['render'])), 8)

    def test_image(self):
        self.render.wait_for_state(lambda state: state['image'] > 0)
        status, body = self.render.ask('image')
        self.assertEqual(status, 200)
        width, height, channels, number = struct.unpack('<4I', body[:16])
        self.assertEqual((width, height, channels), (32, 24, 3))
        self.assertGreater(number, 0)
        values = struct.unpack(f'<{32 * 24 * 3}f', body[16:])
        self.assertGreater(max(values), 0)
        self.assertGreaterEqual(min(values), 0)

    def test_error_and_its_layer(self):
        state = self.render.wait_for_state(lambda state: state['render']['error']['curve'])
        self.assertGreater(state['render']['error']['now'], 0)
        state = self.render.wait_for_state(lambda state: state['render']['layers'])
        number = [layer['name'] for layer in state['render']['layers']].index('error')
        while self.render.ask(f'layer/{number}')[0] == 204:
            self.render.state()
            time.sleep(0.05)
        body = self.render.ask(f'layer/{number}')[1]
        self.assertEqual(struct.unpack('<3I', body[:12]), (32, 24, 3))


class Orders(unittest.TestCase):
    def test_pause_resume_stop(self):
        with WatchedRender(*LONG, '-o', 'a.exr', '--checkpoint', 'c.ckpt') as render:
            render.wait_for_state(lambda state: passes(state) > 8)
            render.order('pause')
            paused = render.wait_for_state(lambda state: state['render']['phase'] == 'paused')
            time.sleep(0.4)
            later = render.state()
            for what in ('passes', 'seconds'):
                self.assertEqual(later['render'][what], paused['render'][what])
            render.order('resume')
            render.wait_for_state(lambda state: passes(state) > passes(paused))
            render.order('stop')
            code, messages = render.end()
            self.assertEqual(code, 130)
            self.assertIn('stopped by whoever watches its page', messages)
            self.assertIn('wrote a.exr and a.png', messages)
            for name in ('a.exr', 'a.png', 'c.ckpt'):
                self.assertTrue((render.path / name).exists(), name)

    def test_stop_while_paused(self):
        with WatchedRender(*LONG) as render:
            render.wait_for_state(lambda state: passes(state) > 0)
            render.order('pause')
            at = passes(render.wait_for_state(lambda state: state['render']['phase'] == 'paused'))
            render.order('stop')
            code, messages = render.end()
            self.assertEqual(code, 130)
            self.assertIn(f'rendered {at} passes', messages)

    def test_signal_while_paused(self):
        with WatchedRender(*LONG) as render:
            render.wait_for_state(lambda state: passes(state) > 0)
            render.order('pause')
            render.wait_for_state(lambda state: state['render']['phase'] == 'paused')
            render.interrupt()
            code, messages = render.end()
            self.assertEqual(code, 130)
            self.assertIn('stopped by Ctrl-C or a signal', messages)

    def test_who_watches_sees_the_end(self):
        with WatchedRender('--integrator', 'path', '--time', '1.5') as render:
            state = render.wait_for_state(lambda state: state['render']['phase'] == 'ended')
            self.assertIn('out.exr and out.png', state['render']['message'])
            self.assertEqual(render.end()[0], 0)


class Bits(unittest.TestCase):
    def test_the_image_is_the_same(self):
        """With a watcher that asks for all there is, the file has the same bytes."""
        options = ('--integrator', 'aips', '--passes', '24', '-o', 'a.exr',
                   '--set', 'aips.debuglayers=true')
        with WatchedRender(*options, width=64, height=48) as render:
            watcher = threading.Thread(target=self.watch, args=(render,))
            watcher.start()
            code, messages = render.end()
            watcher.join()
            self.assertEqual(code, 0, messages)
            watched = (render.path / 'a.exr').read_bytes()
            (render.path / 'scene.lxs').write_text(SCENE % {'width': 64, 'height': 48})
            subprocess.run([LXSRENDER, 'scene.lxs', *options, '--quiet'], cwd=render.path, check=True)
            self.assertEqual((render.path / 'a.exr').read_bytes(), watched)
        self.assertGreater(self.pictures, 0)

    def watch(self, render):
        self.pictures = number = 0
        try:
            while render.process.poll() is None:
                state = render.state()
                self.pictures = max(self.pictures, state['image'])
                render.ask('image')
                number = (number + 1) % max(1, len(state['render'].get('layers', [])))
                render.ask(f'layer/{number}')
        except OSError:
            pass  # it has ended


class Port(unittest.TestCase):
    def test_a_port_that_is_taken(self):
        with socket.create_server(('127.0.0.1', 0)) as taken:
            port = taken.getsockname()[1]
            with WatchedRender('--passes', '1') as render:
                ended = subprocess.run([LXSRENDER, 'scene.lxs', '--serve', str(port)],
                                       cwd=render.path, capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 5, ended.stderr)
        self.assertIn(f'cannot listen on 127.0.0.1:{port}: Address already in use', ended.stderr)

    def test_nothing_is_served_unless_asked_for(self):
        with WatchedRender('--passes', '1') as render:
            ended = subprocess.run([LXSRENDER, 'scene.lxs', '--passes', '1'], cwd=render.path,
                                   capture_output=True, text=True, check=True)
        self.assertNotIn('http://', ended.stderr)


if __name__ == '__main__':
    main()
