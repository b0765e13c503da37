"""A program of the SDK that names what it draws with links no more: combinations by size, and the same pixels as with all."""

import subprocess
import sys
from pathlib import Path

import pytest
from elftools.elf.elffile import ELFFile

from tmap.base.paths import ROOT
from tmap.guest import emulator
from tmap.product import sdk

#: Parts that a program names, the routines that it calls, and the most bytes of code and tables. The first two that
#: draw textures are the targets: 8 KB for batches of triangles, 12 KB for convex polygons.
COMBINATIONS = {
    "flat": ("FLAT TRIANGLES", "polygons_draw", 6_800),
    "batches": ("FLAT AFFINE TRIANGLES", "polygons_draw", 8_192),
    "polygons": ("AFFINE POLYGONS STEEP", "polygon_draw", 12_288),
    "triangles": ("FLAT AFFINE TRIANGLES STEEP ROWS SHORT", "polygon_draw, polygons_draw", 11_600),
    "gouraud": ("FLAT GOURAUD TRIANGLES STEEP", "polygon_draw", 10_900),
    "both": ("FLAT GOURAUD AFFINE TRIANGLES POLYGONS STEEP FANS", "polygon_draw, polygons_draw", 23_600),
    "lit": ("LIT_GOURAUD POLYGONS STEEP", "polygon_draw", 15_400),
    "words": ("FLAT AFFINE 16 32 POLYGONS STEEP ROWS", "polygon_draw", 16_400),
    "snapped": ("FLAT AFFINE SNAPPED", "triangles_draw, triangle_tables_make", 28_400),
    "pieces": ("AFFINE PERSPECTIVE STEEP", "polygon_draw", 34_000),
    "reciprocals": ("AFFINE RECIPROCALS STEEP", "polygon_draw", 46_000),
    "curves": ("AFFINE CURVES STEEP", "polygon_draw", 37_800),
    "perspectives": ("AFFINE RECIPROCALS CURVES 16 32 STEEP", "polygon_draw", 55_800),
    "others": ("ARBITRARY TILED COLUMNS GENERATED DITHERED KEYED STEEP", "polygon_draw", 21_200)}
EVERY = ("FLAT GOURAUD AFFINE ARBITRARY TILED COLUMNS GENERATED LIT LIT_GOURAUD DITHERED KEYED 16 32 ROWS SHORT STEEP "
         "STARTS SCANLINE CLIPPING PERSPECTIVE RECIPROCALS CURVES FANS COUNTS FORMS TRIANGLES POLYGONS SNAPPED")
FLAGS = ("-std=c99", "-m68020", "-O2", "-msoft-float", "-ffreestanding", "-fno-pic", "-fomit-frame-pointer",
         "-fleading-underscore", "-fno-tree-loop-distribute-patterns")
