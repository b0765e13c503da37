"""Bitplanes: which bit of memory is which bit of which pixel.

The leftmost of 8 pixels is a byte's highest bit, a pixel's lowest bit is in plane 0; a row of a
plane is whole longwords, as struct planar_plan (c/screen/planar.h) has it.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Planes:
    """Where bitplanes lie in a block of memory, in bytes; ``width`` and ``rows`` are pixels of
    the screen, ``numbers`` the planes that there are."""

    width: int
    rows: int
    row_pitch: int
    plane_pitch: int
    numbers: tuple[int, ...] = tuple(range(8))

    @classmethod
    def separate(cls, width: int, rows: int, **more) -> "Planes":
        """Each plane a block of its own, behind the one before."""
        return cls(width, rows, width // 8, width // 8 * rows, **more)

    @property
    def lines(self) -> np.ndarray:
        """Offsets of the rows from the first row of plane 0: [plane][row]."""
        return (np.array(self.numbers)[:, None] * self.plane_pitch
                + np.arange(self.rows) * self.row_pitch)

    @property
    def first(self) -> int:
        """Where in the block the first row of plane 0 is; that plane may be none of them."""
        return -int(self.lines.min())

    @property
    def size(self) -> int:
        """Bytes of the block."""
        return self.first + int(self.lines.max()) + self.width // 8

    @property
    def offsets(self) -> np.ndarray:
        """Offsets of all bytes in the block: [plane][row][byte]."""
        return self.first + self.lines[..., None] + np.arange(self.width // 8)

    def put(self, pixels: np.ndarray, block: np.ndarray) -> None:
        """Writes pixels, uint8 [row][x], into the planes; other bytes stay."""
        bits = pixels >> np.array(self.numbers, np.uint8)[:, None, None] & 1
        block[self.offsets] = np.packbits(bits, axis=2)

    def get(self, block: np.ndarray) -> np.ndarray:
        """Pixels out of the planes: the display's view, bits without a plane 0."""
        bits = np.unpackbits(block[self.offsets], axis=2)
        return sum((bits[k] << number for k, number in enumerate(self.numbers)),
                   np.zeros((self.rows, self.width), np.uint8))


def difference(expected: np.ndarray, found: np.ndarray) -> str | None:
    """The first pixel that differs, or None."""
    for y, x in np.argwhere(expected != found)[:1]:
        return f"pixel {x}, {y} is {found[y, x]:#04x}, expected {expected[y, x]:#04x}"
    return None
