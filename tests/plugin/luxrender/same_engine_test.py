#!/usr/bin/env python3
"""Protects the engine's isolation: the modules for lxsrender and for LuxRender link one and the same
library of it, and neither compiles a file of it for itself.

    same_engine_test.py BUILD
"""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
LISTS = {'aips': ROOT / 'plugin/CMakeLists.txt',
         'aips_luxrender': ROOT / 'plugin/luxrender/CMakeLists.txt'}


def links(text, target):
    found = re.search(rf'target_link_libraries\({target} ([^)]*)\)', text)
    return found[1].split() if found else []


class SameEngine(unittest.TestCase):
    def test_by_the_lists(self):
        for target, path in LISTS.items():
            text = path.read_text()
            self.assertIn('aips_adapter', links(text, target), path)
            self.assertNotIn('core-adapter', text, path)

    def test_by_the_build(self):
        """As Ninja's files have it: what both modules are linked from."""
        plan = BUILD / 'build.ninja'
        if not plan.exists():
            self.skipTest('the build is not one of Ninja')
        rules = re.findall(r'^build (plugins/(?:aips|aips_luxrender)\.so): (.*?)$',
                           plan.read_text(), flags=re.M)
        engines = {module: sorted(set(re.findall(r'\S*libaips_(?:adapter|core)\.a', inputs)))
                   for module, inputs in rules}
        self.assertIn('plugins/aips.so', engines)
        for module, libraries in engines.items():
            self.assertTrue(libraries, module)
            self.assertEqual(libraries, engines['plugins/aips.so'], module)
        for module, inputs in rules:
            self.assertNotRegex(inputs, r'core-adapter\S*\.o\b', module)
        if 'plugins/aips_luxrender.so' not in engines:
            self.skipTest('the module for LuxRender is not built; -DAIPS_LUXRENDER builds it')


if __name__ == '__main__':
    BUILD = pathlib.Path(sys.argv[1])
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
