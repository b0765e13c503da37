"""Trials of the spans from tiled and column maps, and of the columns' layout."""

from functools import cache

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.span import (FRAME, LONG, LONG_WIDE, MARGIN, SHORT, ground_of, span_trial,
                                       steps_of, texture)
from tmap.base import maps
from tmap.bench.spans import Ground, columns_of
from tmap.bench.trial import Trial, Write
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.setup.scanline import add_span_plan

#: Of column maps: many trials for the first, some for the others.
SIZES = ((256, 256), (8, 8), (64, 32), (8, 512), (512, 8), (128, 512), (512, 512), (1024, 256),
         (2048, 128), (8, 32768), (32768, 8), (8, 16384), (16384, 8))


@cache
def tiled_ground() -> Ground:
    """The page of the other spans in tiles of 8x8."""
    return ground_of(5, maps.to_tiled(texture()).tobytes(), texture())


@cache
def noise_memory(size: int) -> tuple[Memory, int, int]:
    """A frame and so many bytes of map: what maps of one size have in common."""
    memory = Memory(6)
    frame = memory.add(memory.noise.randbytes(FRAME), name="frame")
    return memory, frame, memory.add(memory.noise.randbytes(size), name="map")


def column_ground(width: int, height: int, texel: str) -> Ground:
    memory, frame_at, map_at = noise_memory(width * height * np.dtype(texel).itemsize)
    stored = np.frombuffer(memory.image, texel, width * height, map_at)
    return Ground(memory, frame_at + MARGIN, map_at, maps.from_columns(stored, width, height))


def some(steps: list[tuple[int, int]], count: int, rng) -> list[tuple[int, int]]:
    return [*steps[-3:], *(steps[k] for k in rng.choice(len(steps), count, replace=False))]


def trials_on(kernel: str, on: Ground, short, long, rng) -> list[Trial]:
    wide, (height, width) = LONG_WIDE if on.picture.itemsize == 2 else LONG, on.picture.shape
    name = f"{width}x{height}, " if "columns" in kernel else ""
    return [span_trial(kernel, *pair, 0, size, rng, upwards=k % 8 == 7, ground=on, name=name)
            for size, chosen in ((SHORT, short), (wide, long)) for k, pair in enumerate(chosen)]


def column_trials(kernel: str, texel: str, rng) -> list[Trial]:
    steps = steps_of(rng)
    trials = []
    for size in SIZES:
        on = column_ground(*size, texel)
        short, long = (steps[::2], some(steps, 12, rng)) if size == SIZES[0] else \
            (some(steps, 1, rng), some(steps, 1, rng)[2:])
        trials += trials_on(kernel, on, short, long, rng)
    return trials


def layout_trial(width: int, height: int) -> Trial:
    """column_layout_make, with its arguments in a plan and its result in count."""
    memory = Memory()
    at = memory.room("column_layout")
    plan = add_span_plan(memory, dict(columns=at), {}, count=-1, map_width=width,
                         map_height=height)
    sides = [1 << k for k in range(3, 16)]
    made = width in sides and height in sides and width * height <= 1 << 18
    writes = [Write(plan + layout.load().struct("span_plan").fields["count"]["offset"],
                    int(made).to_bytes(4, "big"))]
    if made:
        writes.append(Write(at, layout.load().struct("column_layout").pack(
            **columns_of(width, height))))
    return Trial(Case("column_layout_make", memory, pointers={"a0": plan}),
                 f"{width}x{height}", writes=writes)


def layout_trials() -> list[Trial]:
    """Powers of two around the limits, and what is none."""
    powers = [1 << k for k in range(31)]
    sizes = [(w, h) for w in powers[:18] for h in powers[:18]]
    wrong = (0, -1, -8, 7, 9, 12, 255, 257, 32767, 32769, 65536 + 8, -1 << 31, *powers[16:])
    return [layout_trial(*size) for size in
            [*sizes, *((n, 8) for n in wrong), *((8, n) for n in wrong)]]


def trials() -> list[Trial]:
    rng = np.random.default_rng([5, 0])
    steps = steps_of(rng)
    return [*trials_on("span_tiled", tiled_ground(), steps, some(steps, 29, rng), rng),
            *column_trials("span_columns", "u1", np.random.default_rng([5, 1])),
            *column_trials("span_columns_16", maps.RGB565, np.random.default_rng([5, 2])),
            *layout_trials()]
