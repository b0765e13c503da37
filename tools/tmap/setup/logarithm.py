"""The integer model's perspective by logarithms: c/perspective/logarithms.c,
src68k/edge/logarithm_lines and src68k/span/logarithm.

On a line u = K + C / q as in tmap.setup.reciprocal. Here the index of q looks up its logarithm at
each pixel; the logarithm of |C| minus that one looks up a power. Lines for which the tables are not
accurate enough are left to tmap.setup.perspective.
"""

from dataclasses import dataclass
from functools import cache
from math import floor, log, log2

import numpy as np

from tmap.base.fixed import M32, signed, step_swapped, swap
from tmap.setup.reciprocal import near_ends

BITS = 14
OCTAVE = 1 << BITS
LOWEST = 8192
COUNT = 65537 - LOWEST
ORIGIN = (LOWEST + 65536) // 2
MIDDLE = 29 * OCTAVE // 2
OCTAVES = 17
POWERS = OCTAVES * OCTAVE
LEAST = 3 * OCTAVE  # 1/32 texel
FURTHEST = 8
PARTS = 256
ONE_2_30 = 1 << 30  # of mantissas
FACTORS = 128
#: Centres the error of ``parts``: between entries it is below the curve by 11.5 at most, taken half
#: (11.5 / 2), and it is cut.
BIAS = 7
#: 2^(1/128) and 2^(1/16384)
COARSE, FINE = 1079572136, 1073787251

#: The errors of a line's pixels. REST, in 1/65536 texel: rounding of K and of powers, C and K of
#: the polygon. OFF_INDEX, in indices of q: its cut, its shift and steps. OFF_LOG, in units of a
#: logarithm: the rounding of ``logs``, the rest of C's rounding after K's move, the error of C
#: itself. See src68k/edge/logarithm_lines.s.
REST, OFF_INDEX, OFF_LOG = 2 * 128 + 24, 0.5 + 0.04, 0.505 + 0.14 + 0.04


def limit(bucket: int) -> int:
    """Returns the largest power allowed to a line whose largest logarithm has these upper bits. Up
    to this distance from K the error is at most 1/32 texel. It is below 512 texels by a margin: a
    rounded step may lead one index, 3 units, further."""
    smallest = 2 ** ((MIDDLE - (bucket - 23) * 1024) / OCTAVE) - 1.5
    far = (2048 - REST) / 65536 / (OFF_INDEX / smallest + OFF_LOG * log(2) / OCTAVE)
    # No value is within 1/1000 of an integer: the logarithm's last bits do not matter.
    return min(floor(OCTAVE * log2(256 * far)), POWERS - 4)


#: The limit for each 1/16 octave of logarithms, from the lowest.
LIMITS = [limit(bucket) for bucket in range(48)]


@cache
def mantissas() -> np.ndarray:
    """Returns 2^(t / OCTAVE) in 2.30 for t from 0 to OCTAVE."""
    rows = [[ONE_2_30], [ONE_2_30]]
    for row, factor in zip(rows, (COARSE, FINE)):
        while len(row) < FACTORS:
            row.append(row[-1] * factor >> 30)
    made = (np.array(rows[0])[:, None] * np.array(rows[1]) >> 30).ravel()
    return np.append(made, 2 * ONE_2_30)


@cache
def logs() -> np.ndarray:
    """Returns MIDDLE minus the logarithms of i + 1/2, i from LOWEST on. Each is the step for which
    the means with its neighbours enclose the value."""
    m = mantissas()
    means = (m[:-1] >> 1) + (m[1:] >> 1)
    out = []
    for k in range(LOWEST.bit_length() - 1, 16):
        x = 2 * np.arange(1 << k, 2 << k) + 1 << 29 - k
        out.append(MIDDLE - k * OCTAVE - np.searchsorted(means, x, "right"))
    return np.append(np.concatenate(out), out[-1][-1])


@cache
def powers() -> np.ndarray:
    """Returns 2^(i / OCTAVE), rounded, with all upper bits."""
    m = mantissas()[:-1]
    return np.concatenate([m + (1 << 29 - k) >> 30 - k for k in range(OCTAVES)])


@cache
def parts() -> list[int]:
    """Returns log2(1 + i / PARTS) in 1/256 units."""
    m, out = mantissas(), []
    for k in range(PARTS):
        x = ONE_2_30 + (k << 22)
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
    k: tuple[int, int]  # 8.8, with all upper bits
    power: tuple[int, int]  # the power for a logarithm of 0
    way: int


