"""Perspective: changes that must leave the picture unchanged, and depth that hardly changes. Other tests of what is
drawn are in tests/accuracy: test_hard_cases.py has all families of depths."""

import random

import numpy as np
import pytest

from tmap.base.fixed import fix
from tmap.corpus import random_maps, random_polygons
from tmap.guest import guest_frames
from tmap.model import model
from tmap.scene_file.scene_file import IDENTITY, ONE, SETTINGS, Material, Object, Scene, Texture
from tmap.setup.perspective import EXACT

WIDTH, HEIGHT = 160, 120
WAYS = SETTINGS["perspective"][1:]


def surface(rng: random.Random, ratio: float) -> list[tuple[int, ...]]:
    """A convex polygon with 1/w on a plane, w differing by up to ``ratio``, and s and t flat on
    it."""
    while True:
        points = random_polygons.convex_polygon(rng, WIDTH, HEIGHT)
        if random_polygons.is_convex(points):
            break
    along = rng.uniform(-1, 1), rng.uniform(-1, 1)
    way = [along[0] * x + along[1] * y for x, y in points]
    low, high = min(way), max(way)
    corners = []
    for (x, y), here in zip(points, way):
        near = 1 + (ratio - 1) * (here - low) / max(high - low, 1)
        s, t = ((x / ONE - 80) / near * 2, (y / ONE - 60) / near * 2)
        corners.append((x, y, round(s * ONE), round(t * ONE), 0, round(ratio * ONE / near)))
    return corners


@pytest.mark.parametrize("way", WAYS)
def test_order_of_vertices_does_not_matter(way: str) -> None:
    """The picture is the same whichever vertex comes first, in either winding."""
    rng, pixels = random.Random(way), 0
    settings = model.Settings("exact", perspective=way)
    for _ in range(40):
        corners = surface(rng, rng.choice((1.0001, 2, 100, 10000)))
        shown = []
        for turned in (corners, corners[1:] + corners[:1], corners[::-1]):
            polygon = model.set_up(model.adapt(turned, settings, 256), WIDTH, HEIGHT, True, settings)
            shown.append([] if polygon is None else [
                [c.tolist() for c in polygon.coordinates(y)]
                for y, line in enumerate(polygon.lines, polygon.top) if line.right > line.left])
        assert shown[0] == shown[1] == shown[2]
        pixels += sum(len(u) for u, _ in shown[0])
    assert pixels > 40 * 1000


@pytest.mark.parametrize("way, units", [("pixel", 2048), ("fine", 512)])
def test_straight_pieces_do_for_curves(way: str, units: int) -> None:
    """Where depth hardly changes, straight pieces replace curves; with their rounding they stay within the
    tolerance."""
    rng, settings, seen = random.Random(way), model.Settings("exact", perspective=way), set()
    for _ in range(60):
        corners = surface(rng, 1 + 10 ** rng.uniform(-5, -1))
        polygon = model.set_up(model.adapt(corners, settings, 256), WIDTH, HEIGHT, True, settings)
        if not polygon or not polygon.perspective or polygon.exact == way:
            continue
        seen.add(polygon.exact)
        pixels, p = EXACT[polygon.exact], polygon.perspective
        q, st = p.q.dx / p.least / 2**32, [plane.dx / p.least for plane in (p.s, p.t)]
        for grows in st:
            chord = pixels**2 / 4 * abs(q) * (abs(grows) + p.farthest * abs(q))
            assert chord + 4 * pixels + 2 <= units
    assert len(seen) > 1


def test_depth_that_hardly_grows_is_the_models() -> None:
    """q grows by less than 2,000 of 2^31 a pixel, so 2^31 / that, times texels, exceeds a longword; u and v grow down the
    frame alone, by whole units at times, so that K is near and borders are met. One triangle a frame."""
    rng, ways = random.Random("hardly"), ("pixel", "fine")
    materials = [Material("affine", "subpixel", perspective=way, texture=0) for way in ways]
    objects, vertices, growths = [], [], []
    while len(objects) < 200:
        number, depth = len(objects), fix(rng.uniform(1, 30))
        start = [rng.randint(-100, 100) * ONE for _ in range(2)]
        down = [rng.choice((0, rng.randint(-3, 3), rng.uniform(-3, 3))) for _ in range(2)]
        corners = [(x, y, *(at + int(grows * y) for at, grows in zip(start, down)), 0, depth + rng.randint(-8, 8))
                   for x, y in random_polygons.convex_polygon(rng, WIDTH, HEIGHT)[:3]]
        settings = model.Settings("subpixel", perspective=ways[number % 2])
        polygon = model.set_up(model.adapt(corners, settings, 256), WIDTH, HEIGHT, True, settings)
        if polygon and polygon.constants and not polygon.is_level and abs(polygon.constants.dqdx) < 2000:
            growths.append(abs(polygon.constants.dqdx))
            objects.append(Object(number % 2, len(vertices), 3, 0, 1, number, 0))
            vertices += corners
    assert min(growths) < 20 and max(growths) > 500, growths
    scene = Scene(WIDTH, HEIGHT, len(objects), 1, random_maps.palette(), [Texture(random_maps.page())], materials,
                  objects, np.array(vertices), np.array([IDENTITY]))
    digests, = guest_frames.draw([(scene, "addx")], "a1200-fast", timed=False)
    guest_frames.require_models((model.render(scene, number) for number in range(scene.frames)), digests,
                                "depth that hardly grows", (scene, "addx", "a1200-fast"))
