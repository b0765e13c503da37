"""Copy mode: four 16-bit texels per step, neither clamped nor filtered nor converted."""

import numpy as np

from tmap.n64.coordinates import masked, shifted
from tmap.n64.state import RGBA, YUV, State, Tile
from tmap.n64.texels import entries, fetch, half_word, raw, rows_of


def check(state: State, number: int) -> None:
    """Refuses a tile that cannot be copied."""
    tile = state.tiles[number & 7]
    state.forbids(tile.format == YUV or (tile.format, tile.size) == (RGBA, 3), "copy format",
                  f"tile {number}: copy mode of YUV or of RGBA of 32 bits")
    state.forbids(not state.modes.tlut and tile.size != 2, "copy format",
                  f"tile {number}: copy mode needs texels of 16 bits or a TLUT")


def unit(state: State, tile: Tile, s: np.ndarray, row: np.ndarray) -> np.ndarray:
    """Returns the 16 bits that contain a texel; for 32-bit texels those in TMEM's lower half."""
    base, swap = rows_of(tile, row)
    mask = 0x7FE if tile.size == 3 else 0xFFE
    return half_word(state.tmem, (base + (s << tile.size >> 1 if tile.size < 3 else 2 * s) ^ swap)
                     & mask)


def copy(state: State, number: int, s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Returns four texels from (s, t), s10.5, on: 16 bits each, int64 [..., 4].

    Without a TLUT, texels that do not have 16 bits (which no manual allows) return the first pair
    as four bytes of intensity or red, and the second as the 16 bits that contain its texels.
    """
    tile = state.tiles[number & 7]
    first, row = ((shifted(axis, c) - 8 * axis.low) >> 5
                  for axis, c in ((tile.s, s), (tile.t, t)))
    row = masked(tile.t, row, True)[0]
    bytes_first = not state.modes.tlut and tile.size != 2
    texels, reds = [], []
    for j in range(4):
        column = masked(tile.s, first + j, False)[0]
        if state.modes.tlut:
            texels.append(entries(state, tile, column, row, j))
        elif not bytes_first:
            texels.append(raw(state, tile, column, row, 0xFFF))
        else:
            texels.append(unit(state, tile, column, row))
            reds.append(fetch(state, tile, column, row)[..., 0])
    if bytes_first:
        texels[:2] = [reds[0] << 8 | reds[1], reds[2] << 8 | reds[3]]
    return np.stack(texels, -1)
