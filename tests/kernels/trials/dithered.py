"""Trials of the dithered spans: every pixel against the texel at its moved u and v."""

from functools import partial

import numpy as np

from tests.kernels.trials.span import (LONG_WIDE, SHORT, TURN, picture_ground, random_starts,
                                       steps_of, steps_text, table_trial)
from tests.kernels.trials.wide import ground as wide_ground
from tmap.base.fixed import M32
from tmap.bench.dithered import MOST, dithered_trial
from tmap.bench.spans import Ground
from tmap.bench.trial import Trial


def within(v: int, count: int, dvdx: int, rng) -> tuple[int, int]:
    """v and count changed such that v, moved, does not wrap in the line."""
    speed = (dvdx + TURN // 2) % TURN - TURN // 2
    room = TURN - 1 - 2 * MOST
    if speed:
        count = min(count, room // abs(speed) + 1)
    travel = abs(speed) * max(count - 1, 0)
    low = MOST + (travel if speed < 0 else 0)
    return v // TURN * TURN + low + int(rng.integers(room - travel + 1)), count


def trial(kernel: str, dudx: int, dvdx: int, size, rng, upwards: bool, on: Ground) -> Trial:
    """One table: every count at all four alignments, on either parity of the first line."""
    counts, pitch = size
    odd, starts = int(rng.integers(2)), []
    for count, u, v in random_starts(counts, rng):
        if not kernel.endswith("_wrap"):
            v, count = within(v, count, dvdx, rng)
        starts.append((count, u, v - MOST & M32 if kernel.endswith("_wrap") else v - MOST))
    return table_trial(partial(dithered_trial, kernel), starts, pitch, rng, upwards,
                       steps_text(dudx, dvdx) + f", first line {odd}", ground=on, dudx=dudx,
                       dvdx=dvdx, odd=odd)


def trials() -> list[Trial]:
    made = []
    for wide in (1, 2, 4):
        on = picture_ground() if wide == 1 else wide_ground(wide)
        name = "span_dithered" + (f"_{8 * wide}" if wide > 1 else "")
        for kernel in (name, f"{name}_wrap"):
            rng = np.random.default_rng([12, wide, kernel.endswith("_wrap")])
            steps = steps_of(rng)
            some = [steps[k] for k in rng.choice(len(steps), 16, replace=False)]
            made += [trial(kernel, *pair, size, rng, k % 8 == 7, on)
                     for size, chosen in ((SHORT, steps), (LONG_WIDE, some))
                     for k, pair in enumerate(chosen)]
    return made
