"""Examples of the passes that find texels: coordinates, filter, points, stores."""

import numpy as np

from tmap.base.fixed import signed
from tmap.bench.examples.example import (BENCH, Example, any_map, any_texels, longs, packed,
                                         pair, pairs, pixels, some_coordinates, walked)
from tmap.build import layout
from tmap.n64.filters import Quad, filtered
from tmap.n64.state import Modes, State

NO_TILES = 0xFFFF0000  # behind the last blending
EDGES = (0, 1, 31, 32, 0x7FFF, 0x8000, 0xFFFF, 0xFFE0)  # of s and t in 16 bits
WIDEST = 512  # texels in a row
DECODED = "n64_decoded", 5  # struct of a tile, bits of fraction of its coordinates


def coordinates(rng, count: int) -> np.ndarray:
    """s and t, s10.5 modulo 2^16, [count][2]."""
    return some_coordinates(rng, count, EDGES, 0.2)


def struct_bytes(name: str, **values: int) -> bytes:
    """A C struct without pointers."""
    return layout.load().struct(name).pack(**values)


def walk(rng, count: int) -> Example:
    start, step = rng.integers(-1 << 31, 1 << 31, (2, 2))
    if rng.random() < 0.5:
        step = rng.integers(-1 << 21, 1 << 21, 2)
    return Example(longs([*start, 0]), pairs(walked(start, step, count) >> 16), count,
                   "n64_iterators", dict(s=step[0], t=step[1], w=0))


def quad_bytes(corners: np.ndarray) -> bytes:
    """struct n64_quad of the corners c00, c10, c01, c11: [n][4][4]."""
    corners = corners.astype(np.int64)
    c00, c10, c01, c11 = (corners[:, k] for k in range(4))
    rows = []
    for corner, in_s, in_t in ((c00, c10, c01), (c11, c01, c10)):
        for high, low in ((0, 2), (1, 3)):
            rows += [8 * pair(in_s - corner, high, low), 8 * pair(in_t - corner, high, low),
                     8 * pair(32 * corner + 16, high, low)]
    mean = 8 * (c00 + c10 + c01 + c11) + 16
    rows += [8 * pair(mean, 0, 2), 8 * pair(mean, 1, 3), 0 * c00[:, 0], 0 * c00[:, 0]]
    return longs(np.stack(rows, 1))


