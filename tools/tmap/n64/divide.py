"""The perspective divide, with the hardware's table and saturation."""

from typing import NamedTuple

import numpy as np

from tmap.base.fixed import signed

#: Reciprocals of 64/64 .. 128/64 of a normalised w, 2^14 / (1 + i/64); one entry is low by 1.
TABLE = np.array([((1 << 21) // (64 + i) + 1) >> 1 for i in range(65)], np.int64)
TABLE[6] = 14979


class Divided(NamedTuple):
    """int64 arrays of one shape: ``s``, ``t``: s10.5, saturated; ``raw_s``, ``raw_t``: their 17
    bits, signed; ``overflow``: bool, true if either did not fit."""

    s: np.ndarray
    t: np.ndarray
    raw_s: np.ndarray
    raw_t: np.ndarray
    overflow: np.ndarray


def reciprocal(w: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns (r, shift) of the low 15 bits of w: 1/w is about r * 2^shift / 2^28."""
    w = np.asarray(w, np.int64) & 0x7FFF
    shift = 15 - np.frexp(w)[1].astype(np.int64)
    shift = np.clip(shift, 0, 14)
    n = w << shift & 0x3FFF
    i, f = n >> 8, n & 255
    return TABLE[i] + (-(TABLE[i] - TABLE[i + 1]) * f * 4 >> 10), shift


def divide(s: np.ndarray, t: np.ndarray, w: np.ndarray, perspective: bool) -> Divided:
    """Returns coordinates of pixels from the upper 16 bits of their iterators; without
    perspective these are the coordinates."""
    s, t, w = (signed(np.asarray(c, np.int64), 16) for c in (s, t, w))
    if not perspective:
        return Divided(s, t, s, t, np.zeros(s.shape, bool))
    bad = w <= 0
    r, shift = reciprocal(w)
    clamped, raws, overflows = [], [], []
    for c in (s, t):
        product = c * r
        v = np.where(shift == 14, product << 1, product >> np.maximum(13 - shift, 0))
        over = bad | (v < -0x10000) | (v > 0xFFFF)
        raw = signed(v, 17)
        limit = np.where(bad | (c >= 0), 32767, -32768)
        clamped.append(np.where(over, limit, np.clip(raw, -32768, 32767)))
        raws.append(raw)
        overflows.append(over)
    return Divided(*clamped, *raws, overflows[0] | overflows[1])
