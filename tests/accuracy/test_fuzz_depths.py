"""Random polygons with depth, with every perspective setting."""

import random
from collections import Counter
from dataclasses import replace
from fractions import Fraction

import pytest

from tests.helpers.surfaces import off_surface
from tmap.fuzz import depths as fuzz_depths, families, polygons, shrink
from tmap.ideal import perspective
from tmap.model import model
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import ONE, SETTINGS
from tmap.scene_file.textures import IN_DEPTH

SEED = 2026

W_MIN, W_MAX = fuzz_depths.limits()


@pytest.fixture(scope="module")
def some() -> list[polygons.Fuzzed]:
    """Polygons with and without depth."""
    return [polygons.even(SEED, k) for k in range(8000)]


def is_deep(each: polygons.Fuzzed) -> bool:
    """Returns whether the polygon is drawn in perspective."""
    return each.settings.perspective != "none"


def test_a_share_has_depth(some) -> None:
    """About 9 % of all have depth, evenly over the perspectives, with the settings that perspective
    needs."""
    found = Counter(p.settings.perspective for p in some)
    assert set(found) == set(SETTINGS["perspective"])
    assert all(0.01 * len(some) < found[name] < 0.03 * len(some) for name in found if name != "none")
    for each in filter(is_deep, some):
        s = each.settings
        assert s.mapper in IN_DEPTH and (s.gradients, s.start) == ("plane", "subtexel")
    assert {p.settings.mapper for p in some if is_deep(p)} == set(IN_DEPTH)
    assert {(p.settings.edges, p.settings.clip) for p in some if is_deep(p)} == {
        (e, c) for e in SETTINGS["edges"] for c in SETTINGS["clip"]}
    assert all(W_MIN <= v[5] <= W_MAX for p in some for v in p.vertices)
    scene = polygons.scene(SEED, 0, some[:200])
    scene_file.write(scene)


def test_polygons_are_the_same_in_every_run(some) -> None:
    """A polygon depends only on seed and number, not on those generated before."""
    assert [polygons.even(SEED, k) for k in range(900, 800, -1)] == some[900:800:-1]


def test_a_family_has_depth_alone() -> None:
    """All differ in depth and have a perspective; number k of a seed is the same in every run."""
    numbers = [*range(300), *range(1000, 1300)]
    some = [polygons.polygon(SEED, k, "perspective") for k in numbers]
    assert all(is_deep(each) and len({v[5] for v in each.vertices}) > 1 for each in some)
    assert {each.settings.perspective for each in some} == {*SETTINGS["perspective"]} - {"none"}
    assert {each.settings.mapper for each in some} == set(IN_DEPTH)
    polygons.polygon.cache_clear()
    assert [polygons.polygon(SEED, k, "perspective") for k in reversed(numbers)] == some[::-1]
    scene_file.write(polygons.scene(SEED, 0, some[:300]))
    assert families.again(SEED, 7, "perspective", "a1200") == (
        f"scripts/tmap fuzz --family perspective --seed {SEED} --first 7 --count 1 --machine a1200")


def test_all_kinds_of_depth_are_there(some) -> None:
    """Constant depths, nearly constant ones, and ratios up to 4, 100 and millions."""
    ratios = [perspective.depth_ratio([(*v[:4], v[5]) for v in p.vertices])
              for p in some if is_deep(p)]
    for low, high in ((1, 1), (1 + Fraction(1, 10**7), Fraction(101, 100)), (Fraction(6, 5), 4), (4, 101),
                      (1000, 10**5), (10**6, 1 << 22)):
        assert sum(low <= r <= high for r in ratios) > len(ratios) / 50, (low, high)
    depths = {v[5] for p in some if is_deep(p) for v in p.vertices}
    assert min(depths) == W_MIN and max(depths) == W_MAX


def test_more_than_three_vertices_are_flat_in_space(some) -> None:
    """The polygons are flat up to rounding: s and t were rounded once on the screen and once more
    here."""
    several = 0
    for each in some:
        if not is_deep(each) or len(each.vertices) == 3:
            continue
        vertices = [(*v[:4], v[5]) for v in each.vertices]
        if perspective.curves(vertices)[0].inverse.d:
            several += 1
            for what, off, allowed in off_surface(vertices, Fraction(1)):
                assert off <= allowed, f"{each}: {what} is {float(off)} off, not {float(allowed)}"
    assert several > 80


def test_most_have_an_ideal(some) -> None:
    """Most are in front of the viewer: only the rounding of w puts a vertex behind."""
    defined = [perspective.in_front(model.adapt(p.vertices, replace(p.settings, edges="exact"), 256))
               for p in some if is_deep(p)]
    assert sum(defined) > 0.9 * len(defined)


@pytest.mark.parametrize("kind", fuzz_depths.KINDS)
def test_depths_of_a_kind(kind: str) -> None:
    """Depths are in the format's range after rounding, and their ratio is in the kind's range."""
    rng = random.Random(kind)
    for _ in range(200):
        points = [(rng.randint(-1 << 30, 1 << 30) >> rng.randrange(12), rng.randint(-1 << 22, 1 << 22))
                  for _ in range(rng.randint(3, 8))]
        found = fuzz_depths.depths(rng, kind, points, (64, 48))
        assert all(W_MIN <= round(w) <= W_MAX for w in found)
        ratio = max(found) / min(found)
        if kind in fuzz_depths.SPREAD:
            low, high = fuzz_depths.SPREAD[kind]
            assert Fraction(10**low) * Fraction(9999, 10000) <= ratio - 1 <= Fraction(10**high) * Fraction(
                10001, 10000)
        elif kind == "constant":
            assert ratio == 1


def test_shrinking_leaves_depth_only_where_it_matters() -> None:
    """w becomes 1 and the perspective the simplest that still fails; w stays in range."""
    start = next(p for p in (polygons.even(SEED, k) for k in range(2000))
                 if p.settings.perspective == "fine" and max(v[5] for v in p.vertices) > 100 * ONE)

    def deep(some):
        return {k: "deep" for k, p in enumerate(some)
                if p.settings.perspective in ("pixel", "fine") and max(v[5] for v in p.vertices) > 50 * ONE}

    found, _ = shrink.shrink(start, "deep", deep)
    depths = sorted(v[5] for v in found.vertices)
    assert found.settings.perspective == "pixel" and depths[:2] == [ONE, ONE]
    assert 50 * ONE < depths[2] < 101 * ONE

    def shallow(some):
        return {k: "shallow" for k, p in enumerate(some) if min(v[5] for v in p.vertices) < ONE // 2}

    found, _ = shrink.shrink(replace(start, vertices=tuple(
        (*v[:5], W_MIN) for v in start.vertices)), "shallow", shallow)
    assert found.settings.perspective == "none"
    assert sorted(v[5] for v in found.vertices)[1:] == [ONE] * (len(found.vertices) - 1)
    for each in shrink.candidates(start):
        assert all(W_MIN <= v[5] <= W_MAX for v in each.vertices)
