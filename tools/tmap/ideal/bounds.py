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
be the polygon's largest bound plus the distance of its plane beyond the range at a vertex, and P how
far its plane goes on from an edge to a pixel that is drawn beyond it: |g| E(j), and 2U (|g| + |h|) if
vertices were cut. A step shrinks by 2B + 2P over the longest line and is cut (U), and a start moves
no farther than its ends were outside, 3B + P + U: 6B + 3P + 2U. Negative steps are then 2 units
smaller: a line whose first pixel is on the map's far border starts a unit before it and is above the
exact values from its next pixel on. That adds 2U per pixel.

**Light** (`lit_gouraud`): levels are on a plane over the screen like u, in multiples of 4U, with
perspective too. Every line is held: 6B + 3P + 8U.

The texels that are fetched have the bounds of u and v: tools/tmap/ideal/bounds_fetched.py.
"""

from dataclasses import dataclass

import numpy as np

from tmap.corpus.random_polygons import is_convex
from tmap.ideal import bounds_fetched, bounds_snapped, check_perspective, ideal, planarity
from tmap.ideal.bounds_coverage import LARGEST, Side, check_coverage, edge_bound
from tmap.ideal.ideal import UNIT
from tmap.ideal.perspective import in_front
from tmap.ideal.rows import Rows
from tmap.ideal.verdict import Verdict, add_errors
from tmap.model import model
from tmap.setup import snapped, spans, tolerance
from tmap.setup.dithered import MOST as DITHERED
from tmap.setup.edges import Edge
from tmap.setup.spans import BIAS
from tmap.setup.texturing import CUT, STEEP_256, Line, Settings, Texturing


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


def start_bound(c: Coordinate, t: model.Texturing, side: Side, columns: np.ndarray,
                settings: Settings) -> np.ndarray:
    """Returns the bounds of u at the first pixels ``columns`` of lines before the frame cuts them (not
    for plane + subtexel)."""
    n, off = side.below, abs(columns - side.crossings)
    zeros = (1 << c.cut) * UNIT  # including the free bit's value
    if settings.gradients == "plane":
        first = side.each(lambda edge: c.plane.bound(edge.column(edge.top), edge.top, t, c.cut)
                          + UNIT + c.g * edge_bound(edge, edge.top))
        slope = side.each(lambda edge: abs(edge.slope)) * UNIT
        return (first + c.step + n * (c.down + UNIT + c.g * UNIT / 2 + slope * c.step)
                + (n + 1) * zeros + c.g * off)
    along = (n + 1) * (UNIT / 2 + zeros)
    if settings.start == "truncated":
        return along + c.g * off
    return along + (n + 1) * UNIT + c.g * side.bounds + (off + side.bounds) * c.step


def raised_starts(c: Coordinate, edge: Edge, width: int, settings: Settings) -> float:
    """Returns the most by which starts of `polygon` are raised, in texels."""
    lines, whole = edge.end - edge.top, min(c.g + c.step + 2, STEEP_256)
    line = 3 + whole if settings.start == "subtexel" else 1
    return ((lines * line + (width + 1) * coarse(c.cut)) / 2 + 4 * whole + 4) * UNIT


def plane_bound(c: Coordinate, t: model.Texturing, side: Side, i: np.ndarray,
                settings: Settings) -> tuple[np.ndarray, np.ndarray]:
    """Returns how far below and above u may be at pixels of the left side's lines, if the polygon has one step."""
    exact = settings.start == "subtexel"
    if isinstance(t, snapped.Triangle):
        both = [bounds_snapped.bound(c.g, t, "uv".index(c.key), *at) for at in zip(i.tolist(), side.ys.tolist())]
        return tuple(np.array(each) for each in zip(*both))
    if settings.gradients == "plane" and exact:
        high = c.plane.bound(i, side.ys, t, c.cut)
        return high if c.plane.below() else 0.0 * high, high
    column = side.columns
    off = start_bound(c, t, side, column, settings) + abs(i - column) * c.step
    if settings.gradients == "plane":
        return off, off
    # if the longest line is narrower than a pixel, its quotient is off by more than half a texel
    wide = exact and c.g < STEEP_256 - 6 and c.step < (1 + c.g) * c.end + coarse(c.cut) * UNIT / 2
    width = t.box[2] - t.box[0]
    sure = wide & (i - side.each(lambda edge: edge.column(edge.top)) <= width) & (i - column <= width)
    return np.where(sure, 0.0, off), off + side.each(lambda edge: raised_starts(c, edge, width, settings))


