"""Builds the display lists and the DRAM of a scene's texture engines."""

from pathlib import Path

import numpy as np

from tmap.base.byte_pool import BytePool
from tmap.base.errors import UserError
from tmap.base.fields import fail, join
from tmap.compiler.n64 import numbers
from tmap.compiler.n64_tiles import EDGE_MAX, Axis, Palettes, Tile, make, place
from tmap.n64 import commands
from tmap.n64.loads import BLOCK_TEXELS
from tmap.n64.state import State
from tmap.n64.words import List, drifts

Words = list[tuple[int, int]]


def is_block(tile: Tile) -> bool:
    """Returns True if a tile's texels can be loaded as one block."""
    texture = tile.texture
    row = texture.row_texels << texture.size >> 4  # 64-bit words
    return (len(texture.data) >> max(texture.size, 2) - 1 <= BLOCK_TEXELS
            and not drifts(row, texture.height))


def load(words: List, tile: Tile, palette: int) -> None:
    """Loads a tile's texels and sets its descriptor."""
    texture, wanted = tile.texture, tile.spec["load"]
    fits = is_block(tile)
    if wanted == "block" and not fits:
        fail(f"{tile.where}.load", f'"block", but {texture.width}x{texture.height} texels are too '
                                   "many, or their rows drift; \"tile\" can load them")
    common = {"tmem": tile.tmem, "tile": tile.number}
    looks = tile.address, texture.form, texture.size, texture.row_texels
    if fits and wanted != "tile":
        words.load_texture_block(*looks, texture.height, palette, tile.s.wrap, tile.t.wrap,
                                 **common)
    else:
        corners = 0, 0, texture.row_texels - 1, texture.height - 1
        words.load_texture_tile(*looks, corners, palette, tile.s.wrap, tile.t.wrap, **common)


def describe(words: List, tile: Tile, palette: int) -> None:
    """Sets a tile's descriptor without loading texels."""
    texture = tile.texture
    words.set_tile(tile.number, texture.form, texture.size, tile.line, tile.tmem, palette,
                   tile.s.wrap, tile.t.wrap)


def edges(tile: Tile, frame: int) -> tuple[int, int, int, int]:
    """Returns sl, tl, sh and th of a tile in a frame, 10.2."""
    found = []
    for axis, step in zip((tile.s, tile.t), tile.spec["slide"]):
        low, high = axis.low, axis.high
        if step and not axis.clamps:  # an axis whose mask became 0 is one texel
            low = moved(axis, step * frame, tile.level)
            high = min(low + axis.high - axis.low, EDGE_MAX)
        found.append((low, high))
    (sl, sh), (tl, th) = found
    return sl, tl, sh, th


def moved(axis: Axis, way: float, level: int) -> int:
    """Returns the edge of an axis that moves by texels of level 0, wrapped to its period; 10.2."""
    period = 4 << axis.wrap.mask + axis.wrap.mirror
    return (axis.low + (round(4 * way) >> level)) % period


def set_modes(words: List, engine: dict) -> None:
    """Sets all modes, colours and constants."""
    words.cycle_type({1: "one", 2: "two"}.get(engine["cycles"], engine["cycles"]))
    words.texture_perspective(engine["perspective"])
    words.texture_detail(engine["detail"])
    words.texture_lod(engine["lod"])
    words.texture_lut(engine["tlut"])
    words.texture_filter(engine["filter"])
    words.texture_convert(engine["convert"])
    words.set_convert(*engine["k"])
    words.combine_mode(engine["combine"][0], engine["combine"][-1])
    words.prim_colour(engine["min_level"], engine["primitive_lod_fraction"], engine["primitive"])
    words.env_colour(engine["environment"])
    words.texture(engine["max_level"], engine["tile"])


def load_palettes(words: List, palettes: Palettes, dram: BytePool) -> None:
    """Loads an engine's palettes into TMEM."""
    for first, entries in sorted(palettes.entries.items()):
        words.load_tlut(len(entries), 256 + first, dram.put(entries.astype(">u2").tobytes()))


def lists_of(engine: dict, folder: Path, where: str, frames: int, dram: BytePool) -> list[Words]:
    """Returns an engine's display lists: one for the start and, if anything moves, one for each
    frame."""
    tiles, palettes = make(engine, folder, where)
    place(tiles, dram, engine["tlut"] != "none")
    start = List()
    set_modes(start, engine)
    load_palettes(start, palettes, dram)
    for tile in tiles:
        begin = describe if tile.is_loaded else load
        begin(start, tile, tile.spec["palette"][0])
        start.set_tile_size(tile.number, *edges(tile, 0))
    lists = [start.words]
    if any(any(tile["slide"]) or len(tile["palette"]) > 1 for tile in engine["tiles"]):
        for frame in range(frames):
            words = List()
            words.tile_sync()
            for tile in tiles:
                palette = tile.spec["palette"]
                if len(palette) > 1:
                    describe(words, tile, palette[frame % len(palette)])
                if any(tile.spec["slide"]):
                    words.set_tile_size(tile.number, *edges(tile, frame))
            lists.append(words.words)
    return lists


def check(lists: list[Words], dram: BytePool, where: str) -> None:
    """Refuses lists that the engine's model refuses."""
    state = State(np.frombuffer(bytes(dram.data), np.uint8))
    try:
        for words in lists:
            commands.replay(state, words)
    except UserError as error:
        fail(where, str(error))


def build(spec: dict, folder: Path, frames: int, where: str) -> tuple[dict[str, int], dict]:
    """Returns the number of each material's engine, and the tables of all engines for a Scene. Sets
    sizes that tiles take from their pictures."""
    numbers_, known, dram = {}, {}, BytePool()
    units, lists, words = [], [], []
    for name, material in spec["materials"].items():
        if "n64" not in material:
            continue
        engine, at = material["n64"], join(f"{where}materials", name) + ".n64"
        key = repr(engine)
        if key not in known:
            made = lists_of(engine, folder, at, frames, dram)
            check(made, dram, at)
            known[key] = len(units), engine["tiles"]
            units.append([len(lists), len(made)])
            for each in made:
                lists.append([len(words), len(each)])
                words += each
        numbers_[name], engine["tiles"] = known[key]
    tables = {"units": units, "lists": lists, "words": words}
    return numbers_, {name: np.array(rows, np.int64).reshape(-1, 2)
                      for name, rows in tables.items()} | {"dram": bytes(dram.data)}


def size_of(material: dict) -> tuple[int, int]:
    """Returns the size in texels of the first tile that an engine draws, after ``build``."""
    engine = material["n64"]
    tile = next(tile for tile, end in zip(engine["tiles"], numbers(engine)[1:]) if engine["tile"] < end)
    return tile["width"], tile["height"]
