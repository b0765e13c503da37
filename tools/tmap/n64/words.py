"""Builds command words and the manual's macros, expanded as on the N64.

A ``List`` collects words; its methods are the commands and the macros. Numbers that do not fit
their fields raise UserError. Sizes are 0 to 3 for 4, 8, 16 and 32 bits per texel.
"""

from dataclasses import astuple, dataclass, field
from typing import NamedTuple

from tmap.base.errors import UserError
from tmap.n64.combiner import ALPHA_NAMES, RGB_NAMES
from tmap.n64.loads import BLOCK_TEXELS
from tmap.n64.opcodes import (FULL_SYNC, LOAD_BLOCK, LOAD_SYNC, LOAD_TILE, LOAD_TLUT, NAMES,
                              PIPE_SYNC, SET_COMBINE, SET_CONVERT, SET_ENVIRONMENT_COLOUR,
                              SET_OTHER_MODES, SET_PRIMITIVE_COLOUR, SET_TEXTURE_IMAGE, SET_TILE,
                              SET_TILE_SIZE, TEXTURE, TILE_SYNC, Word)
from tmap.n64.state import LEGAL, RGBA, YUV, Modes

LOAD_NUMBER, RENDER_NUMBER = 7, 0  # the macros' tiles
DXT_ONE = 2048  # u1.11
CYCLES = {"one": 0, "two": 1, "copy": 2, "fill": 3}
DETAILS = {"clamp": (0, 0), "sharpen": (0, 1), "detail": (1, 0)}  # detail, sharpen
TLUTS = {"none": (0, 0), "rgba16": (1, 0), "ia16": (1, 1)}  # tlut, tlut_type
FILTERS = {"point": (0, 0), "bilerp": (1, 0), "average": (1, 1)}  # quad, mid
CONVERTS = {"filter": (1, 1, 0), "convert": (0, 0, 0), "filter, convert": (1, 0, 1)}

Four = tuple[str, str, str, str]


class Wrap(NamedTuple):
    """How an axis of a tile continues beyond its texels."""

    clamp: int = 0
    mirror: int = 0
    mask: int = 0
    shift: int = 0


class Cycle(NamedTuple):
    """A combiner cycle's inputs A, B, C, D by name (tmap.n64.combiner); "0": zero."""

    rgb: Four
    alpha: Four


def place(name: str, value: int, bits: int, shift: int = 0, negative: bool = False) -> int:
    """Returns a value shifted to its field; refuses one that does not fit."""
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if negative else (0, (1 << bits) - 1)
    if not isinstance(value, int) or not low <= value <= high:
        raise UserError(f"{name}: {value} is not a whole number from {low} to {high}")
    return (value & (1 << bits) - 1) << shift


def choose(name: str, choices: dict, choice: str):
    """Returns one of a mode's choices by name."""
    if choice not in choices:
        raise UserError(f"{name}: {choice!r} is none of {', '.join(map(repr, choices))}")
    return choices[choice]


def code(where: str, names: tuple, name: str) -> int:
    """Returns the code of a combiner's input."""
    wanted = None if name == "0" else name
    if wanted in names:
        return names.index(wanted)
    if wanted is None and len(names) > 7:
        return 31 if len(names) > 8 else 15  # all codes beyond the named ones are zero
    known = ", ".join(n for n in names if n)
    raise UserError(f"{where}: {name!r} is none of {known}, 0")


