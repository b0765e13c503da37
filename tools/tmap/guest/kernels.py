"""Calls kernels on the emulated machine, for the bench and the kernel tests.

A case names a kernel, its registers and a memory image (the arena). The program ``bench`` calls it
once, returns registers and memory, and then times repeats. Layouts come from c/bench/plan_file.h.
"""

from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import M32
from tmap.base.paths import PROGRAMS
from tmap.build import layout
from tmap.guest import emulator
from tmap.guest.emulator import CYCLES_PER_TICK

REGISTERS = [f"d{n}" for n in range(8)] + [f"a{n}" for n in range(7)]
#: Content of registers that a case does not set: no kernel may rely on them.
POISON = 0xDEAD0000
#: Most bytes of a plan's images, cases and offsets. A machine with chip RAM alone has about 1.7 MB
#: free for the plan and the largest arenas; the others have 8 MB more.
BATCH_BYTES = 950_000
BATCH_BYTES_FAST = 5_000_000


class Changed(UserError):
    """Far memory was changed outside of what cases list."""


class Place(NamedTuple):
    """What an offset of an arena belongs to: its name, where that begins, its bytes."""

    name: str
    at: int
    size: int


class Arena:
    """A memory image under construction: blocks at offsets, pointers to be relocated. Blocks have
    names and shapes for arenas that tell what is at an offset."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.pointers: list[int] = []  # longwords with offsets into this arena
        self.far_pointers: list[int] = []  # longwords with offsets into the far arena

    def add(self, content: bytes | bytearray, align: int = 4, name: str = "data",
            shape: layout.Struct | None = None) -> int:
        """Appends a block; returns its offset."""
        self.data += bytes(-len(self.data) % align)
        at = len(self.data)
        self.data += content
        return at

    def blank(self, size: int, name: str = "data", shape: layout.Struct | None = None) -> int:
        """Appends a block that a kernel writes: zeros."""
        return self.add(bytes(size), name=name, shape=shape)

    def room(self, struct: str, count: int = 1, name: str = "") -> int:
        """Appends blank space for ``count`` structs."""
        shape = layout.load().struct(struct)
        return self.blank(shape.size * count, name or struct, shape)

    def place(self, offset: int) -> Place:
        """What an offset belongs to."""
        return Place(f"offset {offset}", offset, 1)

    def struct(self, name: str, pointers: dict[str, int], far: dict[str, int] | None = None,
               **values: int) -> int:
        """Appends a C struct; fields of ``pointers`` and ``far`` hold offsets into the two
        arenas."""
        shape, far = layout.load().struct(name), far or {}
        offsets = {field: at & M32 for field, at in (pointers | far).items()}
        at = self.add(shape.pack(**values, **offsets), name=name, shape=shape)
        self.pointers += [at + shape.fields[field]["offset"] for field in pointers]
        self.far_pointers += [at + shape.fields[field]["offset"] for field in far]
        return at

    @property
    def image(self) -> bytes:
        """The content, padded to longwords."""
        return bytes(self.data) + bytes(-len(self.data) % 4)


@dataclass
class Shown:
    """Figures of a case for an owner's program, as in struct plan_case. Cycles are those of one of
    ``units`` on the emulated machine, in thousandths; 0 if the row is not shown."""

    title: str
    units: int
    chip: int  # cycles with chip RAM alone
    fast: int  # cycles with fast RAM
    drawn: int  # checksum of the far memory after a call; 0: none


@dataclass
class Case:
    """One call. ``registers``: values; ``pointers``, ``far_pointers``: registers that hold offsets
    into ``arena`` (a program's own data) and ``far`` (map and frame).
    """

    kernel: str
    arena: Arena = field(default_factory=Arena)
    registers: dict[str, int] = field(default_factory=dict)
    pointers: dict[str, int] = field(default_factory=dict)
    far: Arena = field(default_factory=Arena)
    far_pointers: dict[str, int] = field(default_factory=dict)
    chip: bool = False  # far is in chip RAM
    repeats: int = 0
    display: str = "OFF"  # name in enum plan_display, while it is timed
    limit: int = 100  # of the watchdog, in units of 92 ms
    writes: list[tuple[int, int]] | None = None  # offsets and bytes of far that it may write; None: all
    shown: Shown | None = None


@dataclass
class Result:
    """The state after a call: addresses, memory, registers, the stack's error, cycles."""

    address: int
    memory: bytes
    far_address: int
    far_memory: bytes
    registers: dict[str, int]
    stack: int
    cycles: int  # of all repeats, the harness's own calls included


def checksum(content: bytes) -> int:
    """Returns the checksum of a plan's content, as in struct plan_header."""
    sums = np.cumsum(np.frombuffer(content, ">u4"), dtype=np.uint32)
    return (2 * int(sums.sum(dtype=np.uint64)) - int(sums[-1])) & M32


def pieces(image: bytes) -> list[bytes]:
    """Returns an image's pieces as a plan stores them; b"" is a piece of zeros."""
    size = layout.load().constants["PLAN_PIECE"]
    cut = [image[at:at + size] for at in range(0, len(image), size)]
    return [piece if piece.strip(b"\0") else b"" for piece in cut]


def written(size: int, writes: list[tuple[int, int]] | None) -> np.ndarray:
    """Returns which pieces of an image have PLAN_WRITTEN: bool. ``size``: its bytes; ``writes``: as in Case."""
    constants = layout.load().constants
    piece = constants["PLAN_PIECE"]
    found = np.full(-(-size // piece), writes is None)
    for first, count in writes or ():
        if count:
            found[first // piece:(first + count - 1) // piece + 1] = True
    found[-1:] = found[constants["PLAN_HELD"]:] = True
    return found


def plan(cases: list[Case]) -> bytes:
    """Returns the plan file for ``cases``."""
    shapes = layout.load()
    header, case_shape = shapes.struct("plan_header"), shapes.struct("plan_case")
    body = bytearray(header.size + len(cases) * case_shape.size)
    kept: dict[bytes, int] = {}

    def place(content: bytes) -> int:
        if content not in kept:
            body.extend(bytes(-len(body) % 4))
            kept[content] = len(body)
            body.extend(content)
        return kept[content]

    def place_text(text: str) -> int:
        return place(text.encode("ascii") + b"\0")

    def place_image(image: bytes, writes: list[tuple[int, int]] | None = None) -> int:
        listed = np.array([place(piece) if piece else 0 for piece in pieces(image)], ">u4")
        listed[written(len(image), writes)] |= shapes.constants["PLAN_WRITTEN"]
        return place(listed.tobytes())

    def mask(registers: dict[str, int]) -> int:
        return sum(1 << REGISTERS.index(name) for name in registers)

    for index, case in enumerate(cases):
        registers = [POISON + n for n in range(len(REGISTERS))]
        for name, value in (case.registers | case.pointers | case.far_pointers).items():
            registers[REGISTERS.index(name)] = value & M32
        near, far = case.arena.image, case.far.image
        shown = asdict(case.shown) if case.shown else {}
        at = header.size + index * case_shape.size
        body[at:at + case_shape.size] = case_shape.pack(
            name_at=place_text(case.kernel), title_at=place_text(shown.pop("title", "")),
            near_at=place_image(near), near=len(near), far_at=place_image(far, case.writes),
            far=len(far),
            far_memory=shapes.constants["MEMORY_CHIP" if case.chip else "MEMORY_ANY"],
            near_offsets_at=place(np.array(case.arena.pointers, ">u4").tobytes()),
            near_offsets=len(case.arena.pointers),
            far_offsets_at=place(np.array(case.arena.far_pointers, ">u4").tobytes()),
            far_offsets=len(case.arena.far_pointers),
            near_registers=mask(case.pointers), far_registers=mask(case.far_pointers),
            registers=registers, display=shapes.constants[f"DISPLAY_{case.display}"],
            repeats=case.repeats, limit=case.limit,
            **{field: shown.get(field, 0) for field in ("units", "chip", "fast", "drawn")})
    body.extend(bytes(-len(body) % 4))
    summed = header.fields["cases"]["offset"]
    values = dict(magic=shapes.constants["PLAN_MAGIC"], version=shapes.constants["PLAN_VERSION"],
                  size=len(body), checksum=0, cases=len(cases), cases_at=header.size)
    body[:header.size] = header.pack(**values)
    values["checksum"] = checksum(body[summed:])
    body[:header.size] = header.pack(**values)
    return bytes(body)


def batches(cases: list[Case], machine: str) -> list[list[Case]]:
    """Splits the cases into runs whose images fit the guest's memory beside their arenas. A plan
    stores equal pieces once."""
    limit = BATCH_BYTES_FAST if emulator.has_fast_memory(machine) else BATCH_BYTES
    runs: list[list[Case]] = []
    kept: dict[bytes, None] = {}
    room, size = 0, layout.load().struct("plan_case").size
    for case in cases:
        images = pieces(case.arena.image) + pieces(case.far.image)
        rest = size + 4 * (len(case.arena.pointers) + len(case.arena.far_pointers) + len(images))
        more = rest + sum(len(piece) for piece in images if piece not in kept)
        if not runs or more > room:
            runs.append([])
            kept.clear()
            room, more = limit, rest + sum(map(len, images))
        kept.update(dict.fromkeys(images))
        runs[-1].append(case)
        room -= more
    return runs


def far_after(case: Case, data: memoryview) -> tuple[bytes, int]:
    """Returns the far memory after a call, and how many bytes of ``data``, which has its written pieces, it took."""
    image, size = bytearray(case.far.image), layout.load().constants["PLAN_PIECE"]
    marks, at = np.flatnonzero(np.diff(written(len(image), case.writes), prepend=False, append=False)), 0
    for first, end in zip((marks[::2] * size).tolist(), (marks[1::2] * size).tolist()):
        end = min(end, len(image))
        image[first:end] = data[at:at + end - first]
        at += end - first
    return bytes(image), at


def call_batch(cases: list[Case], machine: str, progress, timed: bool = True, programs: Path = PROGRAMS,
               patience: float | None = None) -> list[Result]:
    """Runs the cases in one boot; returns their results; ``timed``, ``programs``, ``patience``: as in
    emulator.run_batch. Raises Changed if a call wrote far memory outside its case's ``writes``."""
    with emulator.workspace() as directory:
        done = emulator.run("bench", "kernels.plan kernels.results", {"kernels.plan": plan(cases)},
                            machine, directory, progress, programs, patience, timed=timed)
        if done.code:
            raise UserError(f"bench: {emulator.last_words(done.output)}")
        data = (done.directory / "kernels.results").read_bytes()
    shape = layout.load().struct("plan_result")
    results, at, view = [], 0, memoryview(data)
    for case in cases:
        near = len(case.arena.image)
        memory, at = data[at:at + near], at + near
        far_memory, size = far_after(case, view[at:])
        fields, at = shape.unpack(data, at + size), at + size + shape.size
        results.append(Result(fields["near"], memory, fields["far"], far_memory,
                              dict(zip(REGISTERS, fields["registers"])), fields["stack"],
                              fields["ticks"] * CYCLES_PER_TICK))
    if at + 4 != len(data):
        raise UserError(f"bench: {len(data)} bytes of results instead of {at + 4}")
    if changed := int.from_bytes(data[at:], "big"):
        raise Changed(f"bench: {changed} pieces of far memory were changed by calls that may not write them")
    return results


def call(cases: list[Case], machine: str, on_case=None) -> list[Result]:
    """Calls every case. ``on_case`` is called with the number of cases begun."""
    results: list[Result] = []

    def progress(output: str) -> None:
        if on_case:
            on_case(len(results) + output.count("case "))

    for batch in batches(cases, machine):
        results += call_batch(batch, machine, progress)
    return results
