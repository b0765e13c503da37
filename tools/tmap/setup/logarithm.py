"""The integer model's perspective by logarithms: c/perspective/logarithms.c,
src68k/edge/logarithm_lines and src68k/span/logarithm.

On a line u = K + C / q as in ``model_reciprocal``; here q's index finds its logarithm at each
pixel, and that of |C| less it a power. Lines for which the tables are not good enough are
left to ``model_perspective``.
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
ONE = 1 << 30  # of mantissas
FACTORS = 128
#: Centre of what parts lie below the curve between them, 11.5 / 2, and are cut.
BIAS = 7
#: 2^(1/128) and 2^(1/16384)
COARSE, FINE = 1079572136, 1073787251

#: What makes a line's pixels wrong: in 1/65536 texel K and powers rounded, C and K of the polygon;
#: in indices of q its cut and its shift and steps; in units of a logarithm logs' rounding, what
#: K's move leaves of C's, C's own. See src68k/edge/logarithm_lines.s.
REST, OFF_INDEX, OFF_LOG = 2 * 128 + 24, 0.5 + 0.04, 0.505 + 0.14 + 0.04


def limit(bucket: int) -> int:
    """The power up to which a line may go whose largest logarithm has this upper part: the distance
    from K that keeps to 1/32 texel, and almost 512 texels: a rounded step may lead an index, 3
    units, further."""
    smallest = 2 ** ((MIDDLE - (bucket - 23) * 1024) / OCTAVE) - 1.5
    far = (2048 - REST) / 65536 / (OFF_INDEX / smallest + OFF_LOG * log(2) / OCTAVE)
    # No value is within 1/1000 of an integer: the logarithm's last bits do not matter.
    return min(floor(OCTAVE * log2(256 * far)), POWERS - 4)


#: Of each 1/16 of an octave of logs, from the lowest.
LIMITS = [limit(bucket) for bucket in range(48)]


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
    return np.append(np.concatenate(out), out[-1][-1])


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
        q = step_swapped(q, each.dq)
    return np.array(out)


def coordinates(each: Logarithmic) -> tuple[np.ndarray, np.ndarray]:
    """u and v of the line's pixels, 16.16 modulo 2^32."""
    log = logs()[indices(each)]
    return tuple((k + (-d if each.way >> bit & 1 else d)) << 8 & M32 for bit, k, d in
                 ((axis, each.k[axis], powers()[each.power[axis] + log]) for axis in (0, 1)))


def mantissa(power: int) -> int:
    """2^(power / OCTAVE) in 1/OCTAVE, straight between octaves; up to 6.2 % too large."""
    return (power % OCTAVE + OCTAVE) << (power >> BITS)


def constant(c: int, k: int, base: int, high: int) -> tuple[int, int] | None:
    """(K in 8.8, power) of a line whose 64 C, K and higher logarithm are given; None where C is
    too large. K takes 0.72 of what a rounded C is off at the farthest pixel, or the middle of what
    the least power is."""
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
    """The line's record from ``reciprocal.Constants``; None: it is left to others.
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
    """What a line's u or v may be off from S / q of its planes, in 1/65536 texel: see OFF_INDEX.
    Where |C| is too small for the powers, they show 1/32 texel at the farthest pixel and 1/256 at
    least: 7/16 of 1/32, as K is moved to the middle; its move by chords 1/9 of 9/16 of that."""
    q = swap(each.q) + (ORIGIN << 16) & M32
    last = q + each.n * swap(each.dq) & M32
    smaller = min(q, last) if last >> 16 >= LOWEST else q  # 2^32 by the rounding of steps
    high = int(logs()[(smaller >> 16) - LOWEST])
    far = int(powers()[min(max(each.power) + high, POWERS - 1)]) << 8
    i = (smaller >> 16) - 0.5
    found = REST + far * (OFF_INDEX / i + OFF_LOG * log(2) / OCTAVE)
    return max(found, 1024 + REST) if min(each.power) + high <= LEAST + 4 else found
