"""The command line of lxsrender for a render in Blender."""

WRITE_COST = 0.5e-6   # seconds that writing the image so far takes, a pixel, with four layers
WRITING_SHARE = 0.05  # of the time that writing may take


def write_every(pixels, interval):
    """Seconds between two images so far: the interval, or more where writing takes long."""
    return max(interval, pixels * WRITE_COST / WRITING_SHARE)


def arguments(program, scene, image, threads=0, seed=0, denoise=False, explain=False, every=1.0):
    """`image` is the EXR to write, anew about every `every` seconds."""
    found = [program, scene, '-o', image, '--seed', str(seed), '--write-every', f'{every:.3g}']
    if threads:
        found += ['--threads', str(threads)]
    if denoise:
        found.append('--denoise=last')  # denoising takes thirty times as long as writing
    if explain:
        found.append('--explain')
    return found
