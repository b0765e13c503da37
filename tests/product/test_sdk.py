"""The SDK: complete, of one convention, the same bytes in every form; and its example draws the
model's pictures, whichever tools built it."""

import contextlib
import io
import json
import re
import shutil
import subprocess
import sys
import tarfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from amitools.binfmt.hunk import Hunk
from amitools.binfmt.hunk.HunkReader import HunkReader

from tmap.base import planar
from tmap.base.errors import UserError
from tmap.base.paths import BASELINE, ROOT
from tmap.bench import bench
from tmap.build import contracts, elf_object, hunk_object
from tmap.build.elf_object import Relocation, Section
from tmap.guest import emulator
from tmap.guest.guest_frames import first_wrong
from tmap.model import model
from tmap.product import sdk
from tmap.setup.texturing import Settings

WIDTH, HEIGHT = 160, 128  # of the examples' pictures
TURNS = (63, 10), (57, 29), (45, 45), (29, 57)  # their cosines and sines, 1/64
#: Sets of the example's tools, and the programs that each needs besides vasm: all installed sets
#: are tested, the first one always.
TOOLS = {"elf": ("m68k-linux-gnu-gcc", "m68k-linux-gnu-ld"), "vbcc": ("vbccm68k", "vlink"),
         "gcc": ("m68k-amigaos-gcc",)}
WARNINGS = ("-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only")
#: Compilers for the headers, all used the same way.
COMPILERS = {
    "m68k-linux-gnu-gcc": ("-std=c99", *WARNINGS, "-m68020", "-x", "c"),
    "m68k-amigaos-gcc": ("-std=c99", *WARNINGS, "-m68020", "-x", "c"),
    "g++": ("-std=c++11", *WARNINGS, "-x", "c++"),
    "vbccm68k": ("-c99", "-cpu=68020", "-quiet", "-warnings-as-errors")}
#: The functions that C code for texture engines needs from the program, as listed in README.txt.
ASKED = {"_mem_take"}
#: Routines that are not public: parts of others, and loops used only for measuring.
PARTS = {"edge_right", "edge_right_exact", "edge_exact", "edge_exact_upright", "edge_rounded",
         "polygon_outline",
         "triangle_outline", "texturing_gentle", "texturing_gentle_from", "three_one", "longest_find",
         "crossings_find"}
#: What three_draw, deep_draw and far_find refer to: C, in the list of sources that polygon_draw needs; cover_draw: C of
#: c/coverage.
IN_C = {"_cover_rest", "_deep_rest", "_far_lengths", "_far_spans", "_kind_spans", "_three_rest", "_three_starts"}
MEASURED = {"pixel.s", "step.s", "floor.s", "instructions.s"}
#: Largest sizes of the example's programs in bytes, as in README.txt: unused routines are not
#: linked.
MOST = {"spans": 1_500, "example": 13_500, "triangles": 29_000}
#: Names of sections, by linker: of code, and of tables.
SECTIONS = {"vlink": {Hunk.HUNK_CODE: "CODE", Hunk.HUNK_DATA: "DATA"},
            "gcc": {Hunk.HUNK_CODE: ".text", Hunk.HUNK_DATA: ".data"}}
LIBRARIES = {"vlink": "tmap020.lib", "gcc": "libtmap020.a"}


@pytest.fixture(scope="module")
def kit(tmp_path_factory):
    """The SDK's folder, made by its name in another; its archive is in the same place."""
    folder = tmp_path_factory.mktemp("made")
    with contextlib.chdir(folder):
        assert sdk.command(Path("sdk")) == 0
    return folder / "sdk"


@dataclass
class Piece:
    """A hunk of an object as amitools reads it."""

    data: bytes
    name: str
    kind: int
    defined: dict[str, int]
    inside: dict[int, int]  # offsets to which the address of a hunk of the unit is added
    outside: dict[int, str]  # or a symbol's address


