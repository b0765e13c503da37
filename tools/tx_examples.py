"""Random input of the texture engine's passes, and what must come out of each.

The expected output is worked out here pixel by pixel from the rules (the coordinate steps,
filter, divide, combiner), in whatever way is plainest: neither the C nor the assembly is
asked. The bench measures one example of each pass, the tests call many.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from . import layout

EDGES_16 = (0, 1, 31, 32, 0x7FFF, 0x8000, 0xFFFF, 0xFFE0)


@dataclass
class Example:
    """One call: bytes in and out, the struct of constants; ``blocks`` are what its fields
    point at."""

    kernel: str
    source: bytes
    expected: bytes
    count: int
    struct: str = ""
    values: dict[str, int] = field(default_factory=dict)
    blocks: dict[str, bytes] = field(default_factory=dict)
    title: str = ""


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


#: Pass to the maker of its examples. Those in C alone are called tx_..._c.
MAKERS: dict[str, Callable[..., Example]] = {
    "tx_walk": walk, "tx_threepoint": threepoint, "tx_quads": quads}
IN_C_ALONE = ("tx_quads",)


def struct_bytes(example: Example) -> tuple[layout.Struct, dict[str, int]]:
    """The struct of constants and its values modulo 2^32 (those that point come later)."""
    shape = layout.load().struct(example.struct)
    return shape, {name: int(value) % (1 << 8 * shape.fields[name]["size"]) if
                   not shape.fields[name]["signed"] else int(value)
                   for name, value in example.values.items()}