def indices(each: Logarithmic) -> np.ndarray:
    """Returns the logarithms' indices of the line's pixels, from 0."""
    q, out = each.q, []
    for _ in range(each.n + 1):
        out.append(signed(q << 16) // 65536 + ORIGIN - LOWEST)
        q = step_swapped(q, each.dq)
    return np.array(out)


def coordinates(each: Logarithmic) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of the line's pixels, 16.16 modulo 2^32."""
    log = logs()[indices(each)]
    return tuple((k + (-d if each.way >> bit & 1 else d)) << 8 & M32 for bit, k, d in
                 ((axis, each.k[axis], powers()[each.power[axis] + log]) for axis in (0, 1)))


def mantissa(power: int) -> int:
    """Returns 2^(power / OCTAVE) in 1/OCTAVE, linear between octaves; up to 6.2 % too large."""
    return (power % OCTAVE + OCTAVE) << (power >> BITS)


def constant(c: int, k: int, base: int, high: int) -> tuple[int, int] | None:
    """Returns (K in 8.8, power) of a line from 64 C, K and the larger logarithm; None if C is too
    large. K is moved by 0.72 of the error that C's rounding makes at the farthest pixel; with the
    least power, so that the middles of the drawn and the exact values agree."""
    size = abs(c)
    power = None
    if size >> 32:
        up = 64 - size.bit_length()
        m = size << up >> 32
        part, rest = m >> 23 & 255, m >> 7 & 0xFFFF
        lower, upper = parts()[part:part + 2]
        full = lower + ((upper - lower) * rest >> 16) - (up << 22) + base
        power = full >> 8
        if power + high > LIMITS[(high + 24576) >> 10]:
            return None
    if power is None or power + high < LEAST:
        reach = 8 if power is None or power + high < 0 else mantissa(power + high) >> 10
        power = LEAST - high
        more = (reach - 128) * 9
    else:
        more = ((full & 255) - 128) * (mantissa(power + high) >> 16) >> 13
    return signed(k) + (-more if c < 0 else more) + 128 >> 8, power


def line(p, k, left: int, right: int, y: int) -> Logarithmic | None:
    """Returns the line's record from ``reciprocal.Constants``; None if it is drawn another way.
    ``right`` is excluded."""
    at_ends = near_ends(p, left, right, y, FURTHEST)
    if not at_ends:
        return None
    q0, q1, shift = at_ends
    factor = 1024 // ((max(q0, q1) << shift >> 26) + 1)
    q0, q1 = ((q << shift >> 4) * factor for q in (q0, q1))
    if min(q0, q1) < LOWEST + 1 << 16:
        return None
    dq = ((signed(p.q.dx, 64) >> 4) * factor << shift) + (1 << 31) >> 32
    high = int(logs()[(min(q0, q1) >> 16) - LOWEST])
    base = (shift + 33 << 22) - (MIDDLE << 8) + parts()[(factor - 16) * 16] + BIAS + 128
    found, way = [], 0
    for axis, (middle, c, dc) in enumerate(zip(k.k, k.c, k.dc)):
        c = signed(c + (y - p.j) * dc, 64)
        found.append(constant(c, middle, base, high))
        way |= (c < 0) << axis
    if None in found:
        return None
    (u, power_u), (v, power_v) = found
    return Logarithmic(left, right - 1 - left, swap(q0 - (ORIGIN << 16) & M32), swap(dq & M32),
                       (u, v), (power_u, power_v), way)


def bound(each: Logarithmic) -> float:
    """Returns the largest error of a line's u or v against S / q of its planes, in 1/65536 texel:
    see OFF_INDEX. If |C| is too small for the powers, they give 1/32 texel at the farthest pixel
    and at least 1/256 elsewhere. As K is moved to the middle, the error is 7/16 of 1/32; the chords
    in K's move add 1/9 of 9/16 of that."""
    q = swap(each.q) + (ORIGIN << 16) & M32
    last = q + each.n * swap(each.dq) & M32
    smaller = min(q, last) if last >> 16 >= LOWEST else q  # rounded steps may reach 2^32
    high = int(logs()[(smaller >> 16) - LOWEST])
    far = int(powers()[min(max(each.power) + high, POWERS - 1)]) << 8
    i = (smaller >> 16) - 0.5
    found = REST + far * (OFF_INDEX / i + OFF_LOG * log(2) / OCTAVE)
    return max(found, 1024 + REST) if min(each.power) + high <= LEAST + 4 else found
