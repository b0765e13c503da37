"""The bounds of every setting's error against the exact ideal, and the check of polygons by them.

All bounds follow from formats and roundings alone. 1 unit = U = 1/2^16, of a pixel or a
texel. Vertices are those that ``model.adapt`` returns: `integer` edges are judged by the
vertices that they cut, shades and texels by the vertices' values after their rounding. For the
pixels that are drawn, and for E(j), the error of the edge on line j, see
tools/tmap/ideal/bounds_coverage.py.

**Steps.** With g, h the exact gradients in x and y (u, v or shade per pixel):

* `plane`: d = r/2 + e(g), with e and r from tools/tmap/ideal/ideal.py: r is U, or 2^cut U if the
  spans drop ``cut`` low bits. Starts are raised for d over the whole box, from its middle on, or from
  the first pixel of the left side if gradients are gentle: then up to twice as many pixels.
* `polygon`: the longest line's width w and rise are off by H each: U/2 by rounding, and 1 in 2^32 of
  the long edge's own, U/2 at most. Their quotient is off by U/2, and if cut is not 0, rounding to a
  multiple of 2^cut U adds half of that: d = (1 + |g|) H / (w - H) + R, R = U/2 or (1 + 2^cut) U/2. It saturates at 32,768 texels per
  pixel: with g near that, or w below 2 H, d = |g| + 32,768.

**Start of line j.** Its edge crosses at x and its first pixel is c; it is n lines below the
edge's first line in the frame:

* `plane`, `subtexel`: on the plane, see tools/tmap/ideal/ideal.py.
* `plane`, `truncated`: the plane's value at the first line's pixel is moved back to the crossing
  by a product cut to U with a prestep that is off by E. Then follow n steps of dudy + slope * dudx,
  each with the plane's rounding in y, a product cut to U and a slope rounded to U/2:
  p + U + |g| E(j0) + d + n (d_y + U + |g| U/2 + |slope| d) + (n + 1) (2^cut - 1) U, p being the
  plane's bound there. This is the value at the crossing, not at the pixel: |g| (c - x) more.
* `polygon`: along the edge, the start and each step are rounded to the nearest unit: (n + 1) U/2.
  `truncated`: |g| (c - x) more. `subtexel`: cut products at the start and in each step move the
  value by c - x' in all, x' being the rounded crossing: (n + 1) U + |g| E(j) + |c - x'| d.
  Start and steps are raised to multiples of 2^cut: (n + 1) (2^cut - 1) U.

Pixel i is i - c steps from there: (i - c) d more.

**One side.** Values of `plane`, `subtexel` are never below the exact ones
(tools/tmap/ideal/ideal.py). The same holds for `polygon`, `subtexel` if the longest line is a pixel
wide or more, |g| is below 250, and no edge begins farther left of the frame than the box is wide.
With N lines and W pixels, starts are raised by (N (3 + g') + (W + 1) 2R/U) / 2 + 4 g' + 4 units, g'
between |g| and |g| + 2.5. That is the most that the sums above can be: N/2 along the edge, N in
moves, N |g| / 2 by x, and d over W + 1 pixels, 3 w of them at most by the quotient. `truncated` is raised
by the same without the part of the moves. If a texel's border is exactly on a pixel's centre, the
texel that begins there is shown.

**Two divides per line** (`scanline`): the ideal is linear along both exact edges and between
them. At a crossing, u is off by a = (n + 1) U/2 and x by E(j); an end is off by b = a + |g| E.
Between the ends the error is at most the larger b plus a step cut to U at a distance of i - x':
max(b0, b1) (1 + 2E) + (|i - x'| + 1) U. For a line under one pixel wide it is at most
|u1 - u0| + a0 + a1 + U. `truncated` divides the rise by P whole pixels, from the crossing on: by
its nature it is off by g ((i - c)(w / P - 1) - (c - x)), and by 2 a0 + a1 + (i - c) U. Both ends
are raised by N/2 + 2 units, N being their edge's lines, and steps are rounded up: if edges cross
lines at whole units, values are never below the exact ones. Values are raised to clear the low bits
that the spans drop: (|i - c| + 1) (2^cut - 1) U.

**Mappers.** Generated code replaces the start's fraction f by 520 U, which is more than the
shortfall of 1,023 steps, (U/2 + 256 / 2^31 + 3 / 2^32) each: f - 520 U below, or 520 U - f above.
If u leaves its row of the map in a line, affine spans draw the polygon. Dithered points are moved
by 3/8 texel at most, exactly: moves are whole units. For lines held in a range (edge_clamp), let B
be the polygon's largest bound plus the distance of its plane beyond the range at a vertex. A step
shrinks by 2B over the longest line and is cut (U), and a start moves no farther than its ends were
outside, 3B + U: 6B + 2U. Negative steps are then 2 units smaller: a line whose first pixel is on
the map's far border starts a unit before it and is above the exact values from its next pixel on.
That adds 2U per pixel.

**Light** (`lit_gouraud`): levels are on a plane over the screen like u, in multiples of 4U, with
perspective too. Every line is held: 6B + 8U.

The texels that are fetched have the bounds of u and v: tools/tmap/ideal/bounds_fetched.py.
"""

