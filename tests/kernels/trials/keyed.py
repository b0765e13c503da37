"""Trials of edge_opaque: every line against the texels of its pixels, one by one."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.base.fixed import ONE, signed
from tmap.bench.edges import opaque_trial
from tmap.bench.trial import Trial, values

SLOWEST = 62 * ONE  # of steps


def picture_of(rng) -> np.ndarray:
    """A map of any size: rows that are transparent, opaque, opaque from one texel to another, or have holes."""
    width, height = (1 << int(n) for n in rng.integers(3, 9, 2))
    picture = rng.integers(1, 256, (height, width), np.uint8)
    u = np.arange(width)
    for row in picture:
        first, last = np.sort(rng.integers(0, width, 2))
        kind = rng.integers(5)
        if kind:
            row[(u < first) | (u > last) | (kind == 1)] = 0
        if kind == 2:
            row[rng.random(width) < 0.3] = 0
    return picture


def trial(rng, dudx: int) -> Trial:
    picture, lines = picture_of(rng), []
    width = picture.shape[1]
    for _ in range(40):
        count = int(rng.choice((-3, 0, 1, 2, rng.integers(1, 40), rng.integers(1, 1024))))
        if dudx and rng.random() < 0.8:  # inside one repetition of the map
            count = min(count, int(rng.integers(1, (width << 16) // abs(dudx) + 2)))
        u, v = (int(c) for c in rng.integers(0, 1 << 32, 2))
        if rng.random() < 0.6:
            room = max((width << 16) - 1 - abs(dudx) * max(count - 1, 0), 0)
            x = int(rng.integers(0, room + 1))
            u = u & ~((width << 16) - 1) | (x if dudx >= 0 else (width << 16) - 1 - x)
        lines.append((int(rng.integers(0, 300)), count, u, v))
    return opaque_trial(lines, signed(dudx + (int(rng.integers(-2, 3)) << 24)), picture,
                        Memory(int(rng.integers(1 << 30))), rng.integers(0, 0x10000, len(lines)).tolist(),
                        f"map {picture.shape[::-1]}, {values(dudx=dudx)}")


def trials() -> list[Trial]:
    rng = np.random.default_rng([13, 0])
    steps = [0, 1, -1, ONE, -ONE, ONE - 1, 1 - ONE, SLOWEST, -SLOWEST]
    steps += [int(n) >> int(s) for n, s in zip(rng.integers(-SLOWEST, SLOWEST, 80), rng.integers(0, 16, 80))]
    return [trial(rng, step) for step in steps]
