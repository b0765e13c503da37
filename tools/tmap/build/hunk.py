"""Turns a linked ELF program into an AmigaDOS hunk executable.

``python -m tmap.build.hunk PROGRAM.elf OUT``. The linker keeps its relocations (``ld -q``) and puts
``.text``, ``.data`` and ``.bss`` each at address 0, so that every R_68K_32 becomes one entry of a
HUNK_RELOC32. OUT.map, written with the program, lists ``offset name`` for each symbol of the code;
crash reports take the routines' names from it. This file imports nothing from tmap: the SDK
contains it as elf2hunk.py.

Source: AmigaDOS hunk format (The AmigaDOS Manual, chapter on binary files).
"""

import re
import struct
import sys
from pathlib import Path

from elftools.common.exceptions import ELFError
from elftools.elf.elffile import ELFFile

HUNK_CODE, HUNK_DATA, HUNK_BSS = 0x3E9, 0x3EA, 0x3EB
HUNK_RELOC32, HUNK_END, HUNK_HEADER = 0x3EC, 0x3F2, 0x3F3
SECTIONS = (".text", ".data", ".bss")
R_68K_32 = 1
COMPILER_LABEL = re.compile(r"\.|l\d+$")  # inside routines: would hide the routines' names
PC_RELATIVE = {4, 5, 6}  # R_68K_PC32, PC16, PC8: resolved inside one section


def longs(*values: int) -> bytes:
    """Returns big-endian longwords."""
    return struct.pack(f">{len(values)}I", *values)


def relocations(elf: ELFFile, section, hunk_of: dict[int, int]) -> dict[int, list[int]]:
    """Returns offsets to relocate in ``section``, by the hunk that they point into. ``hunk_of``:
    each section's hunk."""
    table = elf.get_section_by_name(".rela" + section.name)
    found: dict[int, list[int]] = {}
    if table is None:
        return found
    symbols = elf.get_section(table["sh_link"])
    for entry in table.iter_relocations():
        symbol = symbols.get_symbol(entry["r_info_sym"])
        target = symbol["st_shndx"]
        kind = entry["r_info_type"]
        if kind == R_68K_32 and target in hunk_of:
            found.setdefault(hunk_of[target], []).append(entry["r_offset"])
        elif kind in PC_RELATIVE and target == elf.get_section_index(section.name):
            continue
        elif kind and target != "SHN_ABS":
            raise ValueError(f"relocation type {kind} to {symbol.name!r} cannot be in a hunk file")
    return found


def executable(elf: ELFFile) -> bytes:
    """Returns the hunk file of a linked program."""
    sections = [s for s in map(elf.get_section_by_name, SECTIONS) if s and s["sh_size"]]
    hunk_of = {elf.get_section_index(s.name): i for i, s in enumerate(sections)}
    sizes = [(s["sh_size"] + 3) // 4 for s in sections]
    out = longs(HUNK_HEADER, 0, len(sections), 0, len(sections) - 1, *sizes)
    for section, size in zip(sections, sizes):
        if section.name == ".bss":
            out += longs(HUNK_BSS, size)
        else:
            out += longs(HUNK_CODE if section.name == ".text" else HUNK_DATA, size)
            out += section.data().ljust(size * 4, b"\0") + reloc32(relocations(elf, section, hunk_of))
        out += longs(HUNK_END)
    return out


def reloc32(offsets: dict[int, list[int]]) -> bytes:
    """Returns a hunk's HUNK_RELOC32 from the offsets of its addresses, by the hunk that they point
    into; b"" if there are none."""
    if not offsets:
        return b""
    return longs(HUNK_RELOC32) + b"".join(longs(len(some), hunk, *sorted(some))
                                          for hunk, some in sorted(offsets.items())) + longs(0)


def symbol_map(elf: ELFFile) -> str:
    """Returns a line for each symbol of the code: offset in hexadecimal, name."""
    code, table = elf.get_section_index(".text"), elf.get_section_by_name(".symtab")
    texts = elf.get_section(table["sh_link"]).data()
    # Read here: of 600,000 symbols, constants of assembly most of them, pyelftools would make objects.
    found = ((value, texts[at:texts.index(0, at)].decode())
             for at, value, _, _, _, section in struct.iter_unpack(">IIIBBH", table.data())
             if section == code and at)
    names = sorted(each for each in found if not COMPILER_LABEL.match(each[1]))
    return "".join(f"{value:08x} {name}\n" for value, name in names)


def convert(elf_path: Path, out_path: Path) -> None:
    """Writes ``out_path`` (the executable) and ``out_path``.map."""
    with elf_path.open("rb") as stream:
        elf = ELFFile(stream)
        program, symbols = executable(elf), symbol_map(elf)
    out_path.write_bytes(program)
    out_path.with_name(out_path.name + ".map").write_text(symbols)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"usage: python {sys.argv[0]} PROGRAM.elf OUT")
    try:
        convert(Path(sys.argv[1]), Path(sys.argv[2]))
    except (OSError, ELFError, ValueError) as error:
        sys.exit(f"hunk: {sys.argv[1]}: {error}")
