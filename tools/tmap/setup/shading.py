"""The integer model's light: c/polygon/shading.c and src68k/edge/edge_shade.s."""

from dataclasses import dataclass

import numpy as np

from tmap.base.fixed import counted, signed
from tmap.setup.texturing import Line, Settings, Texturing, plane

LIT = ("lit", "lit_gouraud")  # mappers
FREE_BITS = 3  # of a level's fraction: kept 0


def level_of(shade: int) -> int:
    """Returns the level of a vertex's shade, both 16.16."""
    return shade >> 2


@dataclass
class Shading:
    """The levels of a polygon: u of a plane, within ``low`` to ``high``."""

    plane: Texturing
    low: int
    high: int


def shading(vertices, corners, box) -> Shading:
    """Returns the light of vertices whose last number is their level, 16.16."""
    levels = [v[-1] for v in vertices]
    t = plane([(*v[:2], v[-1], 0) for v in vertices], corners, box, Settings(mapper="levels"))
    return Shading(t, min(levels) & ~0xFFFF, (max(levels) | 0xFFFF) - FREE_BITS)


def light_lines(lines: list[Line], top: int, light: Shading) -> None:
    """Sets the level and its step of each line, so that no pixel leaves the range."""
    t, longest = light.plane, max(1, *(line.right - line.left for line in lines)) - 1
    step = signed(t.dudx)
    if longest:
        most = (light.high - light.low) // longest & ~FREE_BITS
        step = min(max(step, -most), most)
    for y, line in enumerate(lines, top):
        start = signed(t.u + (y - t.j) * t.dudy + (line.left - t.i) * t.dudx)
        travel = (line.right - line.left - 1) * step
        line.c = min(max(start, light.low - min(travel, 0)), light.high - max(travel, 0))
        line.dcdx = step


def rows(lines: list[Line]) -> np.ndarray:
    """Returns the light table's row at each pixel of lines, one after the other."""
    counts = [line.right - line.left for line in lines]
    c, step = np.repeat([(line.c, line.dcdx) for line in lines], counts, axis=0).T
    return c + counted(counts) * step >> 16
