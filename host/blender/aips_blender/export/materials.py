"""Turns Blender's materials into named materials of the scene language, each once."""
import dataclasses

from . import graph, versions
from .object_info import values_of
from .principled import mix, principled
from .shaders import Shader, Shaders, color
from .volume_shaders import MediumNodes

DEFAULT_GREY = (0.8, 0.8, 0.8)  # Cycles' surface without a material


GLOSSY = ('BSDF_GLOSSY', 'BSDF_ANISOTROPIC')


def is_fresnel(by):
    """Whether a node's output is the share that a dielectric reflects."""
    return by.node.type == 'FRESNEL' or (by.node.type == 'LAYER_WEIGHT' and
                                         by.output.name == 'Fresnel')


class Materials:
    """`override`: a material that stands for all of them, or None."""

    def __init__(self, text, textures, left_out, override=None):
        self._override = override
        self._shaders = Shaders(text, textures, left_out)
        self._textures = textures
        self._media = MediumNodes(textures, left_out)
        self._left_out = left_out
        self._border = None  # name of the material around volumes
        self._known = {}  # Shaders by material, and by what they depend on
        self._reads = {}  # of a material whether it depends on the mesh's box, on what of objects
        self._leaves = {
            'BSDF_DIFFUSE': self._shaders.diffuse, 'BSDF_GLOSSY': self._shaders.glossy,
            'BSDF_ANISOTROPIC': self._shaders.glossy, 'BSDF_GLASS': self._shaders.glass,
            'BSDF_REFRACTION': self._shaders.glass, 'BSDF_TRANSPARENT': self._shaders.transparent,
            'BSDF_TRANSLUCENT': self._shaders.translucent, 'BSDF_VELVET': self._shaders.velvet,
            'BSDF_SHEEN': self._shaders.velvet, 'BSDF_METALLIC': self._shaders.metallic,
            'SUBSURFACE_SCATTERING': self._shaders.scattering, 'EMISSION': self._shaders.emission,
            'BSDF_HAIR': self._shaders.fibre,
            'BSDF_HAIR_PRINCIPLED': self._shaders.hair,
            'BSDF_PRINCIPLED': lambda found, name: principled(self._shaders, found, name),
            'MIX_SHADER': self._mix, 'ADD_SHADER': self._add,
        }

    def shader(self, material, box=None, info=None, fills=False):
        """The Shader of a material, which may be None, on a mesh of this box, by which generated
        coordinates go: its least corner and size; and on an object of this ObjectInfo. `fills`:
        the object is of type volume and has no surface."""
        material = self._override or material
        name = material.name_full if material else None, fills
        key = self._key(name, box, info)
        if key not in self._known:
            made = self._read(material, name, box, info)
            key = self._key(name, box, info)  # more of it may be known
            self._known[key] = dataclasses.replace(made, of_object=self._reads[name][1])
        return self._known[key]

    def _key(self, name, box, info):
        by_box, of_object = self._reads.get(name, (False, frozenset()))
        return name, box if by_box else None, info and values_of(info, of_object)

    def _read(self, material, name, box, info):
        textures = self._textures
        self._left_out.reading = material.name if material else ''
        textures.box, textures.info = box, info
        textures.material_index = material.pass_index if material else 0
        made = self._filling(material) if name[1] else self._made(material)
        if isinstance(made.emission, str) and (textures.read.colors or len(textures.read.uv) > 1):
            self._left_out.add('what shines has white in place of colours of vertices and of '
                               'second uv maps')
        textures.box = textures.info = None
        by_box, of_object = self._reads.get(name, (False, frozenset()))
        self._reads[name] = (by_box or textures.read.generated,
                             of_object | textures.read.of_object)
        return dataclasses.replace(made, layers=textures.read.taken())

    def _made(self, material):
        if material is None:
            return self._matte('no material', DEFAULT_GREY)
        if not versions.uses_nodes(material):
            return self._matte(material.name, tuple(material.diffuse_color[:3]))
        output = graph.output_node(material.node_tree, 'OUTPUT_MATERIAL')
        if output is None:
            return Shader(self._shaders.black(material.name))
        if graph.source(graph.Place(output.inputs['Displacement'])):
            self._left_out.add('displacement of materials is left out', material.name)
        surface, volume = (graph.Place(output.inputs[what]) for what in ('Surface', 'Volume'))
        if graph.source(volume) is None:
            return self._of(surface, material.name)
        # Without a surface a volume has a border that is not seen.
        shader = self._of(surface, material.name) if graph.source(surface) else \
            Shader(self._shaders.null(material.name), opaque=False)
        return dataclasses.replace(shader, medium=self._media.of(volume, material.name))

    def _filling(self, material):
        """The Shader of what has no surface: a border that is not seen."""
        if self._border is None:
            self._border = self._shaders.null('border of volumes')
        made = Shader(self._border, opaque=False)
        if material is None:
            return dataclasses.replace(made, medium=self._media.of_no_material())
        output = versions.uses_nodes(material) and \
            graph.output_node(material.node_tree, 'OUTPUT_MATERIAL')
        if not output:
            return made
        volume = graph.Place(output.inputs['Volume'])
        return dataclasses.replace(made, medium=self._media.of(volume, material.name))

    def _matte(self, name, rgb):
        return Shader(self._shaders.named(name, 'matte', [color('Kd', rgb)]))

    def _of(self, place, name):
        found = graph.source(place)
        if found is None:
            return Shader(self._shaders.black(name))
        make = self._leaves.get(found.node.type)
        if make is None:
            self._left_out.add(f'shaders {found.node.bl_label} are replaced by grey', name)
            return self._matte(name, DEFAULT_GREY)
        return make(found, name)

    def _inputs(self, found):
        """The two places of a mix or a sum, which have the same name."""
        return [graph.Place(s, found.groups) for s in found.node.inputs if s.type == 'SHADER']

    def _mix(self, found, name):
        first, second = self._inputs(found)
        by, over = graph.source(found.input('Fac')), graph.source(second)
        if by and by.node.type == 'LIGHT_PATH':
            return self._by_ray(by.output.name, first, second, name)
        if over and over.node.type in GLOSSY and by and is_fresnel(by):
            return self._by_fresnel(by, first, over, name)
        share = self._share(found, name)
        if share == 0.0:
            return self._of(first, name)
        if share == 1.0:
            return self._of(second, name)
        a, b = self._of(first, f'{name}: 1'), self._of(second, f'{name}: 2')
        emission = self._sum(self._part(a, share, True), self._part(b, share, False), name)
        return Shader(mix(self._shaders, name, a.name, b.name, share), emission,
                      opaque=a.opaque and b.opaque)

    def _share(self, found, name):
        share = self._textures.number(found.input('Fac'))
        return share if isinstance(share, str) else min(max(share, 0.0), 1.0)

    def _by_fresnel(self, by, first, over, name):
        """Gloss by a dielectric's share over what lies below, which makes glass of what it lets
        through."""
        below = graph.source(first)
        index = self._textures.index_by_angle(by)
        if below and below.node.type == 'BSDF_REFRACTION':
            return self._shaders.glass_of(over, below, name)
        if below and below.node.type == 'BSDF_TRANSPARENT' and self._shaders.is_smooth(over):
            return self._shaders.pane(over, below, index, name)
        base = self._of(first, f'{name}: base')
        reflects = ((index - 1) / (index + 1)) ** 2
        return dataclasses.replace(base, name=self._shaders.coat(over, name, base.name, reflects))

    def _by_ray(self, what, first, second, name):
        """A mix by an output of node Light Path: what the camera sees, unless it is what shines."""
        camera = what == 'Is Camera Ray'
        seen, other = (second, first) if camera else (first, second)
        if camera and self._kind(other) == 'EMISSION':
            made = self._of(other, name)
            if self._kind(seen) in (None, 'BSDF_TRANSPARENT'):  # a light that is not seen
                return dataclasses.replace(made, name=self._shaders.null(f'{name}: unseen'),
                                           opaque=False, hidden=True)
            self._tell_ray('what the camera sees is what lights the scene', name)
            return made
        self._tell_ray('all rays see what the camera does', name)
        return self._of(seen, name)

    def _tell_ray(self, instead, name):
        self._left_out.add(f'what differs by kind of ray (Light Path) is left out, {instead}', name)

    @staticmethod
    def _kind(place):
        found = graph.source(place)
        return found.node.type if found else None

    def _part(self, shader, share, first):
        """Emission of one side of a mix, times its share."""
        if shader.emission is None:
            return None
        return self._textures.share(shader.emission, share, first)

    def _sum(self, a, b, name):
        if a is None or b is None:
            return a if b is None else b
        if isinstance(a, tuple) and isinstance(b, tuple):
            return tuple(x + y for x, y in zip(a, b))
        self._left_out.add('of two emissions with textures one is left out', name)
        return a

    def _add(self, found, name):
        """Emission adds to a surface; of two surfaces the sum has no counterpart."""
        first, second = self._inputs(found)
        kinds = [graph.source(place) for place in (first, second)]
        if kinds[0] is None or kinds[0].node.type == 'EMISSION':
            first, second = second, first
            kinds.reverse()
        if kinds[1] and kinds[1].node.type != 'EMISSION':
            self._left_out.add('sums of two surfaces show the first', name)
            return self._of(first, name)
        base, light = self._of(first, name), self._of(second, f'{name}: light')
        return dataclasses.replace(base, emission=self._sum(base.emission, light.emission, name))
