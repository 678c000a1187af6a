"""Protects that scripts/setup knows the groups that scripts and pages ask it for, that its list names
no package of one release alone, and that scripts/in-debian says so where it can make no system."""
import os
import pathlib
import re
import shutil
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SETUP = ROOT / 'scripts/setup'
IN_DEBIAN = ROOT / 'scripts/in-debian'
# Numbers that belong to the name of what is packaged.
NUMBERED = {'librandom123-dev', 'nlohmann-json3-dev', 'libcli11-dev', 'python3', 'python3-numpy', 'help2man',
            'zlib1g-dev', 'pybind11-dev', 'python3-dev'}


def groups():
    """{name: [packages]}, without those of other groups."""
    found = {}
    for line in (ROOT / 'scripts/packages.txt').read_text().splitlines():
        if header := re.match(r'\[([a-z]+)(?:: ([a-z ]+))?\]  \S', line):
            own = found.setdefault(header[1], [])
            for other in (header[2] or '').split():
                assert other in found, f'{line}: {other} comes later, or not at all'
        elif line and not line.startswith('#'):
            own.append(line.split()[0])
            assert len(line.split()) > 1, f'{line}: for what?'
    return found


class Packages(unittest.TestCase):
    def test_no_name_has_a_version(self):
        for names in groups().values():
            for name in names:
                if name not in NUMBERED:
                    self.assertIsNone(re.search(r'\d', name), name)

    def test_what_is_asked_for_is_listed(self):
        call = re.compile(r"""scripts/setup(?:['"],)?["'`]?((?: ['"]?[a-z]+\b['"]?)*)""")
        known = set(groups())
        files = [ROOT / 'README.md', ROOT / '.ci/run', *(ROOT / 'docs').rglob('*.md'),
                 *(file for file in (ROOT / 'scripts').iterdir() if file.is_file())]
        asked = set()
        for file in files:
            for line in file.read_text().splitlines():
                if re.match(r'^\s*("\$root/)?scripts/setup"?( |$)', line) or 'subprocess' in line:
                    words = call.search(line.split('#')[0])
                    asked |= set(re.findall('[a-z]+', words[1])) if words else set()
        self.assertLessEqual({'render', 'test', 'develop', 'page', 'mpi'}, asked)
        self.assertLessEqual(asked, known)

    def test_pages_tell_of_every_group(self):
        page = (ROOT / 'docs/build-on/building.md').read_text()
        for group in groups():
            self.assertIn(f'| `{group}` |', page)

    def test_unknown_group(self):
        result = subprocess.run([SETUP, 'nothing'], capture_output=True, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertIn('unknown group nothing; there are render python', result.stderr)


class InDebian(unittest.TestCase):
    def test_unknown_release(self):
        result = subprocess.run([IN_DEBIAN, '7', 'true'], capture_output=True, text=True)
        self.assertEqual(result.returncode, 2)

    def test_without_rights(self):
        command = [IN_DEBIAN, '13', 'true']
        if os.geteuid() == 0:
            if not shutil.which('setpriv'):
                self.skipTest('no setpriv')
            command = ['setpriv', '--reuid=65534', '--clear-groups', *command]
        elif subprocess.run(['sudo', '-n', 'true'], capture_output=True).returncode == 0:
            self.skipTest('sudo gives the rights')
        result = subprocess.run(command, capture_output=True, text=True)
        if result.returncode == 126:
            self.skipTest('the tree is not readable for others')
        self.assertEqual(result.returncode, 77, result.stderr)
        self.assertIn('skipped: ', result.stderr)


if __name__ == '__main__':
    unittest.main()
