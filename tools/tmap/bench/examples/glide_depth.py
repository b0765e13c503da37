"""Examples of the passes with perspective: the exact quotient, and the level of detail."""

import numpy as np

from tmap.base.elementary import power
from tmap.base.fixed import signed
from tmap.bench.examples.example import BENCH, Example, longs, pairs, walked, words
from tmap.bench.examples.glide_sample import WRAPPED, Axes, axes
from tmap.glide.coordinates import coordinates
from tmap.glide.logarithm import log2, thresholds
from tmap.glide.state import Modes

ONE = 1 << 30  # of w


def between(start, end, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Start and step of iterators."""
    return np.asarray(start), (np.asarray(end) - start) // count


def iterators(rng, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Start and step of s, t, w: any, or of a map that is seen, whose w falls or rises."""
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
    """The coordinates of ``count`` pixels: all are divided, or the ends of the ground's pieces."""
    before = np.arange(ground.left or count)
    modes = Modes(perspective=1, clamp_negative_w=ground.behind,
                  subdivision=1 << ground.bits if ground.bits else 0)
    st = coordinates(modes, *walked(start, step, len(before)).T, before, before[::-1])
    st = np.stack(st, 1)[ground.skip:][:count]
    return Example(longs(start), pairs(ground.coordinates(st)), count, "glide_steps",
                   ground.values(step))


def divide(rng, count: int) -> Example:
    if count == BENCH:  # w to a quarter, 260 and 150 texels on
        return priced(rng, count)
    ground = axes(rng, int(rng.integers(0, 9)), rng.random(2) < 0.4, int(rng.choice((4, 8))))
    ground.behind = int(rng.integers(2))
    if count > 24 and rng.random() < 0.2:  # w falls to a quarter; slopes grow 16 times, from near a limit
        slope = int(rng.integers(2, 12)) << 14
        ground = Axes(14, 0, (WRAPPED, WRAPPED))
        return found(*between([0, 0, ONE], [slope * count, -slope * count, ONE >> 2], count), count, ground)
    if rng.random() < 0.2:
        return found(*parted(rng, count), count, ground)
    if rng.random() < 0.6:  # w falls to a part: slopes grow by its square
        ends = (ONE >> rng.integers(14)) // np.array([1, rng.choice((4, 30, 100, 250))])
        s, t = (rng.uniform(-1.5, 1.5) * ends + rng.choice((-1, 1)) * rng.uniform(1, 2) * (1 << rng.integers(14, 30)) for _ in range(2))
        return found(*between(*np.stack([s, t, ends], 1).astype(np.int64).tolist(), count), count, ground)
    return found(*iterators(rng, count), count, ground)


def parted(rng, count: int) -> tuple[np.ndarray, np.ndarray]:
    """A line of several parts: w changes its sign, or is so small at one end that s and t are out of reach; s and t are
    any number of texels there, and up to 2,048 at the other end."""
    near = int(ONE * power(2, -rng.uniform(0, 8)))
    texels = rng.uniform(-1, 1, 2) * power(2, rng.uniform(0, 11)) * 2**18 * near / ONE
    beyond = rng.uniform(-1, 1, 2) * power(2, rng.uniform(10, 30.9))
    ends = [[*texels.astype(np.int64).tolist(), near],
            [*beyond.astype(np.int64).tolist(), int(near * rng.uniform(-1, 0.1))]]
    return between(*ends[::int(rng.choice((1, -1)))], count)


def divide_clamp(_, count: int) -> Example:
    ground = Axes(14, 8, (255 * 16, 255 * 16))
    line = between([-9 << 18, 50 << 18, ONE], [300 << 16, 200 << 16, ONE >> 2], count)
    return found(*line, count, ground)


def divide_each(_, count: int) -> Example:
    """A line that has to be divided pixel by pixel, for its w."""
    ground = Axes(14, 8, (WRAPPED, WRAPPED))
    line = between([40 << 18, 50 << 18, -ONE], [300 << 16, 200 << 16, -ONE >> 2], count)
    return found(*line, count, ground)


def pieces(rng, count: int) -> Example:
    """Any run of any line."""
    if count == BENCH:
        return priced(rng, count, 3)
    ground = axes(rng, int(rng.integers(0, 9)), rng.random(2) < rng.choice((0, 0.4)),
                  int(rng.choice((4, 8))))
    ground.behind, ground.bits = int(rng.integers(2)), int(rng.integers(3, 5))
    if rng.random() < 0.6:
        ground.skip = int(rng.integers(1 << ground.bits))
    line = ground.skip + count + int(rng.choice((0, 0, 1, rng.integers(40))))
    ground.left = 0 if line == count and rng.random() < 0.5 else line
    return found(*iterators(rng, line), count, ground)


def priced(_, count: int, bits: int = 0, last: int = WRAPPED, shift: int = 14) -> Example:
    """A line from end to end: w to a quarter, 260 and 150 texels on."""
    line = between([40 << 18, 50 << 18, ONE], [75 << 18, 50 << 18, ONE >> 2], count)
    return found(*line, count, Axes(shift, 8, (last, last), bits=bits, left=count if bits else 0))


def limits() -> np.ndarray:
    """2^(31 + (k + 1/2) / 256), rounded down: where the next logarithm begins."""
    return (thresholds() - np.uint64(1) >> np.uint64(32)).astype(np.int64)


def logarithm_bytes() -> bytes:
    """What glide_logarithms_make makes: of each 512th of an octave the limit inside, or the most,
    and the logarithm at its beginning."""
    first, limit = np.arange(1 << 31, 1 << 32, 1 << 22), limits()
    number = np.searchsorted(limit, first)
    following = np.append(limit, 1 << 32)[number]
    inside = np.where(following < first + (1 << 22), following, (1 << 32) - 1)
    return longs(np.stack([inside, log2(first) - 31 * 256 << 16], 1))


def logarithms(_, count: int) -> Example:
    return Example(longs(limits()), logarithm_bytes(), count)


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
    w = abs(walked(start, step, count)[:, 2])
    values = np.resize(lods, count) + 31 * 256 - log2(np.maximum(w, 1))
    return Example(longs(start), words(np.where(w, np.clip(values, least, most), most)), count,
                   "glide_lods",
                   {"lods": lods.tolist(), "least": least, "most": most, "w": step[2]},
                   {"logarithms": logarithm_bytes()})


def flips(rng, count: int) -> Example:
    lods = rng.integers(0, 2049, count)
    factors = lods & 255 ^ np.where(lods >> 8 & 1, 255, 0)
    return Example(words(lods), factors.astype(np.uint8).tobytes(), count)


def details(rng, count: int) -> Example:
    """LODs on the slope of a detail factor: above 0, below the most."""
    end, scale = 256 * int(rng.integers(1, 32)), int(rng.integers(0, 8))
    if count == BENCH:
        end, scale = 2048, 5
    first = max(end - ((256 << 8 - scale) - 1), 0)
    lods = rng.integers(first, end + 1, count)
    lods[rng.random(count) < 0.1] = first
    factors = (end - lods >> 8 - scale).astype(np.uint8)
    return Example(words(lods), factors.tobytes(), count, "glide_nearness",
                   {"end": end, "shift": 8 - scale})
