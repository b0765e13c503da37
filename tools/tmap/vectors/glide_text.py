"""Reference data of Glide's texture unit: its commands, and the program's operations."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import M32
from tmap.glide.registers import NCC_REGISTERS, ncc_of
from tmap.glide.state import UNIT_MEMORY, Ncc
from tmap.vectors import vector_text
from tmap.vectors.vector_file import Operations
from tmap.vectors.vector_text import DECIMAL, HEX, Line, Shape, check_longs, xorshift

SHAPES = {
    "texrand": Shape((DECIMAL,)),  # seed
    "palrand": Shape((DECIMAL,)),
    "nccrand": Shape((DECIMAL,)),
    "regs": Shape((HEX,) * 4),  # textureMode tLOD tDetail texBaseAddr
    "grad": Shape((DECIMAL,) * 4),  # dsdx dtdx dsdy dtdy
    "pix": Shape((DECIMAL,) * 3 + (HEX, DECIMAL, DECIMAL), (HEX,), (M32,)),  # s t w other x y
}

#: The operation of each command, without the prefix VECTOR_GLIDE_.
OPERATIONS = {"texrand": "RANDOM", "palrand": "PALETTE_RANDOM", "nccrand": "NCC_RANDOM",
              "regs": "REGISTERS", "grad": "GRADIENTS", "pix": "PIXEL"}

PERSPECTIVE = 1  # bit of textureMode
#: A register's bits that have a meaning.
REGISTER_BITS = {"textureMode": M32, "tLOD": (1 << 23) - 1, "tDetail": (1 << 17) - 1,
                 "texBaseAddr": (1 << 29) - 1}
FORMATS = (*range(6), *range(8, 15))
FACTORS = range(6)
#: Prefix of the names of Voodoo 2 files, whose filter weights have 8 bits instead of 4.
WIDE_PREFIX = "tmu2"
COLOUR_BITS = 27  # of an NCC register of I or Q


def check_registers(words: tuple[int, ...], place: str) -> None:
    """Refuses registers that a unit cannot take."""
    for (name, bits), word in zip(REGISTER_BITS.items(), words, strict=True):
        if not 0 <= word <= M32:
            raise UserError(f"{place}: {name}: {word:x} does not fit into 32 bits")
        if word & ~bits:
            raise UserError(f"{place}: {name}: the bits {word & ~bits:x} stand for nothing")
    mode = words[0]
    if mode >> 8 & 15 not in FORMATS:
        raise UserError(f"{place}: textureMode: there is no format {mode >> 8 & 15}")
    for name, factor in (("rgb", mode >> 14 & 7), ("alpha", mode >> 23 & 7)):
        if factor not in FACTORS:
            raise UserError(f"{place}: textureMode: {name}: there is no factor {factor}")


def read(path: str | Path) -> Iterator[Line]:
    """Reads the lines of a file."""
    return vector_text.read(path, SHAPES)


def random_memory(seed: int) -> np.ndarray:
    """Returns a unit's texture memory filled with random numbers, uint8."""
    return np.frombuffer(xorshift(seed, UNIT_MEMORY // 4).astype("<u4").tobytes(), np.uint8)


def random_palette(seed: int) -> np.ndarray:
    """Returns a random palette, int64 [256, 3]."""
    values = xorshift(seed, 256).astype(np.int64)
    return np.stack([values >> shift & 255 for shift in (16, 8, 0)], -1)


def random_ncc(seed: int) -> list[Ncc]:
    """Returns both NCC tables with random registers."""
    words = xorshift(seed, 2 * NCC_REGISTERS).astype(np.int64).reshape(2, NCC_REGISTERS)
    words[:, 4:] &= (1 << COLOUR_BITS) - 1
    return [ncc_of(table) for table in words]


class GlideLines:
    """Adds the lines of a file. Logarithms, and quotients under perspective, may be rounded
    differently from the reference."""

    SHAPES = SHAPES
    ALLOWED = {"without perspective": 2, "with perspective": 5}

    def __init__(self, operations: Operations, path: Path) -> None:
        self.operations = operations
        self.mode = 0
        operations.add("GLIDE_RESET", 8 if path.name.startswith(WIDE_PREFIX) else 4)

    def kind(self) -> str:
        """Returns the kind of question, by textureMode."""
        return "with perspective" if self.mode & PERSPECTIVE else "without perspective"

    def add(self, line: Line, place: str) -> None:
        """Adds the operation of one line."""
        if line.command == "regs":
            check_registers(line.arguments, place)
            self.mode = line.arguments[0]
        check_longs(line.arguments, place)
        self.operations.add(f"GLIDE_{OPERATIONS[line.command]}", *line.arguments)
