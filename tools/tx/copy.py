"""Copy mode: four 16-bit texels a step, neither clamped nor filtered nor converted."""

import numpy as np

from .coordinates import masked, shifted
from .state import RGBA, YUV, State
from .texels import entries, raw


def check(state: State, number: int) -> None:
    """Whether a tile can be copied."""
    tile = state.tiles[number & 7]
    state.forbids(tile.format == YUV or (tile.format, tile.size) == (RGBA, 3), "copy format",
                  f"tile {number}: copy mode of YUV or of RGBA of 32 bits")
    state.forbids(not state.modes.tlut and tile.size != 2, "copy format",
                  f"tile {number}: copy mode needs texels of 16 bits or a TLUT")


def copy(state: State, number: int, s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Four texels from (s, t), s10.5, on: 16 bits each, int64 [..., 4]."""
    tile = state.tiles[number & 7]
    first, row = ((shifted(axis, c) - 8 * axis.low) >> 5
                  for axis, c in ((tile.s, s), (tile.t, t)))
    row = masked(tile.t, row, True)[0] & 255
    texels = []
    for j in range(4):
        column = masked(tile.s, first + j, False)[0]
        if state.modes.tlut:
            texels.append(entries(state, tile, column, row, j))
        else:
            texels.append(raw(state, tile, column, row, 0xFFF))
    return np.stack(texels, -1)
