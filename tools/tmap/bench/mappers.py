"""Bench rows of the mappers beside the affine one: Gouraud, arbitrary size, generated."""

import numpy as np

from tmap.base.fixed import ONE
from tmap.bench.spans import DU, DV, GAP, line_count, scanlines, span_call
from tmap.build import layout
from tmap.guest.kernels import Arena
from tmap.setup.spans import texel_generated

DS = 0xA000  # shades a pixel, 16.16
DU_ROW = 0x3000  # texels a pixel, of generated code: 1024 pixels stay in a row of the map
PICTURE = 331, 417  # rows and columns of the arbitrary map: at an odd address


def add_map(far: Arena, name: str, picture: np.ndarray) -> int:
    """Adds a map as a mapper wants it; where the mapper's pointer goes."""
    if "gouraud" in name:
        return 0  # there is none
    if name == "arbitrary":
        return far.add(b"\0" + picture.tobytes()) + 1
    half = len(picture) // 2  # as much again lies before it, and behind it
    lying = np.concatenate([picture[half:], picture, picture[:half]]).tobytes()
    return far.add(bytes(32768) + lying, ONE) + ONE


def start_of(name: str, rng: np.random.Generator, steps: tuple[int, int], length: int) -> tuple[int, int]:
    """u and v of a line: shades that do not run over; all of it inside the arbitrary map, or inside a
    row of generated code's."""
    if "gouraud" in name:
        return int(rng.integers(0, 90 << 16)), 0
    if name == "arbitrary":
        travel = [step * (length - 1) for step in steps]
        return tuple(int(rng.integers(max(0, -t), (side << 16) - max(0, t)))
                     for t, side in zip(travel, PICTURE[::-1]))
    return int(rng.integers(0, (255 << 16) - steps[0] * length)), int(rng.integers(0, 256 << 16))


def drawn(name: str, picture: np.ndarray, start: tuple[int, int], steps: tuple[int, int],
          length: int) -> np.ndarray:
    """A line's pixels."""
    n, (u, v), (du, dv) = np.arange(length), start, steps
    if "gouraud" in name:
        return (u + n * du) >> 16
    if name == "arbitrary":
        return picture[(v + n * dv) >> 16, (u + n * du) >> 16]
    return picture.reshape(-1)[texel_generated(u, v, du, dv, length) & 0xFFFF]


def mapper_case(name: str, length: int, dv: int = DV, lines: int = 0):
    """A table of spans of one length, as tmap.bench.spans.span_case."""
    rng, lines = np.random.default_rng(length), lines or line_count(length)
    arena, far = Arena(), Arena()
    rows, columns = PICTURE if name == "arbitrary" else (256, 256)
    picture = rng.integers(0, 256, (rows, columns), dtype=np.uint8)
    map_at = add_map(far, name, picture)
    steps = DS if "gouraud" in name else DU_ROW if name == "generated" else DU, dv
    starts = [(k % 4, *start_of(name, rng, steps, length)) for k in range(lines)]
    expected = np.zeros((lines, length + GAP), np.uint8)
    for k, (x, *start) in enumerate(starts):
        expected[k, x:x + length] = drawn(name, picture, tuple(start), steps, length)
    pointers = {"lines": arena.add(scanlines(starts, length, "plain")),
                "code": arena.add(bytes(layout.load().constants["CODE_BYTES"]))}
    return lines * length, *span_call(f"span_{name}", arena, far, pointers, {"map": map_at}, expected,
                                      dudx=steps[0], dvdx=dv, map_width=columns, map_height=rows)
