"""Programs built for one scene: they draw what the full renderer draws, as fast, and contain
nothing else."""

import json
import shutil

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import main
from tmap.base.errors import UserError
from tmap.base.paths import PROGRAMS, PROGRAMS_BASELINE, SCENES
from tmap.build import elf_object
from tmap.build.elf_object import Relocation, Section
from tmap.product import program_layout, program_parts, scene_program

MESH = """\
title = "A pyramid"
width = 96
height = 64
frames = 2
background = "#101420"
[textures]
wall.image = "wall.png"
[materials]
wall = { texture = "wall", perspective = "every16" }
[camera]
eye = [0, 1, 3]
target = [0, 0, 0]
fov = 60
[[objects]]
points = [[-1, -1, -1], [1, -1, -1], [1, -1, 1], [-1, -1, 1], [0, 1, 0]]
faces = [[0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0]]
uvs = [[[0, 256], [128, 0], [256, 256]]]
material = "wall"
turns = 0.1
"""
FLAT = """\
width = 64
height = 48
frames = 3
background = "#102030"
[materials]
red.colour = "#ff0000"
[[objects]]
material = "red"
sides = 5
radius = 20
centre = [30, 24]
turns = 0.4
"""
#: A point-sampled tile, which becomes a page for the plain mappers, and a filtered one.
UNITS = """\
width = 64
height = 32
frames = 2
format = "rgba5551"
background = "#102030"
[materials.page.n64]
tiles = [{ image = "tile.png", format = "rgba16" }]
[materials.filtered.n64]
filter = "bilerp"
tiles = [{ image = "tile.png", format = "ia8", s.wrap = "mirror" }]
[[objects]]
material = "page"
vertices = [[1, 1, 0, 0], [30, 2, 40, 0], [28, 30, 40, 40], [2, 28, 0, 40]]
centre = [0, 0]
[[objects]]
material = "filtered"
vertices = [[1, 1, 0, 0], [30, 2, 20, 0], [28, 30, 20, 20], [2, 28, 0, 20]]
centre = [32, 0]
"""
#: Nothing moves. One polygon each of: flat, prepared; two triangles and a quad; beyond the frame; a level edge with the
#: same t at its ends; perspective; no table for its edges; tiles; a map that does not repeat; light; shades.
STILL = """\
width = 128
height = 96
frames = 11
background = "#102030"
[textures]
tile.image = "tile.png"
wall.image = "wall.png"
big.image = "checker.png"
[materials]
red = { colour = "#ff0000", edges = "snapped" }
wall = { texture = "wall", edges = "snapped" }
deep = { texture = "tile", perspective = "every8" }
exact = { texture = "wall", edges = "exact" }
lit = { texture = "wall", mapper = "lit", edges = "snapped" }
tiled = { texture = "big", mapper = "tiled" }
once = { texture = "wall", mapper = "arbitrary" }
shade = { shades = ["#000000", "#ffffff"], edges = "snapped" }
[[objects]]
material = "red"
sides = 5
radius = 20
centre = [30, 24]
[[objects]]
material = "wall"
vertices = [[1, 1, 0, 0], [60, 2, 512, 0], [58, 60, 512, 512], [2, 56, 0, 512]]
[[objects]]
material = "wall"
vertices = [[90, 2, 0, 0], [110, 3, 256, 0], [98, 20, 256, 256]]
[[objects]]
material = "wall"
vertices = [[40, -10, 0, 0], [90, 12, 256, 0], [58, 60, 256, 256]]
[[objects]]
material = "wall"
vertices = [[70, 50, 0, 0], [120, 50, 256, 0], [98, 90, 256, 0]]
[[objects]]
material = "deep"
vertices = [[70, 10, 0, 0, 1], [120, 5, 256, 0, 3], [98, 60, 256, 256, 2]]
[[objects]]
material = "exact"
vertices = [[10, 60, 0, 0], [50, 65, 256, 0], [30, 90, 256, 256]]
[[objects]]
material = "tiled"
vertices = [[60, 60, 0, 0], [75, 65, 256, 0], [70, 90, 256, 256]]
[[objects]]
material = "once"
vertices = [[80, 60, 0, 0], [95, 65, 256, 0], [90, 90, 256, 256]]
[[objects]]
material = "lit"
vertices = [[100, 60, 0, 0, 90], [115, 65, 256, 0, 90], [110, 90, 256, 256, 90]]
[[objects]]
material = "shade"
vertices = [[1, 70, 0], [15, 75, 128], [10, 90, 255]]
"""
#: Bytes of programs' files by their parts, built with gcc.
BASELINE = json.loads(PROGRAMS_BASELINE.read_text())
#: The most that a program of one textured triangle may have without its map.
TRIANGLE_MOST = 4_096


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The scenes' files."""
    made = tmp_path_factory.mktemp("scenes")
    texels = np.indices((64, 64)).sum(axis=0) // 8 % 2 * 200 + 30
    Image.fromarray(np.repeat(texels[..., None], 3, axis=2).astype(np.uint8)).save(
        made / "wall.png")
    Image.fromarray(np.stack([texels[:16, :16]] * 3 + [255 - texels[:16, :16]], -1).astype(
        np.uint8)).save(made / "tile.png")
    (made / "units.toml").write_text(UNITS)
    (made / "mesh.toml").write_text(MESH)
    (made / "flat.toml").write_text(FLAT)
    (made / "still.toml").write_text(STILL)
    shutil.copy(SCENES / "checker.png", made)
    return made


