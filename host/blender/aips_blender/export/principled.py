"""Turns node Principled BSDF into LuxRender's glossy, metal2, glass and mixes of these."""
from .lxs_text import factor
from .shaders import BLACK, WHITE, Shader, color

REFLECTANCE_OF_SPECULAR = 0.08  # at normal incidence, where Specular is 1 (Cycles' manual)
APPROXIMATED = (('Subsurface', 0.0), ('Specular Tint', 0.0), ('Anisotropic', 0.0), ('Sheen', 0.0),
                ('Clearcoat', 0.0))


def principled(shaders, found, name):
    textures = shaders.textures
    for what, neutral in APPROXIMATED:
        if textures.number(found.input(what)) != neutral:
            shaders.left_out.add(f"{what} of node Principled BSDF is left out", name)
    alpha = textures.number(found.input('Alpha'))
    if alpha == 1.0:
        material = _mixed(shaders, found, name)
    else:
        opaque = _mixed(shaders, found, f'{name}: opaque')
        material = mix(shaders, name, shaders.null(f'{name}: null'), opaque, alpha)
    through = textures.number(found.input('Transmission')) != 0.0 and \
        textures.number(found.input('Metallic')) != 1.0
    return Shader(material, _emission(shaders, found, alpha), opaque=alpha == 1.0 and not through)


def _mixed(shaders, found, name):
    """Metal over glass over the coated diffuse base, by their shares."""
    metallic = shaders.textures.number(found.input('Metallic'))
    transmission = shaders.textures.number(found.input('Transmission'))
    base = shaders.textures.color(found.input('Base Color'))
    width, bump = shaders.width(found), shaders.bump(found)

    def metal(part):
        return shaders.metal(part, base, width, bump)

    def glass(part):
        index = shaders.textures.constant_number(found.input('IOR'), 'index of refraction')
        return shaders.dielectric(part, WHITE, base, index, width, bump)

    def coated(part):
        return _coated(shaders, found, part, base, width, bump)

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


def _coated(shaders, found, name, base, width, bump):
    specular = shaders.textures.constant_number(found.input('Specular'), 'specular')
    if specular == 0.0:
        return shaders.named(name, 'matte', [color('Kd', base), *bump])
    coat = (REFLECTANCE_OF_SPECULAR * specular,) * 3
    return shaders.named(name, 'glossy', [color('Kd', base), color('Ks', coat),
                                          *shaders.roughness(width), *bump])


def _emission(shaders, found, alpha):
    """What is partly there shines as much less."""
    textures = shaders.textures
    strength = textures.constant_number(found.input('Emission Strength'), 'strengths of emission')
    light = textures.product(textures.color(found.input('Emission')), strength)
    if BLACK in (light, (alpha,) * 3):
        return None
    return textures.product(light, alpha)
