"""Polygons like handwritten ones: zeros, whole numbers and halves, equal coordinates, right angles,
maps from their first texel to their last. Scenes consist of these, and noise has none of them.

SHARE of every fuzzer's polygons come from here: for the mapper settings, including perspective and
depth (tmap.fuzz.polygons), for tmap.corpus.random_polygons, for the N64's engine and Glide's unit
(tmap.corpus.random_n64, random_glide). Each family has a weight.
"""

import random
from fractions import Fraction

from tmap.base.fixed import ONE, fix

SHARE = 0.3
Points = list[tuple[int, int]]  # 16.16
#: Weights: rectangles and right-angled triangles with sides along the axes, on whole pixels; the
#: whole frame or more; triangles on whole numbers, on halves, with few different numbers; diamonds.
OUTLINES = {"rectangle": 6, "right_angle": 4, "frame": 1, "whole": 3, "halves": 2, "shared": 3,
            "diamond": 1}
#: Weights: the map over the polygon's box; one texel per pixel; a row or a column of the map, with
#: s or t the same at all vertices; for triangles, numbers from a list at each vertex.
TEXTURES = {"box": 6, "texel_a_pixel": 3, "row": 2, "listed": 3}
#: How often the map repeats over the box, and its start, in parts of the map.
TIMES, STARTS = (1, 1, 1, 1, -1, 2, 3, Fraction(1, 2)), (0, 0, 0, 0, 1, Fraction(1, 2), -1)
SIZES = (0, 0, 0, 8, 16, 32, 64, 100, 128, 255, 256, 256, 256, Fraction(1, 2))
DEPTHS = (1, 1, 1, 2, 2, 3, 4, 8, 10, 16, 100, 1000, 16384, Fraction(1, 2), Fraction(1, 4),
          Fraction(1, 256))


def by_weight(rng: random.Random, weights: dict[str, int]) -> str:
    """Returns a random family by its weight."""
    return rng.choices(list(weights), weights.values())[0]


def whole(rng: random.Random, side: int) -> int:
    """A place along a side of the frame: an end, the middle, a multiple of 8, any, just outside."""
    return rng.choice((0, side, side // 2, 8 * rng.randint(0, side // 8), rng.randint(0, side),
                       rng.randint(-4, side + 4)))


def pair(rng: random.Random, side: int) -> tuple[int, int]:
    """Returns two different places, the lower one first."""
    while True:
        low, high = sorted((whole(rng, side), whole(rng, side)))
        if low < high:
            return low, high


def corners_of(rng: random.Random, family: str, width: int, height: int) -> list[tuple]:
    """Returns x and y of the corners, in pixels, in order around the polygon."""
    if family == "frame":
        more = rng.choice((0, 0, 1, 8, 1000))
        left, top, right, bottom = -more, -more, width + more, height + more
    else:
        (left, right), (top, bottom) = pair(rng, width), pair(rng, height)
    box = [(left, top), (right, top), (right, bottom), (left, bottom)]
    if family in ("rectangle", "frame"):
        return box
    if family == "right_angle":
        del box[rng.randrange(4)]
        return box
    if family == "diamond":
        x, y = Fraction(left + right, 2), Fraction(top + bottom, 2)
        return [(x, top), (right, y), (x, bottom), (left, y)]
    if family == "shared":
        return [(rng.choice((left, right, whole(rng, width))), rng.choice((top, bottom)))
                for _ in range(3)]
    parts = 2 if family == "halves" else 1
    return [(Fraction(whole(rng, parts * width), parts), Fraction(whole(rng, parts * height), parts))
            for _ in range(3)]


def outline(rng: random.Random, width: int, height: int) -> Points:
    """Returns the corners of a convex polygon with area, with either winding, any of them first."""
    while True:
        points = corners_of(rng, by_weight(rng, OUTLINES), width, height)
        (x0, y0), (x1, y1), (x2, y2) = points[:3]
        if (x1 - x0) * (y2 - y0) != (x2 - x0) * (y1 - y0):
            break
    if rng.random() < 0.5:
        points.reverse()
    first = rng.randrange(len(points))
    return [(fix(x), fix(y)) for x, y in points[first:] + points[:first]]


def part_of(value: int, values: list[int]) -> Fraction:
    """Returns a value's place between the least and the greatest, 0 to 1."""
    low, extent = min(values), max(values) - min(values)
    return Fraction(value - low, extent) if extent else Fraction(0)


def inside(value: Fraction, end: Fraction) -> int:
    """Clamps a coordinate to a map that does not repeat, 16.16."""
    return min(max(int(value * ONE), 0), int(end * ONE))


def texels(rng: random.Random, points: Points, ends, repeats: bool = True) -> Points:
    """Returns s and t of the corners, on one plane; ``ends``: those of the map's far ends;
    ``repeats``: they may be outside the map."""
    family, turned = by_weight(rng, TEXTURES), rng.random() < 0.25
    axes = [[p[k] for p in points] for k in (0, 1)]
    made = []
    for k, end in enumerate(map(Fraction, ends)):
        along = axes[k ^ turned]
        if family == "listed" and len(points) == 3:
            values = [min(Fraction(rng.choice(SIZES)), end) for _ in points]
        elif family == "row" and k == turned:
            values = [min(Fraction(rng.choice(SIZES)), end)] * len(points)
        elif family == "texel_a_pixel":
            start = rng.choice((0, 0, 8, Fraction(1, 2)))
            values = [start + Fraction(c - min(along), ONE) for c in along]
        else:
            times, start = rng.choice(TIMES), rng.choice(STARTS)
            if not repeats:
                times, start = rng.choice(((1, 0), (1, 0), (-1, 1), (Fraction(1, 2), 0)))
            values = [end * (start + times * part_of(c, along)) for c in along]
        made.append([round(v * ONE) if repeats else inside(v, end) for v in values])
    return list(zip(*made))


def depths(rng: random.Random, points: Points) -> list[Fraction]:
    """Returns w of the corners: for a triangle, numbers from a list; for others, one number at each
    of two opposite sides, with 1/w on a plane between them."""
    if len(points) == 3:
        some = rng.choice(DEPTHS), rng.choice(DEPTHS)
        return [Fraction(rng.choice(some)) for _ in points]
    first, last = (Fraction(rng.choice(DEPTHS)) for _ in "ab")
    axis = rng.randrange(2)
    along = [p[axis] for p in points]
    parts = [part_of(c, along) for c in along]
    return [1 / ((1 - part) / first + part / last) for part in parts]
