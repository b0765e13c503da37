"""Trials of perspective from the far ends of lines: tables of lines with any planes that stay inside the table."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.reciprocal import COUNTS, PITCH
from tests.kernels.trials.span import picture_ground
from tmap.bench import far as bench
from tmap.bench.trial import Trial
from tmap.setup import far as model

NEAREST = 1 << 31  # q, 16 bits below the index


def span_trial(piece: int, leftwards: bool, coarse: int, rng) -> Trial:
    """q grows by any step a pixel that the longest line has room for, and a little from line to line."""
    lines = [(k % 4, count) for k, count in enumerate(COUNTS)]
    longest = max(COUNTS) + 4
    step = int(rng.integers(1, (NEAREST - (model.LOWEST + 64 << 16)) // longest // 2))
    step = min(step, int(2.0 ** rng.uniform(1, 26)))
    down = int(rng.integers(-1000, 1000))
    room = NEAREST - (model.LOWEST + 2 << 16) - longest * step - 1000 * len(lines)
    low = (model.LOWEST + 1 << 16) + 1000 * len(lines) + int(rng.integers(0, room))
    q = low + longest * step if leftwards else low
    c = [int(rng.integers(-1 << bits, 1 << bits)) for bits in rng.integers(17, 31, 2)]
    dc = [int(rng.integers(-1 << bits, 1 << bits)) for bits in rng.integers(2, 23, 2)]
    made = model.Constants(tuple(int(n) for n in rng.integers(0, 1 << 32, 2)), tuple(c), tuple(dc), q,
                           -step if leftwards else step, down, 0, 0, piece, coarse, [0, 0])
    return bench.span_trial(Memory(int(rng.integers(1 << 30))), picture_ground(), made, lines, PITCH,
                            f"{made}")


def trials() -> list[Trial]:
    rng = np.random.default_rng(24)
    return [span_trial(piece, leftwards, coarse, rng) for piece in (3, 4) for leftwards in (False, True)
            for coarse in (0, model.COARSE) for _ in range(8)]
