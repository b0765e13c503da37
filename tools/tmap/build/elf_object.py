"""Relocatable ELF objects as the linker of scene programs reads them: sections and their
references."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from elftools.elf.constants import SH_FLAGS
from elftools.elf.elffile import ELFFile
from elftools.elf.enums import ENUM_ST_SHNDX

from tmap.base.errors import UserError

#: R_68K_32, PC32, PC16, PC8: size in bytes, and true if relative to the field's own address.
RELOCATIONS = {1: (4, False), 4: (4, True), 5: (2, True), 6: (1, True)}

COMMON = ENUM_ST_SHNDX["SHN_COMMON"]  # a symbol without a section
SYMBOL = np.dtype([("name", ">u4"), ("value", ">u4"), ("size", ">u4"), ("info", "u1"),
                   ("other", "u1"), ("section", ">u2")])
RELA = np.dtype([("offset", ">u4"), ("info", ">u4"), ("addend", ">i4")])


@dataclass(eq=False)
class Section:
    """A section of an object: the unit that a program includes or leaves out."""

    file: str
    name: str
    data: bytes  # empty if ``bss``
    size: int
    align: int
    code: bool = False
    bss: bool = False
    relocations: list["Relocation"] = field(default_factory=list)
    symbols: dict[str, int] = field(default_factory=dict)  # global ones, to offsets

    @property
    def title(self) -> str:
        """The routine's or table's name without the compiler's prefixes; else the file's name."""
        if self.name in ("CODE", "DATA", "BSS"):
            return f"{Path(self.file).stem}.c"
        parts = self.name.split(".")[2:]
        return ".".join(part for part in parts if part != "startup") or Path(self.file).stem


def split_strings(section: Section) -> dict[int, Section]:
    """Splits a section of strings into one section for each, by their offsets."""
    parts, start = {}, 0
    for text in section.data.split(b"\0")[:-1]:
        data = text + b"\0"
        parts[start] = Section(section.file, section.name, data, len(data), 1)
        start += len(data)
    return parts


def part_at(parts: dict[int, Section], offset: int) -> tuple[Section, int]:
    """Returns the part of a section of strings that contains an offset, and the offset in it."""
    start = max(place for place in parts if place <= offset)
    return parts[start], offset - start


@dataclass
class Relocation:
    """A reference from a section to another, or to a symbol of another object."""

    offset: int
    size: int
    relative: bool
    target: Section | str
    addend: int


def string_at(table: bytes, offset: int) -> str:
    """Returns the name at an offset in a table of zero-terminated strings."""
    return table[offset:table.index(b"\0", offset)].decode()


def load(path: Path) -> list[Section]:
    """Returns the sections of an object that are loaded into memory."""
    with path.open("rb") as stream:
        elf = ELFFile(stream)
        found: dict[int, Section] = {}
        tables: dict[int, np.ndarray] = {}
        strings: dict[int, dict[int, Section]] = {}
        for index, part in enumerate(elf.iter_sections()):
            if part["sh_flags"] & SH_FLAGS.SHF_ALLOC and part["sh_size"]:
                bss = part["sh_type"] == "SHT_NOBITS"
                found[index] = Section(
                    str(path), part.name, b"" if bss else part.data(), part["sh_size"],
                    max(part["sh_addralign"], 4), bool(part["sh_flags"] & SH_FLAGS.SHF_EXECINSTR),
                    bss)
                if part["sh_flags"] & SH_FLAGS.SHF_STRINGS and part["sh_entsize"] == 1:
                    strings[index] = split_strings(found[index])
            elif part["sh_type"] == "SHT_RELA":
                tables[part["sh_info"]] = np.frombuffer(part.data(), RELA)
            elif part["sh_type"] == "SHT_SYMTAB":
                symbols, names = np.frombuffer(part.data(), SYMBOL), elf.get_section(part["sh_link"]).data()
    home = symbols["section"]
    for name, value, _, info, _, index in symbols[np.isin(home, [COMMON, *found])].tolist():
        if index == COMMON:
            raise UserError(f"{path}: {string_at(names, name)} is common: give it a section")
        if info >> 4:
            found[index].symbols[string_at(names, name)] = value
    for index, section in found.items():
        table = tables.get(index, np.zeros(0, RELA))
        for (offset, info, addend), (name, value, *_, home) in zip(table.tolist(), symbols[table["info"] >> 8].tolist()):
            if info & 255 not in RELOCATIONS:
                raise UserError(f"{path}: {section.name}: a relocation of type {info & 255}, which "
                                "nothing here can make")
            size, relative = RELOCATIONS[info & 255]
            target = string_at(names, name)
            if home in strings:
                target, addend = part_at(strings[home], addend + value)
            elif home in found:
                target, addend = found[home], addend + value
            section.relocations.append(Relocation(offset, size, relative, target, addend))
    return [part for index, section in found.items()
            for part in strings.get(index, {0: section}).values()]