from dataclasses import dataclass

import numpy as np

from tmap.base.fixed import ceil16
from tmap.corpus.random_polygons import is_convex
from tmap.ideal import bounds_fetched, bounds_perspective, bounds_snapped, ideal, planarity
from tmap.ideal.bounds_coverage import (FLOAT, LARGEST, crossing, edge_bound, edges_by_line,
                                        check_coverage)
from tmap.ideal.ideal import UNIT
from tmap.ideal.perspective import in_front
from tmap.model import model
from tmap.setup import snapped, spans, tolerance
from tmap.setup.dithered import MOST as DITHERED
from tmap.setup.edges import Edge
from tmap.setup.spans import BIAS
from tmap.setup.texturing import CUT, STEEP_256, Line, Settings, Texturing


@dataclass
class Verdict:
    """The errors of one polygon. Texel errors in texels (shades)."""

    pixels: int = 0
    coverage_errors: int = 0  # pixels lit or left out against the exact polygon
    texel_error: float = 0.0  # the largest
    texel_bound: float = 0.0  # at the same pixel
    texel_ratio: float = 0.0  # the largest error / bound of a pixel
    unsure: int = 0  # polygons drawn affine though w differs
    complaint: str = ""  # the first excess found, in words

    def complain(self, text: str) -> None:
        """Notes an excess, if it is the first."""
        self.complaint = self.complaint or text

    def note(self, error: float, bound: float) -> None:
        """Notes a pixel's error, if it is the largest."""
        if error > self.texel_error or not self.texel_bound:
            self.texel_error, self.texel_bound = float(error), float(bound)

    def merge(self, other: "Verdict") -> None:
        """Takes the worse of both."""
        self.pixels += other.pixels
        self.coverage_errors += other.coverage_errors
        self.unsure += other.unsure
        self.note(other.texel_error, other.texel_bound)
        self.texel_ratio = max(self.texel_ratio, other.texel_ratio)
        self.complain(other.complaint)


def has_ideal(vertices, settings: Settings = Settings()) -> bool:
    """Returns true if the exact ideal of vertices from ``model.adapt`` is defined. They must be in
    range and convex (integer edges may dent a polygon) and, with a perspective, in front of the
    viewer (the rounding of more than three may prevent that)."""
    points = [tuple(v[:2]) for v in vertices]
    inside = all(-model.FAR <= c < model.FAR for v in vertices for c in v[:4])
    convex = len(points) == 3 or is_convex(points) and winds_once(points)
    return inside and convex and (settings.perspective == "none" or in_front(vertices))


def winds_once(points) -> bool:
    """Returns true if a polygon that turns one way only goes round once: its x has one minimum."""
    signs = [b[0] > a[0] for a, b in zip(points, [*points[1:], points[0]]) if b[0] != a[0]]
    return sum(a != b for a, b in zip(signs, [*signs[1:], *signs[:1]])) <= 2


@dataclass
class Coordinate:
    """u or v of a polygon: the exact plane and the bounds that hold for all of it."""

    key: str
    plane: ideal.Plane
    cut: int  # low bits that are 0
    g: float  # texels per pixel
    h: float  # texels per line
    step: float  # d, per pixel
    down: float  # d_y, per line (plane)
    end: float = 0.0  # H, of the longest line's ends (polygon)


def coordinate(vertices, key: int, t: model.Texturing | None, settings: Settings) -> Coordinate:
    """Returns the plane of ``vertices`` [key] through their corners, and its steps' bounds."""
    plane = ideal.plane_of(vertices, key)
    cut = t.cuts[key - 2] if isinstance(t, Texturing) else CUT.get(settings.mapper, (0, 0))[key - 2]
    g, h = abs(plane.nx / plane.d), abs(plane.ny / plane.d)
    if settings.gradients == "plane":
        rounding = UNIT / 2 * (1 << cut)
        gentle = isinstance(t, Texturing) and t.gentle
        return Coordinate("..uv"[key], plane, cut, g, h,
                          *(rounding + plane.cut(each, gentle) for each in (g, h)))
    top, bottom, _ = ideal.corners(vertices)
    height = vertices[bottom][1] - vertices[top][1]
    width = abs(plane.d / height) * UNIT if height else 0.0
    step = g + LARGEST
    reach = max(abs(vertices[bottom][k] - vertices[top][k]) for k in (0, key))
    end = UNIT / 2 + reach * UNIT / 2**32
    if width > 2 * end:
        rounded = (1 + g) * end / (width - end) + coarse(cut) * UNIT / 2
        if g + rounded < LARGEST - 1:
            step = rounded
    return Coordinate("..uv"[key], plane, cut, g, h, step, 0.0, end)


