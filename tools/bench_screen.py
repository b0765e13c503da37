"""Bench rows of the way to the screen: a frame to its planes, rows' and planes' ends included."""

import numpy as np

from . import planar
from .kernels import Arena, Case, Result

SCREEN = 320, 256
NAMES = ("c2p_8",)


def place(kernel: str, pixels: np.ndarray, planes: planar.Planes, pitch: int, arena: Arena,
          far: Arena, room: bytes) -> tuple[Case, int]:
    """The call of a kernel, pixels in the near arena, planes in the far one; and where those
    begin. ``pixels``: bytes [row][x], ``pitch`` from row to row, ``room`` what the planes'
    block holds before."""
    lines = np.arange(planes.rows) * pitch
    first, content = -int(lines.min()), bytearray(np.ptp(lines) + pixels.shape[1])
    for row, at in zip(pixels, lines):
        content[first + at:first + at + len(row)] = row.tobytes()
    at, out = arena.add(content, 8), far.add(room)
    plan = arena.struct(
        "planar_plan", {"pixels": at + first}, {"planes": out + planes.first}, pitch=pitch,
        width=planes.width, rows=planes.rows, row_pitch=planes.row_pitch,
        plane_pitch=planes.plane_pitch)
    return Case(kernel, arena, pointers={"a0": plan}, far=far), out


def screen_case(kernel: str):
    """A screen of noise in one call."""
    (width, height), planes = SCREEN, planar.Planes.separate(*SCREEN)
    pixels = np.random.default_rng(8).integers(0, 256, (height, width), np.uint8)
    case, out = place(kernel, pixels, planes, width, Arena(), Arena(), bytes(planes.size))

    def check(result: Result) -> str | None:
        block = np.frombuffer(result.far_memory, np.uint8, planes.size, out)
        return planar.difference(pixels, planes.get(block))

    return width * height, case, check
