"""Prefiltered tiles of Glide's texture units: frames are the model's, bit for bit, before tiles
pay, while they are made and afterwards, with memory for many and for a few.

TMU_SEED and TMU_COUNT choose others; TMU_CASE draws one of them alone.
"""

import os

import numpy as np
import pytest
from tmu_tiles_random import FRAMES, HEIGHT, KINDS, WIDTH, scene

from tools import model, run

SEED = int(os.environ.get("TMU_SEED", "1"))
COUNT = int(os.environ.get("TMU_COUNT", "28"))
BOOT = 28  # cases
TILE = {"rgb565": 1 << 17, "rgba8888": 1 << 18}  # bytes


@pytest.mark.parametrize("pixels", TILE)
@pytest.mark.parametrize("tiles", [8, 2, 1, 0])
def test_frames_are_the_models(pixels: str, tiles: int) -> None:
    """Cases of their own for each number of tiles that there is memory for."""
    alone = os.environ.get("TMU_CASE")
    numbers = [int(alone)] if alone else list(range(tiles * COUNT, (tiles + 1) * COUNT))
    wrong, spans, mixed = [], set(), 0
    for k in range(0, len(numbers), BOOT):
        some = numbers[k:k + BOOT]
        made = scene(SEED, some, pixels, tiles * TILE[pixels])
        done = run.render(made, "a1200-fast", "addx")
        kinds = [set(figures["spans"]) for figures in done.figures]
        spans |= set().union(*kinds)
        mixed += sum({"tmu_tiles", "tmu_passes"} <= set().union(*kinds[f:f + FRAMES])
                     for f in range(0, len(kinds), FRAMES))
        for frame, found in enumerate(done.frames):
            expected = model.render(made, frame)
            differs = np.argwhere(found != expected)
            if len(differs):
                (y, x), number = differs[0], some[frame // FRAMES]
                wrong.append(f"seed {SEED}, case {number} ({KINDS[number % len(KINDS)]}), frame "
                             f"{frame % FRAMES}, {pixels}, {tiles} tiles: {len(differs)} of "
                             f"{WIDTH}x{HEIGHT} pixels; ({x}, {y}) is {found[y, x]:#x}, not "
                             f"{expected[y, x]:#x}; by {' '.join(kinds[frame])}; again: "
                             f"TMU_SEED={SEED} TMU_CASE={number} .deps/venv/bin/python -m pytest "
                             f"tests/test_tmu_tiles.py -k '{tiles} and {pixels}'")
    assert not wrong, f"{len(wrong)} frames are wrong; the first:\n{wrong[0]}"
    if alone:
        return
    assert ("tmu_tiles" in spans) == (tiles > 0) and "tmu_passes" in spans, spans
    assert mixed >= COUNT // 7 or not tiles, f"{mixed} textures were drawn directly, then from tiles"
