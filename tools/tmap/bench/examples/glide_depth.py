"""Examples of the passes with perspective: the exact quotient, and the level of detail."""

from functools import cache
from math import isqrt

import numpy as np

from tmap.base.elementary import power
from tmap.base.fixed import signed
from tmap.bench.examples.example import BENCH, Example, longs, pairs, walked, words
from tmap.bench.examples.glide_sample import WRAPPED, Axes, axes

ONE = 1 << 30  # of w


def quotient(c: int, w: int, behind: int) -> int:
    """The exact one, cut to 32 bits."""
    if w == 0 or (w < 0 and behind):
        return 0
    return min(max((c << 30) // w, -1 << 31), (1 << 31) - 1)


def between(start, end, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Start and step of iterators."""
    return np.asarray(start), (np.asarray(end) - start) // count


def iterators(rng, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Start and step of s, t, w: any, or of a map that is seen, whose w falls by a factor of up to
    ``ratio`` or rises."""
    if rng.random() < 0.2:
        return rng.integers(-1 << 31, 1 << 31, 3), rng.integers(-1 << 31, 1 << 31, 3)
    ratio = float(rng.choice((1.001, 1.2, 2, 4, 20)))
    near = int(ONE * power(2, -rng.uniform(-0.3, 14)))
    w = [near, int(near / ratio)][::int(rng.choice((1, -1)))]
    if rng.random() < 0.1:
        w = [near, near]
    texels = rng.integers(-1 << 12, 1 << 12, (2, 2)) * rng.choice((0.01, 0.1, 1))
    if rng.random() < 0.1:
        texels = texels * 16
    ends = [[*(texels[k] * 2 ** 18 * w[k] / ONE).astype(np.int64), w[k]] for k in (0, 1)]
    if rng.random() < 0.1:  # small ones, around 0
        ends = rng.integers(-1000, 1000, (2, 3))
    start, step = between(*ends, count)
    if rng.random() < 0.1:
        step[:2] = step[:2] * rng.choice((-1, 1 << 6))
    return signed(start), signed(step)


def found(start, step, count: int, ground: Axes) -> Example:
    """The coordinates of a line."""
    points = walked(start, step, count)
    divided = np.array([[quotient(int(c), int(w), ground.behind) for c in (s, t)]
                        for s, t, w in points])
    return Example("glide_divide", longs(start), pairs(ground.coordinates(divided)), count,
                   "glide_steps", ground.values(step))


def divide(rng, count: int) -> Example:
    if count == BENCH:  # w to a quarter, 260 and 150 texels on
        texel = 1 << 18
        line = between([40 * texel, 50 * texel, ONE], [75 * texel, 50 * texel, ONE // 4], count)
        return found(*line, count, Axes(14, 8, (WRAPPED, WRAPPED)))
    ground = axes(rng, int(rng.integers(0, 9)), rng.random(2) < 0.4, int(rng.choice((4, 8))))
    ground.behind = int(rng.integers(2))
    return found(*iterators(rng, count), count, ground)


def divide_clamp(_, count: int) -> Example:
    ground = Axes(14, 8, (255 * 16, 255 * 16))
    line = between([-9 << 18, 50 << 18, ONE], [300 << 16, 200 << 16, ONE >> 2], count)
    return found(*line, count, ground)


def divide_each(_, count: int) -> Example:
    """A line that has to be divided pixel by pixel, for its w."""
    ground = Axes(14, 8, (WRAPPED, WRAPPED))
    line = between([40 << 18, 50 << 18, ONE + count], [300 << 16, 200 << 16, ONE >> 2], count)
    return found(*line, count, ground)


def line_of_pieces(start, step, ground: Axes) -> np.ndarray:
    """s and t, [left][2], of a line that is divided at the ends of pieces: numbers without a limit
    are cut to 32 bits where the rules say so."""
    points = walked(start, step, ground.left).tolist()
    divided = [[quotient(c, w, ground.behind) for c in (s, t)] for s, t, w in points]
    values = []
    for n in range(ground.left):
        first = n >> ground.bits << ground.bits
        last = min(first + (1 << ground.bits), ground.left - 1)
        steps = [signed(b - a) // max(last - first, 1)
                 for a, b in zip(divided[first], divided[last])]
        values.append([a + (n - first) * way for a, way in zip(divided[first], steps)])
    return signed(np.array(values))


def some_pieces(start, step, count: int, ground: Axes) -> Example:
    """A run of ``count`` pixels."""
    values = line_of_pieces(start, step, ground)[ground.skip:][:count]
    return Example("glide_pieces", longs(start), pairs(ground.coordinates(values)), count,
                   "glide_steps", ground.values(step))


def pieces(rng, count: int) -> Example:
    """Any run of any line."""
    ground = axes(rng, int(rng.integers(0, 9)), rng.random(2) < rng.choice((0, 0.4)),
                  int(rng.choice((4, 8))))
    ground.behind, ground.bits = int(rng.integers(2)), int(rng.integers(3, 5))
    if rng.random() < 0.6:
        ground.skip = int(rng.integers(1 << ground.bits))
    ground.left = ground.skip + count + int(rng.choice((0, 0, 1, rng.integers(40))))
    return some_pieces(*iterators(rng, ground.left), count, ground)


def priced(count: int, bits: int, last: int = WRAPPED, shift: int = 14) -> Example:
    """A line from end to end: w to a quarter, 260 and 150 texels on."""
    line = between([40 << 18, 50 << 18, ONE], [75 << 18, 50 << 18, ONE >> 2], count)
    return some_pieces(*line, count, Axes(shift, 8, (last, last), bits=bits, left=count))


def pieces_8(rng, count: int) -> Example:
    return priced(count, 3) if count == BENCH else pieces(rng, count)


def pieces_16(_, count: int) -> Example:
    return priced(count, 4)


def pieces_clamp(_, count: int) -> Example:
    return priced(count, 3, 255 * 16)


def pieces_small(_, count: int) -> Example:
    return priced(count, 3, shift=17)


@cache
def limits() -> tuple[int, ...]:
    """2^(31 + (k + 1/2) / 256), rounded down: where the next logarithm begins."""
    def root(value: int) -> int:
        for _ in range(9):
            value = isqrt(value)
        return value
    return tuple(root(1 << 512 * 31 + 2 * k + 1) for k in range(256))


def logarithm(value: int) -> int:
    """256 log2 of a number above 0, rounded to the nearest."""
    shifts = 32 - value.bit_length()
    return 256 * (31 - shifts) + sum(value << shifts > limit for limit in limits())


@cache
def logarithms() -> bytes:
    """What glide_logarithms_make makes."""
    rows = []
    for first in range(1 << 31, 1 << 32, 1 << 22):
        inside = [limit for limit in limits() if first <= limit < first + (1 << 22)]
        rows += [inside[0] if inside else (1 << 32) - 1, logarithm(first) - 31 * 256 << 16]
    return longs(rows)


def logarithm_table(_, count: int) -> Example:
    return Example("glide_logarithms", longs(limits()), logarithms(), count)


def lod(rng, count: int) -> Example:
    start, step = iterators(rng, count)
    if count == BENCH:
        start, step = between([0, 0, ONE], [0, 0, ONE // 4], count)
    least, most = sorted(int(n) for n in rng.integers(0, 2049, 2))
    lods = rng.integers(-1000, 1000) + rng.integers(0, 240, 4)
    if rng.random() < 0.1:
        lods = rng.integers(-32000, 5000, 4)
    if count == BENCH:
        least, most, lods = 0, 2048, np.full(4, 300)
    w = walked(start, step, count)[:, 2]
    found = [min(max(int(lods[n % 4]) + 31 * 256 - logarithm(abs(int(z))), least), most) if z
             else most for n, z in enumerate(w)]
    return Example("glide_lod", longs(start), words(found), count, "glide_lods",
                   {"lods": lods.tolist(), "least": least, "most": most, "w": step[2]},
                   {"logarithms": logarithms()})


def details(rng, count: int) -> Example:
    """LODs on the slope of a detail factor: above 0, below the most."""
    end, scale = 256 * int(rng.integers(1, 32)), int(rng.integers(0, 8))
    if count == BENCH:
        end, scale = 2048, 5
    first = max(end - ((256 << 8 - scale) - 1), 0)
    lods = rng.integers(first, end + 1, count)
    lods[rng.random(count) < 0.1] = first
    factors = (end - lods >> 8 - scale).astype(np.uint8)
    return Example("glide_details", words(lods), factors.tobytes(), count, "glide_nearness",
                   {"end": end, "shift": 8 - scale})
