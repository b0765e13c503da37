"""The integer model's polygons that are drawn from the far ends of their lines by planes of u and v, as K is too
far away (tmap.setup.far): c/perspective/far.c and the spans src68k/span/far_planes_*.

u = S r with r = TABLE[q]. Each piece is a chord between two products, so nothing adds up from piece to piece.
"""

from dataclasses import dataclass

import numpy as np

from tmap.base.fixed import M32, signed
from tmap.setup import far, reciprocal

SCALE, RANGE, WAY, OFF = 28, 1536, 8192, 32
STEP = 1 << 26  # of S a pixel, shifted, so that 16 fit


@dataclass
class Constants:
    """A polygon's planes at pixel (left, top), as words of 32 bits: the value, its growth a pixel, a line."""

    q: int
    dqdx: int
    dqdy: int
    st: tuple[tuple[int, int, int], tuple[int, int, int]]
    base: tuple[int, int]  # 16.16
    left: int
    top: int
    every: str  # of far.LENGTHS
    raised: list[int]  # units by which u and v are raised, included in the base
    even: int = 0  # pieces may differ in length

    @property
    def leftwards(self) -> bool:
        """True if lines are drawn from right to left."""
        return self.dqdx < 0


@dataclass
class Line(far.Line):
    """A line's pixels left to left + n; c: S and T at its far end."""


def find(p, every: str, lines, box, exact: bool) -> Constants | None:
    """Returns the planes of a tmap.setup.perspective.Perspective; None if the polygon is drawn another way."""
    way = len(lines) + box[2] - box[0]
    shift = far.shift_of(p, way, exact)
    if shift is None:
        return None
    ranges = [(max(-low, high) >> 16) + 1 for low, high in zip(p.low, p.high)]
    way <<= shift
    if max(ranges) > RANGE or way > WAY:
        return None
    raised = [OFF + (way >> 1) + (n * (far.OFF_PART + (way >> 11)) >> 2) for n in ranges]
    q, *st = (tuple(signed(n >> bits) for n in (plane.at, plane.dx, plane.dy))
              for plane, bits in ((p.q, 32), (p.s, SCALE), (p.t, SCALE)))
    if max(abs(dx) for _, dx, _ in st) > STEP >> shift:
        return None
    return Constants(*q, tuple(st), tuple(b + n for b, n in zip(p.base, raised)), p.i, p.j, every, raised)


def line(p, k: Constants, left: int, right: int, y: int) -> Line:
    """Returns a line's values; ``right`` is excluded."""
    end = right - 1 if k.leftwards else left
    across, down = end - k.left, y - k.top
    q, *st = (at + across * dx + down * dy for at, dx, dy in ((k.q, k.dqdx, k.dqdy), *k.st))
    return Line(left, right - 1 - left, q & M32, tuple(map(signed, st)), abs(across) + down, down, k)


def pieces(each: Line):
    """Yields each piece, and (S, T) at its beginning and end."""
    k, at = each.constants, each.c
    way = -1 if k.leftwards else 1
    for piece in each.pieces:
        if piece.is_first:
            begin = tuple(signed(c << piece.shift) if not piece.at else c >> 2 for c in at)
        at = tuple(signed(c + (way * dx * piece.pixels << piece.shift)) for c, (_, dx, _) in zip(begin, k.st))
        yield piece, begin, at
        begin = at


def bound(each: Line) -> float:
    """Returns the largest error of a line's u or v against S / q of its planes, at the ends of its pieces,
    in 1/65536 texel: those of q's index (half of 1, and the steps' cuts), of r (half of 1), and of S (the steps'
    cuts); a unit a pixel of a piece for u's steps and V's overflow, and 8 for the rest."""
    most = 0.0
    for piece, begin, end in pieces(each):
        cut = (each.way + piece.at + 2 * piece.pixels + 4) * 2.0**piece.shift
        for i, st in ((piece.begin, begin), (piece.end, end)):
            r = far.reciprocal_at(i)
            s = (max(map(abs, st)) + cut) / 65536
            most = max(most, s * r * ((0.5 + cut / 65536) / i + 0.5 / r) + cut * r / 65536)
    return 16 + 8 + most


def coordinates(each: Line) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of the line's pixels, 16.16 modulo 2^32; see ``reciprocal.coordinates``."""
    k, us, vs = each.constants, [], []
    for piece, begin, end in pieces(each):
        at, to = ([base + (c * far.reciprocal_at(i) >> 16) for base, c in zip(k.base, st)]
                  for i, st in ((piece.begin, begin), (piece.end, end)))
        du, dv = (signed(b - a) * (256 // piece.pixels) for a, b in zip(at, to))
        at = [n << 8 for n in at]
        _, _, u, v = reciprocal.piece(reciprocal.begun(*at), at, du, dv, min(each.n + 1 - piece.at, piece.pixels))
        us += u
        vs += v
    if k.leftwards:
        us.reverse(), vs.reverse()
    return np.array(us), np.array(vs)
