"""Bench rows of the dithered spans: as those of tmap.bench.spans, points moved by the pixel."""

import numpy as np

from tmap.base import maps
from tmap.base.fixed import M32, fix
from tmap.bench.spans import DU, GAP, line_count, scanlines, span_call
from tmap.build import layout
from tmap.guest.kernels import Arena
from tmap.setup.dithered import MOST, moves

DV = 0xC000  # texels a pixel, 16.16: v need not wrap in a line of 256 pixels
#: Ends of the kernels' names: bytes of a pixel.
NAMES = {"": 1, "_wrap": 1, "_16": 2, "_16_wrap": 2, "_32": 4, "_32_wrap": 4}


def dithered_case(name: str, wide: int, length: int):
    """A table of spans of one length from a page of noise, ``wide`` bytes a pixel; v wraps where the
    kernel allows it."""
    rng, lines = np.random.default_rng(length), line_count(length)
    arena, far, n = Arena(), Arena(), np.arange(length)
    picture = rng.integers(0, 256**wide, (256, 256)).astype(f">u{wide}")
    map_at = far.add(maps.to_page(picture).tobytes(), layout.load().constants["ARENA_ALIGN"])
    if wide > 1:
        map_at += picture.nbytes // 2
    low = fix(MOST)
    high = (256 << 16) - low - (0 if "wrap" in name else length * DV)
    starts, expected = [], np.zeros((lines, length + GAP), picture.dtype)
    for k in range(lines):
        u, v, x = int(rng.integers(1 << 24)), int(rng.integers(low, high)), k % 4
        starts.append((x, u - low & M32, v - low & M32))
        du, dv = moves(x, x + length, k)
        expected[k, x:x + length] = picture[(v + n * DV + dv) >> 16 & 255,
                                            (u + n * DU + du) >> 16 & 255]
    pointers = {"lines": arena.add(scanlines(starts, length, "addx"))}
    return lines * length, *span_call(name, arena, far, pointers, {"map": map_at}, expected, dudx=DU,
                                      dvdx=DV, odd=0)


def dithered_rows(length: int) -> list[tuple]:
    """Name, length, pixels, case and check of each kernel."""
    return [(f"dithered{end}", length, *dithered_case(f"span_dithered{end}", wide, length))
            for end, wide in NAMES.items()]
