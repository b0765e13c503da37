"""Random polygons of Glide's texture units: every frame of the guest is the model's, bit for bit.

TMU_SEED and TMU_COUNT choose others; TMU_CASE draws one of them alone.
"""

import numpy as np
import pytest
from engine_polygons import Polygons, vertex_lines
from tmu_random import Case, case, scene

from tools import model
from tools.scene_file import read, write
from tools.tmu.words import ASPECTS, FORMATS, MIPMAPS

BITS = {"rgb565": 16, "rgba8888": 32}  # of a pixel
PIXELS = tuple(BITS)


def lines(each: Case) -> list[str]:
    """All there is to know of a polygon."""
    return [f"  edges {each.edges}, clip {each.clip}, coordinates of its own {each.own}",
            *(f"  unit {n}: {modes}" for n, modes in enumerate(each.modes)),
            *vertex_lines(each.vertices)]


POLYGONS = Polygons("TMU", 40, lambda seed, number, _: case(seed, number), scene, lines)
SEED = POLYGONS.seed


def test_the_polygons_differ() -> None:
    """The generator reaches what it should, and a scene of them is read as it was written."""
    cases = [case(SEED, n) for n in range(max(len(POLYGONS.numbers(None)), 100))]
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
    rules, spans = POLYGONS.draw(pixels, off)
    if off is None and not POLYGONS.asked("CASE"):
        assert rules >= {"tmu_plain", "tmu_passes", "constant_w"}, rules
        assert spans & {f"dithered_{BITS[pixels]}{end}" for end in ("", "_wrap")}, spans
        assert {"tmu_passes", "tmu_pixels"} < spans, spans
