"""Turns graphs of shader nodes into programs of texture "nodes" of the scene language.

A program has one line a node; docs/reference/shading.md lists them. What it is made of are operands:
a number as text, or rN for the value of line N.
"""
import numpy as np

from . import graph
from .blackbody import COLDEST, HOTTEST, blackbody
from .folded import folded
from .fractals import Fractal
from .layers import RENDERED
from .lxs_text import parameter
from .versions import setting

MOST_LINES = 256    # of lxsrender
MOST_TEXTURES = 32  # likewise
CURVE_POINTS = 33   # as many as fit a string of the scene language
RAMP_POINTS = 32
KIND_OF_SOCKET = {'RGBA': 'color', 'VECTOR': 'vector'}  # others are floats
NOT_BY_POINT = {'LIGHT_PATH', 'CAMERA', 'OBJECT_INFO', 'HAIR_INFO', 'PARTICLE_INFO'}
CONSTANTS = {'Random': 0.5, 'Color': 1.0, 'Alpha': 1.0, 'Ray Length': 1.0,
             'View Distance': 1.0, 'View Z Depth': 1.0}


def text(number):
    return f'{float(number):.6g}'


class TooLong(Exception):
    """The graph has more nodes than a program may."""


class Program:
    """Lines that are being written, for one socket."""

    def __init__(self, textures, left_out):
        self.lines = []
        self.read = []  # names of textures
        self._textures = textures
        self._left_out = left_out
        self._known = {}
        self.material_index = textures.material_index

    def emit(self, *words):
        line = ' '.join(words)
        if line in self.lines:
            return f'r{self.lines.index(line)}'
        if len(self.lines) == MOST_LINES:
            raise TooLong
        self.lines.append(line)
        return f'r{len(self.lines) - 1}'

    def value(self, *numbers):
        return self.emit('value', *map(text, numbers))

    def texture(self, name):
        """The value of a colour texture of the scene language, or of a constant."""
        if not isinstance(name, str):
            return self.value(*name)
        return self.emit('texture', self._number_of(name))

    def _number_of(self, texture):
        if texture not in self.read:
            if len(self.read) == MOST_TEXTURES:
                raise TooLong
            self.read.append(texture)
        return str(self.read.index(texture) + 1)

    def of(self, place, kind):
        """Operand of what a place has, as a float, color or vector."""
        found = graph.source(place)
        if found is None:
            value = graph.constant(place)
            if isinstance(value, float):
                return text(value)
            operand = self.value(*value[:3])
            return self._as(operand, KIND_OF_SOCKET.get(place.socket.type, 'float'), kind)
        return self.of_node(found, kind)

    def of_node(self, found, kind):
        return self._as(self.node(found), KIND_OF_SOCKET.get(found.output.type, 'float'), kind)

    def _as(self, operand, have, want):
        if want != 'float' or have == 'float':
            return operand
        return self.emit('luminance' if have == 'color' else 'average', operand)

    def node(self, found):
        key = (found.node.as_pointer(), found.output.identifier,
               tuple(g.as_pointer() for g in found.groups))
        if key not in self._known:
            make = NODES.get(found.node.type)
            operand = make(self, found) if make else None
            self._known[key] = self._instead(found) if operand is None else operand
        return self._known[key]

    def _instead(self, found):
        """Of a node without a counterpart its first input of the kind of its output, or grey."""
        label, name = found.node.bl_label, found.output.name
        if found.node.type in NOT_BY_POINT:
            self._left_out.add(f'what node {label} tells is taken to be the same everywhere')
            seen = self._textures.camera_ray if name == 'Is Camera Ray' else 0.0
            return text(CONSTANTS.get(name, seen))
        for socket in found.node.inputs:
            if socket.type == found.output.type and socket.enabled:
                self._left_out.add(f'nodes {label} are replaced by their input {socket.name}')
                return self.of(graph.Place(socket, found.groups), KIND_OF_SOCKET.get(
                    socket.type, 'float'))
        self._left_out.add(f'nodes {label} are replaced by grey')
        return '0.5'

    def float(self, found, *names):
        place = found.input(*names)
        return '0' if place is None else self.of(place, 'float')

    def set(self, found, name):
        """A number that is to be the same everywhere."""
        return self._textures.constant_number(found.input(name), f'{name} of noises')

    def color(self, found, *names):
        return self.of(found.input(*names), 'color')

    def vector(self, found, *names):
        return self.of(found.input(*names), 'vector')

    def share(self, found, *names):
        return self.clamped(self.float(found, *names))

    def clamped(self, operand, wanted=True):
        if not wanted:
            return operand
        if not operand.startswith('r'):
            return text(min(max(float(operand), 0), 1))
        return self.emit('clamp', operand, '0', '1')

    def place(self, found):
        """Where a pattern is looked up: by generated coordinates unless told otherwise."""
        socket = found.input('Vector')
        if socket is None or graph.source(socket) is None:
            return self.generated()
        return self.of(socket, 'vector')

    def generated(self):
        """0 to 1 across the mesh's box."""
        self._textures.read.generated = True
        box = self._textures.box
        local = self.local()
        if box is None:
            return local
        least, size = box
        rows = [[1 / s if i == j else 0 for j in range(3)] + [-at / s]
                for i, (at, s) in enumerate(zip(least, size))]
        return self.affine(local, rows)

    def local(self):
        """The point in the object's space."""
        return self.emit('local')

    def affine(self, operand, rows):
        return self.emit('affine', operand, *(text(x) for row in list(rows)[:3] for x in row))

    def uv(self, name):
        return self.emit(('uv', 'color')[self._textures.coordinates.place_of(name)])

    def vertex_color(self, name):
        return self.emit('color') if self._textures.reads_color(name) else '1'

    def grid(self, _name):
        """Of a volume's grid; None where there is none, as on surfaces."""
        return None

    def image(self, found):
        """Of node Image Texture; its colours as they are."""
        name = self._textures.plain(found)
        if self._textures.is_placed_by_uv(found) or not isinstance(name, str):
            return self.texture(name)
        place = found.input('Vector')
        at = self.of(place, 'vector') if graph.source(place) else self.uv(RENDERED)
        return self.emit('textureat', self._number_of(name), at)

    def of_object(self, name):
        """A value of the object's; None where there is none."""
        value = self._textures.of_object(name)
        if value is None:
            return None
        return text(value[0]) if len(value) == 1 else self.value(*value)

    def mean_by_angle(self, found):
        """Of a node Fresnel or Layer Weight."""
        self._left_out.add('what differs by angle has its mean')
        return text(self._textures.mean_by_angle(found))

    def blackbody(self, found):
        if graph.source(found.input('Temperature')) is None:
            return self.value(*self._textures.blackbody(found))
        return self.blackbody_at(self.float(found, 'Temperature'))

    def blackbody_at(self, kelvin):
        """Of an operand; stops as near to each other as colours differ, which is by 1 / kelvin."""
        width = HOTTEST - COLDEST
        stops = []
        for i in range(RAMP_POINTS):
            share = i / (RAMP_POINTS - 1)
            at = 1 / (share / HOTTEST + (1 - share) / COLDEST)
            stops += [(at - COLDEST) / width, *blackbody(at)]
        place = self.emit('math', 'subtract', kelvin, text(COLDEST), '0')
        place = self.emit('math', 'divide', place, text(width), '0')
        return self.emit('ramp', 'linear', place, *map(text, stops))

    def tell(self, what):
        self._left_out.add(what)

    def constant(self):
        """Three numbers where the last line is the same everywhere and that is known here."""
        return folded(self.lines)

    def parameters(self, kind):
        found = [parameter('string', 'program', self.lines)]
        found += [parameter('texture', f'tex{i}', name) for i, name in enumerate(self.read, 1)]
        if kind == 'color':
            found.append(parameter('bool', 'plaincolors', True))
        return found


