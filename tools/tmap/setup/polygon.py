"""The integer model's set-up of a polygon: c/polygon and src68k/polygon formula by formula.

All coordinates are 16.16 (units of 1/65536 pixel or texel); gradients of the plane are 32.32 before
they are rounded to steps.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from tmap.base.fixed import M32, ONE, mul, signed
from tmap.setup import afar, cubic, far, level_reciprocal, snapped
from tmap.setup.clip import clip, frame_window
from tmap.setup.edges import Edge, Sides, measure, side
from tmap.setup.level import bends, columns_are_cheaper, is_chained, is_even, is_level, tilt_of
from tmap.setup.perspective import PIECES, Q_ONE, Perspective, perspective, way
from tmap.setup.shading import LIT, Shading, level_of, light_lines, shading
from tmap.setup.spans import stays_in_row
from tmap.setup.stepped import Stepped, stepped_of
from tmap.setup.texturing import (CUT, Line, Settings, Texturing, along, edge_starts, longest,
                                  plane, raised, ramp_point, scanline_line)
from tmap.setup.tolerance import coarser, is_flat

CORNERS_MAX = 64
FAR = 16384 << 16
INSET = ONE // 16  # see c/drawing/parts/clamp.c
ON_PLANE = 3 * INSET // 4
STEEP_4, STEEP_256 = 4 << 16, 256 << 16
HELD = ("gouraud", "arbitrary")  # mappers whose lines are held in a range
EDGES_32 = 4096  # texels a pixel times lines


@dataclass
class Polygon:
    """A set-up polygon: its lines from ``top`` on."""

    top: int
    lines: list[Line]
    texturing: Texturing | None
    left_edges: list[Edge]
    right_edges: list[Edge]
    textured: bool
    mapper: str = "affine"  # the mapper that draws it; affine if generated code cannot
    perspective: Perspective | None = None  # instead of texturing
    setting: str = "none"  # how the perspective is drawn
    exact: str = "none"  # whose pieces or curves draw lines exactly
    straight: bool = False  # the tolerance allows straight lines
    level: int = 0  # lit: the row of the light table
    shading: Shading | None = None  # lit Gouraud
    is_level: bool = False  # lines are drawn as if the perspective's depth did not change along them
    #: The same with x and y exchanged, if it is drawn by columns: they are its lines.
    columns: "Polygon | None" = None
    #: Of lines drawn by tables.
    constants: far.Constants | cubic.Constants | None = None
    triangle: snapped.Triangle | None = None  # drawn by a routine for triangles

    def record(self, line: Line, y: int):
        """Returns the record of the line at y for ``afar``; None if it is drawn another way."""
        return self.constants and afar.model_of(self.constants).line(self.perspective, self.constants,
                                                                     line.left, line.right, y)

    @cached_property
    def records(self) -> list:
        """``record`` of all lines."""
        return [self.record(line, y) for y, line in enumerate(self.lines, self.top)]

    @cached_property
    def stepped(self) -> Stepped:
        """u and v of all pixels."""
        return stepped_of(self)

    def coordinates(self, y: int) -> tuple[np.ndarray, np.ndarray]:
        """Returns u and v of the pixels of line y, int64, 16.16 modulo 2^32."""
        return self.stepped.line(y - self.top)

    @property
    def pixels(self) -> int:
        """The count of pixels drawn."""
        return sum(max(0, line.right - line.left) for line in self.lines)


def is_steep(settings: Settings, dudx: int, dvdx: int, lines: int) -> bool:
    """Returns true if the error of edges or gradients may move values out of the vertices' range by
    over INSET."""
    steep = max(abs(signed(step)) for step in (dudx, dvdx))
    if settings.gradients != "plane" or steep >= STEEP_256:
        return True
    if settings.has_exact_edges:
        return False
    return steep >= STEEP_4 if settings.clip == "vertices" \
        else ((steep >> 16) + 1) * (lines + 1) > EDGES_32


def plane_range(vertices, t: Texturing) -> tuple[list[int], list[int]]:
    """Returns the lowest u and v, and the highest, that the stepped plane has at the vertices."""
    planes = ((t.u, signed(t.dudx), signed(t.dudy)), (t.v, signed(t.dvdx), signed(t.dvdy)))
    values = [[signed(at + mul(ddx, v[0] - (t.i << 16)) + mul(ddy, v[1] - (t.j << 16)))
               for v in vertices] for at, ddx, ddy in planes]
    return [min(c) for c in values], [max(c) for c in values]


def held_range(vertices, settings: Settings, size: tuple[int, int] | None, t: Texturing | None,
               steep: bool):
    """Returns (low, high) of u and of v if lines must be held in a range; else None."""
    if settings.mapper not in HELD:
        return None
    low, high = ([f(v[k] for v in vertices) for k in (2, 3)] for f in (min, max))
    ranges = ([(low[0] & ~0xFFFF, high[0] | 0xFFFF), (0, 0)] if settings.mapper == "gouraud" else
              [(0, (side << 16) - 1) for side in size])
    inset = INSET
    if len(vertices) > 3 and not steep:  # the plane need not pass through all of them
        inset, (low, high) = ON_PLANE, plane_range(vertices, t)
    used = 1 if settings.mapper == "gouraud" else 2
    inside = all(a >= first + inset and b <= last - inset
                 for a, b, (first, last) in list(zip(low, high, ranges))[:used])
    return None if inside and not steep else ranges


def clamp(lines: list[Line], ranges) -> None:
    """Moves the lines, all with the same steps, so that no pixel leaves the ranges. Negative steps
    are made smaller by two units: a start may be moved a unit below the far border, and u must be
    above the exact value again one pixel on."""
    counts = [line.right - line.left for line in lines]
    longest_line = max(*counts, 1) - 1
    for line, count in zip(lines, counts):
        for coordinate, (low, high) in zip("uv", ranges):
            step = signed(getattr(line, f"d{coordinate}dx"))
            step = min(step + 2, 0) if step < 0 else step
            if longest_line:
                most = (high - low) // longest_line
                step = min(max(step, -most), most)
            setattr(line, f"d{coordinate}dx", step & M32)
            if count > 0:
                travel, start = (count - 1) * step, signed(getattr(line, coordinate))
                start = min(max(start, low - min(travel, 0)), high - max(travel, 0))
                setattr(line, coordinate, start & M32)


def scanline_lines(left: list[Edge], right: list[Edge], lines: list[Line],
                   settings: Settings) -> None:
    """Sets u, v and steps of each line by two divides."""
    sides = ([ramp_point(edge, point) for edge in edges for point in along(edge)]
             for edges in (left, right))
    cuts = CUT.get(settings.mapper, (0, 0))
    for line, a, b in zip(lines, *sides):
        if line.right > line.left:
            scanline_line(line, a, b, settings.start == "truncated")
            for name, cut in zip("uv", cuts):
                for field in (name, f"d{name}dx"):
                    setattr(line, field, raised(getattr(line, field), cut))


@dataclass
class Outline:
    """The source of the edges: the vertices, clipped if the settings say so, and their sides.
    ``corners``: those of the whole polygon, for the gradients."""

    corners: tuple[int, int, int]
    vertices: list[tuple]
    sides: Sides

    @property
    def box(self) -> tuple[int, int, int, int]:
        """Left, top, right and bottom of the box of pixels."""
        return self.sides.box

    def polygon(self, width: int, exact: bool, textured: bool, upright: bool = False) -> Polygon:
        """Returns the polygon with its edges and lines, which have no u and v yet."""
        _, top, _, bottom = self.box
        lefts, rights = (side(self.vertices, self.sides.corners[0], direction, top, bottom, exact, upright)
                         for direction in (self.sides.direction, -self.sides.direction))
        left, right = (first_columns(edges).tolist() for edges in (lefts, rights))
        lines = [Line(max(a, 0), min(b, width)) for a, b in zip(left, right)]
        return Polygon(top, lines, None, lefts, rights, textured)


def outline_of(vertices, width: int, height: int, settings: Settings) -> Outline | None:
    """Returns the outline of a polygon; None if it covers no pixel."""
    sides = measure(vertices, width, height)
    if sides is None:
        return None
    corners = sides.corners
    if settings.clip == "vertices" and not settings.has_exact_edges:
        clipped = clip(vertices, frame_window(width, height))
        if clipped != vertices:
            vertices, sides = clipped, measure(clipped, width, height)
    return Outline(corners, vertices, sides) if sides else None


def first_columns(edges: list[Edge]) -> np.ndarray:
    """Returns the first pixels of the lines of a side, before the frame cuts them."""
    return np.concatenate([edge.columns for edge in edges]) if edges else np.zeros(0, np.int64)


def plane_lines(polygon: Polygon, settings: Settings) -> None:
    """Sets u, v and steps of each line by the polygon's steps."""
    t, dudx, dvdx = polygon.texturing, polygon.texturing.dudx & M32, polygon.texturing.dvdx & M32
    starts = [start for edge in polygon.left_edges for start in edge_starts(t, edge, settings)]
    for line, column, (u, v) in zip(polygon.lines, first_columns(polygon.left_edges).tolist(), starts):
        cut = line.left - column
        line.u, line.v, line.dudx, line.dvdx = u + cut * dudx & M32, v + cut * dvdx & M32, dudx, dvdx


