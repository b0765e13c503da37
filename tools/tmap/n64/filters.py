"""Samples: the 2x2 quad filtered over three of its texels, averaged, or colour-converted."""

from typing import NamedTuple

import numpy as np

from tmap.base.fixed import signed
from tmap.n64.coordinates import Position, position
from tmap.n64.state import YUV, State, Tile
from tmap.n64.texels import chroma, fetch


class Quad(NamedTuple):
    """Texels around pixels, int64 [..., n] each: this one, right, below, both."""

    c00: np.ndarray
    c10: np.ndarray
    c01: np.ndarray
    c11: np.ndarray


def quad(state: State, tile: Tile, s: Position, t: Position) -> Quad:
    """Returns the four texels of pixels. A YUV texel's chroma neighbour is in the next pair."""
    columns, rows = (s.index, s.index + s.step), (t.index & 255, (t.index & 255) + t.step)
    taps = [fetch(state, tile, column, row) for row in rows for column in columns]
    if tile.format == YUV:
        for tap, row in zip((1, 3), rows):
            taps[tap][..., :2] = chroma(state, tile, columns[1] + s.step, row)
    return Quad(*taps)


def interpolate(q: Quad, fs: np.ndarray, ft: np.ndarray) -> np.ndarray:
    """Three-point interpolation in fractions of 1/32, rounded to the nearest, [..., n]."""
    fs, ft = fs[..., None], ft[..., None]
    lower = q.c00 + (fs * (q.c10 - q.c00) + ft * (q.c01 - q.c00) + 16 >> 5)
    upper = q.c11 + ((32 - fs) * (q.c01 - q.c11) + (32 - ft) * (q.c10 - q.c11) + 16 >> 5)
    return np.where(fs + ft >= 32, upper, lower)


def weighed(q: Quad, fs: np.ndarray, ft: np.ndarray, previous: np.ndarray,
            middle: np.ndarray) -> np.ndarray:
    """Interpolates with the last sample's channels as fractions of 1/256: filter and
    convert-one together, which no manual describes. In the middle a quarter of the fourth
    texel is added."""
    u, v, y = (signed(previous[..., k], 9)[..., None] for k in range(3))
    lower = u * (q.c10 - q.c00) + v * (q.c01 - q.c00)
    upper = u * (q.c01 - q.c11) + v * (q.c10 - q.c11) + np.where(middle, 64 * (q.c00 - q.c11), 0)
    return y + (np.where((fs + ft >= 32)[..., None], upper, lower) + 128 >> 8)


def filtered(state: State, q: Quad, fs: np.ndarray, ft: np.ndarray,
             previous: np.ndarray | None) -> np.ndarray:
    """Returns the filter's result for channels [..., n]."""
    middle = ((fs == 16) & (ft == 16) & bool(state.modes.mid))[..., None]
    if previous is not None:
        return weighed(q, fs, ft, previous, middle)
    return np.where(middle, sum(q) + 2 >> 2, interpolate(q, fs, ft))


def nearest(q: Quad, fs: np.ndarray, ft: np.ndarray) -> np.ndarray:
    """Returns the texel at the right angle of the triangle that contains the pixel."""
    return np.where((fs + ft >= 32)[..., None], q.c11, q.c00)


def convert(k: list[int], texel: np.ndarray) -> np.ndarray:
    """Converts (U, V, Y, any), 9-bit signed, to (R, G, B, Y), 9 bits, [..., 4]."""
    u, v, y = (signed(texel[..., n], 9) for n in range(3))
    k0, k1, k2, k3 = (2 * c + 1 for c in k[:4])
    return np.stack([y + (k0 * v + 128 >> 8), y + (k1 * u + k2 * v + 128 >> 8),
                     y + (k3 * u + 128 >> 8), y], -1) & 511


def sample(state: State, number: int, s: np.ndarray, t: np.ndarray, cycle: int = 0,
           previous: np.ndarray | None = None) -> np.ndarray:
    """Samples tile ``number`` at pixels: int64 [..., 4], channels of 9 bits (0..511).

    ``s``, ``t``: s10.5, one shape; ``cycle``: 0 or 1; ``previous``: cycle 0's sample, needed
    in cycle 1 if convert-one is on.
    """
    modes, tile = state.modes, state.tiles[number & 7]
    s_at, t_at = position(tile.s, s, False), position(tile.t, t, True)
    filters = modes.filter1 if cycle else modes.filter0
    again = previous if cycle and modes.convert_one else None
    if not filters and again is not None:
        return convert(state.k, again)
    if not modes.quad:
        texel = fetch(state, tile, s_at.index, t_at.index & 255)
        if not filters:
            return convert(state.k, texel)
        if again is not None:
            texel = np.repeat(again[..., 2:3], 4, -1)
        return texel & 511
    q = quad(state, tile, s_at, t_at)
    parts = [(slice(0, 4), s_at.fraction)]
    if tile.format == YUV:  # a pair of texels shares its chroma: its step is half as large
        parts = [(slice(0, 2), s_at.fraction >> 1 | (s_at.index & 1) << 4),
                 (slice(2, 4), s_at.fraction)]
    results = []
    for channels, fs in parts:
        part = Quad(*(c[..., channels] for c in q))
        results.append(filtered(state, part, fs, t_at.fraction, again) if filters
                       else nearest(part, fs, t_at.fraction))
    result = np.concatenate(results, -1)
    return result & 511 if filters else convert(state.k, result)
