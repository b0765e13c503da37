"""Examples of the passes with perspective: the hardware's divide, and the level of detail."""

from functools import cache

import numpy as np

from tmap.base.fixed import signed
from tmap.bench.examples.example import BENCH, Example, longs, pairs, walked
from tmap.bench.examples.n64_sample import NO_TILES
from tmap.n64.divide import divide as divided, reciprocal
from tmap.n64.lod import Gradients, choose, level
from tmap.n64.state import Modes, State


NOTHING_LEFT = 24 << 8  # a shift of all of a fraction


@cache
def reciprocals() -> bytes:
    """What n64_divide_table_make makes."""
    r, shifts = reciprocal(np.arange(2, 1 << 15))
    return longs([0x7FFFFFFF, 0x7FFFFFFF, *(r << 3 + shifts)])


def any_iterators(rng, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Start and step of S, T, W: wild, or such that w stays above 0."""
    start, step = rng.integers(-1 << 31, 1 << 31, (2, 3))
    if rng.random() < 0.7:
        ends = rng.integers([-1 << 24, -1 << 24, 1 << 16], [1 << 24, 1 << 24, 1 << 31], (2, 3))
        start, step = ends[0], (ends[1] - ends[0]) // count
        if rng.random() < 0.3:  # very small w
            start[2], step[2] = 65536 * rng.integers(-2, 5), rng.integers(-8000, 9000)
        elif count != BENCH and rng.random() < 0.3:  # S or T is twice W: the quotients are where 17 bits end
            axis, twice = rng.integers(2), 2 * rng.choice((-1, 1))
            start[2], step[2] = abs(start[2]) >> 1, step[2] >> 1
            start[axis], step[axis] = twice * start[2], twice * step[2]
    return start, step


def usual_iterators(rng, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Start and step of S, T, W of what the bench measures: w stays above a quarter."""
    ends = rng.integers([-1 << 28, -1 << 28, 1 << 29], [1 << 28, 1 << 28, 1 << 31], (2, 3))
    return ends[0], (ends[1] - ends[0]) // count


def divide(rng, count: int) -> Example:
    start, step = any_iterators(rng, count)
    if count == BENCH:
        start, step = usual_iterators(rng, count)
    found = divided(*walked(start, step, count).T >> 16, True)
    return Example(longs(start), pairs(np.stack(found[:2], 1)), count, "n64_division",
                   dict(zip("stw", step)), {"reciprocals": reciprocals()})


def reciprocal_table(_, count: int) -> Example:
    return Example(bytes(4), reciprocals(), count)


def any_level(rng) -> State:
    """What a mode has of detail."""
    lod, sharpen, detail, *levels = (int(n) for n in rng.integers(0, (2, 2, 2, 8, 32, 8)))
    return State(modes=Modes(perspective=1, lod=lod, sharpen=sharpen, detail=detail),
                 **dict(zip(("max_level", "min_level", "primitive_tile"), levels)))


def entries(first, second, low) -> np.ndarray:
    """Longs of two tiles and a word; a fraction's 9 bits are signed."""
    return first << 24 | second << 16 | low & 0xFFFF


def level_bytes(state: State, only_blends: bool = False) -> bytes:
    """struct n64_levels; ``only_blends``: the fraction of a tile and itself is 0."""
    def blending(change, far: bool = False) -> tuple[np.ndarray, ...]:
        first, second, fraction = choose(state, change, np.full(change.shape, far))
        return first, second, np.where(only_blends & (first == second), 0, signed(fraction, 9))

    k = np.arange(1, 512)
    (first, second, fraction), *inside = (blending(32 * k + more) for more in (0, 1, 16))
    whole = np.frexp(np.maximum(k & 255, 1))[1] - 1
    all_one = (fraction == 255) & np.all([each[2] == 255 for each in inside], 0) \
        & (not (state.modes.sharpen or state.modes.detail))
    return longs([*entries(*blending(np.arange(512))), 0,
                  *entries(first, second, np.where(only_blends & (first == second), NOTHING_LEFT,
                                                   whole << 8 | 255 * all_one)),
                  *entries(*blending(np.zeros(1, int), True))])


def levels(rng, count: int) -> Example:
    state, only_blends = any_level(rng), bool(rng.integers(2))
    modes = {name: getattr(state.modes, name) for name in ("lod", "sharpen", "detail")}
    return Example(bytes(4), level_bytes(state, only_blends), count, "n64_level_modes", modes | {
        "only_blends": only_blends, "spare": 0,
        "max_level": state.max_level, "min_level": state.min_level, "tile": state.primitive_tile})


def lod(rng, count: int, apart: int = 0) -> Example:
    """``apart``: what the bench's steps have beside a multiple of 32."""
    start, step = any_iterators(rng, count)
    y = rng.integers(-1 << int(rng.integers(12, 28)), 1 << 12, 3)
    if rng.random() < 0.5:
        step = step & ~31
    if count == BENCH or rng.random() < 0.3:
        start, step = usual_iterators(rng, count)
        y = step[[1, 0, 2]]
        step = step & ~31 | apart
    if count != BENCH and rng.random() < 0.3:
        step = nearly_carried(rng, start, step)
    state = any_level(rng)
    found = level(state, *walked(start, step, count).T, Gradients(*step, *y))
    blendings = entries(found.tile0, found.tile1, signed(found.fraction, 9))
    values = dict(zip("stw", step)) | {f"y_{axis}": n for axis, n in zip("stw", y)}
    return Example(longs(start), pairs(np.stack([found.s, found.t], 1)), count, "n64_lod_steps",
                   values, {"reciprocals": reciprocals(), "levels": level_bytes(state)},
                   more={"blendings": longs([*blendings, NO_TILES])})


def nearly_carried(rng, start, step) -> np.ndarray:
    """Steps after which one iterator's lower word is 0 to 31: cut by as much, it has another upper
    word."""
    axis, few = rng.integers(3), rng.integers(32)
    step = step.copy()
    step[axis] = (step[axis] & -65536 | 32 * int(rng.integers(2048)) | few)
    start[axis] = (start[axis] & -65536) + (int(rng.integers(0, few + 1)) - step[axis] & 0xFFFF)
    return step
