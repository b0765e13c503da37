"""Struct layouts: read from debug information, written for assembly, checked by compilers."""

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from tmap.base import paths
from tmap.base.errors import UserError
from tmap.build import layout

GCC = ["m68k-linux-gnu-gcc", "-std=c99", "-m68020", "-ffreestanding", "-Wall", "-pedantic-errors"]
HEADER = """\
#ifndef THINGS_H
#define THINGS_H
typedef signed short int16;
typedef const volatile int16 odd;
enum first { ALPHA = -200, BETA = 200, GAMMA = 40000, DELTA = 0x544d4150 };
enum { NAMELESS = 3 };
enum choice { ONE = 1, TWO };
struct pair { unsigned char a; int b; };
struct thing {
    unsigned char flag;
    odd level;
    signed char small;
    unsigned short many[2][3];
    const struct pair *link;
    enum choice choice;
    struct pair inside;
    unsigned long big;
};
struct only_named;
#endif
"""


def build(folder: Path, header: str = HEADER, names=("part/things.h",), others: str = "",
          debug: str = "-fno-eliminate-unused-debug-types") -> int:
    """Compiles a header with debug information and runs the tool; its output is in folder/out."""
    (folder / "c" / "part").mkdir(parents=True)
    (folder / "c" / "part" / "things.h").write_text(header)
    (folder / "all.c").write_text('#include "part/things.h"\n' + others)
    subprocess.run([*GCC, "-g", debug, "-Ic", "-c", "all.c"], cwd=folder, check=True)
    return layout.main([str(folder / "all.o"), str(folder / "out"), *names])


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    folder = tmp_path_factory.mktemp("layout")
    assert build(folder, others="struct elsewhere { int x; }; enum { FAR = 1 };\n") == 0
    return folder


@pytest.fixture
def made(built, monkeypatch):
    monkeypatch.setattr(paths, "LAYOUT", built / "out" / "layout.json")
    return layout.load()


def test_structs(made):
    assert made.structs.keys() == {"pair", "thing"}
    assert made.struct("pair").size == 6
    thing = made.struct("thing")
    assert thing.size == 36
    found = {name: tuple(entry.values()) for name, entry in thing.fields.items()}
    assert found == {  # offset, size, signed, count
        "flag": (0, 1, False, 1), "level": (2, 2, True, 1), "small": (4, 1, True, 1),
        "many": (6, 2, False, 6), "link": (18, 4, False, 1), "choice": (22, 4, False, 1),
        "inside": (26, 1, False, 6), "big": (32, 4, False, 1)}
    assert list(thing.fields["flag"]) == ["offset", "size", "signed", "count"]


def test_constants(made):
    assert made.constants == {"ALPHA": -200, "BETA": 200, "GAMMA": 40000, "DELTA": 0x544D4150,
                              "NAMELESS": 3, "ONE": 1, "TWO": 2}


def test_equates(built):
    lines = (built / "out" / "layout.i").read_text().splitlines()
    assert {"pair_a equ 0", "pair_b equ 2", "pair_sizeof equ 6", "thing_many equ 6",
            "thing_sizeof equ 36", "ALPHA equ -200", "DELTA equ 1414349136"} < set(lines)
    assert len(lines) == 1 + 2 + 1 + 8 + 1 + 7


def test_pack_and_unpack(made):
    pair, thing = made.struct("pair"), made.struct("thing")
    assert pair.pack(a=1, b=-2) == b"\1\0\xff\xff\xff\xfe"
    assert pair.unpack(b"\x99" + pair.pack(a=255, b=-2**31), 1) == {"a": 255, "b": -2**31}
    values = {"flag": 200, "level": -3, "small": -128, "many": [1, 2, 3, 4, 5, 65535],
              "link": 2**32 - 1, "choice": 2, "inside": [1, 2, 3, 4, 5, 6], "big": 7}
    data = thing.pack(**values)
    assert len(data) == thing.size and thing.unpack(data) == values
    assert data[thing.fields["level"]["offset"]:][:2] == b"\xff\xfd"


@pytest.mark.parametrize("values, error", [
    ({"a": 1}, TypeError), ({"a": 1, "b": 2, "c": 3}, TypeError),
    *(({"a": a, "b": b}, OverflowError) for a, b in ((256, 0), (-1, 0), (0, 2**31)))])
