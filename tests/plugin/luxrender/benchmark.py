#!/usr/bin/env python3
"""The table of docs/measured/luxrender.md: see scripts/luxrender-benchmark."""
import argparse
import tempfile

import numpy as np

from luxconsole import LuxConsole, block_differences, errors

WIDTH = 160  # pixels
LONG, SHORT = 500, 100  # passes of aips
SAMPLES = 400  # a pixel, bidirectional


def sppm_for(lux, scene, seconds):
    """LuxRender's sppm with as many passes as take the time."""
    first = lux.render(scene, 'sppm', 2, WIDTH, threads=1)
    passes = max(1, round(2 * seconds / first.seconds))
    return lux.render(scene, 'sppm', passes, WIDTH, threads=1)


def row(lux, scene):
    reference = lux.render(scene, 'aips', LONG, WIDTH, '"integer seed" [7]', threads=1).image
    theirs = lux.render(scene, 'bidirectional', SAMPLES, WIDTH, threads=1).image
    ours = lux.render(scene, 'aips', SHORT, WIDTH, '"integer seed" [1]', threads=1)
    sppm = sppm_for(lux, scene, ours.seconds)
    difference = block_differences(reference, theirs)
    cells = [scene, f'{100 * np.median(np.abs(difference)):.2f} %',
             f'{100 * (reference.mean() / theirs.mean() - 1):+.2f} %']
    for rendered in (ours, sppm):
        whole, rest = errors(rendered.image, reference)
        cells += [f'{rendered.seconds:.1f}', f'{whole:.3g}', f'{rest:.3g}']
    return cells


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('luxconsole')
    parser.add_argument('module')
    parser.add_argument('scenes', nargs='*', default=['glass-ball', 'ring', 'hall'])
    arguments = parser.parse_args()
    print('| scene | blocks | mean | aips s | whole | rest | sppm s | whole | rest |')
    print('| --- | --- | --- | --- | --- | --- | --- | --- | --- |')
    with tempfile.TemporaryDirectory(prefix='aips-luxrender-') as folder:
        lux = LuxConsole(arguments.luxconsole, arguments.module, folder)
        for scene in arguments.scenes:
            print('|', ' | '.join(row(lux, scene)), '|', flush=True)


if __name__ == '__main__':
    main()
