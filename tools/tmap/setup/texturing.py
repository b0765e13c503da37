"""The integer model's texturing: src68k/polygon, src68k/edge,
c/polygon/texturing.c and ramps.c."""

from dataclasses import dataclass

import numpy as np

from tmap.base.fixed import (M32, ONE, Number, ceil16, cut_quotient, mul, mul_div, quotient, signed, step,
                             wide_mul)
from tmap.setup.edges import Edge

#: Mappers whose u and v share an addx chain.
CHAINED = ("affine", "keyed", "lit")
#: Texels per pixel from which on the shortfall of a step without a plane is not compensated.
STEEP_256 = 256
#: Bits of the fraction of gentle gradients.
GENTLE = 26
#: How far v of a gentle plane's pixels may be outside the range of the vertices' v, units: MARGIN of
#: src68k/polygon/texturing_gentle.s.
MARGIN = ONE // 2
#: The longest way of a gentle plane, pixels: WAYS_MOST of src68k/include/gentle.i.
WAYS_MOST = 240
#: Units by which values of a gentle plane are raised beside their steps, as there.
RAISED = 5
#: Low bits of u and v that a mapper's spans drop; "levels": those of levels of light.
CUT = {"tiled": (0, 1), "columns": (3, 3), "levels": (2, 0)}


@dataclass(frozen=True)
class Settings:
    """How a polygon is drawn: the choices of struct material."""

    edges: str = "subpixel"  # integer, subpixel, snapped, exact
    gradients: str = "plane"  # scanline, polygon, plane
    start: str = "subtexel"  # truncated, subtexel
    clip: str = "scissor"  # scissor, vertices
    perspective: str = "none"  # every16, every8, pixel, fine
    mapper: str = "affine"  # as struct material's, without MAPPER_
    tolerance: int = 0  # error allowed to simpler perspective, 1/65536 texel

    @classmethod
    def of(cls, material) -> "Settings":
        """Returns the settings of a scene's material."""
        return cls(material.edges, material.gradients, material.start, material.clip,
                   material.perspective, material.mapper, material.tolerance)

    @property
    def has_exact_edges(self) -> bool:
        """True if no pixel is wrong beside the edges of the vertices that ``adapt`` returns."""
        return self.edges in ("snapped", "exact")


def raised(value: int, cut: int) -> int:
    """Rounds a number up to a multiple of 2^cut, modulo 2^32."""
    return value + (1 << cut) - 1 >> cut << cut & M32


@dataclass
class Line:
    """Pixels left to right - 1 of a line; u, v and their steps at pixel left, 16.16."""

    left: int
    right: int
    u: int = 0
    v: int = 0
    dudx: int = 0
    dvdx: int = 0
    c: int = 0  # level of light; its step is dcdx
    dcdx: int = 0
    chain: tuple[int, int] | None = None  # u and v, and their steps, in one number: u * 2^24 + v


@dataclass
class Texturing:
    """Steps of u and v, 16.16 modulo 2^32; for a plane also u and v at pixel (i, j)."""

    dudx: int
    dvdx: int
    u_cut: int  # low bits of u that the spans drop ...
    wrap_bit: int  # ... and their value: 1 if v falls in a chain
    wraps: bool
    v_cut: int = 0
    dudy: int = 0
    dvdy: int = 0
    u: int = 0
    v: int = 0
    i: int = 0
    j: int = 0
    box: tuple[int, int, int, int] = (0, 0, 0, 0)  # the box of pixels around (i, j)
    gentle: bool = False  # the plane is one of ``gentle_plane``

    @property
    def cuts(self) -> tuple[int, int]:
        """The low bits of u and of v that the spans drop."""
        return self.u_cut, self.v_cut


def inside_period(dvdx: int, dvdy: int, v: int, box) -> bool:
    """Returns true if v, given at the box's middle, stays between two multiples of 256 texels."""
    left, top, right, bottom = box
    travel_x, travel_y = abs(signed(dvdx)) >> 8, abs(signed(dvdy)) >> 8
    travel = ((travel_x + 1) * ((right - left + 1) >> 1)
              + (travel_y + 1) * ((bottom - top + 1) >> 1) + 1)
    return (travel_x < 0x10000 and travel_y < 0x10000
            and travel <= v >> 8 & 0xFFFF < 0x10000 - travel)


def inside_vertices(vertices) -> bool:
    """Returns true if v of the vertices, and of all pixels of a gentle plane, is between the same two
    multiples of 256 texels."""
    vs = [v[3] for v in vertices]
    return signed(min(vs) - MARGIN) >> 24 == signed(max(vs) + MARGIN) >> 24


