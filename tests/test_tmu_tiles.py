"""Prefiltered tiles of Glide's texture units: frames are the model's, bit for bit, before tiles
pay, while they are made and afterwards, with memory for many and for a few.

TMU_SEED and TMU_COUNT choose others; TMU_CASE draws one of them alone.
"""

import os

import numpy as np
import pytest
from tmu_tiles_random import FRAMES, HEIGHT, KINDS, WIDTH, scene

from tools import guest_frames, model, run
from tools.pixel_formats import FORMATS

MACHINE = "a1200-fast"
SEED = int(os.environ.get("TMU_SEED", "1"))
COUNT = int(os.environ.get("TMU_COUNT", "14"))
ALONE = os.environ.get("TMU_CASE")
PIXELS = ("rgb565", "rgba8888")
TILES = (8, 2, 1, 0)  # that there is memory for


def numbers(first: int = 0) -> list[int]:
    return [int(ALONE)] if ALONE else list(range(first, first + COUNT))


def room(pixels: str, tiles: int) -> int:
    """Bytes of tiles."""
    return tiles * FORMATS[pixels].bytes << 16


def about(number: int, frame: int, pixels: str, tiles: int) -> str:
    return (f"seed {SEED}, case {number} ({KINDS[number % len(KINDS)]}), frame {frame % FRAMES}, "
            f"{pixels}, {tiles} tiles")


def again(number: int, pixels: str) -> str:
    return (f"; again, pixel by pixel: TMU_SEED={SEED} TMU_CASE={number} .deps/venv/bin/python -m "
            f"pytest tests/test_tmu_tiles.py -k 'counted and {pixels}'")


@pytest.mark.parametrize("pixels", PIXELS)
def test_frames_are_the_models(pixels: str) -> None:
    """Cases of their own for each number of tiles."""
    made = [(scene(SEED, numbers(k * COUNT), pixels, room(pixels, tiles)), tiles)
            for k, tiles in enumerate(TILES)]
    drawn = guest_frames.draw([(each, "addx") for each, _ in made], MACHINE)
    wrong = []
    for k, ((each, tiles), digests) in enumerate(zip(made, drawn)):
        some = numbers(k * COUNT)
        wrong += [(some[frame // FRAMES], frame, tiles) for frame in range(each.frames)
                  if not guest_frames.is_models(model.render(each, frame), digests[frame])]
    assert not wrong, (f"{len(wrong)} frames are wrong; the first: "
                       f"{about(*wrong[0][:2], pixels, wrong[0][2])}{again(wrong[0][0], pixels)}")


@pytest.mark.parametrize("pixels", PIXELS)
@pytest.mark.parametrize("tiles", [3])
def test_what_is_counted(pixels: str, tiles: int) -> None:
    """Frames are drawn once more to be counted, and are the model's then; some textures are drawn
    directly first, then from tiles."""
    some = numbers()
    made = scene(SEED, some, pixels, room(pixels, tiles))
    done = run.render(made, MACHINE, "addx")
    kinds = [set(figures["spans"]) for figures in done.figures]
    for frame, found in enumerate(done.frames):
        expected = model.render(made, frame)
        differs = np.argwhere(found != expected)
        number = some[frame // FRAMES]
        where = "".join(f": {len(differs)} of {WIDTH}x{HEIGHT} pixels; ({x}, {y}) is "
                        f"{found[y, x]:#x}, not {expected[y, x]:#x}; by {' '.join(kinds[frame])}"
                        for y, x in differs[:1])
        assert not where, about(number, frame, pixels, tiles) + where + again(number, pixels)
    if ALONE:
        return
    rules = {rule for material in done.executed for rule in material["rules"]}
    assert "tmu_tiles" in rules, rules
    of_cases = [[*kinds[k:k + FRAMES]] for k in range(0, len(kinds), FRAMES)]
    assert any({"tmu_passes"} == case[0] and {"tmu_tiles"} == case[-1] for case in of_cases)
    assert any({"tmu_passes"} == case[-1] for case in of_cases)


def test_tiles_pay() -> None:
    """With the rule and without it: the same frames; and each texture that is drawn from tiles, once
    they are made, for less."""
    made = scene(SEED, numbers(), "rgb565", room("rgb565", 8))
    on, off = guest_frames.draw([(made, "addx"), (made, "addx OFF tmu_tiles")], MACHINE)
    done = run.render(made, MACHINE, "addx")
    assert (on["sum"] == off["sum"]).all() and (on["hash"] == off["hash"]).all()
    paid = 0
    for k in range(0, made.frames, FRAMES):
        if all(set(done.figures[f]["spans"]) == {"tmu_tiles"} for f in range(k, k + FRAMES)[-2:]):
            ticks = [int(each["ticks"][k + FRAMES - 1]) for each in (on, off)]
            assert ticks[0] < ticks[1], (k // FRAMES, ticks)
            paid += 1
    assert paid, "no texture was drawn from tiles"
