"""The references of executed instructions, found by the disassembler of the binutils."""

import re
import subprocess
from dataclasses import dataclass

from tmap.base.errors import UserError
from tmap.build.elf_object import Section

OBJDUMP = "m68k-linux-gnu-objdump"
LINE = re.compile(r"\s*([0-9a-f]+):\t((?:[0-9a-f]{4} )+)\s*\t(\S+)\s*(.*)")
#: A PC-relative operand: its address, and a comma if registers are added to it.
PLACE = re.compile(r"%pc@\((?:0x)?([0-9a-f]+)(?: <[^>]*>)?(,?)")
TARGET = re.compile(r"(?:^|,)(?:0x)?([0-9a-f]+)(?: <[^>]*>)?$")
BRANCH = re.compile(r"(b(ra|sr|hi|ls|cc|cs|ne|eq|vc|vs|pl|mi|ge|lt|gt|le)|db..?)[sbwl]?$")
ENDS = re.compile(r"(bra[sbwl]?|jmp|rts|rtd|rte|rtr|illegal)$")


@dataclass
class Instruction:
    """An instruction: its length in bytes and the offsets in its section that it refers to."""

    length: int
    goes_on: bool  # execution can continue with the next instruction
    branch: int | None = None
    data: int | None = None


def parse(words: str, name: str, operands: str) -> Instruction:
    """Parses an instruction from its words in hexadecimal and its text."""
    found = Instruction(len(words.split()) * 2, not ENDS.match(name))
    place = PLACE.search(operands)
    target = TARGET.search(operands)
    if place:
        if name not in ("jmp", "jsr"):
            found.data = int(place[1], 16)
        elif not place[2]:
            found.branch = int(place[1], 16)
    elif target and BRANCH.match(name):
        found.branch = int(target[1], 16)
    return found


def sweep(section: Section, start: int) -> dict[int, Instruction]:
    """Returns the instructions of a section from an offset on, by offset."""
    done = subprocess.run(
        [OBJDUMP, "-d", "-m", "m68k:68020", "--insn-width=24", "-j", section.name,
         f"--start-address={start}", section.file], capture_output=True, text=True)
    if done.returncode:
        raise UserError(f"{section.file}: {section.name}: {' '.join(done.stderr.split())}")
    return {int(match[1], 16): parse(*match.groups()[1:])
            for match in map(LINE.match, done.stdout.splitlines()) if match}


def at(section: Section, offsets: list[int]) -> dict[int, Instruction]:
    """Returns the instructions at these offsets. Tables between them do no harm: disassembly starts
    again at each offset that it missed."""
    known: dict[int, Instruction] = {}
    for offset in sorted(offsets):
        if offset not in known:
            known |= sweep(section, offset)
        if offset not in known:
            raise UserError(f"{section.file}: {section.name}: no instruction at {offset:#x}")
    return {offset: known[offset] for offset in offsets}
