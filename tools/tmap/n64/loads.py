"""Loads: chunks of 8 bytes from DRAM into TMEM, whose odd rows swap 32-bit halves."""

import numpy as np

from tmap.n64.misuse import Misuse
from tmap.n64.state import RGBA, TMEM_WORDS, YUV, State, Tile

BLOCK_TEXELS = 2048  # the most of a block
TLUT_ENTRIES = 256
TLUT_WORD = 256  # the TLUT area's first word


def columns(tile: Tile, s: np.ndarray) -> np.ndarray:
    """Returns the 16-bit columns of texels s within a tile."""
    if tile.format == YUV or tile.size == 1:
        return s >> 1
    return s >> 2 if tile.size == 0 else s


def put(tmem: np.ndarray, tile: Tile, rows: np.ndarray, s: np.ndarray,
        chunks: np.ndarray) -> None:
    """Stores chunks in order. ``rows``, ``s``: [n], each chunk's place relative to the tile's first
    texel; ``chunks``: uint8 [n, 8]. Later chunks overwrite earlier ones."""
    units = tmem.reshape(-1, 2)
    pairs = chunks.reshape(-1, 4, 2)
    base = (tile.line * rows % TMEM_WORDS + tile.tmem) * 4 + columns(tile, s)
    swap = (rows & 1) * 2
    if tile.format == YUV or (tile.format, tile.size) == (RGBA, 3):
        first = (base & 0x7FE ^ swap) & 0x3FF
        at = first[:, None] + np.array([0, 1, 0x400, 0x401])
        if tile.format == YUV:  # U0 Y0 V0 Y1 U1 Y2 V1 Y3
            pairs = chunks[:, [[0, 2], [4, 6], [1, 3], [5, 7]]]
        else:
            pairs = pairs[:, [0, 2, 1, 3]]
    else:
        at = (base & 0x7FC)[:, None] + np.arange(4) ^ swap[:, None]
    units[at.reshape(-1)] = pairs.reshape(-1, 2)


def read(state: State, addresses: np.ndarray, count: int) -> np.ndarray:
    """Returns ``count`` bytes of DRAM from each address, uint8 [n, count]."""
    if addresses.size and addresses.max() + count > state.dram.size:
        raise Misuse("dram", f"a load reads up to byte {addresses.max() + count:#x} of "
                             f"{state.dram.size:#x} of DRAM")
    return state.dram[addresses[:, None] + np.arange(count)]


def check(state: State) -> None:
    """Refuses an image from which no texels can be loaded."""
    state.forbids(state.image.size == 0, "image size",
                  "a load from an image of 4 bits a texel, which hangs the hardware")


def load_tile(state: State, tile: Tile) -> None:
    """Loads a rectangle of the image; its edges are those of the tile (10.2)."""
    check(state)
    left, top, right, bottom = (c >> 2 for c in (tile.s.low, tile.t.low, tile.s.high, tile.t.high))
    state.forbids(right < left or bottom < top, "tile edges", "a load tile of no texels")
    step = 16 >> state.image.size
    across = (right - left) // step + 1 if right >= left else 0
    rows, c = (a.reshape(-1) for a in
               np.mgrid[top:max(bottom + 1, top), 0:across])
    texels = rows * state.image.width + left
    addresses = state.image.address + (texels << state.image.size >> 1) + 8 * c
    put(state.tmem, tile, rows - top, c * step, read(state, addresses, 8))


def load_block(state: State, tile: Tile) -> None:
    """Loads a run of texels; sl, tl and sh are whole texels, th is dxt (u1.11), rows per chunk."""
    check(state)
    count, dxt = tile.s.high - tile.s.low + 1, tile.t.high
    state.forbids(not 0 < count <= BLOCK_TEXELS, "block length",
                  f"a load block of {count} texels; there must be 1 to {BLOCK_TEXELS}")
    step = 16 >> state.image.size
    c = np.arange(max(-(-count // step), 0))
    texel = tile.t.low * state.image.width + tile.s.low
    addresses = state.image.address + (texel << state.image.size >> 1) + 8 * c
    put(state.tmem, tile, c * dxt >> 11, c * step, read(state, addresses, 8))


def load_tlut(state: State, tile: Tile) -> None:
    """Loads entries of a palette, each four times into one word."""
    first, last = tile.s.low >> 2, tile.s.high >> 2
    count = last - first + 1
    state.forbids(state.image.size != 2, "TLUT image", "a load TLUT from an image not of 16 bits")
    state.forbids(tile.size != 0, "TLUT tile", "a load TLUT through a tile not of 4 bits")
    state.forbids(tile.t.low >> 2 != tile.t.high >> 2, "TLUT rows",
                  "a load TLUT over several rows, which hangs the hardware")
    state.forbids(not 0 < count <= TLUT_ENTRIES, "TLUT entries",
                  f"a load TLUT of {count} entries; there must be 1 to {TLUT_ENTRIES}")
    state.forbids(tile.tmem < TLUT_WORD or tile.tmem + count > TMEM_WORDS, "TLUT place",
                  f"a load TLUT into words {tile.tmem} to {tile.tmem + count - 1}; its area "
                  f"is {TLUT_WORD} to {TMEM_WORDS - 1}")
    e = np.arange(max(count, 0))
    texels = (tile.t.low >> 2) * state.image.width + first + e
    entries = read(state, state.image.address + 2 * texels, 2)
    words = state.tmem.reshape(-1, 4, 2)
    words[(tile.tmem + e) % TMEM_WORDS] = entries[:, None, :]
