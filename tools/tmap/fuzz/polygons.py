"""Random polygons for the fuzzer: number k of a seed and a family is the same in every run.

Ordinary polygons, handwritten ones (tmap.corpus.written) and kinds that are known to break
rasterisers, with every setting and mapper. The BLOCK polygons of a block share a frame size and
maps, as one scene file.
"""

import random
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from tmap.base.fixed import ONE, ceil16, fix
from tmap.compiler.map_range import extent_of
from tmap.corpus import written
from tmap.corpus.random_polygons import convex_polygon
from tmap.fuzz import depths
from tmap.fuzz.families import ALL
from tmap.model.model import FAR
from tmap.scene_file.scene_file import (IDENTITY, MAPPER_LAYOUT, MAPPERS, ON_PLANE, SETTINGS, Material,
                                        Object, Scene, Texture)
from tmap.scene_file.textures import IN_DEPTH
from tmap.setup.shading import LIT
from tmap.setup.texturing import Settings

BLOCK = 1000
#: Width and height of blocks' frames, in turn: small ones are quick, long ones show drift, high ones have
#: columns.
FRAMES = ((64, 48), (160, 100), (64, 48), (1024, 6), (64, 128), (8, 1024), (96, 64), (4, 1))
SIDES = {"page": (8, 16, 32, 64, 128, 256), "columns": (8, 16, 32, 64, 128, 256, 512)}
#: Tolerances of materials with a perspective, 1/65536 texel.
TOLERANCES = (0, 0, 0, 655, 6554, ONE // 2, ONE)
#: Sides of maps that can have any size.
ODD_SIDES = (1, 2, 3, 7, 8, 37, 100, 255, 256, 257, 640)


@dataclass(frozen=True)
class Fuzzed:
    """One polygon, its settings and its texture."""

    vertices: tuple[tuple[int, int, int, int, int, int], ...]  # x, y, s, t, shade, w; 16.16
    settings: Settings
    texture: int  # index in its block's textures; -1: none


def frame_size(block: int) -> tuple[int, int]:
    """Returns width and height of a block's frame."""
    return FRAMES[block % len(FRAMES)]


@cache
def textures(seed: int, block: int) -> list[Texture]:
    """Returns the maps of a block: some of each layout, a light table last."""
    rng = random.Random(f"{seed} maps {block}")
    noise = np.random.default_rng([seed, block])
    sizes = [("page", (256, 256)), ("page", (rng.choice(SIDES["page"]), rng.choice(SIDES["page"]))),
             ("tiled", (256, 256)), ("margins", (256, 256))]
    sizes += [("linear", (rng.choice(ODD_SIDES), rng.choice(ODD_SIDES))) for _ in range(3)]
    sizes += [("columns", (rng.choice(SIDES["columns"]), rng.choice(SIDES["columns"])))
              for _ in range(2)]
    sizes += [("light", (256, 64))]  # the last one
    return [Texture(noise.integers(0, 256, (h, w), dtype=np.uint8), layout)
            for layout, (w, h) in sizes]


def corners(rng: random.Random, width: int, height: int) -> list[tuple[int, int]]:
    """Returns x and y of a polygon, 16.16."""
    kind = rng.random()
    if kind < 0.5:
        points = convex_polygon(rng, width, height)
    elif kind < 0.6:  # a sliver: three points on a line, one moved a little
        x, y = fix(rng.uniform(0, width)), fix(rng.uniform(0, height))
        dx, dy = (rng.randint(-ONE << 7, ONE << 7) >> rng.randrange(16) for _ in range(2))
        a, b = rng.randint(-3, 3), rng.randint(-3, 3)
        points = [(x, y), (x + dx, y + dy), (x + 2 * dx + a, y + 2 * dy + b)]
    elif kind < 0.7:  # within a pixel or two
        x, y = rng.randrange(width) * ONE, rng.randrange(height) * ONE
        points = [(x + rng.randint(-ONE, ONE), y + rng.randint(-ONE, ONE)) for _ in range(3)]
    elif kind < 0.8:  # anything in range
        points = [(rng.randint(-FAR, FAR - 1), rng.randint(-FAR, FAR - 1)) for _ in range(3)]
    elif kind < 0.87:  # around the frame, on whole and half pixels
        points = [(rng.randint(-4, 2 * width + 4) * ONE // 2, rng.randint(-4, 2 * height + 4) * ONE // 2)
                  for _ in range(3)]
    elif kind < 0.92:  # repeated and collinear vertices
        points = convex_polygon(rng, width, height)
        at = rng.randrange(len(points))
        a, b = points[at], points[(at + 1) % len(points)]
        middle = a if rng.random() < 0.5 else ((a[0] + b[0]) // 2, (a[1] + b[1]) // 2)
        points.insert(at + 1, middle)
    elif kind < 0.97:  # any order: crossing itself
        points = [(fix(rng.uniform(-width, 2 * width)), fix(rng.uniform(-height, 2 * height)))
                  for _ in range(rng.randint(3, 12))]
    else:  # any bits
        points = [(rng.randint(-1 << 31, (1 << 31) - 1) >> rng.randrange(4),
                   rng.randint(-1 << 31, (1 << 31) - 1) >> rng.randrange(4)) for _ in range(3)]
    return points


def visible_corners(rng: random.Random, width: int, height: int) -> list[tuple[int, int]]:
    """Returns corners whose box covers a pixel of the frame, nine times in ten."""
    for _ in range(1 if rng.random() < 0.1 else 20):
        points = corners(rng, width, height)
        ends = [(min(axis), max(axis)) for axis in zip(*points)]
        if all(max(ceil16(low), 0) < min(ceil16(high), side)
               for (low, high), side in zip(ends, (width, height))):
            break
    return points


def plane_of(rng: random.Random, points, most: int) -> list[tuple[int, int]]:
    """Returns s and t of the corners, from one affine function of x and y; |s|, |t| < ``most``."""
    if len(points) == 3 and rng.random() < 0.4:  # three vertices are always on a plane
        return [(rng.randint(-most, most - 1) >> rng.randrange(12),
                 rng.randint(-most, most - 1) >> rng.randrange(12)) for _ in points]
    gradients = [rng.choice((0, 1, -1, rng.uniform(-2, 2), rng.uniform(-16, 16),
                             rng.uniform(-256, 256))) for _ in range(4)]
    base = [rng.randint(-300, 300) * ONE + rng.choice((0, ONE // 2, rng.randrange(ONE)))
            for _ in range(2)]
    x0, y0 = points[0]
    plane = [tuple(base[k] + round(gradients[2 * k] * (x - x0) + gradients[2 * k + 1] * (y - y0))
                   for k in range(2)) for x, y in points]
    largest = max(abs(c) for pair in plane for c in pair)
    if largest >= most:  # flatter, but still one plane
        shrink = most / (largest + 1)
        plane = [tuple(int(c * shrink) if len(points) == 3 else 0 for c in pair) for pair in plane]
    return plane


def inside_map(plane, size: tuple[int, int]) -> list[tuple[int, int]]:
    """Wraps s and t into a map that does not repeat, 0 to 256 along its longer side; only for
    three vertices, whose texture is always planar."""
    longer = max(size)
    made = []
    for k, side in enumerate(size):
        limit = side * 256 * ONE // longer
        made.append([c % (limit + 1) for c in (pair[k] for pair in plane)])
    return list(zip(*made))


def with_perspective(rng: random.Random, each: Fuzzed, size: tuple[int, int], by_hand: bool,
                     family: str) -> Fuzzed:
    """Gives a quarter of the polygons that may have them, or all of a family in perspective, depths, and a perspective
    with the settings that it needs; ``size``: the frame's; ``by_hand``: three in four depths are handwritten."""
    if family == ALL and (each.settings.mapper not in IN_DEPTH or rng.random() >= 0.25):
        return each
    settings = replace(each.settings, perspective=rng.choice(
        [name for name in SETTINGS["perspective"] if family == ALL or name != "none"]))
    if settings.perspective != "none":
        settings = replace(settings, gradients="plane", start="subtexel",
                           tolerance=rng.choice(TOLERANCES))
    vertices = each.vertices
    if settings.perspective != "none" or len(vertices) == 3:  # "none": s, t planar on screen
        kind = rng.choice(depths.KINDS)
        if by_hand and rng.random() < 0.75:
            kind = depths.WRITTEN
        vertices = depths.in_depth(rng, kind, vertices, size)
    return replace(each, vertices=vertices, settings=settings)


def uneven(rng: random.Random, each: Fuzzed, maps: list[Texture]) -> Fuzzed:
    """Moves one vertex off the others' planes in one of eight polygons with more than three
    vertices: by about the rounding, or by far; it stays on a map that does not repeat."""
    if len(each.vertices) == 3 or rng.random() >= 1 / 8:
        return each
    k, field = rng.randrange(len(each.vertices)), rng.choice((2, 3, 4))
    vertex = list(each.vertices[k])
    off = rng.choice((-1, 1)) * rng.randrange(1, 1 << rng.randrange(1, 28))
    vertex[field] = min(max(vertex[field] + off, -FAR), FAR - 1)
    vertex[4] = min(max(vertex[4], 0), 256 * ONE - 1)
    if each.settings.mapper == "arbitrary":
        ends = extent_of(maps[each.texture].texels.shape[::-1])
        vertex[2:4] = (min(max(c, 0), int(end * ONE)) for c, end in zip(vertex[2:4], ends))
    return replace(each, vertices=(*each.vertices[:k], tuple(vertex), *each.vertices[k + 1:]))


@cache
def polygon(seed: int, number: int, family: str = ALL) -> Fuzzed:
    """Returns polygon ``number`` of a seed and a family."""
    maps, name, tries = textures(seed, number // BLOCK), str(seed), 0
    while True:
        if family != ALL:
            name = f"{seed} {family} {tries}"
        each = uneven(random.Random(f"{name} uneven {number}"), even(seed, number, family, name), maps)
        if family == ALL or len({v[5] for v in each.vertices}) > 1:
            return each
        tries += 1


def for_triangles(rng: random.Random, width: int, height: int, most: int):
    """Returns corners inside a frame and their s and t, which routines for triangles may draw: a
    triangle or, one time in eight, a parallelogram. ``most``: lines."""
    reach = rng.choice((1, 4, 16, 64, 320))
    x, y = rng.uniform(0, min(width, 320)), rng.uniform(0, height)
    one = rng.choice((1, 1 << 12, ONE, ONE))  # coordinates are multiples of it
    points = [(int(min(max(x + rng.uniform(-reach, reach), 0), min(width, 320)) * ONE) // one * one,
               int(min(max(y + rng.uniform(-reach, reach), y - most / 2, 0), height, y + most / 2)
                   * ONE) // one * one) for _ in range(3)]
    size = rng.choice((1, 16, 256, 511)) * ONE
    plane = [(rng.randint(-size, size - 1) // one * one, rng.randint(-size, size - 1) // one * one)
             for _ in range(3)]
    if rng.random() < 1 / 8:
        a, b, c = points
        points.append((a[0] + c[0] - b[0], a[1] + c[1] - b[1]))
        a, b, c = plane
        plane.append((a[0] + c[0] - b[0], a[1] + c[1] - b[1]))
    return points, plane


def even(seed: int, number: int, family: str = ALL, name: str = "") -> Fuzzed:
    """Returns polygon ``number`` of a family with all vertices on planes. ``name``: what its random numbers depend on
    beside ``number``, the seed if it is empty."""
    name = name or str(seed)
    rng = random.Random(f"{name} fuzz {number}")
    block = number // BLOCK
    width, height = frame_size(block)
    hand = random.Random(f"{name} written {number}")
    by_hand = hand.random() < written.SHARE
    points = (written.outline(hand, width, height) if by_hand else
              visible_corners(rng, width, height))
    others = tuple(mapper for mapper in (MAPPERS[1] if family == ALL else IN_DEPTH) if mapper != "affine")
    mapper = rng.choice(others + 4 * ("affine",))
    choices = {kind: rng.choice(names) for kind, names in SETTINGS.items()
               if kind not in ("mapper", "perspective")}
    if mapper in ON_PLANE:
        choices |= {"gradients": "plane", "start": "subtexel"}
    settings = Settings(mapper=mapper, **choices)
    if len(points) > 3 and settings.gradients == "polygon":
        settings = replace(settings, gradients="plane")
    layout, texture = MAPPER_LAYOUT[mapper], -1
    maps = textures(seed, block)
    if layout:
        texture = rng.choice([k for k, t in enumerate(maps) if t.layout == layout])
    map_size = maps[texture].texels.shape[::-1] if layout else (256, 256)
    if by_hand:
        plane = written.texels(hand, points, extent_of(map_size), mapper != "arbitrary")
    else:
        plane = plane_of(rng, points, FAR)
        if mapper == "arbitrary":
            points = points[:3]
            plane = inside_map(plane[:3], map_size)
    if settings.edges == "snapped" and mapper != "arbitrary" and hand.random() < 0.5:
        points, plane = for_triangles(hand, width, height, 127)
        settings = replace(settings, gradients="plane", start="subtexel")
    shades = [rng.choice((0, 255 * ONE, 256 * ONE - 1, rng.randrange(256 * ONE))) for _ in points]
    if len(points) > 3:  # planar: along y, over the polygon's height
        low, high = min(y for _, y in points), max(y for _, y in points)
        shades = [(y - low) * 255 * ONE // max(high - low, 1) for _, y in points]
    if by_hand and hand.random() < 0.5:
        shades = [hand.choice((0, 128, 255)) * ONE] * len(points)
    vertices = tuple((*p, *q, shade, ONE) for p, q, shade in zip(points, plane, shades))
    return with_perspective(random.Random(f"{name} depth {number}"),
                            Fuzzed(vertices, settings, texture), (width, height), by_hand, family)


def scene(seed: int, block: int, polygons: list[Fuzzed]) -> Scene:
    """Returns a scene of the polygons with a block's frame size and maps, one per frame."""
    materials: dict[Material, int] = {}
    maps = textures(seed, block)
    objects, vertices = [], []
    for number, each in enumerate(polygons):
        mapper = each.settings.mapper
        material = Material(**vars(each.settings), texture=each.texture,
                            colour=200 if mapper == "flat" else 0,
                            light=len(maps) - 1 if mapper in LIT else -1)
        objects.append(Object(materials.setdefault(material, len(materials)), len(vertices),
                              len(each.vertices), 0, 1, number, 0))
        vertices += each.vertices
    palette = np.zeros((256, 3), np.uint8)
    return Scene(*frame_size(block), len(polygons), 7, palette, maps,
                 list(materials), objects, np.array(vertices), np.array([IDENTITY]))