def piece(segment: list[dict]) -> Piece:
    """Converts a segment from amitools' reader."""
    made = Piece(bytes(segment[0].get("data", b"")), segment[0]["name"], segment[0]["type"], {}, {}, {})
    for hunk in segment[1:]:
        if hunk["type"] == Hunk.HUNK_ABSRELOC32:
            made.inside = {at: number for number, ats in hunk["reloc"].items() for at in ats}
        made.defined |= {each["name"]: each["def"] for each in hunk.get("ext_def", ())}
        for each in hunk.get("ext_ref", ()):
            assert each["type"] == Hunk.EXT_ABSREF32, each
            made.outside |= {at: each["name"] for at in each["refs"]}
    return made


def units(data: bytes) -> dict[str, list[Piece]]:
    """The units of an object or a library by name, each with its hunks."""
    reader = HunkReader()
    assert reader.read_file_obj("", io.BytesIO(data)) == Hunk.RESULT_OK, reader.error_string
    assert reader.build_segments(), reader.error_string
    return {unit["name"]: [piece(segment) for segment in unit["segments"]] for unit in reader.units}


@pytest.fixture(scope="module")
def libraries(kit):
    """The units of the hunk libraries, by linker."""
    return {linker: units((kit / "lib" / linker / name).read_bytes())
            for linker, name in LIBRARIES.items()}


@pytest.fixture(scope="module")
def elf(kit):
    """The sections of the ELF objects, by name."""
    return {path.name: elf_object.load(path)
            for path in sorted((kit / "lib" / "elf" / "objects").iterdir())}


def test_every_kernel_is_public_but_parts_and_measurements():
    names = {each.name for each in sdk.public()}
    others = [each for each in contracts.kernels(ROOT / "src68k") if each.name not in names]
    assert {each.name for each in others if Path(each.file).name not in MEASURED} == PARTS


def test_no_argument_in_frame_pointer_or_library_base():
    for each in sdk.public():
        used = [r for a in each.inputs + each.outputs for r in a.register.split(":")]
        assert not {"a5", "a6", "sp"}.intersection(used), f"{each.file}:{each.line}: {each.name}"


def test_every_routine_has_objects_and_entries(kit, libraries, elf):
    """Each routine has both names in all three libraries and in the include file, and a C
    declaration."""
    include = (kit / "include" / "tmap020.i").read_text()
    headers = subprocess.run(["m68k-linux-gnu-gcc", "-E", "-P", f"-I{kit / 'include'}",
                              kit / "include" / "tmap020.h"], capture_output=True, text=True).stdout
    defined = {"elf": {name for sections in elf.values() for s in sections for name in s.symbols}}
    defined |= {linker: {name for pieces in found.values() for p in pieces for name in p.defined}
                for linker, found in libraries.items()}
    for each in sdk.public():
        for name in (each.name, f"_{each.name}"):
            assert f"        xref    {name}\n" in include, name
            for form, names in defined.items():
                assert name in names, f"{form}: {name}"
        declared = rf"\b{each.name}\(|^\w+_pass [^;()]*\b{each.name}[,;]"
        assert re.search(declared, headers, re.M), each.name


def test_symbols_and_sections(libraries):
    """Every symbol has both names, every section its linker's name; nothing else is referred to."""
    for linker, found in libraries.items():
        pieces = [piece for unit in found.values() for piece in unit]
        assert all(piece.name == SECTIONS[linker][piece.kind] for piece in pieces), linker
        for unit in found.values():
            assert len({piece.kind for piece in unit}) == len(unit), linker
        defined = [name for piece in pieces for name in piece.defined]
        assert len(defined) == len(set(defined))
        for name in defined:
            assert (name[1:] if name.startswith("_") else f"_{name}") in defined, name
        assert {name for piece in pieces for name in piece.outside.values()} - IN_C <= set(defined)


def test_libraries_are_their_objects(kit, libraries, elf):
    listed = subprocess.run(["m68k-linux-gnu-ar", "t", kit / "lib" / "elf" / "libtmap020.a"],
                            capture_output=True, text=True, check=True).stdout.split()
    assert listed == list(elf)
    for linker, found in libraries.items():
        single = {path.name: units(path.read_bytes())[path.name]
                  for path in (kit / "lib" / linker / "objects").iterdir()}
        assert single == found and set(found) == set(elf), linker


def address_of(name: str) -> int:
    """A made-up address for a symbol of another object."""
    return 0x400000 + sum(ord(c) << k % 16 for k, c in enumerate(name)) * 4


