"""Walls, which are drawn by columns of the frame: the pixels that lines have, bit for bit the model's texels."""

import random
from functools import cache

import numpy as np
import pytest

from tmap.base.fixed import ONE
from tmap.corpus import random_polygons
from tmap.corpus.random_maps import page
from tmap.guest import guest_frames
from tmap.ideal.bounds import check_set_up
from tmap.model import model
from tmap.scene_file.scene_file import IDENTITY, SETTINGS, Material, Object, Scene, Texture, vertices_at
from tmap.setup.edges import measure
from tmap.setup.polygon import Outline

WIDTH, HEIGHT = 128, 160
WALLS = 24  # of each setting
UPRIGHT = 16  # walls and floors of each setting
WAYS = SETTINGS["perspective"][1:]
LEANS = (0, 0, 1e-6, 1e-5, 1e-4, 1e-3)  # how much 1/w grows on a column, of its growth on a line


def wall(rng: random.Random) -> list[tuple[int, ...]]:
    """A convex polygon, whose depth grows along lines: 1.1 to 50 times. Many have upright sides: their depth is
    the same down each column, rounding included."""
    is_upright = rng.random() < 0.5
    while True:
        points = random_polygons.convex_polygon(rng, WIDTH, HEIGHT)
        if is_upright:
            sides = ((rng.randint(-30, 60) * ONE, 1), (rng.randint(70, 150) * ONE, -1))
            points = [(x, y) for x, way in sides
                      for y in (rng.randint(-40, 60) * ONE, rng.randint(90, 200) * ONE)[::way]]
        ys = [y for _, y in points]
        if random_polygons.is_convex(points) and min(max(ys), HEIGHT * ONE) - max(min(ys), 0) > 100 * ONE:
            break
    lean = 0 if is_upright else rng.choice(LEANS)
    way = [x + lean * y for x, y in points]
    low, high, ratio = min(way), max(way), rng.uniform(1.1, 50)
    corners = []
    for (x, y), here in zip(points, way):
        near = 1 + (ratio - 1) * (here - low) / max(high - low, 1)
        s, t = (x / ONE - 60) / near, (y / ONE - 80) / near * 2
        corners.append((x, y, round(s * ONE), round(t * ONE), 0, round(ratio * 64 * ONE / near)))
    return corners


def scene_of(polygons: list) -> Scene:
    """The polygons, one a frame, with all settings in turn."""
    materials = [Material("affine", edges="exact", perspective=way, texture=0) for way in WAYS]
    objects, vertices = [], []
    for number, corners in enumerate(polygons):
        objects.append(Object(number % len(WAYS), len(vertices), len(corners), 0, 1, number))
        vertices += corners
    return Scene(WIDTH, HEIGHT, len(objects), 7, np.zeros((256, 3), np.uint8), [Texture(page())], materials,
                 objects, np.array(vertices), np.array([IDENTITY]))


@cache
def scene() -> Scene:
    """The walls of all settings."""
    rng = random.Random("walls")
    return scene_of([wall(rng) for _ in range(WALLS * len(WAYS))])


def parts(number: int, this: Scene | None = None) -> list[tuple[list, model.Polygon]]:
    """The adapted vertices and the polygon of each part in which a wall is drawn."""
    this, found = this or scene(), []
    each = this.objects[number]
    corners = vertices_at(this, each, number)
    settings = model.Settings.of(this.materials[each.material])
    for part in model.parts(corners, settings, (WIDTH, HEIGHT), 256):
        adapted = model.adapt(part, settings, 256)
        found.append((adapted, model.set_up(adapted, WIDTH, HEIGHT, True, settings, (256, 256))))
    return found


def pixels(polygon: model.Polygon | None) -> set[tuple[int, int]]:
    """The pixels of a polygon's lines."""
    return {(x, y) for y, line in enumerate(polygon.lines, polygon.top) for x in range(line.left, line.right)}


