"""Turns what feeds a colour or a number socket into constants, or textures of the scene language.

A value is a tuple of three numbers or a number where it is constant, and a texture's name where
it is not. Nodes without a counterpart give their mean guess, and are told as left out.
"""
import contextlib
import math

from . import angles, graph
from .blackbody import blackbody
from .colours import surface_color
from .coordinates import Coordinates, uv_parameters
from .folded import shortened
from .grids import GridTextures
from .layers import Read
from .lxs_text import color as color_as_written, factor, parameter
from .node_programs import Program, TooLong

GREY = (0.5, 0.5, 0.5)
MAGENTA = (1.0, 0.0, 1.0)  # where an image is missing, as in Cycles
WRAP = {'REPEAT': 'repeat', 'EXTEND': 'clamp', 'CLIP': 'black'}
LUMINANCE = (0.2126, 0.7152, 0.0722)  # Rec. 709


def color(name, value):
    """The parameter of a colour within a texture, which mostly is that of a surface."""
    return color_as_written(name, surface_color(value))


def luminance(rgb):
    return sum(w * c for w, c in zip(LUMINANCE, rgb))


class Textures:
    def __init__(self, text, images, left_out):
        self._text = text
        self._images = images
        self._left_out = left_out
        self.read = Read()
        self.coordinates = Coordinates(self.read, left_out)
        self.grids = GridTextures(text)
        self._known = {}
        self.box = None  # least corner and size of the mesh whose generated coordinates are meant
        self.material_index = 0
        self.info = None  # the ObjectInfo of what is meant, or None
        self.camera_ray = 1.0  # whether what the camera sees is meant

    @contextlib.contextmanager
    def lighting(self):
        """Within it values are those that light other surfaces, in place of those seen."""
        self.camera_ray = 0.0
        try:
            yield
        finally:
            self.camera_ray = 1.0

    def index_by_angle(self, by):
        """Index of refraction of a node Fresnel, or of that output of a node Layer Weight."""
        if by.node.type == 'FRESNEL':
            return self.constant_number(by.input('IOR'), 'index of refraction')
        return angles.index_of_blend(self.constant_number(by.input('Blend'), 'blends'))

    def mean_by_angle(self, by):
        if by.node.type == 'LAYER_WEIGHT' and by.output.name == 'Facing':
            return angles.mean_facing(self.constant_number(by.input('Blend'), 'blends'))
        return angles.mean_fresnel(self.index_by_angle(by))

    def of_object(self, name):
        """A value of ObjectInfo; None where there is no object."""
        if self.info is None:
            return None
        self.read.of_object.add(name)
        return self.info.value(name)

    def reads_color(self, name):
        """Whether a material may read a layer of colours, which it does from here on."""
        if not self.read.has_place_for_colors():
            self._left_out.add('of the uv maps and colours that a material reads two are taken')
            return False
        self.read.colors.add(name)
        return True

    def image_file(self, node):
        """The ImageFile of a node's image, or None."""
        return self._images.file(node.image, node.image_user)

    def color(self, place):
        """Value of a colour place."""
        found = graph.source(place)
        if found is None:
            value = graph.constant(place)
            return (value,) * 3 if isinstance(value, float) else tuple(value[:3])
        return self._once(found, 'color')

    def number(self, place):
        """Value of a number place."""
        found = graph.source(place)
        if found is None:
            value = graph.constant(place)
            return value if isinstance(value, float) else luminance(value[:3])
        return self._once(found, 'float')

    def constant_number(self, place, what):
        """A number where the scene language takes no texture; `what` is told where there is one."""
        value = self.number(place)
        if isinstance(value, str):
            self._left_out.add(f'textures of {what} are left out')
            return float(place.socket.default_value)
        return value

    def _once(self, found, kind):
        # Nodes are wrapped anew at each access; their addresses tell them apart.
        key = (found.node.as_pointer(), found.output.identifier, kind,
               tuple(g.as_pointer() for g in found.groups), self.box, self.info, self.camera_ray)
        if key not in self._known:
            self._known[key] = self._value(found, kind)
        return self._known[key]

    def _value(self, found, kind):
        make = {
            'TEX_IMAGE': self._image, 'RGB': self._rgb, 'VALUE': self._number, 'MIX': self._mix,
            'MIX_RGB': self._mix, 'BLACKBODY': self._blackbody, 'VERTEX_COLOR': self._vertex_color,
            'ATTRIBUTE': self._vertex_color,
        }.get(found.node.type)
        value = make(found, kind) if make else None
        if value is None:
            value = self._program(found, kind)
        if kind == 'float' and isinstance(value, tuple):
            return luminance(value)
        if kind != 'float' and isinstance(value, (int, float)):
            return (value,) * 3
        return value

    def _program(self, found, kind):
        """The value of a node and of those before it, by texture "nodes" where it varies."""
        program = Program(self, self._left_out)
        try:
            last = program.of_node(found, kind)
        except TooLong:
            self._left_out.add('graphs of too many nodes are replaced by grey')
            return GREY
        return self.of_program(program, last, kind)

    def of_program(self, program, last, kind):
        """The value of an operand of a program, which it ends with; `kind`: float, color, or plain
        for colours that are no surface's."""
        if not last.startswith('r'):
            return float(last)
        if last != f'r{len(program.lines) - 1}':
            program.lines.append(f'math add {last} 0 0' if kind == 'float' else
                                 f'vector add {last} 0 0 0')
        constant = program.constant()
        if constant is not None:
            return constant[0] if kind == 'float' else constant
        program.lines = shortened(program.lines)
        return self._texture('nodes', 'float' if kind == 'float' else 'color', 'nodes',
                             program.parameters(kind))

    def plain(self, found):
        """The colour texture of a node Image Texture, its colours as they are."""
        return self._once(found, 'plain')

    def blackbody(self, found):
        return self._blackbody(found, 'color')

    def _texture(self, wanted, kind, plugin, parameters):
        name = self._text.free_name(wanted)
        self._text.statement('Texture', name, kind, plugin, parameters=parameters)
        return name

    def _rgb(self, found, _kind):
        return tuple(found.output.default_value[:3])

    def _number(self, found, _kind):
        return float(found.output.default_value)

    def _blackbody(self, found, _kind):
        return blackbody(self.constant_number(found.input('Temperature'), 'temperatures'))

    def _vertex_color(self, found, kind):
        node = found.node
        if node.type == 'ATTRIBUTE' and node.attribute_type != 'GEOMETRY':
            return None
        name = node.attribute_name if node.type == 'ATTRIBUTE' else node.layer_name
        if node.type == 'ATTRIBUTE' and not name:
            return (0.0, 0.0, 0.0)
        if found.output.name == 'Alpha':
            self._left_out.add('alpha of colours is taken for 1')
            return 1.0
        if not self.reads_color(name):
            return (1.0, 1.0, 1.0)
        return self._texture('vertex color', kind,
                             'hitpointcolor' if kind == 'color' else 'hitpointgrey', [])

    def _image(self, found, kind):
        node = found.node
        if kind != 'plain' and not self.is_placed_by_uv(found):
            return None
        file = self.image_file(node) if node.image else None
        if file is None:
            return MAGENTA if node.image else (0.0, 0.0, 0.0)
        if node.projection != 'FLAT':
            self._left_out.add('projections of images are left out, uv is used', node.image.name)
        if found.output.name != 'Alpha':
            what = [parameter('string', 'channel', 'colored_mean')] if kind == 'float' else \
                [parameter('bool', 'plaincolors', kind == 'color')]
            if file.times_alpha and not node.outputs['Alpha'].is_linked:
                what.append(parameter('bool', 'timesalpha', True))  # as Cycles, which is odd
            return self._image_channel(node, file, found, 'float' if kind == 'float' else 'color',
                                       what)
        if node.image.alpha_mode == 'NONE':
            return 1.0
        alpha = self._image_channel(node, file, found, 'float',
                                    [parameter('string', 'channel', 'alpha')])
        return alpha if kind == 'float' else self._grey(alpha)

    def _grey(self, amount):
        """A colour texture of a float one."""
        return self._texture('grey', 'color', 'mix', [factor('amount', amount)])

    def _image_channel(self, node, file, found, kind, what):
        return self._texture(node.image.name, kind, 'imagemap', [
            self._text.file(file.path), file.color_space(), *what,
            parameter('string', 'wrap', WRAP.get(node.extension, 'repeat')),
            parameter('string', 'filtertype',
                      'nearest' if node.interpolation == 'Closest' else 'bilinear'),
            *self.mapping(found)])

    def is_placed_by_uv(self, found):
        """Whether an image is looked up by the first uv map, at most scaled and shifted."""
        return self.coordinates.are_plain(found) and self.coordinates.are_of_first(found)

    def mapping(self, found):
        """Parameters of an image's uv mapping, that of a node Mapping before `found`; none where
        the coordinates come by other nodes."""
        scale, shift = (1.0, 1.0), (0.0, 0.0)
        if self.is_placed_by_uv(found):
            scale, shift = self.coordinates.uv(found)
        # Images of the scene language begin at the top, uv of Blender at the bottom.
        return uv_parameters((scale[0], -scale[1]), (shift[0], 1 - shift[1]))

    def _mix(self, found, kind):
        node = found.node
        if node.type == 'MIX' and node.data_type != 'RGBA':
            return None
        first = found.input('A_Color', 'Color1')
        second = found.input('B_Color', 'Color2')
        amount = self.number(found.input('Factor_Float', 'Fac'))
        a, b = self.color(first), self.color(second)
        mixed = self._blended(node.blend_type, a, b, amount)
        if mixed is None or kind == 'color' or isinstance(mixed, tuple):
            return mixed
        return None

    def _blended(self, blend, a, b, amount):
        if not any(isinstance(v, str) for v in (a, b, amount)):
            return _blended_constants(blend, a, b, amount)
        if blend == 'MULTIPLY':
            product = self._texture('product', 'color', 'scale',
                                    [color('tex1', a), color('tex2', b)])
            return self._blended('MIX', a, product, amount) if amount != 1 else product
        if blend != 'MIX':
            return None
        return self._texture('mixed colors', 'color', 'mix',
                             [color('tex1', a), color('tex2', b), factor('amount', amount)])

    def mixed(self, a, b, amount):
        """Of two colour values the one by `amount` on the way from the first to the second."""
        return self._blended('MIX', a, b, amount)

    def root(self, value):
        """Square root of a colour value."""
        if isinstance(value, tuple):
            return tuple(max(c, 0.0) ** 0.5 for c in value)
        self._left_out.add('glass of node Principled BSDF is tinted twice by textures')
        return value

    def product(self, light, gain):
        """A colour value of light times a number or a value of numbers."""
        if isinstance(gain, str):
            return self._faded(light, gain, 'tex2', 'tex1')
        if isinstance(light, tuple):
            return tuple(c * gain for c in light)
        if gain == 1:
            return light
        return self._texture('gain', 'color', 'scale', [
            color('tex1', light), color('tex2', (gain,) * 3)])

    def share(self, light, share, first):
        """What the first or the second side of a mix contributes to its light."""
        if isinstance(share, str) and first:
            return self._faded(light, share, 'tex1', 'tex2')
        return self.product(light, 1 - share if first else share)

    def _faded(self, light, amount, where, other):
        """A mix of light and darkness by a texture."""
        return self._texture('faded', 'color', 'mix', [
            color_as_written(where, surface_color(light, math.inf)),
            color_as_written(other, (0.0, 0.0, 0.0)), factor('amount', amount)])


def _blended_constants(blend, a, b, amount):
    single = {'MIX': lambda x, y: y, 'MULTIPLY': lambda x, y: x * y, 'ADD': lambda x, y: x + y,
              'SUBTRACT': lambda x, y: x - y, 'DARKEN': min, 'LIGHTEN': max,
              'SCREEN': lambda x, y: 1 - (1 - x) * (1 - y)}.get(blend)
    if single is None:
        return None
    return tuple(x + amount * (single(x, y) - x) for x, y in zip(a, b))
