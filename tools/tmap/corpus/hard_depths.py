"""Hard depths: one function per family. Polygons whose w differs, or is equal and not 1.

A surface gives exact s, t and w at any point of the screen: 1/w, s/w and t/w are affine
there. ``deep`` rounds x and y first and takes the surface's values there, so a vertex differs
from the surface only by the rounding of these values.

The distance of a fourth vertex from the planes through the three corners (chosen by
tools/tmap/ideal/ideal.py), all in units: rounding moves s, t and w by 1/2 at most, so 1/w of a
corner by r = 1 / (w (2 w - 1)). With b the vertex's barycentric coordinates in the three corners,
whose sum is 1, and Q = sum(b / w) there:

* 1/w is off the plane by sum(|b| r), and by the vertex's own r.
* u is off the curve by sum(|b| (1 / (2 w) + r (|u - u_here| + 1))) / Q, and by its own 1/2:
  the corners' u is off by 1/2, and with the surface's u_here, sum(b (u - u_here) / w) is 0
  before the w are rounded.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction

from tmap.base.fixed import fix
from tmap.corpus.hard_case import LIMIT, HEIGHT, UNIT, WIDTH, Case, label, spread
from tmap.corpus.hard_outlines import FARTHEST, box, ring
from tmap.scene_file.textures import IN_DEPTH

NEAREST, DEEPEST = Fraction(1, 256), Fraction(16384)  # w's range
FOCUS = 64  # pixels from the viewer to the screen
MIDDLE = (Fraction(WIDTH, 2), Fraction(HEIGHT, 2))
SCREEN = box(0, 0, WIDTH, HEIGHT)
SHARES = {"1_unit": UNIT / 1024, "1_millionth": Fraction(1, 10**6), "1_10000th": Fraction(1, 10**4),
          "1_percent": Fraction(1, 100)}

Exact = tuple[Fraction, Fraction, Fraction]
Surface = Callable[[Fraction, Fraction], Exact]  # x, y: s, t, w
Affine = tuple  # a value at (0, 0), and its growth per pixel right and down


def deep(name: str, sentence: str, points, surface: Surface) -> Case:
    """Returns a case from points in pixels on a surface."""
    corners = [(fix(x), fix(y)) for x, y in points]
    values = [surface(x * UNIT, y * UNIT) for x, y in corners]
    return by_vertex(name, sentence, [(x * UNIT, y * UNIT) for x, y in corners],
                     [v[:2] for v in values], [v[2] for v in values])


def by_vertex(name: str, sentence: str, points, texels, depths) -> Case:
    """Returns a case from each vertex's numbers; for triangles, which are always planar."""
    shades = spread([2 * Fraction(x) + Fraction(y) for x, y in points], Fraction(0), Fraction(255), LIMIT)
    return Case(name, sentence, tuple((fix(x), fix(y), fix(s), fix(t), fix(shade), fix(w))
                                      for (x, y), (s, t), shade, w
                                      in zip(points, texels, shades, depths, strict=True)),
                IN_DEPTH, depth=True)


def at(plane: Affine, x, y) -> Fraction:
    """Returns an affine function's value."""
    return Fraction(plane[0]) + Fraction(plane[1]) * x + Fraction(plane[2]) * y


def over(inverse: Affine, s: Affine, t: Affine) -> Surface:
    """Returns the surface of 1/w, s/w and t/w."""
    def surface(x, y) -> Exact:
        w = 1 / at(inverse, x, y)
        return at(s, x, y) * w, at(t, x, y) * w, w
    return surface


def mixed(*parts: tuple) -> Affine:
    """Returns the sum of (factor, affine function)."""
    return tuple(sum(Fraction(factor) * plane[k] for factor, plane in parts) for k in range(3))


def across(first, last, w_first, w_last) -> Affine:
    """Returns a 1/w that depends only on x, from w at two columns."""
    grow = (1 / Fraction(w_last) - 1 / Fraction(w_first)) / (Fraction(last) - Fraction(first))
    return 1 / Fraction(w_first) - grow * Fraction(first), grow, Fraction(0)


def down(first, last, w_first, w_last) -> Affine:
    """Returns a 1/w that depends only on y, from w at two lines."""
    start, grow, _ = across(first, last, w_first, w_last)
    return start, Fraction(0), grow