def set_texturing(polygon: Polygon, vertices, outline: Outline, settings: Settings,
                  size: tuple[int, int] | None, for_unit: bool) -> bool:
    """Sets u, v and steps of a polygon's lines; returns False if its corners have no area."""
    groups = [[line] for line in polygon.lines if line.right > line.left]
    if settings.gradients == "scanline":
        scanline_lines(polygon.left_edges, polygon.right_edges, polygon.lines, settings)
    else:
        corners, box = outline.corners, outline.box
        edge = polygon.left_edges[0]
        first = None if for_unit else (edge.column(edge.top), edge.top)
        polygon.texturing = plane(vertices, corners, box, settings, first) \
            if settings.gradients == "plane" else longest(vertices, corners, box, settings)
        if polygon.texturing is None:
            return False
        plane_lines(polygon, settings)
        groups = [polygon.lines]  # all with the same steps
    if settings.mapper not in HELD:
        return True
    for lines in groups:
        ranges = held_range(vertices, settings, size, polygon.texturing,
                            is_steep(settings, lines[0].dudx, lines[0].dvdx, len(polygon.lines)))
        if ranges:
            clamp(lines, ranges)
    return True


def set_level(polygon: Polygon, deep: Perspective, width: int, off: int, least: int,
              settings: Settings) -> str:
    """Returns how lines of so many pixels are drawn as if affine, "level" or "straight", and sets the tilt; else "".
    ``off``: how far they may be if their depth is constant; ``least``: q of the longest."""
    if is_level(deep, width, polygon.setting, off):
        return "level"
    if polygon.setting not in PIECES or polygon.setting != settings.perspective:
        return ""
    if settings.has_exact_edges and is_even(deep, width, polygon.setting):
        return "level"
    deep.tilt = (tilt := tilt_of(deep, width, least)) or 0
    return "" if tilt is None else "straight"


