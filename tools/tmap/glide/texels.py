"""Texels: the places of levels in texture memory, and the formats' colours."""

import numpy as np

from tmap.base.colours import five
from tmap.glide.state import (A8, AI44, AI88, AP88, ARGB1555, ARGB4444, ARGB8332, AYIQ8422,
                              FIRST_WIDE, I8, LEVELS, P8, RGB332, RGB565, SIDE, YIQ422, Modes, Ncc,
                              Unit)

LEAST_TEXELS = 4  # the least room of a level in memory
FULL = 255  # alpha in formats without one


def level_size(modes: Modes, level: int) -> tuple[int, int]:
    """Returns (width, height) of a level in texels."""
    longer, shorter = SIDE >> level, max(SIDE >> modes.aspect + level, 1)
    return (longer, shorter) if modes.wide else (shorter, longer)


def owns(modes: Modes, level: int) -> bool:
    """Returns true if a level is in memory: of a split map only the odd or the even ones are."""
    return not modes.split or level & 1 == modes.odd


def texel_bytes(form: int) -> int:
    """Returns the bytes of a texel."""
    return 2 if form >= FIRST_WIDE else 1


def level_bytes(modes: Modes, level: int) -> int:
    """Returns the bytes of a level in memory."""
    width, height = level_size(modes, level)
    return max(width * height, LEAST_TEXELS) * texel_bytes(modes.format)


def level_bases(modes: Modes) -> list[int]:
    """Returns the first bytes of all levels, the largest first, not yet wrapped to the memory's
    size. A level that the map does not own takes no room."""
    bases = [modes.base]
    for level in range(LEVELS - 1):
        bases.append(bases[-1] + owns(modes, level) * level_bytes(modes, level))
    return bases


def six(x: np.ndarray) -> np.ndarray:
    """Expands the low 6 bits to 8."""
    x = x & 63
    return x << 2 | x >> 4


def colours_of_332(value: np.ndarray) -> list[np.ndarray]:
    """Returns R, G, B of the low 8 bits."""
    r, g = value >> 5 & 7, value >> 2 & 7
    return [r << 5 | r << 2 | r >> 1, g << 5 | g << 2 | g >> 1, (value & 3) * 0x55]


def colours_of_ncc(table: Ncc, value: np.ndarray) -> list[np.ndarray]:
    """Returns R, G, B of bytes yyyyiiqq, the low 8 bits."""
    found = table.y[value >> 4 & 15][..., None] + table.i[value >> 2 & 3] + table.q[value & 3]
    return list(np.moveaxis(np.clip(found, 0, 255), -1, 0))


def decoded(form: int, value: np.ndarray, palette: np.ndarray | None = None,
            ncc: Ncc | None = None) -> np.ndarray:
    """Returns colours [..., 4] of texels' bits; ``palette`` [256, 3] and ``ncc`` are needed by some
    formats."""
    value = np.asarray(value, np.int64)
    low, high = value & 255, value >> 8
    if form in (RGB332, ARGB8332):
        channels = colours_of_332(low)
    elif form in (YIQ422, AYIQ8422):
        channels = colours_of_ncc(ncc, low)
    elif form in (A8, I8, AI88):
        channels = [low] * 3
    elif form == AI44:
        channels = [(low & 15) * 17] * 3
    elif form in (P8, AP88):
        channels = list(np.moveaxis(palette[low], -1, 0))
    elif form == RGB565:
        channels = [five(value >> 11), six(value >> 5), five(value)]
    elif form == ARGB1555:
        channels = [five(value >> 10), five(value >> 5), five(value)]
    else:
        channels = [(value >> shift & 15) * 17 for shift in (8, 4, 0)]
    if form in (ARGB8332, AYIQ8422, AI88, AP88):
        alpha = high
    elif form == A8:
        alpha = low
    elif form == AI44:
        alpha = (low >> 4) * 17
    elif form == ARGB1555:
        alpha = (value >> 15) * 255
    elif form == ARGB4444:
        alpha = (value >> 12) * 17
    else:
        alpha = np.full_like(value, FULL)
    return np.stack([*channels, alpha], -1)


def raw(unit: Unit, level: np.ndarray, i: np.ndarray, j: np.ndarray) -> np.ndarray:
    """Returns the bits of texels in column ``i`` of row ``j`` of levels, arrays of one shape."""
    modes, memory = unit.modes, unit.memory
    widths = np.array([level_size(modes, n)[0] for n in range(LEVELS)])
    offset = j * widths[level] + i
    last = memory.size - 1
    if texel_bytes(modes.format) == 1:
        return memory[np.array(level_bases(modes))[level] + offset & last].astype(np.int64)
    at = np.array(level_bases(modes))[level] + 2 * offset & last
    return memory[at].astype(np.int64) | memory[at + 1].astype(np.int64) << 8


def fetch(unit: Unit, level: np.ndarray, i: np.ndarray, j: np.ndarray) -> np.ndarray:
    """Returns colours [..., 4] of texels within their levels."""
    modes = unit.modes
    return decoded(modes.format, raw(unit, level, i, j), unit.palette, unit.ncc[modes.ncc_table])