def wall(points, inverse: Affine) -> Surface:
    """Returns a surface under a polygon: s and t are up to about 100 where it is nearest, more
    farther away, but at most 16,000."""
    depths = [at(inverse, *p) for p in points]
    scale = min(100 * max(depths), 16000 * min(depths)) / 8
    (x, wide), (y, high) = ((min(c), scale / Fraction(max(c) - min(c))) for c in zip(*points))
    plane = (-x * wide - y * high, wide, high)
    return over(inverse, mixed((5, (-x * wide, wide, 0)), (2, (-y * high, 0, high)), (scale, (1, 0, 0))),
                mixed((-2, plane), (7 * scale, (1, 0, 0))))


def determinant(a, b, c) -> Fraction:
    """Returns the determinant of three vectors."""
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))


def seen(name: str, sentence: str, origin, along_s, along_t, corners) -> Case:
    """Returns a case of a flat thing in space seen through a pinhole, from the place (X, Y, Z) of
    its texel (0, 0), the growth of X, Y and Z per texel along s and along t, and its corners as (s,
    t)."""
    a, b, p = ([Fraction(c) for c in vector] for vector in (along_s, along_t, origin))
    points = []
    for s, t in corners:
        x, y, z = (o + s * c + t * d for o, c, d in zip(p, a, b))
        points.append((MIDDLE[0] + FOCUS * x / z, MIDDLE[1] + FOCUS * y / z))

    def surface(x, y) -> Exact:
        """Solves p + s a + t b = w ray by Cramer's rule."""
        ray = (x - MIDDLE[0]) / FOCUS, (y - MIDDLE[1]) / FOCUS, Fraction(1)
        whole = determinant(a, b, ray)
        return (-determinant(p, b, ray) / whole, -determinant(a, p, ray) / whole,
                determinant(a, b, p) / whole)
    return deep(name, sentence, points, surface)


def ground(inverse: Affine, aside: Affine, deepest) -> Surface:
    """Returns ground: t grows with depth from -16,000 on, s grows sideways from 0, as fast as the
    range allows where w is ``deepest``."""
    return over(inverse, mixed((min(Fraction(1), Fraction(250) / deepest), aside)),
                mixed((-16000, inverse), (min(Fraction(40), Fraction(32000) / deepest), (1, 0, 0))))


def horizons() -> Iterator[Case]:
    """Floors: 1/w from large to almost 0 at the horizon, 20 lines below the screen's top."""
    aside = (-MIDDLE[0], 1, 0)
    for way, roll in (("straight", 0), ("rolled_a_little", UNIT * 1000), ("rolled", Fraction(1, 16))):
        inverse = ((-20 - MIDDLE[0] * roll) / FOCUS, roll / Fraction(FOCUS), Fraction(1, FOCUS))
        for beside in (Fraction(1, 128), Fraction(1, 2), 8):
            top = [20 + beside + roll * (MIDDLE[0] - x) for x in (0, WIDTH)]
            yield deep(f"floor_{way}_{label(beside)}_below_the_horizon", "A floor up to "
                       f"{float(beside):.4g} lines below its horizon, {way.replace('_', ' ')}.",
                       [(0, top[0]), (WIDTH, top[1]), (WIDTH, HEIGHT), (0, HEIGHT)],
                       ground(inverse, aside, FOCUS / Fraction(beside)))
    inverse = (Fraction(75, FOCUS), 0, -Fraction(1, FOCUS))
    yield deep("ceiling_up_to_the_horizon", "A ceiling: the horizon is below it.",
               box(0, 0, WIDTH, 75 - Fraction(1, 128)), ground(inverse, aside, 128 * FOCUS))