#: Triangles by all settings that need no other part, some of them across the frame's sides; then what is not named.
DRAWS = """
#include "tmap020.h"
enum { WIDTH = 160, HEIGHT = 128, PAGE = 65536, COUNT = 24 };
int32 save(const char *name, const void *data, int32 bytes);
static uint8 room[2 * PAGE];
static uint8 pixels[WIDTH * HEIGHT];
static struct material materials[5];
static struct vertex corners[3 * COUNT];
static struct polygon polygons[COUNT];
static struct scratch scratch;
static struct map map;
static struct renderer renderer;
static struct frame frame;

static int32 next(uint32 *seed, int32 most)
{
    *seed = *seed * 1664525 + 1013904223;
    return (int32)((*seed >> 16) * (uint32)most >> 16);
}

int main(void)
{
    uint8 *const texels = room + (PAGE - 1 - ((uint32)room - 1) % PAGE);
    uint32 seed = 1;
    int32 result = 0;

    for (int32 i = 0; i < PAGE; i++)
        texels[i] = (uint8)((i >> 8) ^ i);
    map.texels = texels;
    map.width = map.height = 256;
    map.scale = 1 << 16;
    map.layout = MAP_PAGE;
    map.texel_bytes = 1;
    frame.pixels = pixels;
    frame.width = frame.pitch = WIDTH;
    frame.height = HEIGHT;
    frame.pixel_bytes = 1;
    renderer.frame = &frame;
    renderer.scratch = &scratch;
    for (int32 k = 0; k < 5; k++) {
        materials[k].mapper = k == 0 ? MAPPER_FLAT : k == 4 ? MAPPER_ARBITRARY : MAPPER_AFFINE;
        materials[k].edges = k == 1 ? EDGES_EXACT : k == 2 ? EDGES_SUBPIXEL : EDGES_INTEGER;
        materials[k].gradients = GRADIENTS_PLANE;
        materials[k].start = START_SUBTEXEL;
        materials[k].colour = 77;
        materials[k].map = k ? &map : 0;
    }
    for (int32 k = 0; k < 4; k++) {
        for (int32 i = 0; i < COUNT; i++) {
            for (int32 j = 0; j < 3; j++) {
                struct vertex *v = &corners[3 * i + j];

                v->x = (next(&seed, 240) - 40) * 65536 + next(&seed, 65536);
                v->y = (next(&seed, 200) - 36) * 65536 + next(&seed, 65536);
                v->s = next(&seed, 256) << 16;
                v->t = next(&seed, 256) << 16;
            }
            polygon_set(&polygons[i], &corners[3 * i], 3, PLANAR_ALL);
        }
        if (k == 2)
            for (int32 i = 0; i < COUNT; i++)
                result |= polygon_draw(&renderer, &polygons[i], &materials[k]) > POLYGON_EMPTY;
        else
            result |= polygons_draw(&renderer, polygons, COUNT, &materials[k]) != POLYGON_DRAWN;
    }
    if (polygons_draw(&renderer, polygons, 1, &materials[4]) != POLYGON_REFUSED
        || !material_is_named(&materials[2], 1) || material_is_named(&materials[4], 1)
        || material_is_named(&materials[2], 2))
        result |= REFUSES;
    frame.pixel_bytes = 2;
    if (REFUSES && polygon_draw(&renderer, polygons, &materials[0]) <= POLYGON_EMPTY)
        result |= 1;
    return save(NAME, pixels, WIDTH * HEIGHT) ? 2 * result : 20;
}
"""


def run(*words: str | Path) -> None:
    """Runs a tool; shows its output if it fails."""
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(scope="module")
def kit(tmp_path_factory):
    """The SDK, and beside it one library of all it holds. C is compiled without sections for the linker to drop."""
    folder = tmp_path_factory.mktemp("parts") / "sdk"
    sdk.make(folder)
    objects = folder / "objects"
    objects.mkdir()
    text = (folder / "c" / "sources.mk").read_text().replace("\\\n", " ")
    lists = dict(line.split(" := ") for line in text.splitlines() if " := " in line)
    sources = {*lists["polygon_draw"].split(), *lists["triangles_draw"].split()}
    made = [compiled(folder, folder / "c" / name, objects / f"{name.replace('/', '_')}.o") for name in sorted(sources)]
    library = folder / "libdraw.a"
    library.write_bytes((folder / "lib" / "elf" / "libtmap020.a").read_bytes())
    run("m68k-linux-gnu-ar", "qcsD", library, *made)
    return folder


def compiled(kit: Path, source: Path, out: Path, *more: str) -> Path:
    """Compiles a C file as the example's Makefile does."""
    run("m68k-linux-gnu-gcc", *FLAGS, *more, f"-I{kit / 'include'}", f"-I{kit / 'c'}", "-c", "-o", out, source)
    return out


def parts_file(kit: Path, out: Path, names: str) -> Path:
    """The object of the C file that names the parts."""
    source = out.with_suffix(".c")
    source.write_text("".join(f"#define WITH_{name}\n" for name in names.split())
                      + '#include "drawing/parts/parts.h"\n')
    return compiled(kit, source, out, "-pedantic", "-Wall", "-Wextra", "-Werror")


