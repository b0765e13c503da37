"""The integer model: the renderer's own arithmetic, in Python integers.

It follows c/polygon and src68k/math formula by formula and must agree with the
68020 bit for bit. It knows nothing of forms: addx, swap and C draw the same
picture, because every number that decides a pixel depends on the pixel alone.

All coordinates are 16.16 (units of 1/65536 pixel or texel); gradients of the
plane are 32.32 before they are rounded to steps.

What it may be off from the ideal, and why, stands in tools/ideal.py.
"""

from dataclasses import dataclass, replace

import numpy as np

from . import maps
from .clip import clip, frame_window, mul_div

FAR = 16384 << 16
EDGE_ERROR = 1024
M32 = (1 << 32) - 1


def signed(value: int, bits: int = 32) -> int:
    """The low ``bits`` of a value as a two's complement number."""
    value &= (1 << bits) - 1
    return value - (value >> (bits - 1) << bits)


def ceil16(x: int) -> int:
    """The smallest integer not below a 16.16 number."""
    return (x + 0xFFFF) >> 16


def mul(a: int, b: int) -> int:
    """a * b of two 16.16 numbers, rounded down."""
    return a * b >> 16


def quotient(n: int, d: int) -> int:
    """n / d in 32.32 modulo 2^64, as ``gradients`` divides: d keeps 32 bits."""
    if n == 0:
        return 0
    sign = -1 if (n < 0) != (d < 0) else 1
    n, d = abs(n), abs(d)
    shifts_n, shifts_d = 64 - n.bit_length(), 64 - d.bit_length()
    upper = (d << shifts_d) >> 32
    q = ((n << shifts_n >> 1) << 32) // upper
    right = 31 + shifts_n - shifts_d
    q = q >> right if right >= 0 else q << -right
    return signed(sign * (q & ((1 << 64) - 1)), 64)


def wide_mul(gradient: int, offset: int) -> int:
    """A 32.32 gradient times a 16.16 offset, in 16.16 modulo 2^32."""
    return (gradient * offset + (1 << 31)) >> 32 & M32


def step(gradient: int, spare: int) -> int:
    """A 32.32 gradient as a 16.16 step modulo 2^32 whose ``spare`` low bits are 0."""
    return ((gradient + (0x8000 << spare)) >> 16 & M32) >> spare << spare


@dataclass(frozen=True)
class Settings:
    """How a polygon is drawn: the choices of struct material."""

    edges: str = "subpixel"  # integer, subpixel, exact
    gradients: str = "plane"  # scanline, polygon, plane
    start: str = "subtexel"  # truncated, subtexel
    clip: str = "scissor"  # scissor, vertices


