"""Trials of src68k/triangle against tools/tmap/setup/snapped.py, which is held to exact numbers
elsewhere."""

from collections.abc import Iterator

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.base.fixed import ONE
from tmap.bench.trial import Trial
from tmap.bench.triangle_fans import VALUES, Made, fans_trial, vertices_trial
from tmap.bench.triangles import HEIGHT, LINERS, ROUTINES, WIDTH, batch_trial, lines_trial
from tmap.setup import snapped

TALL = 300  # lines of a frame for triangles of up to so many
MOST = 256 << 20


def vertex(rng, around: tuple[int, int], reach: int, size: int, whole: bool,
           height: int) -> tuple[int, ...]:
    """A vertex near a place in the frame: u, which Gouraud draws, is a shade; then v and a level."""
    x, y = (int(np.clip(c + rng.integers(-reach, reach + 1), 0, 16 * side - 1))
            for c, side in zip(around, (WIDTH, height)))
    u = int(rng.integers(1 << 17, min(size, MOST) - (1 << 17)))
    v = int(rng.integers(-size, size))
    level = int(rng.integers(1 << 16, 64 << 20))
    return (x & -16, y & -16, u, v, level) if whole else (x, y, u, v, level)


def triangles(rng, count: int, height: int = HEIGHT) -> list[list[tuple]]:
    """Triangles of all sizes, some with level edges or without area."""
    made = []
    for _ in range(count):
        around = tuple(int(rng.integers(0, 16 * side)) for side in (WIDTH, height))
        reach, size = int(rng.choice((3, 20, 100, 400, 2040) if height == HEIGHT else (1500, 4000))), int(rng.choice((1 << 20, 1 << 26, 1 << 29)))
        three = [vertex(rng, around, reach, size, bool(rng.integers(4) == 0), height)
                 for _ in range(3)]
        if rng.integers(8) == 0:
            three[1] = (three[1][0], three[0][1], *three[1][2:])
        if rng.integers(16) == 0:
            three[2] = three[int(rng.integers(2))]
        made.append(three)
    return made


def whole_steps(rng, count: int) -> list[list[tuple]]:
    """Triangles whose values step by whole numbers a pixel and a line, up or down."""
    made = []
    for three in triangles(rng, count):
        a, b = (int(n) for n in rng.integers(-20, 21, 2))
        values = [(a * x + b * y) * (1 << 16) for x, y, *_ in three]
        if max(values) - min(values) >= MOST - (1 << 20):
            continue
        base = (1 << 19) - min(values) + int(rng.integers(0, 2)) * 12345
        made.append([(x, y, value + base, -value, 0) for (x, y, *_), value in zip(three, values)])
    return made


def tall(rng, count: int) -> list[list[tuple]]:
    """Triangles of many lines, some of them narrow; about one in four has too many."""
    made = triangles(rng, count, TALL)
    for three in made[::3]:
        x, width = int(rng.integers(0, 16 * WIDTH - 400)), int(rng.choice((20, 250, 400)))
        three[:] = [(x + int(rng.integers(0, width)), *v[1:]) for v in three]
    return made