def wrap_bits(dvdx: int, width: int, wraps: bool) -> tuple[int, int, bool]:
    """Returns u_cut, wrap_bit and wraps of struct texturing; ``wraps``: v may wrap in a chain."""
    speed = signed(dvdx, 24)
    once = ((abs(speed) >> 8) + 1) * width <= 0x10000
    has_wrap_bit = int(wraps and once)
    return has_wrap_bit, has_wrap_bit & (speed < 0), wraps and not once


def whole_texels(gradient: int) -> int:
    """Returns a 32.32 gradient's magnitude in whole texels, rounded down, or one less."""
    return (gradient ^ gradient >> 63) >> 32


def shortfall(found: tuple[int, int], steps: tuple[int, int], ways: tuple[int, int], way: int) -> int:
    """Returns the units by which a coordinate may be below its plane at any pixel of a box, rounded
    up.

    ``found``: the gradients, 32.32; ``steps``: the gradients rounded to 16.16; ``ways``: pixels
    from the middle of the box to its sides; ``way``: pixels from the first corner to the farthest,
    the sum of x and y. Steps that were rounded by r units add an error of r units per pixel. The
    gradients themselves are off by |g| / 2^31 + 3 / 2^32 texels per pixel, the value in the middle
    by a unit.
    """
    rounded = sum(abs(signed((s << 16) - g, 40)) * w for g, s, w in zip(found, steps, ways))
    cut = (sum(whole_texels(g) for g in found) + 5 & M32) * 2 * way
    return (rounded >> 16) + (cut >> 16) + 3


def gradients(corners, key: int) -> tuple[int, int] | None:
    """Returns the gradients, per pixel and per line, of the plane through one number of three
    corners (x, y, ...), 32.32; None if the corners have no area."""
    a, b = ([p - q for p, q in zip(corner, corners[0])] for corner in corners[1:])
    d = a[0] * b[1] - b[0] * a[1]
    if d == 0:
        return None
    return (quotient(a[key] * b[1] - b[key] * a[1], d),
            quotient(a[0] * b[key] - b[0] * a[key], d))


def gentle_gradients(corners, key: int) -> tuple[int, int] | None:
    """Returns ``gradients`` in 6.26, as ``texturing_gentle`` finds them; None if it does not."""
    a, b = ([p - q for p, q in zip(corner, corners[0])] for corner in corners[1:])
    d = a[0] * b[1] - b[0] * a[1]
    if d < 0:
        a, b, d = b, a, -d
    numerators = a[key] * b[1] - b[key] * a[1], a[0] * b[key] - b[0] * a[key]
    if not 1 << 31 <= d < 1 << 52:
        return None
    top = d.bit_length() - 1
    inverse = ((1 << 61) - 1) // (d >> top - 30)
    upper = [n >> top - 27 for n in numerators]
    if not all(-1 << 31 <= n < 1 << 31 for n in upper):
        return None
    return tuple(n * inverse >> 32 for n in upper)


def gentle_shortfall(ways: int, cut: int) -> int:
    """Returns the units by which a coordinate may be below its plane at any pixel of a box, rounded up,
    with gradients in 6.26.

    ``ways``: pixels from the first pixel to the box's farthest sides, the sum of x and y. Steps are off
    by half of 2^cut units; RAISED is for gradients, by 2.5 in 2^26 over up to 1,270 pixels, and for the
    value at the first pixel, by a unit.
    """
    return (ways << cut >> 1) + RAISED


def gentle_axis(corner: int, both: tuple[int, int], away, ways: int,
                cut: int) -> tuple[int, int, int]:
    """Returns steps and raised value of a coordinate with gradients in 6.26; ``corner``: its value
    at the first corner."""
    low = GENTLE - 16 + cut
    steps = [g + (1 << low - 1) >> low << cut for g in both]
    at = corner + sum(g * (a << 6) + (1 << 31) >> 32 for g, a in zip(both, away))
    return *(s & M32 for s in steps), raised(at + gentle_shortfall(ways, cut), cut)