def near_planes() -> Iterator[Case]:
    """Polygons as clipped at the nearest w: far off the screen there, up to the horizon."""
    reach, beside = 16000, Fraction(1, 256)
    k = 1 / (NEAREST * reach)
    for way, (x, y) in {"below": (0, 1), "above": (0, -1), "right": (1, 0), "left": (-1, 0)}.items():
        def place(ahead, aside):
            return MIDDLE[0] + x * ahead + y * aside, MIDDLE[1] + y * ahead + x * aside

        inverse = (-k * (MIDDLE[0] * x + MIDDLE[1] * y), k * x, k * y)
        aside = (-MIDDLE[0] * abs(y) - MIDDLE[1] * abs(x), abs(y), abs(x))
        surface = ground(inverse, aside, 1 / (k * beside))
        yield deep(f"near_plane_{way}_two_near", f"Ground that leaves the view {way}: two vertices "
                   "at the nearest w far off the screen, two at the horizon.",
                   [place(beside, -40), place(beside, 40), place(reach, 16300), place(reach, -16300)],
                   surface)
        yield deep(f"near_plane_{way}_one_near", "One vertex at the nearest w, far off the screen, two "
                   "at the horizon.", [place(beside, -60), place(beside, 60), place(reach, 9)], surface)
    yield by_vertex("near_plane_corner", "Two vertices at the nearest w in corners of the whole range, "
                    "one far away in the middle.", [(-LIMIT, FARTHEST), (FARTHEST, -LIMIT), (60,
                                                                                             50)],
                    [(0, 0), (200, 10), (9000, 5000)], [NEAREST, NEAREST + UNIT, 5000])
    yield by_vertex("near_plane_on_screen", "A vertex at the nearest w on the screen, two at the "
                    "deepest w.", [(64, 90), (0, 5), (127, 8)], [(100, 100), (0, 0), (255, 0)],
                    [NEAREST, DEEPEST, DEEPEST])


def ratios() -> Iterator[Case]:
    """Depth a thousand times as large at a span's end, four million times in a polygon."""
    band = box(0, 20, WIDTH, 70)
    for name, (near, far) in {"from_the_nearest": (NEAREST, 1000 * NEAREST), "from_1": (1, 1000),
                              "to_the_deepest": (DEEPEST / 1000, DEEPEST)}.items():
        for left, right in ((0, WIDTH), (WIDTH, 0)):
            way = "right" if right else "left"
            yield deep(f"1_to_1000_{name}_{way}", "Each span is a thousand times as deep at its "
                       f"{way} end.", band, wall(band, across(left, right, near, far)))
    for where, points, inverse in (
            ("in_a_span", band, across(0, WIDTH, NEAREST, DEEPEST)),
            ("in_a_span_back", band, across(WIDTH, 0, NEAREST, DEEPEST)),
            ("downwards", box(20, 0, 100, HEIGHT), down(0, HEIGHT, NEAREST, DEEPEST)),
            ("upwards", box(20, 0, 100, HEIGHT), down(HEIGHT, 0, NEAREST, DEEPEST)),
            ("of_a_wide_polygon", box(-LIMIT, 20, LIMIT - 1, 70), across(-LIMIT, LIMIT - 1,
                                                                         NEAREST, DEEPEST))):
        yield deep(f"all_depths_{where}", "From the nearest w to the deepest, four million times, "
                   f"{where.replace('_', ' ')}.", points, wall(points, inverse))
    yield by_vertex("all_depths_in_a_triangle", "The nearest w, the deepest and one between.",
                    [(10, 6), (118, 30), (40, 90)], [(0, 0), (16000, 0), (0, 250)], [NEAREST, DEEPEST, 8])


def grazing() -> Iterator[Case]:
    """Walls seen at grazing angles: all their depth within a few columns."""
    for aside in (Fraction(1, 32), Fraction(1, 16), Fraction(1, 4), 1):
        for far in (10, 1000):
            yield seen(f"wall_{label(aside)}_aside_{far}_deep", f"A wall {float(aside):.3g} beside the "
                       f"viewer, up to {far} away.", (aside, -Fraction(1, 2), 1), (0, 0, Fraction(1, 16)),
                       (0, Fraction(1, 128), 0), box(0, 0, 16 * (far - 1), 128))
    for columns in (1, 3):
        for left, right in ((60, 60 + columns), (60 + columns, 60)):
            yield deep(f"depth_in_{columns}_columns_{'right' if left < right else 'left'}",
                       f"A thousand times as deep {columns} columns on.", box(60, 5, 60 + columns, 90),
                       over(across(left, right, 1, 1000), (Fraction(1, 60), 0, 0), (0, 0, Fraction(1, 90))))


def hardly_deep() -> Iterator[Case]:
    """Depth that hardly changes: divisions by its change break down."""
    texture = (10, 1, Fraction(1, 3)), (20, Fraction(-1, 4), 1)
    for name, share in SHARES.items():
        for way, inverse in (("x", across(0, WIDTH, 1024, 1024 * (1 + share))),
                             ("y", down(0, HEIGHT, 1024, 1024 * (1 + share)))):
            yield deep(f"depth_differs_{name}_in_{way}", f"Depth 1024 grows by {float(share):.2g} of "
                       f"itself over the screen, in {way} alone.", SCREEN,
                       over(inverse, *(mixed((Fraction(1, 1024), plane)) for plane in texture)))
    for name, base, step in (("nearest", NEAREST, UNIT), ("1", 1, UNIT), ("deepest", DEEPEST, -UNIT)):
        for k, place in enumerate(("top", "right", "left")):
            depths = [base + step * (n == k) for n in range(3)]
            yield by_vertex(f"depth_{name}_but_1_unit_{place}", "All depths are alike but for one unit "
                            f"of the {place} one's.", [(50, 4), (120, 60), (8, 88)],
                            [(200, 3), (255, 90), (0, 255)], depths)


