"""The integer model's constants of lines by tables: src68k/polygon/reciprocal_find.

On a line u = K + C / q: K belongs to the polygon, C to the line, so that only q is stepped.
"""

from dataclasses import dataclass

from tmap.base.fixed import M32, signed, swap
from tmap.build import layout

FLAT = 1 << 8
BITS = 6  # by which C is kept larger
FAR_512 = 512 << 16  # of K, u and v from their base


@dataclass
class Constants:
    """K of u and v, 16.16; 64 C of the first line and its growth per line, modulo 2^64."""

    k: tuple[int, int]
    c: tuple[int, int]
    dc: tuple[int, int]
    raised: list[int]  # units by which u and v are raised, included in k


def product(k: int, q: int) -> int:
    """Returns K q, both 32.32, in units, cut as the routine cuts it."""
    (a, b), (c, d) = ((x >> 32, x & M32) for x in (k, q))
    return a * c + (a * d >> 32) + (b * c >> 32)


def asymptote(q, plane) -> int | None:
    """Returns K of a plane, 32.32; None if it is 2^(16 - BITS) texels away."""
    top, bottom = signed(plane.dx, 64), signed(q.dx, 64)
    sign = -1 if (top < 0) != (bottom < 0) else 1
    top, bottom = abs(top), abs(bottom)
    if bottom >> 32 < FLAT or top >> 64 - BITS or top >> 32 - BITS >= bottom >> 32:
        return None
    up = 32 - (bottom >> 32).bit_length()
    return sign * ((top << up + 32) // (bottom << up >> 32))


def asymptotes(p, x: int, y: int) -> tuple[list[int], list[int], list[int]] | None:
    """Returns K of u and v, less their bases, C 2^BITS of the first line, and its growth per line; None if
    there is no K. (x, y): a pixel of the polygon, relative to the planes' (i, j)."""
    if not p.gentle:
        return None
    k, c, dc = [], [], []
    q = signed(p.q.value(x, y), 64)
    for plane in (p.s, p.t):
        full = asymptote(p.q, plane)
        if full is None:
            return None
        k.append(full >> 32)
        dc.append(signed(plane.dy - product(full, signed(p.q.dy, 64)) << BITS, 64))
        c.append(signed((plane.value(x, y) - product(full, q) << BITS) - y * dc[-1], 64))
    return k, c, dc


def is_near(p, k: list[int]) -> bool:
    """Returns true if K and the ranges are nearer than FAR_512 to the bases, and K is as near the ranges."""
    return (max(max(abs(n), high, -low) for n, high, low in zip(k, p.high, p.low)) < FAR_512
            and not any(max(low - n, n - high) > FAR_512 for n, high, low in zip(k, p.high, p.low)))


def find(p, x: int, y: int) -> Constants | None:
    """Returns the constants of a tmap.setup.perspective.Perspective for logarithms; None if no line is tried.
    (x, y): a pixel of the polygon, relative to the planes' (i, j)."""
    found = asymptotes(p, x, y)
    if found is None or not is_near(p, found[0]):
        return None
    k, c, dc = found
    more = layout.load().constants["LOGARITHM_OFF"]
    return Constants(tuple(b + n + more & M32 for b, n in zip(p.base, k)), tuple(c), tuple(dc), [more, more])


def near_ends(p, left: int, right: int, y: int, furthest: int) -> tuple[int, int, int] | None:
    """Returns q at a line's first and last pixel, and how many bits the larger one can be shifted
    left; None if that is over ``furthest`` or q is too small. ``right`` is excluded."""
    q0, q1 = (p.q.value(x - p.i, y - p.j) >> 32 for x in (left, right - 1))
    shift = 32 - max(q0, q1).bit_length()
    return None if min(q0, q1) < p.least or shift > furthest else (q0, q1, shift)


def steps(du: int, dv: int, carry: int) -> tuple[int, int]:
    """Returns the steps of B and A from those of u and v, 8.24."""
    u, v = du + carry & M32, swap(dv & M32)
    u = (u << 8 | u >> 24) & M32
    return u & 0xFFFF0000 | v & 0xFFFF, v & 0xFFFF0000 | u & 0xFFFF


def piece(state: tuple[int, int], at, du: int, dv: int, count: int):
    """Steps the chain's registers B and A for ``count`` pixels by du and dv, 8.24; returns their state, the sums
    of the steps from ``at`` on, and u and v of the pixels."""
    (b, a), us, vs = state, [], []
    db, da = steps(du, dv, 0)
    a += da & 0xFFFF0000
    for _ in range(count):
        us.append(lift((a & 0xFF) << 16 | b >> 16, at[0]))
        vs.append(lift((b & 0xFFFF) << 8, at[1], 255))
        at = at[0] + du, at[1] + dv
        b += db + (a >> 32)
        ahead = a & 0xFFFF0000
        a = (a & M32) + da + (b >> 32)
        b &= M32
    return (b, ahead | a & 0xFFFF), at, us, vs


def begun(u: int, v: int) -> tuple[int, int]:
    """Returns the chain's registers B and A for u and v, 8.24."""
    b, a = steps(u, v, 0)
    return b, a & 0xFFFF00FF


def lift(x: int, near: int, hidden: int = 0) -> int:
    """Extends x, 8.16, to the 16.16 number, modulo 2^32, that is nearest to ``near``, which has 24
    fraction bits. The result may be up to ``hidden`` above x."""
    near >>= 8
    x = near + (x - near + (1 << 23) & 0xFFFFFF) - (1 << 23)
    return min(max(near, x), x + hidden) & M32