def coarse(cut: int) -> int:
    """Twice the rounding of a step without a plane, its quotient's rounding included; units."""
    return 1 + (1 << cut) if cut else 1


def start_bound(c: Coordinate, t: model.Texturing, edge: Edge, line: int, column: int,
                settings: Settings) -> float:
    """Returns the bound of u at the first pixel ``column`` of a line before the frame cuts it (not
    for plane + subtexel)."""
    n, off = line - edge.top, abs(column - crossing(edge, line))
    zeros = (1 << c.cut) * UNIT  # including the free bit's value
    if settings.gradients == "plane":
        first = c.plane.bound(edge.column(edge.top), edge.top, t, c.cut)
        slope = abs(edge.slope) * UNIT
        return (first + UNIT + c.g * edge_bound(edge, edge.top) + c.step
                + n * (c.down + UNIT + c.g * UNIT / 2 + slope * c.step)
                + (n + 1) * zeros + c.g * off)
    along = (n + 1) * (UNIT / 2 + zeros)
    if settings.start == "truncated":
        return along + c.g * off
    rounded = edge_bound(edge, line)
    return along + (n + 1) * UNIT + c.g * rounded + (off + rounded) * c.step


def raised_starts(c: Coordinate, edge: Edge, width: int, settings: Settings) -> float:
    """Returns the most by which starts of `polygon` are raised, in texels."""
    lines, whole = edge.end - edge.top, min(c.g + c.step + 2, STEEP_256)
    line = 3 + whole if settings.start == "subtexel" else 1
    return ((lines * line + (width + 1) * coarse(c.cut)) / 2 + 4 * whole + 4) * UNIT


def plane_bound(c: Coordinate, t: model.Texturing, edge: Edge, i: int, y: int,
                settings: Settings) -> tuple[float, float]:
    """Returns how far below and above u may be at a pixel, if the polygon has one step."""
    exact = settings.start == "subtexel"
    if isinstance(t, snapped.Triangle):
        return bounds_snapped.bound(c.g, t, "uv".index(c.key), i, y)
    if settings.gradients == "plane" and exact:
        high = c.plane.bound(i, y, t, c.cut)
        return high if c.plane.below() else 0.0, high
    column = edge.column(y)
    off = start_bound(c, t, edge, y, column, settings) + abs(i - column) * c.step
    if settings.gradients == "plane":
        return off, off
    # if the longest line is narrower than a pixel, its quotient is off by more than half a texel
    wide = exact and c.g < STEEP_256 - 6 and c.step < (1 + c.g) * c.end + coarse(c.cut) * UNIT / 2
    width = t.box[2] - t.box[0]
    sure = wide and i - edge.column(edge.top) <= width and i - column <= width
    return 0.0 if sure else off, off + raised_starts(c, edge, width, settings)


def scanline_ideal(key: str, y: int, edges: tuple[Edge, Edge], i: int,
                   settings: Settings) -> tuple[float, float]:
    """u at a pixel between both exact edges, and its bound if each line has its own steps."""
    index = "uv".index(key) + 2
    x, u, a, off = [], [], [], []
    for edge in edges:
        part = ((y << 16) - edge.upper[1]) / (edge.lower[1] - edge.upper[1])
        x.append(crossing(edge, y))
        u.append((edge.upper[index] + (edge.lower[index] - edge.upper[index]) * part) * UNIT)
        a.append((y - edge.top + 1) * UNIT / 2 + ((edge.end - edge.top) / 2 + 2) * UNIT)
        off.append(edge_bound(edge, y))
    width, rise = x[1] - x[0], u[1] - u[0]
    g = rise / width if width > 0 else 0.0
    exact, rounded = u[0] + g * (i - x[0]), [edge.at(y) for edge in edges]
    if settings.start == "truncated":
        first = ceil16(rounded[0])
        pixels = ceil16(rounded[1]) - first
        stretch = width / pixels - 1 if pixels > 0 else -1.0
        return exact, (abs(g * ((i - first) * stretch - (first - x[0])))
                       + 2 * a[0] + a[1] + (abs(i - first) + 1) * UNIT)
    ends = max(b + abs(g) * e for b, e in zip(a, off)) * (1 + 2 * max(off))
    bound = ends + (abs(i - rounded[0] * UNIT) + 1) * UNIT
    if rounded[1] - rounded[0] < 65536:
        bound = max(bound, abs(rise) + a[0] + a[1] + UNIT)
    return exact, bound


