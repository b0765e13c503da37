"""Relocatable ELF objects as the linker of scene programs sees them: sections and what they
refer to."""

from dataclasses import dataclass, field
from pathlib import Path

from elftools.elf.constants import SH_FLAGS
from elftools.elf.elffile import ELFFile

#: R_68K_32, PC32, PC16, PC8: bytes and whether relative to their own place.
RELOCATIONS = {1: (4, False), 4: (4, True), 5: (2, True), 6: (1, True)}


@dataclass(eq=False)
class Section:
    """A section of an object: what a program holds or leaves out."""

    file: str
    name: str
    data: bytes  # empty where ``bss``
    size: int
    align: int
    code: bool = False
    bss: bool = False
    relocations: list["Relocation"] = field(default_factory=list)
    symbols: dict[str, int] = field(default_factory=dict)  # global ones, to offsets

    @property
    def title(self) -> str:
        """The routine's or table's name without what compilers put before it."""
        if self.name in ("CODE", "DATA", "BSS"):
            return f"{Path(self.file).stem}.c"
        parts = self.name.split(".")[2:]
        return ".".join(part for part in parts if part != "startup") or Path(self.file).stem


@dataclass
class Relocation:
    """Where a section refers to another, or to a symbol of another object."""

    offset: int
    size: int
    relative: bool
    target: Section | str
    addend: int


def load(path: Path) -> list[Section]:
    """The sections of an object that go into memory."""
    with path.open("rb") as stream:
        elf = ELFFile(stream)
        found: dict[int, Section] = {}
        for index, part in enumerate(elf.iter_sections()):
            if part["sh_flags"] & SH_FLAGS.SHF_ALLOC and part["sh_size"]:
                bss = part["sh_type"] == "SHT_NOBITS"
                found[index] = Section(
                    str(path), part.name, b"" if bss else part.data(), part["sh_size"],
                    max(part["sh_addralign"], 4), bool(part["sh_flags"] & SH_FLAGS.SHF_EXECINSTR),
                    bss)
        table = elf.get_section_by_name(".symtab")
        symbols = list(table.iter_symbols())
        for symbol in symbols:
            if symbol["st_shndx"] == "SHN_COMMON":
                raise SystemExit(f"{path}: {symbol.name} is common: give it a section")
            if symbol["st_info"]["bind"] != "STB_LOCAL" and symbol["st_shndx"] in found:
                found[symbol["st_shndx"]].symbols[symbol.name] = symbol["st_value"]
        for index, section in found.items():
            relocations = elf.get_section_by_name(".rela" + section.name)
            for part in elf.iter_sections():  # two sections may have the same name
                if part["sh_type"] == "SHT_RELA" and part["sh_info"] == index:
                    relocations = part
            for entry in relocations.iter_relocations() if relocations else ():
                symbol = symbols[entry["r_info_sym"]]
                size, relative = RELOCATIONS[entry["r_info_type"]]
                addend, target = entry["r_addend"], symbol.name
                if symbol["st_shndx"] in found:
                    target, addend = found[symbol["st_shndx"]], addend + symbol["st_value"]
                section.relocations.append(
                    Relocation(entry["r_offset"], size, relative, target, addend))
    return list(found.values())
