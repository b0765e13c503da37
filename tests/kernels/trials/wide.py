"""Trials of the spans with texels and pixels of 16 and 32 bits."""

from functools import cache

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.span import (FRAME, LONG_WIDE, MARGIN, SHORT, alone_trials, copy_trial,
                                       fill_trials, span_trial, steps_of)
from tmap.base import maps
from tmap.bench.spans import Ground
from tmap.bench.trial import Trial


@cache
def ground(wide: int) -> Ground:
    """A page of noise in texels of so many bytes, at no larger multiple of them than it must be;
    a frame."""
    memory = Memory(7)
    frame = memory.add(memory.noise.randbytes(FRAME * wide // 2), name="frame")
    picture = np.frombuffer(memory.noise.randbytes(65536 * wide), f">u{wide}").reshape(256, 256)
    before = memory.noise.randbytes(wide)
    at = memory.add(before + maps.to_page(picture).tobytes(), 8, "map")
    return Ground(memory, frame + MARGIN, at + len(before) + 128 * 256 * wide, picture)


def span_trials(kernel: str, on: Ground, rng) -> list[Trial]:
    steps = steps_of(rng)
    some = [steps[k] for k in rng.choice(len(steps), 24, replace=False)]
    return [span_trial(kernel, *pair, 0, size, rng, k % 8 == 7, on)
            for size, chosen in ((SHORT, steps), (LONG_WIDE, some))
            for k, pair in enumerate(chosen)]


def copy_trials(kernel: str, on: Ground, rng) -> list[Trial]:
    """Lines of all lengths up to 72 pixels, and longer ones, at all alignments."""
    tables = SHORT, (tuple(range(41, 73)), 192), LONG_WIDE, \
        ((127, 128, 129, 255, 256, 258, 513), LONG_WIDE[1])
    return [copy_trial(counts, pitch, source, near, rng, source == 3, kernel, on)
            for counts, pitch in tables for near in (False, True) for source in range(4)]


def trials() -> list[Trial]:
    made = []
    for wide in (2, 4):
        on, rng, name = ground(wide), np.random.default_rng([7, wide]), f"span_affine_{8 * wide}"
        for kind in ("", "_wrap", "_scanline", "_level"):
            made += span_trials(name + kind, on, rng)
        made += alone_trials(f"{name}_row", rng, on, (SHORT, LONG_WIDE))
    return [*made, *copy_trials("span_affine_16_copy", ground(2), rng),
            *fill_trials("span_fill_32", ground(4), LONG_WIDE, rng)]
