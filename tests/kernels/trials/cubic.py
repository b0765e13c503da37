"""Trials of perspective by cubics: tables of lines with any constants."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.far import COUNTS, PITCH
from tests.kernels.trials.span import picture_ground
from tmap.bench import cubic as bench
from tmap.bench.trial import Trial
from tmap.setup import cubic as model

ACROSS = max(COUNTS) + 4
LINES = [(k % 4, count) for k, count in enumerate(COUNTS)]
MARGIN = 4000 * len(LINES)  # q grows by up to 4000 a line


def span_trial(setting: str, leftwards: bool, bits: int, rng) -> Trial:
    """Any constants; q is 2^bits at least, 1.31."""
    least = (1 << bits) + MARGIN
    step = int(2.0 ** rng.uniform(2, np.log2(((1 << 31) - MARGIN - least) // ACROSS)))
    low = int(least * (((1 << 31) - MARGIN - ACROSS * step) / least) ** rng.uniform(0, 1))
    c, dc = ([int(rng.integers(-1 << n, 1 << n)) for n in rng.integers(*reach, 2)] for reach in ((9, 31), (20, 54)))
    q, dqdx = (low + ACROSS * step, -step) if leftwards else (low, step)
    made = bench.constants(int(rng.integers(1, model.REACH + 1)), setting, q, dqdx, int(rng.integers(-4000, 4000)),
                           bits, k=tuple(rng.integers(0, 1 << 32, 2).tolist()), c=tuple(c), dc=tuple(dc))
    return bench.span_trial(Memory(int(rng.integers(1 << 30))), picture_ground(), made, LINES, PITCH, f"{made}")


def trials() -> list[Trial]:
    rng = np.random.default_rng(25)
    return [span_trial(setting, leftwards, bits, rng) for setting in model.WAYS for leftwards in (False, True)
            for bits in range(22, 31) for _ in range(4)]
