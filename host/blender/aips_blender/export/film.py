"""Writes the statements before WorldBegin: film, filter, sampler and integrator."""
import dataclasses

from .lxs_text import factor, parameter

# The film's primaries and white are those of the scene's colours, so that a colour comes out as it
# went in; Rec. 709, and the white of a light of L 1 1 1 (docs/understand/colours.md).
COLOR_SPACE = (('red', (0.64, 0.33)), ('green', (0.30, 0.60)), ('blue', (0.15, 0.06)),
               ('white', (0.3133, 0.3292)))
RENDERERS = {'path': 'sampler'}  # by integrator, where its name is another
CYCLES_FILTER = 1.5  # pixels: radius of Cycles' Blackman-Harris filter, which it calls a width


@dataclasses.dataclass
class Film:
    """What is rendered, for how long, and how."""
    width: int
    height: int
    crop: tuple = (0.0, 1.0, 0.0, 1.0)  # x0 x1 y0 y1 as shares of the image, from the upper left
    layers: tuple = ()
    passes: int = 0                      # 0: no bound
    seconds: int = 0                     # likewise
    error: float = 0.0                   # likewise
    integrator: str = 'aips'
    options: tuple = ()                  # parameters of the integrator, as text
    filter_radius: float = CYCLES_FILTER  # pixels
    tone_map: str = 'reinhard'
    transparent: bool = False            # an alpha channel, and no sight of what is far away


def write(text, film, name):
    parameters = [parameter('integer', 'xresolution', film.width),
                  parameter('integer', 'yresolution', film.height),
                  parameter('float', 'cropwindow', film.crop),
                  parameter('string', 'filename', name),
                  parameter('string', 'tonemapkernel', film.tone_map)]
    parameters += [parameter('float', f'colorspace_{what}', xy) for what, xy in COLOR_SPACE]
    if film.layers:
        parameters.append(parameter('string', 'layers', film.layers))
    for key, value in (('haltspp', film.passes), ('halttime', film.seconds)):
        if value:
            parameters.append(parameter('integer', key, value))
    if film.transparent:
        parameters.append(parameter('bool', 'premultiplyalpha', True))
    if film.error:
        parameters.append(factor('haltthreshold', film.error))
    text.statement('Film', 'fleximage', parameters=parameters)
    radius = film.filter_radius
    text.statement('PixelFilter', 'blackmanharris',
                   parameters=[factor('xwidth', radius), factor('ywidth', radius)])
    text.statement('Sampler', 'lowdiscrepancy')
    text.statement('Renderer', RENDERERS.get(film.integrator, film.integrator))
    text.statement('SurfaceIntegrator', film.integrator, parameters=film.options)
