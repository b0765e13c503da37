"""The integer model: the renderer's own arithmetic, in Python integers.

It follows c/polygon and src68k/math formula by formula and must agree with the
68020 bit for bit. It knows nothing of forms: addx, swap and C draw the same
picture, because every number that decides a pixel depends on the pixel alone.

All coordinates are 16.16 (units of 1/65536 pixel or texel); gradients of the
plane are 32.32 before they are rounded to steps.

What it may be off from the ideal, and why, stands in tools/ideal.py.
"""

from dataclasses import dataclass

import numpy as np

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


def mul_div(a: int, b: int, c: int) -> int:
    """a * b / c rounded to the nearest integer, c > 0."""
    return (a * b + (c >> 1)) // c


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


@dataclass
class Edge:
    """A side's section: x at line ``first`` and the slope, 16.16, for lines top to end."""

    first: int
    x: int
    slope: int
    top: int
    end: int

    def at(self, line: int) -> int:
        """x at a line."""
        return self.x + (line - self.first) * self.slope


@dataclass
class Texturing:
    """u at pixel (i, j) and its steps, 16.16 modulo 2^32; v alike."""

    i: int
    j: int
    u: int
    v: int
    dudx: int
    dudy: int
    dvdx: int
    dvdy: int
    spare: int
    wraps: bool


@dataclass
class Polygon:
    """What the set-up makes of a polygon: lines top.., left and right (excluded) of each."""

    top: int
    left: list[int]
    right: list[int]
    texturing: Texturing | None
    left_edges: list[Edge]
    right_edges: list[Edge]

    @property
    def pixels(self) -> int:
        """Pixels drawn."""
        return sum(max(0, r - l) for l, r in zip(self.left, self.right))


def side(vertices, start: int, direction: int, top: int, bottom: int) -> list[Edge]:
    """The edges of one side from the top vertex on, between two lines."""
    edges, index, upper = [], start, vertices[start]
    while top < bottom:
        index = (index + direction) % len(vertices)
        lower = vertices[index]
        end = min(ceil16(lower[1]), bottom)
        if end > top and lower[1] > upper[1]:
            first, height = ceil16(upper[1]), lower[1] - upper[1]
            width = lower[0] - upper[0]
            x = upper[0] + mul_div(width, (first << 16) - upper[1], height)
            single = ceil16(lower[1]) - first <= 1
            slope = 0 if single else mul_div(width, 65536, height)
            edges.append(Edge(first, x, slope, top, end))
            top = end
        upper = lower
    return edges


def texturing(vertices, corners, box) -> Texturing | None:
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
    inside = (travel_x < 0x10000 and travel_y < 0x10000
              and travel <= v >> 8 & 0xFFFF < 0x10000 - travel)
    speed = signed(dvdx, 24)
    once = ((abs(speed) >> 8) + 1) * (right - left) <= 0x10000
    spare = int(not inside and once)
    dudx, dudy = step(dsdx, spare), step(dsdy, spare)
    if spare:
        u = u & ~1 | (speed < 0)
    return Texturing(i, j, u, v, dudx, dudy, dvdx, dvdy, spare, not inside and not once)


def set_up(vertices, width: int, height: int, textured: bool) -> Polygon | None:
    """Sets a polygon up for a frame; None where it is refused or covers nothing.

    ``vertices``: a list of (x, y, s, t), 16.16, as polygon_draw takes them.
    """
    n = len(vertices)
    if not 3 <= n <= 64 or any(not -FAR < c < FAR for v in vertices for c in v):
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
    direction = 1 if (turns[apex] > 0) == forward else -1
    lefts = side(vertices, top, direction, box[1], box[3])
    rights = side(vertices, top, -direction, box[1], box[3])
    # The frame's columns cut a line only where an edge can lie outside them.
    left = [max(ceil16(e.at(y)), 0) for e in lefts for y in range(e.top, e.end)]
    right = [min(ceil16(e.at(y)), width) for e in rights for y in range(e.top, e.end)]
    plane = texturing(vertices, (top, bottom, apex), box) if textured else None
    if textured and plane is None:
        return None
    return Polygon(box[1], left, right, plane, lefts, rights)


def coordinates(plane: Texturing, line: int, first: int, end: int):
    """u and v of the pixels first..end-1 of a line, uint32 arrays, 16.16 modulo 2^32."""
    i = np.arange(first - plane.i, end - plane.i, dtype=np.int64)
    j = line - plane.j
    u = (plane.u + i * signed(plane.dudx) + j * signed(plane.dudy)) & M32
    v = (plane.v + i * signed(plane.dvdx) + j * signed(plane.dvdy)) & M32
    return u, v


def draw(frame: np.ndarray, polygon: Polygon, texture: np.ndarray | None, colour: int) -> None:
    """Draws a set-up polygon into ``frame`` (uint8, height x width)."""
    for line, (left, right) in enumerate(zip(polygon.left, polygon.right), polygon.top):
        if right <= left:
            continue
        if polygon.texturing is None:
            frame[line, left:right] = colour
        else:
            u, v = coordinates(polygon.texturing, line, left, right)
            frame[line, left:right] = texture[v >> 16 & 255, u >> 16 & 255]


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
