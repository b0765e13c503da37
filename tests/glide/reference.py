"""Runs the texture unit's model over the text of reference data; computes rules of the unit with
fractions."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tmap.base.paths import ROOT
from tmap.glide.chain import Point, pixel
from tmap.glide.lod import base
from tmap.glide.registers import modes_of
from tmap.glide.state import Modes, Unit, packed, unpacked
from tmap.vectors import glide_text
from tmap.vectors.vector_text import Line

FOLDER = ROOT / "tests" / "vectors"


class Question(NamedTuple):
    """One pixel of the file: the unit's state at that time, and the answer."""

    line: Line
    unit: Unit
    point: Point
    other: np.ndarray
    answer: int


def questions(path: Path, fraction_bits: int):
    """Yields the questions of a file, answered by the model."""
    unit, gradients = Unit(), (0, 0, 0, 0)
    for line in glide_text.read(path):
        values = line.arguments
        if line.command == "texrand":
            unit.memory = glide_text.random_memory(*values)
        elif line.command == "palrand":
            unit.palette = glide_text.random_palette(*values)
        elif line.command == "nccrand":
            unit.ncc = glide_text.random_ncc(*values)
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
    """Modes that draw from a single level; ``linear``: 0 point, 1 bilinear."""
    return Modes(minify=linear, magnify=linear, lod_min=4 * level, lod_max=4 * level, **others)


def table_quotient(s: int, w: int) -> int:
    """s * 2^30 / w with the reciprocal of the rules, computed with fractions: rounded down, within
    32 bits; 0 if w is 0."""
    if not w:
        return 0
    shift = 32 - abs(w).bit_length()
    place = Fraction((abs(w) << shift) - (1 << 31), 1 << 22)  # 0 to 512, in entries
    i, part = int(place), int(place % 1 * 256)
    entries = [(1 << 31) // (512 + n) for n in (i, i + 1)]
    inverse = (entries[0] * (256 - part) + entries[1] * part) // 256
    value = s * inverse * Fraction(2) ** (shift - 23) * (1 if w > 0 else -1)
    return max(-1 << 31, min(value.numerator // value.denominator, (1 << 31) - 1))
