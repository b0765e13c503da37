"""Calls of the dithered spans: points are moved by the pixel."""

import numpy as np

from tmap.base import maps
from tmap.base.fixed import M32, fix
from tmap.bench.spans import DU, GAP, Ground, Line, framed, line_count, table_trial, texels
from tmap.bench.trial import Trial
from tmap.build import layout
from tmap.guest.kernels import Arena
from tmap.setup import dithered

DV = 0xC000  # texels a pixel, 16.16: v need not wrap in a line of 256 pixels
MOST = fix(dithered.MOST)
#: Ends of the kernels' names: bytes of a pixel.
NAMES = {"": 1, "_wrap": 1, "_16": 2, "_16_wrap": 2, "_32": 4, "_32_wrap": 4}


def dithered_trial(kernel: str, lines: list[Line], pitch: int, arena: Arena, ground: Ground,
                   title: str = "", *, dudx: int, dvdx: int, odd: int, **more) -> Trial:
    """One table of lines, u and v less than their points' by MOST; ``odd``: line 0's parity."""
    def drawn(k: int, _: int, column: int, count: int, u: int, v: int) -> np.ndarray:
        du, dv = dithered.moves(np.arange(column, column + count), k + odd)
        return texels(ground.picture, u + MOST + du, v + MOST + dv, dudx, dvdx, count)

    return table_trial(kernel, "addx", lines, pitch, arena, ground, drawn, title, dudx=dudx,
                       dvdx=dvdx, odd=odd, **more)


def dithered_case(name: str, wide: int, length: int):
    """A table of spans of one length from noise, ``wide`` bytes a pixel; v wraps if it may."""
    rng, lines, far = np.random.default_rng(length), line_count(length), Arena()
    picture = rng.integers(0, 256**wide, (256, 256)).astype(f">u{wide}")
    map_at = far.add(maps.to_page(picture).tobytes(), layout.load().constants["ARENA_ALIGN"])
    if wide > 1:
        map_at += picture.nbytes // 2
    high = (256 << 16) - MOST - (0 if "wrap" in name else length * DV)
    starts = []
    for k in range(lines):
        u, v = int(rng.integers(1 << 24)), int(rng.integers(MOST, high))
        starts.append((k % 4, length, u - MOST & M32, v - MOST & M32))
    return dithered_trial(name, starts, length + GAP, Arena(),
                          framed(far, map_at, picture, lines, length), dudx=DU, dvdx=DV,
                          odd=0).row(lines * length)