#: Of each program: routines that it has, of some one at least, and routines that it has not.
INSIDE = {
    "triangle": (({"triangles_affine"}, {"box_fill"}),
                 {"span_fill", "triangle_polygon", "triangle_fans", "polygon_draw", "clock_start", "fault", "text_print",
                  "mem_need", "touched_vertices", "touched_next", "span_affine_addx", "edge_addx", "texturing_plane",
                  "span_affine_row", "span_lit", "span_tiled", "span_gouraud", "edge_addx_exact",
                  "perspective_lines", "mesh_transform_wide", "mesh_draw"}),
    "still": (({"triangles_affine"}, {"triangles_gouraud"}, {"polygon_draw"}, {"span_lit"}, {"span_tiled"}),
              {"scene_make", "scene_copy_maps", "scene_place", "clock_start", "fault"}),
    "mesh": (({"mesh_transform_wide"}, {"mesh_faces_wide"}),
             {"mesh_transform", "mesh_gather", "span_lit", "span_tiled", "span_generated", "span_cubic_right",
              "span_light", "span_light_gouraud", "light_draw"}),
    "flat": (({"span_fill"}, {"edge_flat_exact"}), {"edge_addx", "texturing_plane", "mesh_transform_wide"}),
    # The parts of their engine that the scene needs: no levels, divides or combiner.
    "units": (({"span_affine_16", "span_affine_16_wrap"}, {"n64_threepoint_16"}, {"n64_weights"},
               {"n64_command"}),
              {"n64_divide", "n64_lod", "n64_combiner", "n64_lerp", "n64_convert",
               "n64_draw_pixel", "span_affine_addx"})}