# Nodes ------------------------------------------------------------------------------------------


def _coordinates(program, found):
    name = found.output.name
    if name == 'UV':
        return program.uv(RENDERED)
    if name == 'Normal':
        return program.emit('localnormal')
    if name == 'Object':
        other = found.node.object
        if other is None:
            return program.local()
        return program.affine(program.emit('position'), other.matrix_world.inverted_safe())
    if name != 'Generated':
        program.tell(f'texture coordinates {name} are replaced by generated ones')
    return program.generated()


def _geometry(program, found):
    name = found.output.name
    if name == 'Position':
        return program.emit('position')
    if name in ('Normal', 'True Normal'):
        return program.emit('normal')
    if name == 'Parametric':
        return program.uv(RENDERED)
    program.tell(f'{name} of node Geometry is taken to be the same everywhere')
    return {'Pointiness': '0.5', 'Random Per Island': '0.5'}.get(name, '0')


def _attribute(program, found):
    node = found.node
    if node.type == 'ATTRIBUTE' and node.attribute_type in ('OBJECT', 'INSTANCER'):
        value = program.of_object('.' + node.attribute_name)
        return value if found.output.name in ('Color', 'Vector', 'Fac') else None
    if node.type == 'ATTRIBUTE' and node.attribute_type != 'GEOMETRY':
        return None
    name = node.attribute_name if node.type == 'ATTRIBUTE' else node.layer_name
    if found.output.name == 'Alpha':
        program.tell('alpha of colours is taken for 1')
        return '1'
    if node.type == 'ATTRIBUTE' and not name:
        return '0'
    color = program.vertex_color(name)
    return program.emit('average', color) if found.output.type == 'VALUE' else color


