"""Random polygons and rectangles of texture engines: every frame of the guest is the model's, bit
for bit.

N64_SEED and N64_COUNT choose others; N64_CASE draws one of them alone.
"""

from dataclasses import astuple

import numpy as np
import pytest

from tests.helpers.engine_polygons import MACHINE, Polygons
from tmap.corpus import random_n64
from tmap.corpus.random_n64 import HEIGHT, MOST, PIXELS, WIDTH, Case, case, scene
from tmap.guest import guest_frames
from tmap.guest.emulator import SECOND
from tmap.model import model
from tmap.n64.combiner import samples
from tmap.scene_file.scene_file import ONE
from tmap.scene_file.units import PRIMITIVES, RECTANGLES, state_at

POLYGONS = Polygons("N64", 100, random_n64)
SEED = POLYGONS.seed


def test_the_polygons_differ() -> None:
    """The generator covers formats, modes, samples and edges beyond the frame."""
    cases = POLYGONS.first("rgba5551")
    made = scene(cases, SEED, "rgba5551")
    formats = {(t.format, t.size) for each in cases for t in each.tiles}
    assert len(formats) == 10
    for key, count in (("cycles", 3), ("detail", 3), ("lod", 2), ("filter", 3), ("convert", 3),
                       ("perspective", 2), ("tlut", 2)):
        assert len({each.modes[key] for each in cases}) == count, key
    read = [frozenset(samples(state_at(made, n, 0))) for n in range(len(cases))]
    assert set(read) >= {frozenset({0}), frozenset({0, 1}), frozenset()}
    assert len({astuple(t.s) for each in cases for t in each.tiles}) > 100
    check_rectangles(cases)
    drawn = [len(np.unique(model.render(made, n))) for n in range(len(cases))]
    assert sum(n > 2 for n in drawn) > 0.8 * len(cases)
    assert sum(n > 9 for n in drawn) > len(cases) / 3


def check_rectangles(cases: list[Case]) -> None:
    """Rectangles of each kind, cut by every side of the frame, including copies of whole lines."""
    found = [each for each in cases if each.primitive in RECTANGLES]
    assert {each.primitive for each in cases} == set(PRIMITIVES)
    edges = np.array([[c >> 16 for v in each.vertices for c in v[:2]] for each in found])
    assert ((edges[:, :2] < 0).sum(0) > 1).all()
    assert ((edges[:, 2:] > (WIDTH, HEIGHT)).sum(0) > 1).all()
    steps = [each.vertices[1][2:4] for each in found]
    assert any(min(step) < 0 for step in steps)
    assert any(dsdx == 1024 for dsdx, _ in steps) and any(dsdx & 1023 for dsdx, _ in steps)
    copies = [each for each in found if each.modes["cycles"] == "copy"]
    assert {each.vertices[1][2] == 4096 for each in copies} == {False, True}
    assert any(each.vertices[0][0] <= 0 and each.vertices[1][0] >= WIDTH * ONE for each in copies)
    assert {each.modes["tlut"] for each in copies} == {False, True}


@pytest.mark.parametrize("pixels", PIXELS)
def test_frames_are_the_models(pixels: str) -> None:
    """Each polygon has a separate frame, drawn with the rules of lowering."""
    rules, spans = POLYGONS.check(pixels)
    if not POLYGONS.asked("CASE"):
        assert rules >= {"n64_flat", "n64_plain", "n64_passes", "equal_shades", "constant_w"}, rules
        assert {"n64_pixels", "n64_passes"} < spans, spans
        assert pixels != "rgba5551" or "affine_16_copy" in spans, spans


@pytest.mark.parametrize("pixels", PIXELS)
def test_frames_are_the_models_without_rules(pixels: str) -> None:
    """Fewer polygons, and other ones."""
    _, spans = POLYGONS.check(pixels, "all")
    if not POLYGONS.asked("CASE"):
        assert "n64_pixels" in spans and "n64_passes" not in spans, spans


@pytest.mark.parametrize("pixels", PIXELS)
def test_the_second_processor_draws_the_same(pixels: str) -> None:
    """It refuses what takes more stack than a shell gives, which an Amiga would not tell."""
    cases = [case(SEED, number, pixels) for number in POLYGONS.numbers(None)]
    made = scene(cases[:MOST], SEED, pixels)
    digests, = guest_frames.draw([(made, "addx")], SECOND, timed=False)
    guest_frames.require_models([model.render(made, number) for number in range(made.frames)], digests,
                                "polygons", (made, "addx", SECOND))


def test_a_texel_that_nothing_needs_is_not_sampled() -> None:
    """Two cycles, the second without texel 1, whose tile has never been prepared. Found by ``scripts/tmap fuzz --family n64
    --seed 21``: a crash of the guest."""
    each = case(21, 4312, "rgba8888")
    made = scene([each], 21, "rgba8888")
    assert 1 not in samples(state_at(made, 0, 0)) and each.modes["cycles"] == "two"
    for machine in (MACHINE, SECOND):
        found = guest_frames.frame_of(made, "addx", machine)
        expected = model.render(made, 0)
        assert (found == expected).all(), guest_frames.first_wrong(expected, found)
