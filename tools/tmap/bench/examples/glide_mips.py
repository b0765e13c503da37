"""Examples of the passes that sample a level for each pixel."""

import numpy as np

from tmap.bench.examples.example import (BENCH, Example, Map, any_texels, pairs, pixels,
                                         some_coordinates, words)
from tmap.bench.examples.glide_sample import EDGES, SIDE, filtered, quad_bytes
from tmap.build import layout

LEVELS = 9
LARGE = 2  # larger levels are tried as narrow ones alone, whose quads take less memory


def any_levels(rng, count: int) -> tuple[np.ndarray, list[int], list[Map | None]]:
    """LODs; the shift and the map of each integer part of a LOD, or none where no pixel has it. An
    integer's level is the next one if the map holds only even levels or only odd ones."""
    first = LARGE if count == BENCH else int(rng.integers(LEVELS))
    parity = int(rng.integers(3))
    shifts = [min(n + (parity < 2 and n & 1 != parity), LEVELS - 1) for n in range(LEVELS)]
    aspect = 3 if first < LARGE else int(rng.integers(4))
    aspects = np.array((aspect, 0))[::int(rng.choice((-1, 1)))]
    made = {shift: Map(any_texels(rng, int(np.prod(side))).reshape(*side, 4))
            for shift in set(shifts) if shift >= first
            for side in [np.maximum(SIDE >> aspects >> shift, 1)]}
    lods = np.minimum(rng.integers(first << 8, LEVELS << 8, count), LEVELS - 1 << 8)
    return lods, shifts, [made.get(shift) for shift in shifts]


def level_bytes(shifts: list[int], maps: list[Map | None], half: int, to_bytes) -> bytes:
    """The array of struct glide_mip, and texels behind it. Levels without a map are not drawn."""
    struct = layout.load().struct("glide_mip")
    head, blocks = b"", b""
    for shift, ground in zip(shifts, maps):
        if not ground:
            head += bytes(struct.size)
            continue
        rows, columns = ground.texels.shape[:2]
        y, x = np.divmod(np.arange(rows * columns), columns)
        head += struct.pack(half=(half << shift) * 0x10001, mask_s=columns - 1 << 4,
                            mask_t=rows - 1 << 4,
                            texels=struct.size * LEVELS - len(head) + len(blocks),
                            columns_bits=columns.bit_length() - 1, shift=shift)
        blocks += to_bytes(ground.corners(x, y))
    return head + blocks


def example(rng, count: int, half: int, to_bytes, found) -> Example:
    """``found``: a map's texels at coordinates [n][2], 12.4."""
    st = some_coordinates(rng, count, EDGES, 0.1)
    lods, shifts, maps = any_levels(rng, count)
    texels = np.zeros((count, 4), np.int64)
    for n in np.unique(lods >> 8):
        at = lods >> 8 == n
        texels[at] = found(maps[n], (st[at] >> shifts[n]) - half)
    return Example(pairs(st), pixels(texels), count, "glide_mips", {},
                   {"lods": words(lods), "levels": level_bytes(shifts, maps, half, to_bytes)})


def point(rng, count: int) -> Example:
    return example(rng, count, 0, lambda corners: pixels(corners[:, 0]),
                   lambda ground, st: ground.corners(*(st >> 4).T)[:, 0])


def bilinear(rng, count: int) -> Example:
    return example(rng, count, 8, quad_bytes, lambda ground, st: filtered(st, ground, 4))
