"""The integer model of triangles with snapped vertices: src68k/triangle, c/triangle.

Vertices are snapped to 1/16 pixel; edges are exact for these. Steps and starts of interpolated values
come from a table of reciprocals and 32-bit arithmetic, along the long edge, from the top vertex to
the bottom one. Lines are drawn away from it.
"""

from dataclasses import dataclass

from tmap.base.fixed import M32, ONE, signed
from tmap.build import layout
from tmap.setup.texturing import Line, Settings

M24 = (1 << 24) - 1
#: How far other triangles' edges begin below x + 1, 2^-21 pixel, and those that are FINER high: BELOW of
#: triangle_wide.i.
BELOW, BELOW_FINER = 64, 8
#: Widths of small triangles, pixels, by mapper and bytes a pixel; where tables of lines are made, none is.
SMALL_WIDTH = {("flat", 1): 32, ("gouraud", 1): 32, ("affine", 1): 16, ("arbitrary", 1): 16}
#: Numbers of a vertex that mappers interpolate; other mappers have no routine for triangles.
VALUES = {"flat": 0, "gouraud": 1, "affine": 2, "lit": 2, "lit_gouraud": 2, "arbitrary": 2}
#: Those with pixels of two and four bytes.
WIDE_PIXELS = ("flat", "affine")
#: The most corners of a polygon that is drawn as triangles.
CORNERS = 4

LIMITS = layout.load().constants
WIDTH, LINES, TEXELS, RAISED, FINER = (LIMITS[name] for name in (
    "SNAPPED_WIDTH", "SNAPPED_LINES", "SNAPPED_TEXELS", "SNAPPED_RAISED", "FINER_HEIGHT"))
#: Heights of small triangles, 1/16 line.
SMALL_HEIGHT = LIMITS["SMALL_HEIGHT"]
TALL, TALL_RAISED = 16 * LIMITS["SNAPPED_TALL"], 16 * LIMITS["TALL_RAISED"]
STEEP, STEEP_LEVELS = LIMITS["SHADES_STEEP"], LIMITS["LEVELS_STEEP"]
BELOW_MAP, ABOVE_MAP, SLIVER_MAP = (LIMITS[name] for name in ("BELOW_MAP", "ABOVE_MAP", "SLIVER_MAP"))
INSET = ONE // 16  # how far a level is kept inside its whole one


def snap(coordinate: int) -> int:
    """Rounds a coordinate, 16.16, to the nearest 1/16 pixel; the result counts sixteenths."""
    return coordinate + (1 << 11) >> 12


