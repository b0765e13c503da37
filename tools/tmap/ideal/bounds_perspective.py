"""How far pixels with perspective may be from the exact curve.

1 unit = U = 1/2^16 texel. R is the range of u over the vertices. Q is the exact q of a pixel: 2^30
at the nearest vertex, and 22 bits less in the worst case.

**The first and the last pixel of a line.** u = base + S 2^scale / q:

* q of a corner is rounded (1/2), and S is the floor of its value with that q. With the pixel's
  barycentric coordinates l, the sum of |l| at most L, u is off by (sum of l (u_i - u) / 2) / Q,
  at most L R / 2Q, and by L 2^scale / Q. L is 1 in a triangle. With more vertices the
  coordinates of the planes' three are from -1 to 2 each: 3.
* The planes of q and S are off by e(gx) |x| + e(gy) |y| + 2/2^16 (two products cut to that),
  (x, y) being the way from the first corner and e(g) = |g| / 2^31 + 3/2^16, gradients in
  units of the value. q is also cut to a whole number. An error E of q moves S / q by
  |u - base| E. All these are over the drawn q, at least Q - E.
* The quotient is cut: 1 unit. Both u and q are clamped to the vertices' ranges; inside the
  polygon that changes nothing. Rounded edges may be beyond the exact one, and more than three
  vertices may be off the planes: there the exact value's distance from the range is added, and
  E is at least what Q lacks of the range; the drawn q lacks nothing.

* S is raised by the largest errors there of S and of q times u, and the base by a unit, so that u
  of a line's first pixel is never below the exact value. The bound grows by as much again, with S's
  errors as ``perspective.error_part`` rounds them up, 2^scale / Q units each.

The sums are b0 and b1.

**Between them** u = u0 + du * part. The weights are off by the errors of q and, for n steps, by n
and 2n of their 2^30, or of the rest of it at the far end. Let m be the factor by which this may
change the odds part / (1 - part); then the error by part is |du| (sqrt(m) - 1) / (sqrt(m) + 1) at
most. 3 units are added: part is cut to 2^-31, the product to 2 units.

    b = max(b0, b1) + |du| (sqrt(m) - 1) / (sqrt(m) + 1) + 3 U

Lines are raised by those 3 units, and in pieces by the cuts of their ends, so that a u that is
constant along a line is never below the exact value.

**Straight pieces** of m pixels: b and m - 1 units at their ends, and m units more for the last
one's cut steps, measured from the chords of the exact curve.

**Level lines**, and those that are straight from their first pixel to their last:
tools/tmap/ideal/bounds_level.py.

**Columns** are raised as the setting's lines are, which is added: where w of the vertices is rounded, so are
borders on which the exact values lie.

**From the far end** (tmap.setup.far): pieces are measured from the chords that begin at the line's
far end, the last one beyond its near end, and in even spans go through points that are a part of a pixel ahead.
``far.bounds`` are added, and what lines are raised by: they are never below the exact value at the far end. These are
added too, Q the far end's q, l its coordinates:

* q of the corners is rounded, and q's plane off by E, cut included: (sum of |l| R / 2 + E |u - K|) / Q.
* C = (u - K) q is exact at the top and the bottom but for what ``far.bounds`` has. So an error of K counts as far
  as q changes from the line between them to the pixel: at most its error times 2^30 / Q, 1/8 unit and |K| / 2^31
  for the quotient. Where K lacks bits it is 2 units, and u of the vertices is cut by 1. What S of the corners is
  cut by, up to 1 each, moves K by at most 2 2^scale h / N, N the quotient's divisor and h the height; q changes by
  N / h times l of the middle corner: 2 l 2^scale / Q.

**By cubics** (tmap.setup.cubic): ``cubic.bounds``, which has what the cubic may be off, what lines are raised by, and
what is added for K, C and q from the far end: at its first pixel a line is never below the exact value. All of it is
within the setting's 1/32 or 1/128 texel.

If the planes are not accurate enough (c/perspective/perspective.h), the polygon is drawn affine.
Then both the exact u and the drawn one are within L times the range R, except for the affine
plane's errors, and may be that far apart.

**A tolerance** (c/perspective/tolerance.c derives the errors): pieces longer than the setting's are
off by the tolerance at most between their ends; straight lines and triangles drawn affine are off
by it in addition to their own bounds.

**Straight pieces for curves**: where q grows so slowly that a piece's chord and its rounding, 4 m + 2 units for m
pixels, are within the setting's 1/32 or 1/128 texel (c/perspective/tolerance.c), pieces of 8 to 64 pixels are drawn.

**Curves**: a parabola through three points off by b each is off by 5/4 b. It is off from the curve
by the setting's 1/32 or 1/128 texel, its rounding included (see ``perspective.enough``).
"""

