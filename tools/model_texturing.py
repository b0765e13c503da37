"""The integer model's texturing: src68k/polygon, src68k/edge,
c/polygon/texturing.c and ramps.c."""

from dataclasses import dataclass

from .fixed import M32, ONE, ceil16, cut_quotient, mul, mul_div, quotient, signed, step, wide_mul
from .model_edges import Edge

#: Mappers whose u and v share an addx chain.
CHAINED = ("affine", "lit")


@dataclass(frozen=True)
class Settings:
    """How a polygon is drawn: the choices of struct material."""

    edges: str = "subpixel"  # integer, subpixel, exact
    gradients: str = "plane"  # scanline, polygon, plane
    start: str = "subtexel"  # truncated, subtexel
    clip: str = "scissor"  # scissor, vertices
    perspective: str = "none"  # every16, every8, pixel, fine
    mapper: str = "affine"  # as struct material's, without MAPPER_
    tolerance: int = 0  # 1/65536 texel that less perspective may cost


@dataclass
class Line:
    """Pixels left to right - 1 of a line; u, v and their steps at pixel left, 16.16."""

    left: int
    right: int
    u: int = 0
    v: int = 0
    dudx: int = 0
    dvdx: int = 0
    c: int = 0  # level of light, and its step
    dcdx: int = 0


@dataclass
class Texturing:
    """Steps of u and v, 16.16 modulo 2^32; on the plane also u at pixel (i, j), v alike."""

    dudx: int
    dvdx: int
    spare: int  # 1: u's lowest bit is kept free ...
    guard: int  # ... and holds this
    wraps: bool
    dudy: int = 0
    dvdy: int = 0
    u: int = 0
    v: int = 0
    i: int = 0
    j: int = 0


def inside_period(dvdx: int, dvdy: int, v: int, box) -> bool:
    """Whether v, given at the box's middle, stays between two multiples of 256 texels."""
    left, top, right, bottom = box
    travel_x, travel_y = abs(signed(dvdx)) >> 8, abs(signed(dvdy)) >> 8
    travel = ((travel_x + 1) * ((right - left + 1) >> 1)
              + (travel_y + 1) * ((bottom - top + 1) >> 1) + 1)
    return (travel_x < 0x10000 and travel_y < 0x10000
            and travel <= v >> 8 & 0xFFFF < 0x10000 - travel)


def guarded(dvdx: int, width: int, wraps: bool) -> tuple[int, int, bool]:
    """spare, guard and wraps of struct texturing, where v may wrap in a chain."""
    speed = signed(dvdx, 24)
    once = ((abs(speed) >> 8) + 1) * width <= 0x10000
    spare = int(wraps and once)
    return spare, spare & (speed < 0), wraps and not once


def gradients(corners, key: int) -> tuple[int, int] | None:
    """What one number of three corners (x, y, ...) grows a pixel and a line on its plane, 32.32;
    None where the corners have no area."""
    a, b = ([p - q for p, q in zip(corner, corners[0])] for corner in corners[1:])
    d = a[0] * b[1] - b[0] * a[1]
    if d == 0:
        return None
    return (quotient(a[key] * b[1] - b[key] * a[1], d),
            quotient(a[0] * b[key] - b[0] * a[key], d))


def plane(vertices, corners, box, settings: Settings) -> Texturing | None:
    """The texture plane through three corners (indices), seen from the box's middle."""
    three = [vertices[k] for k in corners]
    found = [gradients(three, key) for key in (2, 3)]
    if None in found:
        return None
    (dsdx, dsdy), (dtdx, dtdy) = found
    left, top, right, bottom = box
    i, j = (left + right) >> 1, (top + bottom) >> 1
    x0, y0, u0, v0 = three[0][:4]
    x, y = signed((i << 16) - x0), signed((j << 16) - y0)
    u = u0 + wide_mul(dsdx, x) + wide_mul(dsdy, y) & M32
    v = v0 + wide_mul(dtdx, x) + wide_mul(dtdy, y) & M32
    dvdx, dvdy = step(dtdx, 0), step(dtdy, 0)
    chained = settings.mapper in CHAINED  # only their u and v share a chain
    inside = settings.start == "subtexel" and inside_period(dvdx, dvdy, v, box)
    spare, guard, wraps = guarded(dvdx, right - left, chained and not inside)
    return Texturing(step(dsdx, spare), dvdx, spare, guard, wraps, step(dsdy, spare), dvdy,
                     u & ~spare | guard, v, i, j)


