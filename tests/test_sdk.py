"""The SDK: complete, of one convention, the same bytes in every form; and its example draws the
model's pictures, however it was built."""

import io
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass

import numpy as np
import pytest
from amitools.binfmt.hunk import Hunk
from amitools.binfmt.hunk.HunkReader import HunkReader

from engine_polygons import first_wrong
from tools import contracts, emulator, hunk_object, model, objects, planar, sdk
from tools.errors import UserError
from tools.objects import Relocation, Section
from tools.paths import ROOT

WIDTH, HEIGHT = 160, 128  # of the example's pictures
#: Each set of the example's tools, and the programs that it takes beside vasm.
TOOLS = {"elf": ("m68k-linux-gnu-gcc", "m68k-linux-gnu-ld"), "vbcc": ("vbccm68k", "vlink"),
         "gcc": ("m68k-amigaos-gcc",)}
#: Whoever is found compiles the headers, too.
COMPILERS = {"m68k-linux-gnu-gcc": ("-m68020",), "m68k-amigaos-gcc": ("-m68020",), "gcc": ()}
#: What C code for texture engines asks the program for, as README.txt says.
ASKED = {"_mem_take"}
#: Routines that no header declares: parts of others, and loops for measuring alone.
PARTS = {"edge_right", "edge_right_exact", "edge_exact", "edge_rounded"}
MEASURED = {"pixel", "step", "floor", "instructions"}  # files of src68k/span


def found(names) -> list[str]:
    """Those of the names that have all their programs on PATH."""
    return [name for name in names if all(map(shutil.which, names[name]))]


@pytest.fixture(scope="module")
def kit(tmp_path_factory):
    """The SDK, and its archive beside it."""
    out = tmp_path_factory.mktemp("sdk") / "sdk"
    assert sdk.command(out) == 0
    return out


@dataclass
class Unit:
    """A hunk object as amitools reads it: code, its section's name, and what it defines and
    refers to."""

    data: bytes
    name: str
    kind: int
    defined: dict[str, int]
    inside: dict[int, list[int]]  # offsets that need the address of a hunk of the unit
    outside: dict[int, tuple[str, int]]  # name and kind of reference, by offset


def read_units(data: bytes) -> list[list[Unit]]:
    """The hunks of each unit of an object or a library."""
    reader = HunkReader()
    assert reader.read_file_obj("", io.BytesIO(data)) == Hunk.RESULT_OK, reader.error_string
    assert reader.build_segments(), reader.error_string
    return [[as_unit(segment) for segment in unit["segments"]] for unit in reader.units]


def as_unit(segment: list[dict]) -> Unit:
    """A segment of amitools' reader."""
    main = segment[0]
    unit = Unit(main["data"], main["name"], main["type"], {}, {}, {})
    for hunk in segment[1:]:
        if hunk["type"] == Hunk.HUNK_ABSRELOC32:
            unit.inside |= hunk["reloc"]
        for entry in hunk.get("ext_def", ()):
            unit.defined[entry["name"]] = entry["def"]
        for entry in hunk.get("ext_ref", ()):
            unit.outside |= {offset: (entry["name"], entry["type"]) for offset in entry["refs"]}
    return unit
