"""The integer model's polygons with perspective that are drawn from the far ends of their lines to the
near ones: c/perspective/far.c, src68k/polygon/far_* and the spans src68k/span/far_*.

On a line u = K + C r with r = TABLE[q]: K and the steps of q belong to the polygon, C to the line. K is the growth of
S over that of q; C = (u - K) q at the top and the bottom, and changes by the same from line to line. q is shifted
left by an even number so that its index is LOWEST to 4 LOWEST; where that is over, the line begins again. Pieces
go from the far end on; the near end cuts the last one short.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tmap.base.fixed import M32, counted, cut_quotient, signed, step_swapped, swap
from tmap.setup import chain
from tmap.setup.perspective import steepness

LOWEST = 8192
COUNT = 40962 + 768
ORIGIN = 32768
MOST = 1 << 30
#: The greatest steps of q a pixel, q being 2^29 to 2^31, by a piece's pixels; by settings, and every8 if a tolerance
#: has chosen it.
LENGTHS = {"every16": {16: 1 << 23, 8: 1 << 25, 4: 1 << 27, 2: MOST // 2, 1: MOST},
           "every8": {16: 1 << 22, 8: 1 << 24, 4: 1 << 26, 2: 1 << 28, 1: MOST},
           "tolerance": {16: 0, 8: 1 << 24, 4: 1 << 26, 2: 1 << 28, 1: MOST}}
NEVER = 65535  # an index
#: Eighths of a chord's error, by which the ends of even spans' pieces are ahead.
AHEAD = {"every16": 3, "every8": 4}
DEEP = 8
COARSE = 4
EVEN = 1 << 28
K_BITS, K_SCALE = 3, 29
BITS, BITS_COARSE = 5, 1
DOWN = 2048
REACH = 192
TABLE = [((1 << 29) + i) // (2 * i + 1) for i in range(LOWEST, LOWEST + COUNT)]
TABLE_ARRAY = np.array(TABLE)
OFF_PART, OFF_CORNERS, OFF_WORD, OFF_LINES, OFF = 21, 32, 1024, 4, 8


@dataclass
class Constants:
    """A polygon's constants. k: 8.24 with all upper bits; c, dc: 16.16, of the first line; q, dqdx, dqdy: 2.30,
    at pixel (left, top)."""

    k: tuple[int, int]
    c: tuple[int, int]
    dc: tuple[int, int]
    q: int
    dqdx: int
    dqdy: int
    left: int
    top: int
    every: str  # of LENGTHS
    coarse: int  # 0, COARSE or 2 COARSE
    raised: list[int]  # units by which u and v are raised, included in k
    even: bool = False  # q differs four times at most; q and C are shifted by one bit then
    down: int = 0  # lines from the top vertex to the first
    ahead: int = 0  # of the index, where even spans' pieces end

    @cached_property
    def words(self) -> list[list[int]]:
        """Even spans: C of each line, once asked for, half a word more, with its halves exchanged."""
        return []

    def first_index(self, pixels: int) -> int:
        """Even spans: the index from which pieces have so many pixels."""
        most = LENGTHS[self.every][pixels] >> 13
        return -(-2 * abs(self.dqdx) // most) if most else NEVER

    def words_at(self, n: int) -> tuple[int, int]:
        """Returns C of an even span's line, as words: the chain of both halves."""
        while len(self.words) <= n:
            self.words.append([step_swapped(c, swap(dc << 1 & M32)) for c, dc in zip(self.words[-1], self.dc)]
                              if self.words else [swap((c << 1) + 0x8000 & M32) for c in self.c])
        return tuple(signed(c, 16) for c in self.words[n])

    @property
    def leftwards(self) -> bool:
        """True if lines are drawn from right to left."""
        return self.dqdx < 0

    @property
    def less(self) -> int:
        """The bits that K lacks."""
        return max(self.coarse - COARSE, 0)