def scanline_ideal(key: str, sides: tuple[Side, Side], i: np.ndarray,
                   settings: Settings) -> tuple[np.ndarray, np.ndarray]:
    """u at a pixel of each line between both exact edges, and its bound if each line has its own steps."""
    index = "uv".index(key) + 2
    x, off, at = ([getattr(side, name) for side in sides] for name in ("crossings", "bounds", "at"))
    u = [side.values(index) * UNIT for side in sides]
    a = [(side.below + 1) * UNIT / 2 + (side.each(lambda edge: edge.end - edge.top) / 2 + 2) * UNIT for side in sides]
    width, rise = x[1] - x[0], u[1] - u[0]
    g = np.where(width > 0, rise / np.where(width > 0, width, 1.0), 0.0)
    exact = u[0] + g * (i - x[0])
    if settings.start == "truncated":
        first, end = (edge + 0xFFFF >> 16 for edge in at)
        stretch = np.where(end > first, width / np.maximum(end - first, 1) - 1, -1.0)
        return exact, (abs(g * ((i - first) * stretch - (first - x[0])))
                       + 2 * a[0] + a[1] + (abs(i - first) + 1) * UNIT)
    ends = np.maximum(*(b + abs(g) * e for b, e in zip(a, off))) * (1 + 2 * np.maximum(*off))
    bound = ends + (abs(i - at[0] * UNIT) + 1) * UNIT
    narrow = np.maximum(bound, abs(rise) + a[0] + a[1] + UNIT)
    return exact, np.where(at[1] - at[0] < 65536, narrow, bound)


def mapper_bounds(mapper: str, key: str, lines: list[Line]) -> tuple:
    """What a mapper adds to the bounds of u or v of lines, below and above."""
    if mapper == "generated":
        lost = np.array([(getattr(line, key) & 0xFFFF) - BIAS for line in lines])
        return np.maximum(lost, 0) * UNIT, np.maximum(-lost, 0) * UNIT
    return (DITHERED * (mapper == "dithered"),) * 2


def coordinate_errors(c: Coordinate, values: np.ndarray, rows: Rows, t, sides: tuple[Side, Side],
                      settings: Settings) -> tuple[np.ndarray, list[tuple]]:
    """Returns the errors of the stepped u at the pixels of rows, exact at both ends, and how far below and above u may
    be at both ends."""
    ends, last = (rows.lefts, rows.ends - 1), rows.starts + rows.counts - 1
    if settings.gradients == "scanline":
        both = [scanline_ideal(c.key, sides, i, settings) for i in ends]
        (first, _), (end, _) = both
        slope = rows.spread((end - first) / np.maximum(rows.counts - 1, 1))
        exact = rows.spread(first) + (rows.columns - rows.spread(rows.lefts)) * slope
        exact[last] = np.where(rows.counts > 1, end, first)
        zeros = rows.counts * ((1 << c.cut) - 1) * UNIT
        return ((values * UNIT - exact + LARGEST) % (2 * LARGEST) - LARGEST,
                [(b + zeros, b + zeros) for _, b in both])
    errors = c.plane.row_errors(values, rows)
    errors[last] = c.plane.errors_at(values[last], ends[1], rows.ys)
    return errors, [plane_bound(c, t, sides[0], i, settings) for i in ends]


def fetched_inside(lines: list[Line], mapper: str, size: tuple[int, int], stepped, rows: Rows,
                   drawn: Rows) -> tuple[np.ndarray, np.ndarray]:
    """Returns the column and row of the map that the pixels of rows show, in lines ``drawn``, which contain them."""
    if mapper != "generated":
        return spans.fetched_by(lines, mapper, size, stepped)
    return tuple(each[rows.inside(drawn)] for each in spans.fetched_by(lines, mapper, size, stepped))