def linked(kit: Path, out: Path, *objects: Path) -> Path:
    """Links a program for elf2hunk.py, without the linker's own search for what is not needed."""
    run("m68k-linux-gnu-ld", "-q", "-z", "noexecstack", "--no-check-sections", "-e", "0",
        "-T", kit / "example" / "amiga.ld", "-o", out, *objects, kit / "libdraw.a")
    return out


def size(program: Path) -> int:
    """Bytes of code and tables."""
    with program.open("rb") as stream:
        elf = ELFFile(stream)
        return sum(elf.get_section_by_name(name)["sh_size"] for name in (".text", ".data")
                   if elf.get_section_by_name(name))


@pytest.mark.parametrize("name", COMBINATIONS)
def test_size_of_what_is_named(kit, tmp_path, name):
    names, calls, most = COMBINATIONS[name]
    source = tmp_path / "main.c"
    source.write_text(f'#include "tmap020.h"\nvoid *called[] = {{{calls}}};\n')
    program = linked(kit, tmp_path / "program.elf", compiled(kit, source, tmp_path / "main.o"),
                     parts_file(kit, tmp_path / "parts.o", names))
    assert 0.9 * most < size(program) <= most, f"{size(program)} bytes of {most}"


def test_all_named_is_all_that_is_linked_without_names(kit, tmp_path):
    """And each part that is left out makes the program smaller."""
    source = tmp_path / "main.c"
    source.write_text('#include "tmap020.h"\nvoid *called[] = {polygon_draw, polygons_draw, triangles_draw, '
                      'triangle_tables_make, material_is_named};\n')
    main = compiled(kit, source, tmp_path / "main.o")
    whole = size(linked(kit, tmp_path / "whole.elf", main))
    named = size(linked(kit, tmp_path / "named.elf", main, parts_file(kit, tmp_path / "parts.o", EVERY)))
    assert named == whole
    implied = {"AFFINE", "POLYGONS", "LIT", "PERSPECTIVE"}  # by others, and SNAPPED by the call
    for left in sorted(set(EVERY.split()) - implied - {"SNAPPED"}):
        names = " ".join(each for each in EVERY.split() if each != left)
        less = size(linked(kit, tmp_path / "less.elf", main, parts_file(kit, tmp_path / "less.o", names)))
        assert less < whole, left


def test_named_parts_draw_what_all_do(kit, tmp_path):
    """The same triangles by a program that names batches, and by one that has everything: every pixel is the same.
    What is not named is refused."""
    source = tmp_path / "main.c"
    source.write_text('#include "drawing/parts/named.h"\n' + DRAWS)
    start = kit / "lib" / "elf" / "start.o"
    for name, refuses, parts in (("named", "1", "FLAT AFFINE TRIANGLES STEEP"), ("all", "0", None)):
        main = compiled(kit, source, tmp_path / "main.o", f'-DNAME="{name}.chunky"', f"-DREFUSES={refuses}")
        objects = [start, main] + ([parts_file(kit, tmp_path / "parts.o", parts)] if parts else [])
        program = linked(kit, tmp_path / f"{name}.elf", *objects)
        run(sys.executable, kit / "example" / "elf2hunk.py", program, tmp_path / name)
    results = emulator.run_batch(["named", "all"], {}, "a1200-fast", tmp_path / "run", programs=tmp_path,
                                 timed=False)
    assert [result.code for result in results] == [0, 0]
    found, expected = (results[0].directory / f"{name}.chunky" for name in ("named", "all"))
    assert found.read_bytes() == expected.read_bytes() and len(set(found.read_bytes())) > 100


def test_page_names_the_parts():
    """Every part is in the header's list, and the list has no other."""
    text = (ROOT / "c" / "drawing" / "parts" / "parts.h").read_text()
    head = text[:text.index("*/")]
    assert all(f"WITH_{name}" in head for name in EVERY.split())
