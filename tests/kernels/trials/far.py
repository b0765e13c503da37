"""Trials of perspective from the far ends of lines: tables of lines with any planes that stay inside the table."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.reciprocal import COUNTS, PITCH
from tests.kernels.trials.span import picture_ground
from tmap.bench import far as bench
from tmap.bench.trial import Trial
from tmap.setup import far as model


def span_trial(longest: int, leftwards: bool, coarse: int, rng) -> Trial:
    """q grows by any step a pixel from as far as it may be, and a little from line to line."""
    lines = [(k % 4, count) for k, count in enumerate(COUNTS)]
    across = max(COUNTS) + 4
    step = int(2.0 ** rng.uniform(0, 29.5)) // across
    least = max(1 << 29 - model.DEEP, min(4 * step, 1 << 28)) + 4000 * len(lines)
    down = int(rng.integers(-4000, 4000))
    most = (1 << 31) - 1 - across * step - 4000 * len(lines)
    low = int(least * 2.0 ** rng.uniform(0, np.log2(most / least)))
    q = low + across * step if leftwards else low
    c = [int(rng.integers(-1 << bits, 1 << bits)) for bits in rng.integers(9, 31, 2)]
    dc = [int(rng.integers(-1 << bits, 1 << bits)) for bits in rng.integers(2, 23, 2)]
    made = model.Constants(tuple(int(n) for n in rng.integers(0, 1 << 32, 2)), tuple(c), tuple(dc), q,
                           -step - 1 if leftwards else step + 1, down, 0, 0, longest, coarse, [0, 0])
    return bench.span_trial(Memory(int(rng.integers(1 << 30))), picture_ground(), made, lines, PITCH,
                            f"{made}")


def trials() -> list[Trial]:
    rng = np.random.default_rng(24)
    return [span_trial(longest, leftwards, coarse, rng) for longest in (8, 16) for leftwards in (False, True)
            for coarse in (0, model.COARSE) for _ in range(16)]