@pytest.mark.parametrize("name", INSIDE)
def test_program_of_a_scene(folder, tmp_path, capsys, name: str):
    """It is as fast as the full renderer, its table is that of its file, and it contains only what
    it needs.

    The command itself refuses a program whose frames are not the full renderer's, byte for byte;
    ``test_wrong_frame_is_refused`` tests that.
    """
    path = (SCENES if name == "triangle" else folder) / f"{name}.toml"
    assert main(["scene-program", str(path), "-o", str(tmp_path)]) == 0, capsys.readouterr().err
    about = json.loads((tmp_path / "program.json").read_text())
    ticks, sizes = about["ticks"], about["bytes"]
    apart = [own - full for own, full in zip(ticks["own"], ticks["full"], strict=True)]
    assert max(apart) <= scene_program.LONGER, (
        f"{name}: ticks beside the full renderer's by {apart}; "
        f"scripts/tmap scene-program {name}.toml")
    assert sizes["file"] == (tmp_path / name).stat().st_size
    assert sizes["code"] + sizes["scene"] + sizes["maps"] == sizes["file"]
    assert about["full_bytes"]["code"] == (PROGRAMS / "render").stat().st_size
    if name in BASELINE and about["compiler"].startswith("gcc"):
        most = BASELINE[name]["code"] + BASELINE[name]["scene"]
        assert sizes["without_maps"] <= most, f"{name}: {sizes['without_maps']} bytes without its maps, not {most}"
    assert name != "triangle" or sizes["without_maps"] < TRIANGLE_MOST
    lines = (tmp_path / f"{name}.map").read_text().splitlines()
    inside, (needed, others) = {line.split()[1] for line in lines}, INSIDE[name]
    assert all(some & inside for some in needed) and not inside & others
    if name == "flat":
        assert sizes["maps"] == 0
        assert not {each for each in inside if each.startswith("span_")} - {"span_fill"}


def test_wrong_frame_is_refused():
    full = scene_program.Run({"frame_000.chunky": b"ab"}, [10])
    scene_program.compare(full, full, "toy")
    with pytest.raises(UserError, match="toy: frame_000.chunky is not what the full renderer"):
        scene_program.compare(full, scene_program.Run({"frame_000.chunky": b"ax"}, [10]), "toy")
    with pytest.raises(UserError, match="toy: 0 frames drawn and 0 timed where the full renderer "
                       "has 1 and 1"):
        scene_program.compare(full, scene_program.Run({}, []), "toy")


@pytest.mark.parametrize("name, text, wanted", [
    ("bad", FLAT.replace("width = 64", "width = 63"), "width"),
    ("bad", FLAT.replace('colour = "#ff0000"', 'color = "#ff0000"'), "materials.red"),
    ("none", None, "none.toml"),
    ("two words", FLAT, "two words.toml: its name is not from 1 to 30 letters"),
])
def test_bad_input_is_one_line(tmp_path, capsys, name, text, wanted):
    path, out = tmp_path / f"{name}.toml", tmp_path / "out"
    if text:
        path.write_text(text)
    assert main(["scene-program", str(path), "-o", str(out)]) == 2
    message = capsys.readouterr().err
    assert message.count("\n") == 1 and wanted in message, message
    assert not out.exists()


def section(name: str, data: bytes, room: str = "amiga", **more) -> Section:
    """A section of code."""
    return Section(f"build/obj/asm/{room}/{name}.o", f".text.{name}", data, len(data), 4,
                   code=True, **more)


def test_calls_of_what_never_ran_stop():
    """A pointer to a routine that was not executed leads to an ILLEGAL."""
    entry = section("start", bytes(8), symbols={"start": 0},
                    relocations=[Relocation(2, 4, False, "other", 0)])
    other = section("other", bytes(64), "span", symbols={"other": 0})
    program = program_parts.Program([entry, other], {}, {})
    assert other not in program.parts
    layout = program_layout.Layout(program, {})
    image, code, bss, _ = layout.link()
    assert code == [2] and bss == []
    stop = int.from_bytes(image[2:6], "big")
    assert image[stop:stop + 2] == program_parts.ILLEGAL


def test_calls_need_no_relocation():
    """jsr and jmp with an address become branches of a 68000, or of a 68020 if the code is timed
    once. Repeatedly timed code is unchanged, and so are addresses of data and of cleared memory."""
    calls = bytes.fromhex("4eb900000000 4ef900000000 4eb900000000 223c00000000")
    other = section("other", bytes(64), symbols={"other": 0})
    cleared = Section("build/obj/asm/amiga/x.o", ".bss.x", b"", 8, 4, bss=True, symbols={"x": 0})
    entry = section("start", calls, symbols={"start": 0}, relocations=[
        Relocation(place, 4, False, target, addend) for place, target, addend in
        ((2, "other", 8), (8, "other", 10), (14, "x", 4), (20, "other", 0))])
    images = []
    for timed in range(3):
        program = program_parts.Program([entry, other, cleared], {}, {entry: ([], timed)})
        image, code, bss, _ = program_layout.Layout(program, {}).link()
        assert (sorted(code), bss) == ([2, 8, 20] if timed == 2 else [20], [14])
        assert image[12:18].hex() == "4eb900000004"
        images.append(image[:12].hex())
    at = int.from_bytes(image[20:24], "big")
    assert images == [f"6100{at + 6:04x}4e716000{at + 2:04x}4e71", f"61ff{at + 6:08x}60ff{at + 2:08x}",
                      f"4eb9{at + 8:08x}4ef9{at + 10:08x}"]
    assert program_layout.branch(bytes.fromhex("4eb9"), 1 << 15, 0) is None