def constant_depths() -> Iterator[Case]:
    """The same depth everywhere: an affine polygon at any depth."""
    for w in (NEAREST, NEAREST + UNIT, Fraction(1, 2), 1, Fraction(3, 2), 1000 + UNIT, DEEPEST - UNIT,
              DEEPEST):
        inverse = (1 / Fraction(w), 0, 0)
        planes = ((30, Fraction(5, 4), -Fraction(1, 3)), (7, Fraction(1, 3), 1))
        yield deep(f"depth_{label(w)}_everywhere", f"Its depth is {float(w):.9g} at every vertex.",
                   [(16.25, 8.5), (112, 20.75), (100.5, 88), (8, 70.25)],
                   over(inverse, *(mixed((1 / Fraction(w), plane)) for plane in planes)))


def one_apart() -> Iterator[Case]:
    """One vertex far away from two near ones, or near before two far ones, at every place."""
    for name, (alone, others) in {"far": (DEEPEST, 1), "near": (1, DEEPEST), "farther": (16, 1)}.items():
        for k, place in enumerate(("top", "right", "bottom")):
            yield by_vertex(f"one_{name}_at_the_{place}", f"Its {place} vertex is at {alone}, the others "
                            f"are at {others}.", [(30, 4), (120, 40), (50, 90)],
                            [(3, 5), (250, 20), (90, 240)], [alone if n == k else others for n in range(3)])


def deep_slivers() -> Iterator[Case]:
    """Hardly any area: the planes' divisor is small, and their values differ much."""
    for size in (UNIT, 256 * UNIT, Fraction(1, 2), 1):
        for far in (4, 1000):
            for way, points in (("high", [(9.25, 40), (118.5, 40), (60, 40 + size)]),
                                ("wide", [(60, 5.5), (60 + size, 50), (60, 90)])):
                yield by_vertex(f"deep_sliver_{label(size)}_{way}_1_to_{far}", f"A sliver {float(size):.3g} "
                                f"pixels {way}, {far} times as deep at its second vertex.", points,
                                [(0, 0), (255, 30), (120, 200)], [1, far, far / Fraction(2)])
    yield by_vertex("deep_without_area", "Its vertices lie on one line, at different depths.",
                    [(10, 10), (40, 40), (90, 90)], [(0, 0), (90, 10), (200, 200)], [1, 5, 20])


def deep_sizes() -> Iterator[Case]:
    """From within a pixel to the whole range of coordinates."""
    for size in (UNIT, Fraction(1, 2), 1, 2, 8):
        for far in (4, LIMIT):
            yield by_vertex(f"deep_triangle_{label(size)}_1_to_{far}", f"A triangle {float(size):.3g} "
                            f"pixels large, {far} times as deep at one end.",
                            [(50, 50), (50 + size, 50), (50, 50 + size)], [(0, 0), (250, 0), (0, 250)],
                            [1, far, 2])
    for far in (4, LIMIT):
        for way, inverse in (("right", across(-LIMIT, FARTHEST, 1, far)),
                             ("down", down(-LIMIT, FARTHEST, 1, far))):
            yield deep(f"deep_box_of_the_whole_range_1_to_{far}_{way}", "All coordinates there are, "
                       f"{far} times as deep at the end, {way}.", box(-LIMIT, -LIMIT, FARTHEST,
                                                                      FARTHEST),
                       over(inverse, (0, Fraction(1, 2 * far), 0), (0, 0, Fraction(1, 2 * far))))


def far_textures() -> Iterator[Case]:
    """A map that repeats into the distance: s and t up to 16,383."""
    for name, s, t in (("s", 16383, 100), ("t", 100, 16383), ("both", 16383, 16383),
                       ("back", -16383, 16383)):
        yield by_vertex(f"repeated_up_to_the_horizon_{name}", "A hundred times as deep at its tip, where "
                        "the map has repeated itself most often.", [(4, 90), (124, 90), (70, 10)],
                        [(0, 0), (200, 0), (s, t)], [1, 1, 100])
    yield by_vertex("repeated_over_the_whole_range", "Texels run through all values they have, a thousand "
                    "times as deep at one end.", [(2, 3), (126, 20), (30, 93)],
                    [(-LIMIT, -LIMIT), (FARTHEST, 0), (0, FARTHEST)], [1, 1000, 30])


