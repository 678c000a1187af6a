"""Reads images and the benchmark's references of them: for scripts/error-study,
denoise-study, pbrt-benchmark."""
import re
import subprocess
import tempfile


def pixels(exr, layer=''):
    """R, G, B of a layer of an EXR file, such as 'denoised.', as one list. Needs oiiotool."""
    channels = ','.join(layer + color for color in 'RGB')
    with tempfile.NamedTemporaryFile(suffix='.exr') as alone:
        subprocess.run(['oiiotool', exr, '--ch', channels, '--chnames', 'R,G,B', '-o', alone.name],
                       check=True)
        text = subprocess.run(['oiiotool', '--dumpdata', alone.name], check=True,
                              stdout=subprocess.PIPE, text=True).stdout
    rows = re.findall(r'Pixel \(.*?\): (.*)', text)
    return [float(value) for row in rows for value in row.split()]


def references(folder, scene):
    """The two images that the benchmark rendered last, in SCENE-w200 or SCENE, as pixels()."""
    folders = [folder / f'{scene}-w200', folder / scene]
    for place in folders:
        files = [sorted(place.glob(f'{n}.*.exr'), key=lambda file: file.stat().st_mtime)
                 for n in (1, 2)]
        if all(files):
            return [pixels(found[-1]) for found in files]
    raise SystemExit(f'no references in {" or ".join(map(str, folders))}')


def mean_without_worst(values):
    """Mean over pixels but for the worst 0.1 %, of three values each."""
    by_pixel = sorted((sum(values[i:i + 3]) / 3 for i in range(0, len(values), 3)), key=abs)
    kept = by_pixel[:len(by_pixel) - max(1, len(by_pixel) // 1000)]
    return sum(kept) / len(kept)
