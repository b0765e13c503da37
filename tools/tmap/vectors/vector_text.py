"""The text of reference data: one command a line, questions with their expected answers.

A file is plain text or gzipped. ``#`` starts a comment line; a line with `` = `` is a question.
State persists from line to line; the caller keeps it.
"""

import gzip
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import M32

DECIMAL, HEX = 10, 16


@dataclass(frozen=True)
class Shape:
    """The form of a command's line. ``bases``: of each argument; if ``many``, of each argument in a
    group, and the line has one or more groups. ``answers``: bases of the expected answer; empty:
    not a question. ``masks``: the bits of each number of the answer that are compared; None: it is
    not compared. ``names``: instead of all these; arguments are pairs of one of the names and a
    decimal value."""

    bases: tuple[int, ...] = ()
    answers: tuple[int, ...] = ()
    masks: tuple[int | None, ...] = ()
    many: bool = False
    names: tuple[str, ...] = ()


@dataclass(frozen=True)
class Line:
    """One command. ``arguments``: integers, or (name, value) pairs. ``expected``: the answer's
    integers, empty if the line is not a question."""

    number: int
    command: str
    arguments: tuple
    expected: tuple[int, ...]


def integers(texts: list[str], bases: tuple[int, ...], place: str) -> tuple[int, ...]:
    """Converts texts to integers with these bases."""
    values = []
    for text, base in zip(texts, bases, strict=True):
        try:
            values.append(int(text, base))
        except ValueError:
            kind = "decimal" if base == DECIMAL else "hexadecimal"
            raise UserError(f"{place}: {text!r} is not a {kind} number") from None
    return tuple(values)


def pairs(texts: list[str], names: tuple[str, ...], place: str) -> tuple[tuple[str, int], ...]:
    """Converts texts to pairs of a name and a value."""
    if not texts or len(texts) % 2:
        raise UserError(f"{place}: pairs of name and value expected")
    for name in texts[::2]:
        if name not in names:
            raise UserError(f"{place}: there is no {name!r}")
    return tuple(zip(texts[::2], integers(texts[1::2], (DECIMAL,) * (len(texts) // 2), place)))


def parse_line(text: str, number: int, shapes: dict[str, Shape], place: str) -> Line:
    """Parses a line with a command."""
    question, equals, answer = text.partition(" = ")
    command, *texts = question.split()
    shape = shapes.get(command)
    if shape is None:
        raise UserError(f"{place}: there is no command {command!r}")
    place = f"{place}: {command}"
    bases = shape.bases
    if shape.many and texts and len(texts) % len(bases) == 0:
        bases *= len(texts) // len(bases)
    answers = answer.split()
    if not shape.names and len(texts) != len(bases):
        raise UserError(f"{place}: {len(bases)} arguments expected, {len(texts)} found")
    if len(answers) != len(shape.answers) or bool(equals) != bool(shape.answers):
        raise UserError(f"{place}: an answer of {len(shape.answers)} numbers expected, "
                        f"{len(answers)} found")
    arguments = pairs(texts, shape.names, place) if shape.names else integers(texts, bases, place)
    return Line(number, command, arguments, integers(answers, shape.answers, place))


def read(path: str | Path, shapes: dict[str, Shape]) -> Iterator[Line]:
    """Yields the commands of a file in order; ``shapes``: all commands allowed. UserError names the
    file and the line."""
    path = Path(path)
    try:
        data = path.read_bytes()
        text = (gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data).decode("ascii")
    except (OSError, EOFError, zlib.error) as error:
        reason = getattr(error, "strerror", None) or error
        raise UserError(f"{path}: cannot be read: {reason}") from None
    except UnicodeDecodeError:
        raise UserError(f"{path}: not ASCII text") from None
    for number, line in enumerate(text.splitlines(), 1):
        if line.strip() and not line.startswith("#"):
            yield parse_line(line, number, shapes, f"{path}:{number}")


def check_range(values: Iterable[int], bits: Iterable[tuple[str, int]], place: str) -> None:
    """Refuses a value that does not fit its unsigned field, (name, bits)."""
    for value, (name, width) in zip(values, bits, strict=True):
        if not 0 <= value < 1 << width:
            raise UserError(f"{place}: {name}: {value} is not within 0 to {(1 << width) - 1}")


def check_longs(values: Iterable[int], place: str) -> None:
    """Refuses a value that does not fit 32 bits, signed or not."""
    for value in values:
        if not -1 << 31 <= value < 1 << 32:
            raise UserError(f"{place}: {value} does not fit into 32 bits")


def xorshift_step(x: int) -> int:
    """Returns the next number of xorshift32."""
    x ^= x << 13 & M32
    x ^= x >> 17
    return x ^ x << 5 & M32


def after(basis: list[int], x: int) -> int:
    """Returns x after the steps of a basis, which has the result for each bit."""
    result = 0
    for bit, becomes in enumerate(basis):
        if x >> bit & 1:
            result ^= becomes
    return result


@cache
def doublings(times: int) -> list[int]:
    """Returns the basis of 2^times steps."""
    if not times:
        return [xorshift_step(1 << bit) for bit in range(32)]
    half = doublings(times - 1)
    return [after(half, becomes) for becomes in half]


@cache
def jumps(times: int) -> np.ndarray:
    """Returns, for each byte of a number, the lowest first, and each value of that byte, the result
    of 2^times steps; uint32 [4][256]. Steps are linear: a number's result is the exclusive or of
    its bytes' results."""
    basis = doublings(times)
    return np.array([[after(basis[8 * n:8 * n + 8], value) for value in range(256)]
                     for n in range(4)], np.uint32)


def xorshift(seed: int, count: int) -> np.ndarray:
    """Returns the ``count`` numbers after a seed, uint32. The ``rand`` commands fill memory with
    them."""
    values = np.array([xorshift_step(seed)], np.uint32)
    for times in range((count - 1).bit_length()):
        parts = (jump[values >> np.uint32(8 * n) & np.uint32(255)]
                 for n, jump in enumerate(jumps(times)))
        values = np.concatenate([values, np.bitwise_xor.reduce(list(parts))])
    return values[:count]
