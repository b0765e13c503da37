"""From iterated S, T and W to the texels of a level."""

from typing import NamedTuple

import numpy as np

from .state import COORDINATE_BITS, LEVELS, ONE_W, Modes
from .texels import level_size

LEAST, MOST = -(1 << 31), (1 << 31) - 1


def quotient(c: np.ndarray, w: np.ndarray) -> np.ndarray:
    """floor(c * 2^30 / w), exact, within 32 bits; 0 where w is 0. ``c``: 14.18, ``w``: 2.30,
    int64 arrays of 32-bit values, so that no product leaves 63 bits."""
    divided = np.floor_divide(c * ONE_W, np.where(w == 0, 1, w))
    return np.where(w == 0, 0, np.clip(divided, LEAST, MOST))


def coordinates(modes: Modes, s: np.ndarray, t: np.ndarray,
                w: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """s and t of pixels, 14.18, of what is iterated."""
    if modes.perspective:
        s, t = quotient(s, w), quotient(t, w)
    if modes.clamp_negative_w:
        s, t = (np.where(w < 0, 0, c) for c in (s, t))
    return s, t


class Taps(NamedTuple):
    """Of an axis: texel, the next one, the fraction between them (of the unit's filter bits)."""

    first: np.ndarray
    second: np.ndarray
    fraction: np.ndarray


def within(index: np.ndarray, side: np.ndarray, clamp: int) -> np.ndarray:
    """A texel's index within its side."""
    return np.clip(index, 0, side - 1) if clamp else index & side - 1


def sides(modes: Modes, axis: int) -> np.ndarray:
    """Texels along s (0) or t (1) of all levels, [9]."""
    return np.array([level_size(modes, level)[axis] for level in range(LEVELS)])


def nearest(modes: Modes, c: np.ndarray, level: np.ndarray, axis: int) -> np.ndarray:
    """The texel in which a coordinate lies."""
    clamp = modes.clamp_t if axis else modes.clamp_s
    return within(c >> COORDINATE_BITS + level, sides(modes, axis)[level], clamp)


def taps(modes: Modes, c: np.ndarray, level: np.ndarray, axis: int) -> Taps:
    """The two texels whose centres a coordinate lies between."""
    clamp, bits = modes.clamp_t if axis else modes.clamp_s, modes.fraction_bits
    u = (c >> COORDINATE_BITS - bits + level) - (1 << bits - 1)
    side = sides(modes, axis)[level]
    index = u >> bits
    return Taps(within(index, side, clamp), within(index + 1, side, clamp), u & (1 << bits) - 1)