def quads(rng, count: int) -> Example:
    step = int(rng.integers(1, 4)) if count != BENCH else 1
    rows = any_texels(rng, 2 * (count + 1) * step).reshape(2, count + 1, step, 4)
    above, below = rows[:, :, 0]
    made = quad_bytes(np.stack([above[:-1], above[1:], below[:-1], below[1:]], 1))
    apart = np.zeros((count, step, len(made) // count), np.uint8)
    apart[:, 0] = np.frombuffer(made, np.uint8).reshape(count, -1)
    return Example(pixels(rows[0]), apart.tobytes(), count, "n64_quad_row",
                   {"step": step}, {"below": pixels(rows[1])})


def threepoint(rng, count: int, averages: bool = False) -> Example:
    st, ground = coordinates(rng, count), any_map(rng, WIDEST)
    if averages:
        st[rng.random(count) < 0.5] = st[0] & 0xFFE0 | 16
    quad = Quad(*ground.corners(*(st >> 5).T).swapaxes(0, 1))
    drawn = filtered(State(modes=Modes(mid=averages)), quad, *(st.T & 31), None)
    return Example(pairs(st), pixels(drawn), count, *ground.decoded(*DECODED, quad_bytes))


def threepoint_intensity(rng, count: int) -> Example:
    made = threepoint(rng, count)
    made.expected = longs(np.frombuffer(made.expected, np.uint8)[3::4])
    return made


def threepoint_levels(rng, count: int) -> Example:
    """Of the second texel, those of a pair of equal tiles are not written."""
    st, shifts = coordinates(rng, count), rng.integers(0, 4, 8)
    grounds = [any_map(rng, 256) for _ in shifts]
    second, skips = (int(n) for n in rng.integers(0, 2, 2))
    runs = rng.integers(0, 8, (count, 2)).repeat(rng.integers(1, 9, count), 0)[:count]
    single = np.where(rng.random(8) < 0.2, 0, 31)  # fractions that are not looked at
    tiles, drawn, places = runs[:, second], np.zeros((count, 4), np.int64), []
    blocks = b""
    for n, ground in enumerate(grounds):
        _, values, made = ground.decoded(*DECODED, quad_bytes)
        places.append(struct_bytes("n64_level_tile", **{
            name: int(values[name]) for name in ("mask_s", "mask_t", "columns_bits")},
            quads_at=len(blocks), shift=int(shifts[n]), fractions=int(single[n]) << 16 | 31))
        blocks += made["quads"]
        at = tiles == n
        moved = signed(st[at], 16) >> shifts[n]
        quad = Quad(*ground.corners(*(moved >> 5).T).swapaxes(0, 1))
        fractions = moved.T & np.array([[single[n]], [31]])
        drawn[at] = filtered(State(modes=Modes()), quad, *fractions, None)
    drawn[(runs[:, 0] == runs[:, 1]) & bool(second and skips)] = 0
    blendings = longs([*(runs[:, 0] << 24 | runs[:, 1] << 16), NO_TILES])
    return Example(pairs(st), pixels(drawn), count, "n64_level_sampling",
                   {"second": second, "skips": skips},
                   {"blendings": blendings, "tiles": b"".join(places), "quads": blocks})


def threepoint_16(rng, count: int) -> Example:
    made = threepoint(rng, count)
    made.expected = packed(np.frombuffer(made.expected, np.uint8))
    return made


def point(rng, count: int) -> Example:
    st, ground = coordinates(rng, count), any_map(rng, WIDEST)
    return Example(pairs(st), pixels(ground.corners(*(st >> 5).T)[:, 0]), count,
                   *ground.decoded(*DECODED))


def store_16(rng, count: int) -> Example:
    texels = any_texels(rng, count)
    return Example(pixels(texels), packed(texels), count)


def axis(rng, kind: str) -> tuple[int, int, int, int]:
    """Clamp, shift as the tile has it, low, high; ``kind``: "any", "plain", or "clamp" or "line"
    without a shift."""
    if kind == "plain":
        return 0, 0, int(rng.integers(4096)), 4095
    if kind in ("clamp", "line"):
        low, high = sorted(4 * int(n) for n in rng.integers(0, 1024, 2))
        if rng.random() < 0.2:  # either may be the larger one, and have a fraction
            low, high = (int(n) for n in rng.integers(0, 4096, 2))
        return int(rng.random() < 0.8), 0, low, high
    low, high = (int(n) for n in rng.integers(0, 4096, 2))
    if rng.random() < 0.7:
        low, high = min(low, high) & ~3, max(low, high) & ~3
    return int(rng.integers(2)), int(rng.integers(16)), low, high


def related(c: int, clamp: int, shift: int, low: int, high: int) -> int:
    """The coordinate c (16 bits signed) relative to the tile, modulo 2^16."""
    c = c >> shift if shift <= 10 else signed(c << 16 - shift, 16)
    is_over = c >> 3 >= high
    c -= 8 * low
    if clamp and is_over:
        return 32 * ((high >> 2) - (low >> 2) & 0x3FF)
    return 0 if clamp and c < 0 else c & 0xFFFF


def tiled(rng, count: int, kind: str = "any") -> Example:
    st, shape = coordinates(rng, count), layout.load().struct("n64_axis_range")
    axes = [axis(rng, kind) for _ in "st"]
    for k, (*_, low, high) in enumerate(axes):  # what stands on the borders
        border = 8 * rng.choice((low, high), count) + rng.integers(-2, 3, count)
        st[:, k] = np.where(rng.random(count) < 0.3, border & 0xFFFF, st[:, k])
    if kind == "line":  # often near to a border, sometimes past it
        start = [int(rng.integers(8 * low - 99, 8 * max(low, high) + 99)) for *_, low, high in axes]
        step = rng.integers(-1 << rng.integers(16, 31), 1 << rng.integers(16, 31), 2)
        st = walked(np.array(start) << 16, step, count) >> 16 & 0xFFFF
    if kind in ("clamp", "line") and count == BENCH:  # inside a picture of 64x64 texels
        axes, st = [(1, 0, 0, 63 * 4)] * 2, rng.integers(0, 63 * 32, (count, 2))
        st = st if kind == "clamp" else walked((5 << 16, 1900 << 16), (7 << 16, -5 << 15), count) >> 16
    found = [[related(int(c), *a) for c, a in zip(row, axes)] for row in signed(st, 16)]
    ranges = [list(shape.pack(shift=shift if shift <= 10 else shift - 16, clamp=clamp, low=8 * low,
                              high=8 * high, last=32 * ((high >> 2) - (low >> 2) & 0x3FF)))
              for clamp, shift, low, high in axes]
    return Example(pairs(st), pairs(np.array(found)), count, "n64_axes", dict(zip("st", ranges)))
