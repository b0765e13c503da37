"""Bench rows of the way to the screen: a frame to its planes, ends of rows included."""

import numpy as np

from . import planar
from .kernels import Arena, Case, Result

#: Pixels: HAM8's are four dots wide each, of 640 in a row.
SCREENS = {"c2p_8": (320, 256), "c2p_ham8_16": (160, 256), "c2p_ham8_32": (160, 256)}
ROWS_IN_C = 16
NAMES = [name + end for name in SCREENS for end in ("", "_c")]


def frame(pixels: np.ndarray, pitch: int, padding: bytes) -> tuple[bytearray, int]:
    """Rows of pixels in memory, ``padding`` between them, and where the first one is."""
    lines = np.arange(len(pixels)) * pitch
    first, size = -int(lines.min()), int(np.ptp(lines)) + pixels[0].nbytes
    content = bytearray((padding * size)[:size])
    for row, at in zip(pixels, lines):
        content[first + at:first + at + row.nbytes] = row.tobytes()
    return content, first


def place(kernel: str, pixels: np.ndarray, pitch: int, planes: planar.Planes, arena: Arena,
          far: Arena, before: bytes) -> tuple[Case, int]:
    """The call of a kernel, pixels in the near arena, planes in the far one, where the block of
    planes holds ``before``; and where that is."""
    content, first = frame(pixels, pitch, b"\xa5")
    at, out = arena.add(content, 8), far.add(before)
    plan = arena.struct(
        "planar_plan", {"pixels": at + first}, {"planes": out + planes.first}, pitch=pitch,
        width=pixels.shape[1], rows=planes.rows, row_pitch=planes.row_pitch,
        plane_pitch=planes.plane_pitch)
    return Case(kernel, arena, pointers={"a0": plan}, far=far), out


def screen_case(kernel: str):
    """A screen of noise, the maps' (a plan has it once), in one call; each plane behind the one
    before."""
    name = kernel.removesuffix("_c")
    form, (width, rows) = planar.FORMS[name], SCREENS[name]
    rows = rows if kernel == name else ROWS_IN_C
    pixels = planar.noise(name, np.random.default_rng(256), width, rows)
    row = form.dots * width // 8
    planes = planar.Planes(8 * row, rows, row, row * rows, form.planes)
    case, out = place(kernel, pixels, width * form.bytes, planes, Arena(), Arena(),
                      bytes(planes.size))
    expected = form.convert(pixels)

    def check(result: Result) -> str | None:
        block = np.frombuffer(result.far_memory, np.uint8, planes.size, out)
        return planar.difference(expected, planes.decoded(block))

    return width * rows, case, check
