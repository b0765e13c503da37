"""Examples of the passes with perspective: the hardware's divide, and the level of detail."""

from dataclasses import dataclass
from functools import cache

import numpy as np

from tmap.base.fixed import signed
from tmap.bench.examples.example import BENCH, Example, longs, pairs, walked


def reciprocal(w: int) -> tuple[int, int]:
    """The hardware's reciprocal of a w above 0, and the shifts that bring its bit 14 to one."""
    shifts = 15 - w.bit_length()
    n = (w << shifts) & 0x3FFF
    table = [round((1 << 20) / (64 + i)) - (i == 6) for i in range(65)]
    i, f = n >> 8, n & 255
    return table[i] + ((table[i + 1] - table[i]) * f * 4 >> 10), shifts


@cache
def reciprocals() -> bytes:
    """What n64_divide_table_make makes."""
    made = [0x7FFFFFFF, 0x7FFFFFFF]
    for w in range(2, 1 << 15):
        r, shifts = reciprocal(w)
        made.append(r << 3 + shifts)
    return longs(made)


def divided(s: int, w: int) -> tuple[int, bool]:
    """The quotient of the words s and w as 17 bits, and whether it overflows."""
    if w <= 0:
        return 65535, True
    r, shifts = reciprocal(w)
    value = s * r * 2 if shifts == 14 else s * r >> 13 - shifts
    return (signed(value, 17), False) if -65536 <= value < 65536 else \
        ((65535, -65536)[s < 0], True)


def in_range(value: int) -> int:
    """A quotient as s10.5, cut to what 16 bits hold."""
    return min(max(value, -32768), 32767)


def any_iterators(rng, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Start and step of S, T, W: wild, or such that w stays above 0."""
    start, step = rng.integers(-1 << 31, 1 << 31, (2, 3))
    if rng.random() < 0.7:
        ends = rng.integers([-1 << 24, -1 << 24, 1 << 16], [1 << 24, 1 << 24, 1 << 31], (2, 3))
        start, step = ends[0], (ends[1] - ends[0]) // count
        if rng.random() < 0.3:  # very small w
            start[2], step[2] = 65536 * rng.integers(-2, 5), rng.integers(-8000, 9000)
    return start, step


def usual_iterators(rng, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Start and step of S, T, W of what the bench measures: w stays above a quarter."""
    ends = rng.integers([-1 << 28, -1 << 28, 1 << 29], [1 << 28, 1 << 28, 1 << 31], (2, 3))
    return ends[0], (ends[1] - ends[0]) // count


def divide(rng, count: int) -> Example:
    start, step = any_iterators(rng, count)
    if count == BENCH:
        start, step = usual_iterators(rng, count)
    st = [[in_range(divided(int(c), int(w))[0]) for c in (s, t)]
          for s, t, w in walked(start, step, count) >> 16]
    return Example("n64_divide", longs(start), pairs(np.array(st)), count, "n64_division",
                   dict(zip("stw", step)), {"reciprocals": reciprocals()})


def reciprocal_table(_, count: int) -> Example:
    return Example("n64_reciprocals", bytes(4), reciprocals(), count)


@dataclass
class Level:
    """What a mode has of detail."""

    lod: int
    sharpen: int
    detail: int
    max_level: int
    min_level: int
    tile: int

    def blending(self, change: int | None) -> tuple[int, int, int]:
        """Both tiles and the fraction; ``change``: the longest one, None where one is far."""
        magnify = level = 0
        special = self.sharpen or self.detail
        if change is None or change >= 0x4000:
            distant, fraction = True, 0xFF
        elif change < 32:
            magnify, distant = 1, self.max_level == 0
            fraction = 8 * max(change, self.min_level) - 256 * self.sharpen if special else \
                0xFF if distant else 0
        else:
            level = max((change >> 5 & 255).bit_length() - 1, 0)
            distant = self.max_level == 0 or change & 0x6000 != 0 or level >= self.max_level
            fraction = 0xFF if distant and not special else change * 8 >> level & 255
        if not self.lod:
            return self.tile & 7, self.tile + 1 & 7, fraction
        level = self.max_level if distant else level
        first = self.tile + level
        if self.detail:
            tiles = first + (not magnify), first + (1 if distant or magnify else 2)
        else:
            tiles = first, first if distant or (magnify and not self.sharpen) else first + 1
        return tiles[0] & 7, tiles[1] & 7, fraction

    def table(self) -> bytes:
        """struct n64_levels."""
        def entry(first: int, second: int, low: int) -> int:
            return first << 24 | second << 16 | low & 0xFFFF

        rows = [entry(*self.blending(k)) for k in range(32)] + [0]
        for k in range(1, 512):
            first, second, fraction = self.blending(32 * k)
            level = max((k & 255).bit_length() - 1, 0)
            all_one = not (self.sharpen or self.detail) and fraction == 255 and \
                self.blending(32 * k + 1)[2] == 255 and self.blending(32 * k + 16)[2] == 255
            rows.append(entry(first, second, level << 8 | 255 * all_one))
        return longs(rows + [entry(*self.blending(None))])


def any_level(rng) -> Level:
    return Level(*(int(n) for n in rng.integers(0, (2, 2, 2, 8, 32, 8))))


def levels(rng, count: int) -> Example:
    mode = any_level(rng)
    return Example("n64_levels", bytes(4), mode.table(), count, "n64_level_modes", vars(mode))


def lod_apart(rng, count: int) -> Example:
    return lod(rng, count, 1)


def lod(rng, count: int, apart: int = 0) -> Example:
    start, step = any_iterators(rng, count)
    spread = 1 << int(rng.integers(12, 28))
    x, y = rng.integers(-spread, spread, (2, 3))
    if rng.random() < 0.5:
        x = step = step & ~31
    if count == BENCH:
        start, step = usual_iterators(rng, count)
        x, y = step, step[[1, 0, 2]]
        step = step & ~31 | apart
    mode, st, blendings = any_level(rng), [], []
    for point in walked(start, step, count):
        gradients = x & ~31, y & ~0x7FFF
        around = [[divided(int(c), int(q[2])) for c in q[:2]] for q in (
            signed(point + g) >> 16 for g in (np.zeros(3, np.int64), *gradients))]
        st.append([in_range(value) for value, _ in around[0]])
        changes = [q[k][0] - around[0][k][0] for q in around[1:] for k in (0, 1)]
        is_far = any(overflows for q in around for _, overflows in q)
        longest = None if is_far else max(d if d >= 0 else ~d for d in changes)
        first, second, fraction = mode.blending(longest)
        blendings.append(first << 24 | second << 16 | fraction & 0xFFFF)
    values = dict(zip("stw", step)) | {f"{name}_{axis}": n for name, g in (("x", x), ("y", y))
                                       for axis, n in zip("stw", g)}
    return Example("n64_lod", longs(start), pairs(np.array(st)), count, "n64_lod_steps", values,
                   {"reciprocals": reciprocals(), "levels": mode.table()},
                   more={"blendings": longs(blendings)})
