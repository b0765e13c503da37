"""Prefiltered tiles of Glide's texture units: frames are the model's, bit for bit, before tiles
pay, while they are made and afterwards, with memory for many and for a few.

GLIDE_SEED and GLIDE_COUNT choose others; GLIDE_CASE draws one of them alone.
"""

import os

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked, Drawn
from tests.glide.random_tiles import FRAMES, HEIGHT, KINDS, WIDTH, scene
from tmap.base.pixel_formats import FORMATS
from tmap.guest import guest_frames
from tmap.model import model
from tmap.run import run

MACHINE = "a1200-fast"
SEED = int(os.environ.get("GLIDE_SEED", "1"))
COUNT = int(os.environ.get("GLIDE_COUNT", "14"))
ALONE = os.environ.get("GLIDE_CASE")
PIXELS = ("rgb565", "rgba8888")
TILES = (8, 2, 1, 0)  # tiles that fit in memory
PAID = PIXELS[0], TILES[0]


def numbers(first: int = 0) -> list[int]:
    """The numbers of the cases from ``first`` on, or the one of GLIDE_CASE."""
    return [int(ALONE)] if ALONE else list(range(first, first + COUNT))


def room(pixels: str, tiles: int) -> int:
    return tiles * FORMATS[pixels].bytes << 16


def about(number: int, frame: int, pixels: str, tiles: int) -> str:
    """Describes a case and a frame, for messages."""
    return (f"seed {SEED}, case {number} ({KINDS[number % len(KINDS)]}), frame {frame % FRAMES}, "
            f"{pixels}, {tiles} tiles")


def again(number: int, pixels: str) -> str:
    """The command that draws one case alone."""
    return (f"; again, pixel by pixel: GLIDE_SEED={SEED} GLIDE_CASE={number} .deps/venv/bin/python -m "
            f"pytest tests/glide/test_tiles.py -k counted")


@pytest.fixture(scope="module")
def drawn() -> dict[tuple, tuple[Asked, Drawn]]:
    """By pixel format and the number of tiles that fit in memory: different cases each; the PAID
    ones also without the rule: these two are timed."""
    asked = {(pixels, tiles): Asked(scene(SEED, numbers(k * COUNT), pixels, room(pixels, tiles)),
                                    counted=(pixels, tiles) == PAID)
             for pixels in PIXELS for k, tiles in enumerate(TILES)}
    timed = {PAID: asked.pop(PAID)}
    timed["directly"] = Asked(timed[PAID].scene, "glide_tiles", counted=False)
    return {key: pair for some, way in ((timed, True), (asked, False))
            for key, pair in zip(some, zip(some.values(), guest_runs.draw([*some.values()], MACHINE, timed=way)))}


@pytest.mark.parametrize("pixels", PIXELS)
def test_frames_are_the_models(pixels: str, drawn) -> None:
    """Different cases for each number of tiles."""
    wrong = []
    for k, tiles in enumerate(TILES):
        (each, found), some = drawn[pixels, tiles], numbers(k * COUNT)
        wrong += [(some[frame // FRAMES], frame, tiles) for frame in range(each.scene.frames)
                  if not guest_frames.is_models(model.render(each.scene, frame), found.digests[frame])]
    assert not wrong, (f"{len(wrong)} frames are wrong; the first: "
                       f"{about(*wrong[0][:2], pixels, wrong[0][2])}{again(wrong[0][0], pixels)}")


def test_what_is_counted() -> None:
    """Frames drawn a second time to be counted are the model's too; some textures are drawn
    directly at first, later from tiles."""
    some, tiles, pixels = numbers(), 3, PIXELS[0]
    made = scene(SEED, some, pixels, room(pixels, tiles))
    done = run.render(made, MACHINE, "addx", timed=False)
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
    assert "glide_tiles" in rules, rules
    of_cases = [[*kinds[k:k + FRAMES]] for k in range(0, len(kinds), FRAMES)]
    assert any({"glide_passes"} == case[0] and {"glide_tiles"} == case[-1] for case in of_cases)
    assert any({"glide_passes"} == case[-1] for case in of_cases)


def test_tiles_pay(drawn) -> None:
    """The frames are the same with the rule and without it; each texture whose tiles are made is
    drawn from them at lower cost."""
    (each, on), (_, off) = drawn[PAID], drawn["directly"]
    assert (on.digests["sum"] == off.digests["sum"]).all()
    assert (on.digests["hash"] == off.digests["hash"]).all()
    paid = 0
    for k in range(0, each.scene.frames, FRAMES):
        last = k + FRAMES - 1
        if all(set(on.figures[f]["spans"]) == {"glide_tiles"} for f in (last - 1, last)):
            ticks = [int(found.digests["ticks"][last]) for found in (on, off)]
            assert ticks[0] < ticks[1], f"case {k // FRAMES}: {ticks[0]} ticks, {ticks[1]} directly"
            paid += 1
    assert paid, "no texture was drawn from tiles"
