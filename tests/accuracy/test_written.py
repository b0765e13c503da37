"""Polygons as people write them: the properties of the fuzzers' share of such polygons, which noise
lacks."""

import random
from collections import Counter
from fractions import Fraction

import pytest

from tmap.base.fixed import ONE
from tmap.corpus import random_polygons, written
from tmap.fuzz import depths, polygons
from tmap.model import model
from tmap.scene_file.textures import MAPPERS

SIZES = ((64, 48), (1024, 6), (8, 1024), (4, 1))
COUNT = 600


def drawn(seed: str, size: tuple[int, int]):
    """A random source and an outline for a frame."""
    rng = random.Random(seed)
    return rng, written.outline(rng, *size)


def on_plane(values) -> bool:
    """Returns whether a fourth corner's value is on the plane of the other three, to half a unit of
    each: a parallelogram's corner is the sum of its neighbours minus the opposite one."""
    a, b, c, d = values
    return abs(a - b + c - d) <= 2


@pytest.mark.parametrize("size", SIZES)
def test_outlines(size: tuple[int, int]) -> None:
    """Convex, with area, on whole and half pixels, mostly in the frame; most have equal
    coordinates."""
    shared = covered = 0
    for k in range(COUNT):
        _, points = drawn(f"{size} {k}", size)
        assert len(set(points)) == len(points) in (3, 4) and random_polygons.is_convex(points)
        assert all(c % (ONE // 2) == 0 for p in points for c in p)
        assert all(-model.FAR <= c < model.FAR for p in points for c in p)
        shared += any(len(set(axis)) < len(points) for axis in zip(*points))
        covered += model.set_up([(*p, 0, 0) for p in points], *size, True) is not None
    assert shared > 0.6 * COUNT and covered > 0.6 * COUNT


def test_rectangles_and_right_angles() -> None:
    """More than a third are aligned with the axes, on whole pixels; some are the whole frame."""
    found = Counter()
    for k in range(COUNT):
        _, points = drawn(f"angles {k}", SIZES[0])
        xs, ys = (set(axis) for axis in zip(*points))
        is_whole = not any(c % ONE for p in points for c in p)
        found["frame"] += len(points) == 4 and xs == {0, 64 * ONE} and ys == {0, 48 * ONE}
        found[len(points)] += len(xs) == len(ys) == 2 and is_whole
    assert found[4] > COUNT / 5 and found[3] > COUNT / 10 and found["frame"] > 2, found


@pytest.mark.parametrize("ends", [(256, 256), (256, 64), (Fraction(256, 3), 256)])
def test_texels(ends) -> None:
    """On one plane; most are exactly at the map's ends; none is outside a map that does not
    repeat."""
    at_ends, equal = 0, 0
    for k in range(COUNT):
        rng, points = drawn(f"{ends} {k}", SIZES[0])
        for repeats in (True, False):
            made = written.texels(rng, points, ends, repeats)
            if len(points) == 4:
                assert all(on_plane(axis) for axis in zip(*made)), (points, made)
            if not repeats:
                assert all(0 <= c <= end * ONE for pair in made for c, end in zip(pair, ends))
        at_ends += any(c in (0, int(end * ONE)) for pair in made for c, end in zip(pair, ends))
        equal += any(len(set(axis)) == 1 for axis in zip(*made))
    assert at_ends > 0.7 * COUNT and equal > COUNT / 20


def test_depths() -> None:
    """In range; 1/w of four corners on one plane before rounding; some equal, some at both ends of
    the range."""
    least, most = depths.limits()
    seen = Counter()
    for k in range(COUNT):
        rng, points = drawn(f"depths {k}", SIZES[0])
        found = written.depths(rng, points)
        assert all(least <= w * ONE <= most for w in found)
        if len(points) == 4:
            a, b, c, d = (1 / w for w in found)
            assert a - b + c - d == 0
        seen["equal"] += len(set(found)) == 1
        seen.update({w * ONE for w in found})
    assert seen["equal"] > COUNT / 20 and seen[least] and seen[most] and seen[ONE]


def test_fuzzers_have_their_share() -> None:
    """Polygons of each mapper and each perspective, with vertices at the map's first and last
    texel."""
    every, at_ends = Counter(), Counter()
    for k in range(4000):
        each = polygons.polygon(3, k)
        if random.Random(f"3 written {k}").random() < written.SHARE:
            kind = each.settings.mapper, each.settings.perspective
            every[kind] += 1
            at_ends[kind] += any(c in (0, 256 * ONE) for v in each.vertices for c in v[2:4])
    mappers = {kind[0] for kind in every}
    assert mappers == set(MAPPERS[1])
    assert {kind[1] for kind in every} == {"none", "every16", "every8", "pixel", "fine"}
    assert abs(sum(every.values()) / 4000 - written.SHARE) < 0.03  # four standard deviations
    assert all(at_ends[kind] > every[kind] / 2 for kind in every if every[kind] > 30), at_ends