def turned_of(polygon: Polygon, vertices, box, size: tuple[int, int],
              settings: Settings) -> tuple[Perspective, list, Sides] | None:
    """Returns the planes, vertices and sides with x and y exchanged of a polygon with exact edges whose columns may
    be straight; else None. ``size``: the frame's."""
    turned = [(v[1], v[0], 0, 0) for v in vertices]
    sides = measure(turned, size[1], size[0])
    if not sides:
        return None
    deep = polygon.perspective.turned(sides.box[1], box[1])
    deep.base = tuple(b + way(polygon.setting).raised for b in deep.base)
    width, height = box[2] - box[0], box[3] - box[1]
    deep.chained = is_chained(deep, height, polygon.setting)
    shape = set_level(polygon, deep, height, 0, Q_ONE, settings)
    if not shape or not columns_are_cheaper(polygon.setting, shape, len(vertices), width, height):
        return None
    return deep, turned, sides


def columns_of(polygon: Polygon, found, height: int, size: tuple[int, int]) -> Polygon | None:
    """Returns the polygon of the columns that ``turned_of`` has found; None if they bend too much."""
    deep, turned, sides = found
    columns = Outline(sides.corners, turned, sides).polygon(size[1], True, True, True)
    columns.perspective, columns.setting, columns.is_level = deep, polygon.setting, True
    level_reciprocal.settle(deep, len(columns.lines), height, polygon.setting)
    level_reciprocal.settle_still(deep, height)
    return None if deep.tilt and bends(deep, columns.lines, height) else columns


