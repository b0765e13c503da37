"""Trials of the Gouraud span, the map of any size and the generated code."""

from functools import cache, partial

import numpy as np

from tests.kernels.trials.span import (LONG, MAP_ALIGN, PAIRS, SHORT, STEPS, ground_of,
                                       picture_ground, random_starts, sizes, steps_of, steps_text,
                                       table_trial, texture)
from tmap.base.fixed import ONE
from tmap.bench.mappers import mapper_trial, with_margins
from tmap.bench.spans import Ground
from tmap.bench.trial import Trial

#: Maps of any size: columns, rows.
SIZES = (1, 1), (1, 7), (7, 1), (3, 5), (100, 37), (255, 257), (320, 200), (1024, 1024)
#: Steps of u and v as parts of the map's side in 1/65536; None: any number.
PARTS = ((0, 0), (256, 0), (0, 256), (400, 256), (-400, 256), (400, -256), (-400, -256),
         (None, None), (None, None), (3000, 20000), (-ONE, 700), (700, ONE), (0, -300), (-300, 0))
#: And as they are.
SMALL = ((1, 0), (0, -1), (ONE, ONE), (-ONE, ONE), (-ONE, -ONE), (0x18000, 0x14000),
         (-0x18000, -0x14000), (0x18000, -0x14000), (-0x18000, 0x14000), (0x8000, ONE),
         (-0x8000, ONE), (0x8000, -ONE), (ONE, 0x8000), (-ONE, 0xFFFF), (-1, 1), (1, -1), (-1, -1),
         (ONE - 1, -ONE + 1), (0x8000, 0), (-0x8000, 0), (2 * ONE, -0x8000), (0, 0x4000))


@cache
def any_map(columns: int, rows: int) -> Ground:
    """A frame and a map at an odd address."""
    picture = np.random.default_rng(rows).integers(0, 256, (rows, columns), dtype=np.uint8)
    return ground_of(columns + rows, b"\x5c" + picture.tobytes(), picture, 1, 4)


@cache
def margins_ground() -> Ground:
    """A frame and a map between margins: a page's halves once more."""
    return ground_of(5, with_margins(texture()), texture(), MAP_ALIGN)


def fitting(count: int, size: tuple[int, int], steps: tuple[int, int], rng):
    """A line whose texels all lie inside the map, often up to its first and last ones."""
    for side, step in zip(size, steps):
        if step:
            count = min(count, (side * ONE - 1) // abs(step) + 1)
    start = []
    for side, step in zip(size, steps):
        travel = step * (max(count, 1) - 1)
        low, high = max(0, -travel), side * ONE - 1 - max(0, travel)
        start.append((low, high, int(rng.integers(low, high + 1)))[min(2, int(rng.integers(5)))])
    return count, *start


def arbitrary_trial(size: tuple[int, int], steps: tuple[int, int], counts, rng, upwards) -> Trial:
    (dudx, dvdx), (counts, pitch) = steps, counts
    starts = [fitting(count, size, steps, rng) for count in counts for _ in range(4)]
    return table_trial(partial(mapper_trial, "span_arbitrary"), starts, pitch, rng, upwards,
                       f"map {size[0]}x{size[1]}, {steps_text(dudx, dvdx)}", ground=any_map(*size),
                       dudx=dudx, dvdx=dvdx, map_width=size[0], map_height=size[1])


def arbitrary_trials(rng) -> list[Trial]:
    trials = []
    for size in SIZES:
        steps = [tuple(part * side // ONE if part is not None else
                       int(rng.integers(1 - side * ONE, side * ONE)) for part, side in zip(parts, size))
                 for parts in PARTS]
        steps += [s for s in SMALL if all(abs(a) < side * ONE for a, side in zip(s, size))]
        if size[0] * size[1] > 1 << 18:  # a megabyte each
            steps = [steps[k] for k in rng.choice(len(steps), 8, replace=False)]
        for k, pair in enumerate(steps):
            trials.append(arbitrary_trial(size, pair, (SHORT, LONG)[k % 4 == 3], rng, k % 8 == 7))
    return trials


def gouraud_trial(kernel: str, step: int, size, rng, upwards: bool) -> Trial:
    counts, pitch = size
    reduced = abs((step + (128 << 16)) % (256 << 16) - (128 << 16)) / ONE
    longest = int(64000 / reduced) if reduced else 64000
    starts = [(min(count, longest), u, v) for count, u, v in random_starts(counts, rng)]
    return table_trial(partial(mapper_trial, kernel), starts, pitch, rng, upwards, steps_text(step, 0),
                       ground=picture_ground(), dudx=step, dvdx=int(rng.integers(1 << 31)))


def gouraud_trials(kernel: str, rng) -> list[Trial]:
    steps = [*STEPS, *(a for a, _ in PAIRS), *(int(n) for n in rng.integers(-ONE, ONE, 8)),
             *(int(n) for n in rng.integers(-1 << 31, 1 << 31, 12))]
    return [gouraud_trial(kernel, step, size, rng, k % 8 == 7)
            for size in sizes(kernel) for k, step in enumerate(steps)]


def generated_trial(dudx: int, dvdx: int, size, rng, upwards: bool) -> Trial:
    """One table drawn by generated code; the code itself is compared too."""
    counts, pitch = size
    return table_trial(partial(mapper_trial, "span_generated"), random_starts(counts, rng), pitch,
                       rng, upwards, steps_text(dudx, dvdx), ground=margins_ground(), dudx=dudx, dvdx=dvdx)


def generated_trials(rng) -> list[Trial]:
    """Steps of all kinds, on short and on long lines, and a table without a pixel."""
    steps = steps_of(rng)
    long_steps = [*PAIRS, *(steps[k] for k in rng.choice(len(steps), 16, replace=False))]
    tables = (((0, -1, -16), 128), [(0, ONE)]), (SHORT, steps), (LONG, long_steps)
    return [generated_trial(*pair, size, rng, k % 8 == 7)
            for size, chosen in tables for k, pair in enumerate(chosen)]


def trials() -> list[Trial]:
    makers = (partial(gouraud_trials, "span_gouraud"), arbitrary_trials, generated_trials,
              partial(gouraud_trials, "span_gouraud_short"))
    return [trial for seed, make in enumerate(makers)
            for trial in make(np.random.default_rng([7, seed]))]
