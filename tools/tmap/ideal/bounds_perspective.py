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
``bound`` is added, and what lines are raised by: they are never below the exact value at the far end. These are
added too, Q the far end's q, l its coordinates:

* q of the corners is rounded, and q's plane off by E, cut included: (sum of |l| R / 2 + E |u - K|) / Q.
* C = (u - K) q is exact at the top and the bottom but for what ``far.bound`` has. So an error of K counts as far
  as q changes from the line between them to the pixel: at most its error times 2^30 / Q, 1/8 unit and |K| / 2^31
  for the quotient. Where K lacks bits it is 2 units, and u of the vertices is cut by 1. What S of the corners is
  cut by, up to 1 each, moves K by at most 2 2^scale h / N, N the quotient's divisor and h the height; q changes by
  N / h times l of the middle corner: 2 l 2^scale / Q.

**By cubics** (tmap.setup.cubic): ``cubic.bound``, which has what the cubic may be off, what lines are raised by, and
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
from tmap.ideal import bounds_fetched, ideal
from tmap.ideal.bounds_level import chord, level_bound, reciprocal_bound, straight_bound
from tmap.ideal.ideal import UNIT
from tmap.ideal.perspective import FLOAT, Curve, curves, curves_through
from tmap.setup import afar, cubic, far, spans
from tmap.setup.perspective import EXACT, Ends, Perspective, ends, raise_of, way

TOLERANCE = {"pixel": 1 / 32, "fine": 1 / 128}
BOUNDLESS = 32768.0  # texels: values are modulo twice that


def plane_error(plane, scale: int, x: float, y: float) -> float:
    """The error of a plane x pixels and y lines from the first corner, in the value's units."""
    gradients = [abs(signed(g, 64)) / 2**scale for g in (plane.dx, plane.dy)]
    return sum(way * (g / 2**31 + 3 / 2**16) for way, g in zip((x, y), gradients)) + 2 / 2**16


@dataclass
class At:
    """A pixel's exact value, in units, and Q, 0 behind the viewer; how far S, in units times Q, and q are off."""

    value: float
    q: float
    off_s: float
    off_q: float


class Bound:
    """The bounds of u or v of a polygon. ``key``: 2 for u, 3 for v; ``three``: its corners."""

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

    def at(self, i: int, y: int) -> At:
        """Returns the exact values at a pixel, and how far the planes are off."""
        n, q = self.curve.terms(i << 16, y << 16)
        if q <= 0:
            return At(0.0, 0.0, 0.0, 0.0)
        x, down, scale = abs(i - self.corner[0]), abs(y - self.corner[1]), self.p.scale
        off_s = (plane_error(self.plane, scale, x, down) + self.spread
                 + self.p.raised[0 if self.plane is self.p.s else 1]) * 2**scale
        spread = max(self.high, n / q) - min(self.low, n / q)
        return At(n / q, q * self.unit, off_s + self.spread / 2 * spread,
                  plane_error(self.p.q, 32, x, down) + 1 + self.spread / 2)

    def end(self, i: int, y: int) -> tuple[float, float]:
        """Returns b0 or b1 in units, and the largest relative error of q."""
        at = self.at(i, y)
        if at.q <= 0:
            return BOUNDLESS / UNIT, 0.5
        beyond = max(0.0, at.value - self.high, self.low - at.value)
        return self.quotient(at) + beyond, max(at.off_q, self.p.least - at.q) / at.q

    def quotient(self, at: At) -> float:
        """Returns the error of S / q before it is clamped, in units."""
        off_q = max(at.off_q, self.p.least - at.q)
        return (at.off_s + off_q * self.largest) / max(at.q - at.off_q, self.p.least) + 2

    def shares(self, x: float, y: float) -> float:
        """The sum of the magnitudes of a point's barycentric coordinates: 1 inside the corners."""
        areas = [(bx - ax) * (y - ay) - (by - ay) * (x - ax)
                 for (ax, ay), (bx, by) in zip(self.three, self.three[1:] + self.three[:1])]
        return sum(map(abs, areas)) / abs(sum(areas))

    def afar(self, made: far.Line, y: int, key: int) -> float:
        """Returns what K, C and q of a line from its far end add to ``far.bound``, in units. ``key``: 0 for u, 1
        for v."""
        k, ends = made.constants, (made.left, made.left + made.n)
        first = ends[k.leftwards]
        n, q = self.curve.terms(first << 16, y << 16)
        if q <= 0:
            return BOUNDLESS / UNIT
        exact, big = n / q, q * self.unit
        high, low = max(self.high, exact), min(self.low, exact)
        at = k.k[key] / 256 - k.raised[key]
        off_q = plane_error(self.p.q, 32, abs(first - self.corner[0]), abs(y - self.corner[1])) + 1
        share = max(self.shares(x, y) for x in ends)
        return ((share * ((high - low) / 2 + 2 * 2.0**self.p.scale) + off_q * max(high - at, at - low)) / big
                + (2.0**k.less / 8 + (k.less > 0) + abs(at - self.base) / 2**31) * 2**30 / big + 1)

    def line(self, made: Ends, y: int) -> float:
        """Returns b of a line's pixels, texels."""
        (b0, e0), (b1, e1) = (self.end(i, y) for i in (made.left, made.left + made.n))
        if not made.n:
            return b0 * UNIT
        way = abs(made.du if self.plane is self.p.s else made.dv)
        first, last = made.weight(0) + made.n, made.weight(made.n) + 2 * made.n
        lost = 1 - (1 - made.n / first) * (1 - 2 * made.n / last)
        part = 1.0
        if e0 + e1 + lost < 0.5:
            odds = sqrt((1 + e0) * (1 + e1) / ((1 - e0) * (1 - e1) * (1 - lost)))
            part = (odds - 1) / (odds + 1)
        return min((max(b0, b1) + way * part + 3) * UNIT, BOUNDLESS)


