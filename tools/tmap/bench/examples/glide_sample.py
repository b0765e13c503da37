"""Examples of the passes that find texels: coordinates, filter, points, stores."""

from dataclasses import dataclass

import numpy as np

from tmap.bench.examples.example import (BENCH, Example, Map, any_map, any_texels, longs, numbered,
                                         pair, pairs, pixels, some_coordinates, walked, words)

WRAPPED = 0xFFFF
EDGES = (0, 1, 15, 16, 0x7FFF, 0x8000, 0xFFFF, 0xFFF0)  # of s and t, 12.4
SIDE = 256  # texels, at most
DECODED = "glide_decoded", 4  # struct of a level, bits of fraction of its coordinates


@dataclass
class Axes:
    """A level as a walk sees it: ``last`` of s and t, WRAPPED where not clamped."""

    shift: int
    half: int
    last: tuple[int, int]
    behind: int = 0
    bits: int = 0  # of glide_pieces alone, from here on
    skip: int = 0
    left: int = 0

    def values(self, step) -> dict[str, int]:
        """struct glide_steps."""
        return dict(zip("stw", step)) | dict(zip(("last_s", "last_t"), self.last), spare=0) | {
            name: value for name, value in vars(self).items() if name != "last"}

    def coordinates(self, points: np.ndarray) -> np.ndarray:
        """Of s and t, [n][2] in 14.18."""
        found = (points >> self.shift) - self.half
        last = np.array(self.last)
        return np.where(last == WRAPPED, found, np.clip(found, 0, last))


def axes(rng, level: int, is_clamped=(False, False), bits: int = 4) -> Axes:
    """A random level ``level`` of 256 texels and less; ``bits`` of fraction."""
    sides = np.maximum(256 >> rng.integers(0, 4, 2) >> level, 1)
    return Axes(18 - bits + level, int(rng.choice((0, 1 << bits - 1))),
                tuple(int(side - 1 << bits) if clamped else WRAPPED
                      for side, clamped in zip(sides, is_clamped)))


def walked_line(start, step, points: np.ndarray, ground: Axes) -> Example:
    """The coordinates of a line's points of s and t, without perspective."""
    return Example(longs([*start, 0]), pairs(ground.coordinates(points)), len(points),
                   "glide_steps", ground.values([*step, 0]))


def walk(rng, count: int, levels=(0, 3)) -> Example:
    bits = int(rng.choice((4, 8)))
    level = int(rng.integers(*levels)) + (0 if bits == 4 else int(rng.integers(0, 5)))
    ground = axes(rng, min(level, 8), bits=bits)
    if count == BENCH:
        ground = Axes(14 + levels[0], 8, (WRAPPED, WRAPPED))
    start, step = rng.integers(-1 << 31, 1 << 31, (2, 2))
    if rng.random() < 0.5:
        step = rng.integers(-1 << 21, 1 << 21, 2)
    elif count != BENCH and rng.random() < 0.5:  # the smallest steps carry into the texel at once
        start, step = start | (1 << rng.integers(8, 26, 2)) - 1, rng.integers(1, 8, 2)
    return walked_line(start, step, numbered(start, step, count), ground)


def walk_clamp(rng, count: int) -> Example:
    level = int(rng.integers(0, 9))
    ground = axes(rng, level, rng.random(2) < 0.7, int(rng.choice((4, 8))))
    start, step = rng.integers(-1 << 31, 1 << 31, (2, 2))
    if rng.random() < 0.8:  # near the map, which has 2^26
        ends = rng.integers(-1 << 26, 1 << 27, (2, 2))
        start, step = ends[0], (ends[1] - ends[0]) // count
    if rng.random() < 0.3:
        step = rng.integers(-1, 2, 2) * rng.integers(0, 1 << 31, 2)
    if count == BENCH:
        ground = Axes(14, 8, (255 * 16, 255 * 16))
        start, step = [-40 << 18, 50 << 18], [1 << 18, 1 << 18]
    return walked_line(start, step, walked(start, step, count), ground)


def walk_inside(rng, count: int) -> Example:
    ground = axes(rng, 0, rng.random(2) < 0.7)
    ends = rng.integers(1 << 19, 30 << 18, (2, 2))
    step = (ends[1] - ends[0]) // count
    if count == BENCH:
        ground = Axes(14, 8, (255 * 16, 255 * 16))
    return walked_line(ends[0], step, numbered(ends[0], step, count), ground)


