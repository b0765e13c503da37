"""What the texture unit is meant to draw: exact perspective and filters with exact fractions.

Coordinates are quotients of two planes over the screen (tools.ideal_perspective), so which
texel a pixel lies in, and in which triangle of four, is decided in integers; colours are float64.
The colour a mode draws is then off from this for the hardware's reasons: coordinates of 5
fraction bits, the reciprocal's table, colours of 8 bits.
"""

from typing import NamedTuple

import numpy as np

from ..errors import UserError
from ..ideal import corners
from ..ideal_perspective import Curve
from .polygon import Vertex
from .state import Axis, State
from .texels import fetch

UNIT = 65536
FILTERS = ("point", "three-point", "bilinear")


class Coordinate(NamedTuple):
    """Of pixels [n]: ``index``: whole texels, int64, exact; ``fraction``: float64, 0 <= f < 1."""

    index: np.ndarray
    fraction: np.ndarray

    @property
    def value(self) -> np.ndarray:
        """Texels, float64."""
        return self.index + self.fraction


class Surface:
    """The exact s and t of a planar polygon; ``perspective``: divided by depth."""

    def __init__(self, vertices: list[Vertex], perspective: bool):
        three = [vertices[k] for k in corners(vertices)]
        points = [v[:2] for v in three]
        depths = [v.w if perspective else UNIT for v in three]
        self.curves = [Curve(points, [v[k] for v in three], depths) for k in (2, 3)]

    def at(self, x: np.ndarray, y: np.ndarray) -> tuple[Coordinate, Coordinate]:
        """s and t in texels at pixels [n], exact."""
        found = []
        for curve in self.curves:
            over, inverse = curve.terms(*(np.asarray(c).astype(object) * UNIT for c in (x, y)))
            below = np.broadcast_to(inverse * UNIT, over.shape)
            if (below <= 0).any():
                raise UserError("ideal: a pixel lies behind the viewer")
            index = over // below
            fraction = ((over - index * below) / below).astype(np.float64)
            found.append(Coordinate(index.astype(np.int64), fraction))
        return tuple(found)

    def distance(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Texels to the next pixel right or below along s or t, the most of the four, float64:
        what the level of detail is meant to be taken from."""
        here, most = self.at(x, y), np.zeros(np.shape(x))
        for there in (self.at(x + 1, y), self.at(x, y + 1)):
            for a, b in zip(here, there):
                moved = (b.index - a.index) + (b.fraction - a.fraction)
                most = np.maximum(most, np.abs(moved))
        return most


def scaled(c: Coordinate, shift: int) -> Coordinate:
    """A coordinate after a tile's shift."""
    if shift <= 10:
        whole = c.index >> shift
        rest = (c.index - (whole << shift) + c.fraction) / (1 << shift)
    else:
        more = (c.fraction * (1 << 16 - shift))
        whole = (c.index << 16 - shift) + np.floor(more).astype(np.int64)
        rest = more % 1
    return Coordinate(whole, rest)


def placed(axis: Axis, c: Coordinate) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(texel, neighbour, fraction) of a coordinate on a tile's axis: [n] each."""
    c = scaled(c, axis.shift)
    whole, quarter = divmod(axis.low, 4)
    moved = c.fraction - quarter / 4
    index, fraction = c.index - whole + np.floor(moved).astype(np.int64), moved % 1
    if axis.clamp or not axis.mask:
        last = (axis.high >> 2) - whole
        end = (axis.high - axis.low) / 4
        outside = (index < 0) | (index + fraction >= end)
        fraction = np.where(outside, 0, fraction)
        index = np.where(index < 0, 0, np.where(outside, last, index))
    return wrapped(axis, index), wrapped(axis, index + 1), fraction


def wrapped(axis: Axis, index: np.ndarray) -> np.ndarray:
    """An index within a tile's mask."""
    if not axis.mask:
        return index
    period = 1 << min(axis.mask, 10)
    if not axis.mirror:
        return index % period
    index = index % (2 * period)
    return np.where(index < period, index, 2 * period - 1 - index)


def sample(state: State, number: int, s: Coordinate, t: Coordinate, how: str) -> np.ndarray:
    """Colours [n, 4], float64 0..255, of tile ``number``; ``how``: one of FILTERS. Not of YUV."""
    if how not in FILTERS:
        raise UserError(f"ideal: filter {how!r} is none of {', '.join(FILTERS)}")
    tile = state.tiles[number & 7]
    (s0, s1, fs), (t0, t1, ft) = placed(tile.s, s), placed(tile.t, t)
    c00 = fetch(state, tile, s0, t0).astype(np.float64)
    if how == "point":
        return c00
    c10, c01, c11 = (fetch(state, tile, a, b) for a, b in ((s1, t0), (s0, t1), (s1, t1)))
    fs, ft = fs[:, None], ft[:, None]
    if how == "bilinear":
        upper, lower = c00 + fs * (c10 - c00), c01 + fs * (c11 - c01)
        return upper + ft * (lower - upper)
    return np.where(fs + ft < 1, c00 + fs * (c10 - c00) + ft * (c01 - c00),
                    c11 + (1 - fs) * (c01 - c11) + (1 - ft) * (c10 - c11))


def levels(state: State, surface: Surface, x: np.ndarray, y: np.ndarray, how: str) -> np.ndarray:
    """Colours [n, 4] between two levels of the state's tiles, from its first on: with n whole
    doublings in the distance to the next pixel, tiles n and n + 1 in the ratio of the rest.
    No detail, no sharpening: nearer than 1 texel a pixel it is the first tile's colour."""
    s, t = surface.at(x, y)
    lod = np.maximum(surface.distance(x, y), 1)
    level = np.minimum(np.floor(np.log2(lod)).astype(np.int64), state.max_level)
    rest = np.where(level == state.max_level, 0, lod / (1 << level) - 1)[:, None]
    colours = np.zeros((np.size(x), 4))
    for n in np.unique(level).tolist():
        here = level == n
        at = [Coordinate(c.index[here], c.fraction[here]) for c in (s, t)]
        near, far = (sample(state, state.primitive_tile + min(n + k, state.max_level), *at, how)
                     for k in range(2))
        colours[here] = near + rest[here] * (far - near)
    return colours


class Error(NamedTuple):
    """How far colours are off, in 1/255 of the brightest."""

    most: float
    rms: float


def error(drawn: np.ndarray, ideal: np.ndarray, channels: int = 3) -> Error:
    """Colours [n, 4], drawn and ideal, compared in their first channels."""
    off = np.abs(drawn[..., :channels].astype(np.float64) - ideal[..., :channels])
    if not off.size:
        return Error(0.0, 0.0)
    return Error(float(off.max()), float(np.sqrt((off * off).mean())))
