"""The tiles of a scene's texture engines: pictures in DRAM, places in TMEM, descriptors."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from tmap.base.byte_pool import BytePool
from tmap.base.fields import fail
from tmap.compiler.n64 import TEXELS, WRAPS, numbers
from tmap.images import images
from tmap.n64 import images as texels
from tmap.n64.state import CI, REACH, RGBA, TMEM_WORDS, YUV
from tmap.n64.words import Wrap, line_of

HALF = TMEM_WORDS // 2
ROWS_MAX = 256
EDGE_MAX = 4 * REACH - 1  # 10.2
ENTRIES = 16  # of a palette


@dataclass(frozen=True)
class Axis:
    """s or t of a tile: its descriptor's part, and its edges in 10.2."""

    wrap: Wrap
    low: int
    high: int

    @property
    def clamps(self) -> bool:
        """Returns True if coordinates are clamped at the edges."""
        return bool(self.wrap.clamp or not self.wrap.mask)


@dataclass
class Tile:
    """A tile descriptor under construction: one level of a tile in the scene."""

    where: str
    spec: dict
    number: int
    level: int
    texture: texels.Texture
    s: Axis
    t: Axis
    address: int = 0
    tmem: int = 0
    is_loaded: bool = False  # the texels are already loaded for another tile

    @property
    def line(self) -> int:
        """Returns the TMEM words of a row."""
        return line_of(self.texture.form, self.texture.size, self.texture.row_texels)

    @property
    def words(self) -> int:
        """Returns the TMEM words of all rows; for split texels, the words in each half."""
        return self.line * self.texture.height

    @property
    def is_split(self) -> bool:
        """Returns True if the texels use both halves of TMEM."""
        return self.texture.form == YUV or (self.texture.form, self.texture.size) == (RGBA, 3)

    def slots(self, at: int) -> list[slice]:
        """Returns the TMEM words that the tile takes if it starts at a word."""
        starts = (at, at + HALF) if self.is_split else (at,)
        return [slice(start, start + self.words) for start in starts]


def shifted(shift: int, level: int) -> int:
    """Returns a tile's shift for a coarser level: 0-10 to the right, 11-15 to the left by 16 -
    shift."""
    right = (shift if shift <= 10 else shift - 16) + level
    return right if right >= 0 else right + 16


def axis_of(spec: dict, side: int, level: int, where: str) -> Axis:
    """Returns an axis of a tile whose picture has ``side`` texels at level 0. Refuses an axis that
    shows more texels."""
    clamp, mirror = WRAPS[spec["wrap"]]
    mask, low = spec["mask"], round(4 * spec["low"])
    if mask is None:
        mask = 0 if spec["wrap"] == "clamp" else side.bit_length() - 1
        if mask and side != 1 << mask:
            fail(f"{where}.wrap", f'"{spec["wrap"]}", but {side} texels are not a power of two')
    high = low + 4 * (side - 1) if spec["high"] is None else round(4 * spec["high"])
    inside = (high >> 2) - (low >> 2) + 1
    shown = inside if not mask else min(inside, 1 << mask) if clamp else 1 << mask
    if high > EDGE_MAX:
        fail(f"{where}.low", f"the tile would end at {high / 4:g}; {EDGE_MAX / 4:g} at most")
    if inside < 1 and (clamp or not mask):
        fail(f"{where}.high", "lies before low")
    if shown > side:
        fail(f"{where}.{'high' if shown == inside else 'mask'}",
             f"the tile shows {shown} texels, its picture has {side}")
    if level and mask and shifted(spec["shift"], level) > 10 > spec["shift"]:
        fail(f"{where}.shift", f"is more than 10 at level {level}")
    first = low >> level
    last = first + max((high - low + 4 >> level) - 4, 0)
    return Axis(Wrap(clamp, mirror, max(mask - level, 0), shifted(spec["shift"], level)),
                first, last)


