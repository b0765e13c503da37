"""Bench rows of spans from a page, and what the rows of all spans share: tables of lines of one
length, calls that leave a picture, and its check.
"""

from collections.abc import Callable

import numpy as np

from tmap.base import maps
from tmap.build import layout
from tmap.corpus import random_maps
from tmap.guest.kernels import Arena, Case, Result
from tmap.setup.scanline import add_span_plan, pack

DU, DV = 0x18000, 0x14000  # texels a pixel, 16.16
LENGTHS = (256, 64, 16, 4)  # pixels
#: Of the spans for short lines and of the copying one: kernel, steps, lengths.
SPECIAL = (("affine_copy", 1 << 16, 0, (256, 64, 16, 4, 1)), ("affine_short", DU, DV, (16, 4, 1)),
           ("affine_short_wrap", DU, DV, (16, 4, 1)), ("affine_row_short", DU, 0, (24, 16, 4, 1)))
BIAS = 16384  # what struct scanline adds to columns: EDGE_BIAS
COLOUR = 0x5C  # of spans without a map
GAP = 4  # pixels from a line's last to the next one's first place: lines begin 0 to 3 pixels on

Check = Callable[[Result], str | None]


def line_count(length: int) -> int:
    """Lines of a row: so many that a call draws 2,048 pixels, but 16 to 128."""
    return min(128, max(16, 2048 // length))


def first_difference(expected: np.ndarray, found: np.ndarray) -> str | None:
    """Where two pictures first differ, in words; None where they are equal."""
    wrong = np.argwhere(expected != found)
    if not len(wrong):
        return None
    y, x = wrong[0]
    return (f"{len(wrong)} pixels differ, the first at ({x}, {y}): "
            f"expected {expected[y, x]:#04x}, found {found[y, x]:#04x}")


def table_of(lines: list[dict[str, int]]) -> bytes:
    """A table of struct scanline with the fields given, the others 0."""
    dtype = layout.load().struct("scanline").dtype
    return np.array([tuple(line.get(name, 0) for name in dtype.names) for line in lines], dtype).tobytes()


def scanlines(starts: list[tuple[int, int, int]], length: int, form: str) -> bytes:
    """Entries of struct scanline of ``length`` pixels each, from (first column, u, v)."""
    return table_of([pack(form, u, v) | {"left": BIAS + first, "last": BIAS + first + length - 1}
                     for first, u, v in starts])


def span_call(kernel: str, arena: Arena, far: Arena, pointers: dict[str, int],
              far_pointers: dict[str, int], expected: np.ndarray, **values: int) -> tuple[Case, Check]:
    """The call that must leave ``expected`` in a frame of zeros, and its check. ``pointers``,
    ``far_pointers``, ``values``: the plan's, but for the frame's."""
    frame_at = far.add(bytes(expected.nbytes))
    row = frame_at - BIAS * expected.itemsize
    plan_at = add_span_plan(arena, pointers, {"row": row} | far_pointers, count=len(expected),
                            pitch=expected.shape[1] * expected.itemsize, **values)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.far_memory, expected.dtype, expected.size, frame_at)
        return first_difference(expected, found.reshape(expected.shape))

    return Case(kernel, arena, pointers={"a0": plan_at}, far=far), check


def wide_texture(kernel: str) -> np.ndarray:
    """The same with as many bytes a texel as the kernel's name says, big-endian."""
    picture = random_maps.page()
    for bits, shifts in (("16", (8,)), ("32", (8, 16, 24))):
        if bits in kernel.split("_"):
            wide = sum(picture.astype(int) << shift for shift in shifts) | picture.T
            return wide.astype(f">u{int(bits) // 8}")
    return picture


def add_map(far: Arena, kernel: str, picture: np.ndarray) -> int:
    """Adds a map as a kernel wants it; where the kernel's pointer goes."""
    stored = maps.to_tiled(picture) if "tiled" in kernel else \
        maps.to_columns(picture) if "columns" in kernel else maps.to_page(picture)
    map_at = far.add(stored.tobytes(), layout.load().constants["ARENA_ALIGN"])
    return map_at + stored.nbytes // 2 if picture.itemsize > 1 and "affine" in kernel else map_at


def span_case(kernel: str, form: str, length: int, du: int = DU, dv: int = DV, lines: int = 0):
    """A table of spans of one length; starts such that v wraps once in a long one. ``lines``: how many
    (line_count's)."""
    rng = np.random.default_rng(length)
    lines = lines or line_count(length)
    arena, far, picture = Arena(), Arena(), wide_texture(kernel)
    map_at = add_map(far, kernel, picture)
    starts = [(k % 4, int(rng.integers(0, 1 << 24)) & ~1, int(rng.integers(0, 190 << 16)))
              for k in range(lines)]
    pointers = {"lines": arena.add(scanlines(starts, length, form))}
    if "scanline" in kernel:
        steps = layout.load().struct("scanline_step").pack(dudx=du, dvdx=dv)
        pointers["steps"] = arena.add(steps * lines)
    if "columns" in kernel:
        pointers["columns"] = arena.struct("column_layout", {}, v_bits=8, u_mask=0xFC03,
                                           v_mask=0x3FC)
    n, expected = np.arange(length), np.zeros((lines, length + GAP), picture.dtype)
    for k, (x, u, v) in enumerate(starts):
        texels = picture[(v + n * dv) >> 16 & 255, (u + n * du) >> 16 & 255]
        expected[k, x:x + length] = COLOUR if "fill" in kernel else texels
    return lines * length, *span_call(kernel, arena, far, pointers, {"map": map_at}, expected, dudx=du,
                                      dvdx=dv, colour=COLOUR)
