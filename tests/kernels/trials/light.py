"""Trials of the spans that light pixels in the frame: every one by the level it must have."""

from functools import partial

import numpy as np

from tests.kernels.trials.lit import lit_ground, steps_of_levels, with_level
from tests.kernels.trials.span import LONG, SHORT, random_starts, table_trial
from tmap.bench.effects import LEVELS, light_trial
from tmap.bench.trial import Trial, values


def level_trial(level: int, size, rng, upwards: bool) -> Trial:
    ground, light, light_at = lit_ground()
    counts, pitch = size
    return table_trial(partial(light_trial, "span_light"), random_starts(counts, rng), pitch, rng, upwards,
                       f"level {level}", ground=ground, light=light, light_at=light_at, level=level)


def gouraud_trial(dcdx: int, size, rng, upwards: bool) -> Trial:
    ground, light, light_at = lit_ground()
    (counts, pitch), starts, shades = size, [], []
    for count, u, v in random_starts(counts, rng):
        count, shade = with_level(count, dcdx, rng)
        starts.append((count, u, v))
        shades.append(shade)
    return table_trial(partial(light_trial, "span_light_gouraud"), starts, pitch, rng, upwards,
                       values(dcdx=dcdx), ground=ground, light=light, light_at=light_at, shades=shades,
                       dcdx=dcdx)


def trials() -> list[Trial]:
    rng = [np.random.default_rng([12, seed]) for seed in range(2)]
    made = [level_trial(level, size, rng[0], level % 8 == 7) for size in (SHORT, LONG)
            for level in range(0, LEVELS, 3)]
    return made + [gouraud_trial(step & ~3, size, rng[1], k % 8 == 7) for size in (SHORT, LONG)
                   for k, step in enumerate(steps_of_levels(rng[1]))]