def picture_of(tile: dict, folder: Path, where: str) -> np.ndarray:
    """Returns a tile's picture, R, G, B, A, in the tile's size; sets sizes left to the picture."""
    at = f"{where}.image"
    if tile["width"] is None or tile["height"] is None:
        wide, high = images.picture(tile["image"], folder, at).size
        for name, side, most in (("width", wide, REACH), ("height", high, ROWS_MAX)):
            if tile[name] is None and side > most:
                fail(at, f"{tile['image']}: {wide}x{high} pixels; a tile has {REACH}x{ROWS_MAX} "
                         "texels at most")
            tile[name] = tile[name] or side
    if tile["levels"] > 1:
        sides = tile["width"], tile["height"]
        if any(side & side - 1 for side in sides):
            fail(f"{where}.levels", f"{sides[0]}x{sides[1]} texels are not powers of two")
        if max(sides) >> tile["levels"] - 1 < 1:
            fail(f"{where}.levels", f"{sides[0]}x{sides[1]} texels have "
                                    f"{max(sides).bit_length()} levels")
    return images.load(tile["image"], folder, at, tile["width"], tile["height"], "RGBA")


def nearest(picture: np.ndarray, entries: np.ndarray, is_ia: bool) -> np.ndarray:
    """Returns the entry nearest to each pixel, [height, width]; ``entries``: 16 bits."""
    colours = (texels.ia16 if is_ia else texels.rgba16)(entries)
    away = picture[..., None, :].astype(np.int64) - colours
    return (away * away).sum(-1).argmin(-1)


@dataclass
class Palettes:
    """The palettes of an engine: entries by the number of the first one, a multiple of 16."""

    is_ia: bool
    entries: dict[int, np.ndarray] = field(default_factory=dict)

    def read(self, reference: str, folder: Path, where: str) -> None:
        """Reads all palettes from a picture, one from each row."""
        picture = np.array(images.picture(reference, folder, where, "RGBA"))
        height, width = picture.shape[:2]
        if width != ENTRIES or height > ENTRIES:
            fail(where, f"{reference}: {width}x{height} pixels; palettes are 1 to {ENTRIES} rows "
                        f"of {ENTRIES}")
        values = (texels.to_ia16 if self.is_ia else texels.to_rgba16)(picture)
        self.entries = {ENTRIES * row: values[row] for row in range(height)}

    def indices(self, pictures: list[np.ndarray], first: int, count: int) -> list[np.ndarray]:
        """Returns pictures as indices into the entries from ``first`` on. If there are none, the
        entries are made from the pictures."""
        found = [self.entries[at] for at in sorted(self.entries)
                 if first <= at < first + count]
        if found:
            return [nearest(picture, np.concatenate(found), self.is_ia) for picture in pictures]
        joint = np.concatenate([picture.reshape(1, -1, 4) for picture in pictures], 1)
        made, self.entries[first] = texels.palette_of(joint, count, self.is_ia)
        parts = np.split(made[0], np.cumsum([p.shape[0] * p.shape[1] for p in pictures])[:-1])
        return [part.reshape(picture.shape[:2]) for part, picture in zip(parts, pictures)]


def indexed_level(indices: np.ndarray, size: int, shape: tuple[int, int]) -> texels.Texture:
    """Returns a CI texture of padded indices; ``shape``: height and width without padding."""
    data = (indices if size else texels.nibbles(indices)).astype(np.uint8)
    return texels.Texture(CI, size, shape[1], shape[0], indices.shape[1], data.tobytes())


def indexed(engine: dict, pictures: list[list[np.ndarray]], folder: Path,
            where: str) -> tuple[list[list[texels.Texture]], Palettes]:
    """Returns the levels of CI tiles, and their palettes. "ci4" tiles with the same ``colours``
    share a palette of 16 entries; all "ci8" tiles share one of 256."""
    palettes = Palettes(engine["tlut"] == "ia16")
    if engine["palettes"]:
        palettes.read(engine["palettes"], folder, f"{where}.palettes")
    elif len({tile["format"] for tile in engine["tiles"]}) > 1:
        fail(f"{where}.palettes", 'is missing: "ci4" and "ci8" tiles share one TLUT')
    groups: dict[int | None, list[int]] = {}  # by palette; None: the one of 256 entries
    for i, tile in enumerate(engine["tiles"]):
        groups.setdefault(tile["colours"] if tile["format"] == "ci4" else None, []).append(i)
    made: dict[int, list[texels.Texture]] = {}
    for number, members in groups.items():
        size, first, count = (1, 0, 256) if number is None else (0, ENTRIES * number, ENTRIES)
        if engine["palettes"] and number is not None and first not in palettes.entries:
            fail(f"{where}.tiles[{members[0]}].colours", f"{engine['palettes']} has no row {number}")
        padded = [texels.padded(level, texels.alignment(CI, size))
                  for i in members for level in pictures[i]]
        found = iter(palettes.indices(padded, first, count))
        for i in members:
            made[i] = [indexed_level(next(found), size, level.shape[:2]) for level in pictures[i]]
    for i, tile in enumerate(engine["tiles"]):
        for number in tile["palette"] if tile["format"] == "ci4" else ():
            if ENTRIES * number not in palettes.entries:
                fail(f"{where}.tiles[{i}].palette", f"palette {number} has no colours")
    return [made[i] for i in range(len(pictures))], palettes


