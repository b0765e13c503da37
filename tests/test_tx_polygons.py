"""Random polygons and rectangles of texture engines: every frame of the guest is the model's, bit
for bit.

TX_SEED and TX_COUNT choose others; TX_CASE draws one of them alone.
"""

import os
from dataclasses import astuple

import numpy as np
import pytest
from tx_random import HEIGHT, WIDTH, Case, case, scene

from tools import model, run
from tools.scene_file import ONE
from tools.tx.combiner import samples
from tools.scene_units import PRIMITIVES, RECTANGLES, state_at

SEED = int(os.environ.get("TX_SEED", "1"))
COUNT = int(os.environ.get("TX_COUNT", "100"))
BOOT = 100  # polygons: the tiles that engines keep decoded fill memory
PIXELS = ("rgba5551", "rgba8888")


def explain(seed: int, number: int, pixels: str, each: Case, expected: np.ndarray,
            found: np.ndarray) -> str:
    """All that is needed to look for the cause."""
    wrong = np.argwhere(found != expected)
    y, x = wrong[0]
    digits = 2 + 2 * expected.itemsize
    lines = [f"seed {seed}, polygon {number}, {pixels}: {len(wrong)} pixels of {WIDTH}x{HEIGHT}; "
             f"pixel ({x}, {y}) is {found[y, x]:#0{digits}x}, not {expected[y, x]:#0{digits}x}",
             f"  modes {each.modes}, edges {each.edges}, clip {each.clip}"]
    lines += [f"  tile {n}: {tile}" for n, tile in enumerate(each.tiles)]
    lines.append(f"  {each.primitive}"
                 + ", s and t in s10.5, then s5.10 a step" * (each.primitive in RECTANGLES))
    names = ("x", "y", "s", "t", "shade", "w")
    raw = "st" if each.primitive in RECTANGLES else ("shade",) * (each.primitive == "coloured")
    lines += ["  " + ", ".join(f"{name} {value}" if name in raw else f"{name} {value / ONE:.6f}"
                               for name, value in zip(names, vertex)) for vertex in each.vertices]
    return "\n".join([*lines, f"  again: TX_SEED={seed} TX_CASE={number} .deps/venv/bin/python -m "
                              f"pytest tests/test_tx_polygons.py -k {pixels}"])


def test_the_polygons_differ() -> None:
    """The generator reaches what it should: formats, modes, samples, edges beyond the frame."""
    cases = [case(SEED, n, "rgba5551") for n in range(max(COUNT, 100))]
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
    """Rectangles of each kind, cut by every side of the frame, copies of whole lines among them."""
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
@pytest.mark.parametrize("off", [None, "all"])
def test_frames_are_the_models(pixels: str, off: str | None) -> None:
    """Each polygon in a frame of its own, many in a boot: with the rules of lowering, without."""
    alone = os.environ.get("TX_CASE")
    first = 0 if off is None else COUNT  # other polygons
    many = COUNT if off is None else COUNT // 4
    numbers = [int(alone)] if alone else list(range(first, first + many))
    wrong, rules, spans = [], set(), set()
    for k in range(0, len(numbers), BOOT):
        cases = [case(SEED, number, pixels) for number in numbers[k:k + BOOT]]
        made = scene(cases, SEED, pixels)
        done = run.render(made, "a1200-fast", "addx", off)
        rules |= {rule for material in done.executed for rule in material["rules"]}
        spans |= set(run.total(done.figures)["spans"])
        for frame, (number, each, found) in enumerate(zip(numbers[k:], cases, done.frames)):
            expected = model.render(made, frame)
            if not np.array_equal(found, expected):
                wrong.append(explain(SEED, number, pixels, each, expected, found))
    assert not wrong, f"{len(wrong)} of {len(numbers)} polygons are wrong; the first:\n{wrong[0]}"
    if off is None and not alone:
        assert rules >= {"tx_flat", "tx_plain", "tx_passes", "equal_shades", "constant_w"}, rules
        assert {"tx_pixels", "tx_passes"} < spans, spans
        assert pixels != "rgba5551" or "affine_16_copy" in spans, spans
