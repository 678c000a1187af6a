#!/usr/bin/env python3
"""Protects the page of --serve as its watchers see it, in headless Chromium: check_page.mjs says what
is looked at.

    page_test.py LXSRENDER PACKAGES [SCREENSHOT.png]

PACKAGES is the folder with node_modules.
"""
import pathlib
import shutil
import subprocess
import sys
import unittest

from watched_render import SKIPPED, WatchedRender, main

HERE = pathlib.Path(__file__).resolve().parent
CHROMIUMS = ('chromium-headless-shell', 'chromium', 'chromium-browser', 'google-chrome')


class Page(unittest.TestCase):
    def test_in_a_browser(self):
        options = ('--integrator', 'aips', '--passes', '1000000', '--target-error', '0.0001',
                   '--set', 'aips.debuglayers=true', '--set', 'aips.guide=paper', '-o', 'a.exr')
        with WatchedRender(*options, width=96, height=72) as render:
            checked = subprocess.run([NODE, HERE / 'check_page.mjs', render.link, CHROMIUM,
                                      *sys.argv[2:]], check=False)
            self.assertEqual(checked.returncode, 0)
            code, messages = render.end()
            self.assertEqual(code, 130, messages)
            self.assertTrue((render.path / 'a.exr').exists())


if __name__ == '__main__':
    NODE = shutil.which('node')
    CHROMIUM = next(filter(None, map(shutil.which, CHROMIUMS)), None)
    if not NODE or not CHROMIUM:
        print('skipped: this test needs node and Chromium (scripts/setup page installs both)')
        sys.exit(SKIPPED)
    main()
