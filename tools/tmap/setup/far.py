"""The integer model's polygons with perspective that are drawn from the far ends of their lines to the
near ones: c/perspective/far.c and the spans src68k/span/far_*.

On a line u = K + C r with r = TABLE[q]: K and the steps of q belong to the polygon, C to the line. All pieces
have 2^piece pixels, from the far end on; the near end cuts the last one short.
"""

from dataclasses import dataclass, field

import numpy as np

from tmap.base.fixed import M32, signed, step_swapped, swap
from tmap.build import layout
from tmap.setup import reciprocal

LOWEST = 8192
COUNT = 65536 - LOWEST
ORIGIN = LOWEST + COUNT // 2
STEEP = 1 << 25
COARSE = 4
BITS = 3  # of K and C
FAR_4096 = 4096 << 16
PIECES_8 = 64
TABLE = [((1 << 29) + i) // (2 * i + 1) for i in range(LOWEST, 65536)]
OFF_PART = 21


@dataclass
class Constants:
    """A polygon's constants. k: 8.24 with all upper bits; c, dc: 16.16, of the first line, rounded; q, dqdx, dqdy: index and 16
    bits below it, at pixel (left, top)."""

    k: tuple[int, int]
    c: tuple[int, int]
    dc: tuple[int, int]
    q: int
    dqdx: int
    dqdy: int
    left: int
    top: int
    piece: int
    coarse: int  # 0 or COARSE
    raised: list[int]  # units by which u and v are raised, included in k
    rows: list[tuple[int, int]] = field(default_factory=list, repr=False)  # C of lines from top on

    def c_at(self, y: int) -> tuple[int, int]:
        """Returns C of u and v on a line, 16.16, stepped as fraction:integer."""
        rows = self.rows = self.rows or [tuple(swap(c & M32) for c in self.c)]
        while len(rows) <= y - self.top:
            rows.append(tuple(step_swapped(c, swap(dc & M32)) for c, dc in zip(rows[-1], self.dc)))
        return tuple(signed(swap(c)) for c in rows[y - self.top])


@dataclass
class Line:
    """A line's pixels left to left + n; q and C at its far end."""

    left: int
    n: int
    q: int
    c: tuple[int, int]  # 16.16, rounded
    way: int  # pixels and lines from the planes' own pixel to the far end
    constants: Constants

    @property
    def leftwards(self) -> bool:
        """True if the line is drawn from right to left."""
        return self.constants.dqdx < 0

    @property
    def indices(self) -> list[int]:
        """The index of q at the beginnings and the end of the line's pieces, in drawing order."""
        q, dq = swap(self.q - (ORIGIN << 16) & M32), self.constants.dqdx << self.constants.piece
        dq, found = swap(abs(dq)), []
        for _ in range((self.n >> self.constants.piece) + 2):
            found.append(signed(q << 16) // 65536 + ORIGIN)
            q = step_swapped(q, dq)
        return found


def magnitude(value: int) -> int:
    """Returns the magnitude of a 64-bit number's upper half, as ``perspective_steepness``."""
    high = value >> 32
    return high if high >= 0 else (~high if value & M32 else -high)


def piece_of(p, piece: int) -> int | None:
    """Returns log2 of the pieces' pixels; None if the polygon is not drawn this way."""
    steep = magnitude(signed(p.q.dx, 64)) + 1
    if steep >= STEEP or (p.least - steep) >> 15 <= LOWEST or p.most > (1 << 30) + steep:
        return None
    return 3 if p.least // PIECES_8 < steep else piece


def fits(c: int, dc: int, count: int, bits: int) -> bool:
    """Returns true if C times 2^bits is below 2^31 on all lines."""
    return magnitude(c) < 1 << 30 - bits and magnitude(dc) < (1 << 29 - bits) // count


def find(p, piece: int, lines, box) -> Constants | None:
    """Returns the constants of a tmap.setup.perspective.Perspective, whose lines begin at the box's first;
    None if the polygon is drawn another way. ``piece``: log2 of the setting's pixels."""
    piece = piece_of(p, piece)
    first = next((k for k, line in enumerate(lines) if line.right > line.left), None)
    if piece is None or first is None:
        return None
    found = reciprocal.asymptotes(p, lines[first].left - box[0], first, BITS)
    if found is None or not reciprocal.is_near(p, found[0], FAR_4096, FAR_4096):
        return None
    ks, cs, dcs = found
    bits, coarse = 13 - BITS - piece, 0
    if not all(fits(c, dc, len(lines), bits) for c, dc in zip(cs, dcs)):
        bits, coarse = bits - COARSE, COARSE
        if not all(fits(c, dc, len(lines), bits) for c, dc in zip(cs, dcs)):
            return None
    off = len(lines) + 8 if coarse else 66 << piece
    raised = [off + (((max(high - n, n - low) >> 16) + 1) * OFF_PART >> 2)
              for n, low, high in zip(ks, p.low, p.high)]
    c, dc = ([signed(n << bits >> 32) for n in each] for each in (cs, dcs))
    q = [signed(n >> 31) for n in (p.q.at, p.q.dx, p.q.dy)]
    return Constants(tuple(b + n + m << 8 for b, n, m in zip(p.base, ks, raised)),
                     tuple(n + 0x8000 for n in c), tuple(dc), *q, p.i, p.j, piece, coarse, raised)


def line(p, k: Constants, left: int, right: int, y: int) -> Line:
    """Returns a line's values; ``right`` is excluded."""
    far = right - 1 if k.dqdx < 0 else left
    q = k.q + (far - k.left) * k.dqdx + (y - k.top) * k.dqdy & M32
    return Line(left, right - 1 - left, q,
                k.c_at(y), abs(far - k.left) + y - k.top, k)


def bound(each: Line) -> float:
    """Returns the largest error of a line's u or v against S / q of its planes, at the ends of its pieces,
    in 1/65536 texel: those of q's index (half of 1, and the steps' cuts), of r (half of 1), of C (half a
    word; if it is coarse, only times what r has changed; and the steps' cuts); a unit per pixel for u's steps
    and V's overflow, and 8 for K and the start."""
    k = each.constants
    scale = 2.0**(k.piece + k.coarse - 8)  # units of 1 in C r
    c = max(abs(n) for n in each.c) / 65536 + 1
    cut = (each.way + each.n + (2 << k.piece)) / 65536
    found = [(i, TABLE[i - LOWEST]) for i in each.indices]
    first = found[0][1]
    return each.n + 8 + max(
        scale * (c * r * ((0.5 + cut) / i + 0.5 / r) + ((first - r if k.coarse else r) / 2) + r * cut)
        for i, r in (found[0], found[-1]))


def coordinates(each: Line) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of the line's pixels, 16.16 modulo 2^32; see ``reciprocal.coordinates``."""
    k, m = each.constants, 1 << each.constants.piece
    rs = [TABLE[i - LOWEST] for i in each.indices]
    words = [signed(c >> 16, 16) for c in each.c]
    if k.coarse:
        at = [base + ((c - 0x8000) * rs[0] >> 16 - k.piece - k.coarse)
              for base, c in zip(k.k, each.c)]
    else:
        at = [base + (c * rs[0] << k.piece) for base, c in zip(k.k, words)]
    b, a = reciprocal.steps(*at, 0)
    a &= 0xFFFF00FF
    us, vs = [], []
    for old, r in zip(rs, rs[1:]):
        rest = min(each.n + 1 - len(us), m)
        if not rest:
            break
        du, dv = (c * (r - old) << k.coarse for c in words)
        db, da = reciprocal.steps(du, dv, 0)
        a += da & 0xFFFF0000
        for _ in range(rest):
            us.append(reciprocal.lift((a & 0xFF) << 16 | b >> 16, at[0]))
            vs.append(reciprocal.lift((b & 0xFFFF) << 8, at[1], 255))
            at = at[0] + du, at[1] + dv
            b += db + (a >> 32)
            ahead = a & 0xFFFF0000
            a = (a & M32) + da + (b >> 32)
            b &= M32
        a = ahead | a & 0xFFFF
    if each.leftwards:
        us.reverse(), vs.reverse()
    return np.array(us), np.array(vs)
