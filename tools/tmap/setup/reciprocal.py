"""The integer model's perspective by a table of reciprocals: src68k/polygon/reciprocal_find,
src68k/edge/reciprocal_lines and the spans src68k/span/reciprocal_*.

On a line u = K + C / q: K belongs to the polygon, C to the line, so that only q is stepped. Its
index looks up r in the table, and a piece's steps are C times the difference of r. Lines for which
the table is not accurate enough are left to tmap.setup.perspective.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np

from tmap.base.fixed import M32, signed, step_swapped, swap
from tmap.build import layout

LOWEST = 10920
COUNT = 65536 - LOWEST
ORIGIN = LOWEST + COUNT // 2
FURTHEST = 8
TWO, THREE, LEAST = 0x40000000, 0xAAAA0000, LOWEST + 2 << 16
FLAT = 1 << 8
BITS = 6  # by which C is kept larger
FAR_512 = 512 << 16  # of K, u and v from their base
TABLE = [((1 << 30) + i) // (2 * i + 1) for i in range(LOWEST, 65536)]


@dataclass
class Constants:
    """K of u and v, 16.16; 64 C of the first line and its growth per line, modulo 2^64."""

    k: tuple[int, int]
    c: tuple[int, int]
    dc: tuple[int, int]
    limit: int | None
    piece: int | None
    raised: list[int]  # units by which u and v are raised, included in k


@dataclass
class Reciprocal:
    """A line's record."""

    left: int
    n: int
    start: tuple[int, int]  # 8.24, with all upper bits
    q: int  # fraction:integer, as dq
    dq: int
    c: tuple[int, int]
    first: int
    last: int
    carry: int
    piece: int


@cache
def reach(piece: int, width: int) -> int:
    """Returns the most texels between K and a line in pieces of 2^piece pixels; c/span/reciprocal.h
    derives it."""
    found = layout.load().constants
    return found[f"RECIPROCAL_REACH_{1 << piece}"] - width // found["RECIPROCAL_REACH_WIDTH"]


def product(k: int, q: int) -> int:
    """Returns K q, both 32.32, in units, cut as the routine cuts it."""
    (a, b), (c, d) = ((x >> 32, x & M32) for x in (k, q))
    return a * c + (a * d >> 32) + (b * c >> 32)