def add_error(error: float, bounds: tuple[float, float], key: str, pixel: tuple, out: Verdict) -> None:
    """Adds one pixel's error to a verdict; ``bounds``: how far it may be below and above."""
    bound = bounds[error >= 0]
    out.note(abs(error), max(bounds))
    if max(bounds) < LARGEST and error:
        ratio = abs(error) / bound if bound else 2.0
        out.texel_ratio = max(out.texel_ratio, ratio)
        if ratio > FLOAT:
            out.complain(f"{key} at pixel {pixel} is {error:.9f} off the exact value, "
                         f"{-bounds[0]:.9f} to {bounds[1]:.9f} are allowed")


def mapper_bound(mapper: str, key: str, line: Line, i: int, error: float) -> float:
    """What a mapper adds to the bound of u or v at pixel i of a line, on the error's side."""
    if mapper == "generated":
        lost = (getattr(line, key) & 0xFFFF) - BIAS
        return max(-lost if error > 0 else lost, 0) * UNIT
    return DITHERED * (mapper == "dithered")


def line_errors(key: str, c: Coordinate, values: np.ndarray, pixel: tuple[int, int], t,
                edges: tuple[Edge, Edge], settings: Settings) -> tuple[np.ndarray, list[tuple]]:
    """Returns the errors of the stepped u at the pixels of a line from ``pixel`` on, exact at both
    ends, and how far below and above u may be at the ends."""
    (left, y), last = pixel, pixel[0] + len(values) - 1
    if settings.gradients == "scanline":
        ends = [scanline_ideal(key, y, edges, i, settings) for i in (left, last)]
        exact = np.linspace(ends[0][0], ends[1][0], len(values))
        zeros = len(values) * ((1 << c.cut) - 1) * UNIT
        return ((values * UNIT - exact + LARGEST) % (2 * LARGEST) - LARGEST,
                [(b + zeros, b + zeros) for _, b in ends])
    errors = c.plane.errors(values, np.arange(left, last + 1), y)
    errors[-1] = c.plane.error(int(values[-1]), last, y)
    return errors, [plane_bound(c, t, edges[0], i, y, settings) for i in (left, last)]


def check_texels(vertices, polygon: model.Polygon, settings: Settings, size: tuple[int, int],
                 beyond: float | None, out: Verdict) -> None:
    """Adds the error of u and v at both ends of every line inside the exact polygon, as both are
    linear between them, and judges the texels that are fetched at all its pixels."""
    mapper, t = polygon.mapper, polygon.triangle or polygon.texturing
    sides = [edges_by_line(e) for e in (polygon.left_edges, polygon.right_edges)]
    planes = {key: coordinate(vertices, index, t, settings)
              for key, index in (("u", 2), ("v", 3)) if mapper != "gouraud" or key == "u"}
    found = []  # error, bounds below and above, coordinate, pixel
    shown = []  # the texels of a line, how far they may be below and above
    for y, line, left, right in bounds_perspective.inner_lines(vertices, polygon):
        seen, last = slice(left - line.left, right - line.left), right - 1
        stepped = polygon.coordinates(line, y)
        texels = spans.fetched(line, mapper, size, stepped)
        for k, (key, c) in enumerate(planes.items()):
            values = stepped[k][seen]
            errors, bounds = line_errors(key, c, values, (left, y), t, (sides[0][y], sides[1][y]), settings)
            for i, error, both in ((left, errors[0], bounds[0]), (last, errors[-1], bounds[1])):
                more = [mapper_bound(mapper, key, line, i, way) for way in (-1, 1)]
                found.append((float(error), tuple(map(sum, zip(both, more))), key, (i, y)))
            allowed = [max(each) + mapper_bound(mapper, key, line, last, way)
                       for way, each in zip((-1, 1), zip(*bounds))]
            side = 256 if mapper == "gouraud" else size[k]
            shown.append(((key, texels[k][seen], values, errors, side, left, y), tuple(allowed)))
    if beyond is not None:
        longest = max(line.right - line.left for line in polygon.lines)
        most = max((max(each) for _, each, *_ in found), default=0.0) + beyond
        held = 6 * most + 2 * (longest + 1) * UNIT
        found = [(error, (held, held), *rest) for error, _, *rest in found]
        shown = [(each, (held, held)) for each, _ in shown]
    for error, both, key, pixel in found:
        add_error(error, both, key, pixel, out)
    bounds_fetched.judge_lines(shown, out)


