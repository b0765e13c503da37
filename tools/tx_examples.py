"""Random input of the texture engine's passes, and what must come out of each.

The expected output is worked out here pixel by pixel from the rules (the coordinate steps,
filter, divide, combiner), in whatever way is plainest: neither the C nor the assembly is
asked. The bench measures one example of each pass, the tests call many.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache

import numpy as np

from . import layout

EDGES_16 = (0, 1, 31, 32, 0x7FFF, 0x8000, 0xFFFF, 0xFFE0)


@dataclass
class Example:
    """One call: bytes in and out, and the struct of constants, or a table that is them.

    ``blocks`` are what its fields point at, ``more`` what they point at and is written.
    ``stride``: bytes from pixel to pixel where a word of each is written alone.
    """

    kernel: str
    source: bytes
    expected: bytes
    count: int
    struct: str = ""
    values: dict[str, int] = field(default_factory=dict)
    blocks: dict[str, bytes] = field(default_factory=dict)
    more: dict[str, bytes] = field(default_factory=dict)
    table: bytes = b""
    stride: int = 0

    def image(self, before: bytes) -> bytes:
        """The output as it must be, from what its memory held."""
        if not self.stride:
            return self.expected
        out = np.frombuffer(before, np.uint8).reshape(self.count, self.stride).copy()
        out[:, :2] = np.frombuffer(self.expected, np.uint8).reshape(self.count, 2)
        return out.tobytes()

    @property
    def size(self) -> int:
        """Bytes of the output's memory."""
        return self.count * self.stride or len(self.expected)


def longs(values) -> bytes:
    """Numbers modulo 2^32, big-endian."""
    return (np.asarray(values).astype(np.int64) & 0xFFFFFFFF).astype(">u4").tobytes()


def words(values) -> bytes:
    """Numbers modulo 2^16, big-endian."""
    return (np.asarray(values).astype(np.int64) & 0xFFFF).astype(">u2").tobytes()


def signed(values, bits: int) -> np.ndarray:
    """The low bits as a signed number."""
    values = np.asarray(values, np.int64) & (1 << bits) - 1
    return values - (values >> bits - 1 << bits)


def pixels(channels: np.ndarray) -> bytes:
    """Channels [n][4] as R G B A bytes."""
    return channels.astype(np.uint8).tobytes()


def coordinates(rng, count: int) -> np.ndarray:
    """s and t, [count][2], 0 to 65,535: edges and any."""
    some = rng.integers(0, 1 << 16, (count, 2))
    edge = rng.choice(EDGES_16, (count, 2))
    return np.where(rng.random((count, 2)) < 0.2, edge, some)


def pairs(st: np.ndarray) -> bytes:
    """s:t longs."""
    return longs((st[:, 0] & 0xFFFF) << 16 | st[:, 1] & 0xFFFF)


def walked(start, step, count: int) -> np.ndarray:
    """Iterators at each pixel, modulo 2^32 as signed numbers, [count][len(start)]."""
    n = np.arange(count, dtype=np.int64)[:, None]
    return signed(np.asarray(start, np.int64) + n * np.asarray(step, np.int64), 32)


def walk(rng, count: int) -> Example:
    start, step = rng.integers(-1 << 31, 1 << 31, (2, 2))
    if rng.random() < 0.5:
        step = rng.integers(-1 << 21, 1 << 21, 2)
    return Example("tx_walk", longs([*start, 0]), pairs(walked(start, step, count) >> 16), count,
                   "tx_iterators", dict(s=step[0], t=step[1], w=0))


def quad_bytes(corners: np.ndarray) -> bytes:
    """struct tx_quad of the corners c00, c10, c01, c11: [n][4][4]."""
    corners = corners.astype(np.int64)
    c00, c10, c01, c11 = (corners[:, k] for k in range(4))

    def pair(channels, high: int, low: int) -> np.ndarray:
        return channels[:, high] * 65536 + channels[:, low]

    rows = []
    for corner, in_s, in_t in ((c00, c10, c01), (c11, c01, c10)):
        for high, low in ((0, 2), (1, 3)):
            rows += [8 * pair(in_s - corner, high, low), 8 * pair(in_t - corner, high, low),
                     8 * pair(32 * corner + 16, high, low)]
    mean = 8 * (c00 + c10 + c01 + c11) + 16
    rows += [8 * pair(mean, 0, 2), 8 * pair(mean, 1, 3), 0 * c00[:, 0], 0 * c00[:, 0]]
    return longs(np.stack(rows, 1))


def quads(rng, count: int) -> Example:
    corners = any_texels(rng, 4 * count).reshape(count, 4, 4)
    return Example("tx_quads", pixels(corners), quad_bytes(corners), count)