def gentle_plane(vertices, corners, box, settings: Settings, first: tuple[int, int]) -> Texturing | None:
    """Returns ``plane`` relative to the pixel ``first``, the first one right of the left side; None if
    it is not gentle."""
    three = [vertices[k] for k in corners]
    found = [gentle_gradients(three, key) for key in (2, 3)]
    away = [signed((at << 16) - corner) for at, corner in zip(first, three[0])]
    if None in found or not all(-1 << 25 <= a < 1 << 25 for a in away):
        return None
    left, _, right, bottom = box
    i, j = first
    ways = max(right - i, i - left) + bottom - j
    if ways > WAYS_MOST:
        return None

    def coordinate(key: int, cut: int) -> tuple[int, int, int]:
        return gentle_axis(three[0][2 + key], found[key], away, ways, cut)

    u_cut, v_cut = CUT.get(settings.mapper, (0, 0))
    dvdx, dvdy, v = coordinate(1, v_cut)
    inside = settings.start == "subtexel" and inside_vertices(vertices)
    has_wrap_bit, wrap_bit, wraps = wrap_bits(dvdx, right - left,
                                              settings.mapper in CHAINED and not inside)
    dudx, dudy, u = coordinate(0, u_cut or has_wrap_bit)
    return Texturing(dudx, dvdx, u_cut or has_wrap_bit, wrap_bit, wraps, v_cut, dudy, dvdy,
                     u | wrap_bit, v, i, j, box, True)


def plane(vertices, corners, box, settings: Settings,
          first: tuple[int, int] | None = None) -> Texturing | None:
    """Returns the texture plane through three corners (indices), relative to the box's middle; None
    if the corners have no area. ``first``: the pixel for ``gentle_plane``, which is tried before."""
    three = [vertices[k] for k in corners]
    found = [gradients(three, key) for key in (2, 3)]
    if None in found:
        return None
    gentle = first and gentle_plane(vertices, corners, box, settings, first)
    if gentle:
        return gentle
    left, top, right, bottom = box
    i, j = (left + right) >> 1, (top + bottom) >> 1
    away = [signed((at << 16) - corner) for at, corner in zip((i, j), three[0])]
    ways = i - left, j - top
    way = sum(abs(a) >> 16 for a in away) + sum(ways) + 2

    def coordinate(key: int, cut: int) -> tuple[int, int, int]:
        both = found[key]
        steps = [step(g, cut) for g in both]
        at = three[0][2 + key] + sum(wide_mul(g, a) for g, a in zip(both, away))
        at += shortfall(both, steps, ways, way)
        return *steps, raised(at, cut)

    u_cut, v_cut = CUT.get(settings.mapper, (0, 0))
    dvdx, dvdy, v = coordinate(1, v_cut)
    chained = settings.mapper in CHAINED  # only their u and v share a chain
    inside = settings.start == "subtexel" and inside_period(dvdx, dvdy, v, box)
    has_wrap_bit, wrap_bit, wraps = wrap_bits(dvdx, right - left, chained and not inside)
    dudx, dudy, u = coordinate(0, u_cut or has_wrap_bit)
    return Texturing(dudx, dvdx, u_cut or has_wrap_bit, wrap_bit, wraps, v_cut, dudy, dvdy,
                     u | wrap_bit, v, i, j, box)


def saturated_step(part: int, whole: int) -> int:
    """Returns part / whole in 16.16, saturated to the largest number."""
    if abs(part) >> 15 >= abs(whole):
        return 0x7FFFFFFF if (part < 0) == (whole < 0) else -0x7FFFFFFF
    return mul_div(-part, ONE, -whole) if whole < 0 else mul_div(part, ONE, whole)