def intended(values: np.ndarray, setting: str) -> np.ndarray:
    """A setting's intended error at a line's pixels: straight pieces through exact values, minus
    these; else 0; texels."""
    n = len(values) - 1
    if not n or setting not in EXACT:
        return np.zeros(n + 1)
    nodes = np.array([*range(0, n, EXACT[setting]), n])
    return np.interp(np.arange(n + 1), nodes, values[nodes]) - values


def intended_from_afar(curve: Curve, record: far.Line, y: int) -> np.ndarray:
    """The intended error of a line that is drawn from its far end: its last piece is a whole one's
    beginning, and ends of pieces may be ahead."""
    way, k = -1 if record.constants.leftwards else 1, record.constants
    first = record.left + (record.n if way < 0 else 0)
    last = record.pieces[-1]
    nodes = np.array([*(piece.at for piece in record.pieces), last.at + last.pixels])
    ahead = k.ahead * 2.0**15 / abs(k.dqdx) * (nodes > 0)  # pixels
    values = np.interp(np.arange(record.n + 1), nodes, curve.values(first + way * (nodes + ahead), y))
    return values[::way] - curve.values(record.left + np.arange(record.n + 1), y)


def bend(setting: str, piece: int) -> float:
    """Returns 64 log2 of a curve's error over the part of the tolerance that is left for it, if the
    other factors of the error (see ``perspective.enough``) are 1. Its longest piece has 2^piece
    pixels. The second difference is off by half a unit, times the square of half the length; 8
    units are for the three points."""
    left = TOLERANCE[setting] / UNIT - (1 << piece - 1)**2 / 2 - 8
    return 64 * log2(6 / (9 * sqrt(3)) / left)


def line_bound(b: float, setting: str) -> float:
    """Returns the largest error of pixels against the intended values, in texels."""
    b += raise_of(setting) * UNIT
    if setting in EXACT:
        return b + 2 * EXACT[setting] * UNIT + FLOAT
    return 1.25 * b + TOLERANCE[setting] + FLOAT


