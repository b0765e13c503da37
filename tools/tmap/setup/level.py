"""The integer model's lines and columns of polygons with perspective that are drawn as if they were affine:
c/perspective/draw.c, src68k/edge/level_lines and lines_bend.
Those by reciprocals: tmap.setup.level_reciprocal."""

import numpy as np

from tmap.base.fixed import M32, counted, signed
from tmap.build import layout
from tmap.setup import level_reciprocal
from tmap.setup.perspective import Perspective, cut_quotients, steepness, way
from tmap.setup.texturing import Line

STEEP_2_22 = 1 << 22
MAP = 0xFFFFFF  # 256 texels


def is_level(p: Perspective, width: int, setting: str, off: int) -> bool:
    """Returns true if lines are drawn as if depth did not change along them, off by ``off`` at most."""
    return width <= way(setting).width and keeps_level(p, width, off)


def keeps_level(p: Perspective, width: int, tolerance: int) -> bool:
    """Returns true if level lines are off by at most the tolerance, in 1/65536 texel."""
    grows = abs(p.q.dx)
    high, part = p.q.dx >> 32, grows & M32
    if high not in (0, -1) or part >> 16 == 0xFFFF:
        return False
    if not part:
        return not high
    off = (((p.farthest >> 16) + 1) * width * ((part >> 16) + 1) >> 16) + 1
    return off <= (p.least >> 16) * tolerance + ((p.least & 0xFFFF) * tolerance >> 16)


def is_even(p: Perspective, width: int, setting: str) -> bool:
    """Returns true if lines with straight pieces are off by a half or a quarter of a texel at most without a tilt."""
    steep = steepness(p.q.dx) + 1
    if steep > p.least >> layout.load().constants["PERSPECTIVE_EVEN_STEEP"]:
        return False
    return steep <= (p.least >> way(setting).even) // (((p.farthest >> 16) + 1) * width)


def tilt_of(p: Perspective, width: int, least: int) -> int | None:
    """Returns q's growth a pixel, 24.8, if a line on which q is ``least`` or more may be straight from its
    first pixel to its last; else None."""
    steep = steepness(p.q.dx) + 1
    if steep >= STEEP_2_22 or steep > least // ((width * width >> 1) + 1):
        return None
    return signed(p.q.dx, 64) >> 24


def columns_are_cheaper(setting: str, shape: str, count: int, width: int, height: int) -> bool:
    """Returns true if columns of a shape, "level" or "straight", cost fewer cycles than lines; ``count``: of vertices,
    by which more or less of the box is filled."""
    cost = layout.load().constants
    column = cost["PERSPECTIVE_COLUMN_TILTED" if shape == "straight" else "PERSPECTIVE_COLUMN"]
    column -= (way(setting).saved * height * (2 if count == 3 else 3) >> 2)
    return cost["PERSPECTIVE_TURN"] + width * column < cost["PERSPECTIVE_LINE"] * height


def is_chained(p: Perspective, width: int, setting: str) -> bool:
    """Returns true if u and v of level lines are stepped by a chain: unless the picture is the affine one."""
    return bool(p.q.dx or p.q.dy) and width <= way(setting).chain


def level_steps(gradient: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Returns gradient / q rounded up; 0 if it does not fit 32 bits, being divided as one less if it is above 0."""
    up = gradient > 0
    found = cut_quotients(gradient - up, q)
    return np.where(found == signed(found), found + up, 0)


def bends(p: Perspective, lines, width: int) -> bool:
    """Returns true if a straight line would be too far off in one of the ``lines``, from row p.j on, of a box as
    wide as ``width``."""
    steep = steepness(p.q.dx) + 1
    q = (p.q.at >> 32) - (width * steep if p.tilt < 0 else 0)
    return any(line.right > line.left and steep * n * n >> 1 > q + k * (p.q.dy >> 32)
               for k, (line, n) in enumerate((line, line.right - 1 - line.left) for line in lines))


def regained(c: np.ndarray, high: int, n: np.ndarray) -> np.ndarray:
    """Returns what is added to steps so that n of them make up for what the range takes from the first pixel's
    value c, and a part of a unit more; 0 if that is nothing, or if c does not fit 32 bits."""
    return np.where((n > 0) & (high < c) & (c < 1 << 31), (c - high) // np.maximum(n, 1) + 1, 0)


def level_line(p: Perspective, left: int, right: int, y: int) -> list[tuple[int, int]]:
    """Returns u of a level line's first pixel and its step, 16.16, and v's; right is excluded."""
    (u, v), (du, dv) = (each.tolist()[0] for each in level_lines(p, *(np.array([n]) for n in (left, right, y))))
    return [(u, du), (v, dv)]


def level_lines(p: Perspective, left: np.ndarray, right: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of level lines' first pixels, and their steps, 16.16; right is excluded. From a
    first pixel that is held below the range's end, lines lead to the last one's value all the same. In a chain u goes a
    unit up where v goes down, with or without that."""
    if p.inverse:
        made = np.array([level_reciprocal.line(p, *at) for at in zip(left.tolist(), y.tolist())])
        return made[:, :, 0], made[:, :, 1]
    n = right - 1 - left
    more = [regained(c, high, n) for c, high in zip(p.quotients(left, y)[1], p.high)]
    q, starts = p.divided(left, y)
    if p.tilt:
        q = np.maximum(q + (n * p.tilt >> 8), p.least)
    # what is over 2^63 is far from fitting, with any sign
    du, dv = (level_steps(signed(plane.dx, 64) - ((start - base) * p.tilt >> 8), q)
              for start, base, plane in zip(starts, p.base, (p.s, p.t)))
    du += p.chained & (dv | dv + more[1]) >> 23 & 1
    return np.stack(starts, 1), np.stack([signed(step + n) for step, n in zip((du, dv), more)], 1)


def level(p: Perspective, lines: list[Line], ys: list[int]) -> list[np.ndarray]:
    """Returns u and v of the pixels of level lines, one after the other, 16.16 modulo 2^32."""
    counts = [line.right - line.left for line in lines]
    k = counted(counts)
    ends = np.array([(line.left, line.right) for line in lines]).T
    (u, v), (du, dv) = (np.repeat(each, counts, axis=0).T for each in level_lines(p, *ends, np.array(ys)))
    return [u + k * du + (wraps(v, dv, k) if p.chained else 0) & M32, v + k * dv & M32]


def wraps(v: np.ndarray, dv: np.ndarray, k: np.ndarray) -> np.ndarray:
    """Returns the units that the chain's u has gone up after k steps: one for each time that v has wrapped at
    256, or less if it has done so downwards. v, dv: 16.16."""
    return (v & MAP) + k * signed(dv & MAP, 24) >> 24
