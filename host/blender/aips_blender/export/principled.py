"""Turns node Principled BSDF into LuxRender's glossy, glass and mixes of these.

Sockets have the names of Blender 4 here, and those of Blender 3 behind them.
"""
from .lxs_text import factor, parameter
from .shaders import BLACK, CONSERVING, WHITE, Shader, color
from .versions import BLENDER_3

REFLECTANCE_OF_SPECULAR = 0.08  # at normal incidence, where Blender 3's Specular is 1
SPECULAR = ('Specular IOR Level', 'Specular')
TRANSMISSION = ('Transmission Weight', 'Transmission')
EMISSION = ('Emission Color', 'Emission')
COAT = ('Coat Weight', 'Clearcoat')
COAT_ROUGHNESS = ('Coat Roughness', 'Clearcoat Roughness')
CLEARCOAT = 0.25 * 0.04  # reflectance of Blender 3's clearcoat of 1
SUBSURFACE = ('Subsurface Weight', 'Subsurface')
DIELECTRIC = parameter('string', 'fresnel', 'dielectric')
LEFT_OUT = (('Sheen Weight', 'Sheen'), ('Transmission Roughness',),
            ('Diffuse Roughness',), ('Thin Film Thickness',))


def principled(shaders, found, name):
    textures = shaders.textures
    for names in LEFT_OUT:
        place = found.input(*names)
        if place and textures.number(place) != 0.0:
            shaders.left_out.add(f'{place.socket.name} of node Principled BSDF is left out', name)
    alpha = textures.number(found.input('Alpha'))
    if alpha == 1.0:
        material = _below_coat(shaders, found, name)
    else:
        opaque = _below_coat(shaders, found, f'{name}: opaque')
        material = mix(shaders, name, shaders.null(f'{name}: null'), opaque, alpha)
    through = textures.number(found.input(*TRANSMISSION)) != 0.0 and \
        textures.number(found.input('Metallic')) != 1.0
    return Shader(material, _emission(shaders, found, alpha), opaque=alpha == 1.0 and not through)


def _below_coat(shaders, found, name):
    """The whole with its second coat, by LuxRender's coating of the same index."""
    weight = shaders.textures.constant_number(found.input(*COAT), 'weights of coats')
    if weight == 0.0:
        return _mixed(shaders, found, name)
    base = _mixed(shaders, found, f'{name}: base')
    if _is_of_blender_4(found):
        index = shaders.textures.constant_number(found.input('Coat IOR'), 'index of refraction')
        tint = shaders.textures.color(found.input('Coat Tint'))
        if tint != WHITE:
            shaders.left_out.add('Coat Tint of node Principled BSDF is left out', name)
        reflects = weight * ((index - 1) / (index + 1)) ** 2
    else:
        reflects = CLEARCOAT * weight
    rough = shaders.textures.constant_number(found.input(*COAT_ROUGHNESS), 'roughness of coats')
    return shaders.named(name, 'glossycoating', [
        parameter('string', 'basematerial', base), color('Ks', (reflects,) * 3),
        *shaders.roughness(rough * rough)])


def _mixed(shaders, found, name):
    """Metal over glass over the coated diffuse base, by their shares."""
    metallic = shaders.textures.number(found.input('Metallic'))
    transmission = shaders.textures.number(found.input(*TRANSMISSION))
    base = shaders.textures.color(found.input('Base Color'))
    width, bump = shaders.width(found), shaders.bump(found)

    def metal(part):
        edge = found.input('Specular Tint')
        if _is_of_blender_4(found) and shaders.textures.color(edge) != WHITE:
            shaders.left_out.add('tinted edges of metals are left out', name)
        return shaders.metal_of(found, part, base, shaders.stretched(
            found, width, 'Anisotropic Rotation'), bump)

    def glass(part):
        index = shaders.textures.constant_number(found.input('IOR'), 'index of refraction')
        tint = base
        if _is_of_blender_4(found):  # light takes the colour as it enters and leaves, half each
            tint = shaders.textures.root(base)
        return shaders.dielectric(part, WHITE, tint, index, width, bump)

    def coated(part):
        if shaders.textures.number(found.input('Anisotropic')) != 0.0:
            shaders.left_out.add('anisotropy of what is no metal is left out', name)
        return _coated(shaders, found, part, _with_subsurface(shaders, found, base, name), width,
                       bump)

    def dielectric(part):
        return _by_share(shaders, part, ('base', coated), ('glass', glass), transmission)

    return _by_share(shaders, name, ('dielectric', dielectric), ('metal', metal), metallic)


def _by_share(shaders, name, first, second, share):
    """Of two pairs of a part's name and what makes it; the whole alone has the name itself."""
    for edge, (_, make) in ((0.0, first), (1.0, second)):
        if share == edge:
            return make(name)
    parts = [make(f'{name}: {part}') for part, make in (first, second)]
    return mix(shaders, name, *parts, share)


def mix(shaders, name, first, second, share):
    """Of materials by name; share is that of the second, a number or a texture's name."""
    from_names = [f'"string namedmaterial1" ["{first}"]', f'"string namedmaterial2" ["{second}"]']
    return shaders.named(name, 'mix', from_names + [factor('amount', share)])


def _is_of_blender_4(found):
    return found.input(SPECULAR[0]) is not None


def _with_subsurface(shaders, found, base, name):
    """Scattering below the surface is taken for diffuse of the colour that it has as a whole."""
    weight = shaders.textures.number(found.input(*SUBSURFACE))
    if weight == 0.0:
        return base
    shaders.left_out.add('scattering below the surface is replaced by diffuse', name)
    other = found.input('Subsurface Color')  # until Blender 4
    if other is None:
        return base
    return shaders.textures.mixed(base, shaders.textures.color(other), weight)


def _reflectance(shaders, found, name):
    """Of the surface of the base at normal incidence, three numbers."""
    level = shaders.textures.constant_number(found.input(*SPECULAR), 'specular')
    tint = shaders.textures.color(found.input('Specular Tint'))
    if not _is_of_blender_4(found):
        if tint != BLACK:  # a number here
            shaders.left_out.add('Specular Tint of node Principled BSDF is left out', name)
        return (REFLECTANCE_OF_SPECULAR * level,) * 3
    if isinstance(tint, str):
        shaders.left_out.add('textures of Specular Tint are left out', name)
        tint = WHITE
    index = shaders.textures.constant_number(found.input('IOR'), 'index of refraction')
    whole = 2 * level * ((index - 1) / (index + 1)) ** 2
    return tuple(min(whole * c, 1.0) for c in tint)


def _coated(shaders, found, name, base, width, bump):
    coat = _reflectance(shaders, found, name)
    if coat == BLACK:
        return shaders.named(name, 'matte', [color('Kd', base), *bump])
    if BLENDER_3:  # in which what the surface reflects is not taken from the base
        base = shaders.textures.product(base, 1 / (1 - max(coat)))
        if isinstance(base, tuple):
            base = tuple(min(c, 1.0) for c in base)
    return shaders.named(name, 'glossy', [
        color('Kd', base), color('Ks', coat), CONSERVING, DIELECTRIC, *shaders.roughness(width),
        *bump])


def _emission(shaders, found, alpha):
    """What is partly there shines as much less."""
    textures = shaders.textures
    with textures.lighting():
        strength = textures.constant_number(found.input('Emission Strength'),
                                            'strengths of emission')
        light = textures.product(textures.color(found.input(*EMISSION)), strength)
    if BLACK in (light, (alpha,) * 3):
        return None
    return textures.product(light, alpha)
