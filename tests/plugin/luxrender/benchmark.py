#!/usr/bin/env python3
"""The tables of docs/measured/other-renderers.md: see scripts/luxrender-benchmark."""
import argparse
import pathlib
import tempfile

import numpy as np

from luxconsole import LuxConsole, block_differences, errors

WIDTH = 160  # pixels
LONG = 2000  # passes of the reference by aips
SAMPLES = 400  # a pixel, bidirectional
REFERENCE_SEED, SEEDS = 7, (1, 2, 3)


def sppm_passes(lux, scene, seconds):
    """As many passes of LuxRender's sppm as take the time."""
    first = lux.render(scene, 'sppm', 2, WIDTH, threads=1)
    return max(1, round(2 * seconds / first.seconds))


def agreement(name, reference, theirs):
    difference = 100 * block_differences(reference, theirs)
    whole = 100 * (reference.mean() / theirs.mean() - 1)
    return [name, f'{np.median(np.abs(difference)):.2f} %', f'{np.median(difference):+.2f} %',
            f'{np.quantile(np.abs(difference), 0.9):.2f} %', f'{whole:+.2f} %']


def equal_time(name, lux, scene, reference, short):
    """Means over the seeds, and as many renders by sppm, which knows no seeds: no two are alike."""
    ours = [lux.render(scene, 'aips', short, WIDTH, f'"integer seed" [{seed}]', threads=1)
            for seed in SEEDS]
    passes = sppm_passes(lux, scene, np.mean([rendered.seconds for rendered in ours]))
    theirs = [lux.render(scene, 'sppm', passes, WIDTH, threads=1) for _ in SEEDS]
    cells, left = [name], []
    for renders in (ours, theirs):
        whole, rest = np.mean([errors(rendered.image, reference) for rendered in renders], axis=0)
        seconds = np.mean([rendered.seconds for rendered in renders])
        cells += [f'{seconds:.1f}', f'{whole:.2g}', f'{rest:.2g}']
        left.append((whole, rest))
    return cells + [f'{theirs_ / ours_:.2g}' for ours_, theirs_ in zip(*left)]


def print_table(head, rows):
    for cells in (head, ['---'] * len(head), *rows):
        print('|', ' | '.join(cells), '|')
    print(flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('luxconsole')
    parser.add_argument('module')
    parser.add_argument('scenes', nargs='*', default=['glass-ball', 'ring', 'hall'])
    parser.add_argument('--passes', type=int, default=100, help='of aips, of what is measured')
    arguments = parser.parse_args()
    agree, error = [], []
    with tempfile.TemporaryDirectory(prefix='aips-luxrender-') as folder:
        lux = LuxConsole(arguments.luxconsole, arguments.module, folder)
        for name in arguments.scenes:
            scene = pathlib.Path(name).read_text() if name.endswith('.lxs') else name
            name = pathlib.Path(name).stem
            reference = lux.render(scene, 'aips', LONG, WIDTH, f'"integer seed" [{REFERENCE_SEED}]').image
            theirs = lux.render(scene, 'bidirectional', SAMPLES, WIDTH).image
            agree.append(agreement(name, reference, theirs))
            error.append(equal_time(name, lux, scene, reference, arguments.passes))
    print_table(['scene', 'blocks: median', 'signed', '90 % within', 'whole image'], agree)
    print_table(['scene', 'aips: CPU seconds', 'whole', 'rest', 'sppm: CPU seconds', 'whole', 'rest', 'ratio, whole',
                 'rest'], error)


if __name__ == '__main__':
    main()
