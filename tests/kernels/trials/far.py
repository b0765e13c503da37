"""Trials of perspective from the far ends of lines: tables of lines with any planes that stay inside the table."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.reciprocal import COUNTS, PITCH
from tests.kernels.trials.span import picture_ground
from tmap.bench import far as bench
from tmap.bench.trial import Trial
from tmap.setup import far as model, far_planes


ACROSS = max(COUNTS) + 4
LINES = [(k % 4, count) for k, count in enumerate(COUNTS)]
MARGIN = 4000 * len(LINES)  # q grows by up to 4000 a line


def any_q(leftwards: bool, rng) -> tuple[int, int, int]:
    """q at the table's corner and its growth a pixel and a line: any step, from as far as it may be."""
    step = int(2.0 ** rng.uniform(0, 30)) // ACROSS + 1
    least = 1 << 29 - model.DEEP
    while step << (31 - least.bit_length() & ~1) > model.MOST:
        least *= 2
    most = (1 << 31) - 1 - ACROSS * step - MARGIN
    low = int((least + MARGIN) * 2.0 ** rng.uniform(0, np.log2(most / (least + MARGIN))))
    down = int(rng.integers(-4000, 4000))
    return (low + ACROSS * step, -step, down) if leftwards else (low, step, down)


def even_q(leftwards: bool, pixels: int, longest: int, rng) -> tuple[int, int, int]:
    """The same for pieces of so many pixels each, between 2^28 and 2^30."""
    most = min(model.LENGTHS[longest][pixels] // 2, (3 << 28) // ACROSS - MARGIN // ACROSS * 2 - 1)
    step = int(2.0 ** rng.uniform(0, np.log2(most))) + 1
    low = int(rng.integers((1 << 28) + MARGIN, (1 << 30) - ACROSS * step - MARGIN))
    down = int(rng.integers(-4000, 4000))
    return (low + ACROSS * step, -step, down) if leftwards else (low, step, down)


def anything_of(made, rng) -> Trial:
    return bench.span_trial(Memory(int(rng.integers(1 << 30))), picture_ground(), made, LINES, PITCH, f"{made}")


def span_trial(longest: int, leftwards: bool, coarse: int, rng, even: int = 0) -> Trial:
    """Any constants. ``even``: pixels of all pieces."""
    c, dc = ([int(rng.integers(-1 << bits, 1 << bits)) for bits in rng.integers(*reach, 2)]
             for reach in ((9, 31), (2, 23)))
    return anything_of(model.Constants(
        tuple(int(n) for n in rng.integers(0, 1 << 32, 2)), tuple(c), tuple(dc),
        *(even_q(leftwards, even, longest, rng) if even else any_q(leftwards, rng)), 0, 0,
        longest, coarse, [0, 0], even), rng)


def planes_trial(longest: int, leftwards: bool, rng) -> Trial:
    """Any planes of u and v; their base is the same."""
    st = tuple(tuple(int(rng.integers(-1 << bits, 1 << bits)) for bits in (30, 22, 22)) for _ in "uv")
    return anything_of(far_planes.Constants(
        *any_q(leftwards, rng), st, tuple(int(n) for n in rng.integers(-1 << 31, 1 << 31, 2)), 0, 0, longest,
        [0, 0]), rng)


def trials() -> list[Trial]:
    rng = np.random.default_rng(24)
    ways = [(longest, leftwards) for longest in (8, 16) for leftwards in (False, True)]
    return [*(span_trial(*way, coarse, rng) for way in ways for coarse in (0, model.COARSE) for _ in range(16)),
            *(span_trial(16, leftwards, coarse, rng, even) for leftwards in (False, True)
              for coarse in (0, model.COARSE) for even in (4, 8, 16) for _ in range(8)),
            *(planes_trial(*way, rng) for way in ways for _ in range(16))]