@dataclass
class Piece:
    """Pixels of a line from ``at`` on, counted from the far end; its q shifted by ``shift``, the indices of its
    beginning and end."""

    at: int
    pixels: int
    shift: int
    begin: int
    end: int
    is_first: bool  # the line begins here, or again


@dataclass
class Line:
    """A line's pixels left to left + n; q and C at its far end."""

    left: int
    n: int
    q: int
    c: tuple[int, int]  # 16.16
    way: int  # pixels and lines from the planes' own pixel to the far end
    down: int  # lines from the planes' own
    constants: Constants

    def words(self, shift: int) -> list[int]:
        """C as words."""
        if self.constants.even and not self.constants.coarse:
            return self.constants.words_at(self.down)
        return [signed(signed(c << shift) + 0x8000 >> 16, 16) for c in self.c]

    @cached_property
    def pieces(self) -> list[Piece]:
        """The line's pieces in drawing order."""
        found, at, dq = [], 0, abs(self.constants.dqdx)
        if self.constants.even:
            first = {m: self.constants.first_index(m) for m in (8, 16)}
            x, pixels = swap(self.q << 1 & M32 ^ 1 << 31), 4
            while at <= self.n:
                for m in (8, 16):
                    if pixels == m // 2 and signed(x, 16) + ORIGIN >= first[m]:
                        pixels = m
                        if at:
                            break
                begin, x = x, step_swapped(x, swap(dq * pixels << 1))
                begin, end = (signed(n, 16) + ORIGIN + self.constants.ahead for n in (begin, x))
                found.append(Piece(at, pixels, 1, begin if at else begin - self.constants.ahead, end, not at))
                at += pixels
            return found
        shift = 31 - self.q.bit_length() & ~1
        q = self.q << shift
        while True:
            pixels = next(m for m, most in LENGTHS[self.constants.every].items() if dq << shift <= most)
            step, x, is_first = swap(dq * pixels << shift), swap(q ^ 1 << 31), True
            while is_first or x & 0x8000:
                begin, x = x, step_swapped(x, step)
                found.append(Piece(at, pixels, shift, *(signed(n, 16) + ORIGIN for n in (begin, x)), is_first))
                at, is_first = at + pixels, False
                if at > self.n:
                    return found
            q, shift = (swap(x) ^ 1 << 31) >> 2, shift - 2


def least_of(p, way: int, exact: bool) -> int | None:
    """Returns the least q of a pixel; None if the polygon is too deep or too high, or q or the texels are too steep,
    for lines from their far ends. ``way``: lines and pixels of the box; ``exact``: edges are not rounded."""
    steep = steepness(p.q.dx) + 1
    least = p.least - way - (0 if exact else steep)
    if not p.corners.gentle or least < 1 << 29 - DEEP or p.most > (1 << 30) + steep or p.scale >= K_SCALE \
            or p.corners.down > DOWN:
        return None
    return least


def shift_of(p, dq: int, every: str, least: int) -> tuple[int, bool] | None:
    """Returns the bits by which q may have to be shifted left, and whether even spans draw the polygon; None if
    its steps are too great for that."""
    if least >= EVEN and dq << 1 <= LENGTHS[every][4]:
        return 1, True
    shift = max(0, 31 - least.bit_length() & ~1)
    return (shift, False) if steepness(p.q.dx) + 1 << shift <= MOST else None


def asymptotes(p, less: int = 0) -> list[int] | None:
    """Returns K of u and v, less their bases, in 2^(less - K_BITS) units; None if one is 4,096 texels, times 2^less,
    away or q hardly grows."""
    top, bottom, middle = p.corners.three
    (_, ay, *a), (_, by, *b) = ([n - m for n, m in zip(each, top)] for each in (bottom, middle))
    q, *st = (m * by - n * ay for m, n in zip(a, b))
    shift = 32 - (abs(q) >> 32).bit_length()
    if shift == 32:
        return None
    divisor, up = abs(q) << shift >> 32, shift + p.scale - less - K_SCALE
    found = []
    for grows in st:
        k = (abs(grows) << up if up >= 0 else abs(grows) >> -up) // divisor
        if k >> 31:
            return None
        found.append(-k if (grows < 0) != (q < 0) else k)
    return found