def test_strings_are_parts_of_their_own():
    """A program contains only the strings that it refers to."""
    whole = Section("build/obj/gcc/system/x.o", ".rodata.x.str1.1", b"ab\0\0cde\0", 8, 4)
    strings = elf_object.split_strings(whole)
    assert {at: part.data for at, part in strings.items()} == {0: b"ab\0", 3: b"\0", 4: b"cde\0"}
    assert elf_object.part_at(strings, 5) == (strings[4], 1)
    assert elf_object.part_at(strings, 3) == (strings[3], 0)


def test_what_nothing_defines_is_refused():
    entry = section("start", bytes(8), symbols={"start": 0},
                    relocations=[Relocation(2, 4, False, "gone", 0)])
    with pytest.raises(UserError, match="start.o: gone: nothing defines it"):
        program_parts.Program([entry], {}, {})


def test_fixed_places_keep_their_cache_lines():
    """Timed sections have the same cache lines as in the full renderer, modulo the cache's size,
    and do not overlap."""
    entry = section("start", bytes(8), symbols={"start": 0}, relocations=[
        Relocation(0, 4, False, "a", 0), Relocation(4, 4, False, "b", 0)])
    a = section("a", bytes(40), symbols={"a": 0})
    b = section("b", bytes(40), symbols={"b": 0})
    program = program_parts.Program([entry, a, b], {}, None)
    layout = program_layout.Layout(program, {a: 0x1234, b: 0x5230})
    assert layout.at[a] % program_layout.CACHE == 0x34 and layout.at[b] % program_layout.CACHE == 0x30
    assert abs(layout.at[a] - layout.at[b]) >= 40 + program_layout.AHEAD


def test_holes_are_not_in_the_file():
    """A file has the code without its holes, a table to place it by, and addresses where the loader finds them."""
    a = section("a", bytes.fromhex("4e71 4e71 23c000000000"), symbols={"a": 0},
                relocations=[Relocation(6, 4, False, "cell", 4)])
    entry = section("start", bytes.fromhex("4eb900000000 41f900000000"), symbols={"start": 0}, relocations=[
        Relocation(2, 4, False, "a", 0), Relocation(8, 4, False, "holes", 0)])
    cell = Section("build/obj/asm/amiga/x.o", ".bss.x", b"", 8, 4, bss=True, symbols={"cell": 0})
    holes = Section("", program_layout.HOLES, b"", 0, 4, bss=True, symbols={"holes": 0})
    program = program_parts.Program([entry, a, cell, holes], {}, None)
    layout = program_layout.Layout(program, {a: 0x180 - 256})
    place = layout.at[a]
    assert place == 0x80
    image = layout.link()[0]
    numbers = np.frombuffer(layout.hunks(), ">u4").tolist()
    assert numbers[2:8] == [3, 0, 2, len(image) // 4, 2, 4] and numbers[9] == 6  # longwords in memory, in the file
    packed = np.array(numbers[10:16], ">u4").tobytes()
    assert packed == image[:12] + image[place:place + 12]
    table = np.array(numbers[-9:-5], ">u4").tobytes()
    ends, steps = np.frombuffer(table[:8], ">u4").tolist(), np.frombuffer(table[8:], ">u2").tolist()
    assert ends == [24, len(image)] and steps[:2] == [5, place - 12]
