"""Schema and checks of texture engines in a scene's TOML: materials with a table ``n64``.

Names and values follow the N64 manual where possible; c/n64/n64.h explains them.
"""

import re
from dataclasses import dataclass

from tmap.base.fields import (REQUIRED, Reader, colour, expect, fail, flag, integer, number, one_of, one_or_rows,
                              reader, rows, table, text)
from tmap.n64.combiner import ABSENT, ALPHA_NAMES, RGB_NAMES
from tmap.n64.state import CI, I, IA, REACH, RGBA, TILES, YUV
from tmap.n64.words import CONVERTS, DETAILS, FILTERS, TLUTS, Cycle

#: A tile's formats by name: format and size in its descriptor.
TEXELS = {"rgba16": (RGBA, 2), "rgba32": (RGBA, 3), "yuv16": (YUV, 2), "ci4": (CI, 0),
          "ci8": (CI, 1), "ia4": (IA, 0), "ia8": (IA, 1), "ia16": (IA, 2), "i4": (I, 0),
          "i8": (I, 1)}
FRAMES = ("rgba5551", "rgba8888")  # formats of scenes that engines draw into
WRAPS = {"wrap": (0, 0), "mirror": (0, 1), "clamp": (1, 0), "mirror and clamp": (1, 1)}
COPY = "copy"  # cycle type of texture rectangles that copy texels unchanged
COPIED = ("rgba16", "ia16", "ci4", "ci8")
COPY_FRAMES = "rgba5551"
#: Fields that copy mode cannot follow, with the only value that they may have.
NOT_COPIED = {"perspective": False, "filter": "point", "convert": "filter", "lod": False,
              "detail": "clamp"}


def same(*inputs: str) -> Cycle:
    """Returns a cycle whose alpha inputs are the same as the colour's."""
    return Cycle(inputs, inputs)


OPAQUE = ("0", "0", "0", "one")
#: Combiner cycles by name: inputs A, B, C, D of (A - B) * C + D. In the second of two cycles
#: texel0 and texel1 have changed places.
PRESETS = {
    "primitive": same("0", "0", "0", "primitive"),
    "shade": same("0", "0", "0", "shade"),
    "decal": same("0", "0", "0", "texel0"),
    "modulate": same("texel0", "0", "shade", "0"),
    "modulate primitive": same("texel0", "0", "primitive", "0"),
    "blend": Cycle(("primitive", "environment", "texel0", "environment"), OPAQUE),
    "interference": same("texel0", "0", "texel1", "0"),
    "mix": same("texel1", "texel0", "primitive lod fraction", "texel0"),
    "trilinear": same("texel1", "texel0", "lod fraction", "texel0"),
    "convert": Cycle(("texel0", "k4", "k5", "texel0"), OPAQUE),
    "pass": same("0", "0", "0", "combined"),
    "modulate again": same("combined", "0", "shade", "0"),
    "modulate primitive again": same("combined", "0", "primitive", "0"),
    "blend again": Cycle(("primitive", "environment", "combined", "environment"), OPAQUE),
}


@reader('colour, `"#rrggbb"` or `"#rrggbbaa"`')
def colour_and_alpha(value, where):
    """Converts ``#rrggbb``, opaque, or ``#rrggbbaa`` to (red, green, blue, alpha)."""
    text(value, where)
    if re.fullmatch(r"#[0-9a-fA-F]{8}", value):
        return tuple(bytes.fromhex(value[1:]))
    return *colour(value, where), 255


def four(names: tuple):
    """Returns the check of a cycle's inputs A, B, C, D, given the names that each may have."""
    @reader("list of 4 inputs")
    def check(value, where):
        found = rows(text, 4, 4)(value, where)
        for i, (name, letter, known) in enumerate(zip(found, "ABCD", names)):
            allowed = [n for n in (*known, "0") if n and n not in ABSENT]
            if name not in allowed:
                fail(f"{where}[{i}]", f"{name!r} is no input {letter}; known are "
                                      + ", ".join(allowed))
        return tuple(found)
    return check


@reader("a preset's name, a list of two, or a table: "
        "`{ rgb = [[A, B, C, D]], alpha = [[A, B, C, D]] }`")
def combine(value, where) -> list[Cycle]:
    """Checks a preset, two presets, or lists of inputs; returns one cycle for each."""
    if isinstance(value, dict):
        found = table({"rgb": (rows(four(RGB_NAMES), 1, 2), REQUIRED, "a list of inputs a cycle"),
                       "alpha": (rows(four(ALPHA_NAMES), 1, 2), REQUIRED, "the same for alpha")})(value, where)
        if len(found["rgb"]) != len(found["alpha"]):
            fail(f"{where}.alpha", f"must have {len(found['rgb'])} entries, as rgb has")
        return [Cycle(*both) for both in zip(found["rgb"], found["alpha"])]
    expect(value, where, (str, list), "a preset's name, a list of two, or a table")
    preset = one_of(*PRESETS)
    names = rows(preset, 1, 2)(value, where) if isinstance(value, list) else [preset(value, where)]
    return [PRESETS[name] for name in names]


