"""``tmap vectors``: reference data against the engine in C, on the emulated machine.

The lines of all files go into one file of operations (c/bench/vector_file.h), which the program
``vectors`` runs in one boot; its answers are compared here, number by number.
"""

import sys
import zlib
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .. import emulator, layout
from ..errors import UserError
from . import vector_text
from .vector_text import Line

M32 = (1 << 32) - 1
#: Bytes of operations that fit the machine's memory beside what else is in it.
FILE_BYTES = 6_000_000
SHOWN = 5  # wrong lines of a file that are printed
NINE_BITS = 0x1FF

#: Command to the operation's name behind VECTOR_.
OPERATIONS = {
    "tmemrand": "TMEM_RANDOM", "tlutrand": "TLUT_RANDOM", "rdramrand": "DRAM_RANDOM",
    "tmem": "TMEM", "rdram": "DRAM", "tile": "TILE", "convert": "CONVERT", "rdp": "WORDS",
    "tmemhash": "HASH", "fetch": "FETCH", "sample": "SAMPLE", "sample2": "SAMPLE_BOTH",
    "persp": "DIVIDE", "pix2": "PIXEL", "copy": "COPY"}

#: Name in a ``mode`` line to (field of struct tx_modes, bits).
MODE_FIELDS = {
    "persp_tex_en": ("perspective", 1), "detail_tex_en": ("detail", 1),
    "sharpen_tex_en": ("sharpen", 1), "tex_lod_en": ("lod", 1), "en_tlut": ("tlut", 1),
    "tlut_type": ("tlut_type", 1), "sample_type": ("quad", 1), "mid_texel": ("mid", 1),
    "bi_lerp0": ("filter0", 1), "bi_lerp1": ("filter1", 1), "convert_one": ("convert_one", 1),
    "cycle_type": ("cycle", 2)}

#: A ``tile`` line's fields and their bits.
TILE_BITS = {"n": 3, "fmt": 3, "siz": 2, "line": 9, "tmem": 9, "pal": 4, "cs": 1, "ms": 1,
             "masks": 4, "shs": 4, "ct": 1, "mt": 1, "maskt": 4, "sht": 4, "sl": 12, "tl": 12,
             "sh": 12, "th": 12}

#: Which bits of a question's answer count, a number each; None: it is not compared.
COMPARED = {
    "tmemhash": (M32,), "fetch": (NINE_BITS,) * 4, "sample": (NINE_BITS,) * 4,
    "sample2": (NINE_BITS,) * 8, "persp": (None, None, M32, M32),
    "pix2": (M32,) * 4 + (NINE_BITS,) * 9, "copy": (M32,) * 2}


class Operations:
    """What the program is to do, in the making: big-endian longs."""

    def __init__(self) -> None:
        self.longs: list[int] = []
        self.count = 0
        self.codes = layout.load().constants

    def add(self, name: str, *values: int) -> None:
        """Appends an operation; ``name`` without VECTOR_."""
        if len(values) >= 1 << 16:
            raise UserError(f"an operation of {len(values)} numbers is too long")
        self.longs += [self.codes[f"VECTOR_{name}"] << 16 | len(values),
                       *(value & M32 for value in values)]
        self.count += 1

    def file(self) -> bytes:
        """The file that the program reads."""
        header = layout.load().struct("vector_header")
        body = np.array(self.longs, ">u4").tobytes()
        values = {"magic": self.codes["VECTOR_MAGIC"], "version": self.codes["VECTOR_VERSION"],
                  "size": header.size + len(body), "checksum": 0, "operations_at": header.size,
                  "operations": self.count}
        summed = header.fields["operations_at"]["offset"]
        values["checksum"] = zlib.crc32(header.pack(**values)[summed:] + body)
        return header.pack(**values) + body


def ask(operations: Operations, machine: str = "a1200-fast", on_operation=None) -> np.ndarray:
    """Runs the operations in one boot; returns all answers, int32. ``on_operation`` is told
    how many operations were begun."""
    def progress(output: str) -> None:
        lines = [line for line in output.splitlines() if line.startswith("operation ")]
        if on_operation and lines and lines[-1].split()[1].isdecimal():
            on_operation(int(lines[-1].split()[1]))

    with emulator.workspace() as directory:
        done = emulator.run("vectors", "tx.questions tx.answers",
                            {"tx.questions": operations.file()}, machine, directory, progress)
        if done.code:
            raise UserError(f"vectors: {emulator.last_words(done.output)}")
        return np.frombuffer((done.directory / "tx.answers").read_bytes(), ">i4").astype(np.int32)


def check_range(values: Iterable[int], bits: Iterable[tuple[str, int]], place: str) -> None:
    """Every value must fit its unsigned field, (name, bits)."""
    for value, (name, width) in zip(values, bits, strict=True):
        if not 0 <= value < 1 << width:
            raise UserError(f"{place}: {name}: {value} is not within 0 to {(1 << width) - 1}")


