"""Turns Blender's materials into named materials of the scene language, each once."""
import dataclasses

from . import graph, versions
from .media import MediumNodes
from .principled import mix, principled
from .shaders import Shader, Shaders, color

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
        self._known = {}   # Shaders by material
        self._by_box = {}  # of those that differ by mesh
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

    def shader(self, material, box=None):
        """The Shader of a material, which may be None, on a mesh of this box: its least corner and
        size, by which generated coordinates go."""
        material = self._override or material
        key = material.name_full if material else None
        if key in self._known:
            return self._known[key]
        if (key, box) not in self._by_box:
            self._left_out.reading = material.name if material else ''
            self._textures.box = box
            made = self._made(material)
            if isinstance(made.emission, str) and self._textures.read.colors:
                self._left_out.add('what shines has white in place of colours of vertices')
            self._textures.box = None
            known, own = (self._by_box, (key, box)) if self._textures.read.generated else \
                (self._known, key)
            known[own] = dataclasses.replace(made, layers=self._textures.read.taken())
            return known[own]
        return self._by_box[key, box]

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
        if over and over.node.type in GLOSSY and by and is_fresnel(by):
            base = self._of(first, f'{name}: base')
            coat = self._shaders.coat(over, name, base.name, self._normal_incidence(by))
            return dataclasses.replace(base, name=coat)
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
        place = found.input('Fac')
        by = graph.source(place)
        if by and by.node.type == 'LIGHT_PATH':
            self._left_out.add('what differs by kind of ray (Light Path) is left out', name)
            return 0.0
        if by and by.node.type in ('FRESNEL', 'LAYER_WEIGHT'):
            self._left_out.add('mixes by angle have their share at normal incidence', name)
            return self._normal_incidence(by)
        share = self._textures.number(place)
        return share if isinstance(share, str) else min(max(share, 0.0), 1.0)

    def _normal_incidence(self, by):
        if by.node.type == 'FRESNEL':
            index = self._textures.constant_number(by.input('IOR'), 'index of refraction')
        elif by.output.name == 'Fresnel':
            index = 1 / max(1 - self._textures.constant_number(by.input('Blend'), 'blends'), 1e-5)
        else:
            return 0.0
        return ((index - 1) / (index + 1)) ** 2

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