def _object_info(program, found):
    if found.output.name == 'Material Index':
        return text(program.material_index)
    return program.of_object(found.output.name)


def _volume_info(program, found):
    return program.grid(found.output.name.lower()) or '0'


def turned(angles):
    """The matrix of Euler angles about x, then y, then z."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(angles), np.sin(angles)
    about_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    about_z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return about_z @ about_y @ about_x


def _mapping(program, found):
    place, kind = program.vector(found, 'Vector'), found.node.vector_type

    def input_of(what, neutral):
        return program.vector(found, what) if found.input(what) else text(neutral)

    turn = np.eye(3)
    if found.input('Rotation'):
        if graph.source(found.input('Rotation')):
            program.tell('linked rotations of node Mapping are taken as they are set')
        turn = turned(np.array(found.input('Rotation').socket.default_value))
    shift, scale = input_of('Location', 0), input_of('Scale', 1)

    def vector(what, a, b):
        return program.emit('vector', what, a, b, '0', '0')

    def rotated(operand, matrix):
        if np.allclose(matrix, np.eye(3)):
            return operand
        return program.affine(operand, np.hstack([matrix, np.zeros((3, 1))]))

    if kind == 'TEXTURE':
        return vector('divide', rotated(vector('subtract', place, shift), turn.T), scale)
    if kind == 'NORMAL':
        return vector('normalize', rotated(vector('divide', place, scale), turn), '0')
    made = rotated(vector('multiply', place, scale), turn)
    return made if kind == 'VECTOR' else vector('add', made, shift)


def _math(program, found):
    operands = [program.of(graph.Place(s, found.groups), 'float') if s.enabled else '0'
                for s in found.node.inputs][:3]
    made = program.emit('math', found.node.operation.lower(), *operands)
    return program.clamped(made, found.node.use_clamp)


def _vector_math(program, found):
    sockets, operation = found.node.inputs, found.node.operation.lower()
    if operation in ('refract', 'faceforward'):
        return None
    operands = [program.of(graph.Place(s, found.groups), 'vector') if s.enabled else '0'
                for s in sockets][:3]
    scale = program.float(found, 'Scale') if found.input('Scale') else '0'
    return program.emit('vector', operation, *operands, scale)


def _mix(program, found):
    node = found.node
    if node.type == 'MIX_RGB':
        made = program.emit('mix', node.blend_type.lower(), program.share(found, 'Fac'),
                            program.color(found, 'Color1'), program.color(found, 'Color2'))
        return program.clamped(made, node.use_clamp)
    kind = {'FLOAT': 'Float', 'VECTOR': 'Vector', 'RGBA': 'Color'}.get(node.data_type)
    if kind is None:
        return None
    want = {'Float': 'float', 'Vector': 'vector', 'Color': 'color'}[kind]
    a, b = (program.of(found.input(f'{side}_{kind}'), want) for side in 'AB')
    if kind == 'Vector' and node.factor_mode == 'NON_UNIFORM':
        by = program.clamped(program.vector(found, 'Factor_Vector'), node.clamp_factor)
        difference = program.emit('vector', 'subtract', b, a, '0', '0')
        return program.emit('vector', 'multiply_add', difference, by, a, '0')
    by = program.clamped(program.float(found, 'Factor_Float'), node.clamp_factor)
    how = node.blend_type.lower() if kind == 'Color' else 'mix'
    made = program.emit('mix', how, by, a, b)
    return program.clamped(made, kind == 'Color' and node.clamp_result)


def _ramp(program, found):
    ramp = found.node.color_ramp
    exact = ramp.color_mode == 'RGB' and ramp.interpolation in ('LINEAR', 'CONSTANT')
    if exact:
        stops = [(e.position, tuple(e.color)) for e in ramp.elements]
    else:
        ends = [e.position for e in ramp.elements]
        stops = [(at, tuple(ramp.evaluate(at))) for at in
                 np.linspace(ends[0], ends[-1], RAMP_POINTS)]
    alpha = found.output.name == 'Alpha'
    table = [(at, *((c[3],) * 3 if alpha else c[:3])) for at, c in stops]
    constant = exact and ramp.interpolation == 'CONSTANT'
    return program.emit('ramp', 'constant' if constant else 'linear', program.float(found, 'Fac'),
                        *(f'{x:.5g}' for stop in table for x in stop))


def _curves(program, found):
    mapping = found.node.mapping
    mapping.initialize()
    curves = mapping.curves
    least = -1.0 if found.node.type == 'CURVE_VEC' else 0.0
    rows = []
    for at in np.linspace(least, 1, CURVE_POINTS):
        whole = mapping.evaluate(curves[3], at) if len(curves) > 3 else at
        rows.append([mapping.evaluate(curves[min(i, len(curves) - 1)], whole) for i in range(3)])
    given = {'CURVE_VEC': 'Vector', 'CURVE_FLOAT': 'Value'}.get(found.node.type, 'Color')
    before = program.of(found.input(given), KIND_OF_SOCKET.get(found.output.type, 'float'))
    made = program.emit('curves', before, text(least), '1',
                        *(f'{x:.4g}' for row in rows for x in row))
    return program.emit('mix', 'mix', program.share(found, 'Fac', 'Factor'), before, made)


def _hue_saturation(program, found):
    return program.emit('huesaturation', *(program.float(found, what) for what in
                                           ('Hue', 'Saturation', 'Value', 'Fac')),
                        program.color(found, 'Color'))


def _bright_contrast(program, found):
    return program.emit('brightcontrast', program.color(found, 'Color'),
                        program.float(found, 'Bright', 'Brightness'),
                        program.float(found, 'Contrast'))


def _gamma(program, found):
    return program.emit('gamma', program.color(found, 'Color'), program.float(found, 'Gamma'))


def _invert(program, found):
    return program.emit('invert', program.float(found, 'Fac'), program.color(found, 'Color'))


def _clamp(program, found):
    least, most = (program.float(found, what) for what in ('Min', 'Max'))
    if found.node.clamp_type == 'RANGE':
        least, most = (program.emit('math', how, least, most, '0')
                       for how in ('minimum', 'maximum'))
    return program.emit('clamp', program.float(found, 'Value'), least, most)


def _map_range(program, found):
    node = found.node
    how = node.interpolation_type.lower()
    if getattr(node, 'data_type', 'FLOAT') != 'FLOAT':
        parts = [program.emit('maprange', how, *(
            program.emit('channel', axis, program.vector(found, what)) for what in
            ('Vector', 'From_Min_FLOAT3', 'From_Max_FLOAT3', 'To_Min_FLOAT3', 'To_Max_FLOAT3')),
            '4') for axis in 'xyz']
        return program.emit('combine', *parts)
    ends = [program.float(found, what) for what in ('From Min', 'From Max', 'To Min', 'To Max')]
    steps = program.float(found, 'Steps') if how == 'stepped' else '0'
    made = program.emit('maprange', how, program.float(found, 'Value'), *ends, steps)
    if not node.clamp or how in ('smoothstep', 'smootherstep'):
        return made
    least, most = (program.emit('math', side, ends[2], ends[3], '0')
                   for side in ('minimum', 'maximum'))
    return program.emit('clamp', made, least, most)


def _separate(program, found):
    node = found.node
    given = {'SEPXYZ': 'Vector', 'SEPRGB': 'Image'}.get(node.type, 'Color')
    operand = program.of(found.input(given), 'vector' if given == 'Vector' else 'color')
    if node.type == 'SEPHSV' or getattr(node, 'mode', 'RGB') == 'HSV':
        operand = program.emit('tohsv', operand)
    elif getattr(node, 'mode', 'RGB') != 'RGB':
        return None
    index = [s.identifier for s in node.outputs].index(found.output.identifier)
    return program.emit('channel', 'xyz'[index], operand)


def _combine(program, found):
    node = found.node
    parts = [program.of(graph.Place(s, found.groups), 'float') for s in node.inputs][:3]
    made = program.emit('combine', *parts)
    if node.type == 'COMBHSV' or getattr(node, 'mode', 'RGB') == 'HSV':
        return program.emit('fromhsv', made)
    return made if getattr(node, 'mode', 'RGB') == 'RGB' else None


def _kind(found):
    return 'color' if found.output.name == 'Color' else 'fac'


def node_dimensions(found):
    return setting('3D', (found.node, 'noise_dimensions'), (found.node, 'musgrave_dimensions'),
                   (found.node, 'voronoi_dimensions')).lower()


def _noise(program, found):
    node = found.node
    kind = getattr(node, 'noise_type', 'FBM')  # from 4.1 on
    if kind != 'FBM' or not getattr(node, 'normalize', True):
        if found.output.name != 'Color' and program.float(found, 'Distortion') == '0':
            detail, fade = (program.set(found, what) for what in ('Detail', 'Roughness'))
            return _fractal(program, found, kind, detail + 1, fade)
        program.tell('distorted and coloured noises of other kinds are normalized sums of octaves')
    lacunarity = program.float(found, 'Lacunarity') if found.input('Lacunarity') else '2'
    return program.emit('noise', _kind(found), node_dimensions(found), program.place(found),
                        program.float(found, 'W'), program.float(found, 'Scale'),
                        program.float(found, 'Detail'), program.float(found, 'Roughness'),
                        lacunarity, program.float(found, 'Distortion'))


def _voronoi(program, found):
    node = found.node
    dimensions = node_dimensions(found)
    if dimensions not in ('2d', '3d'):
        program.tell('cells of one or four dimensions are replaced by those of three')
        dimensions = '3d'
    feature = node.feature.lower()
    if feature == 'n_sphere_radius':
        return None
    if found.input('Detail') and program.float(found, 'Detail') != '0':
        program.tell('details of node Voronoi Texture are left out')
    made = program.emit(
        'voronoi', dimensions, feature, node.distance.lower(), found.output.name.lower(),
        program.place(found), program.float(found, 'Scale'), program.share(found, 'Randomness'),
        program.share(found, 'Smoothness') if found.input('Smoothness') else '1',
        program.float(found, 'Exponent') if found.input('Exponent') else '0.5')
    return made


def _white_noise(program, found):
    return program.emit('white', 'color' if found.output.name == 'Color' else 'fac',
                        program.place(found))


def _checker(program, found):
    colors = [program.color(found, f'Color{i}') for i in (1, 2)]
    if found.output.name != 'Color':
        colors = ['1', '0']
    return program.emit('checker', program.place(found), program.float(found, 'Scale'), *colors)


def _brick(program, found):
    node = found.node
    return program.emit(
        'brick', _kind(found), program.place(found), program.float(found, 'Scale'),
        *(program.color(found, what) for what in ('Color1', 'Color2', 'Mortar')),
        *(program.float(found, what) for what in
          ('Mortar Size', 'Mortar Smooth', 'Bias', 'Brick Width', 'Row Height')),
        text(node.offset), text(node.offset_frequency), text(node.squash),
        text(node.squash_frequency))


def _gradient(program, found):
    return program.emit('gradient', found.node.gradient_type.lower(), program.place(found))


def _wave(program, found):
    node = found.node
    direction = node.bands_direction if node.wave_type == 'BANDS' else node.rings_direction
    direction = {'SPHERICAL': 'diagonal'}.get(direction, direction.lower())
    return program.emit(
        'wave', node.wave_type.lower(), direction, node.wave_profile.lower(), program.place(found),
        *(program.float(found, what) for what in
          ('Scale', 'Distortion', 'Detail', 'Detail Scale', 'Detail Roughness', 'Phase Offset')))


def _magic(program, found):
    return program.emit('magic', _kind(found), program.place(found), program.float(found, 'Scale'),
                        text(found.node.turbulence_depth), program.float(found, 'Distortion'))


def _fractal(program, found, kind, octaves, fade):
    lacunarity = max(program.set(found, 'Lacunarity'), 1e-5)
    scale = program.float(found, 'Scale')

    def noise(octave, detail, roughness):
        times = text(lacunarity ** octave)
        finer = program.emit('math', 'multiply', scale, times, '0') if octave else scale
        return program.emit('noise', 'fac', node_dimensions(found), program.place(found),
                            program.float(found, 'W'), finer, text(detail), text(roughness),
                            text(lacunarity), '0')

    offset, gain = (program.set(found, what) if found.input(what) else 0.0
                    for what in ('Offset', 'Gain'))
    return Fractal(program, noise, octaves, fade, offset, gain).of(kind)


def _musgrave(program, found):
    lacunarity = max(program.set(found, 'Lacunarity'), 1e-5)
    fade = lacunarity ** -max(program.set(found, 'Dimension'), 1e-5)
    return _fractal(program, found, found.node.musgrave_type,
                    min(program.set(found, 'Detail'), 15.0), fade)


NODES = {
    'TEX_IMAGE': Program.image, 'TEX_COORD': _coordinates, 'NEW_GEOMETRY': _geometry,
    'UVMAP': lambda program, found: program.uv(found.node.uv_map),
    'ATTRIBUTE': _attribute, 'VERTEX_COLOR': _attribute, 'OBJECT_INFO': _object_info,
    'VOLUME_INFO': _volume_info,
    'FRESNEL': Program.mean_by_angle, 'LAYER_WEIGHT': Program.mean_by_angle,
    'RGB': lambda program, found: program.value(*found.output.default_value[:3]),
    'VALUE': lambda program, found: text(found.output.default_value),
    'BLACKBODY': Program.blackbody,
    'MAPPING': _mapping, 'MATH': _math, 'VECT_MATH': _vector_math, 'MIX': _mix, 'MIX_RGB': _mix,
    'VALTORGB': _ramp, 'CURVE_RGB': _curves, 'CURVE_VEC': _curves, 'CURVE_FLOAT': _curves,
    'HUE_SAT': _hue_saturation, 'BRIGHTCONTRAST': _bright_contrast, 'GAMMA': _gamma,
    'INVERT': _invert, 'CLAMP': _clamp, 'MAP_RANGE': _map_range,
    'SEPARATE_COLOR': _separate, 'SEPRGB': _separate, 'SEPHSV': _separate, 'SEPXYZ': _separate,
    'COMBINE_COLOR': _combine, 'COMBRGB': _combine, 'COMBHSV': _combine, 'COMBXYZ': _combine,
    'RGBTOBW': lambda program, found: program.emit('luminance', program.color(found, 'Color')),
    'TEX_NOISE': _noise, 'TEX_MUSGRAVE': _musgrave, 'TEX_VORONOI': _voronoi,
    'TEX_WHITE_NOISE': _white_noise, 'TEX_CHECKER': _checker, 'TEX_BRICK': _brick,
    'TEX_GRADIENT': _gradient, 'TEX_WAVE': _wave, 'TEX_MAGIC': _magic,
}
