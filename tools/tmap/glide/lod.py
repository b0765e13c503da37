"""Level of detail: the logarithm to base 2 of the texels that a pixel covers, 8.8, and the level to
read."""

import numpy as np

from tmap.glide.logarithm import log2
from tmap.glide.state import COORDINATE_BITS, LAST_LEVEL, Modes

ONE_8_8 = 256  # of 8.8
LEAST = -(1 << 15)
MOST = (1 << 15) - 1
W_BITS = 30  # fraction bits of W
QUARTER = 64  # a step of the bias and the limits
DITHER_STEP = 16
#: The addition of dithering to the level, in 1/16, by line and column: ordered, each value once.
DITHER = np.array([[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]])


def base(dsdx: np.ndarray, dtdx: np.ndarray, dsdy: np.ndarray, dtdy: np.ndarray) -> np.ndarray:
    """Returns the level of polygons from their gradients, 14.18 in 32 bits: the logarithm of the
    longer of the two steps. It is half of its square's logarithm, which is first rounded, then
    halved towards 0, as in reference data. If all gradients are 0, it is the least level."""
    squares = [np.abs(np.asarray(g, np.int64)).astype(np.uint64) ** 2
               for g in (dsdx, dtdx, dsdy, dtdy)]
    most = np.maximum(squares[0] + squares[1], squares[2] + squares[3])
    double = log2(np.maximum(most, np.uint64(1))) - 2 * ONE_8_8 * COORDINATE_BITS
    return np.where(most == 0, LEAST, np.sign(double) * (np.abs(double) >> 1))


def level_of_detail(modes: Modes, start: np.ndarray, w: np.ndarray, x: np.ndarray,
                    y: np.ndarray) -> np.ndarray:
    """Returns the level of pixels (x, y), 8.8, from their polygons' level ``start``. The magnitude
    of W is used: reference data with W below 0 agree. If W is 0, which they do not contain, the
    pixel is infinitely far away."""
    lod = np.asarray(start, np.int64)
    if modes.perspective:
        size = np.abs(w)
        near = log2(np.maximum(size, 1).astype(np.uint64)) - ONE_8_8 * W_BITS
        lod = np.where(size == 0, MOST, lod - near)
    lod = lod + modes.lod_bias * QUARTER
    if modes.dither:
        lod = lod + DITHER[y & 3, x & 3] * DITHER_STEP
    return within_limits(modes, lod)


def within_limits(modes: Modes, lod: np.ndarray) -> np.ndarray:
    """Clamps a level to the map's limits; if they cross, the upper one is used."""
    most = min(modes.lod_max * QUARTER, LAST_LEVEL * ONE_8_8)
    return np.minimum(np.maximum(lod, modes.lod_min * QUARTER), most)


def chosen(modes: Modes, lod: np.ndarray) -> np.ndarray:
    """Returns the level whose texels are read, 0..8. If a map of odd or even levels lacks a level,
    it is the next coarser one. With trilinear filtering a whole map is used like such a map."""
    level = lod >> 8
    if modes.split or modes.trilinear:
        level = level + (level & 1 != modes.odd)
    return np.minimum(level, LAST_LEVEL)