def check_levels(vertices, polygon: model.Polygon, out: Verdict) -> None:
    """Adds the error of the level at both ends of every line inside the exact polygon."""
    if polygon.triangle:
        plane = ideal.plane_of(vertices, -1)
        for y, line, left, right in bounds_perspective.inner_lines(vertices, polygon):
            for i in {left, right - 1}:
                bound = bounds_snapped.level_bound(abs(plane.nx / plane.d), polygon.triangle, i, y)
                add_error(plane.error(line.c + (i - line.left) * line.dcdx, i, y), (bound, bound),
                          "level", (i, y), out)
        return
    t, light, plane = polygon.shading.plane, polygon.shading, ideal.plane_of(vertices, -1)
    (least, _), (most, _) = model.plane_range(vertices, t)
    beyond = max(0, light.low - least, most - light.high) * UNIT
    found = []  # error, bound on the plane, pixel
    for y, line, left, right in bounds_perspective.inner_lines(vertices, polygon):
        for i in {left, right - 1}:
            found.append((plane.error(line.c + (i - line.left) * line.dcdx, i, y),
                          plane.bound(i, y, t, t.u_cut), (i, y)))
    bound = 6 * (max((b for _, b, _ in found), default=0.0) + beyond) + 8 * UNIT
    for error, _, pixel in found:
        add_error(error, (bound, bound), "level", pixel, out)


def held_beyond(vertices, polygon: model.Polygon, settings: Settings,
                size: tuple[int, int]) -> float | None:
    """Returns None if no line is held in a range, else how far beyond the range the plane is at a
    vertex, in texels: more than three vertices need not be on it."""
    t = polygon.texturing
    if polygon.triangle:
        return None
    steep = t is None or model.is_steep(settings, t.dudx, t.dvdx, len(polygon.lines))
    ranges = model.held_range(vertices, settings, size, t, steep)
    if not ranges:
        return None
    if len(vertices) == 3 or settings.gradients != "plane":
        return 0.0
    ends = zip(*model.plane_range(vertices, t), ranges)
    return max(0, *(max(first - low, high - last) for low, high, (first, last) in ends)) * UNIT


def check_set_up(adapted, polygon: model.Polygon | None, settings: Settings, width: int,
                 height: int, size: tuple[int, int]) -> Verdict:
    """``judge`` for the results of ``model.adapt`` and ``model.set_up``."""
    out = Verdict(pixels=polygon.pixels if polygon else 0)
    out.coverage_errors, out.complaint = check_coverage(adapted, polygon, settings, width, height)
    on_plane = settings.gradients == "plane" and settings.start == "subtexel"
    if polygon and polygon.perspective:
        bounds_perspective.check_texels(adapted, polygon, settings.perspective,
                                        settings.tolerance * UNIT, size, out)
    elif polygon and settings.perspective != "none" and len({v[4] for v in adapted}) > 1:
        flat = tolerance.is_flat(adapted, settings.tolerance)
        bounds_perspective.check_flattened(adapted, polygon,
                                           settings.tolerance * UNIT if flat else None, size,
                                           out)
    elif polygon and polygon.textured and (on_plane or settings.clip == "scissor"):
        check_texels(adapted, polygon, settings, size,
                     held_beyond(adapted, polygon, settings, size), out)
    if polygon and polygon.mapper == "lit_gouraud":
        check_levels(adapted, polygon, out)
    return out


def judge(vertices, settings: Settings, width: int, height: int,
          size: tuple[int, int] = (256, 256)) -> Verdict:
    """Checks a convex polygon, or the triangles that replace it, against the bounds of its
    settings.

    ``vertices``: a scene's (x, y, s, t, shade, w), 16.16; ``size``: the map's. Polygons cut to the
    window are judged by their pixels, and by u and v if these come from the plane.
    """
    out, parts = Verdict(), model.parts(vertices, settings, (width, height), max(size))
    if is_convex([v[:2] for v in vertices]):
        out.complain(planarity.judge(vertices, settings, len(parts)))
    for part in parts:
        adapted = model.adapt(part, settings, max(size))
        polygon = model.set_up(adapted, width, height, settings.mapper != "flat", settings, size)
        out.merge(check_set_up(adapted, polygon, settings, width, height, size))
    return out