def placed(data: bytes, fields: list[tuple[int, int, int]]) -> bytes:
    """The data with values written to its fields: offset, bytes, value."""
    out = bytearray(data)
    for offset, size, value in fields:
        out[offset:offset + size] = (value & (1 << 8 * size) - 1).to_bytes(size, "big")
    return bytes(out)


def linked_elf(sections: list[Section]) -> list[bytes]:
    """An object's sections after linking, the first at $10000, the next at $20000 ..."""
    base = {id(section): (k + 1) << 16 for k, section in enumerate(sections)}

    def value(section: Section, r: Relocation) -> int:
        target = address_of(r.target) if isinstance(r.target, str) else base[id(r.target)]
        return target + r.addend - (base[id(section)] + r.offset if r.relative else 0)

    return [placed(s.data, [(r.offset, r.size, value(s, r)) for r in s.relocations])
            for s in sections]


def linked_hunks(pieces: list[Piece]) -> list[bytes]:
    """The same for a unit: loaders and linkers add the address to the field."""
    def added(piece: Piece, at: int, address: int) -> tuple[int, int, int]:
        return at, 4, int.from_bytes(piece.data[at:at + 4], "big") + address

    return [placed(p.data, [added(p, at, (number + 1) << 16) for at, number in p.inside.items()]
                   + [added(p, at, address_of(name)) for at, name in p.outside.items()])
            for p in pieces]


def test_hunks_hold_what_elf_objects_do(libraries, elf):
    """The bytes are the same at any address, and so are the symbols."""
    for linker, found in libraries.items():
        for name, sections in elf.items():
            pieces = found[name]
            assert [p.defined for p in pieces] == [s.symbols for s in sections], (linker, name)
            for ours, theirs in zip(linked_hunks(pieces), linked_elf(sections), strict=True):
                assert ours[:len(theirs)] == theirs and len(ours) % 4 == 0, (linker, name)
                assert ours[len(theirs):] in (b"", hunk_object.NOP), (linker, name)


def test_objects_are_the_measured_ones(elf):
    """Every section of the project's own objects is in one of the SDK's, byte for byte."""
    home = {name: section for sections in elf.values() for section in sections
            for name in section.symbols}
    tree = sdk.built()
    for path in tree.needed([each.name for each in sdk.public()]):
        for section in tree.sections[path] if sdk.is_assembly(path) else ():
            name, offset = min(section.symbols.items(), key=lambda item: item[1])
            start = home[name].symbols[name] - offset
            assert start % 4 == 0, name
            assert home[name].data[start:start + section.size] == section.data, name


@pytest.mark.parametrize("name", ["span/affine_addx", "glide/bilinear"])
def test_hunks_are_as_vasm_writes_them(libraries, tmp_path, name):
    source, target = ROOT / "src68k" / f"{name}.s", tmp_path / "object"
    subprocess.run([ROOT / "scripts" / "vasm", "-quiet", "-m68020", "-Fhunk",
                    f"-I{ROOT / 'src68k' / 'include'}", f"-I{ROOT / 'build' / 'gen'}",
                    "-o", target, source], check=True)
    (theirs,), = units(target.read_bytes()).values()
    ours, = libraries["vlink"][f"{name.replace('/', '_')}.o"]
    assert (theirs.data, theirs.kind, theirs.defined, theirs.inside, theirs.outside) == (
        ours.data, ours.kind, ours.defined, ours.inside, ours.outside)


@pytest.mark.parametrize("size, relative", [(2, True), (4, True), (2, False)])
def test_distances_to_other_objects_are_refused(size, relative):
    section = Section("x.o", ".text", bytes(8), 8, 4, True, False,
                      [Relocation(2, size, relative, "outer", 0)])
    with pytest.raises(UserError, match="^x.o cannot be a hunk object: offset 2 of .text refers to "
                                        "outer by other than its address$"):
        hunk_object.unit("x.o", [section], hunk_object.VLINK)


def test_c_sources_ask_for_nothing_but_memory(kit):
    tree = sdk.built()
    missing = {name for sections in tree.sections.values() for name in sdk.references(sections)
               if name not in tree.home}
    assert missing == ASKED
    assert all(f"{name[1:]}(" in (kit / "README.txt").read_text() for name in ASKED)


