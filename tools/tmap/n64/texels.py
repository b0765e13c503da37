"""Texels in TMEM, decoded to four channels."""

import numpy as np

from tmap.base.colours import five
from tmap.n64.state import CI, IA, RGBA, YUV, State, Tile

LOW = 0x7FF  # bytes of TMEM's lower half


def rows_of(tile: Tile, row: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns the first bytes of rows, and the value that is XORed to addresses in odd rows."""
    return 8 * (tile.line * row + tile.tmem), (row & 1) * 4


def half_word(tmem: np.ndarray, at: np.ndarray) -> np.ndarray:
    """Returns 16 bits at even addresses."""
    return tmem[at].astype(np.int64) << 8 | tmem[at + 1]


def rgba16(value: np.ndarray) -> np.ndarray:
    """Returns the channels of 5, 5, 5, 1 bits, int64 [..., 4]."""
    return np.stack([five(value >> 11), five(value >> 6), five(value >> 1), (value & 1) * 255], -1)


def ia16(value: np.ndarray) -> np.ndarray:
    """Returns the channels of 8 bits each of intensity and alpha."""
    return grey(value >> 8, value & 255)


def grey(intensity: np.ndarray, alpha: np.ndarray) -> np.ndarray:
    """Returns the channels of an intensity and an alpha, 0..255."""
    return np.stack([intensity, intensity, intensity, alpha], -1)


def raw(state: State, tile: Tile, s: np.ndarray, row: np.ndarray, area: int) -> np.ndarray:
    """Returns the texels' bits in 4, 8 or 16-bit tiles (32 bits: the lower half's 16). ``area``:
    the mask of byte addresses."""
    base, swap = rows_of(tile, row)
    if tile.size == 0:
        byte = state.tmem[(base + (s >> 1) ^ swap) & area].astype(np.int64)
        return np.where(s & 1, byte, byte >> 4) & 15
    if tile.size == 1:
        return state.tmem[(base + s ^ swap) & area].astype(np.int64)
    return half_word(state.tmem, (base + 2 * s ^ swap) & area & ~1)


def entries(state: State, tile: Tile, s: np.ndarray, row: np.ndarray, copy=0) -> np.ndarray:
    """Returns TLUT entries of texels, 16 bits; ``copy``: which of each entry's four copies."""
    index = raw(state, tile, s, row, LOW)
    if tile.size == 0:
        index = tile.palette * 16 + index
    elif tile.size > 1:
        index = index >> 8
    return half_word(state.tmem, 0x800 + 8 * index + 2 * copy)


def chroma(state: State, tile: Tile, s: np.ndarray, row: np.ndarray) -> np.ndarray:
    """Returns U and V of a YUV texel's pair, signed, int64 [..., 2]."""
    base, swap = rows_of(tile, row)
    at = (base + (s & ~1) ^ swap) & 0x7FE
    return np.stack([state.tmem[at], state.tmem[at + 1]], -1).astype(np.int64) - 128


def luma(state: State, tile: Tile, s: np.ndarray, row: np.ndarray) -> np.ndarray:
    """Returns Y of a YUV texel, int64."""
    base, swap = rows_of(tile, row)
    return state.tmem[0x800 | (base + s ^ swap) & LOW].astype(np.int64)


def fetch(state: State, tile: Tile, s: np.ndarray, row: np.ndarray) -> np.ndarray:
    """Returns texels (s, row), int64 [..., 4]: R, G, B, A 0..255, or U, V (signed), Y, Y.

    ``s``, ``row``: indices after the coordinates' pipeline. A TLUT's entries are read from
    their first copies, as a load makes all four the same.
    """
    s, row = np.asarray(s, np.int64), np.asarray(row, np.int64)
    modes = state.modes
    if tile.format == YUV:
        y = luma(state, tile, s, row)[..., None]
        return np.concatenate([chroma(state, tile, s, row), y, y], -1)
    if modes.tlut:
        entry = entries(state, tile, s, row)
        return ia16(entry) if modes.tlut_type else rgba16(entry)
    if tile.format == RGBA and tile.size == 3:
        base, swap = rows_of(tile, row)
        at = (base + 2 * s ^ swap) & 0x7FE
        return np.stack([state.tmem[at + k].astype(np.int64) for k in (0, 1, 0x800, 0x801)], -1)
    value = raw(state, tile, s, row, 0xFFF)
    if tile.size == 0:
        if tile.format == IA:
            i = value >> 1
            return grey(i << 5 | i << 2 | i >> 1, (value & 1) * 255)
        i = tile.palette * 16 + value if tile.format == CI else value * 17
        return grey(i, i)
    if tile.size == 1:
        return grey((value >> 4) * 17, (value & 15) * 17) if tile.format == IA \
            else grey(value, value)
    if tile.format == RGBA:
        return rgba16(value)
    if tile.format == IA and tile.size == 2:
        return ia16(value)
    return np.stack([value >> 8, value & 255] * 2, -1)  # undocumented pairs
