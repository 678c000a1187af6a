#!/usr/bin/env python3
"""Protects the manual (docs/, README.md, scenes/README.md): what manual_checks.py says of it.

    manual_test.py CHECK [--lxsrender PROGRAM]     one check, or `all`
    manual_test.py planted                         every check finds the faults that it is for
    manual_test.py counts                          pages and words of the manual, by folder
"""
import argparse
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from manual_checks import CHECKS, Manual, counts  # noqa: E402
from manual_pages import slug  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]

HEALTHY = {
    'README.md': '# It\n\n[the manual](docs/index.md)\n\n| scene | sppm |\n| --- | --- |\n'
                 '| ball, big | **0.2** |\n',
    'scenes/README.md': '# Scenes\n\n![ball](../docs/images/ball.png)\n',
    'docs/images/ball.png': '',
    'docs/index.md': '# Manual\n\n[light](understand/light.md#what--where-it-is), '
                     '[changing](build-on/changing.md "how"), '
                     '[outside](https://example.org/a/b)\n\n`[no](link.md)`\n',
    'docs/understand/light.md': '# Light\n\n## What & where it is\n\n```\n[no](link.md)\n```\n\n'
                                '[below](#what--where-it-is-1)\n\n## What & where it is\n',
    'docs/build-on/changing.md': '# Changing\n\nSee `scripts/go`, `docs/NAME.md` and `a_name`.\n\n'
                                 '```\nscripts/go --fast \\\n    -o x   # --never\n'
                                 'lxsrender a.lxs --passes 4 --set aips.guide=none\n```\n',
    'docs/notebook/2026-01-02-try.md': '# What if?\n\nBefore, at 1a2b3c4d.\n',
    'scripts/go': '# scripts/go [--fast] [any option of lxsrender]\n'
                  'exec "$build/bin/lxsrender" "$@"\n',
    'lxsrender': '#!/bin/sh\ncase $1 in --help) echo "  -o,--output FILE --passes N --set X";;\n'
                 '--describe) echo "guide  string";; esac\n',
}

# Put together, so that no line of the project has such a path.
SOMEBODYS = '/' + 'home/'

# Check, file, what it holds (None: it is taken away), what the check says of it.
PLANTED = [
    ('links', 'README.md', '[x](docs/none.md)', 'README.md:1: docs/none.md: there is no such file'),
    ('links', 'scenes/README.md', '![x](../docs/images/cube.png)', 'cube.png: there is no such'),
    ('links', 'docs/understand/light.md', '# Light\n\n## Else\n', 'no heading there has this'),
    ('links', 'docs/understand/light.md', '# Light\n\n[x](#below)', 'light.md:3: #below: no'),
    ('links', 'docs/index.md', '[x](understand)', 'a folder, where a page'),
    ('reach', 'docs/index.md', '# Manual\n', 'docs/understand/light.md: no link leads here'),
    ('reach', 'docs/index.md', None, 'docs/index.md: there is no such page'),
    ('length', 'docs/index.md', '# M ' + 'word ' * 1599, 'docs/index.md: 1601 words; at most 1600'),
    ('size', 'docs/index.md', '# M ' + 'word ' * 200000, 'words written by hand; at most'),
    ('size', 'docs/reference/gallery.md', '# G ' + 'word ' * 90000, 'words generated; at most'),
    ('titles', 'docs/index.md', 'Manual\n', 'docs/index.md: does not begin with a title'),
    ('diary', 'README.md', 'A third less (at 1a2b3c4).', 'README.md:1: "1a2b3c4" belongs'),
    ('diary', 'docs/index.md', '# M\n\nBefore, at last year', 'index.md:3: "Before, at"'),
    ('leftovers', 'docs/index.md', '# M\n@@table@@', 'docs/index.md:2: "@@table@@" was left'),
    ('leftovers', 'docs/notebook/2026-01-02-try.md', f'In {SOMEBODYS}me.',
     f'"{SOMEBODYS}" was left there'),
    ('commands', 'README.md', '```\nscripts/none --fast\n```', 'README.md:2: scripts/none: there'),
    ('commands', 'README.md', '```\nscripts/go --slow\n```', 'scripts/go has no option --slow'),
    ('commands', 'README.md', '```\nscripts/go \\\n  --out x\n```', 'go has no option --out'),
    ('commands', 'README.md', 'Say `lxsrender a.lxs --pass 3`.', 'lxsrender has no option --pass'),
    ('commands', 'README.md', '`lxsrender -o x --set=aips.gide=x`', 'aips has no parameter gide'),
    ('changing', 'docs/build-on/changing.md', '# C\n`tests/none.cpp`', 'md:2: tests/none.cpp'),
    ('changing', 'docs/build-on/changing.md', '# C\n`tests/NAME_test.cpp`', 'tests/NAME_test.cpp'),
    ('changing', 'docs/build-on/changing.md', None, 'changing.md: there is no such page'),
    ('named', 'host/it.h', '// (docs/it.md)', 'host/it.h:1: docs/it.md: there is no such page'),
    ('figures', 'README.md', '| scene | sppm |\n| --- | --- |\n| ball, big | **0.1** |\n',
     'README.md: ball, sppm: 0.1, but 0.2 in docs/measured/results.md'),
    ('figures', 'README.md', '| scene | path |\n| --- | --- |\n| cube | 0.1 |\n',
     'README.md: cube, path: 0.1, but None in'),
    ('notebook', 'docs/notebook/again.md', '# Again', 'again.md: its name does not begin with'),
    ('notebook', 'docs/index.md', '# M\n[n](notebook/2026-01-02-try.md)', 'index.md:2: notebook/2'),
]