def any_texels(rng, count: int) -> np.ndarray:
    """Texels [count][4]: noise, and extremes."""
    some = rng.integers(0, 256, (count, 4))
    return np.where(rng.random((count, 4)) < 0.3, rng.choice((0, 255), (count, 4)), some)


def filtered(corners, fs, ft) -> np.ndarray:
    """The three-point filter: corners [n][4][channels], fractions [n]."""
    c00, c10, c01, c11 = (corners[:, k] for k in range(4))
    fs, ft = fs[:, None], ft[:, None]
    lower = c00 + (fs * (c10 - c00) + ft * (c01 - c00) + 16 >> 5)
    upper = c11 + ((32 - fs) * (c01 - c11) + (32 - ft) * (c10 - c11) + 16 >> 5)
    return np.where(fs + ft < 32, lower, upper)


@dataclass
class Tile:
    """A random decoded tile that wraps: ``texels`` [rows][columns][4]."""

    texels: np.ndarray
    has_quads: bool

    @property
    def bits(self) -> tuple[int, int]:
        rows, columns = self.texels.shape[:2]
        return columns.bit_length() - 1, rows.bit_length() - 1

    def corners(self, s, t) -> np.ndarray:
        """c00, c10, c01, c11 at coordinates: [n][4][4]."""
        rows, columns = self.texels.shape[:2]
        x, y = s >> 5, t >> 5
        return np.stack([self.texels[(y + j) % rows, (x + i) % columns]
                         for j in (0, 1) for i in (0, 1)], 1).astype(np.int64)

    def decoded(self) -> tuple[str, dict[str, int], dict[str, bytes]]:
        """struct tx_decoded: name, values, blocks."""
        rows, columns = self.texels.shape[:2]
        y, x = np.divmod(np.arange(rows * columns), columns)
        blocks = {"texels": pixels(self.texels)}
        if self.has_quads:
            blocks["quads"] = quad_bytes(self.corners(32 * x, 32 * y))
        bits = self.bits
        return "tx_decoded", dict(
            mask_s=columns - 1 << 5, mask_t=rows - 1 << 5, columns_bits=bits[0],
            rows_bits=bits[1]) | ({} if self.has_quads else {"quads": 0}), blocks


def tile(rng, has_quads: bool) -> Tile:
    columns, rows = (1 << int(rng.integers(0, 6)) for _ in range(2))
    if rng.random() < 0.1:
        columns, rows = (512, 1) if rng.random() < 0.5 else (1, 256)
    return Tile(any_texels(rng, rows * columns).reshape(rows, columns, 4), has_quads)


def threepoint(rng, count: int) -> Example:
    st, ground = coordinates(rng, count), tile(rng, True)
    drawn = filtered(ground.corners(*st.T), *(st.T & 31))
    return Example("tx_threepoint", pairs(st), pixels(drawn), count, *ground.decoded())


def threepoint_16(rng, count: int) -> Example:
    made = threepoint(rng, count)
    made.expected = packed(np.frombuffer(made.expected, np.uint8))
    return made


def average(rng, count: int) -> Example:
    st, ground = coordinates(rng, count), tile(rng, True)
    st[rng.random(count) < 0.5] = st[0] & 0xFFE0 | 16
    corners, (fs, ft) = ground.corners(*st.T), st.T & 31
    drawn = np.where((fs == 16)[:, None] & (ft == 16)[:, None], corners.sum(1) + 2 >> 2,
                     filtered(corners, fs, ft))
    return Example("tx_average", pairs(st), pixels(drawn), count, *ground.decoded())


def point(rng, count: int) -> Example:
    st, ground = coordinates(rng, count), tile(rng, False)
    return Example("tx_point", pairs(st), pixels(ground.corners(*st.T)[:, 0]), count,
                   *ground.decoded())


def packed(texels: np.ndarray) -> bytes:
    """5/5/5/1 words of texels [n][4]."""
    r, g, b, a = texels.reshape(-1, 4).astype(np.int64).T
    return words((r >> 3) << 11 | (g >> 3) << 6 | (b >> 3) << 1 | a >> 7)


def point_16(rng, count: int) -> Example:
    st, ground = coordinates(rng, count), tile(rng, False)
    struct, values, _ = ground.decoded()
    return Example("tx_point_16", pairs(st), packed(ground.corners(*st.T)[:, 0]), count,
                   struct, values, {"texels": packed(ground.texels)})


def store_16(rng, count: int) -> Example:
    texels = any_texels(rng, count)
    return Example("tx_store_16", pixels(texels), packed(texels), count)