def asymptote(q, plane, bits: int = BITS) -> int | None:
    """Returns K of a plane, 32.32; None if it is 2^(16 - bits) texels away."""
    top, bottom = signed(plane.dx, 64), signed(q.dx, 64)
    sign = -1 if (top < 0) != (bottom < 0) else 1
    top, bottom = abs(top), abs(bottom)
    if bottom >> 32 < FLAT or top >> 64 - bits or top >> 32 - bits >= bottom >> 32:
        return None
    up = 32 - (bottom >> 32).bit_length()
    return sign * ((top << up + 32) // (bottom << up >> 32))


def raised(piece: int | None, width: int, k: int, low: int, high: int) -> int:
    """Returns the units by which lines are raised: their largest error, derived in the C
    headers."""
    found = layout.load().constants
    if piece is None:
        return found["LOGARITHM_OFF"]
    far = (max(high - k, k - low) >> 16) + 1
    return found[f"RECIPROCAL_OFF_{1 << piece}"] + width // 2 + (far * found["RECIPROCAL_OFF_PART"] >> 2)


def asymptotes(p, x: int, y: int, bits: int = BITS) -> tuple[list[int], list[int], list[int]] | None:
    """Returns K of u and v, less their bases, C 2^bits of the first line, and its growth per line; None if
    there is no K. (x, y): a pixel of the polygon, relative to the planes' (i, j)."""
    if not p.gentle:
        return None
    k, c, dc = [], [], []
    q = signed(p.q.value(x, y), 64)
    for plane in (p.s, p.t):
        full = asymptote(p.q, plane, bits)
        if full is None:
            return None
        k.append(full >> 32)
        dc.append(signed(plane.dy - product(full, signed(p.q.dy, 64)) << bits, 64))
        c.append(signed((plane.value(x, y) - product(full, q) << bits) - y * dc[-1], 64))
    return k, c, dc


def is_near(p, k: list[int], reach: int, far: int = FAR_512) -> bool:
    """Returns true if K and the ranges are nearer than ``far`` to the bases, and K is at most ``reach``
    outside the ranges."""
    return (max(max(abs(n), high, -low) for n, high, low in zip(k, p.high, p.low)) < far
            and not any(max(low - n, n - high) > reach for n, high, low in zip(k, p.high, p.low)))


def find(p, piece: int | None, width: int, x: int, y: int) -> Constants | None:
    """Returns the constants of a tmap.setup.perspective.Perspective; None if no line is tried.
    (x, y): a pixel of the polygon, relative to the planes' (i, j); ``width``: that of its box;
    ``piece``: log2 of a piece's pixels, None for logarithms."""
    found = asymptotes(p, x, y)
    if found is None or not is_near(p, found[0], FAR_512 if piece is None else reach(piece, width) << 16):
        return None
    k, c, dc = found
    more = [raised(piece, width, *each) for each in zip(k, p.low, p.high)]
    return Constants(tuple(b + n + m & M32 for b, n, m in zip(p.base, k, more)), tuple(c), tuple(dc),
                     piece and reach(piece, width) << 24 - piece, piece, more)


def near_ends(p, left: int, right: int, y: int, furthest: int) -> tuple[int, int, int] | None:
    """Returns q at a line's first and last pixel, and how many bits the larger one can be shifted
    left; None if that is over ``furthest`` or q is too small. ``right`` is excluded."""
    q0, q1 = (p.q.value(x - p.i, y - p.j) >> 32 for x in (left, right - 1))
    shift = 32 - max(q0, q1).bit_length()
    return None if min(q0, q1) < p.least or shift > furthest else (q0, q1, shift)


def line(p, k: Constants, left: int, right: int, y: int) -> Reciprocal | None:
    """Returns the line's record; None if it is drawn another way. ``right`` is excluded."""
    n, m = right - 1 - left, 1 << k.piece
    found = near_ends(p, left, right, y, FURTHEST)
    if not found:
        return None
    q0, q1, shift = found
    q0, q1 = q0 << shift, q1 << shift
    dq = signed(p.q.dx, 64) << shift + k.piece >> 32
    more = min(q0, q1) < TWO and max(q0, q1) < THREE
    if more:
        q0, q1, dq = q0 + (q0 >> 1), q1 + (q1 >> 1), dq + (dq >> 1)
    if min(q0, q1) < LEAST or (n >= m and not 8 << 16 <= abs(dq) < 1 << 31):
        return None
    r0, r1 = (TABLE[(q >> 16) - LOWEST] for q in (q0, q1))
    if n < 3 * m and not -32768 <= r1 - r0 < 32768:
        return None
    cs, starts = [], []
    for base, c, dc in zip(k.k, k.c, k.dc):
        c = signed(c + (y - p.j) * dc, 64) >> 32 << shift + 5 - k.piece
        if more and c == signed(c):
            c += c >> 1
        if c != signed(c) or c + 0x8000 != signed(c + 0x8000):
            return None
        near = c + 0x8000 >> 16
        lost = signed(c, 16)
        start = (signed(base) << 8) + (near * r0 + (lost * (r0 + r1 >> 2) >> 15) << k.piece)
        cs.append(near)
        starts.append(start)
    if max(abs(c) for c in cs) * max(r0, r1) > k.limit:
        return None
    falls = cs[1] * (r1 - r0) < 0
    return Reciprocal(left, n, tuple(starts), swap((q0 - (ORIGIN << 16)) & M32), swap(dq & M32),
                      tuple(cs), r0, r1, -128 if falls else 128, k.piece)


def steps(du: int, dv: int, carry: int) -> tuple[int, int]:
    """Returns the steps of B and A from those of u and v, 8.24."""
    u, v = du + carry & M32, swap(dv & M32)
    u = (u << 8 | u >> 24) & M32
    return u & 0xFFFF0000 | v & 0xFFFF, v & 0xFFFF0000 | u & 0xFFFF


def lift(x: int, near: int, hidden: int = 0) -> int:
    """Extends x, 8.16, to the 16.16 number, modulo 2^32, that is nearest to ``near``, which has 24
    fraction bits. The result may be up to ``hidden`` above x."""
    near >>= 8
    x = near + (x - near + (1 << 23) & 0xFFFFFF) - (1 << 23)
    return min(max(near, x), x + hidden) & M32


def bound(each: Reciprocal) -> float:
    """Returns the largest error of a line's u or v against S / q of its planes, at the ends of its
    pieces, in 1/65536 texel. It is the sum of the errors of q's index, of r and C, of C's rounding
    away from the line's middle, half a unit per pixel for u's steps, and 50 for the rest: q.hi and
    64 C cut (12 and 24), q's steps, the last piece's part, V's overflow and K cut."""
    r = max(each.first, each.last)
    far = max(abs(c) for c in each.c) * r / (1 << 24 - each.piece)
    i = (1 << 29) / r
    return (far * (32768 / i + i / 16384) + abs(each.first - each.last) / (1 << 10 - each.piece)
            + each.n / 2 + 50)


def coordinates(each: Reciprocal) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of the line's pixels, 16.16 modulo 2^32. The chain holds u in 8.16 and v in
    8.8; the sum of the steps supplies the bits above these and v's last 8 bits."""
    m, q, old = 1 << each.piece, each.q, each.first
    b, a = steps(*each.start, 0)
    a &= 0xFFFF00FF
    us, vs, k, at = [], [], 0, each.start
    while True:
        rest = each.n - k
        if rest >= m:
            q = step_swapped(q, each.dq)
            r = TABLE[signed(q << 16) // 65536 + ORIGIN - LOWEST]
            du, dv = (c * signed(r - old, 16) for c in each.c)
            old, rest = r, m - 1
        else:
            r = signed(each.last - old, 16)
            part = 0x7FFFFFFF // rest if rest else 0
            du, dv = ((c * r * part >> 32) << each.piece + 1 for c in each.c)
        db, da = steps(du, dv, each.carry)
        a += da & 0xFFFF0000
        for _ in range(rest + 1):
            us.append(lift((a & 0xFF) << 16 | b >> 16, at[0]))
            vs.append(lift((b & 0xFFFF) << 8, at[1], 255))
            at = at[0] + du, at[1] + dv
            b += db + (a >> 32)
            ahead = a & 0xFFFF0000
            a = (a & M32) + da + (b >> 32)
            b &= M32
        a = ahead | a & 0xFFFF
        k += rest + 1
        if k > each.n:
            return np.array(us), np.array(vs)
