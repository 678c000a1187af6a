#!/usr/bin/env python3
"""Protects the completion of bash: every option of --help, names of integrators, their parameters,
scene files. Called with the script, lxsrender and the scenes' folder.
"""
import re
import subprocess
import sys
import unittest

SCRIPT, LXSRENDER, SCENES = sys.argv[1:4]
# compopt is of an interactive shell alone.
CALL = 'compopt() { :; }; source "$1"; COMP_WORDS=("${@:2}"); COMP_CWORD=$(($# - 2)); ' \
       '_lxsrender "$2"; printf "%s\\n" "${COMPREPLY[@]}"'


def completed(*words, folder='.'):
    output = subprocess.run(['bash', '-c', CALL, 'bash', SCRIPT, LXSRENDER, *words], cwd=folder,
                            check=True, text=True, stdout=subprocess.PIPE).stdout
    return output.split()


class Completion(unittest.TestCase):
    def test_options_are_those_of_help(self):
        text = subprocess.run([LXSRENDER, '--help'], check=True, text=True,
                              stdout=subprocess.PIPE).stdout
        options = re.findall(r'^  (?:-\w,)?(--[a-z-]+)', text, re.MULTILINE)
        self.assertGreater(len(options), 30)
        found = completed('--')
        for option in options:
            self.assertIn(option, found)

    def test_names_and_values_are_those_of_the_programs(self):
        self.assertEqual(completed('--integrator', 'sp'), ['sppm'])
        self.assertEqual(completed('--describe', 'exp'), ['exphotonmap'])
        self.assertEqual(completed('--set', 'ai'), ['aips.'])
        self.assertIn('aips.guideshare=', completed('--set', 'aips.guide'))
        self.assertEqual(completed('--mpi-split', 'pa'), ['passes'])

    def test_files_are_scenes_and_images(self):
        self.assertEqual(completed('cornell', folder=SCENES), ['cornell-box.lxs'])
        self.assertEqual(completed('READ', folder=SCENES), [])
        self.assertEqual(completed('mesh', folder=SCENES), ['meshes'])


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
