"""The integer model's polygons with perspective that are drawn by cubics: c/perspective/cubic.c and the spans
src68k/span/cubic_*.

On a line u = K + C / q as in tmap.setup.far, from its far end to its near one. A piece of n pixels begins
with the exact U = C / q; behind it C / (q + t dq) = U / (1 + x), x = t dq / q, is the cubic of ``cubics.fits``, stepped
by its differences.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tmap.base.cubics import NEAR, fits
from tmap.base.fixed import M32, counted, mul_div, signed
from tmap.setup import far

#: By setting: the error that cubics may make, the most that lines are raised by, units of 1/65536 texel; the pixels
#: of the longest piece; what the cuts of differences add.
WAYS = {"pixel": (1280, 384, 56, 123), "fine": (320, 96, 28, 18)}
REACH = 16383  # texels from K
STEEP = 120  # texels a pixel
MOST_OFF = 4096  # units of q; what lines are raised by is derived in c/span/cubic.h
OFF_C = 4  # units of C
K_BITS = far.K_BITS


@dataclass
class Constants:
    """A polygon's constants. k: 8.24 with all upper bits; c, dc: of the first line; q, dqdx, dqdy: 1.31, at
    pixel (left, top)."""

    k: tuple[int, int]
    c: tuple[int, int]  # U q 2^(shift + 1 - bits), q being 1 at the nearest vertex
    dc: tuple[int, int]  # the same times 2^32
    q: int
    dqdx: int
    dqdy: int
    left: int
    top: int
    bits: int  # r = 2^(30 + bits) / q
    shift: int  # U = C r / 2^shift
    factors: tuple[int, int, int]  # of r: the steps that p's coefficients take
    most: int  # lambda / dq, 16.16
    longest: int  # pixels of a piece
    raised: list[int]  # units by which u and v are raised, included in k
    down: int  # lines from the top vertex to the first
    farthest: tuple[int, int]  # texels from K of u and v
    setting: str = "pixel"
    less: int = 0  # bits that K lacks

    @property
    def leftwards(self) -> bool:
        """True if lines are drawn from right to left."""
        return self.dqdx < 0


@dataclass
class Line:
    """A line's pixels left to left + n; q and C at its far end."""

    left: int
    n: int
    q: int
    c: tuple[int, int]
    way: int  # pixels and lines from the planes' own pixel to the far end
    down: int  # lines from the planes' own
    constants: Constants

    @cached_property
    def pieces(self) -> list[tuple[int, int, int]]:
        """Each piece's first pixel, counted from the far end, its pixels and its q."""
        k, at, q, found = self.constants, 0, self.q, []
        while at <= self.n:
            pixels = min((q >> 16) * k.most >> 16, k.longest - 1, self.n - at) + 1
            found.append((at, pixels, q))
            at += pixels
            q = q + pixels * abs(k.dqdx) & M32
        return found


def fit_of(farthest: int, setting: str) -> tuple[int, int, int, int]:
    """Returns the row of ``fits`` for a polygon whose farthest point is ``farthest`` texels from K."""
    return fits()[max(farthest.bit_length(), NEAR) - NEAR + (2 if setting == "fine" else 0)]


def finer_starts(p, found) -> list[tuple[int, int]] | None:
    """Returns C of the first line and its growth a line, that times 2^32, from ``far.starts``."""
    if not found:
        return None
    height = p.corners.three[1][1] - p.corners.three[0][1]
    parts = [mul_div(rest, 1 << 30, height) for rest in found[2]]
    return [tuple(c + ((part >> 15) * p.corners.y >> 31) for c, part in zip(found[0], parts)),
            tuple((dc << 32) + (part << 2) for dc, part in zip(found[1], parts))]


def plane_of_q(q) -> list[int]:
    """Returns q's value and steps, 1.31, to the nearest."""
    return [signed(n + (1 << 30) >> 31) for n in (q.at, q.dx, q.dy)]