def test_lists_of_sources(kit):
    """All listed files exist and every source is in a list; polygon_draw needs no memory."""
    text = (kit / "c" / "sources.mk").read_text().replace("\\\n", " ")
    lists = {name: files.split() for name, files in re.findall(r"^(\w+) := (.*)$", text, re.M)}
    assert set(lists) == {*sdk.LISTS, "own_screen"}
    assert all((kit / "c" / file).is_file() for file in lists.pop("own_screen"))
    listed = {file for files in lists.values() for file in files}
    assert listed == {str(path) for path in sdk.offered(".c")}
    assert all((kit / "c" / file).is_file() for file in listed)
    assert "drawing/page.c" not in lists["polygon_draw"]


@pytest.mark.parametrize("compiler", [name for name in COMPILERS if shutil.which(name)])
def test_headers_compile_alone(kit, tmp_path, compiler):
    include, output = kit / "include", "-o=" if compiler == "vbccm68k" else "-o"
    for path in sorted(include.rglob("*.h")):
        source = tmp_path / "header.c"
        source.write_text(f'#include "{path.relative_to(include)}"\n')
        done = subprocess.run([compiler, *COMPILERS[compiler], f"-I{include}", source,
                               f"{output}{tmp_path / 'out.s'}"], capture_output=True, text=True)
        assert done.returncode == 0, f"{path}: {done.stdout}{done.stderr}"


