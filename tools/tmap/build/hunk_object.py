"""Writes relocatable objects as AmigaDOS hunk objects, for vlink and m68k-amigaos-gcc's ld.

Each object becomes a unit with one hunk for each section. The hunks have the section names that the
linker's compilers use, so that the linker joins a program's sections of a kind into one hunk.
Consecutive units form a link library, from which linkers take the units that are referenced.

References to other objects must be addresses. Relative ones are refused: m68k-amigaos-gcc's ld of
2018 expects the field to contain its own offset, as its assembler writes it; later versions and
vlink do not.

Source: AmigaDOS hunk format (The AmigaDOS Manual, chapter on binary files).
"""

from dataclasses import dataclass

from tmap.base.errors import UserError
from tmap.build.elf_object import Relocation, Section
from tmap.build.hunk import HUNK_BSS, HUNK_CODE, HUNK_DATA, HUNK_END, longs, reloc32

HUNK_UNIT, HUNK_NAME, HUNK_EXT = 0x3E7, 0x3E8, 0x3EF
EXT_DEF, EXT_REF32 = 1, 129
NOP = bytes.fromhex("4e71")


@dataclass(frozen=True)
class Names:
    """The section names that a linker's compilers use."""

    code: str
    data: str
    bss: str


VLINK = Names("CODE", "DATA", "BSS")
GCC = Names(".text", ".data", ".bss")


def text(name: str, kind: int = 0) -> bytes:
    """Returns a name as longwords, after a longword with their count and, in the upper byte, a
    kind."""
    data = name.encode("ascii")
    padded = data.ljust((len(data) + 3) // 4 * 4, b"\0")
    return longs(kind << 24 | len(padded) // 4) + padded


def head(section: Section, names: Names) -> bytes:
    """Returns a section's name and its kind of hunk."""
    if section.bss:
        return longs(HUNK_NAME) + text(names.bss) + longs(HUNK_BSS)
    if section.code:
        return longs(HUNK_NAME) + text(names.code) + longs(HUNK_CODE)
    return longs(HUNK_NAME) + text(names.data) + longs(HUNK_DATA)


def place(data: bytearray, offset: int, size: int, value: int) -> None:
    """Stores an addend, to which a linker adds an address, or a known relative offset."""
    if not -1 << 8 * size - 1 <= value < 1 << 8 * size:
        raise UserError(f"{value} does not fit {size} bytes at offset {offset}")
    data[offset:offset + size] = (value & (1 << 8 * size) - 1).to_bytes(size, "big")


def contents(section: Section) -> tuple[bytes, list[Relocation]]:
    """Returns a section's data in whole longwords, and the relocations left to linkers and
    loaders."""
    data, addresses = bytearray(section.data), []
    for r in section.relocations:
        if r.relative and r.target is section:
            place(data, r.offset, r.size, r.addend - r.offset)
            continue
        if r.relative or r.size != 4:
            target = r.target if isinstance(r.target, str) else r.target.name
            raise UserError(f"offset {r.offset} of {section.name} refers to {target} by other than "
                            "its address")
        place(data, r.offset, r.size, r.addend)
        addresses.append(r)
    if section.code and len(data) % 4 == 2:
        data += NOP
    return bytes(data) + bytes(-len(data) % 4), addresses


def hunk(section: Section, names: Names, numbers: dict[Section, int]) -> bytes:
    """Returns a section's hunk; ``numbers``: the hunk numbers of the object's sections."""
    data, addresses = contents(section)
    inside: dict[int, list[int]] = {}
    outside: dict[str, list[int]] = {}
    for r in addresses:
        if isinstance(r.target, str):
            outside.setdefault(r.target, []).append(r.offset)
        else:
            inside.setdefault(numbers[r.target], []).append(r.offset)
    out = head(section, names) + longs((section.size + 3) // 4) + data + reloc32(inside)
    if section.symbols or outside:
        out += longs(HUNK_EXT)
        for name, value in sorted(section.symbols.items()):
            out += text(name, EXT_DEF) + longs(value)
        for name, offsets in sorted(outside.items()):
            out += text(name, EXT_REF32) + longs(len(offsets), *sorted(offsets))
        out += longs(0)
    return out + longs(HUNK_END)


def unit(name: str, sections: list[Section], names: Names) -> bytes:
    """Returns an object's unit."""
    numbers = {section: number for number, section in enumerate(sections)}
    try:
        return longs(HUNK_UNIT) + text(name) + b"".join(hunk(s, names, numbers) for s in sections)
    except UserError as error:
        raise UserError(f"{name} cannot be a hunk object: {error}") from None