def saturated_step(part: int, whole: int) -> int:
    """part / whole in 16.16, at most the largest number."""
    if abs(part) >> 15 >= abs(whole):
        return 0x7FFFFFFF if (part < 0) == (whole < 0) else -0x7FFFFFFF
    return mul_div(-part, ONE, -whole) if whole < 0 else mul_div(part, ONE, whole)


def longest(vertices, corners, box, settings: Settings) -> Texturing:
    """A triangle's steps from its longest scanline, the one through the middle vertex."""
    top, bottom, middle = (vertices[k] for k in corners)
    whole, part = ([p - q for p, q in zip(v, top)] for v in (bottom, middle))
    if whole[1] > 0:
        y = part[1]
        part = [p - mul_div(w, y, whole[1]) for p, w in zip(part, whole)]
    dudx, dvdx = (saturated_step(part[k], part[0]) if part[0] else 0 for k in (2, 3))
    spare, guard, wraps = guarded(dvdx, box[2] - box[0], settings.mapper in CHAINED)
    return Texturing(dudx & ~spare & M32, dvdx & M32, spare, guard, wraps)


def on_plane(t: Texturing, column: int, line: int) -> tuple[int, int]:
    """u and v at a pixel."""
    x, y = column - t.i, line - t.j
    return t.u + x * t.dudx + y * t.dudy, t.v + x * t.dvdx + y * t.dvdy


def along(edge: Edge) -> list[tuple[int, int, int]]:
    """x, u and v where an edge crosses its lines, 16.16."""
    whole = [b - a for a, b in zip(edge.upper, edge.lower)]
    y = (edge.top << 16) - edge.upper[1]
    several = edge.end - edge.top > 1
    first = [edge.upper[k] + mul_div(whole[k], y, whole[1]) for k in (2, 3)]
    steps = [mul_div(whole[k], ONE, whole[1]) if several else 0 for k in (2, 3)]
    return [(edge.at(line), *(f + n * d for f, d in zip(first, steps)))
            for n, line in enumerate(range(edge.top, edge.end))]


def edge_starts(t: Texturing, edge: Edge, settings: Settings) -> list[tuple[int, int]]:
    """u and v of an edge's lines at their first pixels, modulo 2^32."""
    columns = [edge.column(line) for line in range(edge.top, edge.end)]
    if settings.gradients == "plane" and settings.start == "subtexel":
        return [on_plane(t, c, line) for line, c in enumerate(columns, edge.top)]
    x, slope = edge.at(edge.top), edge.slope
    prestep = signed((columns[0] << 16) - x)
    moves = [signed(t.dudx), signed(t.dvdx)]
    if settings.gradients == "plane":
        first = [c - mul(m, prestep) for c, m in zip(on_plane(t, columns[0], edge.top), moves)]
        steps = [d + mul(m, slope) for d, m in zip((t.dudy, t.dvdy), moves)]
    else:
        crossings = along(edge)
        first = list(crossings[0][1:])
        steps = [b - a for a, b in zip(first, crossings[min(1, len(crossings) - 1)][1:])]
        if settings.start == "subtexel":
            first = [f + mul(m, prestep) for f, m in zip(first, moves)]
            steps = [d + mul(m, signed((edge.whole << 16) - slope)) for d, m in zip(steps, moves)]
    first[0] = first[0] & ~t.spare | t.guard
    steps[0] &= ~t.spare
    starts = []
    for n, column in enumerate(columns):
        more = column - columns[0] - n * edge.whole if settings.start == "subtexel" else 0
        starts.append(tuple(f + n * d + more * m for f, d, m in zip(first, steps, moves)))
    return starts


def scanline_line(line: Line, left: tuple, right: tuple, truncated: bool) -> None:
    """Sets u, v and steps of a line with pixels by two divides."""
    rise = [signed(b - a) for a, b in zip(left[1:], right[1:])]
    if truncated:
        first = ceil16(left[0])
        pixels = ceil16(right[0]) - first
        steps = [cut_quotient(r, pixels) if pixels > 0 else 0 for r in rise]
        moves = [(line.left - first) * s for s in steps]
    else:
        width, prestep = min(right[0] - left[0], 0x7FFFFFFF), (line.left << 16) - left[0]
        if width >= ONE:
            steps = [cut_quotient(r << 16, width) for r in rise]
            moves = [mul(s, prestep) for s in steps]
        else:
            prestep = min(max(prestep, 0), width)
            steps = [0, 0]
            moves = [cut_quotient(r * prestep, width) if width > 0 else 0 for r in rise]
    line.u, line.v = (a + m & M32 for a, m in zip(left[1:], moves))
    line.dudx, line.dvdx = (s & M32 for s in steps)
