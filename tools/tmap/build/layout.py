"""The layout of the C headers' structs, for the assembly and for the host.

``python -m tmap.build.layout OBJECT.o OUT_DIR HEADER...`` reads the debug information
of an m68k object compiled with ``-g -fno-eliminate-unused-debug-types`` from a C
file that includes every HEADER (named as in its #include), and writes

* ``layout.json``: what ``load`` returns to the rest of the host side,
* ``layout.i``: vasm equates, ``struct_field``, ``struct_sizeof`` and enumerators,
* ``layout_check.c``: C that compiles only if the layout is the same.
"""

import functools
import io
import json
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from elftools.common.exceptions import DWARFError, ELFError
from elftools.elf.elffile import ELFFile

from tmap.base import paths
from tmap.base.errors import UserError

R_68K_32 = 1
POINTER_SIZE = 4
#: DWARF base type encodings that hold negative numbers: signed, signed char.
SIGNED_ENCODINGS = (5, 6)
#: Types that only name another one.
ALIASES = ("DW_TAG_typedef", "DW_TAG_const_type", "DW_TAG_volatile_type")


def relocated(data: bytes) -> bytes:
    """Returns the object with the offsets between its debug sections filled in.

    pyelftools does not know m68k relocations. In debug sections only R_68K_32
    occurs, and the sections of an object are at 0.
    """
    out = bytearray(data)
    elf = ELFFile(io.BytesIO(data))
    for section in elf.iter_sections("SHT_RELA"):
        target = elf.get_section(section["sh_info"])
        if not target.name.startswith(".debug"):
            continue
        symbols = elf.get_section(section["sh_link"])
        for entry in section.iter_relocations():
            if entry["r_info_type"] != R_68K_32:
                raise UserError(f"{target.name}: relocation type {entry['r_info_type']}")
            symbol = symbols.get_symbol(entry["r_info_sym"])
            at = target["sh_offset"] + entry["r_offset"]
            value = symbol["st_value"] + entry["r_addend"]
            out[at:at + 4] = (value & 0xFFFFFFFF).to_bytes(4, "big")
    return bytes(out)


def files(dwarf, unit) -> dict[int, str]:
    """Returns the unit's source files by the numbers that its declarations use."""
    program = dwarf.line_program_for_CU(unit)
    if program is None:
        return {}
    header = program.header
    base = 0 if header["version"] >= 5 else 1
    folders = [folder.decode() for folder in header["include_directory"]]
    names = {}
    for number, entry in enumerate(header["file_entry"], base):
        index = entry["dir_index"] - base
        folder = folders[index] + "/" if index >= 0 else ""
        names[number] = folder + entry["name"].decode()
    return names


def name_of(die) -> str | None:
    """Returns the name in a debug entry, None for an unnamed one."""
    return die.attributes["DW_AT_name"].value.decode() if "DW_AT_name" in die.attributes else None


def number_of(die, attribute: str) -> int:
    """Returns a number in a debug entry."""
    return die.attributes[attribute].value


def element(die) -> tuple[int, bool, int]:
    """Returns a member type's size in bytes, true if it is signed, and its count.

    An array counts as its elements, a struct or union inside a struct as its bytes.
    """
    while die.tag in ALIASES:
        die = die.get_DIE_from_attribute("DW_AT_type")
    if die.tag == "DW_TAG_pointer_type":
        return POINTER_SIZE, False, 1
    if die.tag == "DW_TAG_array_type":
        size, signed, count = element(die.get_DIE_from_attribute("DW_AT_type"))
        for bound in die.iter_children():
            count *= number_of(bound, "DW_AT_upper_bound") + 1
        return size, signed, count
    if die.tag in ("DW_TAG_structure_type", "DW_TAG_union_type"):
        return 1, False, number_of(die, "DW_AT_byte_size")
    signed = number_of(die, "DW_AT_encoding") in SIGNED_ENCODINGS
    return number_of(die, "DW_AT_byte_size"), signed, 1


def extract(data: bytes, headers: list[str]) -> dict:
    """Returns the content of layout.json from an object file's bytes."""
    dwarf = ELFFile(io.BytesIO(relocated(data))).get_dwarf_info(relocate_dwarf_sections=False)
    structs, constants = {}, {}
    for unit in dwarf.iter_CUs():
        names = files(dwarf, unit)
        for die in unit.get_top_DIE().iter_children():
            file = "/" + names.get(number_of(die, "DW_AT_decl_file"), "") \
                if "DW_AT_decl_file" in die.attributes else ""
            if not any(file.endswith("/" + header) for header in headers):
                continue
            if die.tag == "DW_TAG_enumeration_type":
                constants |= {name_of(c): number_of(c, "DW_AT_const_value")
                              for c in die.iter_children()}
            elif die.tag == "DW_TAG_structure_type" and "DW_AT_byte_size" in die.attributes:
                structs[name_of(die)] = {
                    "size": number_of(die, "DW_AT_byte_size"),
                    "fields": {name_of(m): field(name_of(die), m) for m in die.iter_children()}}
    if not structs:
        raise UserError("no struct of " + ", ".join(headers) + " in the debug information; "
                        "compile with -g -fno-eliminate-unused-debug-types")
    return {"structs": structs, "constants": constants}


