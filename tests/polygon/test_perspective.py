"""Perspective on the emulated Amiga: its cost, and changes that must leave the picture
unchanged."""

import random

import numpy as np
import pytest

from tmap.corpus import random_polygons
from tmap.guest import guest_frames
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.model import model
from tmap.scene_file.scene_file import IDENTITY, ONE, SETTINGS, Material, Object, Scene, Texture

WIDTH, HEIGHT = 160, 120
MACHINE = "a1200-fast"
WAYS = SETTINGS["perspective"][1:]


def scene(polygons, materials: list[Material]) -> Scene:
    """A scene of each polygon with each material, one a frame."""
    noise = np.random.default_rng(7).integers(0, 256, (256, 256), dtype=np.uint8)
    objects, vertices = [], []
    for corners in polygons:
        for k in range(len(materials)):
            objects.append(Object(k, len(vertices), len(corners), 0, 1, len(objects)))
        vertices += corners
    return Scene(WIDTH, HEIGHT, len(objects), 7, np.zeros((256, 3), np.uint8), [Texture(noise)],
                 materials, objects, np.array(vertices), np.array([IDENTITY]))


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


def test_constant_depth_is_affine() -> None:
    """The picture is the same whatever w is, and costs as much as the affine polygon plus the test
    of w."""
    rng = random.Random(1)
    polygons = []
    for depth in (256, ONE, 5 * ONE + 1, 1 << 30):
        polygons += [[(*v[:5], depth) for v in surface(rng, 1)] for _ in range(6)]
    kinds = [Material("affine", "exact", perspective=p, texture=0) for p in ("none", *WAYS)]
    this = scene(polygons, kinds)
    digests, = guest_frames.draw([(this, "addx")], MACHINE)
    rows = digests.reshape(len(polygons), len(kinds))
    seen = 0
    for k, row in enumerate(rows):
        affine = model.render(this, k * len(kinds))
        wrong = [kind.perspective for kind, digest in zip(kinds, row) if not guest_frames.is_models(affine, digest)]
        assert not wrong, f"polygon {k} is not the affine one by {wrong}: {polygons[k]}"
        seen += len(np.unique(affine)) > 4
    assert seen > len(polygons) / 2  # some are beside the frame
    spent = rows["ticks"].astype(int).sum(0) * CYCLES_PER_TICK / len(polygons)
    assert (spent[1:] - spent[0]).max() < 250, spent


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
                [c.tolist() for c in polygon.coordinates(line, y)]
                for y, line in enumerate(polygon.lines, polygon.top) if line.right > line.left])
        assert shown[0] == shown[1] == shown[2]
        pixels += sum(len(u) for u, _ in shown[0])
    assert pixels > 40 * 1000
