"""Random cases of the properties in tests/helpers/properties.py.

``check`` draws one; it depends only on the property's name, a seed and a number.
"""

import random
from collections.abc import Iterator
from dataclasses import replace

from tests.helpers.properties import (Case, covers_once, held, pieces, reversal, rotation,
                                      rows_kept, splitting, translation, wrapping)
from tmap.corpus import random_meshes, random_polygons
from tmap.model import model
from tmap.scene_file.scene_file import ONE

WIDTH, HEIGHT = 96, 72
LATTICE = 243  # units; odd, so that gradients have no end in binary
REPEATING = ("affine", "tiled", "columns", "generated", "dithered", "keyed")  # mappers of maps that repeat


def planar(rng: random.Random, points) -> tuple:
    """Vertices whose s and t lie on one plane exactly: points on multiples of LATTICE,
    gradients of 1 / LATTICE texel a pixel."""
    steps = [(rng.randint(-g, g), rng.randint(-g, g))
             for g in (LATTICE * rng.choice((0, 1, 1, 4)) for _ in range(2))]
    start = [rng.randint(-300 << 16, 300 << 16) for _ in range(2)]
    return tuple((x, y, *(a + gx * (x // LATTICE) + gy * (y // LATTICE)
                          for a, (gx, gy) in zip(start, steps)), 0, ONE) for x, y in points)


def convex(rng: random.Random, least: int = 3, unit: int = 1) -> list[tuple[int, int]]:
    """A random convex polygon with at least ``least`` vertices, on multiples of ``unit``."""
    while True:
        points = [(x // unit * unit, y // unit * unit)
                  for x, y in random_polygons.convex_polygon(rng, WIDTH, HEIGHT)]
        if len(points) >= least and random_polygons.is_convex(points) and random_meshes.twice_area(points):
            return points


def textured(rng: random.Random, points, shades=(0, 255)) -> tuple:
    """Vertices with s and t, at most 8,192 texels from the map's corner, and shade."""
    st = [(model.FAR, 0)]
    while max(abs(c) for pair in st for c in pair) > model.FAR // 2:
        st = random_polygons.texture_plane(rng, points)
    return tuple((*p, *c, rng.randint(shades[0] << 16, (shades[1] << 16) + 0xFFFF), ONE)
                 for p, c in zip(points, st))


def any_settings(rng: random.Random, count: int, **fixed) -> model.Settings:
    """Random settings that are valid for a polygon with ``count`` vertices."""
    kinds = {"edges": ("integer", "subpixel", "exact"), "start": ("truncated", "subtexel"),
             "gradients": ("scanline", "plane") + (("polygon",) if count == 3 else ()),
             "clip": ("scissor", "vertices"), "mapper": REPEATING}
    return model.Settings(**{k: rng.choice(v) for k, v in kinds.items()} | fixed)


def any_case(rng: random.Random, origin: str, **fixed) -> Case:
    """A random polygon with random settings, except those in ``fixed``."""
    points = long_triangle(rng, HEIGHT) if rng.random() < 0.1 else convex(rng)
    vertices = textured(rng, points)
    return Case(origin, vertices, WIDTH, HEIGHT, any_settings(rng, len(vertices), **fixed))


def long_triangle(rng: random.Random, side: int) -> list[tuple[int, int]]:
    """A triangle in, across or far beyond a frame of this width and height; some are needles."""
    while True:
        reach = [rng.choice((0, 0, side, 16000 - side)) for _ in range(2)]
        points = [tuple(round(rng.uniform(-r, side + r) * 65536) for r in reach)
                  for _ in range(3)]
        if rng.random() < 0.3:
            axis = rng.randrange(2)
            points[1] = tuple(c + rng.randint(-65536, 65536) if k == axis else points[2][k]
                              for k, c in enumerate(points[0]))
        if random_meshes.twice_area(points):
            return points


def held_case(rng: random.Random, origin: str) -> Case:
    """A polygon whose texels or shades reach the ends of their range; with more than three vertices
    they are on no plane."""
    points = long_triangle(rng, HEIGHT) if rng.random() < 0.3 else convex(rng)
    size = tuple(rng.choice((1, 2, 8, 100, 256, 1000)) for _ in range(2))
    low, high = sorted(rng.choice((0, 0, 255, rng.randrange(256))) for _ in range(2))
    room = [256 * 65536 * side // max(size) for side in size]
    inset = min(model.INSET * 256 // max(size) + 1, *room)  # lines with this inset need no clamp
    vertices = tuple(
        (*p[:2], *(rng.choice((0, end, inset, end - inset, rng.randint(0, end))) for end in room),
         *p[4:]) for p in textured(rng, points, (low, high)))
    settings = any_settings(rng, len(points), mapper=rng.choice(("gouraud", "arbitrary")))
    return Case(origin, vertices, WIDTH, HEIGHT, settings, size)


def check_watertight(rng: random.Random, origin: str) -> list[str]:
    kind = rng.choice(list(random_meshes.KINDS))
    mesh = random_meshes.mesh(rng, WIDTH, HEIGHT, kind)
    settings = model.Settings(rng.choice(("integer", "subpixel", "exact")),
                              clip=rng.choice(("scissor", "scissor", "vertices")), mapper="flat")
    return covers_once(Case(f"{origin} ({kind})", tuple(mesh.outline), WIDTH, HEIGHT, settings),
                       mesh.triangles)


def row_case(rng: random.Random, origin: str) -> Case:
    """An upright rectangle whose lines cover one row of the map, or up to a texel more or less."""
    x, y = (rng.randrange(side // 2 * ONE) for side in (WIDTH, HEIGHT))
    right, bottom = x + rng.randrange(ONE, WIDTH * ONE), y + rng.randrange(ONE, HEIGHT * ONE)
    ends = [rng.choice((0, end)) + rng.choice((0, rng.randint(-ONE, ONE))) for end in (0, 256 * ONE)]
    rng.shuffle(ends)
    first = rng.randrange(-3, 3) * 256 * ONE
    points = ((x, y, ends[0]), (right, y, ends[1]), (right, bottom, ends[1]), (x, bottom, ends[0]))
    vertices = tuple((*p, first + s, 20 * ONE + p[1] // 3, 0, ONE) for *p, s in points)
    return Case(origin, vertices, WIDTH, HEIGHT, any_settings(rng, 4, mapper="generated"))


def check_rows_kept(rng: random.Random, origin: str) -> list[str]:
    return rows_kept((any_case if rng.random() < 0.5 else row_case)(rng, origin))


def check_translation(rng: random.Random, origin: str) -> list[str]:
    while True:
        case = any_case(rng, origin)
        ways = []
        for axis, side in ((0, WIDTH), (1, HEIGHT)):
            values = [v[axis] for v in case.vertices]
            base = min(values) >> 16
            ways.append((-base, side - 2 - (max(values) >> 16)))
        if all(low <= high for low, high in ways):
            break
    first, second = ([rng.randint(*way) for way in ways] for _ in range(2))
    placed = tuple((x + (first[0] << 16), y + (first[1] << 16), *rest)
                   for x, y, *rest in case.vertices)
    return translation(replace(case, vertices=placed), *(b - a for a, b in zip(first, second)))


def check_wrapping(rng: random.Random, origin: str) -> list[str]:
    return wrapping(any_case(rng, origin), rng.randint(-20, 20), rng.randint(-20, 20))


def check_splitting(rng: random.Random, origin: str) -> list[str]:
    vertices = planar(rng, convex(rng, 4, LATTICE))
    settings = any_settings(rng, 4, gradients="plane", start="subtexel", mapper="affine",
                            edges=rng.choice(("subpixel", "exact")))
    return splitting(Case(origin, vertices, WIDTH, HEIGHT, settings),
                     random_meshes.halves(rng, list(vertices)))


def uneven_case(rng: random.Random, origin: str) -> Case:
    """A polygon whose vertices have arbitrary s, t, shade and w, with any mapper, perspective and
    edges; a few are planar."""
    points, mapper = convex(rng, 4), rng.choice((*REPEATING, "arbitrary", "gouraud", "lit_gouraud"))
    settings = any_settings(rng, 4, gradients="plane", mapper=mapper)
    deep = mapper == "affine" and rng.random() < 0.5
    if deep or mapper in ("dithered", "keyed", "lit_gouraud"):
        settings = replace(settings, start="subtexel",
                           perspective=rng.choice(("every16", "fine")) if deep else "none")
    vertices = list(planar(rng, [(x // LATTICE * LATTICE, y // LATTICE * LATTICE) for x, y in points]))
    if rng.random() < 0.9:
        vertices = [(x, y, *(rng.randrange(256 << 16) for _ in range(3)),
                     rng.randint(ONE, 4 * ONE) if deep else ONE) for x, y, *_ in vertices]
    elif mapper == "arbitrary":
        vertices = [(x, y, 1 << 16, 2 << 16, 0, ONE) for x, y, *_ in vertices]
    return Case(origin, tuple(vertices), WIDTH, HEIGHT, settings)


def holds(prop, case_of):
    """A check of a property that has no arguments but its case."""
    return lambda rng, origin: prop(case_of(rng, origin))


#: name: function that draws a random case and returns its complaints
CHECKS = {name.removeprefix("check_"): function for name, function in list(globals().items())
          if name.startswith("check_")} | {
    "held": holds(held, held_case), "rotation": holds(rotation, any_case),
    "reversal": holds(reversal, any_case), "uneven": holds(pieces, uneven_case)}


def check(name: str, seed: int, number: int) -> list[str]:
    """Returns the complaints of one random case, which depends only on these three arguments."""
    rng = random.Random(f"{name} {seed} {number}")
    return CHECKS[name](rng, f"{name}, seed {seed}, number {number}")


def complaints(name: str, seed: int, count: int) -> Iterator[str]:
    for number in range(count):
        yield from check(name, seed, number)
