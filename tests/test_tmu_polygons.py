"""Random polygons of Glide's texture units: every frame of the guest is the model's, bit for bit.

TMU_SEED and TMU_COUNT choose others; TMU_CASE draws one of them alone.
"""

import os

import numpy as np
import pytest
from tmu_random import HEIGHT, WIDTH, Case, case, scene

from tools import model, run
from tools.scene_file import ONE, read, write
from tools.tmu.words import ASPECTS, FORMATS, MIPMAPS

SEED = int(os.environ.get("TMU_SEED", "1"))
COUNT = int(os.environ.get("TMU_COUNT", "40"))
BOOT = 100  # polygons
BITS = {"rgb565": 16, "rgba8888": 32}  # of a pixel
PIXELS = tuple(BITS)


def explain(seed: int, number: int, pixels: str, each: Case, expected: np.ndarray,
            found: np.ndarray) -> str:
    """All that is needed to look for the cause."""
    wrong = np.argwhere(found != expected)
    y, x = wrong[0]
    digits = 2 + 2 * expected.itemsize
    lines = [f"seed {seed}, polygon {number}, {pixels}: {len(wrong)} pixels of {WIDTH}x{HEIGHT}; "
             f"pixel ({x}, {y}) is {found[y, x]:#0{digits}x}, not {expected[y, x]:#0{digits}x}",
             f"  edges {each.edges}, clip {each.clip}, coordinates of its own {each.own}"]
    lines += [f"  unit {n}: {modes}" for n, modes in enumerate(each.modes)]
    names = ("x", "y", "s", "t", "shade", "w")
    lines += ["  " + ", ".join(f"{name} {value / ONE:.6f}" for name, value in zip(names, vertex))
              for vertex in each.vertices]
    return "\n".join([*lines, f"  again: TMU_SEED={seed} TMU_CASE={number} .deps/venv/bin/python "
                              f"-m pytest tests/test_tmu_polygons.py -k {pixels}"])


def test_the_polygons_differ() -> None:
    """The generator reaches what it should, and a scene of them is read as it was written."""
    cases = [case(SEED, n) for n in range(max(COUNT, 100))]
    units = [modes for each in cases for modes in each.modes]
    for key, names in (("format", FORMATS), ("aspect", ASPECTS), ("mode", MIPMAPS),
                       ("levels", ("even", "odd", "both")), ("bits", (4, 8)), ("blend", (0, 1)),
                       ("perspective", (False, True)), ("clamp_w", (False, True))):
        assert {modes[key] for modes in units} == set(names), key
    assert len({modes["clamp"] for modes in units}) == len({m["filters"] for m in units}) == 4
    assert {(len(each.units), each.own) for each in cases} == {(1, False), (2, False), (2, True)}
    ws = [v[5] for each in cases for v in each.vertices]
    assert min(ws) < 0 and max(ws) > 1 << 16 + 10 and min(map(abs, ws)) < 1 << 16 - 6
    made = scene(cases, SEED, "rgb565")
    data = write(made)
    assert write(read(data, "x")) == data
    drawn = [len(np.unique(model.render(made, n))) for n in range(len(cases))]
    assert sum(n > 2 for n in drawn) > 0.7 * len(cases)
    assert sum(n > 9 for n in drawn) > len(cases) / 3


@pytest.mark.parametrize("pixels", PIXELS)
@pytest.mark.parametrize("off", [None, "all"])
def test_frames_are_the_models(pixels: str, off: str | None) -> None:
    """Each polygon in a frame of its own, many in a boot: with the rules of lowering, without."""
    alone = os.environ.get("TMU_CASE")
    first = 0 if off is None else COUNT  # other polygons
    many = COUNT if off is None else COUNT // 4
    numbers = [int(alone)] if alone else list(range(first, first + many))
    wrong, rules, spans = [], set(), set()
    for k in range(0, len(numbers), BOOT):
        cases = [case(SEED, number) for number in numbers[k:k + BOOT]]
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
        assert rules >= {"tmu_plain", "tmu_passes", "constant_w"}, rules
        assert spans & {f"dithered_{BITS[pixels]}{end}" for end in ("", "_wrap")}, spans
        assert {"tmu_passes", "tmu_pixels"} < spans, spans