def field(struct: str | None, member) -> dict:
    """Returns one field's entry in layout.json."""
    if struct is None or name_of(member) is None or "DW_AT_bit_size" in member.attributes:
        raise UserError(f"struct {struct or 'without a name'}: assembly can only use fields that "
                        "have names and are not bit-fields")
    size, signed, count = element(member.get_DIE_from_attribute("DW_AT_type"))
    return {"offset": number_of(member, "DW_AT_data_member_location"),
            "size": size, "signed": signed, "count": count}


def equates(layout: dict) -> str:
    """Returns the text of layout.i."""
    lines = []
    for name, struct in layout["structs"].items():
        lines += [(f"{name}_{f}", entry["offset"]) for f, entry in struct["fields"].items()]
        lines.append((f"{name}_sizeof", struct["size"]))
    lines += layout["constants"].items()
    seen = set()
    for name, _ in lines:
        if name in seen:
            raise UserError(f"layout.i: {name} would be defined twice; rename one in the headers")
        seen.add(name)
    return ("; Offsets and constants of the C headers. Generated: do not edit.\n"
            + "".join(f"{name} equ {value}\n" for name, value in lines))


def check(layout: dict, headers: list[str]) -> str:
    """Returns the text of layout_check.c.

    Both gcc and vbcc refuse a bit-field that is too wide for its type (an array of
    negative size is only a warning in vbcc). Without a library header, no spelling
    of offsetof is a constant in both.
    """
    lines = ["/* Compiles only where structs are laid out as layout.i says.",
             "   Generated: do not edit. */"]
    lines += [f'#include "{header}"' for header in headers]
    lines += ["", "#ifdef __VBCC__", "#define OFFSET(s, f) __offsetof(s, f)", "#else",
              "#define OFFSET(s, f) __builtin_offsetof(s, f)", "#endif",
              "#define CHECK(name, holds) struct name { unsigned bits : (holds) ? 1 : 99; };", ""]
    for name, struct in layout["structs"].items():
        lines.append(f"CHECK(size_of_{name}, sizeof(struct {name}) == {struct['size']})")
        lines += [f"CHECK(offset_of_{name}_{f}, OFFSET(struct {name}, {f}) == {entry['offset']})"
                  for f, entry in struct["fields"].items()]
    return "\n".join(lines) + "\n"


@dataclass(frozen=True)
class Struct:
    """One struct: size in bytes, fields {name: {offset, size, signed, count}}."""

    name: str
    size: int
    fields: dict[str, dict]

    @functools.cached_property
    def dtype(self) -> np.dtype:
        """Big-endian numpy type of one struct, for whole tables at once."""
        entries = self.fields.values()
        formats = [f">{'i' if e['signed'] else 'u'}{e['size']}" for e in entries]
        return np.dtype({
            "names": list(self.fields), "offsets": [e["offset"] for e in entries],
            "formats": [f if e["count"] == 1 else (f, (e["count"],))
                        for f, e in zip(formats, entries)],
            "itemsize": self.size})

    def pack(self, **values) -> bytes:
        """Returns the struct's bytes; every field must be given and fit."""
        if values.keys() != self.fields.keys():
            raise TypeError(f"struct {self.name} has the fields {', '.join(self.fields)}")
        out = np.zeros((), self.dtype)
        for name, value in values.items():
            out[name] = value
        return out.tobytes()

    def unpack(self, data: bytes, offset: int = 0) -> dict:
        """Returns Python integers by field; a list for an array field."""
        record = np.frombuffer(data, self.dtype, 1, offset)[0]
        return {name: record[name].tolist() for name in self.fields}


@dataclass(frozen=True)
class Layout:
    """All structs and enumerators of the headers."""

    structs: dict[str, dict]
    constants: dict[str, int]

    def names(self, prefix: str) -> list[str]:
        """Returns the enumerators with a prefix, without it and in lower case."""
        return [name.removeprefix(prefix).lower() for name in self.constants
                if name.startswith(prefix)]

    @functools.cached_property
    def by_name(self) -> dict[str, Struct]:
        """The structs, ready to pack and unpack."""
        return {name: Struct(name, **struct) for name, struct in self.structs.items()}

    def struct(self, name: str) -> Struct:
        """Returns a struct by its name."""
        return self.by_name[name]


def load() -> Layout:
    """Returns the layout that this tree was built with."""
    return read(paths.LAYOUT)


@functools.cache
def read(path: Path) -> Layout:
    """Reads a layout file. Cached, as it is needed many thousand times."""
    try:
        return Layout(**json.loads(path.read_text()))
    except FileNotFoundError:
        raise UserError(f"{path} is missing: run make first") from None


def main(arguments: list[str]) -> int:
    """Writes the three files; returns the exit status."""
    if len(arguments) < 3:
        print("usage: python -m tmap.build.layout OBJECT.o OUT_DIR HEADER...", file=sys.stderr)
        return 2
    source, out, headers = Path(arguments[0]), Path(arguments[1]), arguments[2:]
    try:
        layout = extract(source.read_bytes(), headers)
        texts = {"layout.json": json.dumps(layout, indent=1) + "\n",
                 "layout.i": equates(layout), "layout_check.c": check(layout, headers)}
        out.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            (out / name).write_text(text)
    except (UserError, ELFError, DWARFError, OSError) as error:
        print(f"layout: {source}: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
