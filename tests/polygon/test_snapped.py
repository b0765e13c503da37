"""Triangles with snapped vertices: neighbours cover each pixel once, whichever set-up draws them, and
values keep their bounds."""

import math
import random

import numpy as np

from tmap.base.fixed import ONE, fix
from tmap.ideal import bounds
from tmap.model import model
from tmap.setup import shading, snapped
from tmap.setup.texturing import Settings

WIDTH, HEIGHT = 320, 256
SNAPPED = Settings("snapped")


def mesh(rng: random.Random, across: int) -> list[list[tuple]]:
    """Triangles that cover the frame and more, once: a grid whose points are moved a little."""
    step = (WIDTH + 40) / across
    rows = int((HEIGHT + 60) / step) + 2
    points = [[(fix(step * (i + rng.uniform(-0.2, 0.2)) - 20), fix(step * (j + rng.uniform(-0.2, 0.2)) - 20))
               for i in range(across + 1)] for j in range(rows)]
    for k in (0, -1):  # the outer points are outside
        points[k] = [(x, fix((-60, HEIGHT + 60)[k])) for x, _ in points[k]]
        for row in points:
            row[k] = (fix((-60, WIDTH + 60)[k]), row[k][1])
    made = []
    for j in range(rows - 1):
        for i in range(across):
            a, b, c, d = points[j][i], points[j][i + 1], points[j + 1][i + 1], points[j + 1][i]
            made += [[a, b, c], [a, c, d]] if rng.random() < 0.5 else [[a, b, d], [d, b, c]]
    return [[(x, y, x, y, 0, ONE) for x, y in three] for three in made]


def covered(triangles, settings_of) -> tuple[np.ndarray, int]:
    """Returns how often each pixel is drawn, and how many triangles routines for triangles drew."""
    count, drawn = np.zeros((HEIGHT, WIDTH), int), 0
    for number, vertices in enumerate(triangles):
        settings = settings_of(number)
        made = model.set_up(model.adapt(vertices, settings, 256), WIDTH, HEIGHT, True, settings, (256, 256))
        if made:
            drawn += made.triangle is not None
            for y, line in enumerate(made.lines, made.top):
                count[y, line.left:max(line.left, line.right)] += 1
    return count, drawn


def test_neighbours_cover_each_pixel_once_by_either_set_up():
    rng, handed = random.Random("snapped neighbours"), 0
    for across in (2, 3, 8, 40, 90):
        triangles = mesh(rng, across)
        count, drawn = covered(triangles, lambda _: SNAPPED)
        handed += len(triangles) - drawn
        assert (count == 1).all(), (across, np.argwhere(count != 1)[:3])
        # the same with a mapper that has no routine for every third triangle
        count, _ = covered(triangles, lambda n: Settings("snapped", mapper="tiled") if n % 3 else SNAPPED)
        assert (count == 1).all(), (across, np.argwhere(count != 1)[:3])
    assert handed > 100  # by their place or height


def test_unrounded_vertices_beside_rounded_ones_are_noticed():
    triangles = mesh(random.Random("snapped neighbours"), 40)
    count, _ = covered(triangles, lambda n: Settings("exact") if n % 3 else SNAPPED)
    assert (count != 1).any()


def edges(rng: random.Random):
    """Edges (x, y, dx, dy), many of them nearly at a pixel on their last lines."""
    for _ in range(1500):
        dy = rng.choice((rng.randrange(1, 256), rng.randrange(240, 272), rng.randrange(256, 2048),
                         rng.randrange(2000, 2048), rng.randrange(2048, 4096), rng.randrange(4000, 4096)))
        y, dx = rng.randrange(0, 16), rng.randrange(-5120, 5121)
        line = (y + dy - rng.randrange(1, 40) & -16) - y
        if line > 0 and math.gcd(line, dy) == 1 and rng.random() < 0.7:  # x a 1/dy beside a sixteenth
            dx = (pow(line, -1, dy) * rng.choice((1, -1, 2, -2)) + dy * rng.randrange(-2, 3)) % (2 * dy) - dy
            dx = max(-5120, min(5120, dx))
        yield rng.randrange(max(0, -dx), min(5120, 5120 - dx) + 1), y, dx, dy