def reciprocal(w: int) -> tuple[int, int]:
    """The hardware's reciprocal of a w above 0, and the shifts that bring its bit 14 to one."""
    shifts = 15 - w.bit_length()
    n = (w << shifts) & 0x3FFF
    table = [round((1 << 20) / (64 + i)) - (i == 6) for i in range(65)]
    i, f = n >> 8, n & 255
    return table[i] + ((table[i + 1] - table[i]) * f * 4 >> 10), shifts


@cache
def reciprocals() -> bytes:
    """What tx_divide_table_make makes."""
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
    return (int(signed(value, 17)), False) if -65536 <= value < 65536 else \
        ((65535, -65536)[s < 0], True)


def in_range(value: int) -> int:
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


def divide(rng, count: int, kernel: str = "tx_divide") -> Example:
    start, step = any_iterators(rng, count)
    if kernel == "tx_divide_inside" or count == 256:
        ends = rng.integers([-1 << 28, -1 << 28, 1 << 29], [1 << 28, 1 << 28, 1 << 31], (2, 3))
        start, step = ends[0], (ends[1] - ends[0]) // count
    st = [[in_range(divided(int(c), int(w))[0]) for c in (s, t)]
          for s, t, w in walked(start, step, count) >> 16]
    return Example(kernel, longs(start), pairs(np.array(st)), count, "tx_division",
                   dict(zip("stw", step)), {"reciprocals": reciprocals()})


def divide_inside(rng, count: int) -> Example:
    return divide(rng, count, "tx_divide_inside")


def reciprocal_table(rng, count: int) -> Example:
    return Example("tx_reciprocals", bytes(4), reciprocals(), count)


def axis(rng, is_plain: bool) -> tuple[int, int, int, int]:
    """Clamp, shift as the tile has it, low, high."""
    if is_plain:
        return 0, 0, int(rng.integers(4096)), 4095
    low, high = (int(n) for n in rng.integers(0, 4096, 2))
    if rng.random() < 0.7:
        low, high = min(low, high) & ~3, max(low, high) & ~3
    return int(rng.integers(2)), int(rng.integers(16)), low, high


def related(c: int, clamp: int, shift: int, low: int, high: int) -> int:
    """The coordinate c (16 bits signed) relative to the tile, modulo 2^16."""
    c = c >> shift if shift <= 10 else int(signed(c << 16 - shift, 16))
    is_over = c >> 3 >= high
    c -= 8 * low
    if clamp and is_over:
        return 32 * ((high >> 2) - (low >> 2) & 0x3FF)
    return 0 if clamp and c < 0 else c & 0xFFFF


def axis_bytes(clamp: int, shift: int, low: int, high: int) -> list[int]:
    """struct tx_axis_range."""
    return list(layout.load().struct("tx_axis_range").pack(
        shift=shift if shift <= 10 else shift - 16, clamp=clamp, low=8 * low, high=8 * high,
        last=32 * ((high >> 2) - (low >> 2) & 0x3FF)))


def tiled(rng, count: int, kernel: str = "tx_tile") -> Example:
    st = coordinates(rng, count)
    axes = [axis(rng, kernel == "tx_tile_plain") for _ in "st"]
    for k, (_, shift, low, high) in enumerate(axes):  # what stands on the borders
        border = 8 * rng.choice((low, high), count) + rng.integers(-2, 3, count)
        st[:, k] = np.where(rng.random(count) < 0.3, border & 0xFFFF, st[:, k])
    found = [[related(int(c), *a) for c, a in zip(row, axes)] for row in signed(st, 16)]
    return Example(kernel, pairs(st), pairs(np.array(found)), count, "tx_axes",
                   dict(zip("st", (axis_bytes(*a) for a in axes))))


def tiled_plain(rng, count: int) -> Example:
    return tiled(rng, count, "tx_tile_plain")


def combined(a, b, c, d) -> np.ndarray:
    """The combiner's clamped result, of plain numbers."""
    value = (a - b) * c + 256 * d + 128 >> 8 & 0x1FF
    return np.where(value < 256, value, np.where(value < 384, 255, 0))


