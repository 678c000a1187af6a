"""Means over directions of what differs by the angle of view, for what has no angle here.

They are those of the light that a surface gets from all around: by the cosine.
"""
import numpy as np

COSINES = (np.arange(256) + 0.5) / 256


def fresnel(index):
    """Share that a dielectric of this index reflects at each of COSINES."""
    root = np.sqrt(np.maximum(index * index - 1 + COSINES ** 2, 0))
    across = (root - COSINES) / (root + COSINES)
    along = (COSINES * (root + COSINES) - 1) / (COSINES * (root - COSINES) + 1)
    return across ** 2 / 2 * (1 + along ** 2)


def mean_fresnel(index):
    return float(2 * (fresnel(max(index, 1e-5)) * COSINES).mean())


def mean_facing(blend):
    """Of output Facing of node Layer Weight."""
    blend = min(max(blend, 0.0), 1 - 1e-5)
    power = 2 * blend if blend < 0.5 else 0.5 / (1 - blend)
    return 1 - 2 / (power + 2)


def index_of_blend(blend):
    """Of output Fresnel of node Layer Weight."""
    return 1 / max(1 - blend, 1e-5)
