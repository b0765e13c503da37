"""The ideal of the N64's texture engine: exact perspective and filters with exact fractions.

Coordinates are quotients of two planes over the screen (tmap.ideal.texels), so the texel of a
pixel, and the triangle between four texels, are decided in integers; colours are float64. The
remaining errors of a mode's colours are the hardware's: coordinates of 5 fraction bits, the
reciprocal's table, colours of 8 bits.
"""

from math import prod
from typing import NamedTuple

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import ONE
from tmap.ideal.ideal import corners
from tmap.ideal.texels import Coordinate, Quotients, bilinear, scaled
from tmap.n64.combiner import ALPHA, ALPHA_NAMES, RGB, RGB_NAMES, names
from tmap.n64.polygon import Vertex
from tmap.n64.state import TWO_CYCLES, YUV, Axis, State
from tmap.n64.texels import fetch

FILTERS = ("point", "three-point", "bilinear")


class Surface(Quotients):
    """The exact s and t of a planar polygon, in texels; ``perspective``: divided by depth."""

    def __init__(self, vertices: list[Vertex], perspective: bool):
        three = [vertices[k] for k in corners(vertices)]
        depths = [v.w if perspective else 1 for v in three]
        near = [prod(depths) // depth for depth in depths]
        super().__init__([v[:2] for v in three], [[v[k] * p for v, p in zip(three, near)]
                                                  for k in (2, 3)], [ONE * p for p in near])

    def distance(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Returns the texels to the next pixel right or below along s or t, the largest of the
        four, float64: the ideal source of the level of detail."""
        here = self.at(x, y)
        return np.max([abs((b.index - a.index) + (b.fraction - a.fraction))
                       for there in (self.at(x + 1, y), self.at(x, y + 1))
                       for a, b in zip(here, there)], axis=0)


def placed(axis: Axis, c: Coordinate) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns (texel, neighbour, fraction) of a coordinate on a tile's axis: [n] each."""
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
    """Wraps an index to a tile's mask."""
    if not axis.mask:
        return index
    period = 1 << min(axis.mask, 10)
    if not axis.mirror:
        return index % period
    index = index % (2 * period)
    return np.where(index < period, index, 2 * period - 1 - index)


def three_point(c: list[np.ndarray], fs: np.ndarray, ft: np.ndarray) -> np.ndarray:
    """Filters texels (this one, right, below, both) [n, channels] by fractions of the triangle."""
    (c00, c10, c01, c11), fs, ft = c, fs[:, None], ft[:, None]
    return np.where(fs + ft < 1, c00 + fs * (c10 - c00) + ft * (c01 - c00),
                    c11 + (1 - fs) * (c01 - c11) + (1 - ft) * (c10 - c11))


def sample(state: State, number: int, s: Coordinate, t: Coordinate, how: str) -> np.ndarray:
    """Returns colours [n, 4], float64 0..255, of tile ``number``; ``how``: one of FILTERS. Those of
    a YUV tile are U, V (signed), Y, Y, valid before the last pair of texels: a pair shares its
    chroma, which is filtered from pair to pair."""
    if how not in FILTERS:
        raise UserError(f"ideal: filter {how!r} is none of {', '.join(FILTERS)}")
    tile = state.tiles[number & 7]
    (s0, s1, fs), (t0, t1, ft) = placed(tile.s, s), placed(tile.t, t)
    if how == "point":
        return fetch(state, tile, s0, t0).astype(np.float64)
    weigh = three_point if how == "three-point" else bilinear
    found = weigh([fetch(state, tile, a, b) for b in (t0, t1) for a in (s0, s1)], fs, ft)
    if tile.format == YUV:
        pair = s0 & ~1
        corners = [fetch(state, tile, a, b) for b in (t0, t1) for a in (pair, pair + 2)]
        found[:, :2] = weigh(corners, (fs + (s0 & 1)) / 2, ft)[:, :2]
    return found


def converted(k: list[int], texel: np.ndarray) -> np.ndarray:
    """Converts U, V, Y and an unused value to R, G, B, Y: [n, 4]; ``k``: the convert word's."""
    u, v, y = (texel[:, n] for n in range(3))
    k0, k1, k2, k3 = ((2 * c + 1) / 256 for c in k[:4])
    return np.stack([y + k0 * v, y + k1 * u + k2 * v, y + k3 * u, y], -1)


class Texels(NamedTuple):
    """The combiner's inputs for pixels: two colours [n, 4], and the level of detail's fraction from
    the first to the second [n]; if it is below 0, the first is sharpened."""

    texel0: np.ndarray
    texel1: np.ndarray
    fraction: np.ndarray


def pairs(state: State, distance: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns two tiles, counted from the first, and the fraction between them, [n] each, from
    distances to the next pixel. n whole doublings give levels n and n + 1 in the ratio of the rest.
    Below one texel per pixel it is only the first level; with detail, the detail tile before it and
    the first level; with sharpening, the first level and the second, the fraction below 0."""
    modes, near = state.modes, distance < 1
    lod = np.maximum(distance, 1)
    level = np.minimum(np.frexp(lod)[1] - 1, state.max_level)  # whole doublings, exactly
    rest = np.where(level == state.max_level, 0, lod / (1 << level) - 1)
    close = np.maximum(distance, state.min_level / 32)
    if modes.detail:
        return level + ~near, np.minimum(level + 1, state.max_level) + ~near, \
            np.where(near, close, rest)
    if modes.sharpen:
        rest = np.where(near, close - 1, rest)
    return level, np.minimum(level + 1, state.max_level), rest


def texels(state: State, surface: Surface, x: np.ndarray, y: np.ndarray, how: str) -> Texels:
    """Returns the combiner's inputs at pixels [n]; ``how``: one of FILTERS."""
    s, t = surface.at(x, y)
    zero = np.zeros(np.size(x), np.int64)
    first, second, fraction = zero, zero + 1, zero * 1.0
    if state.modes.lod:
        first, second, fraction = pairs(state, surface.distance(x, y))
    near, far = np.zeros((2, zero.size, 4))
    for number in np.unique([first, second]).tolist():
        for found, numbers in ((near, first), (far, second)):
            here = numbers == number
            at = [Coordinate(c.index[here], c.fraction[here]) for c in (s, t)]
            found[here] = sample(state, state.primitive_tile + number, *at, how)
    if not state.modes.filter0:
        near = converted(state.k, near)
    if not state.modes.filter1:
        far = converted(state.k, near if state.modes.convert_one else far)
    return Texels(near, far, fraction)


def levels(state: State, surface: Surface, x: np.ndarray, y: np.ndarray, how: str) -> np.ndarray:
    """Returns colours [n, 4] between two levels of the state's tiles, counted from its first."""
    near, far, rest = texels(state, surface, x, y, how)
    return near + rest[:, None] * (far - near)


def combined(state: State, found: Texels, shade: np.ndarray) -> np.ndarray:
    """Returns the combiner's ideal colours [n, 4], 0..255. As factors, colours are divided by 255,
    fractions and K5 by 256. ``shade``: [n, 4]."""
    result = np.zeros_like(found.texel0)
    two = state.modes.cycle == TWO_CYCLES
    for cycle in range(1 - two, 2):
        second = two and cycle == 1
        values = {"combined": result, "shade": shade,
                  "texel0": found.texel1 if second else found.texel0,
                  "texel1": found.texel0 if second or not two else found.texel1,
                  "primitive": np.array(state.primitive), "one": np.full(4, 255),
                  "environment": np.array(state.environment), "k4": np.full(4, state.k[4])}
        factors = {"lod fraction": found.fraction[:, None], "k5": state.k[5] / 256,
                   "primitive lod fraction": state.primitive_fraction / 256}
        parts = []
        for inputs, table, channels in ((state.combine.rgb[cycle], RGB_NAMES, RGB),
                                        (state.combine.alpha[cycle], ALPHA_NAMES, ALPHA)):
            def value(name: str | None, channels=channels):
                base, dot, _ = (name or "").partition(".")
                return values[base][..., ALPHA if dot else channels] if base in values else 0

            a, b, c, d = names(inputs, table)
            factor = factors[c] if c in factors else value(c) / 255
            made = (value(a) - value(b)) * factor + value(d)
            parts.append(np.broadcast_to(made, (len(shade), channels.stop - channels.start)))
        result = np.concatenate(parts, -1)
    return np.clip(result, 0, 255)
