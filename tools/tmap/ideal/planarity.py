"""Checks by exact planes that polygons are drawn in the correct number of pieces.

Polygons of more than three vertices whose values are on one plane up to rounding are drawn in one
piece, all others as triangles. c/drawing/fan.c derives the errors by rounding; it shares no
arithmetic with this file. Between the two limits below, a polygon may be drawn either way:

* LEAST: half a unit of each of the vertices' numbers; a polygon must be allowed this much;
* MOST: the most that fan.c allows, and its own largest error.

Units are 1/65536; g and h are a plane's gradients; the errors of its three corners are multiplied
by 3 at most.
"""

from dataclasses import dataclass
from fractions import Fraction
from math import lcm

from tmap.ideal import ideal
from tmap.setup.planarity import COLOURS, DEPTHS, SHADES, TEXELS, asked

HALF = Fraction(1, 2)
NEAREST = 1 << 29  # the scaled 1/w of the nearest vertex
TOO_STEEP = 1 << 14  # a gradient beyond this does not fit 16.16
THIN = 128  # units; the gradients of thinner polygons are made by rounding


@dataclass
class Value:
    """A value at all vertices, exact, as integers over one denominator; its error by the vertices' rounding, and its
    allowance beyond that of a value written in 16.16."""

    name: str
    at: list[int]
    over: int
    rounded: Fraction
    allowed: Fraction


def divided(vertices) -> list[Value]:
    """Returns 1/w, s/w and t/w, scaled so that 1/w is NEAREST at the nearest vertex. s and t are
    relative to the middle of their range and scaled by its size."""
    least = min(abs(v[5]) for v in vertices)
    whole = lcm(*(v[5] for v in vertices))
    inverse = [NEAREST * least * (whole // v[5]) for v in vertices]  # over ``whole``
    unit = Fraction(NEAREST, least)  # of w
    ranges = [(min(v[k] for v in vertices), max(v[k] for v in vertices)) for k in (2, 3)]
    bases = [low + (high - low) // 2 for low, high in ranges]
    reach = max(max((high - low + 1) // 2 for low, high in ranges).bit_length(), 16)
    scale = 1 << reach
    made = [Value("1/w", inverse, whole, unit / 4, 4 * unit)]
    for name, k, base in zip(("s/w", "t/w"), (2, 3), bases):
        at = [(v[k] - base) * q for v, q in zip(vertices, inverse)]
        made.append(Value(name, at, whole * scale, Fraction(0), 4 * unit + Fraction(4 * NEAREST, scale) + 3))
    return made


def values(vertices, kinds: int) -> list[Value]:
    """Returns the values of some kinds (enum planar_values) at vertices (x, y, s, t, shade, w)."""
    made = divided(vertices) if kinds & DEPTHS else []
    for kind, k, name in ((TEXELS, 2, "s"), (TEXELS, 3, "t"), (SHADES, 4, "shade")):
        if kinds & kind:
            made.append(Value(name, [v[k] for v in vertices], 1, HALF, Fraction(0)))
    for k, name in enumerate("RGBA") if kinds & COLOURS else ():
        made.append(Value(name, [(v[4] >> 24 - 8 * k & 255) << 16 for v in vertices], 1,
                          Fraction(32768), Fraction(2 << 16)))
    return made


def is_sure(vertices, three) -> bool:
    """Returns true if a polygon is thick enough for its gradients to be meaningful."""
    (ax, ay), (bx, by), (cx, cy) = (vertices[k][:2] for k in three)
    area = abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay))
    longest = max(abs(p[0] - q[0]) + abs(p[1] - q[1]) for p in vertices for q in vertices)
    return area > THIN * longest


def judge(vertices, material, pieces: int, vouched: int = 0) -> str:
    """A complaint about the number of pieces of a convex polygon, or "". ``vouched``: kinds of
    values that are known to be planar."""
    kinds, three = asked(material) & ~vouched, ideal.corners(vertices)
    if len(vertices) == 3 or not is_sure(vertices, three):
        return ""
    must_cut, must_keep = "", True
    points = [vertices[k][:2] for k in three]
    way = sum(max(v[k] for v in vertices) - min(v[k] for v in vertices) for k in (0, 1)) >> 16
    for value in values(vertices, kinds):
        plane = ideal.Plane(points, [value.at[k] for k in three])
        whole = abs(plane.d) * value.over  # of all numbers here
        steep, both = max(abs(plane.nx), abs(plane.ny)), abs(plane.nx) + abs(plane.ny)  # max(g, h) and g + h
        rounded = 4 * value.rounded * whole + 2 * both
        most = (26 + value.allowed + way) * whole + 12 * both
        must_keep &= steep < TOO_STEEP * whole
        for (x, y, *_), found in zip(vertices, value.at):
            rise = plane.nx * (x - plane.x0) + plane.ny * (y - plane.y0)
            off = abs((found - plane.value0) * plane.d - rise)
            must_keep &= off <= rounded
            if off > most and steep < TOO_STEEP * whole:
                must_cut = (f"{value.name} of vertex ({x}, {y}) is {off / whole:.1f} units off the plane of "
                            f"three corners, {float(most / whole):.1f} are allowed in one piece")
    if must_cut and pieces == 1:
        return must_cut
    if must_keep and pieces > 1 and getattr(material, "edges", "") != "snapped":  # drawn as triangles
        return f"its values lie on planes, but it is drawn in {pieces} pieces"
    return ""
