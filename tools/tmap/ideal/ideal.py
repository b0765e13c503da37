"""The exact rational ideal of a polygon, and the bounds of the renderer's errors against it.

Nothing here is rounded: edges are intersected and the texture plane is evaluated in
integers over one common denominator. It shares no arithmetic with tools/tmap/model/model.py.

A pixel (i, j) is inside when ceil(left) <= i < ceil(right) and ceil(top) <= j <
ceil(bottom), left and right being the polygon's exact extent on line j. The texture
plane passes through the top vertex, the bottom vertex and the vertex farthest from the
line between them (three vertices are enough for a polygon whose texture is planar; others
are judged as their triangles, see tools/tmap/ideal/planarity.py).

The bounds are derived in pixels and texels, with 1 unit = 1/2^16:

* Edge, n lines below its first in the frame: its x starts at the nearest unit (1/2) and
  steps by a slope rounded to the nearest unit (n/2): (n + 1) / 2^17 pixels.
* Plane gradient g: the divisor is cut to 32 bits (|g| / 2^31), the numerator by as many bits
  (1 in a divisor of 2^31 or more: 2/2^32 texels per pixel), the quotient is cut to
  1/2^32: e(g) = |g| / 2^31 + 3/2^32. Gentle gradients, below 16 texels per pixel, have 26 bits of
  fraction in spans: the divisor is cut to 31 bits (16 / 2^30, one way), the numerator to 32 and the
  divisor's reciprocal to 31 (half of 1/2^26 each, the other way), the product to 1/2^26: e(g) = 2.5/2^26.
* Step: the gradient rounded to a multiple of 1/2^16 texel, or of more units if the spans drop low
  bits: 2 for u if its lowest bit is free for a wrap of v, 2 for v of tiles, 8 for columns, 4
  for levels of light. The error is d(g) = |g - the nearest one| + 2 e(g) per pixel: by e(g) or
  2 e(g), the other of two almost equally near ones may be chosen.
* Reference pixel, (x, y) away from the first vertex: two products, each rounded to half a unit, and
  the gradients' errors over that way: 1/2^16 + |x| e(gx) + |y| e(gy). It is the middle of the box, with
  gentle gradients the first pixel right of the left side on the first line.
* So at pixel (i, j), before u is raised: the error of the reference, and |i - i_ref| steps in x and
  |j - j_ref| steps in y.
* u is raised by the largest such error anywhere in the box. With w and h the ways from the
  reference to the box's sides and a = |x| + |y| + w + h + 2, that is w d(gx) + h d(gy) + 3/2^16 +
  (|gx| + |gy| + 5) a 2/2^32 at most. Gentle gradients: w and h are the ways to the farthest sides, and
  each of their pixels counts half of a step's multiple m, whatever the step: ((w + h) m/2 + 5)/2^16, as
  a e(g) is at most 3.1/2^16. Then u is raised to a multiple: by less than that multiple, and by 1/2^16 if the free bit is
  set.

So a drawn value is never below the exact one, and above it by the sum of the last two points at
most. If a gradient is 2^30 texels per pixel or more it may be below as well.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache, partial
from itertools import repeat
from typing import TypeVar

import numpy as np

from tmap.ideal.rows import Rows
from tmap.model import model
from tmap.model.model import Polygon, Settings
from tmap.setup.texturing import RAISED

UNIT = 1 / 65536
Number = TypeVar("Number", float, np.ndarray)
NEVER = 1 << 40  # beyond all columns


def extent(vertices, line: int, scale: int = 1) -> tuple[tuple[int, int], tuple[int, int]]:
    """Returns the exact left and right x on a line, each as (numerator, denominator > 0), 16.16; of vertices that are
    ``scale`` times as large ``scale`` times x."""
    y = (line << 16) * scale
    found = []
    for (x0, y0, *_), (x1, y1, *_) in zip(vertices, [*vertices[1:], vertices[0]]):
        if y0 > y1:
            x0, y0, x1, y1 = x1, y1, x0, y0
        if y0 <= y <= y1 and y0 < y1:
            found.append((x0 * (y1 - y0) + (x1 - x0) * (y - y0), y1 - y0))
        elif y0 == y == y1:
            found += [(x0, 1), (x1, 1)]

    def below(a, b):
        return a[0] * b[1] < b[0] * a[1]

    left = right = found[0]
    for x in found[1:]:
        left = x if below(x, left) else left
        right = x if below(right, x) else right
    return left, right


@lru_cache(64)
def first_pixels_of(outline: tuple, top: int, end: int) -> np.ndarray:
    """``first_pixels`` of an outline, whose other settings need it again."""
    found = np.empty((2, end - top), np.int64)
    found[:] = (NEVER,), (-NEVER,)
    fits = max(abs(c) for point in outline for c in point) <= 1 << 30  # products are below 2^62
    for (x0, y0), (x1, y1) in zip(outline, [*outline[1:], outline[0]]):
        if y0 > y1:
            x0, y0, x1, y1 = x1, y1, x0, y0
        first, last = max(-(-y0 >> 16), top), min(y1 >> 16, end - 1)
        if first > last:
            continue
        lines, height = np.arange(last + 1 - first, dtype=np.int64 if fits else object), y1 - y0
        if height:
            n = x0 * height + (x1 - x0) * ((first << 16) - y0) + (x1 - x0 << 16) * lines
            columns = (-(-n // (height << 16))).astype(np.int64)
        else:
            columns = np.array([[-(-min(x0, x1) >> 16)], [-(-max(x0, x1) >> 16)]])
        part = found[:, first - top:last + 1 - top]
        low, high = columns if not height else (columns, columns)
        part[:] = np.minimum(part[0], low), np.maximum(part[1], high)
    found.flags.writeable = False
    return found


def first_pixels(vertices, top: int, end: int) -> np.ndarray:
    """Returns the first pixels at or right of the exact left, and right, x on lines ``top`` to ``end`` - 1: int64,
    2 rows. A line that the polygon does not meet has NEVER as its left and -NEVER as its right."""
    return first_pixels_of(tuple(tuple(v[:2]) for v in vertices), top, end)


@lru_cache(64)
def extents_of(outline: tuple) -> Callable:
    """Returns ``extent`` for the lines of an outline. Each line is computed once, as drawings with
    other settings need it again."""
    return cache(partial(extent, outline))


def extents(vertices) -> Callable:
    """Returns the function ``extent`` of a line, for these vertices."""
    return extents_of(tuple(tuple(v[:2]) for v in vertices))


@dataclass(frozen=True)
class Crossing:
    """An edge where it crosses a line: its ends (x, y, ...), the line, and the exact x as
    numerator / denominator; all 16.16 except the line."""

    upper: tuple
    lower: tuple
    line: int
    numerator: int
    denominator: int

    @property
    def column(self) -> int:
        """The first pixel at or right of the edge."""
        return -(-self.numerator // (self.denominator << 16))

    def distance(self, column: int) -> Fraction:
        """Returns the distance from a pixel's centre to the edge, along the line; units."""
        return abs(Fraction(self.numerator, self.denominator) - (column << 16))

    def slack(self, settings: Settings, width: int, height: int) -> Fraction:
        """Returns how far from here the renderer's edge may be: (n + 1) / 2 units if it is
        stepped, and the moves by cutting vertices. A cut at the frame's left or right border
        moves a vertex by half a unit down or up, and so the edge by half a slope along the
        line. A cut at its top or bottom moves it by half a unit along the line. Later cuts
        start from the moved edge, so the moves add up."""
        slack = Fraction(0)
        if not settings.has_exact_edges:
            slack += Fraction(self.line - max(-(-self.upper[1] // 65536), 0) + 1, 2)
        if settings.clip == "vertices" and not settings.has_exact_edges:
            slope = Fraction(abs(self.lower[0] - self.upper[0]), self.denominator)
            for axis, limit, move in ((0, width, slope), (1, height, 1)):
                ends = sorted((self.upper[axis], self.lower[axis]))
                slack += sum(ends[0] < at < ends[1] for at in (-65536, limit << 16)) * move / 2
        return slack

    def near(self, column: int, settings: Settings, width: int, height: int) -> bool:
        """True if a pixel may be on the other side of the renderer's edge than of this one."""
        slack = self.slack(settings, width, height)
        return slack > 0 and self.distance(column) <= slack


def crossings(vertices, line: int) -> list[Crossing]:
    """Returns the edges of a polygon, convex or not, that cross a line. An edge's lines are those
    at or below its upper vertex and above its lower one."""
    found = []
    for a, b in zip(vertices, [*vertices[1:], vertices[0]]):
        upper, lower = (a, b) if a[1] < b[1] else (b, a)
        if upper[1] <= line << 16 < lower[1]:
            height = lower[1] - upper[1]
            x = upper[0] * height + (lower[0] - upper[0]) * ((line << 16) - upper[1])
            found.append(Crossing(upper, lower, line, x, height))
    return found


def coverage(outline, width: int, height: int) -> np.ndarray:
    """Returns how often a polygon, convex or not, covers each pixel of a frame: int, [y][x]."""
    counts = np.zeros((height, width + 1), int)
    ys = [v[1] for v in outline]
    for y in range(max(-(-min(ys) // 65536), 0), min(-(-max(ys) // 65536), height)):
        columns = sorted(min(max(c.column, 0), width) for c in crossings(outline, y))
        for left, right in zip(columns[::2], columns[1::2]):
            counts[y, left] += 1
            counts[y, right] -= 1
    return counts.cumsum(axis=1)[:, :width]


def corners(vertices) -> tuple[int, int, int]:
    """Returns top, bottom and the vertex farthest from the line between them, as indices."""
    order = sorted(range(len(vertices)), key=lambda k: (vertices[k][1], vertices[k][0]))
    top = order[0]
    lowest = vertices[order[-1]][1]
    bottom = min((k for k in order if vertices[k][1] == lowest), key=lambda k: vertices[k][0])
    (ax, ay, *_), (bx, by, *_) = vertices[top], vertices[bottom]

    def distance(k):
        x, y, *_ = vertices[k]
        return abs((bx - ax) * (y - ay) - (x - ax) * (by - ay))

    return top, bottom, max(order, key=lambda k: (distance(k), -vertices[k][1], -vertices[k][0]))


class Plane:
    """One coordinate's plane over the screen, exact: (n0 + nx x + ny y) / d, 16.16."""

    def __init__(self, points, values) -> None:
        (x0, y0), (x1, y1), (x2, y2) = points
        self.d = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        self.nx = (values[1] - values[0]) * (y2 - y0) - (values[2] - values[0]) * (y1 - y0)
        self.ny = (x1 - x0) * (values[2] - values[0]) - (x2 - x0) * (values[1] - values[0])
        self.x0, self.y0, self.value0 = x0, y0, values[0]
        self.last = None, None, ()  # texturing and cut of ``terms``, and its result

    def at(self, x: int, y: int) -> Fraction:
        """Returns the exact value at a point; all in units."""
        return self.value0 + Fraction(self.nx * (x - self.x0) + self.ny * (y - self.y0), self.d)

    def texels(self, first: int, end: int, j: int) -> list[int]:
        """The exact value at pixels ``first`` to ``end`` - 1 of line j, in texels, rounded down."""
        rise = self.nx * ((first << 16) - self.x0) + self.ny * ((j << 16) - self.y0)
        start = self.value0 * self.d + rise
        return [(start + k * (self.nx << 16)) // (self.d << 16) for k in range(end - first)]

    def error(self, found: int, i: int, j: int) -> float:
        """Returns found (16.16 modulo 2^32) minus the exact value at pixel (i, j), in texels."""
        rise = self.nx * ((i << 16) - self.x0) + self.ny * ((j << 16) - self.y0)
        error = ((found - self.value0) * self.d - rise) % (abs(self.d) << 32)
        if error >= abs(self.d) << 31:
            error -= abs(self.d) << 32
        return error / self.d * UNIT

    def errors_at(self, found: np.ndarray, columns: np.ndarray, ys: np.ndarray) -> np.ndarray:
        """Returns ``error`` for several pixels."""
        whole, start = abs(self.d) << 32, self.value0 * self.d - self.nx * self.x0 - self.ny * self.y0
        right, down, half, made = self.nx << 16, self.ny << 16, whole >> 1, []
        for value, i, j in zip(found.tolist(), columns.tolist(), ys.tolist()):
            error = (value * self.d - start - right * i - down * j) % whole
            made.append((error - whole if error >= half else error) / self.d * UNIT)
        return np.array(made)

    def errors(self, found: np.ndarray, columns: np.ndarray, j: int) -> np.ndarray:
        """Returns ``error`` for adjacent pixels ``columns`` of line j; the first is exact, the
        others are rounded to some 1/2^30 texel."""
        return self.row_errors(found, Rows.of(columns, j))

    def row_errors(self, found: np.ndarray, rows: Rows) -> np.ndarray:
        """Returns ``errors`` for the pixels of several rows."""
        first = found[rows.starts]
        moved = (found - rows.spread(first)).astype(np.int32)  # modulo 2^32
        exact = (rows.columns - rows.spread(rows.lefts)) * (self.nx / self.d)
        error = rows.spread(self.errors_at(first, rows.lefts, rows.ys)) + moved * UNIT - exact
        return (error + 32768) % 65536 - 32768

    @staticmethod
    def cut(gradient: float, gentle: bool = False) -> float:
        """Returns e(g), a gradient's largest error before it is rounded to a step."""
        return 2.5 / 2**26 if gentle else abs(gradient) / 2**31 + 3 / 2**32

    def rounding(self, cut: int, gentle: bool = False) -> list[float]:
        """The largest errors of steps per pixel and per line, texels; ``cut``: low bits of 0."""
        whole, found = abs(self.d) << cut, []
        for n in (self.nx, self.ny):
            rest = (n << 16) % whole
            found.append(min(rest, whole - rest) / abs(self.d) * UNIT
                         + 2 * self.cut(n / self.d, gentle))
        return found

    def raised(self, t: model.Texturing, cut: int) -> float:
        """The most by which set-up raises the values, in texels; ``cut``: low bits that are 0."""
        if t.gentle:
            ways = max(t.box[2] - t.i, t.i - t.box[0]) + t.box[3] - t.j
            return UNIT * (ways * (1 << cut) / 2 + RAISED + (1 << cut))
        to_pixel = abs(t.i - self.x0 * UNIT) + abs(t.j - self.y0 * UNIT)
        ways = t.i - t.box[0], t.j - t.box[1]
        steep = (abs(self.nx) + abs(self.ny)) / abs(self.d) + 5
        steps = sum(way * off for way, off in zip(ways, self.rounding(cut)))
        return steps + UNIT * (3 + (1 << cut)) + steep * (to_pixel + sum(ways) + 2) * 2 / 2**32

    def bound(self, i: Number, j: Number, t: model.Texturing, cut: int) -> Number:
        """Returns how far set-up's value may be above the exact one at pixel (i, j), or at several, in texels."""
        raised, away, right, down = self.terms(t, cut)
        return raised + UNIT + away + abs(i - t.i) * right + abs(j - t.j) * down

    def terms(self, t: model.Texturing, cut: int) -> tuple[float, float, float, float]:
        """What the bounds of all pixels share, which are asked for one after the other."""
        if self.last[0] is not t or self.last[1] != cut:
            ex, ey = (self.cut(n / self.d, t.gentle) for n in (self.nx, self.ny))
            away = abs(t.i - self.x0 * UNIT) * ex + abs(t.j - self.y0 * UNIT) * ey
            self.last = t, cut, (self.raised(t, cut), away, *self.rounding(cut, t.gentle))
        return self.last[2]

    def below(self) -> bool:
        """Returns true if set-up's value may be below the exact one as well."""
        return max(abs(self.nx), abs(self.ny)) >= abs(self.d) << 30


def plane_of(vertices, key: int) -> Plane:
    """Returns the plane of a polygon's numbers ``key``, through its three corners."""
    three = [vertices[k] for k in corners(vertices)]
    return Plane([v[:2] for v in three], [v[key] for v in three])


class Picture:
    """A convex polygon's ideal in a frame: extents {line: (first, end)}, pixels, planes of u, v."""

    def __init__(self, vertices, width: int, height: int) -> None:
        self.extents = {}
        ys = [v[1] for v in vertices]
        for y in range(max(-(-min(ys) // 65536), 0), min(-(-max(ys) // 65536), height)):
            ends = [min(max(-(-n // (d << 16)), 0), width) for n, d in extent(vertices, y)]
            if ends[0] < ends[1]:
                self.extents[y] = tuple(ends)
        self.pixels = sum(end - first for first, end in self.extents.values())
        self.planes = [plane_of(vertices, k) for k in (2, 3)]
        self.endless = True  # planes continue beyond the polygon


def inner_rows(vertices, polygon: Polygon) -> tuple[list[int], Rows, Rows]:
    """Returns the polygon's lines, as indices, with pixels inside the exact polygon, and two sets of rows: the pixels
    that are in both, and all that are drawn on those lines."""
    ends = np.array([(line.left, line.right) for line in polygon.lines], np.int64).reshape(-1, 2).T
    exact = first_pixels(vertices, polygon.top, polygon.top + len(polygon.lines))
    left, right = np.maximum(ends[0], exact[0]), np.minimum(ends[1], exact[1])
    seen, = np.nonzero(left < right)
    ys = seen + polygon.top
    return seen.tolist(), Rows(ys, left[seen], right[seen]), Rows(ys, *(end[seen] for end in ends))


def gathered(polygon: Polygon, numbers: list[int], rows: Rows, drawn: Rows) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v, int64, 16.16, of the pixels of rows inside ``drawn``, the polygon's lines ``numbers``."""
    at = rows.columns + rows.spread(polygon.stepped.starts[numbers] - drawn.lefts)
    return polygon.stepped.u[at], polygon.stepped.v[at]


def edge_errors(vertices, polygon: Polygon) -> Iterator[tuple[int, int, float, float]]:
    """Yields (first pixel, line, error, bound) of every edge on every line, in pixels. Only for
    stepped edges: exact ones have no error."""
    exact = extents(vertices)
    for side, edges in enumerate((polygon.left_edges, polygon.right_edges)):
        for edge in edges:
            for y in range(edge.top, edge.end):
                numerator, denominator = exact(y)[side]
                error = abs(edge.at(y) * denominator - numerator) / denominator * UNIT
                yield edge.column(y), y, error, (y - edge.top + 1) * UNIT / 2


def texel_errors(vertices, polygon: Polygon) -> Iterator[tuple[str, int, int, float, float]]:
    """Yields (coordinate, pixel, line, error, bound) of u and v, stepped to the ends of every
    line, in texels; no error may be below 0. Along a line both are linear, so the ends have the
    largest errors."""
    plane, stepped = polygon.texturing, polygon.stepped
    drawn, = np.nonzero(np.diff(stepped.starts))
    first, last, y = stepped.starts[drawn], stepped.starts[drawn + 1] - 1, drawn + polygon.top
    left = np.array([polygon.lines[k].left for k in drawn.tolist()], np.int64)
    for name, key, found, cut in zip("uv", (2, 3), (stepped.u, stepped.v), plane.cuts):
        exact = plane_of(vertices, key)
        for at in (first, last):
            i = left + at - first
            errors, bounds = exact.errors_at(found[at], i, y), exact.bound(i, y, plane, cut)
            yield from zip(repeat(name), *(each.tolist() for each in (i, y, errors, bounds)))
