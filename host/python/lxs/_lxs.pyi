# What the compiled part of the package gives to __init__.py, whose classes say what it means.
from typing import Any, Callable, Dict, List, Optional

import numpy as np
from numpy.typing import NDArray

def version() -> str: ...
def describe(name: str, plugin_paths: List[bytes]) -> str: ...
def integrators(plugin_paths: List[bytes]) -> List[str]: ...

class Image:
    passes: int
    seconds: float
    error: Optional[float]
    stopped: bool
    statistics: str
    image: NDArray[np.float32]
    display: NDArray[np.uint8]
    layers: Dict[str, NDArray[np.float32]]
    def save(self, path: bytes) -> None: ...

class Render:
    def __init__(self, *, scene: bytes, integrator: Optional[str], sampler: Optional[str],
                 overrides: List[str], seed: Optional[int], threads: int, width: Optional[int],
                 height: Optional[int], layers: Optional[str], denoise: bool,
                 error_estimate: bool, strict: bool, plugin_paths: List[bytes]) -> None: ...
    def run(self, passes: Optional[int], seconds: Optional[float], error: Optional[float],
            on_pass: Optional[Callable[..., Any]], interval: float) -> bool: ...
    def image(self) -> NDArray[np.float32]: ...
    def result(self) -> Image: ...
    def passes(self) -> int: ...
