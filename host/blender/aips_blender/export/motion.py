"""Where objects and the camera are when the shutter opens and closes."""
from . import versions

LEAST_MOVE = 1e-6  # greatest difference of matrices that is no motion


def instance_key(instance):
    """What tells an instance of the dependency graph from the others, at all times."""
    parent = instance.parent.name_full if instance.is_instance and instance.parent else ''
    return (instance.object.name_full, parent,
            tuple(instance.persistent_id) if instance.is_instance else ())


def matrices_of(depsgraph):
    """Matrices of all instances by key, and that of the camera, by key None."""
    found = {instance_key(i): i.matrix_world.copy() for i in depsgraph.object_instances}
    camera = depsgraph.scene_eval.camera
    if camera is not None:
        found[None] = camera.evaluated_get(depsgraph).matrix_world.copy()
    return found


def shutter_times(scene):
    """Frames at which the shutter opens and closes, around the present one."""
    length = scene.render.motion_blur_shutter
    before = {'START': 0.0, 'CENTER': 0.5, 'END': 1.0}[versions.motion_blur_position(scene)]
    middle = scene.frame_current + scene.frame_subframe
    return middle - before * length, middle + (1 - before) * length


class Motion:
    """Matrices at both ends of the shutter's time; nothing moves where there is no blur."""

    def __init__(self, depsgraph, frame_set):
        self._ends = ()
        scene = depsgraph.scene
        if frame_set is None or not scene.render.use_motion_blur:
            return
        now = (scene.frame_current, scene.frame_subframe)
        ends = []
        for time in shutter_times(scene):
            frame_set(int(time // 1), time % 1)
            ends.append(matrices_of(depsgraph))
        frame_set(*now)
        self._ends = tuple(ends)

    @property
    def blurs(self):
        """Whether the shutter is open for a time."""
        return bool(self._ends)

    def of(self, key, matrix):
        """One matrix where it stands still, else two."""
        ends = [end.get(key) for end in self._ends]
        if not ends or None in ends or not _differ(*ends):
            return (matrix,)
        return tuple(ends)


def _differ(a, b):
    return max(abs(x - y) for r, s in zip(a, b) for x, y in zip(r, s)) > LEAST_MOVE