def check_slide(steps: list[float], axes: list[Axis], level: int, where: str) -> None:
    """Refuses moving axes that clamp, or whose period exceeds the range of an edge."""
    for name, axis, step in zip("st", axes, steps):
        if step and axis.clamps and not level:
            fail(where, f"{name} clamps; only what wraps or mirrors can slide")
        if step and axis.wrap.mask + axis.wrap.mirror > 10:
            fail(where, f"{name} repeats after more than {REACH} texels")


def make(engine: dict, folder: Path, where: str) -> tuple[list[Tile], Palettes]:
    """Returns an engine's tiles, before they are placed, and its palettes."""
    spots = [f"{where}.tiles[{i}]" for i in range(len(engine["tiles"]))]
    pictures = [texels.chain(picture_of(tile, folder, at), tile["levels"])
                for tile, at in zip(engine["tiles"], spots)]
    palettes = Palettes(False)
    if engine["tlut"] != "none":
        textures, palettes = indexed(engine, pictures, folder, where)
    else:
        textures = [[texels.encode(level, *TEXELS[tile["format"]]) for level in levels]
                    for tile, levels in zip(engine["tiles"], pictures)]
    made = []
    for tile, first, levels, at in zip(engine["tiles"], numbers(engine), textures, spots):
        for level, texture in enumerate(levels):
            axes = [axis_of(tile[name], side, level, f"{at}.{name}")
                    for name, side in (("s", tile["width"]), ("t", tile["height"]))]
            check_slide(tile["slide"], axes, level, f"{at}.slide")
            made.append(Tile(at, tile, first + level, level, texture, *axes))
    return made, palettes


def free_place(tile: Tile, taken: np.ndarray, room: int, asked: int | None) -> int:
    """Returns the first TMEM word from which a tile fits below ``room``, or the word the tile
    names; refuses a tile that does not fit. ``taken``: bool [TMEM_WORDS]."""
    starts = range(TMEM_WORDS) if asked is None else [asked]
    for at in starts:
        if at + tile.words <= room and not any(taken[slot].any() for slot in tile.slots(at)):
            return at
    halves = " in each half" if tile.is_split else ""
    level = f", level {tile.level}," if tile.level else ""
    spot = "" if asked is None else f" at word {asked}"
    fail(tile.where, f"TMEM is full: {tile.texture.width}x{tile.texture.height} texels of "
                     f"{tile.spec['format']}{level} need {tile.words} words{halves}{spot}; "
                     f"free are {int((~taken[:room]).sum())}{' there' if room == HALF else ''}")


def place(tiles: list[Tile], dram: BytePool, has_tlut: bool) -> None:
    """Places tiles in DRAM and TMEM: first the tiles with a given TMEM word, then split ones, then
    all others. Equal texels are stored once."""
    taken = np.zeros(TMEM_WORDS, bool)
    taken[HALF:] = has_tlut
    known: dict[tuple, int] = {}
    for tile in tiles:
        tile.address = dram.put(tile.texture.data)
    asked = {t.number: t.spec["tmem"] for t in tiles if t.spec["tmem"] is not None and not t.level}
    for tile in sorted(tiles, key=lambda t: (t.number not in asked, not t.is_split, t.number)):
        texture, wanted = tile.texture, asked.get(tile.number)
        key = texture.form, texture.size, texture.row_texels, texture.height, texture.data
        if key in known and wanted in (None, known[key]):
            tile.tmem = known[key]
            continue
        room = HALF if tile.is_split or has_tlut else TMEM_WORDS
        tile.tmem = known[key] = free_place(tile, taken, room, wanted)
        for slot in tile.slots(tile.tmem):
            taken[slot] = True
    loaded = set()
    for tile in tiles:  # the first tile loads texels that several tiles show
        tile.is_loaded = (tile.address, tile.tmem) in loaded
        loaded.add((tile.address, tile.tmem))
