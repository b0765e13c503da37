"""Coordinates in one tile: from s10.5 to texel indices, fractions and neighbours."""

from typing import NamedTuple

import numpy as np

from tmap.base.fixed import signed
from tmap.n64.state import Axis

MASK_MAX = 10  # bits; larger masks act like this one


class Position(NamedTuple):
    """The places of pixels on an axis, int64 arrays of one shape: texel ``index`` after mask and
    mirror, ``fraction`` in 1/32 texel, ``step`` to the neighbour's index."""

    index: np.ndarray
    fraction: np.ndarray
    step: np.ndarray


def shifted(axis: Axis, c: np.ndarray) -> np.ndarray:
    """Applies the tile's shift: right by 0..10, or left by 5..1 bits; s10.5."""
    c = signed(np.asarray(c, np.int64), 16)
    return c >> axis.shift if axis.shift <= 10 else signed(c << 16 - axis.shift, 16)


def masked(axis: Axis, index: np.ndarray, is_t: bool) -> tuple[np.ndarray, np.ndarray]:
    """Returns indices after mask and mirror, and the step to each one's neighbour.

    The step over a wrapped seam leads back to 0; for rows it uses only 8 bits.
    """
    if not axis.mask:
        return index, np.ones_like(index)
    m = min(axis.mask, MASK_MAX)
    full = (1 << m) - 1
    if axis.mirror:
        turned = index >> m & 1 != 0
        index = np.where(turned, ~index, index) & full
        step = np.where(index == np.where(turned, 0, full), 0, np.where(turned, -1, 1))
    else:
        index = index & full
        step = np.where(index == full, -(index & 255 if is_t else index), 1)
    return index, step


def position(axis: Axis, c: np.ndarray, is_t: bool) -> Position:
    """Runs the axis's pipeline. ``c``: s10.5, any shape."""
    c = shifted(axis, c)
    over = c >> 3 >= axis.high
    c = c - 8 * axis.low
    index, fraction = c >> 5, c & 31
    if axis.clamp or not axis.mask:
        last = (axis.high >> 2) - (axis.low >> 2) & 0x3FF
        index = np.where(over, last, np.where(c < 0, 0, index))
        fraction = np.where(over | (c < 0), 0, fraction)
    index, step = masked(axis, index, is_t)
    return Position(index, fraction, step)
