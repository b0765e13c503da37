"""From iterated S, T and W to the texels of a level."""

from typing import NamedTuple

import numpy as np

from tmap.base.fixed import signed
from tmap.glide.state import COORDINATE_BITS, LEVELS, ONE_W, Modes
from tmap.glide.texels import level_size

LEAST, MOST = -(1 << 31), (1 << 31) - 1
TOO_LARGE, TOO_SMALL = 2.0**-17 + 2.0**-20, 2.0**-20  # parts of a reciprocal


def reciprocal(normal: np.ndarray) -> np.ndarray:
    """Returns about 2^53 / normal for numbers from 2^31 to 2^32 - 1, as hardware does: on the line
    between two of 513 entries floor(2^31 / (512 + i)), at the 8 bits below those of i. It is too
    large by at most the part TOO_LARGE (unused bits, 2^-17; the line is above the curve), too small
    by at most TOO_SMALL (entries and the line's value are rounded down)."""
    i, part = normal >> 22 & 511, normal >> 14 & 255
    first, second = (1 << 31) // (512 + i), (1 << 31) // (513 + i)
    return (first << 8) - (first - second) * part >> 8


def quotient(c: np.ndarray, w: np.ndarray) -> np.ndarray:
    """Returns floor(c * 2^30 / w), exact, clamped to 32 bits; 0 where w is 0. ``c``: 14.18, ``w``:
    2.30, int64 arrays of 32-bit values, so that products fit 63 bits."""
    divided = np.floor_divide(c * ONE_W, np.where(w == 0, 1, w))
    return np.where(w == 0, 0, np.clip(divided, LEAST, MOST))


def table_quotient(c: np.ndarray, w: np.ndarray) -> np.ndarray:
    """Returns the same by the reciprocal of |w|. All reference data agree with it (the table's size
    is the specification's, the 8 bits were found by experiment)."""
    size = np.maximum(np.abs(w), 1)
    zeros = 32 - np.frexp(size.astype(np.float64))[1].astype(np.int64)
    product = np.abs(c) * reciprocal(size << zeros)  # below 2^54
    product = np.where((c < 0) != (w < 0), -product, product)
    divided = np.where(zeros > 23, np.clip(product, LEAST, MOST) << np.maximum(zeros - 23, 0),
                       product >> np.maximum(23 - zeros, 0))
    return np.where(w == 0, 0, np.clip(divided, LEAST, MOST))


def within_pieces(divided: np.ndarray, size: int, before: np.ndarray,
                  behind: np.ndarray) -> np.ndarray:
    """Keeps exact quotients of pixels, line by line, only at the ends of pieces of ``size`` pixels,
    and interpolates linearly between them. ``before``, ``behind``: pixels of its line on each side
    of each.

    A piece's last exact quotient is the next piece's first, or that of the line's last pixel. With
    w and W, of one sign, at both ends of a piece and r = sqrt(W / w) a value is off the true one by
    up to |difference of the ends| * |r - 1| / (r + 1), and lower by up to ``size``: a quotient is
    rounded down, and so is the step of up to ``size`` - 1 pixels."""
    here, place = np.arange(divided.size).reshape(divided.shape), before % size
    first = here - place
    pixels = np.minimum(place + behind, size)
    start, end = divided.ravel()[first], divided.ravel()[first + pixels]
    return signed(start + place * (signed(end - start) // np.maximum(pixels, 1)))


def coordinates(modes: Modes, s: np.ndarray, t: np.ndarray, w: np.ndarray,
                before: np.ndarray | int = 0,
                behind: np.ndarray | int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Returns s and t of pixels, 14.18, from the iterated values. ``before``, ``behind``: as in
    ``within_pieces``; 0: each pixel is a separate line."""
    if modes.perspective:
        divided = table_quotient if modes.table_quotients else quotient
        s, t = divided(s, w), divided(t, w)
    if modes.clamp_negative_w:
        s, t = (np.where(w < 0, 0, c) for c in (s, t))
    if modes.perspective and modes.subdivision and not modes.table_quotients:
        s, t = (within_pieces(c, modes.subdivision, before, behind) for c in (s, t))
    return s, t


class Taps(NamedTuple):
    """Texels on an axis: one, the next, the fraction between them (in the unit's filter bits)."""

    first: np.ndarray
    second: np.ndarray
    fraction: np.ndarray


def within(index: np.ndarray, side: np.ndarray, clamp: int) -> np.ndarray:
    """Clamps or wraps a texel's index to its side."""
    return np.clip(index, 0, side - 1) if clamp else index & side - 1


def sides(modes: Modes, axis: int) -> np.ndarray:
    """Returns the texels along s (0) or t (1) of all levels, [9]."""
    return np.array([level_size(modes, level)[axis] for level in range(LEVELS)])


def nearest(modes: Modes, c: np.ndarray, level: np.ndarray, axis: int) -> np.ndarray:
    """Returns the texel that contains a coordinate."""
    clamp = modes.clamp_t if axis else modes.clamp_s
    return within(c >> COORDINATE_BITS + level, sides(modes, axis)[level], clamp)


def taps(modes: Modes, c: np.ndarray, level: np.ndarray, axis: int) -> Taps:
    """Returns the two texels whose centres are around a coordinate."""
    clamp, bits = modes.clamp_t if axis else modes.clamp_s, modes.fraction_bits
    u = (c >> COORDINATE_BITS - bits + level) - (1 << bits - 1)
    side = sides(modes, axis)[level]
    index = u >> bits
    return Taps(within(index, side, clamp), within(index + 1, side, clamp), u & (1 << bits) - 1)