def find(p, setting: str, box, exact: bool) -> Constants | None:
    """Returns the constants of a tmap.setup.perspective.Perspective, whose lines begin at the box's first; None if
    the polygon is drawn another way. ``exact``: edges are not rounded."""
    lines = box[3] - box[1]
    way = lines + box[2] - box[0]
    least = far.least_of(p, way, exact)
    if least is None:
        return None
    q, dqdx, dqdy = plane_of_q(p.q)
    dq, bits = abs(dqdx), least.bit_length()
    less, ks = 0, far.asymptotes(p)
    if ks is None or max(far.to_farthest(p, ks)) > REACH // 4:  # u - K is a long
        less, ks = far.COARSE, far.asymptotes(p, far.COARSE)
        if ks is None:
            return None
    farthest = far.to_farthest(p, ks, less)
    reach = max(farthest)
    lost = (way >> 2) + 1 + p.corners.off
    if reach > REACH or lost > MOST_OFF or not dq:
        return None
    shift = min(13 - reach.bit_length() + bits, 31)
    found = finer_starts(p, far.starts(p, ks, shift - bits + less, less))
    if not found:
        return None
    tolerance, raise_most, longest, cuts = WAYS[setting]
    width, *p123 = fit_of(reach, setting)
    single = dq >= 1 << bits - 3 or reach > STEEP * (2 * least // dq)
    factors = (0, 0, 0) if single else tuple(-(dq * n >> bits - 3) for n in p123)
    part = (lost << 18) // (least >> 6) + 1  # 1/256 units for each texel
    off = cuts + (4 if less else 1) * ((1 << 30) // least + 1) + (OFF_C << 31 - shift >> 1) + 2
    off += (3 << p.scale - 2) // (least >> 4)
    raised = [off + (n * part >> 8) + (n >> 8) + (n >> bits - 17) for n in farthest]
    if max(raised) > raise_most:
        return None
    return Constants(tuple((k << 8 - K_BITS + less) + (b + m << 8) for b, k, m in zip(p.base, ks, raised)),
                     *found, q, dqdx, dqdy, p.i, p.j, bits, shift, factors,
                     0 if single else min(width // dq, 65535), longest, raised, p.corners.down - lines,
                     tuple(farthest), setting, less)


def line(p, k: Constants, left: int, right: int, y: int) -> Line:
    """Returns a line's values; ``right`` is excluded."""
    far_x = right - 1 if k.leftwards else left
    q = k.q + (far_x - k.left) * k.dqdx + (y - k.top) * k.dqdy & M32
    return Line(left, right - 1 - left, q, tuple(signed(c + ((y - k.top) * dc >> 32)) for c, dc in zip(k.c, k.dc)),
                abs(far_x - k.left) + y - k.top, y - k.top, k)


def differences(u: np.ndarray, r: np.ndarray, factors: tuple[int, int, int]) -> tuple[np.ndarray, ...]:
    """Returns the first, second and third differences of pieces, 8.24, modulo 2^32. Factors are longs, and r is at most
    2^31, as q is not below the least: no product exceeds 62 bits."""
    d1, d2, d3 = (r * n >> 32 for n in factors)
    b = signed(u * d1 >> 24)
    c = b * d2 >> 32
    d = c * d3
    third = 6 * d >> 32
    return b + c + (d >> 32), 2 * c + third, third


def coordinates(lines: list[Line]) -> list[np.ndarray]:
    """Returns u and v of the pixels of a polygon's lines, one after the other, 16.16 modulo 2^32."""
    k = lines[0].constants
    counts, q, cu, cv = np.array([(pixels, q, *each.c) for each in lines for _, pixels, q in each.pieces]).T
    r = (1 << 30 + k.bits) // q
    n = counted(counts)
    pairs, triples = n * (n - 1) >> 1, n * (n - 1) * (n - 2) // 6
    found = []
    for base, c in zip(k.k, (cu, cv)):
        u = signed(c * r >> k.shift)
        at, *steps = (np.repeat(each, counts) for each in (base + (u << 8), *differences(u, r, k.factors)))
        found.append(at + n * steps[0] + pairs * steps[1] + triples * steps[2] >> 8 & M32)
    return far.in_order(lines, *found)


def bounds(lines: list[Line]) -> np.ndarray:
    """Returns the largest errors of the u or v of a polygon's lines, in 1/65536 texel: what cubics may be off and what
    cuts of differences and of their factors add; that of q's steps; a unit of r and of U; of C those of ``far``'s."""
    k = lines[0].constants
    tolerance, _, _, cuts = WAYS[k.setting]
    q, way, c = np.array([(each.q, each.way, max(abs(n) for n in each.c) + OFF_C) for each in lines]).T
    u = c / 2.0**(k.shift + 1 - k.bits) / q * 2.0**31
    return (tolerance + cuts + 2 + u / 2**24 + u * (way / 2 + 2) / q + c / 2.0**k.shift
            + OFF_C * 2.0**(30 - k.shift))