def constant_texels() -> Iterator[Case]:
    """u or v the same everywhere, though u/w and v/w are not."""
    inverse = across(0, WIDTH, 1, 9)
    along, still = (0, Fraction(1, 8), 0), mixed((Fraction(201, 2), inverse))
    for name, s, t in (("s", mixed((Fraction(309, 4), inverse)), (1, 0, 1)), ("t", along, still),
                       ("both", mixed((256, inverse)), mixed((0, inverse)))):
        yield deep(f"constant_{name}_in_depth", f"The texture does not change along {name}, but depth does.",
                   box(0, 8, WIDTH, 88), over(inverse, s, t))
    yield deep("constant_t_turned", "Its t is the same at all five vertices.", ring(5, 44.1),
               over(inverse, along, still))
    yield deep("constant_t_at_a_border", "Its t is at the border of two texels, everywhere.",
               ring(6, 44.1), over(inverse, along, mixed((100, inverse))))


def vanishing() -> Iterator[Case]:
    """The limit of u towards the viewer, inside the map and outside: K in u = K + C w."""
    for limit in (0, 128, Fraction(257, 2), 256 - UNIT, -1000, 16000, -16000):
        for way, (first, last) in (("right", (0, WIDTH)), ("left", (WIDTH, 0))):
            inverse = across(first, last, 1, 8)
            yield deep(f"vanishing_at_{label(limit)}_{way}", f"Texels tend to {float(limit):.9g} towards "
                       f"the viewer; it is deeper to the {way}.", box(0, 8, WIDTH, 88),
                       over(inverse, mixed((limit, inverse), (20, (1, 0, 0))),
                            mixed((limit, inverse), (1, (1, 0, Fraction(1, 2))))))
    inverse = across(0, WIDTH, 1, Fraction(1001, 1000))
    yield deep("vanishing_190000_texels_away", "So little depth that u tends to a value that 16.16 "
               "cannot have.", box(0, 8, WIDTH, 88),
               over(inverse, mixed((-189990, inverse), (190000, (1, 0, 0))), (5, 0, Fraction(1, 2))))


def in_space() -> Iterator[Case]:
    """Flat things in space, seen through a pinhole."""
    turns = {"a_little": (Fraction(12, 13), Fraction(5, 13)), "half": (Fraction(3, 5), Fraction(4, 5)),
             "almost_away": (Fraction(20, 101), Fraction(99, 101)),
             "back": (-Fraction(15, 17), Fraction(8, 17))}
    for name, (c, s) in turns.items():
        half, texel = Fraction(1, 2), Fraction(1, 256)
        left, beyond = -c / 2, Fraction(5, 4) - s / 2
        yield seen(f"square_turned_{name}", f"A square with the whole map, turned {name.replace('_', ' ')} "
                   "about its upright middle.", (left, -half, beyond),
                   (c * texel, 0, s * texel), (0, texel, 0), box(0, 0, 256, 256))
        yield seen(f"square_tilted_{name}", "The same, rolled and tilted besides.",
                   (left + Fraction(1, 3), -half, beyond), (c * texel, s * texel / 3, s * texel),
                   (-s * texel / 2, texel, c * texel / 4), box(0, 0, 256, 256))
    for count in (5, 16, 64):
        yield seen(f"disc_of_{count}_vertices", f"A floor of {count} vertices.", (-2, Fraction(1, 2), 1),
                   (Fraction(1, 64), 0, 0), (0, 0, Fraction(1, 64)), ring(count, 120, (128, 128)))
    for name, x in (("left", -1), ("right", 1)):
        yield seen(f"corridor_{name}", f"A corridor's {name} wall from beside the viewer to a hundred times "
                   "as far.", (x, -1, Fraction(1, 2)), (0, 0, Fraction(1, 64)), (0, Fraction(1, 128), 0),
                   box(0, 0, 3168, 256))


FAMILIES = (horizons, near_planes, ratios, grazing, hardly_deep, constant_depths, one_apart,
            deep_slivers, deep_sizes, far_textures, constant_texels, vanishing, in_space)