def halves(coefficients: tuple[np.ndarray, ...]) -> bytes:
    """Coefficients [n][4] of each quad: all of R and B, then all of G and A."""
    return longs(np.stack([pair(channels, high, low) for high, low in ((0, 2), (1, 3))
                           for channels in coefficients], 1))


def quad_bytes(corners: np.ndarray) -> bytes:
    """struct glide_quad of texels (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1): [n][4][4]."""
    c00, c10, c01, c11 = (corners[:, k].astype(np.int64) for k in range(4))
    return halves((c00 - c10 - c01 + c11, 16 * (c10 - c00), 16 * (c01 - c00), 256 * c00))


def quad_8_bytes(corners: np.ndarray) -> bytes:
    """struct glide_quad_8 of the same."""
    c00, c10, c01, c11 = (corners[:, k].astype(np.int64) for k in range(4))
    return halves((c10 - c00, 256 * c00, c11 - c01, 256 * c01))


def quads(rng, count: int, to_bytes) -> Example:
    """A row and the one below; each texel with its neighbours."""
    rows = any_texels(rng, 2 * count).reshape(2, count, 4)
    beside = np.roll(rows, -1, 1)
    corners = np.stack([rows[0], beside[0], rows[1], beside[1]], 1)
    return Example(pixels(rows), to_bytes(corners), count)


def any_pixels(rng, count: int) -> tuple[np.ndarray, Map]:
    """s and t of a level, 12.4, [count][2], and the level."""
    return some_coordinates(rng, count, EDGES, 0.1), any_map(rng, SIDE)


def filtered(st: np.ndarray, ground: Map, bits: int) -> np.ndarray:
    """Texels [n][4] by weights of ``bits`` bits."""
    one = 1 << bits
    corners = ground.corners(*(st >> bits).T)
    fs, ft = (st & one - 1).T
    weights = np.stack([(one - fs) * (one - ft), fs * (one - ft), (one - fs) * ft, fs * ft], 1)
    return (weights[:, :, None] * corners).sum(1) >> 2 * bits


def filter_pixels(rng, count: int, bits: int = 4) -> tuple[np.ndarray, Map]:
    """The same for a filter; the bench's have each pair of fractions once, in no order."""
    st, ground = any_pixels(rng, count)
    if count == BENCH and bits == 4:
        st = (st & ~15) + rng.permuted(np.stack(np.divmod(np.arange(256), 16), 1), axis=0)
    return st, ground


def bilinear(rng, count: int, bits: int = 4) -> Example:
    st, ground = filter_pixels(rng, count, bits)
    return Example(pairs(st), pixels(filtered(st, ground, bits)), count,
                   *ground.decoded(*DECODED, quad_bytes if bits == 4 else quad_8_bytes))


def packed(texels: bytes) -> bytes:
    """5/6/5 words of texels R G B A."""
    r, g, b, _ = np.frombuffer(texels, np.uint8).reshape(-1, 4).astype(np.int64).T
    return words(r >> 3 << 11 | g >> 2 << 5 | b >> 3)


def bilinear_565(rng, count: int) -> Example:
    made = bilinear(rng, count)
    made.expected = packed(made.expected)
    return made


def point(rng, count: int) -> Example:
    st, ground = any_pixels(rng, count)
    return Example(pairs(st), pixels(ground.corners(*(st >> 4).T)[:, 0]), count,
                   *ground.decoded(*DECODED))


def store_565(rng, count: int) -> Example:
    texels = pixels(any_texels(rng, count))
    return Example(texels, packed(texels), count)


def widen_565(rng, count: int) -> Example:
    found = rng.integers(0, 1 << 16, count)
    r, g, b = found >> 11, found >> 5 & 63, found & 31
    texels = [r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2, 0 * found]
    return Example(words(found), pixels(np.stack(texels, -1)), count)


def interleave(rng, count: int) -> Example:
    """Pixel n is number n // 4 of array n % 4."""
    room = (count + 3) // 4 + int(rng.integers(0, 5))
    quarters = any_texels(rng, 4 * room)
    found = [quarters[n % 4 * room + n // 4] for n in range(count)]
    return Example(pixels(quarters), pixels(np.array(found)), count, "glide_quarters",
                   {"bytes": 4 * room})
