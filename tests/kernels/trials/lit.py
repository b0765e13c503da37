"""Trials of the lit spans and of edge_shade."""

from functools import cache, partial

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.span import (LONG, MAP_ALIGN, PAIRS, SHORT, STEPS, ground_of,
                                       once_wrapping, random_starts, sizes, steps_text, table_trial,
                                       texture)
from tmap.base.fixed import ONE, signed
from tmap.bench import effects
from tmap.bench.effects import LEVELS
from tmap.bench.spans import BIAS, Ground
from tmap.bench.trial import Trial, values
from tmap.build import layout
from tmap.guest.kernels import M32

FALLS = layout.load().constants["SHADE_FALLS"]


@cache
def lit_ground() -> tuple[Ground, np.ndarray, int]:
    """What lit spans are drawn on and from, and their light table, the second quarter of a page."""
    ground = ground_of(8, texture().tobytes(), texture())
    table = np.random.default_rng(9).integers(0, 256, (LEVELS, 256), dtype=np.uint8)
    noise = ground.arena.noise.randbytes(table.size)
    return ground, table, ground.arena.add(noise + table.tobytes(), MAP_ALIGN, "light") + table.size


def lit_trial(kernel: str, steps: tuple[int, int], size, rng, upwards: bool) -> Trial:
    ground, light, light_at = lit_ground()
    (counts, pitch), level = size, int(rng.integers(LEVELS))
    starts = random_starts(counts, rng)
    if kernel in ("span_lit", "span_lit_short"):
        starts = [once_wrapping(*start, *steps, rng) for start in starts]
    return table_trial(partial(effects.lit_trial, kernel), starts, pitch, rng, upwards,
                       f"level {level}, {steps_text(*steps)}", ground=ground, light=light,
                       light_at=light_at, level=level, dudx=steps[0], dvdx=steps[1])


def with_level(count: int, step: int, rng) -> tuple[int, int]:
    """So many pixels of a line, or as many as the levels allow, and its first level."""
    if step:
        count = min(count, ((LEVELS << 16) - 4) // abs(step) + 1)
    travel = step * max(count - 1, 0)
    low, high = max(0, -travel), (LEVELS << 16) - 4 - max(0, travel)
    return count, (low, high, int(rng.integers(low, high + 1)) & ~3)[min(2, rng.integers(5))]


def gouraud_trial(steps: tuple[int, int], dcdx: int, size, rng, upwards: bool) -> Trial:
    ground, light, light_at = lit_ground()
    (counts, pitch), step, starts, shades = size, dcdx & ~3, [], []
    for count, u, v in random_starts(counts, rng):
        count, shade = with_level(count, step, rng)
        shades.append(shade)
        starts.append((count, u, v))
    added = (light_at & 0xFFFF) + FALLS * (signed(steps[1], 24) < 0)
    return table_trial(partial(effects.lit_trial, "span_lit_gouraud"), starts, pitch, rng, upwards,
                       f"{values(dcdx=dcdx)}, {steps_text(*steps)}", ground=ground, light=light,
                       light_at=light_at, shades=shades, added=added, dudx=steps[0], dvdx=steps[1],
                       dcdx=dcdx)


def pairs_of(rng) -> list[tuple[int, int]]:
    steps = [(a, b) for a in STEPS for b in STEPS] + list(PAIRS)
    steps = [steps[k] for k in rng.choice(len(steps), 48, replace=False)]
    steps += [tuple(int(n) for n in rng.integers(-4 * ONE, 4 * ONE, 2)) for _ in range(8)]
    return steps + [tuple(int(n) for n in rng.integers(-1 << 31, 1 << 31, 2)) for _ in range(8)]


def lit_trials(kernel: str, rng) -> list[Trial]:
    return [lit_trial(kernel, pair, size, rng, k % 8 == 7)
            for size in sizes(kernel) for k, pair in enumerate(pairs_of(rng))]


def steps_of_levels(rng) -> list[int]:
    """Levels rise and fall, by whole ones too, or stay."""
    levels = [0, 4, -4, 0x100, -0x100, 0xFC, -0xFC, 0x1000, -0x1000, 63 << 8, -63 << 8, ONE, -ONE,
              -0x10100, 0x18003, -0x18001, 63 * ONE, -63 * ONE]
    return levels + [int(n) for n in rng.integers(-0x4000, 0x4000, 20)]


def gouraud_trials(rng) -> list[Trial]:
    """The same with levels that change, and v wraps all it can."""
    levels = steps_of_levels(rng)
    most = [(u, v) for u in (0, ONE, -0x18000) for v in (128 * ONE - 1, -128 * ONE, -128 * ONE + 0x100)]
    trials = []
    for size in (SHORT, LONG):
        pairs = [*pairs_of(rng), *most, (0, -0x100), (0, -ONE), (ONE, -0x8000)]
        for k, pair in enumerate(pairs):
            trials.append(gouraud_trial(pair, levels[k % len(levels)], size, rng, k % 8 == 7))
    trials += [gouraud_trial(pair, step, LONG, rng, False) for pair in most
               for step in (0, 4, -4, 0x100, -0x100)]
    return trials


def shade_trial(rng, most: int, inside: bool) -> Trial:
    """A table with lines of up to ``most`` pixels, shades near their range and far from it;
    ``inside``: the caller says that none leaves it, and nothing is held."""
    counts = [int(rng.integers(-3, most + 1)) for _ in range(int(rng.integers(1, 30)))]
    lefts = [BIAS + int(rng.integers(0, 1024)) for _ in counts]
    low = int(rng.integers(0, LEVELS)) << 16
    high = (int(rng.integers(low >> 16, LEVELS)) << 16 | 0xFFFF) - 3
    dcdx = int(rng.integers(-20 * ONE, 20 * ONE)) >> int(rng.integers(0, 20)) & ~3
    dcdy = int(rng.integers(-20 * ONE, 20 * ONE)) >> int(rng.integers(0, 20)) & ~3
    if rng.integers(8) == 0:
        dcdx = int(rng.integers(-1 << 31, 1 << 31)) & ~3
    shade = (int(rng.integers(low, high + 1)) & ~3) - dcdx * lefts[0] & M32
    added = int(rng.choice((0, FALLS))) + (int(rng.integers(0, 193)) << 8)
    plan = dict(shade=shade, dcdx=dcdx, dcdy=dcdy, low=low, high=high, added=added)
    return effects.shade_trial(Memory(int(rng.integers(1 << 30))), list(zip(lefts, counts)),
                               values(**plan), inside=int(inside), **plan)


def trials() -> list[Trial]:
    rng = [np.random.default_rng([11, seed]) for seed in range(6)]
    return [*lit_trials("span_lit", rng[0]), *lit_trials("span_lit_wrap", rng[1]),
            *gouraud_trials(rng[2]), *lit_trials("span_lit_short", rng[4]),
            *lit_trials("span_lit_short_wrap", rng[5]),
            *(shade_trial(rng[3], most, inside) for most in (1, 2, 3, 40, 320)
              for inside in (False, True) for _ in range(20))]