from dataclasses import dataclass
from math import log2, sqrt

import numpy as np

from tmap.base.fixed import signed
from tmap.ideal import ideal
from tmap.ideal.bounds_level import chords, level_bound, reciprocal_bound, straight_bound
from tmap.ideal.ideal import UNIT, gathered, inner_rows
from tmap.ideal.perspective import FLOAT, Curve, Rates, curves_through
from tmap.ideal.rows import Rows
from tmap.setup import afar, far
from tmap.setup.perspective import EXACT, Perspective, all_ends, raise_of, way

TOLERANCE = {"pixel": 1 / 32, "fine": 1 / 128}
BOUNDLESS = 32768.0  # texels: values are modulo twice that


def plane_error(plane, scale: int, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """The error of a plane x pixels and y lines from the first corner, in the value's units."""
    gradients = [abs(signed(g, 64)) / 2**scale for g in (plane.dx, plane.dy)]
    return sum(way * (g / 2**31 + 3 / 2**16) for way, g in zip((x, y), gradients)) + 2 / 2**16


@dataclass
class At:
    """Exact values of pixels, in units, and Q; how far S, in units times Q, and q are off. Behind the viewer values and
    Q are 0."""

    value: np.ndarray
    q: np.ndarray
    off_s: np.ndarray
    off_q: np.ndarray

    @property
    def is_ahead(self) -> np.ndarray:
        """True in front of the viewer."""
        return self.q > 0


class Bound:
    """The bounds of u or v of a polygon, for several pixels or lines at once. ``key``: 2 for u, 3 for v; ``three``:
    its corners."""

    def __init__(self, vertices, three, key: int, curve: Curve, p: Perspective) -> None:
        values = [v[key] for v in vertices]
        self.curve, self.p, self.plane = curve, p, (p.s, p.t)[key - 2]
        self.low, self.high = min(values), max(values)
        self.corner = [c * UNIT for c in three[0][:2]]
        self.three = [tuple(c * UNIT for c in v[:2]) for v in three]
        self.spread = 1 if len(vertices) == 3 else 3  # L
        # Q = 2^30 (least w) / w: ``unit`` is the factor from the curve's integers to it
        _, nearest = curve.terms(*three[0][:2])
        self.unit = 2.0**30 * min(v[4] for v in vertices) / three[0][4] / nearest
        self.base = p.base[key - 2]
        self.largest = max(abs(self.low - self.base), abs(self.high - self.base))

    def exact(self, i: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Returns the exact values at pixels, in units, and Q; 0 behind the viewer."""
        pairs = list(zip(*self.curve.terms_at(i, y)))
        return (np.array([n / q if q > 0 else 0.0 for n, q in pairs]),
                np.array([q * self.unit if q > 0 else 0.0 for _, q in pairs]))

    def at(self, i: np.ndarray, y: np.ndarray) -> At:
        """Returns the exact values at pixels, and how far the planes are off."""
        value, q = self.exact(i, y)
        x, down, scale = abs(i - self.corner[0]), abs(y - self.corner[1]), self.p.scale
        off_s = (plane_error(self.plane, scale, x, down) + self.spread
                 + self.p.raised[0 if self.plane is self.p.s else 1]) * 2**scale
        spread = np.maximum(self.high, value) - np.minimum(self.low, value)
        return At(value, q, off_s + self.spread / 2 * spread,
                  plane_error(self.p.q, 32, x, down) + 1 + self.spread / 2)

    def end(self, at: At) -> tuple[np.ndarray, np.ndarray]:
        """Returns b0 or b1 in units, and the largest relative errors of q."""
        beyond = np.maximum(0.0, np.maximum(at.value - self.high, self.low - at.value))
        off = np.maximum(at.off_q, self.p.least - at.q) / np.where(at.is_ahead, at.q, 1.0)
        return (np.where(at.is_ahead, self.quotient(at) + beyond, BOUNDLESS / UNIT),
                np.where(at.is_ahead, off, 0.5))

    def quotient(self, at: At) -> np.ndarray:
        """Returns the error of S / q before it is clamped, in units."""
        off_q = np.maximum(at.off_q, self.p.least - at.q)
        return (at.off_s + off_q * self.largest) / np.maximum(at.q - at.off_q, self.p.least) + 2

    def shares(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """The sums of the magnitudes of points' barycentric coordinates: 1 inside the corners."""
        areas = [(bx - ax) * (y - ay) - (by - ay) * (x - ax)
                 for (ax, ay), (bx, by) in zip(self.three, self.three[1:] + self.three[:1])]
        return sum(map(abs, areas)) / abs(sum(areas))

    def afar(self, drawn: Rows, k) -> np.ndarray:
        """Returns what K, C and q of lines from their far ends, with constants k, add to ``far.bounds``, in units."""
        key, y, ends = 0 if self.plane is self.p.s else 1, drawn.ys, (drawn.lefts, drawn.ends - 1)
        first = ends[k.leftwards]
        exact, big = self.exact(first, y)
        high, low = np.maximum(self.high, exact), np.minimum(self.low, exact)
        at = k.k[key] / 256 - k.raised[key]
        off_q = plane_error(self.p.q, 32, abs(first - self.corner[0]), abs(y - self.corner[1])) + 1
        share = np.maximum(*(self.shares(x, y) for x in ends))
        found = ((share * ((high - low) / 2 + 2 * 2.0**self.p.scale) + off_q * np.maximum(high - at, at - low))
                 + (2.0**k.less / 8 + (k.less > 0) + abs(at - self.base) / 2**31) * 2**30)
        return np.where(big > 0, found / np.where(big > 0, big, 1.0) + 1, BOUNDLESS / UNIT)

    def lines(self, polygon, drawn: Rows) -> np.ndarray:
        """Returns b of lines' pixels, texels."""
        made = all_ends(self.p, drawn.lefts, drawn.ends, drawn.ys)
        first, last, way = np.array([(each.weight(0), each.weight(each.n), abs(
            each.du if self.plane is self.p.s else each.dv)) for each in made], float).reshape(-1, 3).T
        (b0, e0), (b1, e1) = (self.end(self.at(x, drawn.ys)) for x in (drawn.lefts, drawn.ends - 1))
        n = drawn.counts - 1
        several = n > 0
        first, last = (np.where(several, each, 1.0) for each in (first + n, last + 2 * n))
        lost = 1 - (1 - n / first) * (1 - 2 * n / last)
        is_small = e0 + e1 + lost < 0.5
        e0, e1, lost = (np.where(is_small, each, 0.0) for each in (e0, e1, lost))
        odds = np.sqrt((1 + e0) * (1 + e1) / ((1 - e0) * (1 - e1) * (1 - lost)))
        part = np.where(is_small, (odds - 1) / (odds + 1), 1.0)
        found = np.minimum((np.maximum(b0, b1) + way * part + 3) * UNIT, BOUNDLESS)
        return np.where(several, found, b0 * UNIT)


def intended(rates: Rates, drawn: Rows, setting: str) -> np.ndarray:
    """A setting's intended error at lines' pixels: straight pieces through exact values, minus these; else 0;
    texels."""
    if setting not in EXACT:
        return np.zeros(len(drawn.columns))
    k, n = drawn.columns - drawn.spread(drawn.lefts), drawn.spread(drawn.counts - 1)
    begin = np.where(k == n, n, k // EXACT[setting] * EXACT[setting])
    end = np.minimum(begin + EXACT[setting], n)
    away = drawn.spread(drawn.lefts - rates.columns)
    at, to, exact = (rates.moved(away + x, drawn) for x in (begin, end, k))
    return at + (to - at) / np.maximum(end - begin, 1) * (k - begin) - exact


def intended_from_afar(rates: Rates, records: list[far.Line], drawn: Rows) -> np.ndarray:
    """The intended error of lines that are drawn from their far ends: the last piece is a whole one's
    beginning, and ends of pieces may be ahead."""
    k = records[0].constants
    counts = [len(each.pieces) for each in records]
    at, pixels = np.array([(piece.at, piece.pixels) for each in records for piece in each.pieces]).T
    row = np.repeat(np.arange(len(records)), counts)
    way, first = (-1, drawn.ends - 1) if k.leftwards else (1, drawn.lefts)
    ahead = k.ahead * 2.0**15 / abs(k.dqdx) if k.ahead else 0.0  # pixels
    rate = Rates(rates.columns[row], [], [], rates.first[row], rates.ratio[row])
    begin, end = (rate.moved(first[row] - rate.columns + way * (x + ahead * (x > 0))) for x in (at, at + pixels))
    which = np.repeat(np.arange(len(row)), np.minimum(pixels, drawn.counts[row] - at))  # each pixel's piece
    steps = np.arange(len(which)) - drawn.starts[row[which]]  # from the far end
    column = first[row[which]] + way * steps
    slope = (end - begin) / pixels
    found = begin[which] + slope[which] * (steps - at[which])
    wanted = np.empty(len(which))
    wanted[column + (drawn.starts - drawn.lefts)[row[which]]] = found
    return wanted - rates.moved(drawn.columns - drawn.spread(rates.columns), drawn)


def bend(setting: str, piece: int) -> float:
    """Returns 64 log2 of a curve's error over the part of the tolerance that is left for it, if the
    other factors of the error (see ``perspective.enough``) are 1. Its longest piece has 2^piece
    pixels. The second difference is off by half a unit, times the square of half the length; 8
    units are for the three points."""
    left = TOLERANCE[setting] / UNIT - (1 << piece - 1)**2 / 2 - 8
    return 64 * log2(6 / (9 * sqrt(3)) / left)


def line_bound(b: np.ndarray, setting: str) -> np.ndarray:
    """Returns the largest errors of pixels against the intended values, in texels."""
    b = b + raise_of(setting) * UNIT
    if setting in EXACT:
        return b + 2 * EXACT[setting] * UNIT + FLOAT
    return 1.25 * b + TOLERANCE[setting] + FLOAT


def exchanged(vertices) -> list[tuple]:
    """Returns vertices with x and y exchanged."""
    return [(v[1], v[0], *v[2:]) for v in vertices]


@dataclass
class Errors:
    """u or v (``key``) at the pixels of a polygon's lines: found, 16.16; its error, the intended one and the bound of
    each line, in texels."""

    key: str
    found: np.ndarray
    error: np.ndarray
    wanted: np.ndarray
    allowed: np.ndarray


def all_errors(vertices, polygon, tolerance: float = 0.0) -> tuple[Rows, list[Errors]]:
    """Returns the pixels of lines inside the exact polygon, and the errors of u and of v there. Lines are columns of
    the frame if they are drawn.
    ``vertices``: from ``model.adapt``, in front of the viewer."""
    three, raised = [vertices[k] for k in ideal.corners(vertices)], 0
    if polygon.columns:
        polygon, three, vertices = polygon.columns, exchanged(three), exchanged(vertices)
        raised = way(polygon.setting).raised
    p = polygon.perspective
    numbers, rows, drawn = inner_rows(vertices, polygon)
    made = []
    if not numbers:
        return rows, made
    seen, n = rows.inside(drawn), drawn.counts - 1
    records = [polygon.records[k] for k in numbers] if polygon.constants else []
    more = (afar.model_of(polygon.constants).bounds(records) + max(polygon.constants.raised)) * UNIT \
        if records and not polygon.is_level else 0
    both = curves_through(three)
    # an end on a rounded edge may be behind the viewer
    sure = np.logical_and(*(np.array([q > 0 for q in both[0].terms_at(x, drawn.ys)[1]])
                            for x in (drawn.lefts, drawn.ends - 1)))
    for key, curve, found in zip((2, 3), both, gathered(polygon, numbers, rows, drawn)):
        bound, rates = Bound(vertices, three, key, curve, p), curve.rates(drawn)
        error, wanted = curve.row_errors(found, rows), np.zeros(len(found))
        if polygon.is_level:
            b = (reciprocal_bound if p.inverse else straight_bound)(bound, drawn.lefts, n, drawn.ys) * UNIT
            if p.tilt:
                wanted = chords(rates, drawn)[seen]
            allowed = (level_bound(b, polygon.setting if p.q.dx and not p.tilt else "", n, p.chained)
                       + tolerance * polygon.straight + raised * UNIT)
        else:
            if not records:
                wanted = intended(rates, drawn, polygon.exact)[seen]
            elif isinstance(records[0], far.Line):
                wanted = intended_from_afar(rates, records, drawn)[seen]
            allowed = (more + bound.afar(drawn, polygon.constants) * UNIT + FLOAT if records else
                       line_bound(bound.lines(polygon, drawn), polygon.exact))
            wanted, allowed = np.where(rows.spread(sure), wanted, 0.0), np.where(sure, allowed, BOUNDLESS)
        made.append(Errors("uv"[key - 2], found, error, wanted, allowed))
    return rows, made


def line_errors(vertices, polygon, tolerance: float = 0.0):
    """Yields (u or v, line, pixels, found, error, intended error, bound) of ``all_errors``, line by line: arrays over
    the pixels, the bound a number."""
    rows, made = all_errors(vertices, polygon, tolerance)
    for number, y in enumerate(rows.ys.tolist()):
        part = rows.part(number)
        for each in made:
            yield (each.key, y, rows.columns[part], each.found[part], each.error[part], each.wanted[part],
                   float(each.allowed[number]))


def errors_by_lines(vertices, polygon):
    """Yields (u or v, line of the frame, its pixels, error, intended error, bound), arrays over the pixels, of
    ``line_errors``."""
    every = ((key, y, columns, error, wanted, allowed + 0 * error)
             for key, y, columns, _, error, wanted, allowed in line_errors(vertices, polygon))
    if not polygon.columns:
        yield from every
        return
    lines = {}
    for key, x, rows, *arrays in every:
        for y, *values in zip(rows.tolist(), *arrays):
            lines.setdefault((key, y), []).append((x, *values))
    for (key, y), pixels in lines.items():
        columns, *arrays = zip(*pixels)
        yield key, y, np.array(columns), *map(np.array, arrays)
