"""Perspective: changes that must leave the picture unchanged. Tests of what is drawn are in
tests/accuracy: test_hard_cases.py has all families of depths."""

import random

import pytest

from tmap.corpus import random_polygons
from tmap.model import model
from tmap.scene_file.scene_file import ONE, SETTINGS
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
