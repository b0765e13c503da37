"""The registers textureMode, tLOD, tDetail and texBaseAddr, and those of palette and NCC.

Bits that the model does not have (sequential download, a base for each level, zero fraction) are
ignored when registers are read, and 0 when they are made.
"""

import numpy as np

from tmap.glide.state import Combination, Modes, Ncc

#: Name to (lowest bit, count of bits).
MODE = {"perspective": (0, 1), "minify": (1, 1), "magnify": (2, 1), "clamp_negative_w": (3, 1),
        "dither": (4, 1), "ncc_table": (5, 1), "clamp_s": (6, 1), "clamp_t": (7, 1),
        "format": (8, 4), "trilinear": (30, 1)}
RGB_AT, ALPHA_AT = 12, 21
COMBINATION = {"zero_other": (0, 1), "sub_local": (1, 1), "mselect": (2, 3), "reverse": (5, 1),
               "add_local": (6, 1), "add_alpha_local": (7, 1), "invert": (8, 1)}
LOD = {"lod_min": (0, 6), "lod_max": (6, 6), "lod_bias": (12, 6), "odd": (18, 1),
       "split": (19, 1), "wide": (20, 1), "aspect": (21, 2)}
DETAIL = {"detail_max": (0, 8), "detail_bias": (8, 6), "detail_scale": (14, 3)}
SIGNED = ("lod_bias", "detail_bias")
BASE_UNIT = 8  # bytes
BASE_BITS = 19
NCC_REGISTERS = 12  # per table: four for Y, four for I, four for Q


def decoded(word: int, layout: dict[str, tuple[int, int]], at: int = 0) -> dict[str, int]:
    """Returns a word's fields."""
    values = {}
    for name, (low, bits) in layout.items():
        value = word >> at + low & (1 << bits) - 1
        values[name] = value - (1 << bits) if name in SIGNED and value >> bits - 1 else value
    return values


def encoded(values, layout: dict[str, tuple[int, int]], at: int = 0) -> int:
    """Returns a word with the fields of an object."""
    return sum((getattr(values, name) & (1 << bits) - 1) << at + low
               for name, (low, bits) in layout.items())


def modes_of(mode: int, lod: int, detail: int, base: int, fraction_bits: int) -> Modes:
    """Returns the modes in the four registers."""
    return Modes(**decoded(mode, MODE), **decoded(lod, LOD), **decoded(detail, DETAIL),
                 rgb=Combination(**decoded(mode, COMBINATION, RGB_AT)),
                 alpha=Combination(**decoded(mode, COMBINATION, ALPHA_AT)),
                 base=(base & (1 << BASE_BITS) - 1) * BASE_UNIT, fraction_bits=fraction_bits)


def words_of(modes: Modes) -> tuple[int, int, int, int]:
    """Returns the four registers."""
    combinations = (encoded(modes.rgb, COMBINATION, RGB_AT)
                    | encoded(modes.alpha, COMBINATION, ALPHA_AT))
    return (encoded(modes, MODE) | combinations, encoded(modes, LOD), encoded(modes, DETAIL),
            modes.base // BASE_UNIT)


def ncc_of(words: np.ndarray) -> Ncc:
    """Returns a table from its registers [12]: four Y per word, the first lowest; I and Q as R, G,
    B of 9 bits each, B lowest."""
    words = np.asarray(words, np.int64)
    y = (words[:4, None] >> 8 * np.arange(4) & 255).reshape(16)
    colours = words[4:, None] >> np.array([18, 9, 0]) & 511
    colours -= (colours & 256) << 1
    return Ncc(y, colours[:4], colours[4:])


def words_of_ncc(table: Ncc) -> np.ndarray:
    """Returns the registers of a table, int64 [12]."""
    y = (table.y.reshape(4, 4) << 8 * np.arange(4)).sum(1)
    colours = (np.concatenate([table.i, table.q]) & 511) << np.array([18, 9, 0])
    return np.concatenate([y, colours.sum(1)])
