"""Complete pixels of one unit, or of units in a row."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmap.glide.combine import combined
from tmap.glide.coordinates import coordinates
from tmap.glide.filters import sample
from tmap.glide.lod import level_of_detail
from tmap.glide.state import ONE_W, Unit


class Point(NamedTuple):
    """The iterated values of pixels, integers or arrays of one shape. ``s``, ``t``: 14.18; ``w``:
    2.30; ``base``: the polygon's level of detail, 8.8; ``x``, ``y``: on the screen; ``before``,
    ``behind``: how many pixels of its line are on each side, if pixels are given line by line."""

    s: np.ndarray | int
    t: np.ndarray | int
    w: np.ndarray | int = ONE_W
    base: np.ndarray | int = 0
    x: np.ndarray | int = 0
    y: np.ndarray | int = 0
    before: np.ndarray | int = 0
    behind: np.ndarray | int = 0


def shaded(unit: Unit, s: np.ndarray, t: np.ndarray, lod: np.ndarray,
           other: np.ndarray) -> np.ndarray:
    """Returns colours [..., 4] at s, t (14.18) and a level of detail (8.8)."""
    return combined(unit.modes, lod, sample(unit, s, t, lod), other)


def pixel(unit: Unit, point: Point, other: np.ndarray) -> np.ndarray:
    """Returns colours [..., 4] of a unit's pixels; ``other``: from upstream, [..., 4]."""
    values = np.broadcast_arrays(*(np.asarray(c, np.int64) for c in point))
    s, t, w, start, x, y, before, behind = values
    lod = level_of_detail(unit.modes, start, w, x, y)
    return shaded(unit, *coordinates(unit.modes, s, t, w, before, behind), lod, other)


def chain_pixel(units: Sequence[Unit], points: Sequence[Point]) -> np.ndarray:
    """Returns colours [..., 4] of units in a row, the first nearest the frame buffer; each has its
    own point. The last one's input from upstream is 0. If one dithers its level of detail, all
    divide each pixel."""
    colour = np.zeros(4, np.int64)
    if any(unit.modes.dither for unit in units):
        points = [point._replace(before=0, behind=0) for point in points]
    for unit, point in zip(reversed(units), reversed(points), strict=True):
        colour = pixel(unit, point, colour)
    return colour