def check_poke(line: Line, size: int, place: str) -> None:
    """A line ``tmem`` or ``rdram``: bytes, within the memory."""
    address, *values = line.arguments
    check_range(values, [("a byte", 8)] * len(values), f"{place}: {line.command}")
    if not 0 <= address <= address + len(values) <= size:
        raise UserError(f"{place}: {line.command}: {len(values)} bytes from {address:x} on are "
                        f"not within {size:x} bytes")


def add_line(operations: Operations, line: Line, place: str) -> None:
    """The operations of one line."""
    where = f"{place}: {line.command}"
    arguments = line.arguments
    if line.command == "mode":
        fields = layout.load().struct("tx_modes").fields
        for name, value in arguments:
            field_name, bits = MODE_FIELDS[name]
            check_range([value], [(name, bits)], where)
            operations.add("MODE", fields[field_name]["offset"], value)
        return
    if line.command == "tile":
        check_range(arguments, TILE_BITS.items(), where)
    elif line.command == "tmem":
        check_poke(line, operations.codes["TX_TMEM_BYTES"], place)
    elif line.command == "rdram":
        check_poke(line, operations.codes["VECTOR_DRAM_BYTES"], place)
    for value in arguments:
        if not -1 << 31 <= value <= M32:
            raise UserError(f"{where}: {value} does not fit into 32 bits")
    operations.add(OPERATIONS[line.command], *arguments)


@dataclass
class File:
    """A file of reference data: its questions, and after ``check`` the wrong ones."""

    path: Path
    questions: list[Line]
    wrong: list[tuple[Line, tuple[int, ...]]] = field(default_factory=list)  # and what was found


def add_file(operations: Operations, path: Path) -> File:
    """Reads a file into the operations."""
    operations.add("RESET")
    questions = []
    for line in vector_text.read(path):
        if line.command not in OPERATIONS and line.command != "mode":
            raise UserError(f"{path}:{line.number}: {line.command}: no unit answers this")
        add_line(operations, line, f"{path}:{line.number}")
        if line.expected:
            questions.append(line)
    if not questions:
        raise UserError(f"{path}: asks nothing")
    return File(path, questions)


def differs(line: Line, found: tuple[int, ...]) -> bool:
    """Whether a number that counts is another one."""
    return any(mask is not None and (a ^ b) & mask
               for a, b, mask in zip(line.expected, found, COMPARED[line.command], strict=True))


def compare(file: File, answers: np.ndarray, at: int) -> int:
    """Notes what is wrong in a file, whose answers begin at ``at``; returns their end."""
    for line in file.questions:
        end = at + len(COMPARED[line.command])
        found = tuple(int(value) for value in answers[at:end])
        if len(found) != end - at:
            raise UserError(f"vectors: answers end before {file.path}:{line.number}")
        if differs(line, found):
            file.wrong.append((line, found))
        at = end
    return at


def check(paths: list[Path], machine: str = "a1200-fast", on_operation=None) -> list[File]:
    """Asks every question of the files in one boot. ``on_operation``: told (begun, all)."""
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
    """An answer as files have it: decimal, or hexadecimal in as many digits as it needs."""
    bases = vector_text.SHAPES[line.command].answers
    texts = []
    for value, base, mask in zip(values, bases, COMPARED[line.command], strict=True):
        if base == vector_text.DECIMAL:
            texts.append(str(value))
        else:
            digits = 3 if mask == NINE_BITS else 8
            texts.append(f"{value & (M32 if mask is None else mask):0{digits}x}")
    return " ".join(texts)


def asked(line: Line) -> str:
    """A question as files have it."""
    return " ".join([line.command, *map(str, line.arguments)])


def report(file: File) -> list[str]:
    """Lines on a file: right and wrong, and the first wrong questions."""
    lines = [f"{file.path}: {len(file.questions) - len(file.wrong)} right, "
             f"{len(file.wrong)} wrong"]
    for line, found in file.wrong[:SHOWN]:
        lines.append(f"  line {line.number}: {asked(line)}: expected "
                     f"{written(line, line.expected)}, found {written(line, found)}")
    if len(file.wrong) > SHOWN:
        lines.append(f"  and {len(file.wrong) - SHOWN} more")
    return lines


def command(paths: list[Path], machine: str) -> int:
    """``tmap vectors``: status 1 where an answer is wrong."""
    from rich.progress import Progress

    with Progress(transient=True, disable=not sys.stderr.isatty()) as progress:
        task = progress.add_task("vectors", total=None)
        files = check(paths, machine,
                      lambda begun, count: progress.update(task, completed=begun, total=count))
    for file in files:
        print("\n".join(report(file)))
    return 1 if any(file.wrong for file in files) else 0
