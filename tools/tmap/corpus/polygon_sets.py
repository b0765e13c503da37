"""The named polygon sets of the accuracy report, and the random triangles of ``polys``.

All are triangles, so that every gradient setting can draw them; everything is 16.16 and
the same in every run. A vertex is (x, y, s, t, shade, w).
"""

import math
import random

from tmap.base.elementary import cos, power, sin
from tmap.base.fixed import fix
from tmap.base.linear import length

WIDTH, HEIGHT = 320, 256
COUNT = 20  # polygons per set
#: Texels per pixel of the set's polygons, in turn.
STEPS = (1 / 16, 1 / 4, 1, 4, 16)
#: Name to (least and greatest area in pixels, least and greatest height in pixels).
SHAPES = {"small": ((12, 40), (3, 20)), "medium": ((1800, 2200), (40, 90)),
          "large": ((15000, 40000), (150, 256)), "thin": ((60, 250), (100, 256)),
          "steep": ((60, 250), (0.3, 3))}
#: Name of a set of random triangles to the area of each, pixels; 0.4 to 1 texel a pixel.
SIZES = {f"{pixels}_pixels": pixels for pixels in (8, 25, 100, 500, 2000)}
SIDE = 128  # of the square that they are in
#: The least area of such a triangle over the square of its longest side; an equilateral one has 0.43.
#: So they are as high as those on which published renderers were measured: 4.2, 7.4, 14.6, 32.7 and
#: 65 lines.
ROUND = 0.3
#: Name of a set of medium triangles in space to the largest ratio of the depths of their ends; the
#: least ratio is half of that.
DEPTHS = {"depth": 4, "deep": 100}
FOCUS = WIDTH / 2  # pixels from the viewer to the screen
LARGEST = 8192  # texels: the limit of s and t


def every() -> list[str]:
    """Returns the names of all sets."""
    return [*SHAPES, *SIZES, *DEPTHS]


