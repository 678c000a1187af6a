"""Runs in Blender: loads the add-on from the source tree and runs the named tests, or a study."""
import importlib
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent


def main():
    sys.dont_write_bytecode = True
    sys.path[:0] = [str(HERE), str(HERE.parents[1] / 'host' / 'blender')]
    _, *tests = sys.argv[sys.argv.index('--') + 1:]
    if tests[0] == 'equal_time':
        importlib.import_module(tests[0])
        return
    suite = unittest.defaultTestLoader.loadTestsFromNames(tests)
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)


main()