def write(root, files):
    for name, text in files.items():
        path = root / name
        if text is None:
            path.unlink()
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def faults_with(name, planted):
    """What a check says of the healthy manual with some files changed."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder).resolve()
        write(root, HEALTHY)
        (root / 'lxsrender').chmod(0o755)
        (root / 'docs/measured').mkdir()
        write(root, {'docs/measured/index.md': '# Measured\n\n[results](results.md)\n',
                     'docs/measured/results.md': '# R\n\n| scene | sppm |\n| --- | --- |\n'
                                                 '| ball \\* | 0.2 |\n',
                     'docs/index.md': HEALTHY['docs/index.md'] + '[m](measured/index.md)\n'})
        write(root, planted)
        return list(CHECKS[name](Manual(root, root / 'lxsrender')))


def planted_faults():
    """Runs every check on a healthy manual and on those with a planted fault; what went wrong."""
    wrong = []
    for name in CHECKS:
        wrong += [f'{name} finds fault with a healthy manual: {fault}'
                  for fault in faults_with(name, {})]
        if name not in {check for check, *_ in PLANTED}:
            wrong.append(f'{name}: no fault is planted for it')
    for name, file, text, said in PLANTED:
        faults = faults_with(name, {file: text})
        if not any(said in fault for fault in faults):
            wrong.append(f'{name} does not find "{said}" in {file}: {faults}')
    for heading, anchor in (('What `--set` takes: 2.5 of it', 'what---set-takes-25-of-it'),
                            ('[Links](a.md) & more_or *less*', 'links--more_or-less')):
        if slug(heading) != anchor:
            wrong.append(f'"{heading}" has the anchor {slug(heading)}, not {anchor}')
    return wrong


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument('check', choices=[*CHECKS, 'all', 'planted', 'counts'])
    options.add_argument('--lxsrender', type=pathlib.Path)
    asked = options.parse_args()
    if asked.check == 'counts':
        print(f'{"folder":12}  pages  written  generated')
        for folder, (pages, written, generated) in counts(Manual(ROOT)).items():
            print(f'{folder:12} {pages:6} {written:8} {generated:10}')
        return 0
    if asked.check == 'planted':
        faults = planted_faults()
    else:
        if asked.check in ('commands', 'all') and not asked.lxsrender:
            options.error('commands are checked against a program: --lxsrender')
        manual = Manual(ROOT, asked.lxsrender)
        names = CHECKS if asked.check == 'all' else [asked.check]
        faults = [fault for name in names for fault in CHECKS[name](manual)]
    print('\n'.join(faults) if faults else 'no faults')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
