"""Point samples of texture units' modes: they may be wrong only where rounding of the planes
explains it."""

import numpy as np

from tmap.bench.modes.measure import HEIGHT, WIDTH
from tmap.ideal import ideal
from tmap.model import model


def raised(corners, x: int, y: int, key: int) -> float:
    """Returns by how much s (``key`` 2) or t (3) of a triangle may exceed its exact value at a
    pixel, in texels."""
    made = model.set_up([c[:4] for c in corners], WIDTH, HEIGHT, True, model.Settings("exact"))
    three = [corners[k] for k in ideal.corners(corners)]
    plane = ideal.Plane([c[:2] for c in three], [c[key] for c in three])
    return plane.bound(x, y, made.texturing, made.texturing.cuts[key - 2])


def check(mode, errors, kind: str, surface) -> None:
    """Asserts that every pixel shows the intended texel. A pixel may show the next one if s or t is
    closer to it than its plane may be raised there. ``errors``: the engine's module; ``surface``:
    the exact s and t."""
    on = errors.pixels_of(mode, kind)
    drawn, meant = errors.colours_of(mode, kind)
    s_and_t = surface(on).at(on.x, on.y)
    for k in np.flatnonzero((drawn[:, :3] != meant[:, :3]).any(-1)):
        x, y = int(on.x[k]), int(on.y[k])
        below = [1 - c.fraction[k] for c in s_and_t]
        may = [raised(mode.vertices[:3], x, y, key) for key in (2, 3)]
        assert below[0] <= may[0] or below[1] <= may[1], (
            f"mode {mode.name}, {kind}, pixel ({x}, {y}): expected {meant[k]}, found {drawn[k]}; s and t "
            f"are {below} texels below the next ones and raised by {may}")
