"""The exact ideal of points before a camera, and the bounds of the renderer's errors against it.

It starts from the scene file's points and from the camera's numbers before they are rounded to
the file's formats.

A view's factors f (at most 1) are off by 2^-31, the points p (at most ``reach``) are exact and
the moves are off by 2^-17; the sum is rounded once. So x, y and w are off by

    camera_error = 3 reach 2^-31 + 2^-17 + 2^-17.

On the screen x = middle + G x / w, with G the guard's pixels. Inside the borders |x| <= w; with
x and w each off by e, the quotient is off by at most (e + |x / w| e) / (w - e), and it is rounded
to 2^-17:

    screen_error = 2 G e / (w - e) + 2^-17.

A normal's coordinates are off by 2^-15, the three factors (of a vector ``radius`` long) by 2^-8,
and the sum is cut to 2^-16. By Cauchy and Schwarz a sum of three such products is off by

    look_error = sqrt(3) (radius 2^-15 + 2^-8 (1 + sqrt(3) 2^-15)) + 2^-16.

A face is seen from the front if n e > d: its normal n is off by 2^-31 each, the eye e by 2^-17
each, d by 2^-17, and the sum of products is cut to 2^-16. A corner is at most the sum of the eye's
coordinates and 3 reach from the eye, so the eye's height over the face is off by

    seen_error = (|e_x| + |e_y| + |e_z| + 3 reach) 2^-31 + (sqrt(3) + 3) 2^-17.

If the eye is nearer to the face's plane than that, the face may be seen or not.

With 16-bit operands (struct scene_view16) points P and factors F are whole numbers, each off by half a
unit. A sum of three such products is off by at most

    sum_error16 = (sum of |F| + sum of |P|) / 2 + 3/4 + 1/2,

the last for its move. The depth is that of w's sum, shifted, and rounded to half a unit. x and y in
1/16 pixel are the quotients of such sums and the depth v; x is off by at most

    place_error16 = (sum_error16 of x + x depth_error16) / v.

The tools write such a view if that is at most SHORT = 1/32 pixel in truth, for all points on the
screen. Normals lose the lower words of their coordinates, less than 2^-14 each, and the eye has a
unit of its own, 2^(cut - 16), so the eye's height over a face is off by

    seen_error16 = seen_error + (sum of |e|) 2^-14 + 3 2^(cut - 17) + 2^-16.

A border cuts an edge at a place computed from both ends, each of which is near the exact point. So
the new corner is as near to a place on the exact edge as the ends are to theirs, plus the rounding
of its numbers by half a unit. There are five borders: x, y and w of a corner are within

    corner_error = camera_error + 5/2^17

of a place on the exact edge, its s and t within 5/2^17 of those there. If nothing is cut, x, y and
w are within camera_error, and s and t are exact.
"""

import math
from fractions import Fraction

from tmap.base.fixed import ONE
from tmap.scene_file.meshes import FOG

SHORT = 1 / 32  # pixels by which 16-bit operands may move a point, before it is snapped
CUT = 5 * 2.0 ** -17  # error that cutting at all borders adds to a corner's numbers


def camera_error(reach: float) -> float:
    """Returns the error of x, y and w of a point before the camera, units."""
    return 3 * reach * 2.0 ** -31 + 2.0 ** -16


def screen_error(guard: int, w: float, reach: float) -> float:
    """The error of x and y on the screen of a point inside the borders, pixels; ``w``: exact."""
    return off_screen(guard, w, camera_error(reach))


def off_screen(guard: int, w: float, error: float) -> float:
    """Returns the same error for a point whose x, y and w are within ``error``."""
    return math.inf if w <= error else 2.0 ** (guard + 1) * error / (w - error) + 2.0 ** -17


def edge_error(edges: str, height: int, is_short: bool = True) -> float:
    """Returns what else a drawn edge may be off, pixels: half a unit a line where it is stepped, what corners are
    rounded by. ``is_short``: they may be of 16-bit operands."""
    return {"integer": 1, "subpixel": (height + 1) * 2.0 ** -17, "snapped": 1 / 32 + SHORT * is_short}.get(edges, 0.0)


def look_error(radius: float) -> float:
    """Returns the error of s and t of an environment, or of a shade, before it is clamped."""
    return math.sqrt(3) * (radius * 2.0 ** -15 + 2.0 ** -8 * (1 + math.sqrt(3) * 2.0 ** -15)) \
        + 2.0 ** -16


def seen_error(eye, reach: float, seen_shift: int | None = None) -> float:
    """The largest distance of the eye from a face's plane at which the face may be seen or not;
    ``seen_shift``: of the view16, if it decides."""
    sides = sum(abs(float(c)) for c in eye)
    error = (sides + 3 * reach) * 2.0 ** -31 + (math.sqrt(3) + 3) * 2.0 ** -17
    if seen_shift is None:
        return error
    return error + sides * 2.0 ** -14 + 3 * 2.0 ** (14 - seen_shift - 17) + 2.0 ** -16


def sum_error16(factors, point) -> Fraction:
    """Returns the error of a sum of products of 16-bit operands."""
    return Fraction(sum(map(abs, (*factors, *point))), 2) + Fraction(5, 4)


def corner_error(reach: float, is_cut: bool) -> float:
    """Returns the error of x, y and w of a polygon's corner before the camera, units."""
    return camera_error(reach) + CUT * is_cut


def camera(factors, move, point) -> tuple[Fraction, Fraction, Fraction]:
    """Returns the exact x, y, w: rows of factors and the move as numbers, the point in 16.16."""
    place = [Fraction(p, ONE) for p in point]
    return tuple(sum(Fraction(f) * p for f, p in zip(row, place)) + Fraction(m)
                 for row, m in zip(factors, move))


def screen(guard: int, width: int, height: int, x: Fraction, y: Fraction,
           w: Fraction) -> tuple[Fraction, Fraction]:
    """Projects an exact point before the camera to the screen, pixels."""
    return (Fraction(width, 2) + 2 ** guard * x / w, Fraction(height, 2) + 2 ** guard * y / w)


def shade(instance, light: Fraction, w: Fraction) -> Fraction:
    """Returns the exact shade of a corner: by its normal's product with the light, or in fog by its depth."""
    dark, bright = Fraction(instance.dark, ONE), Fraction(instance.bright, ONE)
    if instance.flags & FOG:
        near, far = Fraction(instance.fog_near, ONE), Fraction(instance.fog_far, ONE)
        return bright - (bright - dark) * (min(max(w, near), far) - near) / (far - near)
    return min(max(dark + light, dark), bright)


def fog_error(instance, corner: float) -> float:
    """Returns the error of a shade in fog, whose depth is off by as much as its ``corner``, and which is
    rounded to half a unit."""
    return corner * (instance.bright - instance.dark) / (instance.fog_far - instance.fog_near) + 2.0 ** -17


def clip(vertices, near: Fraction) -> list[tuple]:
    """Returns the exact part of a polygon inside all borders; a vertex begins with x, y, w, and its
    other values are cut with them."""
    def depths(v):
        return v[2] - near, v[2] + v[0], v[2] - v[0], v[2] + v[1], v[2] - v[1]

    for border in range(5):
        made = []
        for k, vertex in enumerate(vertices):
            last = vertices[k - 1]
            here, before = depths(vertex)[border], depths(last)[border]
            if here * before < 0:
                part = before / (before - here)
                made.append(tuple(a + (b - a) * part for a, b in zip(last, vertex)))
            if here >= 0:
                made.append(vertex)
        vertices = made
    return vertices
