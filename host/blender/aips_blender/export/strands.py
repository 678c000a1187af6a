"""Makes strands of hair, of particles and of Curves objects, meshes of thin tubes."""
import dataclasses

import numpy as np

from .corners import array

RADIUS = 0.005       # of Curves without one, as in Cycles
THICK = 0.01         # radius by length above which the shape of a strand is seen
MOST_TURN = 0.25     # radians that a tube bends by from one ring to the next
MOST_PIECES = 4      # of the way between two points
LEAST_TIP = 0.01     # of the greatest radius: a point would have no area


@dataclasses.dataclass
class Strands:
    points: np.ndarray   # one row each
    radii: np.ndarray
    firsts: np.ndarray   # numbers of the strands' first points, and of all points
    uv: np.ndarray = None  # of the surface at the roots, one row a strand

    def counts(self):
        return np.diff(self.firsts)


def of_particles(thing, system, for_render):
    """Of a system of hair in the object's own space, or None where there is none."""
    settings = system.settings
    parents, children = len(system.particles), len(system.child_particles)
    has_children = settings.child_type != 'NONE' and children > 0
    numbers = range(parents if has_children else 0, parents + children if has_children else parents)
    steps = 2 ** (settings.render_step if for_render else settings.display_step) + 1
    if settings.kink == 'SPIRAL':
        steps += settings.kink_extra_steps
    if not numbers:
        return None
    place = system.co_hair
    points = np.array([place(object=thing, particle_no=i, step=step)
                       for i in numbers for step in range(steps)], float)
    back = np.array(thing.matrix_world.inverted_safe(), float)
    points = points @ back[:3, :3].T + back[:3, 3]
    points = points.reshape(len(numbers), steps, 3)
    lengths = np.linalg.norm(np.diff(points, axis=1), axis=2)
    along = np.hstack([np.zeros((len(points), 1)), np.cumsum(lengths, axis=1)])
    along /= np.maximum(along[:, -1:], 1e-30)
    radii = _radii(settings, along)
    return Strands(points.reshape(-1, 3), radii.ravel(),
                   steps * np.arange(len(numbers) + 1), _uv_of_roots(thing, system, numbers))


def _radii(settings, along):
    """By the share of the strand's length, as Cycles has it."""
    scale = settings.radius_scale / 2
    root, tip = settings.root_radius * scale, settings.tip_radius * scale
    shape = settings.shape
    fade = np.clip(1 - along, 0, 1) ** (1 + shape if shape < 0 else 1 / max(1 - shape, 1e-6))
    radii = tip + (root - tip) * fade
    if settings.use_close_tip:
        radii[:, -1] = 0
    return radii


def _uv_of_roots(thing, system, numbers):
    modifier = next((m for m in thing.modifiers if m.type == 'PARTICLE_SYSTEM' and
                     m.particle_system.name == system.name), None)
    if modifier is None or not thing.data.uv_layers:
        return None
    particles = system.particles
    return np.array([system.uv_on_emitter(
        modifier, particle=particles[min(i, len(particles) - 1)], particle_no=i, uv_no=0)
        for i in numbers], np.float32)


def of_curves(data):
    """Of what an object of hair curves has, or None."""
    if not len(data.curves):
        return None
    lengths = array(data.curves, 'points_length', np.int32, 1).ravel()
    attributes = data.attributes
    points = array(attributes['position'].data, 'vector', np.float32, 3).astype(float)
    radii = np.full(len(points), RADIUS)
    if 'radius' in attributes:
        radii = array(attributes['radius'].data, 'value', np.float32, 1).ravel().astype(float)
    uv = attributes.get('surface_uv_coordinate')
    at_roots = None
    if uv is not None and uv.data_type == 'FLOAT2' and uv.domain == 'CURVE':
        at_roots = array(uv.data, 'vector', np.float32, 2)
    return Strands(points, radii, np.concatenate([[0], np.cumsum(lengths)]), at_roots)