def set_perspective(polygon: Polygon, vertices, outline: Outline, settings: Settings,
                    size: tuple[int, int], narrow: bool) -> bool:
    """Sets the planes of a polygon's perspective; returns False if it is drawn affine. ``size``: the
    frame's; ``narrow``: pixels have one byte, so that tables of lines and columns may draw it."""
    deep = perspective([v[:5] for v in vertices], outline.corners, outline.box)
    if deep is None or settings.tolerance and not deep.is_sure:
        return False
    width = outline.box[2] - outline.box[0]
    setting, straight = coarser(deep, width, settings.perspective, settings.tolerance)
    polygon.perspective, polygon.setting, polygon.straight = deep, setting, straight
    polygon.exact = afar.exact_setting(deep, setting, settings)
    deep.chained = is_chained(deep, width, setting)
    polygon.is_level = straight or bool(set_level(polygon, deep, width, way(setting).off, deep.least, settings))
    polygon.constants = afar.constants(deep, outline.box, setting, settings) if narrow else None
    is_short = afar.takes_short(deep, width, polygon.constants)
    polygon.is_level = polygon.is_level and not is_short
    if polygon.is_level and settings.has_exact_edges:
        level_reciprocal.settle(deep, outline.box[3] - outline.box[1], width, setting)
    turned = None if polygon.is_level or is_short or not (narrow and settings.has_exact_edges) else \
        turned_of(polygon, vertices, outline.box, size, settings)
    from_afar = isinstance(polygon.constants, (far.Constants, cubic.Constants)) and not polygon.is_level and not turned
    if not deep.is_sure and not from_afar:
        polygon.perspective, polygon.setting, polygon.constants = None, "none", None
        polygon.straight = polygon.is_level = False
        return False
    if turned:
        polygon.columns = columns_of(polygon, turned, outline.box[3] - outline.box[1], size)
    return True


def may_be_written(vertices, settings: Settings) -> bool:
    """Returns true if generated code is tried for a polygon: u of its vertices is within one row of
    the map, or up to a texel beside it, and all lines have the same steps."""
    us = [v[2] for v in vertices]
    first = min(us) + ONE & (256 << 16) - 1
    return settings.gradients != "scanline" and first + max(us) - min(us) <= 258 << 16


