"""Describes Blender's camera as one of the scene language."""
import dataclasses
import math

from . import versions
from .lxs_text import factor, parameter

GREATEST_DISTANCE = 1e6  # scene units; beyond it all is sharp


@dataclasses.dataclass
class View:
    """A camera: its kind, the part of its screen that is seen, and its lens."""
    kind: str                    # perspective, orthographic, environment
    window: tuple = ()           # x0 x1 y0 y1; of a perspective tangents of angles
    lens_radius: float = 0.0     # scene units
    focus: float = 0.0           # depth at which it is sharp, scene units
    blades: int = 0
    near: float = 0.0
    far: float = 0.0

    def parameters(self):
        found = [factor('hither', self.near), factor('yon', self.far)]
        window = self.window
        if self.kind == 'perspective':
            half = min(window[1] - window[0], window[3] - window[2]) / 2
            found.append(factor('fov', math.degrees(2 * math.atan(half))))
            window = tuple(w / half for w in window)
        if window:
            found.append(parameter('float', 'screenwindow', window))
        if self.lens_radius > 0:
            found += [factor('lensradius', self.lens_radius), factor('focaldistance', self.focus)]
        if self.lens_radius > 0 and self.kind == 'perspective':
            found.append(parameter('integer', 'blades', self.blades))
        return found


def view_of(camera_object, depsgraph, width, height, aspect, left_out):
    """The View of an evaluated camera object, for an image of the given pixels."""
    camera = camera_object.data
    if camera.type == 'PANO':
        if versions.panorama_type(camera) != 'EQUIRECTANGULAR':
            left_out.add('panoramic cameras are taken for equirectangular', camera_object.name)
        return View('environment', near=camera.clip_start, far=camera.clip_end)
    matrix = camera_object.calc_matrix_camera(depsgraph, x=width, y=height, scale_x=aspect[0],
                                              scale_y=aspect[1])
    view = View('orthographic' if camera.type == 'ORTHO' else 'perspective',
                window_of(matrix, camera.type == 'ORTHO'), near=camera.clip_start,
                far=camera.clip_end)
    _focus(view, camera_object, left_out)
    return view


def of_eye(camera_object, shown, matrices, eye, shift, horizontal):
    """What one eye sees of a stereoscopic image: View and matrices.

    `eye` is its matrix as the camera stands now, `shift` its shift, and `horizontal` tells whether
    shifts go by the image's width, in place of its height.
    """
    aside = camera_object.matrix_world.inverted() @ eye
    x0, x1, y0, y1 = shown.window
    move = (shift - camera_object.data.shift_x) * (x1 - x0 if horizontal else y1 - y0)
    return (dataclasses.replace(shown, window=(x0 + move, x1 + move, y0, y1)),
            tuple(matrix @ aside for matrix in matrices))


def window_of(matrix, orthographic):
    """What part of its screen a projection shows: where it maps to -1 and 1."""
    if orthographic:
        return tuple((sign - matrix[row][3]) / matrix[row][row] for row in (0, 1)
                     for sign in (-1, 1))
    return tuple((sign + matrix[row][2]) / matrix[row][row] for row in (0, 1) for sign in (-1, 1))


def _focus(view, camera_object, left_out):
    camera = camera_object.data
    if not camera.dof.use_dof or camera.dof.aperture_fstop <= 0:
        return
    # Blender's focal length is in millimetres, scene units are metres; Cycles takes 1 for one that
    # orthographic cameras have not.
    length = 1.0 if camera.type == 'ORTHO' else camera.lens * 1e-3
    view.lens_radius = length / (2 * camera.dof.aperture_fstop)
    view.blades = camera.dof.aperture_blades if camera.dof.aperture_blades >= 3 else 0
    view.focus = focus_distance(camera_object)
    if view.blades and camera.type == 'ORTHO':
        left_out.add('blades of orthographic cameras are left out', camera_object.name)
    if camera.dof.aperture_ratio != 1 or (view.blades and camera.dof.aperture_rotation):
        left_out.add("the aperture's ratio and rotation are left out", camera_object.name)


def focus_distance(camera_object):
    """Depth of the focus object along the camera's axis, or the distance that is set."""
    dof, matrix = camera_object.data.dof, camera_object.matrix_world
    if dof.focus_object is None:
        return min(dof.focus_distance, GREATEST_DISTANCE)
    to = dof.focus_object.matrix_world.translation - matrix.translation
    axis = -matrix.to_3x3().col[2].normalized()
    return max(to.dot(axis), 1e-3)


def write(text, view, matrices):
    """The camera at its places: one matrix, or one at either end of the shutter's time."""
    if len(matrices) > 1:
        text.lines.append('MotionBegin [0 1]')
    for matrix in matrices:
        text.statement('LookAt', *map(float, look_at(matrix)))
    if len(matrices) > 1:
        text.lines.append('MotionEnd')
    shutter = [parameter('float', 'shutteropen', 0.0), parameter('float', 'shutterclose', 1.0)]
    text.statement('Camera', view.kind, parameters=view.parameters() + shutter)


def look_at(matrix):
    """Place, target and up of a camera's matrix: nine numbers."""
    place = [matrix[row][3] for row in range(3)]
    return [*place, *(p - matrix[row][2] for row, p in enumerate(place)),
            *(matrix[row][1] for row in range(3))]