def tubes(strands):
    """Rows of vertices (place, normal and, where there are, uv) and triangles; None where no strand
    has a length."""
    strands = _smooth(_long(strands))
    if not len(strands.counts()):
        return None
    rings = _sides(strands)
    count = 12 if (strands.radii.max() > THICK * _median_length(strands)) else 3
    part = np.pi / count
    angles = 2 * part * np.arange(count)
    along, side = rings
    up = np.cross(side, along)
    out = np.cos(angles)[:, None] * side[:, None] + np.sin(angles)[:, None] * up[:, None]
    # A polygon of the circle's perimeter has its width, in the mean over directions.
    radii = np.maximum(strands.radii, LEAST_TIP * strands.radii.max()) * part / np.sin(part)
    places = strands.points[:, None] + radii[:, None, None] * out
    columns = [places.reshape(-1, 3), out.reshape(-1, 3)]
    if strands.uv is not None:
        columns.append(np.repeat(strands.uv, count * strands.counts(), axis=0))
    begins = np.ones(len(strands.points), bool)
    begins[strands.firsts[1:] - 1] = False  # no tube goes on from the last ring
    ring = count * np.flatnonzero(begins)[:, None]
    here, there = np.arange(count), (np.arange(count) + 1) % count
    a, b = ring + here, ring + there
    # The front is outside, where rings run clockwise as seen from the tip.
    faces = np.stack([a, b + count, b, a, a + count, b + count], axis=-1).reshape(-1, 3)
    return np.hstack(columns).astype(np.float32), faces


def _owners(strands):
    """Of each point the number of its strand."""
    return np.repeat(np.arange(len(strands.counts())), strands.counts())


def _median_length(strands):
    steps = np.linalg.norm(np.diff(strands.points, axis=0), axis=1)
    owners = _owners(strands)
    steps[owners[1:] != owners[:-1]] = 0
    return np.median(np.bincount(owners[1:], steps, len(strands.counts())))


def _long(strands):
    """Those that have a length, without points that do not go on from those before."""
    owners = _owners(strands)
    moved = np.ones(len(owners), bool)
    moved[1:] = (np.linalg.norm(np.diff(strands.points, axis=0), axis=1) > 1e-9) | \
        (owners[1:] != owners[:-1])
    counts = np.bincount(owners[moved], minlength=len(strands.counts()))
    there = counts > 1
    moved &= there[owners]
    return Strands(strands.points[moved], strands.radii[moved],
                   np.concatenate([[0], np.cumsum(counts[there])]),
                   None if strands.uv is None else strands.uv[there])


def _smooth(strands):
    """More points, on splines of Catmull and Rom, where strands bend much."""
    firsts, counts = strands.firsts, strands.counts()
    if not len(counts):
        return strands
    along = np.diff(strands.points, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1), 1e-30)[:, None]
    owners = _owners(strands)
    within = owners[2:] == owners[:-2]
    turns = np.arccos(np.clip((along[1:] * along[:-1]).sum(axis=1), -1, 1))[within]
    pieces = int(np.clip(np.ceil(np.quantile(turns, 0.95) / MOST_TURN), 1, MOST_PIECES)) \
        if len(turns) else 1
    if pieces == 1:
        return strands
    starts = np.flatnonzero(owners[1:] == owners[:-1])  # of the ways between points
    least, most = firsts[:-1][owners[starts]], firsts[1:][owners[starts]] - 1
    places = [np.clip(starts + i, least, most) for i in (-1, 0, 1, 2)]
    grown = np.concatenate([[0], np.cumsum((counts - 1) * pieces + 1)])
    to = grown[owners[starts]] + (starts - least) * pieces
    values = np.column_stack([strands.points, strands.radii])
    found = np.empty((grown[-1], 4))
    p = [values[i] for i in places]
    for piece in range(pieces):
        t = piece / pieces
        weights = (-t + 2 * t * t - t ** 3, 2 - 5 * t * t + 3 * t ** 3,
                   t + 4 * t * t - 3 * t ** 3, -t * t + t ** 3)
        found[to + piece] = sum(w / 2 * each for w, each in zip(weights, p))
    found[grown[1:] - 1] = values[firsts[1:] - 1]
    return Strands(found[:, :3], np.maximum(found[:, 3], 0), grown, strands.uv)


def _sides(strands):
    """Of each point the direction of the strand, and one square to it that does not twist."""
    firsts, counts = strands.firsts, strands.counts()
    owners = _owners(strands)
    numbers = np.arange(len(owners))
    before = np.maximum(numbers - 1, firsts[:-1][owners])
    after = np.minimum(numbers + 1, firsts[1:][owners] - 1)
    along = _unit(strands.points[after] - strands.points[before])
    side = np.zeros_like(along)
    carried = np.zeros((len(counts), 3))
    for step in range(counts.max()):
        there = np.flatnonzero(counts > step)
        at = firsts[:-1][there] + step
        left = carried[there]
        left = left - along[at] * (left * along[at]).sum(axis=1)[:, None]
        lost = np.linalg.norm(left, axis=1) < 1e-6
        axes = np.where(np.abs(along[at][:, :1]) < 0.7, (1.0, 0, 0), (0, 1.0, 0))
        left[lost] = np.cross(along[at], axes)[lost]
        side[at] = carried[there] = _unit(left)
    return along, side


def _unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1), 1e-30)[:, None]