def set_up(vertices, width: int, height: int, textured: bool, settings: Settings = Settings(),
           size: tuple[int, int] | None = None, pixel_bytes: int = 1,
           for_unit: bool = False) -> Polygon | None:
    """Sets a polygon up for a frame; returns None if it is refused or covers no pixel.

    ``vertices``: a list of (x, y, u, v), with a perspective (x, y, u, v, w), 16.16, lit ones
    with their level last, as ``adapt`` returns them; ``size``: the map's, in texels; ``for_unit``: a
    texture unit's planes, all gradients in 32.32.
    """
    n = len(vertices)
    if not 3 <= n <= CORNERS_MAX or any(not -FAR <= c < FAR for v in vertices for c in v[:4]):
        return None
    if textured and settings.gradients == "polygon" and n != 3:
        return None
    by_routine = snapped.may_draw(vertices, settings, width, height, pixel_bytes, size)
    if settings.mapper == "generated" and not may_be_written(vertices, settings):
        settings = replace(settings, mapper="affine")
    outline = outline_of(vertices, width, height, settings)
    if outline is None:
        return None
    if by_routine:
        return by_triangles(vertices, outline, width, settings, pixel_bytes)
    polygon = outline.polygon(width, settings.has_exact_edges, textured)
    if settings.perspective != "none" and not is_flat(vertices, settings.tolerance) \
            and set_perspective(polygon, vertices, outline, settings, (width, height), pixel_bytes == 1):
        return set_light(polygon, vertices, outline, settings)
    if textured and not set_texturing(polygon, vertices, outline, settings, size, for_unit):
        return None
    by_code = settings.mapper != "generated" or all(map(stays_in_row, polygon.lines))
    return set_light(polygon, vertices, outline, settings if by_code else replace(settings, mapper="affine"))


def set_light(polygon: Polygon, vertices, outline: Outline, settings: Settings) -> Polygon:
    """Sets a polygon's mapper, and the levels of lit ones."""
    polygon.mapper = settings.mapper
    if settings.mapper == "lit":
        polygon.level = vertices[0][-1] >> 16
    elif settings.mapper == "lit_gouraud":
        polygon.shading = shading(vertices, outline.corners, outline.box)
        light_lines(polygon.lines, polygon.top, polygon.shading)
    return polygon


def by_triangles(vertices, outline: Outline, width: int, settings: Settings,
                 pixel_bytes: int) -> Polygon | None:
    """Returns the polygon that routines for triangles draw; None if it covers no line."""
    keys = snapped.VALUES[settings.mapper]
    triangle = snapped.set_up(snapped.converted(vertices, settings.mapper), settings.mapper, False,
                              pixel_bytes)
    if triangle is None:
        return None
    polygon = outline.polygon(width, True, keys > 0)
    polygon.mapper, polygon.triangle = settings.mapper, triangle
    polygon.lines = snapped.lines(triangle)
    if settings.mapper == "lit":
        polygon.level = vertices[0][-1] >> 16
    return polygon


def adapt(vertices, settings: Settings, longer: int) -> list[tuple]:
    """Converts (x, y, s, t, shade, w) for ``set_up``. x and y are cut to whole pixels if edges are
    integer, rounded to 1/16 if they are snapped. s and t are scaled, to the nearest, to texels of a map with the
    given longer side; w and a lit mapper's level follow. Gouraud's shade becomes u, INSET inside the range of its
    possible pixels, or, with snapped vertices, which polygons share, of its own whole shade."""
    if settings.edges == "integer":
        vertices = [(v[0] & ~0xFFFF, v[1] & ~0xFFFF, *v[2:]) for v in vertices]
    elif settings.edges == "snapped":
        vertices = [(*(signed(snapped.snap(c) << 12) for c in v[:2]), *v[2:]) for v in vertices]
    if settings.mapper == "gouraud":
        shades = [v[4] for v in vertices]
        ranges = [(shade, shade) if settings.edges == "snapped" else (min(shades), max(shades))
                  for shade in shades]
        return [(x, y, min(max(shade, (low & ~0xFFFF) + INSET), (high | 0xFFFF) - INSET), 0, *w)
                for (x, y, _, _, shade, *w), (low, high) in zip(vertices, ranges)]
    is_lit = settings.mapper in LIT
    return [(x, y, signed(s * longer + 128 >> 8), signed(t * longer + 128 >> 8), *w,
             *([level_of(shade)] if is_lit else []))
            for x, y, s, t, shade, *w in vertices]