def trials() -> Iterator[Trial]:
    """Single triangles, batches, culled ones, and lists that end early."""
    for mapper, name in ROUTINES.items():
        rng = np.random.default_rng(len(name))
        for number, each in enumerate(triangles(rng, 60)):
            yield batch_trial(Memory(), mapper, [each], f"{name}: triangle {number}, {each}")
        some = triangles(rng, 40)
        yield batch_trial(Memory(), mapper, some, f"{name}: 40 triangles")
        yield batch_trial(Memory(), mapper, some, f"{name}: 40 triangles, culled", cull=1)
        yield batch_trial(Memory(), mapper, [], f"{name}: an empty list")
        for number, each in enumerate(whole_steps(rng, 60)):
            yield batch_trial(Memory(), mapper, [each], f"{name}: whole steps {number}, {each}")
        for corner in range(3):
            wrong = [v if k != corner else None for k, v in enumerate(some[3])]
            yield batch_trial(Memory(), mapper, [*some[:3], wrong, *some[4:]],
                              f"{name}: vertex {corner} of the fourth is out of range")
        for number, each in enumerate(tall(rng, 60)):
            yield batch_trial(Memory(), mapper, [each], f"{name}: tall {number}, {each}", height=TALL)
        high = [(x, y, MOST // 2, 0, 0) for x, y in ((0, 0), (16 * 20, 16 * snapped.LINES), (0, 16 * 30))]
        yield batch_trial(Memory(), mapper, [some[0], high, some[1]], f"{name}: the second is too high",
                          height=TALL)
    for name in LINERS:
        yield from table_trials(name)
    for mapper in VALUES:
        yield from fans_trials(mapper)


def table_trials(name: str) -> Iterator[Trial]:
    """Tables of lines of single triangles, of the first with lines in a batch, and of none."""
    rng = np.random.default_rng(len(name))
    for number, each in enumerate(triangles(rng, 300)):
        yield lines_trial(Memory(), name, [each], f"{name}: triangle {number}, {each}")
    for number, each in enumerate(tall(rng, 40)):
        yield lines_trial(Memory(), name, [each], f"{name}: tall {number}, {each}", height=TALL)
    some = triangles(rng, 6)
    flat = [(v[0], some[0][0][1], *v[2:]) for v in some[0]]
    turned = [some[1][k] for k in (0, 2, 1)]
    for title, batch, cull in (("an empty list", [], 0), ("one without area", [flat], 0),
                               ("the second has lines", [flat, some[2]], 0),
                               ("culled or not", [some[1], turned], 1),
                               ("culled or not, turned", [turned, some[1]], 1),
                               ("the first is out of range", [[None, *some[3][1:]], some[4]], 0)):
        yield lines_trial(Memory(), name, batch, f"{name}: {title}", cull)


def corner(rng, around: tuple[int, int], reach: int) -> tuple[int, ...]:
    """A vertex of a polygon near a place: x, y, s, t, shade; it may be out of range."""
    x, y = (int(c + rng.integers(-reach, reach + 1)) for c in around)
    s, t = (int(rng.integers(-size, size + 1)) for size in rng.choice((ONE, 300 * ONE, 500 * ONE, 520 * ONE), 2,
                                                                     p=(0.3, 0.4, 0.25, 0.05)))
    shade = int(rng.choice((int(rng.integers(256 * ONE)), int(rng.integers(64)) << 18, 3 * ONE, 253 * ONE)))
    return x, y, s, t, shade


def polygon(rng, made: Made) -> list[tuple[int, ...]]:
    """Three or four vertices, seldom another number; some are level or alike in a value."""
    around = tuple(int(rng.integers(-side << 11, side * 3 << 11)) for side in (made.right, made.bottom))
    reach = int(rng.choice((2 * ONE, 30 * ONE, 300 * ONE), p=(0.5, 0.4, 0.1)))
    if rng.integers(4):  # mostly inside
        around = tuple(min(max(c, reach), max(reach, (side << 12) - reach))
                       for c, side in zip(around, (made.right, made.bottom)))
    vertices = [list(corner(rng, around, reach)) for _ in range(int(rng.choice((3, 4, 5), p=(0.55, 0.43, 0.02))))]
    if rng.integers(4) == 0:  # a level edge, its ends perhaps alike
        a, b = (int(n) for n in rng.choice(len(vertices), 2, replace=False))
        for key in (1, *((int(rng.integers(2, 4)),) if rng.integers(2) else ())):
            vertices[a][key] = vertices[b][key]
    if rng.integers(4) == 0:
        for v in vertices[int(rng.integers(0, 2)):]:
            v[4] = vertices[-1][4] ^ int(rng.integers(0, 2)) * 1234
    return [tuple(v) for v in vertices]


def fans_trials(mapper: str) -> Iterator[Trial]:
    """Single polygons, runs up to one that is not taken, vertices in and out of range, none."""
    rng = np.random.default_rng(len(mapper))
    sizes = ((320 * 16, 256 * 16), (320 * 16, 1024 * 16), (64 * 16, 40 * 16))
    for number in range(150):
        right, bottom = sizes[number % 3]
        made = Made(mapper, right, bottom, int(rng.choice((0, 0, ONE // 2, 12345, 2 * ONE))))
        polygons = [polygon(rng, made) for _ in range(1 if number < 100 else 8)]
        title = f"{mapper}, number {number}: {made}, {polygons if number < 100 else ''}"
        yield fans_trial(Memory(), made, polygons, title, int(number % 10 == 9),
                         int(number % 3 == 0))
        if number % 4 == 0:
            yield vertices_trial(Memory(), made, sum(polygons, []), title)
    yield fans_trial(Memory(), Made(mapper), [], f"{mapper}: no polygon")
    yield vertices_trial(Memory(), Made(mapper), [], f"{mapper}: no vertex")
    high = [(0, 0, 0, 0, 20 * ONE), (40 * ONE, 256 * ONE, ONE, 9 * ONE, 90 * ONE), (9 * ONE, 30 * ONE, 0, 5, 150 * ONE)]
    low = [high[0], (high[1][0], 256 * ONE - ONE // 16, *high[1][2:]), high[2]]
    yield fans_trial(Memory(), Made(mapper), [low, high, low], f"{mapper}: the second is too high")
