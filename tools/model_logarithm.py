"""The integer model's perspective by logarithms: c/polygon/logarithms.c,
src68k/edge/logarithm_lines and src68k/span/logarithm.

On a line u = K + C / q as in ``model_reciprocal``; here q's index finds its logarithm at each
pixel, and that of |C| less it a power. Lines for which the tables are not good enough are
left to ``model_perspective``.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np

from .fixed import M32, signed

BITS = 14
OCTAVE = 1 << BITS
LOWEST = 8192
COUNT = 65536 - LOWEST
ORIGIN = LOWEST + COUNT // 2
MIDDLE = 29 * OCTAVE // 2
OCTAVES = 17
POWERS = OCTAVES * OCTAVE
PARTS = 256
ONE = 1 << 30  # of mantissas
FACTORS = 128
#: 2^(1/128) and 2^(1/16384)
COARSE, FINE = 1079572136, 1073787251


@cache
def mantissas() -> np.ndarray:
    """2^(t / OCTAVE) in 2.30 for t from 0 to OCTAVE."""
    rows = [[ONE], [ONE]]
    for row, factor in zip(rows, (COARSE, FINE)):
        while len(row) < FACTORS:
            row.append(row[-1] * factor >> 30)
    made = (np.array(rows[0])[:, None] * np.array(rows[1]) >> 30).ravel()
    return np.append(made, 2 * ONE)


@cache
def logs() -> np.ndarray:
    """MIDDLE less the logarithms of i + 1/2, i from LOWEST on: the step whose neighbours' means
    enclose it."""
    m = mantissas()
    means = (m[:-1] >> 1) + (m[1:] >> 1)
    out = []
    for k in range(LOWEST.bit_length() - 1, 16):
        x = 2 * np.arange(1 << k, 2 << k) + 1 << 29 - k
        out.append(MIDDLE - k * OCTAVE - np.searchsorted(means, x, "right"))
    return np.concatenate(out)


@cache
def powers() -> np.ndarray:
    """2^(i / OCTAVE) rounded, its upper bits too."""
    m = mantissas()[:-1]
    return np.concatenate([m + (1 << 29 - k) >> 30 - k for k in range(OCTAVES)])


@cache
def parts() -> list[int]:
    """log2(1 + i / PARTS) in 1/256 units."""
    m, out = mantissas(), []
    for k in range(PARTS):
        x = ONE + (k << 22)
        t = int(np.searchsorted(m, x, "right")) - 1
        out.append((t << 8) + ((x - int(m[t])) << 8) // int(m[t + 1] - m[t]))
    return [*out, OCTAVE << 8]


@dataclass
class Logarithmic:
    """A line's record."""

    left: int
    n: int
    q: int  # fraction:integer, as dq
    dq: int
    k: tuple[int, int]  # 8.8, what is above it too
    power: tuple[int, int]  # where a logarithm of 0 leads
    way: int


def indices(each: Logarithmic) -> np.ndarray:
    """The logarithms' indices of the line's pixels, from 0."""
    q, out = each.q, []
    for _ in range(each.n + 1):
        out.append(signed(q << 16) // 65536 + ORIGIN - LOWEST)
        q += each.dq
        q = q & 0xFFFF0000 | (q & 0xFFFF) + (q >> 32) & 0xFFFF
    return np.array(out)


def coordinates(each: Logarithmic) -> tuple[np.ndarray, np.ndarray]:
    """u and v of the line's pixels, 16.16 modulo 2^32."""
    log = logs()[indices(each)]
    return tuple((k + (-d if each.way >> bit & 1 else d)) << 8 & M32 for bit, k, d in
                 ((axis, each.k[axis], powers()[each.power[axis] + log]) for axis in (0, 1)))