def test_edges_are_exact_with_the_fractions_of_each_loop():
    for x, y, dx, dy in edges(random.Random("snapped edges")):
        first, end = y + 15 >> 4, y + dy + 15 >> 4
        exact = [-((-x * dy - (16 * line - y) * dx) // (16 * dy)) for line in range(first, end)]
        edge = snapped.Edge(x, y, dx, dy, False)
        assert edge.columns(end - first) == exact, (x, y, dx, dy)
        if dy < snapped.TALL:  # narrow and wide triangles have 24 bits
            assert [(edge.at >> 8) + n * (edge.step >> 8) >> 24 for n in range(end - first)] == exact
        if dy <= snapped.SMALL_HEIGHT:
            assert snapped.Edge(x, y, dx, dy, True).columns(end - first) == exact


def test_values_keep_their_bounds_and_nearly_reach_them():
    rng, worst = random.Random("snapped bounds"), 0.0
    for _ in range(300):
        reach, high = rng.choice(((4, 2), (30, 15), (127, 64), (127, 127)))
        x, y = rng.uniform(reach, WIDTH - reach), rng.uniform(high, HEIGHT - high)
        vertices = [(fix(x + rng.uniform(-reach, reach)), fix(y + rng.uniform(-high, high)),
                     *(fix(rng.uniform(-reach, reach)) for _ in range(2)), 0, ONE) for _ in range(3)]
        verdict = bounds.judge(vertices, SNAPPED, WIDTH, HEIGHT)
        assert not verdict.complaint, (vertices, verdict.complaint)
        assert not verdict.coverage_errors
        worst = max(worst, verdict.texel_ratio)
    assert worst > 0.5


def test_a_wrong_reciprocal_leaves_the_bounds(monkeypatch):
    right = snapped.reciprocal
    monkeypatch.setattr(snapped, "reciprocal", lambda dy: right(dy) + (dy and right(dy) >> 12))
    vertices = [(fix(10), fix(10), 0, 0, 0, ONE), (fix(250), fix(40), fix(200), fix(20), 0, ONE),
                (fix(60), fix(120), fix(30), fix(99), 0, ONE)]
    assert bounds.judge(vertices, SNAPPED, WIDTH, HEIGHT).complaint


def test_levels_keep_their_bound_and_the_vertices_levels():
    rng, worst = random.Random("snapped levels"), 0.0
    settings = Settings("snapped", mapper="lit_gouraud")
    for _ in range(300):
        reach = rng.choice((1, 4, 30, 100))
        x, y = rng.uniform(reach, WIDTH - reach), rng.uniform(reach / 2, HEIGHT - reach / 2)
        vertices = [(fix(x + rng.uniform(-reach, reach)), fix(y + rng.uniform(-reach, reach) / 2), 0, 0,
                     rng.choice((fix(rng.uniform(0, 255)), rng.randrange(64) << 18)), ONE) for _ in range(3)]
        verdict = bounds.judge(vertices, settings, WIDTH, HEIGHT)
        assert not verdict.complaint, (vertices, verdict.complaint)
        worst = max(worst, verdict.texel_ratio)
        polygon = model.set_up(model.adapt(vertices, settings, 256), WIDTH, HEIGHT, True, settings, (256, 256))
        if polygon:
            assert polygon.triangle
            levels = [level for line in polygon.lines for level in shading.rows([line])]
            whole = [v[4] >> 18 for v in vertices]
            assert not levels or min(whole) <= min(levels) and max(levels) <= max(whole), vertices
    assert worst > 0.8


def test_no_pixel_leaves_a_map_that_does_not_repeat():
    """Texels of the map's corners, and triangles as narrow as is allowed."""
    rng, drawn = random.Random("snapped maps"), 0
    settings = Settings("snapped", mapper="arbitrary")
    ends = [snapped.BELOW_MAP, (256 << 16) - snapped.ABOVE_MAP]
    for _ in range(400):
        reach, x = rng.choice((1, 4, 40, 250)), rng.randint(4, WIDTH - 4)
        vertices = [(fix(min(max(x + rng.uniform(-1, 1) * rng.choice((1, reach)), 0), WIDTH)),
                     fix(min(max(100 + rng.uniform(-reach, reach), 0), HEIGHT)),
                     rng.choice(ends), rng.choice(ends), 0, ONE) for _ in range(3)]
        polygon = model.set_up(model.adapt(vertices, settings, 256), WIDTH, HEIGHT, True, settings, (256, 256))
        if polygon and polygon.triangle:
            drawn += 1
            for y, line in enumerate(polygon.lines, polygon.top):
                u, v = polygon.coordinates(y)
                assert ((u >= 0) & (u < 256 << 16) & (v >= 0) & (v < 256 << 16)).all(), vertices
        verdict = bounds.judge(vertices, settings, WIDTH, HEIGHT)
        assert not verdict.complaint, (vertices, verdict.complaint)
    assert drawn > 100