def inner_lines(vertices, polygon):
    """Yields, for each line with pixels inside the exact polygon: y, the line, and both ends of the pixels that
    are in both."""
    exact = ideal.extents(vertices)
    for y, line in enumerate(polygon.lines, polygon.top):
        extent = [-(-n // (d << 16)) for n, d in exact(y)]
        left, right = max(line.left, extent[0]), min(line.right, extent[1])
        if left < right:
            yield y, line, left, right


def exchanged(vertices) -> list[tuple]:
    """Returns vertices with x and y exchanged."""
    return [(v[1], v[0], *v[2:]) for v in vertices]


def line_errors(vertices, polygon, tolerance: float = 0.0):
    """Yields (u or v, line, pixels, found, error, intended error, bound) for each line inside the
    exact polygon: arrays over the pixels, the bound a number; in texels, found in 16.16. Lines are columns of the
    frame if they are drawn.
    ``vertices``: from ``model.adapt``, in front of the viewer."""
    three, raised = [vertices[k] for k in ideal.corners(vertices)], 0
    if polygon.columns:
        polygon, three, vertices = polygon.columns, exchanged(three), exchanged(vertices)
        raised = way(polygon.setting).raised
    p = polygon.perspective
    bounds = [Bound(vertices, three, key, curve, p) for key, curve in zip((2, 3), curves_through(three))]
    for y, line, left, right in inner_lines(vertices, polygon):
        made = ends(p, line.left, line.right, y)
        columns, drawn = np.arange(left, right), np.arange(line.left, line.right)
        seen = slice(left - line.left, right - line.left)
        record = polygon.record(line, y)
        more = 0
        if record:
            more = (afar.model_of(polygon.constants).bound(record) + max(polygon.constants.raised)) * UNIT
        for key, bound, found in zip("uv", bounds, polygon.coordinates(line, y)):
            error = bound.curve.errors(found[seen], columns, y)
            if polygon.is_level:
                b = (reciprocal_bound if p.inverse else straight_bound)(bound, made.left, made.n, y) * UNIT
                yield (key, y, columns, found[seen], error, chord(bound.curve, drawn, y)[seen] if p.tilt else 0 * error,
                       level_bound(b, polygon.setting if p.q.dx and not p.tilt else "", made.n, p.chained)
                       + tolerance * polygon.straight + raised * UNIT)
                continue
            if all(bound.curve.terms(i << 16, y << 16)[1] > 0 for i in drawn[[0, -1]].tolist()):
                if record:
                    wanted = (intended_from_afar(bound.curve, record, y)[seen] if isinstance(record, far.Line)
                              else 0 * error)
                    allowed = more + bound.afar(record, y, "uv".index(key)) * UNIT + FLOAT
                else:
                    wanted = intended(bound.curve.values(drawn, y), polygon.exact)[seen]
                    allowed = line_bound(bound.line(made, y), polygon.exact)
            else:  # an end on a rounded edge is behind the viewer
                wanted, allowed = 0 * error, BOUNDLESS
            yield key, y, columns, found[seen], error, wanted, allowed


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


def falls_short(polygon, y: int, columns: np.ndarray, error: np.ndarray) -> bool:
    """Returns true if a triangle's line is below the exact value where it must not be: at the pixel that
    is drawn first, or at any pixel if depth does not change."""
    line = polygon.lines[y - polygon.top]
    record = None if polygon.is_level else polygon.record(line, y)
    if polygon.is_level:
        sure = error[:len(error) if not polygon.perspective.q.dx else 0]
    elif isinstance(record, (far.Line, cubic.Line)) and record.constants.leftwards:
        sure = error[-1:] if columns[-1] == line.right - 1 else error[:0]
    else:
        sure = error[:int(columns[0] == line.left)]
    return bool((sure < -FLOAT).any())


def check_shown(key: str, y: int, left: int, found: np.ndarray, off: np.ndarray, allowed: float,
                size: tuple[int, int], out) -> None:
    """Judges the fetched texels of a line; ``off``: errors of u or v, ``allowed``: the most."""
    side = size["uv".index(key)]
    bounds_fetched.judge(key, spans.repeated(found, side), found, off, side, left, y,
                         (allowed, allowed), out)


def check_texels(vertices, polygon, asked: str, tolerance: float, size: tuple[int, int],
                 out) -> None:
    """Adds the error of u and v at every pixel inside the exact polygon to a Verdict, and judges
    the texels; ``asked``: the material's setting, ``tolerance``: in texels, ``size``: the map's."""
    drawn = polygon.columns or polygon
    kind = "column" if polygon.columns else "line"
    for key, y, columns, found, error, wanted, allowed in line_errors(vertices, polygon, tolerance):
        bent = float(abs(wanted).max())
        if polygon.setting in TOLERANCE and bent > TOLERANCE[polygon.setting]:
            out.complain(f"{key} on {kind} {y}: pieces of {polygon.exact} for {polygon.setting} bend {bent:.9f} texels")
        if polygon.setting != asked and bent > tolerance + FLOAT:
            out.complain(f"{key} on {kind} {y}: pieces of {polygon.setting} instead of {asked} "
                         f"bend {bent:.9f} texels, the tolerance is {tolerance:.9f}")
        k = int(abs(error).argmax())
        out.note(abs(error[k]), min(abs(wanted[k]) + allowed, BOUNDLESS))
        if allowed >= BOUNDLESS:
            continue
        if len(vertices) == 3 and falls_short(drawn, y, columns, error):
            out.complain(f"{key} on {kind} {y} is {-error.min():.9f} below the exact value")
        check_shown(key, y, int(columns[0]), found, error - wanted, allowed, size, out)
        off = abs(error - wanted)
        k = int(off.argmax())
        out.texel_ratio = max(out.texel_ratio, float(off[k] / allowed))
        if off[k] > allowed:
            out.complain(f"{key} at pixel {columns[k]} of {kind} {y} is {off[k]:.9f} off what the "
                         f"setting intends, {allowed:.9f} are allowed")


def check_flattened(vertices, polygon, tolerance: float | None, size: tuple[int, int], out) -> None:
    """Judges a polygon that is drawn affine though w differs: by its tolerance, or (None) because
    its planes are not accurate enough; out.unsure counts those."""
    out.unsure += tolerance is None
    spread, t = 1 if len(vertices) == 3 else 3, polygon.texturing
    both, planes = curves(vertices), [ideal.plane_of(vertices, key) for key in (2, 3)]
    for y, line, left, right in inner_lines(vertices, polygon):
        columns, seen = np.arange(left, right), slice(left - line.left, right - line.left)
        for key, curve, plane, found in zip((2, 3), both, planes, polygon.coordinates(line, y)):
            values = [v[key] for v in vertices]
            bound = max(plane.bound(i, y, t, t.cuts[key - 2]) for i in (left, right - 1)) + (
                spread * (max(values) - min(values)) * UNIT if tolerance is None else tolerance)
            error = curve.errors(found[seen], columns, y)
            check_shown("uv"[key - 2], y, left, found[seen], error, bound, size, out)
            error = abs(error)
            k = int(error.argmax())
            out.note(error[k], bound)
            out.texel_ratio = max(out.texel_ratio, float(error[k]) / bound)
            if error[k] > bound:
                out.complain(f"{'uv'[key - 2]} at pixel ({columns[k]}, {y}) of a polygon drawn affine is "
                             f"{error[k]:.9f} off, {bound:.9f} are allowed")