def to_farthest(p, ks: list[int], less: int = 0) -> list[int]:
    """Returns the whole texels from K of u and v to their farthest, rounded up. ``less``: as in ``asymptotes``."""
    texels = [k >> 16 + K_BITS - less for k in ks]
    return [max((high >> 16) - k, k - (low >> 16)) + 1 for k, low, high in zip(texels, p.low, p.high)]


def starts(p, ks: list[int], bits: int, less: int = 0) -> tuple[list[int], ...] | None:
    """Returns C of u and v on the first line, their growth a line, 16.16, and the rests of its division; None if that
    does not fit.
    ``less``: as in ``asymptotes``."""
    top, bottom, _ = p.corners.three
    cs, dcs, rests = [], [], []
    for k, *texels in zip(ks, *p.corners.texels[:2]):
        at, to = (((n << K_BITS >> less) - k) * corner[2] >> 32 - bits for n, corner in zip(texels, (top, bottom)))
        if signed(to - at) != to - at:
            return None
        height = bottom[1] - top[1]
        dc = cut_quotient(to - at << 16, height)
        if signed(dc) != dc:
            return None
        cs.append(at + (dc * p.corners.y >> 16))
        dcs.append(dc)
        rests.append((to - at << 16) - dc * height)
    return cs, dcs, rests