def test_pack_needs_every_field_in_its_range(made, values, error):
    with pytest.raises(error):
        made.struct("pair").pack(**values)


COMPILERS = [pytest.param([*GCC, "-Ic", "-c", "-o", "check.o"], id="gcc")]
if shutil.which("vbccm68k"):
    COMPILERS += [pytest.param(["vbccm68k", "-c99", "-O=23999", "-cpu=68020", "-quiet", "-Ic",
                                "-o=check.s"], id="vbcc")]


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("old, new, accepted", [
    ("", "", True),
    ("sizeof(struct pair) == 6", "sizeof(struct pair) == 8", False),
    ("OFFSET(struct pair, b) == 2", "OFFSET(struct pair, b) == 4", False),
    ("OFFSET(struct thing, link) == 18", "OFFSET(struct thing, link) == 20", False),
])
def test_check_compiles_only_where_it_holds(built, compiler, old, new, accepted):
    text = (built / "out" / "layout_check.c").read_text()
    assert old in text
    (built / "check.c").write_text(text.replace(old, new))
    result = subprocess.run([*compiler, "check.c"], cwd=built, capture_output=True, text=True)
    assert (result.returncode == 0) == accepted, result.stderr


def test_check_fails_with_another_alignment(built):
    """The check exists for a compiler that aligns int to 4."""
    result = subprocess.run([*GCC, "-malign-int", "-Ic", "-c", "out/layout_check.c"],
                            cwd=built, capture_output=True, text=True)
    assert result.returncode and "offset_of_pair_b" in result.stderr


@pytest.mark.parametrize("arguments, message", [
    ({"debug": "-feliminate-unused-debug-types"}, "compile with -g -fno-eliminate"),
    ({"debug": "-g0"}, "compile with -g -fno-eliminate"),
    ({"names": ["part/other.h"]}, "no struct of part/other.h"),
    ({"header": "struct s { int a : 3; };\n"}, "struct s: assembly can only use"),
    ({"header": "typedef struct { int a; } s;\n"}, "struct without a name: "),
    ({"header": "struct s { int a; }; enum { s_a = 1 };\n"}, "s_a would be defined twice"),
])
def test_refused_headers_leave_nothing(tmp_path, capsys, arguments, message):
    assert build(tmp_path, **arguments) == 1
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("content", [None, b"", b"\x7fELF", b"no object" * 9])
def test_other_files_are_refused(tmp_path, capsys, content):
    if content is not None:
        (tmp_path / "x.o").write_bytes(content)
    assert layout.main([str(tmp_path / "x.o"), str(tmp_path / "out"), "x.h"]) == 1
    assert capsys.readouterr().err.startswith(f"layout: {tmp_path / 'x.o'}: ")
    assert not (tmp_path / "out").exists()


def test_usage(capsys):
    assert layout.main([]) == 2
    assert capsys.readouterr().err.startswith("usage: ")


def test_load_before_make(tmp_path, monkeypatch):
    monkeypatch.setattr(paths, "LAYOUT", tmp_path / "layout.json")
    with pytest.raises(UserError, match="run make first"):
        layout.load()


def test_this_trees_layout():
    made = layout.load()
    assert made.struct("scanline").size == 12
    assert made.struct("scene_header").fields["width"]["offset"] == 16
    assert made.constants["SCENE_MAGIC"] == 0x544D4150
    text = (paths.LAYOUT.parent / "layout.i").read_text().splitlines()
    assert "scanline_left equ 2" in text and "scanline_sizeof equ 12" in text
    assert json.loads(paths.LAYOUT.read_text()).keys() == {"structs", "constants"}


def test_longwords_take_one_access():
    """A 68020 needs two accesses for a longword at 4n + 2: polygons were 1.5 % slower in chip
    RAM."""
    for name, struct in layout.load().structs.items():
        wide = [f["offset"] for f in struct["fields"].values() if f["size"] == 4]
        assert not any(offset % 4 for offset in wide), name
        assert not wide or struct["size"] % 4 == 0, f"{name}: {struct['size']} bytes"
