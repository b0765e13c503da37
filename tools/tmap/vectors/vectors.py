"""``tmap vectors``: checks the engines in C, on the emulated machine, against reference data.

The lines of all files become operations of the program ``vectors``, which runs them in one boot.
Its answers are compared here, number by number. The commands of a file determine its engine.
"""

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import M32
from tmap.vectors import vector_text
from tmap.vectors.glide_text import GlideLines
from tmap.vectors.n64_text import N64Lines
from tmap.vectors.vector_file import Operations, ask
from tmap.vectors.vector_text import Line, Shape

#: Most bytes of operations that fit the machine's free memory.
FILE_BYTES = 6_000_000
SHOWN = 5  # wrong lines of a file that are printed


class Lines(Protocol):
    """Adds the lines of a file, in order, for one engine."""

    SHAPES: dict[str, Shape]
    #: Kind of question to the number of answers in 1,000 that may differ.
    ALLOWED: dict[str, int]

    def __init__(self, operations: Operations, path: Path) -> None: ...

    def add(self, line: Line, place: str) -> None:
        """Adds the operations of a line; messages begin with ``place``."""

    def kind(self) -> str:
        """Returns the kind of the question that was added last."""


ENGINES: tuple[type[Lines], ...] = (N64Lines, GlideLines)
SHAPES = {name: shape for engine in ENGINES for name, shape in engine.SHAPES.items()}


@dataclass
class File:
    """A file of reference data: its questions with their kinds, and after ``check`` the wrong ones
    with the answers found."""

    path: Path
    allowed: dict[str, int]
    questions: list[tuple[str, Line]]
    wrong: list[tuple[str, Line, tuple[int, ...]]] = field(default_factory=list)

    def count(self, kind: str) -> tuple[int, int]:
        """Returns (questions, wrong ones) of a kind."""
        return (sum(of == kind for of, _ in self.questions),
                sum(of == kind for of, _, _ in self.wrong))

    def passes(self) -> bool:
        """Returns True if no kind has more wrong answers than allowed."""
        counts = ((allowed, *self.count(kind)) for kind, allowed in self.allowed.items())
        return all(1000 * wrong <= allowed * questions for allowed, questions, wrong in counts)


def engine_of(line: Line) -> type[Lines]:
    """Returns the engine that a command is for."""
    return next(engine for engine in ENGINES if line.command in engine.SHAPES)


def add_file(operations: Operations, path: Path) -> File:
    """Adds a file's lines to the operations."""
    lines, questions = None, []
    for line in vector_text.read(path, SHAPES):
        place = f"{path}:{line.number}"
        engine = engine_of(line)
        lines = lines or engine(operations, path)
        if not isinstance(lines, engine):
            raise UserError(f"{place}: {line.command}: the lines before are for another engine")
        lines.add(line, f"{place}: {line.command}")
        if line.expected:
            questions.append((lines.kind(), line))
    if not questions:
        raise UserError(f"{path}: asks nothing")
    return File(path, lines.ALLOWED, questions)


def differs(line: Line, found: tuple[int, ...]) -> bool:
    """Returns True if any of the compared bits differ."""
    masks = SHAPES[line.command].masks
    return any(mask is not None and (a ^ b) & mask
               for a, b, mask in zip(line.expected, found, masks, strict=True))


def compare(file: File, answers: np.ndarray, at: int) -> int:
    """Compares a file's answers, which begin at ``at``, and notes the wrong ones; returns their
    end."""
    for kind, line in file.questions:
        end = at + len(line.expected)
        found = tuple(int(value) for value in answers[at:end])
        if len(found) != end - at:
            raise UserError(f"vectors: answers end before {file.path}:{line.number}")
        if differs(line, found):
            file.wrong.append((kind, line, found))
        at = end
    return at


def check(paths: list[Path], machine: str = "a1200-fast",
          on_operation: Callable[[int, int], None] | None = None) -> list[File]:
    """Runs every question of the files in one boot. ``on_operation`` is called with (begun,
    all)."""
    operations = Operations()
    files = []
    for path in paths:
        files.append(add_file(operations, path))
        if 4 * len(operations.longs) > FILE_BYTES:
            raise UserError(f"{path}: too much for one boot: {4 * len(operations.longs)} bytes "
                            f"of operations so far, at most {FILE_BYTES}")
    answers = ask(operations, machine, on_operation and (
        lambda begun: on_operation(begun, operations.count)))
    at = 0
    for file in files:
        at = compare(file, answers, at)
    if at != len(answers):
        raise UserError(f"vectors: {len(answers)} numbers of answers instead of {at}")
    return files


def written(line: Line, values: tuple[int, ...]) -> str:
    """Returns an answer in the files' form: decimal, or hexadecimal with as many digits as it
    needs."""
    shape = SHAPES[line.command]
    texts = []
    for value, base, mask in zip(values, shape.answers, shape.masks, strict=True):
        mask = M32 if mask is None else mask
        texts.append(str(value) if base == vector_text.DECIMAL
                     else f"{value & mask:0{(mask.bit_length() + 3) // 4}x}")
    return " ".join(texts)


def asked(line: Line) -> str:
    """Returns a question in the files' form."""
    texts = (str(value) if base == vector_text.DECIMAL else f"{value:x}"
             for value, base in zip(line.arguments, SHAPES[line.command].bases, strict=True))
    return " ".join([line.command, *texts])


def counts(file: File) -> Iterator[str]:
    """Yields the right and wrong answers of each kind, if there are several."""
    for kind in file.allowed if len(file.allowed) > 1 else ():
        questions, wrong = file.count(kind)
        yield f"{kind} {questions - wrong} right, {wrong} wrong"


def report(file: File) -> list[str]:
    """Returns lines on a file: right and wrong answers, and the first wrong questions."""
    lines = ["; ".join([f"{file.path}: {len(file.questions) - len(file.wrong)} right, "
                        f"{len(file.wrong)} wrong", *counts(file)])]
    if file.wrong and file.passes():
        lines[0] += ": no more than may be"
    for _, line, found in file.wrong[:SHOWN]:
        lines.append(f"  line {line.number}: {asked(line)}: expected "
                     f"{written(line, line.expected)}, found {written(line, found)}")
    if len(file.wrong) > SHOWN:
        lines.append(f"  and {len(file.wrong) - SHOWN} more")
    return lines


def command(paths: list[Path], machine: str) -> int:
    """``tmap vectors``: returns 1 if more answers of a file are wrong than allowed."""
    from rich.progress import Progress

    with Progress(transient=True, disable=not sys.stderr.isatty()) as progress:
        task = progress.add_task("vectors", total=None)
        files = check(paths, machine,
                      lambda begun, count: progress.update(task, completed=begun, total=count))
    for file in files:
        print("\n".join(report(file)))
    return 0 if all(file.passes() for file in files) else 1
