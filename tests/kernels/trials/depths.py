"""Trials of src68k/depths: lines inside the bounds, cut by them, beside them and empty; steep planes, whose q wraps."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.bench.depths import Slope, depth_trial
from tmap.bench.trial import Trial

WIDTH = 48


def ends(rng) -> tuple[int, int]:
    """A line: every fourth one has no pixels."""
    first, last = np.sort(rng.integers(0, WIDTH, 2)).tolist()
    return (first, last) if rng.integers(4) else (int(rng.integers(0, WIDTH + 1)), -1)


def trials() -> list[Trial]:
    rng, made = np.random.default_rng(83), []
    for k in range(72):
        height = int(rng.integers(1, 12))
        lines, bounds = ([ends(rng) for _ in range(height)] for _ in range(2))
        steep = int(rng.choice((10, 40, 52, 62)))
        slope = Slope(min(line[0] for line in lines), int(rng.integers(-1 << 60, 1 << 61)),
                      *(int(rng.integers(-1 << steep, 1 << steep)) for _ in range(2)))
        z = rng.integers(-1 << 31, 1 << 31, (height, WIDTH))
        for y, line in enumerate(lines):  # as near as possible to q, above and below
            for x, q in enumerate(slope.line(line[0], line[1] - line[0] + 1, y), line[0]):
                if rng.integers(2):
                    z[y, x] = min(max(q + int(rng.integers(-1, 2)), -1 << 31), (1 << 31) - 1)
        kernel = ("depth_fill", "depth_copy", "depth_copy_keyed")[k % 3]
        made.append(depth_trial(kernel, lines, bounds, slope, z, Memory(), f"{height} lines, number {k}"))
    return made
