"""The command line of lxsrender for a render in Blender."""

# Seconds that writing the image so far takes, a pixel: measured with four layers, and denoised.
WRITE_COST = 0.5e-6
DENOISE_COST = 15e-6
WRITING_SHARE = 0.05  # of the time that writing may take


def write_every(pixels, denoise, interval):
    """Seconds between two images so far: the interval, or more where writing takes long."""
    cost = pixels * (WRITE_COST + (DENOISE_COST if denoise else 0))
    return max(interval, cost / WRITING_SHARE)


def arguments(program, scene, image, threads=0, seed=0, denoise=False, explain=False, every=1.0):
    """`image` is the EXR to write, anew about every `every` seconds."""
    found = [program, scene, '-o', image, '--seed', str(seed), '--write-every', f'{every:.3g}']
    if threads:
        found += ['--threads', str(threads)]
    if denoise:
        found.append('--denoise')
    if explain:
        found.append('--explain')
    return found