def dxt(words: int) -> int:
    """Returns rows per 64-bit word, u1.11 rounded up, for rows of ``words`` words."""
    return -(-DXT_ONE // max(words, 1))


def drifts(words: int, height: int) -> bool:
    """Returns true if rows of ``words`` 64-bit words, counted by dxt, begin a word too soon
    somewhere. The count can only run ahead, and most at a row's last word."""
    step = dxt(words)
    return any(c * step // DXT_ONE != c // words for c in range(words - 1, words * height, words))


def check_texels(name: str, form: int, size: int) -> None:
    """Refuses a size that the format does not have."""
    if (form, size) not in LEGAL:
        raise UserError(f"{name}: there is no format {form} of size {size}")


def line_of(form: int, size: int, width: int) -> int:
    """Returns the 64-bit words of a tile's row in TMEM: wide texels and YUV are split between its
    halves."""
    if size == 0:
        return (width >> 1) + 7 >> 3
    if size == 1 or form == YUV:
        return width + 7 >> 3
    return width * 2 + 7 >> 3


@dataclass
class List:
    """A display list being built, and the modes that its words have set."""

    words: list[Word] = field(default_factory=list)
    modes: Modes = field(default_factory=Modes)

    def add(self, operation: int, hi: int = 0, lo: int = 0) -> None:
        """Adds one command."""
        self.words.append((operation << 24 | hi, lo))

    def set_texture_image(self, form: int, size: int, width: int, address: int) -> None:
        """Sets the image that loads read; ``width`` in texels."""
        name = NAMES[SET_TEXTURE_IMAGE]
        if address & 7:
            raise UserError(f"{name}: address {address:#x} is not a multiple of 8")
        self.add(SET_TEXTURE_IMAGE, place(f"{name}: format", form, 3, 21)
                 | place(f"{name}: size", size, 2, 19) | place(f"{name}: width - 1", width - 1, 10),
                 place(f"{name}: address", address, 24))

    def set_tile(self, number: int, form: int, size: int, line: int, tmem: int, palette: int = 0,
                 s: Wrap = Wrap(), t: Wrap = Wrap()) -> None:
        """Sets a tile descriptor; ``line``, ``tmem``: 64-bit words."""
        name, lo = NAMES[SET_TILE], 0
        for letter, axis, at in (("t", t, 10), ("s", s, 0)):
            for what, value, bits, shift in zip(Wrap._fields, axis, (1, 1, 4, 4), (9, 8, 4, 0)):
                lo |= place(f"{name}: {what} of {letter}", value, bits, at + shift)
        self.add(SET_TILE, place(f"{name}: format", form, 3, 21)
                 | place(f"{name}: size", size, 2, 19) | place(f"{name}: line", line, 9, 9)
                 | place(f"{name}: tmem", tmem, 9),
                 place(f"{name}: tile", number, 3, 24)
                 | place(f"{name}: palette", palette, 4, 20) | lo)

    def edges(self, operation: int, number: int, sl: int, tl: int, sh: int, th: int) -> None:
        """Adds a command with four edges."""
        name = NAMES[operation]
        self.add(operation, place(f"{name}: sl", sl, 12, 12) | place(f"{name}: tl", tl, 12),
                 place(f"{name}: tile", number, 3, 24) | place(f"{name}: sh", sh, 12, 12)
                 | place(f"{name}: th", th, 12))

    def set_tile_size(self, number: int, sl: int, tl: int, sh: int, th: int) -> None:
        """Sets a tile's edges, 10.2 texels."""
        self.edges(SET_TILE_SIZE, number, sl, tl, sh, th)

    def load_tile(self, number: int, sl: int, tl: int, sh: int, th: int) -> None:
        """Loads a rectangle of the image, 10.2 texels."""
        self.edges(LOAD_TILE, number, sl, tl, sh, th)

    def load_block(self, number: int, s: int, t: int, last: int, step: int) -> None:
        """Loads texels s to last of row t; ``step``: dxt, u1.11."""
        if last - s >= BLOCK_TEXELS:
            raise UserError(f"load block: {last - s + 1} texels; there may be {BLOCK_TEXELS}")
        self.edges(LOAD_BLOCK, number, s, t, last, step)

    def load_tlut_command(self, number: int, count: int) -> None:
        """Loads the first ``count`` entries of the image."""
        if not 1 <= count <= 256:
            raise UserError(f"load TLUT: {count} entries; there may be 1 to 256")
        self.edges(LOAD_TLUT, number, 0, 0, count - 1 << 2, 0)

    def set_convert(self, *k: int) -> None:
        """Sets K0..K5, -256..255."""
        if len(k) != 6:
            raise UserError(f"set convert: six constants expected, {len(k)} found")
        both = 0
        for n, value in enumerate(k):
            both |= place(f"set convert: k{n}", value, 9, 45 - 9 * n, True)
        self.add(SET_CONVERT, both >> 32, both & 0xFFFFFFFF)

    def set_modes(self, **changes: int) -> None:
        """Changes modes (fields of tmap.n64.state.Modes); one word holds all of them."""
        for name, value in changes.items():
            setattr(self.modes, name, value)
        cycle, *flags = astuple(self.modes)
        hi = cycle << 20
        for flag, bit in zip(flags, range(19, 8, -1), strict=True):
            hi |= flag << bit
        self.add(SET_OTHER_MODES, hi)

    def cycle_type(self, choice: str) -> None:
        """Sets the cycles per pixel: "one", "two", "copy" or "fill"."""
        self.set_modes(cycle=choose("cycle type", CYCLES, choice))

    def texture_perspective(self, on: bool) -> None:
        """Turns the division of s and t by w on or off."""
        self.set_modes(perspective=int(on))

    def texture_detail(self, choice: str) -> None:
        """Sets the treatment of magnified texels: "clamp", "sharpen" or "detail"."""
        detail, sharpen = choose("texture detail", DETAILS, choice)
        self.set_modes(detail=detail, sharpen=sharpen)

    def texture_lod(self, on: bool) -> None:
        """Turns the choice of tiles by the level of detail on or off."""
        self.set_modes(lod=int(on))

    def texture_lut(self, choice: str) -> None:
        """Sets the format of palettes: "none", "rgba16" or "ia16"."""
        tlut, kind = choose("texture LUT", TLUTS, choice)
        self.set_modes(tlut=tlut, tlut_type=kind)

    def texture_filter(self, choice: str) -> None:
        """Sets the sampling of texels: "point", "bilerp" or "average"."""
        quad, mid = choose("texture filter", FILTERS, choice)
        self.set_modes(quad=quad, mid=mid)

    def texture_convert(self, choice: str) -> None:
        """Sets the cycles' work on texels: "filter", "convert" or "filter, convert"."""
        filter0, filter1, one = choose("texture convert", CONVERTS, choice)
        self.set_modes(filter0=filter0, filter1=filter1, convert_one=one)

    def combine_mode(self, first: Cycle, second: Cycle) -> None:
        """Sets the combiner's two cycles; one-cycle mode uses the second: give it twice."""
        codes = [[code(f"set combine: {what} {letter}", table, name)
                  for letter, table, name in zip("ABCD", tables, four, strict=True)]
                 for cycle in (first, second)
                 for what, tables, four in (("colour", RGB_NAMES, cycle.rgb),
                                            ("alpha", ALPHA_NAMES, cycle.alpha))]
        (a0, b0, c0, d0), (aa0, ab0, ac0, ad0), (a1, b1, c1, d1), (aa1, ab1, ac1, ad1) = codes
        self.add(SET_COMBINE, a0 << 20 | c0 << 15 | aa0 << 12 | ac0 << 9 | a1 << 5 | c1,
                 b0 << 28 | b1 << 24 | aa1 << 21 | ac1 << 18 | d0 << 15 | ab0 << 12 | ad0 << 9
                 | d1 << 6 | ab1 << 3 | ad1)

    def colour(self, operation: int, hi: int, colour: tuple[int, int, int, int]) -> None:
        """Adds a command with a colour."""
        lo = 0
        for letter, value, shift in zip("rgba", colour, (24, 16, 8, 0), strict=True):
            lo |= place(f"{NAMES[operation]}: {letter}", value, 8, shift)
        self.add(operation, hi, lo)

    def prim_colour(self, min_level: int, fraction: int,
                    colour: tuple[int, int, int, int]) -> None:
        """Sets the primitive colour (r, g, b, a), lowest level (1/32) and LOD fraction (1/256)."""
        hi = (place("set primitive colour: lowest level", min_level, 5, 8)
              | place("set primitive colour: fraction", fraction, 8))
        self.colour(SET_PRIMITIVE_COLOUR, hi, colour)

    def env_colour(self, colour: tuple[int, int, int, int]) -> None:
        """Sets the environment colour (r, g, b, a)."""
        self.colour(SET_ENVIRONMENT_COLOUR, 0, colour)

    def texture(self, max_level: int, tile: int) -> None:
        """Sets the highest level and first tile of the triangles that follow."""
        self.add(TEXTURE, place("texture: highest level", max_level, 3, 11)
                 | place("texture: tile", tile, 3, 8))

    def load_sync(self) -> None:
        """Needed before a load after a primitive."""
        self.add(LOAD_SYNC)

    def pipe_sync(self) -> None:
        """Needed before a change of modes after a primitive."""
        self.add(PIPE_SYNC)

    def tile_sync(self) -> None:
        """Needed before a change of tiles after a primitive."""
        self.add(TILE_SYNC)

    def full_sync(self) -> None:
        """Ends a frame."""
        self.add(FULL_SYNC)

    def load_texture_block(self, address: int, form: int, size: int, width: int, height: int,
                           palette: int = 0, s: Wrap = Wrap(), t: Wrap = Wrap(), *,
                           tmem: int = 0, tile: int = RENDER_NUMBER) -> None:
        """Loads a whole texture in one run and sets its tile; rows fill whole words of TMEM.

        ``tmem``, ``tile``: as in the manual's multi forms. For 4-bit textures this is the manual's
        load_texture_block_4b.
        """
        check_texels("load texture block", form, size)
        row = width << size >> 1  # bytes
        words = row >> 3
        unit = 16 if size == 3 or form == YUV else 8  # 16: half goes into each half of TMEM
        if width < 1 or height < 1 or row % unit:
            raise UserError(f"load texture block: {width} x {height} texels: rows of {row} bytes, "
                            f"which must be a positive multiple of {unit}")
        if drifts(words, height):
            raise UserError(f"load texture block: {width} x {height} texels: rows of {words} "
                            "words drift; load it as a tile")
        load_size = max(size, 2)
        count = width * height >> (load_size - size)
        self.set_texture_image(form, load_size, 1, address)
        self.set_tile(LOAD_NUMBER, form, load_size, 0, tmem, 0, s, t)
        self.load_sync()
        self.load_block(LOAD_NUMBER, 0, 0, count - 1, dxt(words))
        self.pipe_sync()
        self.set_tile(tile, form, size, line_of(form, size, width), tmem, palette, s, t)
        self.set_tile_size(tile, 0, 0, width - 1 << 2, height - 1 << 2)

    def load_texture_tile(self, address: int, form: int, size: int, width: int,
                          corners: tuple[int, int, int, int], palette: int = 0,
                          s: Wrap = Wrap(), t: Wrap = Wrap(), *, tmem: int = 0,
                          tile: int = RENDER_NUMBER) -> None:
        """Loads a rectangle of an image ``width`` texels wide and sets its tile.

        ``corners``: first column, first row, last column, last row. For 4-bit textures this is
        the manual's load_texture_tile_4b.
        """
        check_texels("load texture tile", form, size)
        left, top, right, bottom = corners
        if left > right or top > bottom:
            raise UserError(f"load texture tile: no texels from {left}, {top} to "
                            f"{right}, {bottom}")
        across = right - left + 1
        if size == 0 and (width & 1 or left & 1):
            raise UserError(f"load texture tile: 4-bit texels of an image {width} wide from "
                            f"column {left}: both must be even")
        line = line_of(form, size, across)
        if size:
            self.set_texture_image(form, size, width, address)
            self.set_tile(LOAD_NUMBER, form, size, line, tmem, 0, s, t)
        else:
            self.set_texture_image(form, 1, width >> 1, address)
            self.set_tile(LOAD_NUMBER, form, 1, line, tmem, 0, s, t)
        self.load_sync()
        unit = 2 if size else 1  # two 4-bit texels are loaded as one
        self.load_tile(LOAD_NUMBER, left << unit, top << 2, right << unit, bottom << 2)
        self.pipe_sync()
        self.set_tile(tile, form, size, line, tmem, palette, s, t)
        self.set_tile_size(tile, left << 2, top << 2, right << 2, bottom << 2)

    def load_tlut(self, count: int, tmem: int, address: int) -> None:
        """Loads a palette of 16-bit entries to word ``tmem``, 256..511."""
        if not 256 <= tmem <= 512 - count:
            raise UserError(f"load TLUT: {count} entries at word {tmem}: words 256 to 511 "
                            "are the palettes'")
        self.set_texture_image(RGBA, 2, 1, address)
        self.tile_sync()
        self.set_tile(LOAD_NUMBER, RGBA, 0, 0, tmem)
        self.load_sync()
        self.load_tlut_command(LOAD_NUMBER, count)
        self.pipe_sync()

    def load_tlut_pal16(self, palette: int, address: int) -> None:
        """Loads one of sixteen palettes of 16 entries."""
        place("load TLUT: palette", palette, 4)
        self.load_tlut(16, 256 + 16 * palette, address)

    def load_tlut_pal256(self, address: int) -> None:
        """Loads a palette of 256 entries."""
        self.load_tlut(256, 256, address)
