"""The texture unit's model run over the text of reference data."""

from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tools.tmu import vector_text
from tools.tmu.chain import Point, pixel
from tools.tmu.lod import base
from tools.tmu.registers import modes_of
from tools.tmu.state import Modes, Unit, packed, unpacked
from tools.vector_text import Line

FOLDER = Path(__file__).parent / "vectors"


class Question(NamedTuple):
    """A pixel that was asked for: the unit as it stood, and the answer."""

    line: Line
    unit: Unit
    point: Point
    other: np.ndarray
    answer: int


def questions(path: Path, fraction_bits: int):
    """The questions of a file, answered by the model, one after another."""
    unit, gradients = Unit(), (0, 0, 0, 0)
    for line in vector_text.read(path):
        values = line.arguments
        if line.command == "texrand":
            unit.memory = vector_text.random_memory(*values)
        elif line.command == "palrand":
            unit.palette = vector_text.random_palette(*values)
        elif line.command == "nccrand":
            unit.ncc = vector_text.random_ncc(*values)
        elif line.command == "regs":
            unit.modes = replace(modes_of(*values, fraction_bits), table_quotients=1)
        elif line.command == "grad":
            gradients = values
        else:
            s, t, w, colour, x, y = values
            point, other = Point(s, t, w, int(base(*gradients)), x, y), unpacked(colour)
            now = Unit(unit.modes, unit.memory, unit.palette, unit.ncc)
            answer = int(packed(pixel(now, point, other)))
            yield Question(line, now, point, other, answer)


def only(level: int, linear: int, **others) -> Modes:
    """Modes by which one level alone is drawn; ``linear``: 0 point, 1 bilinear."""
    return Modes(minify=linear, magnify=linear, lod_min=4 * level, lod_max=4 * level, **others)