def reciprocal(dy: int) -> int:
    """Returns the table's reciprocal of a height in sixteenths of a line."""
    return min((1 << (39 if dy >= FINER else 31)) * 2 // dy + 1 >> 1, (1 << 31) - 1) if dy else 0


def below_of(dy: int) -> int:
    """Returns BELOW or BELOW_FINER. Starts of values are raised by as many units of 1/2^20."""
    return BELOW_FINER if dy >= FINER else BELOW


def towards_zero(part: int, whole: int) -> int:
    """Divides as divs does."""
    quotient = abs(part) // abs(whole)
    return quotient if (part < 0) == (whole < 0) else -quotient


@dataclass(frozen=True)
class Value:
    """An interpolated value: at the first line's first pixel, its steps a pixel away from the long
    edge, and a line as that edge moves by whole pixels; 16.16."""

    at: int
    pixel: int
    line: int


@dataclass(frozen=True)
class Triangle:
    """A set-up triangle. ``edges``: the long one's first pixel on each line, and the other side's;
    a line's pixels are from the left one's up to the right one's (excluded)."""

    top: int
    right: bool  # the long edge is on the right
    whole: int  # pixels that it moves a line, one more after a carry
    long: list[int]
    short: list[int]
    values: list[Value]
    raised: int  # what was added to values, 1/2^20
    by_spans: bool = False  # from a table of lines
    level: Value | None = None  # lit Gouraud

    @property
    def pixel_chain(self) -> int:
        """The step of u and v a pixel to the right, as the chain adds it; spans take v's modulo 256."""
        sign = -1 if self.right else 1
        u, v = (sign * value.pixel for value in self.values)
        return chain_of(u, signed(v, 24)) if self.by_spans else sign * chain_of(*(
            value.pixel for value in self.values))

    def level_at(self, n: int, column: int) -> int:
        """Returns the plane's level on a line and column, modulo 2^32."""
        step = -self.level.pixel if self.right else self.level.pixel
        down = self.level.line - self.whole * step & ~3
        at = self.level.at - (self.long[0] - self.right) * step & ~3
        return at + n * down + column * step

    def steps(self, line: int, column: int) -> tuple[int, int, int]:
        """Returns how a pixel is reached: lines, pixels added and taken away at carries, pixels
        along the line."""
        first = self.long[line]
        carries = first - self.long[0] - line * self.whole
        return line, carries, first - 1 - column if self.right else column - first


class Edge:
    """An edge from a vertex (x, y) over (dx, dy), in sixteenths."""

    def __init__(self, x: int, y: int, dx: int, dy: int, small: bool):
        slope = self.slope = self.slope_of(dx, dy)  # 32 bits of fraction
        self.x, self.y, self.dx, self.dy = x, y, dx, dy
        prestep = -y & 15
        if small:
            self.bits, self.step = 16, slope >> 16
            self.at = ((x + 16 << 16) + prestep * self.step >> 4) - 2
        else:
            self.bits, self.step = 32, slope
            self.at = (x + 16 << 17) + prestep * (slope >> 15) - below_of(dy) << 11  # the slope as 15.17

    @staticmethod
    def slope_of(dx: int, dy: int) -> int:
        """Returns dx / dy with 32 bits of fraction."""
        return dx * reciprocal(dy) >> 7 if dy >= FINER else 2 * dx * reciprocal(dy)

    def columns(self, count: int) -> list[int]:
        """Returns the first pixel at or right of the edge on its first lines."""
        return [self.at + n * self.step >> self.bits for n in range(count)]


def gradient(top, middle, bottom, key: int, area: int, small: bool, most: int,
             never_whole: bool = False) -> int:
    """Returns a value's step a pixel away from the long edge; 0 where it does not fit, or is not below
    ``most``. ``never_whole``: a whole negative step is a unit farther from 0, where the exact one may be as well."""
    n = (middle[key] - top[key]) * (bottom[1] - top[1]) \
        - (bottom[key] - top[key]) * (middle[1] - top[1])
    high = n >> 32
    sliver = area <= LIMITS["SLIVER_SMALL" if small else "SLIVER_WIDE"]
    if sliver and 2 * (high if high >= 0 else ~high) >= area:
        return 0
    found = towards_zero(n, area)
    if not -most <= found < most:
        return 0
    return found - (never_whole and found < 0 and not found & 0xFFFF)


def raised(edge: Edge) -> int:
    """Returns what is added to values at the start of a long edge, in 1/2^20."""
    return 0 if edge.bits == 16 else below_of(edge.dy) + TALL_RAISED * (edge.dy >= TALL)


def value_of(top, bottom, key: int, edge: Edge, pixel: int, right: bool) -> Value:
    """Returns a value along the long edge. ``pixel``: its gradient."""
    along = 2 * (bottom[key] - top[key]) * reciprocal(edge.dy) >> (40 if edge.dy >= FINER else 32)
    fraction = (edge.slope & M32) >> 1
    place = edge.at >> edge.bits - 16 & 0xFFFF
    away = place + 1 if right else 0xFFFF - place
    at = signed(top[key] + (-edge.y & 15) * along + raised(edge)) >> 4
    return Value(at + (away * pixel >> 16), pixel,
                 along - ((-fraction if right else fraction) * pixel >> 31))


def set_up(vertices, mapper: str, cull: bool = False, pixel_bytes: int = 1) -> Triangle | None:
    """Sets a triangle up; returns None if it covers no line or has no area. ``vertices``: (x, y,
    values ...): sixteenths of a pixel, and 1/2^20 of a texel or shade; more values are ignored."""
    if vertices[0][1] > vertices[1][1]:
        k = 2 if vertices[1][1] > vertices[2][1] else 1
    else:
        k = 2 if vertices[0][1] > vertices[2][1] else 0
    top, one, two = (vertices[(k + n) % 3] for n in range(3))
    area = (one[0] - top[0]) * (two[1] - top[1]) - (two[0] - top[0]) * (one[1] - top[1])
    if area == 0 or area < 0 and cull:
        return None
    if area < 0:
        one, two, area = two, one, -area
    right = two[1] < one[1]
    middle, bottom = (two, one) if right else (one, two)
    (x, y), dx, dy = top[:2], bottom[0] - top[0], bottom[1] - top[1]
    small = dy <= SMALL_HEIGHT and area <= dy * 16 * SMALL_WIDTH.get((mapper, pixel_bytes), 0)
    first, half, end = (v[1] + 15 >> 4 for v in (top, middle, bottom))
    if first == end:
        return None
    short: list[int] = []
    for a, b, lines in ((top, middle, half - first), (middle, bottom, end - half)):
        if lines:
            short += Edge(a[0], a[1], b[0] - a[0], b[1] - a[1], small).columns(lines)
    edge = Edge(x, y, dx, dy, small)
    most = STEEP << 16 if mapper == "gouraud" else 1 << 31
    steps = [gradient(top, middle, bottom, key, area, small, most, mapper == "gouraud")
             for key in range(2, 2 + VALUES[mapper])]
    values = [value_of(top, bottom, key, edge, step, right) for key, step in enumerate(steps, 2)]
    level = None
    if mapper == "lit_gouraud":
        step = gradient(top, middle, bottom, 4, area, small, STEEP_LEVELS << 16) & ~3
        level = value_of(top, bottom, 4, edge, step, right)
    return Triangle(first, right, edge.step >> edge.bits, edge.columns(end - first), short, values,
                    raised(edge), (mapper, pixel_bytes) not in SMALL_WIDTH, level)


def stays_in_map(vertices, size: tuple[int, int] | None) -> bool:
    """Returns true if no pixel of a triangle leaves a map that does not repeat, of 256x256 texels.
    With gradients below 86 texels a pixel values are up to 483 units below the exact ones and 1,835 above."""
    if len(vertices) != 3 or size != (256, 256):
        return False
    (x, y), (x1, y1), (x2, y2) = (map(snap, v[:2]) for v in vertices)
    area = abs((x1 - x) * (y2 - y) - (x2 - x) * (y1 - y))
    return all(BELOW_MAP <= c <= (side << 16) - ABOVE_MAP for v in vertices for c, side in zip(v[2:4], size)) \
        and area >= SLIVER_MAP * (max(y, y1, y2) - min(y, y1, y2))


def may_draw(vertices, settings: Settings, width: int, height: int, pixel_bytes: int = 1,
             size: tuple[int, int] | None = None) -> bool:
    """Returns true if routines for triangles draw a polygon in a frame. ``vertices``: x and y in
    1/65536 pixel, snapped or not, then u and v in 1/65536 texel; ``size``: the map's."""
    keys = VALUES.get(settings.mapper, -1)
    on_plane = (settings.gradients, settings.start, settings.perspective) == ("plane", "subtexel", "none")
    if settings.edges != "snapped" or keys < 0 or keys and not on_plane or len(vertices) > CORNERS \
            or pixel_bytes > 1 and settings.mapper not in WIDE_PIXELS \
            or settings.mapper == "arbitrary" and not stays_in_map(vertices, size):
        return False
    xs, ys = ([snap(v[k]) for v in vertices] for k in (0, 1))
    return (0 <= min(xs) and max(xs) <= 16 * min(width, WIDTH) and 0 <= min(ys)
            and max(ys) <= 16 * height and max(ys) - min(ys) < 16 * LINES
            and (keys < 2 or all(-TEXELS << 16 <= c < TEXELS << 16 for v in vertices for c in v[2:4])))


def converted(vertices, mapper: str) -> list[tuple]:
    """Returns (x, y, values ...) as in struct snapped_vertex, without what it adds to x and y."""
    made = [(snap(x), snap(y), *(value + RAISED << 4 for value in values[:VALUES[mapper]]))
            for x, y, *values in vertices]
    if mapper == "lit_gouraud":
        made = [(*v, min(max(level, (level & ~0xFFFF) + INSET), (level | 0xFFFF) - INSET) << 4)
                for v, (*_, level) in zip(made, vertices)]
    return made


def chain_of(u: int, v: int) -> int:
    """Packs a step of u and v as the chain adds it, modulo 2^48: u * 2^24 + v."""
    return (u - (v < 0) << 24) + (v & M24)


def chain_at(triangle: Triangle, n: int, pixels: int) -> int:
    """Returns u and v, as a chain holds them, ``n`` lines below the first pixel and ``pixels`` to the
    right."""
    u, v = triangle.values
    return (u.at << 24) + (v.at & M24) + n * chain_of(u.line, v.line) + pixels * triangle.pixel_chain


def lines(triangle: Triangle) -> list[Line]:
    """Returns a triangle's lines. A line's u is the chain's, in which u is one more each time v
    wraps; so it is with steps from line to line."""
    made, right = [], triangle.right
    sign = -1 if right else 1
    for n, ends in enumerate(zip(triangle.long, triangle.short)):
        left, end = reversed(ends) if right else ends
        line = Line(left, end)
        made.append(line)
        n, carries, along = triangle.steps(n, left)
        pixels = along + sign * carries
        found = [value.at + n * value.line + pixels * value.pixel & M32 for value in triangle.values]
        steps = [sign * value.pixel & M32 for value in triangle.values]
        if found:
            line.u, line.dudx = found[0], steps[0]
        if len(found) == 2:
            line.chain = chain_at(triangle, n, sign * pixels), triangle.pixel_chain
            line.u, line.v, line.dvdx = line.chain[0] >> 24 & M32, found[1], steps[1]
        if triangle.level:
            line.chain = None
            line.c = signed(triangle.level_at(n, left))
            line.dcdx = triangle.level_at(0, 1) - triangle.level_at(0, 0)
    return made