@dataclass
class Edge:
    """A side's section: from one vertex to a lower one, drawn on lines top to end - 1."""

    upper: tuple
    lower: tuple
    top: int
    end: int
    exact: bool

    @property
    def first(self) -> int:
        """The first line at or below the upper vertex."""
        return ceil16(self.upper[1])

    @property
    def slope(self) -> int:
        """Pixels a line, 16.16; 0 where the edge has one line only."""
        width, height = self.lower[0] - self.upper[0], self.lower[1] - self.upper[1]
        return mul_div(width, 65536, height) if ceil16(self.lower[1]) - self.first > 1 else 0

    def at(self, line: int) -> int:
        """x on a line, 16.16, rounded at the first line and in every step."""
        width, height = self.lower[0] - self.upper[0], self.lower[1] - self.upper[1]
        x = self.upper[0] + mul_div(width, (self.first << 16) - self.upper[1], height)
        return x + (line - self.first) * self.slope

    def column(self, line: int) -> int:
        """The first pixel at or right of the edge."""
        if not self.exact:
            return ceil16(self.at(line))
        (x0, y0, *_), (x1, y1, *_) = self.upper, self.lower
        n = x0 * (y1 - y0) + (x1 - x0) * ((line << 16) - y0)
        return -(-n // (y1 - y0 << 16))

    @property
    def whole(self) -> int:
        """Whole pixels a line."""
        width, height = self.lower[0] - self.upper[0], self.lower[1] - self.upper[1]
        return width // height if self.exact else self.slope >> 16


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


@dataclass
class Line:
    """Pixels left to right - 1 of a line; u, v and their steps at pixel left."""

    left: int
    right: int
    u: int = 0
    v: int = 0
    dudx: int = 0
    dvdx: int = 0


@dataclass
class Polygon:
    """What the set-up makes of a polygon: its lines from ``top`` on."""

    top: int
    lines: list[Line]
    texturing: Texturing | None
    left_edges: list[Edge]
    right_edges: list[Edge]
    textured: bool

    @property
    def pixels(self) -> int:
        """Pixels drawn."""
        return sum(max(0, line.right - line.left) for line in self.lines)


@dataclass
class Sides:
    """Top, bottom and the vertex farthest from the line between them (indices), which
    way the left side runs, and the box of pixels: left, top, right, bottom."""

    corners: tuple[int, int, int]
    direction: int
    box: tuple[int, int, int, int]


def measure(vertices, width: int, height: int) -> Sides | None:
    """The sides of a polygon; None where it covers nothing."""
    n = len(vertices)
    if n < 3:
        return None
    top = min(range(n), key=lambda k: (vertices[k][1], vertices[k][0]))
    bottom = min(range(n), key=lambda k: (-vertices[k][1], vertices[k][0]))
    x_low, x_high = min(v[0] for v in vertices), max(v[0] for v in vertices)
    box = (max(ceil16(x_low - EDGE_ERROR), 0), max(ceil16(vertices[top][1]), 0),
           min(ceil16(x_high + EDGE_ERROR), width), min(ceil16(vertices[bottom][1]), height))
    if box[0] >= box[2] or box[1] >= box[3]:
        return None
    ax, ay = vertices[top][:2]
    dx, dy = vertices[bottom][0] - ax, vertices[bottom][1] - ay
    turns = [dx * (v[1] - ay) - (v[0] - ax) * dy for v in vertices]
    apex = min(range(n), key=lambda k: (-abs(turns[k]), vertices[k][1], vertices[k][0]))
    if turns[apex] == 0:
        return None
    forward = (apex - top) % n < (bottom - top) % n
    return Sides((top, bottom, apex), 1 if (turns[apex] > 0) == forward else -1, box)


def side(vertices, start: int, direction: int, top: int, bottom: int, exact: bool) -> list[Edge]:
    """The edges of one side from the top vertex on, between two lines."""
    edges, index, upper = [], start, vertices[start]
    while top < bottom:
        index = (index + direction) % len(vertices)
        lower = vertices[index]
        end = min(ceil16(lower[1]), bottom)
        if end > top and lower[1] > upper[1]:
            edges.append(Edge(upper, lower, top, end, exact))
            top = end
        upper = lower
    return edges


def guarded(dvdx: int, width: int, inside: bool) -> tuple[int, int, bool]:
    """spare, guard and wraps of struct texturing."""
    speed = signed(dvdx, 24)
    once = ((abs(speed) >> 8) + 1) * width <= 0x10000
    spare = int(not inside and once)
    return spare, spare & (speed < 0), not inside and not once


def plane(vertices, corners, box, subtexel: bool) -> Texturing | None:
    """The texture plane through three corners (indices), seen from the box's middle."""
    a, b, c = (vertices[k] for k in corners)
    e1, e2 = ([p - q for p, q in zip(v, a)] for v in (b, c))

    def cross(p, q):
        return e1[p] * e2[q] - e2[p] * e1[q]

    d = cross(0, 1)
    if d == 0:
        return None
    dsdx, dsdy = quotient(cross(2, 1), d), quotient(cross(0, 2), d)
    dtdx, dtdy = quotient(cross(3, 1), d), quotient(cross(0, 3), d)
    left, top, right, bottom = box
    i, j = (left + right) >> 1, (top + bottom) >> 1
    x, y = signed((i << 16) - a[0]), signed((j << 16) - a[1])
    u = a[2] + wide_mul(dsdx, x) + wide_mul(dsdy, y) & M32
    v = a[3] + wide_mul(dtdx, x) + wide_mul(dtdy, y) & M32
    dvdx, dvdy = step(dtdx, 0), step(dtdy, 0)

    travel_x, travel_y = abs(signed(dvdx)) >> 8, abs(signed(dvdy)) >> 8
    travel = ((travel_x + 1) * ((right - left + 1) >> 1)
              + (travel_y + 1) * ((bottom - top + 1) >> 1) + 1)
    inside = (subtexel and travel_x < 0x10000 and travel_y < 0x10000
              and travel <= v >> 8 & 0xFFFF < 0x10000 - travel)
    spare, guard, wraps = guarded(dvdx, right - left, inside)
    return Texturing(step(dsdx, spare), dvdx, spare, guard, wraps, step(dsdy, spare), dvdy,
                     u & ~spare | guard, v, i, j)


def saturated_step(part: int, whole: int) -> int:
    """part / whole in 16.16, at most the largest number."""
    if abs(part) >> 15 >= abs(whole):
        return 0x7FFFFFFF if (part < 0) == (whole < 0) else -0x7FFFFFFF
    return mul_div(-part, 65536, -whole) if whole < 0 else mul_div(part, 65536, whole)


def longest(vertices, corners, box) -> Texturing:
    """A triangle's steps from its longest scanline, the one through the middle vertex."""
    top, bottom, middle = (vertices[k] for k in corners)
    whole, part = ([p - q for p, q in zip(v, top)] for v in (bottom, middle))
    if whole[1] > 0:
        y = part[1]
        part = [p - mul_div(w, y, whole[1]) for p, w in zip(part, whole)]
    dudx, dvdx = (saturated_step(part[k], part[0]) if part[0] else 0 for k in (2, 3))
    spare, guard, wraps = guarded(dvdx, box[2] - box[0], False)
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
    steps = [mul_div(whole[k], 65536, whole[1]) if several else 0 for k in (2, 3)]
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


def cut_quotient(n: int, d: int) -> int:
    """n / d cut towards zero, d > 0."""
    return n // d if n >= 0 else -(-n // d)


def scanline_line(line: Line, left: tuple, right: tuple, truncated: bool) -> None:
    """Sets u, v and steps of a line with pixels by two divides."""
    rise = [signed(b - a) for a, b in zip(left[1:], right[1:])]
    if truncated:
        first = ceil16(left[0])
        pixels = ceil16(right[0]) - first
        steps = [cut_quotient(r, pixels) if pixels > 0 else 0 for r in rise]
        moves = [(line.left - first) * s for s in steps]
    else:
        width, prestep = right[0] - left[0], (line.left << 16) - left[0]
        if width >= 65536:
            steps = [cut_quotient(r << 16, width) for r in rise]
            moves = [mul(s, prestep) for s in steps]
        else:
            prestep = min(max(prestep, 0), width)
            steps = [0, 0]
            moves = [cut_quotient(r * prestep, width) if width > 0 else 0 for r in rise]
    line.u, line.v = (a + m & M32 for a, m in zip(left[1:], moves))
    line.dudx, line.dvdx = (s & M32 for s in steps)


def set_up(vertices, width: int, height: int, textured: bool,
           settings: Settings = Settings()) -> Polygon | None:
    """Sets a polygon up for a frame; None where it is refused or covers nothing.

    ``vertices``: a list of (x, y, s, t), 16.16, as polygon_draw takes them.
    """
    n = len(vertices)
    if settings.edges == "integer":
        vertices = [(v[0] & ~0xFFFF, v[1] & ~0xFFFF, *v[2:]) for v in vertices]
    if not 3 <= n <= 64 or any(not -FAR < c < FAR for v in vertices for c in v):
        return None
    if textured and settings.gradients == "polygon" and n != 3:
        return None
    sides = measure(vertices, width, height)
    if sides is None:
        return None
    corners, edge_vertices = sides.corners, vertices
    if settings.clip == "vertices":
        clipped = clip(vertices, frame_window(width, height))
        if clipped != vertices:
            edge_vertices = clipped
            sides = measure(clipped, width, height)
            if sides is None:
                return None
    box, direction, top = sides.box, sides.direction, sides.corners[0]
    exact = settings.edges == "exact"
    lefts = side(edge_vertices, top, direction, box[1], box[3], exact)
    rights = side(edge_vertices, top, -direction, box[1], box[3], exact)
    left = [e.column(y) for e in lefts for y in range(e.top, e.end)]
    right = [e.column(y) for e in rights for y in range(e.top, e.end)]
    if not textured:
        lines = [Line(max(a, 0), min(b, width)) for a, b in zip(left, right)]
        return Polygon(box[1], lines, None, lefts, rights, False)
    if settings.gradients == "scanline":
        lines = [Line(max(a, 0), min(b, width)) for a, b in zip(left, right)]
        sides = ([point for e in edges for point in along(e)] for edges in (lefts, rights))
        for line, a, b in zip(lines, *sides):
            if line.right > line.left:
                scanline_line(line, a, b, settings.start == "truncated")
        return Polygon(box[1], lines, None, lefts, rights, True)
    t = plane(vertices, corners, box, settings.start == "subtexel") \
        if settings.gradients == "plane" else longest(vertices, corners, box)
    if t is None:
        return None
    starts = [start for e in lefts for start in edge_starts(t, e, settings)]
    lines = []
    for a, b, (u, v) in zip(left, right, starts):  # the frame's columns cut a line
        cut = max(-a, 0)
        lines.append(Line(max(a, 0), min(b, width), u + cut * t.dudx & M32, v + cut * t.dvdx & M32,
                          t.dudx, t.dvdx))
    return Polygon(box[1], lines, t, lefts, rights, True)


def coordinates(line: Line):
    """u and v of a line's pixels, int64 arrays, 16.16 modulo 2^32."""
    n = np.arange(line.right - line.left, dtype=np.int64)
    return (line.u + n * signed(line.dudx)) & M32, (line.v + n * signed(line.dvdx)) & M32


#: Low bits of u and of v that a mapper's spans have no room for, in starts and steps.
#: Rounded down, start and step lose less than 2^bits/65536 texel each: pixel n shows the
#: texel of a place less than (n + 1) 2^bits/65536 texel up or left of the exact one.
CUT = {"tiled": (0, 1), "columns": (3, 3)}


def cut(line: Line, mapper: str) -> Line:
    """A line as a mapper's spans take it."""
    u, v = CUT.get(mapper, (0, 0))
    return replace(line, u=line.u >> u << u, dudx=line.dudx >> u << u,
                   v=line.v >> v << v, dvdx=line.dvdx >> v << v)


def texel_tiled(u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Where MAP_TILED has the texels of u and v, 16.16."""
    x, y = u >> 16 & 255, v >> 16 & 255
    return 2048 * (x // 8) + 8 * y + x % 8


def texel_columns(u: np.ndarray, v: np.ndarray, width: int, height: int) -> np.ndarray:
    """Where MAP_COLUMNS has the texels of u and v, 16.16; both sides repeat."""
    x, y = (u >> 16) % width, (v >> 16) % height
    return 4 * height * (x // 4) + 4 * y + x % 4


def draw(frame: np.ndarray, polygon: Polygon, texture: np.ndarray | None, colour: int,
         mapper: str = "affine") -> None:
    """Draws a set-up polygon into ``frame`` (height x width); ``texture`` is linear."""
    for y, line in enumerate(polygon.lines, polygon.top):
        if line.right <= line.left:
            continue
        if not polygon.textured:
            frame[y, line.left:line.right] = colour
        else:
            u, v = coordinates(cut(line, mapper))
            if mapper == "tiled":
                texels = maps.to_tiled(texture)[texel_tiled(u, v)]
            elif mapper == "columns":
                texels = maps.to_columns(texture)[texel_columns(u, v, *texture.shape[::-1])]
            else:
                texels = texture[v >> 16 & 255, u >> 16 & 255]
            frame[y, line.left:line.right] = texels


def render(scene, number: int) -> np.ndarray:
    """Frame ``number`` of a scene (tools.scene_file.Scene), uint8, height x width."""
    from .scene_file import vertices_at

    frame = np.full((scene.height, scene.width), scene.background, np.uint8)
    for obj in scene.objects:
        if not obj.first_frame <= number < obj.first_frame + obj.poses:
            continue
        texture, colour = scene.materials[obj.material]
        vertices = vertices_at(scene, obj, number)
        polygon = set_up(vertices, scene.width, scene.height, texture >= 0)
        if polygon:
            draw(frame, polygon, scene.textures[texture] if texture >= 0 else None, colour)
    return frame
