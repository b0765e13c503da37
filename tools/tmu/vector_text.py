"""The text of reference data for texture units: commands, questions, and random contents.

Its form is that of tools.tx.vector_text; only the commands are others.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from ..tx import vector_text
from ..tx.vector_text import DECIMAL, HEX, Line, Shape, xorshift
from .registers import NCC_REGISTERS, ncc_of
from .state import UNIT_MEMORY, Ncc

SHAPES = {
    "texrand": Shape((DECIMAL,)),  # seed
    "palrand": Shape((DECIMAL,)),
    "nccrand": Shape((DECIMAL,)),
    "regs": Shape((HEX,) * 4),  # textureMode tLOD tDetail texBaseAddr
    "grad": Shape((DECIMAL,) * 4),  # dsdx dtdx dsdy dtdy
    "pix": Shape((DECIMAL,) * 3 + (HEX, DECIMAL, DECIMAL), (HEX,)),  # s t w other x y = colour
}
COLOUR_BITS = 27  # of a register of I or Q


def read(path: str | Path) -> Iterator[Line]:
    """The commands of a file in order; UserError names the file and the line."""
    return vector_text.read(path, SHAPES)


def random_memory(seed: int) -> np.ndarray:
    """A unit's texture memory, uint8."""
    return np.frombuffer(xorshift(seed, UNIT_MEMORY // 4).astype("<u4").tobytes(), np.uint8)


def random_palette(seed: int) -> np.ndarray:
    """A palette, int64 [256, 3]."""
    values = xorshift(seed, 256).astype(np.int64)
    return np.stack([values >> shift & 255 for shift in (16, 8, 0)], -1)


def random_ncc(seed: int) -> list[Ncc]:
    """Both tables."""
    words = xorshift(seed, 2 * NCC_REGISTERS).astype(np.int64).reshape(2, NCC_REGISTERS)
    words[:, 4:] &= (1 << COLOUR_BITS) - 1
    return [ncc_of(table) for table in words]
