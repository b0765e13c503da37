"""Level of detail: the two tiles for a pixel, and the fraction between them."""

from typing import NamedTuple

import numpy as np

from tmap.n64.divide import divide
from tmap.n64.state import State

FAR = 0x4000  # 1/32 texel per pixel: no level is coarse enough


class Gradients(NamedTuple):
    """Steps of the iterators (s15.16) to the next column and to the next line."""

    dsdx: int = 0
    dtdx: int = 0
    dwdx: int = 0
    dsdy: int = 0
    dtdy: int = 0
    dwdy: int = 0


class Level(NamedTuple):
    """The level of pixels, int64 arrays of one shape. ``s``, ``t``: s10.5; ``tile0``, ``tile1``:
    0..7; ``fraction``: 9 bits (0..511)."""

    s: np.ndarray
    t: np.ndarray
    tile0: np.ndarray
    tile1: np.ndarray
    fraction: np.ndarray


def upper(iterator: np.ndarray) -> np.ndarray:
    """Returns the upper 16 bits of s15.16, unsigned."""
    return iterator >> 16 & 0xFFFF


def distance(d: np.ndarray) -> np.ndarray:
    """Returns the magnitude, by one's complement."""
    return np.where(d < 0, ~d, d)


def level(state: State, s: np.ndarray, t: np.ndarray, w: np.ndarray,
          gradients: Gradients) -> Level:
    """Returns coordinates and level of pixels. ``s``, ``t``, ``w``: iterators, s15.16 modulo
    2^32."""
    modes, g = state.modes, gradients
    here = divide(upper(s), upper(t), upper(w), modes.perspective)
    lod, over = np.zeros(here.s.shape, np.int64), here.overflow
    for steps, cut in ((g[:3], 0x1F), (g[3:], 0x7FFF)):
        there = divide(*(upper(c + (step & ~cut)) for c, step in zip((s, t, w), steps)),
                       modes.perspective)
        over = over | there.overflow
        for a, b in ((here.raw_s, there.raw_s), (here.raw_t, there.raw_t)):
            lod = np.maximum(lod, distance(b - a))
    tile0, tile1, fraction = choose(state, lod, over | (lod >= FAR))
    return Level(here.s, here.t, tile0, tile1, fraction)


def choose(state: State, lod: np.ndarray, far: np.ndarray):
    """Returns (tile0, tile1, fraction) for a distance between pixels in 1/32 texel; ``far``:
    bool."""
    modes, top = state.modes, state.max_level
    special = modes.sharpen or modes.detail
    near = ~far & (lod < 32)
    whole = np.where(far | near, 1, lod >> 5 & 255)
    number = np.where(whole > 0, np.frexp(np.maximum(whole, 1))[1] - 1, 0).astype(np.int64)
    distant = np.where(near, top == 0, far | (top == 0) | (lod & 0x6000 != 0) | (number >= top))
    fraction = lod * 8 >> number & 255
    if special:
        close = 8 * np.maximum(lod, state.min_level) & 255 | modes.sharpen << 8
        fraction = np.where(near, close, fraction)
    else:
        fraction = np.where(distant, 255, np.where(near, 0, fraction))
    fraction = np.where(far, 255, fraction)
    first = np.full(lod.shape, state.primitive_tile, np.int64)
    if not modes.lod:
        return first & 7, first + 1 & 7, fraction
    first += np.where(distant, top, number)
    if modes.detail:
        tile0, tile1 = first + ~near, first + np.where(distant | near, 1, 2)
    else:
        stays = distant | (near & (not modes.sharpen))
        tile0, tile1 = first, first + ~stays
    return tile0 & 7, tile1 & 7, fraction
