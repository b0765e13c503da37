"""The text of reference data: one command a line, questions with their expected answers.

A file is plain text or gzipped. ``#`` starts a comment line; a line with `` = `` is a question.
State persists from line to line: whoever runs the lines keeps it.
"""

import gzip
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from ..errors import UserError

DECIMAL, HEX = 10, 16


@dataclass(frozen=True)
class Shape:
    """What stands in a command's line. ``bases``: of each argument; where ``many``, of each
    group of arguments, of which there is at least one. ``answers``: bases of the expected
    answer; none: not a question."""

    bases: tuple[int, ...]
    answers: tuple[int, ...] = ()
    many: bool = False


FOUR = (HEX,) * 4

SHAPES = {
    "tmemrand": Shape((DECIMAL,)),  # seed
    "tlutrand": Shape((DECIMAL,)),
    "rdramrand": Shape((DECIMAL,)),
    "tmem": Shape((HEX,), many=True),  # address, bytes
    "rdram": Shape((HEX,), many=True),
    "tile": Shape((DECIMAL,) * 18),  # n fmt siz line tmem pal cs ms masks shs ct .. sht sl tl sh th
    "convert": Shape((DECIMAL,) * 6),  # k0 .. k5
    "rdp": Shape((HEX, HEX), many=True),  # pairs of command words
    "tmemhash": Shape((), (HEX,)),
    "fetch": Shape((DECIMAL,) * 3, FOUR),  # tile s t = r g b a
    "sample": Shape((DECIMAL,) * 4, FOUR),  # tile s t cycle = r g b a
    "sample2": Shape((DECIMAL,) * 4, FOUR * 2),  # t0 t1 s t = both cycles' r g b a
    "persp": Shape((DECIMAL,) * 3, (HEX, HEX, DECIMAL, DECIMAL)),  # s t w = raw_s raw_t s t
    # s t w dsdx dtdx dwdx dsdy dtdy dwdy prim max_level min_level
    #     = s t tile0 tile1 lodfrac texel0 texel1
    "pix2": Shape((DECIMAL,) * 12, (DECIMAL,) * 4 + (HEX,) + FOUR * 2),
    "copy": Shape((DECIMAL,) * 3, (HEX, HEX)),  # tile s t = hi lo
}

#: Names in a ``mode`` line, whose arguments are pairs (name, decimal value).
MODES = ("persp_tex_en", "detail_tex_en", "sharpen_tex_en", "tex_lod_en", "en_tlut", "tlut_type",
         "sample_type", "mid_texel", "bi_lerp0", "bi_lerp1", "convert_one", "cycle_type")


@dataclass(frozen=True)
class Line:
    """One command. ``arguments``: integers; of ``mode`` (name, value) pairs. ``expected``: the
    answer's integers, empty where nothing is asked."""

    number: int
    command: str
    arguments: tuple
    expected: tuple[int, ...]


def integers(texts: list[str], bases: tuple[int, ...], place: str) -> tuple[int, ...]:
    """The texts as integers of the bases."""
    values = []
    for text, base in zip(texts, bases, strict=True):
        try:
            values.append(int(text, base))
        except ValueError:
            kind = "decimal" if base == DECIMAL else "hexadecimal"
            raise UserError(f"{place}: {text!r} is not a {kind} number") from None
    return tuple(values)


def modes(texts: list[str], place: str) -> tuple[tuple[str, int], ...]:
    """A ``mode`` line's pairs."""
    if not texts or len(texts) % 2:
        raise UserError(f"{place}: mode: pairs of name and value expected")
    for name in texts[::2]:
        if name not in MODES:
            raise UserError(f"{place}: mode: there is no mode {name!r}")
    return tuple(zip(texts[::2], integers(texts[1::2], (DECIMAL,) * (len(texts) // 2), place)))


def parse_line(text: str, number: int, place: str,
               shapes: Mapping[str, Shape] = SHAPES) -> Line:
    """One line that holds a command of ``shapes``; only the N64's know ``mode``."""
    question, equals, answer = text.partition(" = ")
    command, *texts = question.split()
    if command == "mode" and shapes is SHAPES:
        if equals:
            raise UserError(f"{place}: mode has no answer")
        return Line(number, command, modes(texts, place), ())
    shape = shapes.get(command)
    if shape is None:
        raise UserError(f"{place}: there is no command {command!r}")
    bases = shape.bases
    if shape.many and texts and len(texts) % len(bases) == 0:
        bases *= len(texts) // len(bases)
    answers = answer.split()
    if len(texts) != len(bases):
        raise UserError(f"{place}: {command}: {len(bases)} arguments expected, "
                        f"{len(texts)} found")
    if len(answers) != len(shape.answers) or bool(equals) != bool(shape.answers):
        raise UserError(f"{place}: {command}: an answer of {len(shape.answers)} numbers "
                        f"expected, {len(answers)} found")
    return Line(number, command, integers(texts, bases, place),
                integers(answers, shape.answers, place))


def read(path: str | Path, shapes: Mapping[str, Shape] = SHAPES) -> Iterator[Line]:
    """The commands of a file in order; UserError names the file and the line."""
    path = Path(path)
    try:
        data = path.read_bytes()
        text = (gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data).decode("ascii")
    except (OSError, EOFError, zlib.error) as error:
        raise UserError(f"{path}: cannot be read: {error}") from None
    except UnicodeDecodeError:
        raise UserError(f"{path}: not ASCII text") from None
    for number, line in enumerate(text.splitlines(), 1):
        if line.strip() and not line.startswith("#"):
            yield parse_line(line, number, f"{path}:{number}", shapes)


def xorshift_step(x: int) -> int:
    """The next number of xorshift32."""
    x ^= x << 13 & 0xFFFFFFFF
    x ^= x >> 17
    return x ^ x << 5 & 0xFFFFFFFF


def after(basis: list[int], x: int) -> int:
    """x after the steps that a basis stands for: what each bit becomes."""
    result = 0
    for bit, becomes in enumerate(basis):
        if x >> bit & 1:
            result ^= becomes
    return result


@cache
def doublings(times: int) -> list[int]:
    """The basis of 2^times steps."""
    if not times:
        return [xorshift_step(1 << bit) for bit in range(32)]
    half = doublings(times - 1)
    return [after(half, becomes) for becomes in half]


def xorshift(seed: int, count: int) -> np.ndarray:
    """The ``count`` numbers that follow a seed, uint32: what the ``rand`` commands fill with."""
    values = np.array([xorshift_step(seed)], np.uint32)
    for times in range((count - 1).bit_length()):
        ahead = np.zeros_like(values)
        for bit, becomes in enumerate(doublings(times)):
            ahead ^= (values >> np.uint32(bit) & np.uint32(1)) * np.uint32(becomes)
        values = np.concatenate([values, ahead])
    return values[:count]
