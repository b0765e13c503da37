"""Command words as readable lines."""

from tmap.base.fixed import signed
from tmap.n64.combiner import ALPHA_NAMES, RGB_NAMES, inputs_of, names
from tmap.n64.opcodes import (LOAD_BLOCK, LOAD_TILE, LOAD_TLUT, NAMES, SET_COMBINE, SET_CONVERT,
                              SET_ENVIRONMENT_COLOUR, SET_OTHER_MODES, SET_PRIMITIVE_COLOUR,
                              SET_TEXTURE_IMAGE, SET_TILE, SET_TILE_SIZE, TEXTURE, Word, bits)
from tmap.n64.state import FORMATS, Inputs

CYCLES = ("one cycle", "two cycles", "copy", "fill")
MODE_BITS = ("perspective", "detail", "sharpen", "lod", "tlut", "IA16 TLUT", "quad", "mid",
             "filter0", "filter1", "convert one")


def texels(hi: int) -> str:
    """Describes format and size."""
    form = bits(hi, 23, 21)
    name = FORMATS[form] if form < len(FORMATS) else f"format {form}"
    return f"{name} {4 << bits(hi, 20, 19)} bits"


def axis(name: str, word: int) -> str:
    """Describes a tile's axis, 10 bits."""
    flags = [flag for bit, flag in ((9, "clamp"), (8, "mirror")) if word >> bit & 1]
    return " ".join([name, *flags, f"mask {bits(word, 7, 4)} shift {bits(word, 3, 0)}"])


def corner(word: int, fraction: bool = True) -> str:
    """Describes two coordinates of 12 bits, 10.2 or whole."""
    pair = (bits(word, 23, 12), bits(word, 11, 0))
    return "(" + ", ".join(f"{c / 4:g}" if fraction else str(c) for c in pair) + ")"


def colour(lo: int) -> str:
    """Describes a colour of 32 bits."""
    return f"#{lo & 0xFFFFFFFF:08x}"


def formula(inputs: Inputs, table) -> str:
    """Returns one cycle's formula of colour or alpha."""
    a, b, c, d = (name or "0" for name in names(inputs, table))
    return f"({a} - {b}) * {c} + {d}"


def details(operation: int, hi: int, lo: int) -> str:
    """Describes a command's fields."""
    tile = bits(lo, 26, 24)
    if operation == SET_TEXTURE_IMAGE:
        return f"{texels(hi)}, width {bits(hi, 9, 0) + 1}, address {bits(lo, 23, 0):#x}"
    if operation == SET_TILE:
        return (f"{tile}: {texels(hi)}, line {bits(hi, 17, 9)}, tmem {bits(hi, 8, 0)}, palette "
                f"{bits(lo, 23, 20)}, {axis('s', bits(lo, 9, 0))}, {axis('t', bits(lo, 19, 10))}")
    if operation in (SET_TILE_SIZE, LOAD_TILE, LOAD_TLUT):
        return f"{tile}: {corner(hi)} to {corner(lo)}"
    if operation == LOAD_BLOCK:
        return (f"{tile}: from {corner(hi, False)} to texel {bits(lo, 23, 12)}, "
                f"dxt {bits(lo, 11, 0)}/2048")
    if operation == SET_CONVERT:
        both = hi << 32 | lo
        return " ".join(str(signed(both >> shift, 9)) for shift in range(45, -9, -9))
    if operation == SET_OTHER_MODES:
        on = [name for name, bit in zip(MODE_BITS, range(19, 8, -1)) if hi >> bit & 1]
        return ", ".join([CYCLES[bits(hi, 21, 20)], *on])
    if operation == SET_COMBINE:
        codes = inputs_of(hi, lo)
        return "; ".join(formula(codes[which][cycle], table) for cycle in range(2)
                         for which, table in (("rgb", RGB_NAMES), ("alpha", ALPHA_NAMES)))
    if operation == SET_PRIMITIVE_COLOUR:
        return (f"{colour(lo)}, lowest level {bits(hi, 12, 8)}/32, "
                f"fraction {bits(hi, 7, 0)}/256")
    if operation == SET_ENVIRONMENT_COLOUR:
        return colour(lo)
    if operation == TEXTURE:
        return f"{bits(hi, 10, 8)}, highest level {bits(hi, 13, 11)}"
    return ""


def line(hi: int, lo: int) -> str:
    """Returns one command as a line."""
    operation = bits(hi, 29, 24)
    if operation not in NAMES:
        return f"{hi:08x} {lo:08x}"
    return f"{NAMES[operation]} {details(operation, hi, lo)}".rstrip()


def listing(words: list[Word]) -> str:
    """Returns a display list, one command per line, numbered from 0."""
    return "\n".join(f"{number:4} {line(hi, lo)}" for number, (hi, lo) in enumerate(words))
