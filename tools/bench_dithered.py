"""Bench rows of the dithered spans: as those of tools.bench_cases, points moved by the pixel."""

import numpy as np

from . import layout, maps
from .bench_mappers import DU, first_difference
from .kernels import M32, Arena, Case, Result
from .model_dithered import MOST, moves
from .scanline import add_span_plan, pack

DV = 0xC000  # texels a pixel, 16.16: v need not wrap in a line of 256 pixels
#: Ends of the kernels' names: bytes of a pixel.
NAMES = {"": 1, "_wrap": 1, "_16": 2, "_16_wrap": 2, "_32": 4, "_32_wrap": 4}


def dithered_case(name: str, wide: int, length: int):
    """A table of spans of one length from a page of noise; v wraps where the kernel allows it."""
    rng = np.random.default_rng(length)
    lines = min(128, max(16, 2048 // length))
    pitch = length + 4  # pixels from line to line: each line begins 0 to 3 pixels on
    constants = layout.load().constants
    arena, far, n = Arena(), Arena(), np.arange(length)
    picture = rng.integers(0, 256**wide, (256, 256)).astype(f">u{wide}")
    map_at = far.add(maps.to_page(picture).tobytes(), constants["ARENA_ALIGN"])
    if wide > 1:
        map_at += picture.nbytes // 2
    entries = np.zeros(lines, layout.load().struct("scanline").dtype)
    expected = np.zeros((lines, pitch), picture.dtype)
    low = round(MOST * 65536)
    high = (256 << 16) - low - (0 if "wrap" in name else length * DV)
    for k in range(lines):
        u, v, x = int(rng.integers(1 << 24)), int(rng.integers(low, high)), k % 4
        for field, value in pack("addx", u - low & M32, v - low & M32).items():
            entries[k][field] = value
        entries[k]["left"] = constants["EDGE_BIAS"] + x
        entries[k]["last"] = entries[k]["left"] + length - 1
        du, dv = moves(x, x + length, k)
        expected[k, x:x + length] = picture[(v + n * DV + dv) >> 16 & 255,
                                            (u + n * DU + du) >> 16 & 255]
    frame_at = far.add(bytes(expected.nbytes))
    plan_at = add_span_plan(
        arena, dict(lines=arena.add(entries.tobytes())),
        dict(row=frame_at - constants["EDGE_BIAS"] * wide, map=map_at), count=lines,
        pitch=pitch * wide, dudx=DU, dvdx=DV, odd=0)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.far_memory, picture.dtype, expected.size, frame_at)
        return first_difference(expected, found.reshape(expected.shape))

    return lines * length, Case(name, arena, pointers={"a0": plan_at}, far=far), check


def dithered_rows(length: int) -> list[tuple]:
    """Name, length, pixels, case and check of each kernel."""
    return [(f"dithered{end}", length, *dithered_case(f"span_dithered{end}", wide, length))
            for end, wide in NAMES.items()]
