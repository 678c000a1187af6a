"""Renders scenes of LuxRender and pbrt as lxsrender does, and gives images as numpy arrays.

    import lxs
    scene = lxs.load("scene.lxs", integrator="aips", set={"aips.guide": "none"}, seed=1)
    result = scene.render(passes=16, on_pass=lambda p: print(p.passes, p.seconds, p.error))
    print(result.image.mean(), result.statistics["counts"]["rays"])
    result.save("out.exr")

The same scene, settings and seed give the bits of lxsrender, for any number of threads. Messages of
a render go to the logger "lxs" of the module logging: warnings are shown unless told otherwise.
"""
from __future__ import annotations

import json
import os
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _lxs

__all__ = ['InputError', 'PluginError', 'Progress', 'Result', 'Scene', 'describe', 'integrators',
           'load']
__version__: str = _lxs.version()

Path = Union[str, bytes, 'os.PathLike[str]', 'os.PathLike[bytes]']
Floats = NDArray[np.float32]
#: What a parameter can be set to: as in a scene file, lists as any sequence.
Value = Union[bool, int, float, str, Sequence[Union[bool, int, float, str]]]


class InputError(RuntimeError):
    """A scene, or a setting of load(), that can't be rendered.

    As text it is all errors as lxsrender prints them, each with its line of the file. The
    attributes are of the first.
    """

    #: Without its place.
    message: str
    #: The scene's file or one that it includes; None where the error is in none.
    file: Optional[str]
    #: From 1; None where the error is in no file.
    line: Optional[int]
    #: From 1, in bytes; likewise.
    column: Optional[int]

    def __init__(self, text: str, message: str = '', file: Optional[str] = None,
                 line: Optional[int] = None, column: Optional[int] = None):
        super().__init__(text)
        self.message, self.file, self.line, self.column = message or text, file, line, column


class PluginError(RuntimeError):
    """A plugin module that can't be loaded, or fails."""


class Progress:
    """How far a render is, for `on_pass`. Figures count from the first pass of the scene."""

    #: Done so far.
    passes: int
    #: Wall time of the passes.
    seconds: float
    photon_paths: int
    #: Shadow rays included.
    rays: int
    samples_per_pixel: float
    #: Estimated error of the image: the square root of relMSE. None before the third pass, or if
    #: it is not estimated.
    error: Optional[float]

    def __init__(self, render: _lxs.Render, passes: int, seconds: float, photon_paths: int,
                 rays: int, samples_per_pixel: float, error: Optional[float]):
        self._render = render
        self.passes, self.seconds = passes, seconds
        self.photon_paths, self.rays = photon_paths, rays
        self.samples_per_pixel, self.error = samples_per_pixel, error

    @property
    def image(self) -> Floats:
        """As Result.image: what the scene has when it is asked for."""
        return self._render.image()


class Result:
    """What a scene has after some passes: it stays as it is when the scene is rendered further.

    Arrays show the memory of the result, which lives as long as one of them does. They are for
    reading; a copy can be changed.
    """

    #: The statistics file of `lxsrender --stats`, as a dict.
    statistics: Dict[str, Any]

    def __init__(self, image: _lxs.Image):
        self._image = image
        self.statistics = json.loads(image.statistics)

    @property
    def image(self) -> Floats:
        """Linear radiance: float32, [row][column][red, green, blue], the top row first."""
        return self._image.image

    @property
    def layers(self) -> Dict[str, Floats]:
        """The layers that the EXR has beside the image, by name: `error`, the scene's light
        groups, what load() was asked for. float32, [row][column][channel], or [row][column] for a
        layer of one channel. Several single channels of one layer have names of their own, as
        "CryptoObject00.R"; alpha is "A"."""
        return self._image.layers

    @property
    def display(self) -> NDArray[np.uint8]:
        """The image as lxsrender's PNG shows it, without denoising: uint8 sRGB, [row][column][red,
        green, blue]."""
        return self._image.display

    @property
    def passes(self) -> int:
        """That the image is the mean of."""
        return self._image.passes

    @property
    def seconds(self) -> float:
        """Wall time of the passes."""
        return self._image.seconds

    @property
    def error(self) -> Optional[float]:
        """Estimated error of the image, as Progress.error."""
        return self._image.error

    @property
    def stopped(self) -> bool:
        """Whether `on_pass` or Ctrl-C ended the render, before what render() was asked for."""
        return self._image.stopped

    def save(self, file: Path) -> None:
        """Writes the EXR that lxsrender would write, byte for byte. Raises OSError."""
        self._image.save(os.fsencode(file))


