"""Trials of coverage_scan: gaps of any number, lines before, in, over and behind them."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.bench.keyed import scan_trial
from tmap.bench.spans import BIAS
from tmap.bench.trial import Trial


def gaps(rng) -> list[tuple[int, int]]:
    """Up to five gaps, with pixels between."""
    ends = np.sort(rng.choice(40, 2 * int(rng.integers(0, 6)), replace=False)) * int(rng.choice((1, 20)))
    return [(BIAS + int(a) + 1, BIAS + int(b) - int(rng.integers(0, b - a))) for a, b in zip(ends[::2], ends[1::2])]


def line(rng, row: list[tuple[int, int]]) -> tuple[int, int]:
    """Any line; often one that begins or ends with a gap."""
    places = [x + int(d) for gap in row for x, d in zip(gap, rng.integers(-1, 2, 2))]
    left, last = (int(rng.choice(places)) if places and rng.random() < 0.7 else BIAS + int(rng.integers(0, 800))
                  for _ in range(2))
    return (left, last) if rng.random() < 0.1 else (min(left, last), max(left, last))


def trials() -> list[Trial]:
    rng, made = np.random.default_rng(25), []
    for number in range(60):
        rows = [gaps(rng) for _ in range(int(rng.choice((1, 2, 30, 100))))]
        lines = [line(rng, row) for row in rows]
        unused = int(rng.choice((0, 1, len(rows))))
        lacks = number % 10 == 9
        made.append(scan_trial(lines, rows, Memory(), f"{len(rows)} lines, number {number}", min(unused, len(rows) - lacks),
                               0 if lacks else None))
    return made
