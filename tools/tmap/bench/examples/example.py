"""What the examples of texture units' passes are made of: numbers as bytes, random input.

A maker of examples is a function of a numpy Generator and a count of pixels; of BENCH pixels it
makes what the bench measures, usual rather than any input.
"""

from dataclasses import dataclass, field

import numpy as np

from tmap.base.fixed import signed

BENCH = 256  # pixels of what is measured


@dataclass
class Example:
    """One call: bytes in and out, and the struct of constants, or a table that is them.

    ``blocks`` are what its fields point at, ``more`` what they point at and is written.
    ``align``: of the blocks; ``within``: how far behind a block's first byte its field points.
    ``stride``: bytes from pixel to pixel where the first ones of each alone are written.
    """

    source: bytes
    expected: bytes
    count: int
    struct: str = ""
    values: dict[str, int] = field(default_factory=dict)
    blocks: dict[str, bytes] = field(default_factory=dict)
    more: dict[str, bytes] = field(default_factory=dict)
    table: bytes = b""
    stride: int = 0
    align: int = 4
    within: dict[str, int] = field(default_factory=dict)

    def image(self, before: bytes) -> bytes:
        """The output as it must be, from what its memory held."""
        if not self.stride:
            return self.expected
        out = np.frombuffer(before, np.uint8).reshape(self.count, self.stride).copy()
        written = np.frombuffer(self.expected, np.uint8).reshape(self.count, -1)
        out[:, :written.shape[1]] = written
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


def pixels(channels: np.ndarray) -> bytes:
    """Channels [n][4] as R G B A bytes."""
    return channels.astype(np.uint8).tobytes()


def pair(channels: np.ndarray, high: int, low: int) -> np.ndarray:
    """Two of the channels [n][4] as halves of a long."""
    return channels[:, high] * 65536 + channels[:, low]


def some_coordinates(rng, count: int, edges: tuple[int, ...], part: float) -> np.ndarray:
    """s and t, [count][2], 0 to 65,535: any, and a part of them on edges."""
    some = rng.integers(0, 1 << 16, (count, 2))
    edge = rng.choice(edges, (count, 2))
    return np.where(rng.random((count, 2)) < part, edge, some)


def some_step(rng, count: int, size: int, part: float = 0.3) -> int:
    """Bytes from a pixel's input to the next one's: ``size``, or 0 in a part of examples."""
    return 0 if rng.random() < part and count != BENCH else size


def pairs(st: np.ndarray) -> bytes:
    """s:t longs."""
    return longs((st[:, 0] & 0xFFFF) << 16 | st[:, 1] & 0xFFFF)


def numbered(start, step, count: int) -> np.ndarray:
    """Iterators at each pixel without a limit, [count][len(start)]."""
    return np.asarray(start, np.int64) + np.arange(count)[:, None] * np.asarray(step, np.int64)


def walked(start, step, count: int) -> np.ndarray:
    """The same modulo 2^32 as signed numbers."""
    return signed(numbered(start, step, count))


def any_texels(rng, count: int) -> np.ndarray:
    """Texels [count][4]: noise, and extremes."""
    some = rng.integers(0, 256, (count, 4))
    return np.where(rng.random((count, 4)) < 0.3, rng.choice((0, 255), (count, 4)), some)


def packed(texels: np.ndarray) -> bytes:
    """5/5/5/1 words of texels [n][4]."""
    r, g, b, a = texels.reshape(-1, 4).astype(np.int64).T
    return words((r >> 3) << 11 | (g >> 3) << 6 | (b >> 3) << 1 | a >> 7)


@dataclass
class Map:
    """A random decoded tile or level that wraps: ``texels`` [rows][columns][4]."""

    texels: np.ndarray

    def corners(self, x, y) -> np.ndarray:
        """Texels (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1): [n][4][4]."""
        rows, columns = self.texels.shape[:2]
        return np.stack([self.texels[(y + j) % rows, (x + i) % columns]
                         for j in (0, 1) for i in (0, 1)], 1).astype(np.int64)

    def decoded(self, struct: str, fraction: int,
                to_bytes=None) -> tuple[str, dict[str, int], dict[str, bytes]]:
        """The ``struct`` of it: name, values, blocks. ``fraction``: bits of it in coordinates;
        ``to_bytes``: of its quads, or without."""
        rows, columns = self.texels.shape[:2]
        blocks = {"texels": pixels(self.texels)}
        if to_bytes:
            y, x = np.divmod(np.arange(rows * columns), columns)
            blocks["quads"] = to_bytes(self.corners(x, y))
        return struct, dict(
            mask_s=columns - 1 << fraction, mask_t=rows - 1 << fraction,
            columns_bits=columns.bit_length() - 1, rows_bits=rows.bit_length() - 1,
        ) | ({} if to_bytes else {"quads": 0}), blocks


def any_map(rng, widest: int) -> Map:
    """Of any size, some a column of 256 or a row alone."""
    columns, rows = (1 << int(rng.integers(0, 6)) for _ in range(2))
    if rng.random() < 0.1:
        columns, rows = (widest, 1) if rng.random() < 0.5 else (1, 256)
    return Map(any_texels(rng, rows * columns).reshape(rows, columns, 4))
