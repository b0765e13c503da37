"""The integer model of c/polygon/clip.c: convex polygons cut to a rectangle.

Coordinates are 16.16; a vertex is a tuple that begins with x and y.
"""

from tmap.base.fixed import ONE, mul_div

VERTICES_MAX = 64 + 4  # CLIP_VERTICES_MAX: the most that a convex polygon can get


def cut(inside: tuple, outside: tuple, axis: int, part: int, whole: int, limit: int) -> tuple:
    """Returns the point on a border, ``part`` of ``whole`` from the vertex inside."""
    point = [a + mul_div(b - a, part, whole) for a, b in zip(inside, outside)]
    point[axis] = limit
    return tuple(point)


def clip_border(vertices: list[tuple], axis: int, sign: int, limit: int) -> list[tuple]:
    """Returns the part of a polygon where sign * coordinate >= sign * limit."""
    made = []
    for k, vertex in enumerate(vertices):
        last = vertices[k - 1]
        if len(made) > VERTICES_MAX - 2:
            return []
        here, before = (sign * (v[axis] - limit) for v in (vertex, last))
        if here >= 0:
            if before < 0 < here:
                made.append(cut(vertex, last, axis, here, here - before, limit))
            made.append(vertex)
        elif before > 0:
            made.append(cut(last, vertex, axis, before, before - here, limit))
    return made


def clip(vertices: list[tuple], window: tuple[int, int, int, int]) -> list[tuple]:
    """Returns the part of a convex polygon inside (left, top, right, bottom), borders included."""
    left, top, right, bottom = window
    for axis, sign, limit in ((0, 1, left), (0, -1, right), (1, 1, top), (1, -1, bottom)):
        vertices = clip_border(vertices, axis, sign, limit)
    return vertices


def frame_window(width: int, height: int) -> tuple[int, int, int, int]:
    """Returns a window one pixel outside the frame, so that rounding loses no pixel centre."""
    return -ONE, -ONE, width * ONE, height * ONE
