"""Random depths for the fuzzer: w of a polygon's vertices, and s and t that stay on one plane in
space.

w is from W_MIN to W_MAX, 16.16, of any kind, or handwritten. For more than three vertices 1/w is on
one plane up to the rounding of w (half a unit): everything before it is exact.
"""

import math
import random
from fractions import Fraction

from tmap.base.fixed import ONE
from tmap.build import layout
from tmap.corpus import written

SPREAD = {"near_equal": (-6, -2), "4": (-1, math.log10(3)), "100": (0, 2),
          "all": (0, math.log10(4e6))}  # log10(deepest w / nearest w - 1)
WRITTEN = "written"
KINDS = ("constant", "space", "vertices", WRITTEN, *SPREAD)


def limits() -> tuple[int, int]:
    """Returns the least and the greatest w."""
    constants = layout.load().constants
    return constants["W_MIN"], constants["W_MAX"]


def nearness(rng: random.Random, kind: str, points, size: tuple[int, int]) -> list[Fraction]:
    """Returns values proportional to 1/w of points (x, y), affine in x and y, above 0."""
    if kind == "space":  # a plane by its normal; the screen is as far as its longer side
        width, height = size
        for _ in range(20):
            normal = [rng.randint(-1000, 1000) for _ in range(3)]
            rays = [(x - (width << 15), y - (height << 15), max(size) << 16) for x, y in points]
            found = [sum(a * b for a, b in zip(normal, ray)) for ray in rays]
            if min(found) > 0:
                return list(map(Fraction, found))
        kind = "constant"
    # a wall or a floor, also seen by a camera that leans a little, or anything
    lean = rng.randint(-9, 9)
    along = rng.choice(((1, 0), (0, 1), (9999, lean), (lean, 9999), (rng.randint(-99, 99), rng.randint(-99, 99))))
    way = [along[0] * x + along[1] * y for x, y in points]
    extent = max(way) - min(way)
    if kind == "constant" or not extent:
        return [Fraction(1)] * len(points)
    more = Fraction(10 ** rng.uniform(*SPREAD[kind]))
    return [1 + more * Fraction(w - min(way), extent) for w in way]


def depths(rng: random.Random, kind: str, points, size: tuple[int, int]) -> list[Fraction]:
    """Returns w of points, in units, not rounded; ``size``: the frame's."""
    least, most = limits()
    if kind == WRITTEN:
        return [w * ONE for w in written.depths(rng, points)]
    if kind == "vertices" and len(points) == 3:  # three are always on a plane
        return [Fraction(rng.choice((least, most, 65536, rng.randint(least, 1 << rng.randint(9, 30)))))
                for _ in points]
    near = nearness(rng, "100" if kind == "vertices" else kind, points, size)
    ratio = max(near) / min(near)
    if ratio > Fraction(most, least):
        return [Fraction(65536)] * len(points)
    low, high = math.log2(least * ratio), math.log2(most)
    deepest = min(max(Fraction(2 ** rng.uniform(low, high)), least * ratio), Fraction(most))
    return [deepest * min(near) / n for n in near]


def in_depth(rng: random.Random, kind: str, vertices, size: tuple[int, int]) -> tuple[tuple, ...]:
    """Returns vertices (x, y, s, t, shade, w) with depths of a kind. s and t, planar on the screen,
    become planar in space: each is multiplied by its w over the greatest. If they were within half
    a unit of a plane, they are within a unit of one afterwards."""
    found = depths(rng, kind, [v[:2] for v in vertices], size)
    # Or they stay unchanged: three are always on a plane.
    screen = len(vertices) == 3 and (kind == WRITTEN or rng.random() < 0.5)
    return tuple((x, y, *((s, t) if screen else (round(c * w / max(found)) for c in (s, t))), shade, round(w))
                 for (x, y, s, t, shade, _), w in zip(vertices, found))
