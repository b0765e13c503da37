"""Pixels of a primitive: from iterators to colours, all of a primitive at once."""

import numpy as np

from tmap.n64.combiner import Sources, combine, samples, used
from tmap.n64.divide import divide
from tmap.n64.filters import sample
from tmap.n64.lod import Gradients, level, upper
from tmap.n64.misuse import Misuse
from tmap.n64.state import ONE_CYCLE, TWO_CYCLES, State
from tmap.n64.texels import rgba16


def check(state: State) -> None:
    """Refuses modes in which ``pixels`` cannot draw."""
    if state.modes.cycle not in (ONE_CYCLE, TWO_CYCLES):
        raise Misuse("cycle type", "pixels are combined in one-cycle and two-cycle mode only")


def by_tiles(state: State, tiles: np.ndarray, s: np.ndarray, t: np.ndarray, cycle: int,
             previous: np.ndarray | None) -> np.ndarray:
    """Returns samples [n, 4] of pixels [n] that each have their own tile."""
    found = np.zeros((tiles.size, 4), np.int64)
    for number in np.unique(tiles).tolist():
        state.check_tile(number)
        here = tiles == number
        found[here] = sample(state, number, s[here], t[here], cycle,
                             None if previous is None else previous[here])
    return found


def pixels(state: State, s: np.ndarray, t: np.ndarray, w: np.ndarray, gradients: Gradients,
           shade: np.ndarray | None) -> np.ndarray:
    """Returns colours uint8 [n, 4] of pixels.

    ``s``, ``t``, ``w``: iterators int64 [n], s15.16 modulo 2^32; ``shade``: [n, 4], 0..255.
    In one-cycle mode there is one sample for both texel inputs; its tile and the LOD fraction
    are those of the two-cycle mode without the differences between lines.
    """
    check(state)
    two = state.modes.cycle == TWO_CYCLES
    if two or state.modes.lod or "lod fraction" in used(state.combine, 1):
        steps = gradients if two else gradients._replace(dsdy=0, dtdy=0, dwdy=0)
        at = level(state, s, t, w, steps)
        texel0 = by_tiles(state, at.tile0, at.s, at.t, 0, None)
        second = two and 1 in samples(state)
        texel1 = by_tiles(state, at.tile1, at.s, at.t, 1, texel0) if second else texel0
        return combine(state, Sources(texel0, texel1, shade, at.fraction))
    at = divide(upper(s), upper(t), upper(w), state.modes.perspective)
    tiles = np.full(at.s.shape, state.primitive_tile)
    texel = by_tiles(state, tiles, at.s, at.t, 0, None)  # no input reads the fraction
    return combine(state, Sources(texel, texel, shade, tiles))


def rgba5551(colours: np.ndarray) -> np.ndarray:
    """Converts colours [..., 4] to 16-bit pixels: each channel is cut to its upper bits."""
    r, g, b, a = (colours[..., k].astype(np.uint16) for k in range(4))
    return r >> 3 << 11 | g >> 3 << 6 | b >> 3 << 1 | a >> 7


def rgba8888(colours: np.ndarray) -> np.ndarray:
    """Converts colours [..., 4] to 32-bit pixels."""
    r, g, b, a = (colours[..., k].astype(np.uint32) for k in range(4))
    return r << 24 | g << 16 | b << 8 | a


def store(frame: np.ndarray, y: np.ndarray, x: np.ndarray, colours: np.ndarray) -> None:
    """Writes pixels into a frame, uint16 (5551) or uint32 (8888) [height, width]."""
    frame[y, x] = rgba5551(colours) if frame.dtype == np.uint16 else rgba8888(colours)


def picture(frame: np.ndarray) -> np.ndarray:
    """Converts a frame to uint8 [height, width, 4] for display."""
    if frame.dtype == np.uint16:
        return rgba16(frame.astype(np.int64)).astype(np.uint8)
    return np.stack([frame >> shift & 255 for shift in (24, 16, 8, 0)], -1).astype(np.uint8)