def test_columns_have_the_pixels_of_lines() -> None:
    """Also where edges and vertices are on pixels."""
    rng, seen = random.Random("pixels"), 0
    for number in range(600):
        grid = (ONE, ONE // 2, ONE // 4, 1)[number % 4]
        points = [(x // grid * grid, y // grid * grid, 0, 0)
                  for x, y in random_polygons.convex_polygon(rng, WIDTH // 4, HEIGHT // 4)]
        if len(set(points)) < len(points) or not random_polygons.is_convex([p[:2] for p in points]):
            continue
        turned = [(y, x, *rest) for x, y, *rest in points]
        by_lines, by_columns = set(), set()
        for corners, size, upright, found in ((points, (WIDTH, HEIGHT), False, by_lines),
                                              (turned, (HEIGHT, WIDTH), True, by_columns)):
            sides = measure(corners, *size)
            if sides:
                outline = Outline(sides.corners, corners, sides)
                found |= pixels(outline.polygon(size[0], True, True, upright))
        assert by_lines == {(x, y) for y, x in by_columns}, points
        seen += len(by_lines)
    assert seen > 100_000


def test_walls_are_the_models() -> None:
    """Bit for bit, with every setting."""
    this = scene()
    digests, = guest_frames.draw([(this, "addx")], "a1200-fast", timed=False)
    frames = (model.render(this, number) for number in range(this.frames))
    guest_frames.require_models(frames, digests, "walls", (this, "addx", "a1200-fast"))


def upright(rng: random.Random) -> list[tuple[int, ...]]:
    """A wall or a floor that is seen straight, and along its texture or across it."""
    tall, wide = rng.uniform(30, 0.9 * HEIGHT), rng.uniform(20, 0.8 * WIDTH)
    ends = [tall / rng.uniform(1.5, 8), tall][::rng.choice((-1, 1))]
    left, share = rng.uniform(-10, WIDTH - wide + 10), rng.random()
    horizon = rng.uniform(-5, HEIGHT - tall + 5) + tall * share
    scales = [rng.choice((-1, 1)) * rng.uniform(0.2, 30) for _ in "st"]
    corners = [(left + x * wide, horizon + (end - share) * ends[x], x * wide * scales[0], end * tall * scales[1], 0,
                tall / ends[x]) for x, end in ((0, 0), (1, 0), (1, 1), (0, 1))]
    if rng.random() < 0.5:
        corners = [(x, y, t, s, *rest) for x, y, s, t, *rest in corners]
    if rng.random() < 0.5:
        corners = [(y, x, *rest) for x, y, *rest in corners[::-1]]
    return [tuple(round(c * ONE) for c in corner) for corner in corners]


def test_upright_walls_and_floors_are_the_models() -> None:
    """Bit for bit; u or v has no step on many."""
    rng, seen = random.Random("upright"), set()
    this = scene_of([upright(rng) for _ in range(UPRIGHT * len(WAYS))])
    for number in range(this.frames):
        for _, made in parts(number, this):
            drawn = made and (made.columns or made)
            if drawn and drawn.perspective and drawn.perspective.inverse:
                seen.add((bool(made.columns), not drawn.perspective.s.dx, not drawn.perspective.t.dx))
    assert {(False, False, True), (True, False, True), (False, True, False), (True, True, False)} <= seen
    digests, = guest_frames.draw([(this, "addx")], "a1200-fast", timed=False)
    frames = (model.render(this, number) for number in range(this.frames))
    guest_frames.require_models(frames, digests, "upright walls", (this, "addx", "a1200-fast"))


@pytest.mark.parametrize("way", WAYS)
def test_walls_keep_their_bounds(way: str) -> None:
    """Many of them are drawn by columns, leaning ones with pieces only."""
    upright = leaning = 0
    for number in range(WAYS.index(way), WALLS * len(WAYS), len(WAYS)):
        for adapted, polygon in parts(number):
            settings = model.Settings("exact", perspective=way)
            verdict = check_set_up(adapted, polygon, settings, WIDTH, HEIGHT, (256, 256))
            assert not verdict.complaint, (number, verdict.complaint)
            if polygon and polygon.columns:
                upright += 1
                leaning += polygon.columns.perspective.tilt != 0
    assert upright >= WALLS // 4, upright
    assert bool(leaning) == (way in ("every16", "every8")), leaning
