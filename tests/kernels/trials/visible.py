"""Trials of what finds visible pixels. src68k/depths: lines in the columns, cut by them, beside them and empty; steep
planes, whose q wraps; polygons that turn to one side or to both. coverage_scan: gaps of any number, lines before, in,
over and behind them. coverage_cut: lines with up to four visible parts."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.bench.spans import BIAS
from tmap.bench.trial import Trial
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.bench.edges import cut_trial, random_cuts
from tmap.bench.visible import Slope, depth_trial, scan_trial

WIDTH = 48


def ends(rng) -> tuple[int, int]:
    """A line: every fourth one has no pixels."""
    first, last = np.sort(rng.integers(0, WIDTH, 2)).tolist()
    return (first, last) if rng.integers(4) else (int(rng.integers(0, WIDTH + 1)), -1)


def depth_trials() -> list[Trial]:
    rng, made = np.random.default_rng(83), []
    for k in range(72):
        height = int(rng.integers(1, 12))
        lines, columns = [ends(rng) for _ in range(height)], ends(rng)
        steep = int(rng.choice((10, 40, 52, 62)))
        slope = Slope(int(rng.integers(-1 << 60, 1 << 61)),
                      *(int(rng.integers(-1 << steep, 1 << steep)) for _ in range(2)))
        z = rng.integers(-1 << 31, 1 << 31, (height, WIDTH))
        for y, line in enumerate(lines):  # as near as possible to q, above and below
            for x, q in enumerate(slope.line(line[0], line[1] - line[0] + 1, y), line[0]):
                if rng.integers(2):
                    z[y, x] = min(max(q + int(rng.integers(-1, 2)), -1 << 31), (1 << 31) - 1)
        kernel = ("depth_fill", "depth_copy", "depth_copy_keyed")[k % 3]
        made.append(depth_trial(kernel, lines, columns, slope, z, Memory(), f"{height} lines, number {k}"))
    return made


def turns(vertices) -> int:
    """Returns 0 if a polygon turns to both sides, else 1."""
    ways = [(bx - ax, by - ay) for (ax, ay), (bx, by) in zip(vertices, vertices[1:] + vertices[:1])]
    crossed = [a[0] * b[1] - a[1] * b[0] for a, b in zip(ways, ways[1:] + ways[:1])]
    return int(min(crossed) >= 0 or max(crossed) <= 0)


def convex_trials() -> list[Trial]:
    """Polygons around a middle, some with a corner near the line between its neighbours; single units decide."""
    rng, made = np.random.default_rng(19), []
    for number in range(48):
        angles = np.sort(rng.random(int(rng.integers(3, 9)))) * 2 * np.pi
        size = int(rng.choice((1 << 4, 1 << 18, 1 << 29)))
        corners = [(int(size * np.cos(a)), int(size * np.sin(a))) for a in angles][::int(rng.choice((1, -1)))]
        if rng.random() < 0.7:
            a, b = corners[0], corners[-1]
            corners.append(tuple((p + q) // 2 + int(rng.integers(-1, 2)) for p, q in zip(a, b)))
        arena = Memory()
        vertices = arena.add(b"".join(value.to_bytes(4, "big", signed=True) for x, y in corners
                                      for value in (x, y, 0, 0, 0, 0)), name="vertices", shape=layout.load().struct("vertex"))
        made.append(Trial(Case("depth_convex", arena, pointers={"a0": vertices}, registers={"d0": len(corners)}),
                          f"{len(corners)} corners, number {number}", outputs={"d0": turns(corners)}))
    return made


def gaps_of(rng) -> list[tuple[int, int]]:
    """Up to five gaps, with pixels between."""
    ends = np.sort(rng.choice(40, 2 * int(rng.integers(0, 6)), replace=False)) * int(rng.choice((1, 20)))
    return [(BIAS + int(a) + 1, BIAS + int(b) - int(rng.integers(0, b - a))) for a, b in zip(ends[::2], ends[1::2])]


def line(rng, row: list[tuple[int, int]]) -> tuple[int, int]:
    """Any line; often one that begins or ends with a gap."""
    places = [x + int(d) for gap in row for x, d in zip(gap, rng.integers(-1, 2, 2))]
    left, last = (int(rng.choice(places)) if places and rng.random() < 0.7 else BIAS + int(rng.integers(0, 800))
                  for _ in range(2))
    return (left, last) if rng.random() < 0.1 else (min(left, last), max(left, last))


def scan_trials() -> list[Trial]:
    rng, made = np.random.default_rng(25), []
    for number in range(60):
        rows = [gaps_of(rng) for _ in range(int(rng.choice((1, 2, 30, 100))))]
        lines = [line(rng, row) for row in rows]
        unused = int(rng.choice((0, 1, len(rows))))
        lacks = number % 10 == 9
        made.append(scan_trial(lines, rows, Memory(), f"{len(rows)} lines, number {number}", min(unused, len(rows) - lacks),
                               0 if lacks else None))
    return made


def cut_trials() -> list[Trial]:
    """Tables of all forms, with steps for each line and without, chained and not."""
    rng, made = np.random.default_rng(27), []
    for number in range(72):
        form = ("addx", "plain", "flat", "addx")[number % 4]
        count = int(rng.choice((1, 2, 9, 40)))
        made.append(cut_trial(random_cuts(rng, count), form, form == "addx" and number % 8 > 3, bool(number // 8 % 2),
                              Memory(), f"{count} lines, number {number}"))
    return made


def trials() -> list[Trial]:
    return depth_trials() + convex_trials() + scan_trials() + cut_trials()