def ahead(dq: int, least: int, every: str) -> int:
    """Returns Constants.ahead; ``least``: the least q."""
    most = LENGTHS[every][16] >> 13
    if not most:  # a tolerance allows 8 pixels
        return 0
    if -(-2 * dq // most) <= least >> 15:  # all have 16: 16^2 dq / (4 least) pixels
        return (AHEAD[every] * (dq >> 9) * (dq >> 9) >> 2) // (least >> 8)
    return AHEAD[every] * dq >> (18 if every == "every16" else 19)


def find(p, every: str, box, exact: bool) -> Constants | None:
    """Returns the constants of a tmap.setup.perspective.Perspective, whose lines begin at the box's first;
    None if the polygon is drawn another way. ``every``: of LENGTHS; ``exact``: edges are not rounded."""
    lines = box[3] - box[1]
    way = lines + box[2] - box[0]
    q = [signed(n >> 32) for n in (p.q.at, p.q.dx, p.q.dy)]
    least = least_of(p, way, exact)
    shifted = least and shift_of(p, abs(q[1]), every, least)
    if not shifted:
        return None
    shift, even = shifted
    part = OFF_PART + (way + p.corners.off + OFF_CORNERS << shift >> 11)
    less, ks = 0, asymptotes(p)
    if ks is None or max(to_farthest(p, ks)) > REACH << COARSE:
        less, ks = COARSE, asymptotes(p, COARSE)
        if ks is None or max(to_farthest(p, ks, less)) > REACH << 2 * COARSE or abs(q[1]) < part << 14:
            return None
    farthest = to_farthest(p, ks, less)
    coarse = 2 * COARSE if less else COARSE if max(farthest) > REACH else 0
    found = starts(p, ks, BITS_COARSE if coarse else BITS, less)
    if not found:
        return None
    down = p.corners.down + OFF_LINES << shift
    off = OFF + (1 << shift << less) + (down >> 1 << less if coarse else OFF_WORD + (down >> 5))
    raised = [off + (n * part >> 2) for n in farthest]
    return Constants(tuple((k << 8 - K_BITS + less) + (b + m << 8) for b, k, m in zip(p.base, ks, raised)),
                     *map(tuple, found[:2]), *q, p.i, p.j, every, coarse, raised, even, p.corners.down - lines,
                     ahead(abs(q[1]), p.least, every) if even else 0)


def line(p, k: Constants, left: int, right: int, y: int) -> Line:
    """Returns a line's values; ``right`` is excluded."""
    far = right - 1 if k.leftwards else left
    q = k.q + (far - k.left) * k.dqdx + (y - k.top) * k.dqdy & M32
    return Line(left, right - 1 - left, q, tuple(signed(c + (y - k.top) * dc) for c, dc in zip(k.c, k.dc)),
                abs(far - k.left) + y - k.top, y - k.top, k)


def reciprocal_at(index: int) -> int:
    """Returns r."""
    return TABLE[index - LOWEST]


def bounds(lines: list[Line]) -> np.ndarray:
    """Returns the largest errors of the u or v of a polygon's lines against S / q of its planes, at the ends of their
    pieces, in 1/65536 texel: those of q's index (half of 1, and the steps' cuts), of r (half of 1), of C (the steps'
    cuts, and half a word; if it is coarse, only times what r has changed); a unit per pixel for u's
    steps and V's overflow, and 8 for K and the start."""
    k = lines[0].constants
    scale = 2.0**(k.coarse - 4)  # units of 1 in C r
    pieces = [piece for each in lines for piece in each.pieces]
    counts = [len(each.pieces) for each in lines]
    at, pixels, shift, begin, end, is_first = np.array(
        [(p.at, p.pixels, p.shift, p.begin, p.end, p.is_first) for p in pieces]).T
    ways, downs, cs = (np.repeat(each, counts) for each in np.array(
        [(each.way, each.down, max(abs(n) for n in each.c)) for each in lines]).T)
    up = (1 << shift) / 65536
    down = k.down + downs + OFF_LINES
    c = (cs + down) * up + 1
    cut = (ways + at + 2 * pixels) * up
    r = TABLE_ARRAY[np.array([begin, end]) - LOWEST]
    first = r[0][np.maximum.accumulate(np.where(is_first, np.arange(len(pieces)), 0))]
    off = scale * (c * r * ((0.5 + cut) / np.array([begin, end]) + 0.5 / r)
                   + (first - r if k.coarse else r) / 2 + r * down * up)
    most = np.maximum.reduceat(off.max(axis=0), np.cumsum([0, *counts[:-1]]))
    return np.array([each.n for each in lines]) + 8 + np.maximum(most, 0.0)


def coordinates(lines: list[Line]) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of the pixels of a polygon's lines, one after the other, 16.16 modulo 2^32; see ``chain``."""
    k, b, a, pieces = lines[0].constants, [], [], []
    for each in lines:
        for piece in each.pieces:
            old, r = reciprocal_at(piece.begin), reciprocal_at(piece.end)
            if piece.is_first:
                cs, words = [signed(c << piece.shift) for c in each.c], each.words(piece.shift)
                at = [base + (c * old >> 8 << k.coarse - COARSE if k.coarse else w * old << 4)
                      for base, c, w in zip(k.k, cs, words)]
                state = chain.begun(*at)
            du, dv = (w * (r - old) * (16 // piece.pixels) << k.coarse for w in words)
            count = min(each.n + 1 - piece.at, piece.pixels)
            state = chain.piece(state, du, dv, count, b, a)
            pieces.append((count, *at, du, dv))
            at = [at[0] + count * du, at[1] + count * dv]
    count, u, v, du, dv = np.array(pieces).T
    steps = counted(count)
    near = (np.repeat(at, count) + steps * np.repeat(step, count) for at, step in ((u, du), (v, dv)))
    return in_order(lines, *chain.values(np.array(b), np.array(a), *near))


def in_order(lines: list[Line], *drawn: np.ndarray) -> list[np.ndarray]:
    """Returns values of lines' pixels from left to right, given in drawing order."""
    if not lines[0].constants.leftwards:
        return list(drawn)
    counts = np.array([each.n + 1 for each in lines])
    ends = np.cumsum(counts)
    order = np.repeat(2 * ends - counts - 1, counts) - np.arange(ends[-1])
    return [each[order] for each in drawn]
