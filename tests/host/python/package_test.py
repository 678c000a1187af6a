"""Protects the package around the module of Python: its page's example runs, what it declares is
there, and it knows what lxsrender knows."""
import ast
import os
import re
import subprocess

import module_fixture as fixture
from module_fixture import BUILT, LXSRENDER, ROOT, SCENES, lxs

STUB = ast.parse((ROOT / 'host/python/lxs/_lxs.pyi').read_text())


def declared(body):
    names = set()
    for node in body:
        if isinstance(node, ast.FunctionDef):
            names.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            names.add(node.target.id)
    return names


class Package(fixture.InFolder):
    def test_example_of_the_page(self):
        page = (ROOT / 'docs/start/python.md').read_text()
        examples = re.findall(r'```python\n(.*?)```', page, re.S)
        self.assertGreater(len(examples), 0)
        (self.folder / 'scenes').symlink_to(SCENES)
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        names = {}
        for example in examples:
            exec(compile(example, 'python.md', 'exec'), names)  # one goes on from another
        self.assertTrue((self.folder / 'glass-ball.exr').exists())

    def test_stub_is_the_module(self):
        found = {name for name in dir(lxs._lxs) if not name.startswith('_')}
        classes = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
        self.assertEqual(found, declared(STUB.body) | set(classes))
        for name, node in classes.items():
            found = {key for key in vars(getattr(lxs._lxs, name)) if not key.startswith('_')}
            self.assertEqual(found, declared(node.body) - {'__init__'}, name)

    def test_what_is_public_is_described(self):
        self.assertTrue((BUILT / 'lxs/py.typed').exists())
        for name in lxs.__all__:
            self.assertTrue(getattr(lxs, name).__doc__, name)

    def test_knows_what_lxsrender_knows(self):
        def said(*options):
            return subprocess.run([LXSRENDER, *options], check=True, text=True,
                                  stdout=subprocess.PIPE).stdout
        self.assertEqual(lxs.__version__, said('--version').split()[-1])
        self.assertEqual(lxs.integrators(),
                         [line.split()[0] for line in said('--list-plugins').splitlines()])
        self.assertEqual(lxs.describe('aips'), said('--describe', 'aips'))
        with self.assertRaisesRegex(ValueError, 'aisp'):
            lxs.describe('aisp')


if __name__ == '__main__':
    fixture.main()