def tile_schema() -> Reader:
    """Returns the check of a tile. None: depends on the picture."""
    edge = number(0, REACH - 0.25, "texels")
    axis = table({"wrap": (one_of(*WRAPS), "wrap", "what is beyond the picture"),
                  "mask": (integer(0, 10), None, "bits of a texel's number that count; without it, as it needs"),
                  "shift": (integer(0, 15), 0, "1 to 10: halves s or t so often; 15 to 11: doubles it 1 to 5 times"),
                  "low": (edge, 0, "the first texel that is shown"),
                  "high": (edge, None, "the last one; without it, the picture's")})
    return table({
        "image": (text, REQUIRED, "a picture, as of `[textures]`"),
        "format": (one_of(*TEXELS), REQUIRED, "of its texels"),
        "width": (integer(1, 1024, unit="texels"), None, "cuts and scales the picture; without it, the picture's own"),
        "height": (integer(1, 256, unit="texels"), None, "the same for its height"),
        "s": (axis, {}, "how the tile continues to the right"), "t": (axis, {}, "the same downwards"),
        "palette": (one_or_rows(integer(0, 15), 1, 1000, "one a frame"), 0, "row of the palettes for `ci4` texels"),
        "colours": (integer(0, 15), None, "the row that `ci4` texels are made for; without it, the first `palette`"),
        "levels": (integer(1, TILES), 1, "levels of a mipmap, a tile each, of means of 2x2 texels"),
        "load": (one_of("block", "tile"), None, "the command that loads it; without it, a block if that can"),
        "tmem": (integer(0, 511, unit="TMEM words"), None, "its place; without it, the first where it fits"),
        "slide": (rows(number(-REACH, REACH, "texels a frame"), 2, 2), [0, 0], "motion of the picture along s and t")})


@reader('1, 2 or `"copy"`')
def cycle_type(value, where):
    """Checks the number of cycles a pixel, or copy mode."""
    if isinstance(value, str):
        return one_of(COPY)(value, where)
    return integer(1, 2)(value, where)


def schema() -> Reader:
    """Returns the check of a material's ``n64``."""
    presets = ", ".join(f"`{name}`" for name in PRESETS)
    return table({
        "cycles": (cycle_type, 1, "cycles a pixel; two for two texels or levels; `copy` is for rectangles"),
        "combine": (combine, "decal", f"(A - B) * C + D of each cycle; presets: {presets}"),
        "perspective": (flag, False, "corners have w, a depth"),
        "filter": (one_of(*FILTERS), "point", "one texel; a mean of three; of four in the middle"),
        "convert": (one_of(*CONVERTS), "filter", "what the cycles do with texels: filter, or convert YUV"),
        "k": (rows(integer(-256, 255), 6, 6), [175, -43, -89, 222, 114, 42], "k0 to k5 of the conversion"),
        "lod": (flag, False, "chooses tiles by the level of detail"),
        "detail": (one_of(*DETAILS), "clamp", "what is drawn where the texture is magnified"),
        "min_level": (integer(0, 31), 0, "least level, in 1/32, for detail and sharpening"),
        "max_level": (integer(0, 7), None, "the last level; without it, that of the last tile"),
        "tlut": (one_of(*TLUTS), None, "format of palettes; without it, `rgba16` for `ci` tiles, else none"),
        "palettes": (text, None, "a picture of palettes, 16 colours a row; without it, they are made from the tiles"),
        "primitive": (colour_and_alpha, "#000000", "the combiner's colour `primitive`"),
        "environment": (colour_and_alpha, "#000000", "the combiner's colour `environment`"),
        "primitive_lod_fraction": (integer(0, 255), 0, "the combiner's number of this name"),
        "tile": (integer(0, 7), 0, "the first tile that is drawn"),
        "tiles": (rows(tile_schema(), 1, TILES), REQUIRED, "tiles with their pictures")})


def copies(engine: dict) -> bool:
    """Returns True if an engine is in copy mode."""
    return engine["cycles"] == COPY


def inputs_of(engine: dict) -> set[str]:
    """Returns the names of the inputs in use, with texel0 and texel1 as in the first cycle."""
    cycles, found = engine["combine"], set()
    for number_, cycle in enumerate(cycles):
        for name in (*cycle.rgb, *cycle.alpha):
            name = name.removesuffix(".a")
            if number_ and name in ("texel0", "texel1"):
                name = "texel1" if name == "texel0" else "texel0"
            found.add(name)
    if engine["cycles"] == 1 and "texel1" in found:
        found = found - {"texel1"} | {"texel0"}
    return found