class Scene:
    """A scene that is ready to be rendered, made by load(). Any thread may use it; one waits for
    another, until its pass ends."""

    def __init__(self, render: _lxs.Render, estimates: bool):
        self._render, self._estimates = render, estimates

    def render(self, passes: Optional[int] = None, *, seconds: Optional[float] = None,
               target_error: Optional[float] = None,
               on_pass: Optional[Callable[[Progress], Any]] = None,
               interval: float = 0) -> Result:
        """Renders until the image has `passes` passes, has taken `seconds`, or has an estimated
        error of `target_error`, whichever is first; without all three as the scene says, else 16
        passes. All count from the first pass: called again, it goes on.

        `on_pass` is called after passes, at most once in `interval` seconds, and after the last. If
        it returns False, or raises, or Ctrl-C is pressed, the render ends after the pass: the scene
        keeps the passes, result() gives them, and render() goes on from there. Raises RuntimeError
        while the scene is being rendered, as from `on_pass`.
        """
        _check(passes is None or passes >= 1, f'passes: expected 1 or more, found {passes}')
        _check(seconds is None or seconds > 0, f'seconds: expected more than 0, found {seconds}')
        _check(target_error is None or target_error > 0,
               f'target_error: expected more than 0, found {target_error}')
        _check(target_error is None or self._estimates,
               'target_error: the scene was loaded without error_estimate')

        def tell(*figures: Any) -> Any:
            return on_pass(Progress(self._render, *figures)) if on_pass else None

        if not self._render.run(passes, seconds, target_error, tell if on_pass else None,
                                interval):
            raise RuntimeError('the scene is being rendered, or has failed before')
        return self.result()

    def result(self) -> Result:
        """The image after the passes so far. Raises RuntimeError before the first."""
        if self._render.passes() == 0:
            raise RuntimeError('the scene has no pass yet')
        return Result(self._render.result())


def load(file: Path, *, integrator: Optional[str] = None,
         sampler: Optional[str] = None, set: Optional[Mapping[str, Value]] = None,
         seed: Optional[int] = None, threads: int = 0, width: Optional[int] = None,
         height: Optional[int] = None, layers: Iterable[str] = (), denoise: bool = False,
         error_estimate: bool = True, strict: bool = False,
         plugin_paths: Iterable[Path] = ()) -> Scene:
    """Reads a scene: of pbrt if the name ends in .pbrt, else of LuxRender.

    The arguments are those options of lxsrender (docs/reference/command-line.md); without them the
    scene decides.

    integrator, sampler: names; integrators() lists those there are.
    set: parameters, as {"aips.photonperpass": 20000}; describe("aips") lists them.
    seed: of all random numbers.
    threads: 0 for all processors. The bits are the same for any number.
    width, height: pixels; given one width, the height follows.
    layers: names beside the image, as "albedo", or "all" (docs/reference/layers.md).
    denoise: a layer "denoised"; the image stays as it is.
    error_estimate: without it there is no error, and no layer of that name.
    strict: what LuxRender would only warn of is an error.
    plugin_paths: folders with plugin modules, before the installed ones.

    Raises InputError, PluginError; ValueError for an argument out of range.
    """
    _check(0 <= threads <= 1024, f'threads: expected 0 to 1024, found {threads}')
    for name, pixels in (('width', width), ('height', height)):
        _check(pixels is None or 1 <= pixels <= 65536,
               f'{name}: expected 1 to 65536, found {pixels}')
    _check(seed is None or 0 <= seed < 2**64, f'seed: expected 0 to 2^64 - 1, found {seed}')
    names = [layers] if isinstance(layers, str) else list(layers)
    return Scene(_lxs.Render(
        scene=os.fsencode(file), integrator=integrator, sampler=sampler,
        overrides=[_override(name, value) for name, value in (set or {}).items()], seed=seed,
        threads=threads, width=width, height=height, layers=','.join(names) if names else None,
        denoise=denoise, error_estimate=error_estimate, strict=strict,
        plugin_paths=[os.fsencode(path) for path in plugin_paths]), error_estimate)


def describe(name: str, plugin_paths: Iterable[Path] = ()) -> str:
    """The parameters of an integrator, or of any material, texture, shape, light, film and so on,
    as `lxsrender --describe`. Raises ValueError for a name that is unknown."""
    text = _lxs.describe(name, [os.fsencode(path) for path in plugin_paths])
    _check(text != '', f'unknown plugin "{name}"')
    return text


def integrators(plugin_paths: Iterable[Path] = ()) -> List[str]:
    """Names of the integrators that there are."""
    return _lxs.integrators([os.fsencode(path) for path in plugin_paths])


def _check(good: bool, message: str) -> None:
    if not good:
        raise ValueError(message)


def _override(name: str, value: Value) -> str:
    """As `--set` has it."""
    plugin, dot, parameter = name.partition('.')
    _check(bool(plugin and dot and parameter),
           f'set: expected PLUGIN.PARAMETER, as "aips.guide", found "{name}"')
    return f'{name}={_text(value)}'


def _text(value: Value) -> str:
    if isinstance(value, (bool, np.bool_)):
        return 'true' if value else 'false'
    if isinstance(value, (str, int, float, np.number)):
        return str(value)
    return ' '.join(_text(one) for one in value)