def lerp(rng, count: int) -> Example:
    first, second = any_texels(rng, count), any_texels(rng, count)
    fractions = rng.integers(-256 if rng.random() < 0.7 and count != 256 else 0, 256, count)
    step = 0 if rng.random() < 0.3 and count != 256 else 2
    fractions = np.where(rng.random(count) < 0.2, 0, fractions)
    used = fractions[np.arange(count) * step // 2][:, None]
    return Example("tx_lerp", pixels(first), pixels(combined(second, first, used, first)), count,
                   "tx_blend", {"fraction_step": step},
                   {"other": pixels(second), "fractions": words(fractions)})


def modulate(rng, count: int) -> Example:
    first, other = any_texels(rng, count), any_texels(rng, count)
    step = 0 if rng.random() < 0.3 and count != 256 else 4
    found = first * other[np.arange(count) * step // 4] + 128 >> 8
    return Example("tx_modulate", pixels(first), pixels(found), count, "tx_modulation",
                   {"step": step}, {"other": pixels(other)})


def mapped(rng, count: int) -> Example:
    texels, tables = any_texels(rng, count), rng.integers(0, 256, (4, 256))
    return Example("tx_map", pixels(texels), pixels(tables[np.arange(4), texels]), count,
                   table=pixels(tables))


def widen(rng, count: int) -> Example:
    texels = any_texels(rng, count)
    return Example("tx_widen", pixels(texels), words(texels), count)


def narrow(rng, count: int) -> Example:
    numbers = rng.integers(-128, 384, (count, 4))
    clamped = np.where(numbers < 0, 0, np.where(numbers > 255, 255, numbers))
    return Example("tx_narrow", words(numbers), pixels(clamped), count)


def combine(rng, count: int) -> Example:
    inputs, steps, used = {}, {}, []
    for name in "abcd":
        numbers = rng.integers(-128, 384, (count, 4))
        if rng.random() < 0.3:
            numbers = rng.integers(-256, 256, (count, 4))
        step = 0 if rng.random() < 0.3 and count != 256 else 8
        inputs[name], steps[f"{name}_step"] = words(numbers), step
        used.append(numbers[np.arange(count) * step // 8, 0])
    a, b, c, d = used
    value = (a - b) * signed(c, 9) + 256 * d + 128 >> 8 & 0x1FF
    found = np.where(value >> 7 == 3, value - 512, value)
    return Example("tx_combine", bytes(4), words(found), count, "tx_combination", steps, inputs,
                   stride=8)


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
        """struct tx_levels."""
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
    return Example("tx_levels", bytes(4), mode.table(), count, "tx_level_modes", vars(mode))


def lod_apart(rng, count: int) -> Example:
    return lod(rng, count, 1)


def lod(rng, count: int, apart: int = 0) -> Example:
    start, step = any_iterators(rng, count)
    spread = 1 << int(rng.integers(12, 28))
    x, y = rng.integers(-spread, spread, (2, 3))
    if rng.random() < 0.5:
        x = step = step & ~31
    if count == 256:
        ends = rng.integers([-1 << 28, -1 << 28, 1 << 29], [1 << 28, 1 << 28, 1 << 31], (2, 3))
        start, step = ends[0], (ends[1] - ends[0]) // count
        x, y = step, step[[1, 0, 2]]
        step = step & ~31 | apart
    mode, st, blendings = any_level(rng), [], []
    for point in walked(start, step, count):
        gradients = x & ~31, y & ~0x7FFF
        around = [[divided(int(c), int(q[2])) for c in q[:2]] for q in (
            signed(point + g, 32) >> 16 for g in (np.zeros(3, np.int64), *gradients))]
        st.append([in_range(value) for value, _ in around[0]])
        changes = [q[k][0] - around[0][k][0] for q in around[1:] for k in (0, 1)]
        is_far = any(overflows for q in around for _, overflows in q)
        longest = None if is_far else max(d if d >= 0 else ~d for d in changes)
        first, second, fraction = mode.blending(longest)
        blendings.append(first << 24 | second << 16 | fraction & 0xFFFF)
    values = dict(zip("stw", step)) | {f"{name}_{axis}": n for name, g in (("x", x), ("y", y))
                                       for axis, n in zip("stw", g)}
    return Example("tx_lod", longs(start), pairs(np.array(st)), count, "tx_detail", values,
                   {"reciprocals": reciprocals(), "levels": mode.table()},
                   more={"blendings": longs(blendings)})


#: Pass to the maker of its examples.
MAKERS: dict[str, Callable[..., Example]] = {
    "tx_walk": walk, "tx_threepoint": threepoint,
    "tx_threepoint_16": threepoint_16, "tx_average": average, "tx_point": point,
    "tx_point_16": point_16, "tx_store_16": store_16, "tx_divide": divide,
    "tx_divide_inside": divide_inside, "tx_tile": tiled, "tx_tile_plain": tiled_plain,
    "tx_lerp": lerp, "tx_modulate": modulate, "tx_map": mapped, "tx_widen": widen,
    "tx_combine": combine, "tx_narrow": narrow, "tx_lod": lod, "tx_lod_apart": lod_apart,
    "tx_quads": quads, "tx_reciprocals": reciprocal_table, "tx_levels": levels}
#: Tables, made by C alone.
IN_C_ALONE = ("tx_quads", "tx_reciprocals", "tx_levels")
#: Another form, or other input, of a pass: beside it there is no C.
FORMS = {"tx_divide_inside": "tx_divide_inside", "tx_tile_plain": "tx_tile",
         "tx_lod_apart": "tx_lod"}
