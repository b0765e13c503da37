"""Selects the sections, and the bytes in them, that a program of one scene needs.

A program keeps those instructions of the renderer that were executed in a traced run, and the
tables that they refer to. If such an instruction could continue at one that was never executed, an
ILLEGAL is put there, which the program's fault handler would report. Sections of the system's rooms
are kept whole, because their behaviour depends on more than the scene.
"""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from tmap.base.errors import UserError
from tmap.build import instructions
from tmap.build.elf_object import Relocation, Section

ILLEGAL = bytes.fromhex("4afc")
#: Rooms of build/obj whose sections are kept whole.
SYSTEM = ("amiga", "system", "programs")
VBCC_CODE = "CODE"  # the name of vbcc's sections, one a file
STOP = "left_out"  # target of pointers to routines that are never called
#: Objects whose routines replace others and call those.
WRAPPERS = ("trace.o", "profile.o", "still_time.o")
TABLE = "_table"  # ending of symbols in code that are not routines


@dataclass(eq=False)
class Part:
    """A section, and the bytes of it that a program keeps."""

    section: Section
    executed: list[int]  # offsets of instructions
    timed: int  # 1: some are executed while frames are timed; 2: some more than once
    whole: bool
    live: np.ndarray = field(init=False, repr=False)  # bool (size,)
    data: bytes = field(init=False, repr=False)
    known: dict[int, instructions.Instruction] = field(init=False, repr=False)
    tables: set[int] = field(init=False, repr=False)  # offsets of the kept tables
    instructions: np.ndarray = field(init=False, repr=False)  # bool (size,)

    def __post_init__(self) -> None:
        self.live = np.full(self.section.size, self.whole)
        self.data = self.section.data
        self.known, self.tables = {}, set()
        if self.whole:
            return
        self.known = instructions.at(self.section, self.executed)
        for offset, instruction in self.known.items():
            self.live[offset:offset + instruction.length] = True
        self.instructions = self.live.copy()
        for instruction in list(self.known.values()):
            if instruction.data is not None:
                self.keep_table(instruction.data)
        self.mark_ends()

    def keep_table(self, offset: int) -> bool:
        """Keeps the bytes from an offset to the next instruction; returns True if some were not
        kept yet."""
        if offset in self.tables:
            return False
        self.tables.add(offset)
        end = min((o for o in self.executed if o >= offset), default=self.section.size)
        news = not self.live[offset:end].all()
        self.live[offset:end] = True
        return news

    def mark_ends(self) -> None:
        """Puts an ILLEGAL where the executed instructions could leave the kept bytes."""
        relocated = {r.offset for r in self.section.relocations}
        data = bytearray(self.data)
        for offset, instruction in self.known.items():
            ends = {offset + instruction.length} if instruction.goes_on else set()
            inside = range(offset, offset + instruction.length)
            if instruction.branch is not None and not relocated.intersection(inside):
                ends.add(instruction.branch)
            for end in ends:
                if end < self.section.size and not self.live[end]:
                    self.live[end:end + 2] = True
                    data[end:end + 2] = ILLEGAL
        self.data = bytes(data)

    def is_table(self, offset: int) -> bool:
        """Returns True if the byte at an offset belongs to no instruction."""
        if self.whole:
            return not self.section.code
        return not self.instructions[offset]

    @property
    def bytes(self) -> int:
        """The number of bytes kept."""
        return int(self.live.sum())


def is_whole(section: Section) -> bool:
    """Returns True if a section is kept whole when it is kept at all."""
    return not section.code or Path(section.file).parent.name in SYSTEM


class Program:
    """The parts that a program needs, starting with its entry."""

    def __init__(self, sections: list[Section], aliases: dict[str, str],
                 trace: dict[Section, tuple[list[int], int]] | None, entry: str = "start"):
        """``trace``: executed offsets of each section, and timed as in Part; None: all parts are
        whole; ``entry``: the symbol where the program begins."""
        self.aliases, self.trace, self.sections = aliases, trace, sections
        self.symbols: dict[str, tuple[Section, int]] = {}
        for section in sections:
            for name, offset in section.symbols.items():
                if name in self.symbols:
                    raise UserError(f"{section.file}: {name}: defined twice")
                self.symbols[name] = section, offset
        self.parts: dict[Section, Part] = {}
        self.stop = Section("", f".text.{STOP}", ILLEGAL, 2, 2, code=True, symbols={STOP: 0})
        self.entry = self.symbols[entry][0]
        self.add(self.entry)
        while self.grow():
            pass

    def add(self, section: Section) -> Part:
        """Adds a section to the program if it is new; returns its part."""
        if section not in self.parts:
            executed, timed = (self.trace or {}).get(section, ([], 0))
            whole = self.trace is None or is_whole(section) or section is self.stop
            self.parts[section] = Part(section, executed, timed, whole)
        return self.parts[section]

    def resolve(self, section: Section, relocation: Relocation) -> tuple[Section, int]:
        """Returns the target section and offset of a relocation."""
        target = relocation.target
        if isinstance(target, Section):
            return target, relocation.addend
        if Path(section.file).name not in WRAPPERS:
            target = self.aliases.get(target, target)
        if target not in self.symbols:
            raise UserError(f"{section.file}: {target}: nothing defines it")
        found, offset = self.symbols[target]
        return found, offset + relocation.addend

    def held(self, part: Part) -> list[Relocation]:
        """Returns the relocations of the kept bytes that no ILLEGAL has replaced."""
        return [r for r in part.section.relocations if part.live[r.offset]
                and part.data[r.offset:r.offset + r.size]
                == part.section.data[r.offset:r.offset + r.size]]

    def lead(self, part: Part, relocation: Relocation) -> tuple[Section, int]:
        """Like ``resolve``, but returns the stop if the target is a routine that was never
        executed. C's entry of one that was executed stays: callers reach the other from it.

        vbcc has tables in the sections of code, so the target of an instruction may be a table.
        """
        target, offset = self.resolve(part.section, relocation)
        if self.trace is None or is_whole(target) or target is self.stop:
            return target, offset
        executed, _ = self.trace.get(target, ([], 0))
        routines = {o for name, o in target.symbols.items() if not name.endswith(TABLE)}
        behind = {target.symbols.get(f"_{name}") for name, o in target.symbols.items() if o in executed}
        if offset in executed or (executed and offset not in routines) or offset in behind:
            return target, offset
        if target.name == VBCC_CODE and not part.is_table(relocation.offset):
            return target, offset
        return self.stop, 0

    def grow(self) -> bool:
        """Adds the targets of the parts' relocations; returns True if any was new."""
        news = False
        for part in list(self.parts.values()):
            for relocation in self.held(part):
                target, offset = self.lead(part, relocation)
                if target is self.stop and part.is_table(relocation.offset):
                    part.live[relocation.offset:relocation.offset + relocation.size] = False
                    continue
                news |= target not in self.parts
                found = self.add(target)
                if not found.whole and offset not in found.executed:
                    news |= found.keep_table(offset)
        return news