def area(points) -> float:
    """Returns a triangle's area."""
    (x0, y0), (x1, y1), (x2, y2) = points
    return abs((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2


def sized(rng: random.Random, pixels: int) -> list[tuple[float, float]]:
    """Returns a triangle of so many pixels, its corners clockwise on the screen."""
    while True:
        points = [(rng.random(), rng.random()) for _ in range(3)]
        longest = max(length((q[0] - p[0], q[1] - p[1]))
                      for p, q in zip(points, points[1:] + points[:1]))
        if area(points) < ROUND * longest * longest:
            continue
        scale = math.sqrt(pixels / area(points))
        extents = [scale * (max(c) - min(c)) for c in zip(*points)]
        if max(extents) > SIDE - 8:
            continue
        moves = [rng.random() * (SIDE - 1 - extent) - scale * min(c)
                 for extent, c in zip(extents, zip(*points))]
        (x0, y0), (x1, y1), (x2, y2) = made = [
            (scale * x + moves[0], scale * y + moves[1]) for x, y in points]
        return made if (x1 - x0) * (y2 - y0) > (x2 - x0) * (y1 - y0) else made[::-1]


def corners(rng: random.Random, name: str) -> list[tuple[float, float]]:
    """Returns a triangle of a set, inside the frame."""
    areas, heights = SHAPES[name]
    while True:
        points = [(rng.uniform(0, WIDTH), rng.uniform(0, HEIGHT)) for _ in range(3)]
        height = rng.uniform(*heights)
        low = min(y for _, y in points)
        scale = height / (max(y for _, y in points) - low)
        points = [(x, low + (y - low) * scale) for x, y in points]
        middle = points[0][0]
        squeeze = min(1, rng.uniform(*areas) / area(points))
        points = [(middle + (x - middle) * squeeze, y) for x, y in points]
        if areas[0] <= area(points) <= areas[1] and all(0 <= y < HEIGHT for _, y in points):
            return points


def texture(rng: random.Random, points, step: float, inside: float | None) -> list[tuple]:
    """Returns s and t of the corners: a rotated map of ``step`` texels per pixel.

    ``inside``: the side of a map that the coordinates must not leave; they are scaled
    down if they would.
    """
    angle = rng.uniform(0, math.tau)
    c, s = step * cos(angle), step * sin(angle)
    x0, y0 = points[0]
    turned = [(c * (x - x0) - s * (y - y0), s * (x - x0) + c * (y - y0)) for x, y in points]
    base = rng.uniform(-100, 400), rng.uniform(-100, 400)
    if inside is None:
        return [(u + base[0], v + base[1]) for u, v in turned]
    extent = max(max(q) - min(q) for q in zip(*turned))
    shrink = min(1, 0.98 * inside / extent)
    turned = [(u * shrink, v * shrink) for u, v in turned]
    low = [min(q) for q in zip(*turned)]
    high = [max(q) for q in zip(*turned)]
    base = [rng.uniform(-a, inside - b) for a, b in zip(low, high)]
    return [(u + base[0], v + base[1]) for u, v in turned]


def in_space(rng: random.Random, points, step: float, most: float) -> list[tuple]:
    """Returns s, t and w of the corners: a map on a random plane in space, on average ``step``
    texels per pixel, one corner ``most`` / 2 to ``most`` times as deep as another."""
    rays = [((x - WIDTH / 2) / FOCUS, (y - HEIGHT / 2) / FOCUS, 1.0) for x, y in points]
    while True:
        normal = [rng.gauss(0, 1) for _ in range(3)]
        near = [sum(map(math.prod, zip(normal, ray))) for ray in rays]
        if min(near) <= 0 or not most / 2 <= max(near) / min(near) <= most:
            continue
        depths = [max(near) / n for n in near]
        places = [[c * w for c in ray] for ray, w in zip(rays, depths)]
        a, b = ([p - q for p, q in zip(place, places[0])] for place in places[1:])
        far = length(a)  # the first corner is texel (0, 0), the second on the s axis
        along = sum(map(math.prod, zip(a, b))) / far
        aside = math.sqrt(max(sum(c * c for c in b) - along * along, 0.0))
        flat = [(0.0, 0.0), (far, 0.0), (along, aside)]
        scale, angle = step * math.sqrt(area(points) / area(flat)), rng.uniform(0, math.tau)
        c, s = scale * cos(angle), scale * sin(angle)
        base, deeper = [rng.uniform(-100, 400) for _ in "st"], power(2, rng.uniform(-2, 4))
        texels = [(base[0] + c * p - s * q, base[1] + s * p + c * q) for p, q in flat]
        if max(abs(c) for pair in texels for c in pair) < LARGEST:
            return [(*pair, w * deeper) for pair, w in zip(texels, depths)]


def polygons(name: str, inside: float | None = None) -> list[list[tuple[int, ...]]]:
    """Returns the polygons of a set. ``inside``: for ``texture``; not for sets with depth."""
    made = []
    for k in range(COUNT):
        rng = random.Random(f"{name} {k}")
        if name in SIZES:
            points, step = sized(rng, SIZES[name]), rng.uniform(0.4, 1)
        else:
            points, step = corners(rng, "medium" if name in DEPTHS else name), STEPS[k % len(STEPS)]
        if name in DEPTHS:
            surface = in_space(rng, points, step, DEPTHS[name])
        else:
            surface = [(s, t, 1) for s, t in texture(rng, points, step, inside)]
        shades = [rng.randrange(256) for _ in points]
        made.append([tuple(map(fix, (*p, s, t, shade, w)))
                     for p, (s, t, w), shade in zip(points, surface, shades)])
    return made


def random_triangles(count: int, seed: int = 1997) -> list[list[tuple[int, ...]]]:
    """Triangles as in fatmap2's test program: x to 320, y to 200, s and t anywhere on the map."""
    rng = random.Random(seed)
    return [[tuple(map(fix, (rng.uniform(0, 320), rng.uniform(0, 200), rng.uniform(0, 255),
                             rng.uniform(0, 255), rng.randrange(256), 1))) for _ in range(3)]
            for _ in range(count)]