def check_texels(vertices, polygon: model.Polygon, settings: Settings, size: tuple[int, int],
                 beyond: float | None, out: Verdict) -> None:
    """Adds the error of u and v at both ends of every line inside the exact polygon, as both are
    linear between them, and judges the texels that are fetched at all its pixels."""
    mapper, t = polygon.mapper, polygon.triangle or polygon.texturing
    numbers, rows, drawn = ideal.inner_rows(vertices, polygon)
    if not numbers:
        return
    lines = [polygon.lines[k] for k in numbers]
    sides = Side(polygon.left_edges, rows.ys), Side(polygon.right_edges, rows.ys)
    keys = ("u",) if mapper == "gouraud" else ("u", "v")
    stepped, last = ideal.gathered(polygon, numbers, rows, drawn), rows.starts + rows.counts - 1
    texels = fetched_inside(lines, mapper, size, stepped, rows, drawn)
    found, low, high, shown, past = [], [], [], [], 0.0  # errors, bounds at both ends; values, errors, bounds of a line
    for k, key in enumerate(keys):
        c, values = coordinate(vertices, k + 2, t, settings), stepped[k]
        errors, ends = coordinate_errors(c, values, rows, t, sides, settings)
        more = mapper_bounds(mapper, key, lines)
        found += [errors[rows.starts], errors[last]]
        low += [end[0] + more[0] for end in ends]
        high += [end[1] + more[1] for end in ends]
        side = 256 if mapper == "gouraud" else size[k]
        allowed = [np.maximum(*way) + far for way, far in zip(zip(*ends), more)]
        shown.append((key, texels[k], values, errors, side, allowed))
        past = max(past, past_edges(c.plane, polygon, settings))
    found, low, high = (np.stack(each, axis=1).ravel() for each in (found, low, high))
    if beyond is not None:
        longest = max(line.right - line.left for line in polygon.lines)
        held = 6 * (max(low.max(), high.max()) + beyond) + 3 * past + 2 * (longest + 1) * UNIT
        low, high = low * 0 + held, high * 0 + held
        shown = [(*rest, [np.full(len(rows), held)] * 2) for *rest, _ in shown]

    def at(k: int) -> tuple[str, tuple[int, int]]:
        row, way = divmod(k, 2 * len(keys))
        return keys[way // 2], (int((rows.ends - 1 if way % 2 else rows.lefts)[row]), int(rows.ys[row]))

    add_errors(found, low, high, at, out)
    suspects = [bounds_fetched.far_rows(rows, *rest) for _, *rest in shown]
    for number in np.flatnonzero(np.logical_or.reduce(suspects)).tolist():
        part = rows.part(number)
        for key, *arrays, side, allowed in shown:
            bounds_fetched.judge(key, *(each[part] for each in arrays), side, int(rows.lefts[number]),
                                 int(rows.ys[number]), tuple(each[number] for each in allowed), out)


def past_edges(plane: ideal.Plane, polygon: model.Polygon, settings: Settings) -> float:
    """Returns P: the most by which the plane's values at drawn pixels are beyond those inside the exact polygon."""
    if settings.has_exact_edges:
        return 0.0
    g, h = abs(plane.nx / plane.d), abs(plane.ny / plane.d)
    edges = (*polygon.left_edges, *polygon.right_edges)
    cut = 2 * UNIT * (g + h) if settings.clip == "vertices" else 0.0
    return g * max((edge_bound(edge, edge.end - 1) for edge in edges), default=0.0) + cut


def check_levels(vertices, polygon: model.Polygon, settings: Settings, out: Verdict) -> None:
    """Adds the error of the level at both ends of every line inside the exact polygon."""
    plane, light = ideal.plane_of(vertices, -1), polygon.shading
    numbers, rows, _ = ideal.inner_rows(vertices, polygon)
    if not numbers:
        return
    i, y = (np.stack(each, axis=1).ravel() for each in ((rows.lefts, rows.ends - 1), (rows.ys, rows.ys)))
    c, step, left = np.repeat([(line.c, line.dcdx, line.left) for line in (polygon.lines[k] for k in numbers)], 2,
                              axis=0).T
    errors = plane.errors_at(c + (i - left) * step, i, y)
    if polygon.triangle:
        bound = np.array([bounds_snapped.level_bound(abs(plane.nx / plane.d), polygon.triangle, *at)
                          for at in zip(i.tolist(), y.tolist())])
    else:
        t = light.plane
        (least, _), (most, _) = model.plane_range(vertices, t)
        beyond = max(0, light.low - least, most - light.high) * UNIT
        held = 6 * (plane.bound(i, y, t, t.u_cut).max() + beyond) + 3 * past_edges(plane, polygon, settings)
        bound = np.full(len(i), held + 8 * UNIT)
    add_errors(errors, bound, bound, lambda k: ("level", (int(i[k]), int(y[k]))), out)


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
        check_perspective.check_texels(adapted, polygon, settings.perspective,
                                        settings.tolerance * UNIT, size, out)
    elif polygon and settings.perspective != "none" and len({v[4] for v in adapted}) > 1:
        flat = tolerance.is_flat(adapted, settings.tolerance)
        check_perspective.check_flattened(adapted, polygon,
                                           settings.tolerance * UNIT if flat else None, size,
                                           out)
    elif polygon and polygon.textured and (on_plane or settings.clip == "scissor"):
        check_texels(adapted, polygon, settings, size,
                     held_beyond(adapted, polygon, settings, size), out)
    if polygon and polygon.mapper == "lit_gouraud":
        check_levels(adapted, polygon, settings, out)
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