@dataclass(frozen=True)
class Looks:
    """Vertex values that an engine needs."""

    depth: bool  # w
    shade: bool


def looks(material: dict) -> Looks | None:
    """Returns a material's needs; None if it has no engine."""
    engine = material.get("n64")
    return engine and Looks(engine["perspective"], "shade" in inputs_of(engine))


def numbers(engine: dict) -> list[int]:
    """Returns the number of each tile's first level, then the number after the last level."""
    found = [0]
    for tile in engine["tiles"]:
        found.append(found[-1] + tile["levels"])
    return found


def is_ci(tile: dict) -> bool:
    """Returns True if a tile's texels are palette indices."""
    return TEXELS[tile["format"]][0] == CI


def check_tile(engine: dict, number_: int, where: str) -> None:
    """Refuses a tile that does not go with the first one, or has fields of another format."""
    tile, at = engine["tiles"][number_], f"{where}.tiles[{number_}]"
    if is_ci(tile) and engine["tlut"] == "none":
        fail(f"{where}.tlut", f'"none", but tiles[{number_}] is {tile["format"]}')
    if is_ci(tile) != is_ci(engine["tiles"][0]):
        fail(f"{at}.format", f'"{tile["format"]}": with a TLUT all tiles are CI, without it none')
    for name, plain in (("palette", [0]), ("colours", None)):
        if tile[name] != plain and tile["format"] != "ci4":
            fail(f"{at}.{name}", f'is for "ci4", not "{tile["format"]}"')


def check_tiles(engine: dict, where: str) -> None:
    """Refuses more tiles than an engine has, tiles that do not exist, and tiles that do not go
    together; fills in defaults."""
    firsts = numbers(engine)
    for i, (tile, end) in enumerate(zip(engine["tiles"], firsts[1:])):
        if end > TILES:
            fail(f"{where}.tiles[{i}].levels", f"makes {end} tiles; an engine has {TILES}")
        check_tile(engine, i, where)
        if tile["colours"] is None:
            tile["colours"] = tile["palette"][0]
    has_tlut = is_ci(engine["tiles"][0])
    if not has_tlut and (engine["tlut"] or "none") != "none":
        fail(f"{where}.tlut", f'"{engine["tlut"]}", but no tile is CI')
    if not has_tlut and engine["palettes"]:
        fail(f"{where}.palettes", "there is no tile that is CI")
    engine["tlut"] = engine["tlut"] or ("rgba16" if has_tlut else "none")
    check_last(engine, firsts[-1], where)


def check_last(engine: dict, count: int, where: str) -> None:
    """Refuses an engine that would draw a tile after its last; fills in the highest level."""
    first = engine["tile"] + (engine["detail"] == "detail" and engine["lod"])  # after a detail tile
    if engine["max_level"] is None:
        engine["max_level"] = max(count - 1 - first, 0) if engine["lod"] else 0
    last = first + engine["max_level"] if engine["lod"] else engine["tile"] + ("texel1" in inputs_of(engine))
    if last >= count:
        fail(f"{where}.tiles", f"tile {last} would be drawn; there are tiles 0 to {count - 1}")


def check_copy(engine: dict, where: str) -> None:
    """Refuses settings that copy mode cannot follow."""
    for name, plain in (NOT_COPIED | {"combine": [PRESETS["decal"]]}).items():
        if engine[name] != plain:
            fail(f"{where}.{name}", "is not for copy mode, which leaves texels as they are")
    for i, tile in enumerate(engine["tiles"]):
        if tile["format"] not in COPIED:
            fail(f"{where}.tiles[{i}].format", f'"{tile["format"]}": copy mode is for '
                                               + ", ".join(COPIED))


def check(engine: dict, where: str) -> None:
    """Refuses modes and tiles that do not go together; fills in defaults."""
    if copies(engine):
        check_copy(engine, where)
        check_tiles(engine, where)
        return
    if len(engine["combine"]) > engine["cycles"]:
        fail(f"{where}.combine", 'has two cycles: "cycles" must be 2')
    if len(engine["combine"]) < engine["cycles"]:
        engine["combine"] = [*engine["combine"], PRESETS["pass"]]
    if engine["cycles"] == 1:
        if engine["lod"] or "lod fraction" in inputs_of(engine):
            fail(f"{where}.{'lod' if engine['lod'] else 'combine'}",
                 'the level of detail needs "cycles" 2')
        if engine["convert"] == "filter, convert":
            fail(f"{where}.convert", '"filter, convert" needs "cycles" 2')
    check_tiles(engine, where)
