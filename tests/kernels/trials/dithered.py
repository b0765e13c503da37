"""Trials of the dithered spans: every pixel against the texel at its moved u and v."""

import numpy as np

from tests.kernels.trials.span import (LONG_WIDE, SHORT, TURN, Ground, picture_memory,
                                       random_starts, steps_of, steps_text, table_trial, texels)
from tests.kernels.trials.wide import ground as wide_ground
from tmap.bench.trial import Trial
from tmap.guest.kernels import M32
from tmap.setup.dithered import EIGHTH, MOVES

MOST = int(MOVES.max()) * EIGHTH


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

    longest = max(count for count, *_ in starts)
    steps = np.array([[dudx], [dvdx]]) * np.arange(longest)
    moves = np.tile(MOVES.transpose(0, 2, 1) * EIGHTH + MOST, longest // 2 + 2)  # [line][u or v][x]

    def drawn(count: int, u: int, v: int, x: int, line: int) -> bytes:
        moved = moves[line + odd & 1, :, x & 1:(x & 1) + count]
        places = np.array([[u], [v]]) + steps[:, :count] + moved & M32
        return on.texels(*places, 0, 0, count).tobytes()

    return table_trial(
        kernel, "addx", starts, pitch, rng, upwards, (on.memory, on.frame_at, on.map_at), drawn,
        steps_text(dudx, dvdx) + f", first line {odd}",
        wide=on.pixel_bytes, placed=True, dudx=dudx, dvdx=dvdx, odd=odd)


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    made = []
    for wide in (1, 2, 4):
        on = Ground(*picture_memory(), texels) if wide == 1 else wide_ground(wide)
        name = "span_dithered" + (f"_{8 * wide}" if wide > 1 else "")
        for kernel in (name, f"{name}_wrap"):
            rng = np.random.default_rng([12, wide, kernel.endswith("_wrap")])
            steps = steps_of(rng)
            some = [steps[k] for k in rng.choice(len(steps), 16, replace=False)]
            made += [trial(kernel, *pair, size, rng, k % 8 == 7, on)
                     for size, chosen in ((SHORT, steps), (LONG_WIDE, some))
                     for k, pair in enumerate(chosen)]
    return made