def square(number: int) -> np.ndarray:
    """Frame ``number`` of example.c as the model draws it."""
    cosine, sine = TURNS[number]
    vertices = [((WIDTH // 2 << 16) + (cosine * right - sine * down) * 1024,
                 (HEIGHT // 2 << 16) + (sine * right + cosine * down) * 1024,
                 (right > 0) * 255 << 16, (down > 0) * 255 << 16)
                for right, down in ((-60, -60), (60, -60), (60, 60), (-60, 60))]
    v, u = np.indices((256, 256))
    frame = np.zeros((HEIGHT, WIDTH), np.uint8)
    polygon = model.set_up(vertices, WIDTH, HEIGHT, True, Settings(edges="exact"))
    model.draw(frame, polygon, (u ^ v).astype(np.uint8), 0)
    return frame


def draw_triangles(frame: np.ndarray, triangles: list[list[tuple]]) -> int:
    """Draws triangles of x, y, s, t, all 16.16, with the XOR pattern, as triangles_draw does with ``cull``: those
    that are clockwise once their vertices are rounded. Returns how many."""
    settings, drawn = Settings(edges="snapped"), 0
    v, u = np.indices((256, 256))
    for three in triangles:
        vertices = model.adapt([(*corner, 0) for corner in three], settings, 256)
        (x0, y0), (x1, y1), (x2, y2) = (vertex[:2] for vertex in vertices)
        if (x1 - x0) * (y2 - y0) > (x2 - x0) * (y1 - y0):
            polygon = model.set_up(vertices, frame.shape[1], frame.shape[0], True, settings)
            if polygon:
                model.draw(frame, polygon, (u ^ v).astype(np.uint8), 0)
            drawn += 1
    return drawn


def box(number: int) -> np.ndarray:
    """Frame ``number`` of triangles.c as the model draws it."""
    cosine, sine = TURNS[number]
    corners = []
    for k in range(8):
        x, y, z = (40 if k >> bit & 1 else -40 for bit in range(3))
        right, away = cosine * x - sine * z, sine * x + cosine * z
        corners.append(((WIDTH // 2 << 16) + right * 1024 - (128 << 16) * (number == 3 and k == 0),
                        (HEIGHT // 2 << 16) + (TURNS[1][0] * 64 * y - TURNS[1][1] * away) * 16,
                        255 * (k & 1) << 16, (200 if k & 2 else 40) + (50 if k & 4 else 0) << 16))
    frame = np.zeros((HEIGHT, WIDTH), np.uint8)
    sides = (0, 1, 3, 2), (5, 4, 6, 7), (4, 0, 2, 6), (1, 5, 7, 3), (4, 5, 1, 0), (2, 3, 7, 6)
    drawn = draw_triangles(frame, [[corners[k] for k in three] for side in sides
                                   for three in (side[:3], (side[0], *side[2:]))])
    assert 4 <= drawn <= 8 and (min(x for x, *_ in corners) < 0) == (number == 3)
    return frame


def turned() -> np.ndarray:
    """The frame of spans.s, computed pixel by pixel."""
    y, x = np.indices((HEIGHT, WIDTH))
    u, v = 0xC000 * x - 0x6000 * y, 0x6000 * x + 0xC000 * y
    return ((u >> 16 ^ v >> 16) & 255).astype(np.uint8)


@pytest.mark.parametrize("tools", [name for name in TOOLS if all(map(shutil.which, TOOLS[name]))])
def test_example_draws_the_models_pictures(kit, tmp_path, tools):
    """Built with its Makefile, run on the machine with the least memory."""
    folder = kit / "example"
    done = subprocess.run(["make", "-C", folder, f"TOOLS={tools}", f"PYTHON={sys.executable}",
                           f"VASM={ROOT / 'scripts' / 'vasm'}"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    for name, most in MOST.items():
        assert (folder / tools / name).stat().st_size <= most, f"{tools}: {name}"
    results = emulator.run_batch(["example", "triangles", "spans"], {}, "a1200", tmp_path,
                                programs=folder / tools, timed=False)
    assert [(result.code, result.output) for result in results] == [(0, "")] * 3
    volume = results[0].directory
    for name, picture in (("frame", square), ("box", box)):
        for number in range(4):
            found = np.fromfile(volume / f"{name}_{number}.chunky", np.uint8).reshape(HEIGHT, WIDTH)
            expected = picture(number)
            assert (found == expected).all(), (
                f"{tools}, {name} {number}: {first_wrong(expected, found)}")
    planes = planar.Planes(WIDTH, HEIGHT, WIDTH // 8, WIDTH // 8 * HEIGHT, tuple(range(8)))
    found, expected = planes.decoded(np.fromfile(volume / "planes", np.uint8)), turned()
    assert (found == expected).all(), f"{tools}, planes: {first_wrong(expected, found)}"


def test_archive_holds_the_folder(kit):
    with tarfile.open(kit.with_name("tmap020-sdk.tar.gz")) as tar:
        packed = {member.name: tar.extractfile(member).read() for member in tar.getmembers()
                  if member.isfile()}
    found = {f"tmap020-sdk/{path.relative_to(kit)}": path.read_bytes() for path in kit.rglob("*")
             if path.is_file()}
    assert packed == {name: found[name] for name in packed}
    assert all(name in packed for name in found if "/example/" not in name)
    assert {f"tmap020-sdk/example/{name}" for name in sdk.EXAMPLE} <= set(packed)


def test_other_folders_are_left_alone(tmp_path):
    kept = tmp_path / "kept"
    kept.write_text("mine")
    with pytest.raises(UserError, match="holds something else than an SDK"):
        sdk.command(tmp_path)
    assert kept.read_text() == "mine"


def test_reference_has_every_call(kit) -> None:
    """Each call has one entry, each routine of assembly its registers, and the figures of the bench."""
    text = (kit / "REFERENCE.md").read_text()
    entries = re.findall(r"^### (\w+)$", text, re.M)
    assert len(entries) == len(set(entries))
    assert {each.name for each in sdk.public()} | {"screen_open", "display_fields", "key_take", "clock_start"} <= {*entries}
    parts = dict(re.findall(r"^### (\w+)$(.*?)(?=^##|\Z)", text, re.M | re.S))
    for each in sdk.public():
        for argument in (*each.inputs, *each.outputs):
            assert f" `{argument.register}` {argument.type}: {argument.meaning}\n" in parts[each.name], each.name
        assert "cycles" in parts[each.name] or each.cost in parts[each.name], each.name
    assert "`polygon_routine polygon_draw;`" in parts["polygon_draw"]
    baseline = json.loads(BASELINE.read_text())
    row = next(row for row in baseline["rows"] if bench.key(row) == ("affine_addx", "a1200-fast", 256))
    assert f"| `affine_addx` | 256 | cycles a pixel | {row['cycles_per_pixel']:.1f} |" in parts["span_affine_addx"]