def longest(vertices, corners, box, settings: Settings) -> Texturing:
    """Returns a triangle's steps from its longest scanline, the one through the middle vertex."""
    top, bottom, middle = (vertices[k] for k in corners)
    whole, part = ([p - q for p, q in zip(v, top)] for v in (bottom, middle))
    if whole[1] > 0:
        above = min(((part[1] << 31) + (whole[1] >> 1)) // whole[1], (1 << 31) - 1)  # 0.31
        part = [p - (w * above + (1 << 30) >> 31) for p, w in zip(part, whole)]
    dudx, dvdx = (saturated_step(part[k], part[0]) if part[0] else 0 for k in (2, 3))
    has_wrap_bit, wrap_bit, wraps = wrap_bits(dvdx, box[2] - box[0], settings.mapper in CHAINED)
    u_cut, v_cut = CUT.get(settings.mapper, (0, 0))
    u_cut = u_cut or has_wrap_bit
    dudx, dvdx = (step + (1 << cut >> 1) >> cut << cut & M32
                  for step, cut in ((dudx, u_cut), (dvdx, v_cut)))
    return Texturing(dudx, dvdx, u_cut, wrap_bit, wraps, v_cut, box=box)


def edge_shortfall(step: int, cut: int, lines: int, width: int, start: str) -> int:
    """Returns the units by which u may fall short without a plane, along a left edge of ``lines``
    lines and along the lines that begin there: see ``shortfall`` in c/polygon/texturing.c."""
    whole = (abs(signed(step)) >> 16) + 2
    coarse = (1 << cut) + 1 if cut else 1
    line = 3 + whole if start == "subtexel" else 1
    return 0 if whole > STEEP_256 else (lines * line + (width + 1) * coarse >> 1) + 4 * whole + 4


def on_plane(t: Texturing, column: Number, line: Number) -> tuple[Number, Number]:
    """Returns u and v at a pixel, or at several."""
    x, y = column - t.i, line - t.j
    return t.u + x * t.dudx + y * t.dudy, t.v + x * t.dvdx + y * t.dvdy


def along(edge: Edge) -> list[tuple[int, int, int]]:
    """Returns x, u and v where an edge crosses its lines, 16.16."""
    whole = [b - a for a, b in zip(edge.upper, edge.lower)]
    y = (edge.top << 16) - edge.upper[1]
    several = edge.end - edge.top > 1
    first = [edge.upper[k] + mul_div(whole[k], y, whole[1]) for k in (2, 3)]
    steps = [mul_div(whole[k], ONE, whole[1]) if several else 0 for k in (2, 3)]
    n = np.arange(edge.end - edge.top)
    return list(zip(edge.at(edge.top + n).tolist(), *((f + n * d).tolist() for f, d in zip(first, steps))))


def ramp_point(edge: Edge, point: tuple[int, int, int]) -> tuple[int, int, int]:
    """Returns x, u and v of an edge's crossing for lines with two divides. u and v are raised by
    their shortfall along the edge, half a unit per line, and by two units for later cuts."""
    x, u, v = point
    more = (edge.end - edge.top + 1) // 2 + 2
    return x, u + more, v + more


def edge_starts(t: Texturing, edge: Edge, settings: Settings) -> list[tuple[int, int]]:
    """Returns u and v of an edge's lines at their first pixels, modulo 2^32."""
    columns, n = edge.columns, np.arange(edge.end - edge.top)
    if settings.gradients == "plane" and settings.start == "subtexel":
        return list(zip(*(each.tolist() for each in on_plane(t, columns, edge.top + n))))
    x, slope = edge.at(edge.top), edge.slope
    prestep = signed((int(columns[0]) << 16) - x)
    moves = [signed(t.dudx), signed(t.dvdx)]
    if settings.gradients == "plane":
        first = [c - mul(m, prestep) for c, m in zip(on_plane(t, int(columns[0]), edge.top), moves)]
        steps = [d + mul(m, slope) for d, m in zip((t.dudy, t.dvdy), moves)]
    else:
        crossings = along(edge)
        first = list(crossings[0][1:])
        steps = [b - a for a, b in zip(first, crossings[min(1, len(crossings) - 1)][1:])]
        if settings.start == "subtexel":
            first = [f + mul(m, prestep) for f, m in zip(first, moves)]
            steps = [d + mul(m, signed((edge.whole << 16) - slope)) for d, m in zip(steps, moves)]
        first = [f + edge_shortfall(m, cut, edge.end - edge.top, t.box[2] - t.box[0], settings.start)
                 for f, m, cut in zip(first, moves, t.cuts)]
    first = [raised(f, cut) for f, cut in zip(first, t.cuts)]
    first[0] |= t.wrap_bit
    steps = [raised(s, cut) for s, cut in zip(steps, t.cuts)]
    more = columns - columns[0] - n * edge.whole if settings.start == "subtexel" else 0 * n
    return list(zip(*((f + n * d + more * m).tolist() for f, d, m in zip(first, steps, moves))))


def scanline_line(line: Line, left: tuple, right: tuple, truncated: bool) -> None:
    """Sets u, v and steps of a line with pixels by two divides."""
    rise = [signed(b - a) for a, b in zip(left[1:], right[1:])]
    if truncated:
        first = ceil16(left[0])
        pixels = ceil16(right[0]) - first
        steps = [-(-r // pixels) if pixels > 0 else 0 for r in rise]
        moves = [(line.left - first) * s for s in steps]
    else:
        width, prestep = min(right[0] - left[0], 0x7FFFFFFF), (line.left << 16) - left[0]
        if width >= ONE:
            steps = [-(-(r << 16) // width) for r in rise]
            moves = [mul(s, prestep) for s in steps]
        else:
            prestep = min(max(prestep, 0), width)
            steps = [0, 0]
            moves = [cut_quotient(r * prestep, width) if width > 0 else 0 for r in rise]
    line.u, line.v = (a + m & M32 for a, m in zip(left[1:], moves))
    line.dudx, line.dvdx = (s & M32 for s in steps)
