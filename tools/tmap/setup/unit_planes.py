"""Planes over the screen that texture units iterate, in pairs.

A pair is set up like the renderer's polygons (tmap.setup.polygon: plane gradients, sub-texel
starts, exact edges or subpixel ones). Every rounding:

- without perspective, or if all w are the same and above 0, planes of s and t are computed in
  16.16; S and T are those times a power of two; W is ``one`` everywhere;
- else W = one * least |w| / w at each corner, half of that if any w is below 0, and
  S = s * the power of two * W / one, T in the same way, each to the nearest, halves up;
- each of a pair is moved by its base, floor((least + most) / 2), before set-up and back after;
- set-up rounds the plane's value at the box's middle, its steps and the lines' starts:
  gradients cut to 32.32, values and steps to the nearest 16.16, and raised so that none is below
  the exact one (tmap.setup.texturing.plane);
- divided S and T are raised to make up for a W that is too high (``divided_more``): where W is
  above 0, S / W and T / W are not below the exact ones either;
- iterators then step without rounding, modulo 2^32.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import M32, mul_div, signed
from tmap.setup.polygon import Polygon, set_up
from tmap.setup.texturing import Settings, Texturing


class Scale(NamedTuple):
    """How s, t and w become iterators. ``bits``: S is s times 2^bits; ``one``: W of the nearest
    corner; ``reach``: s and t of two corners differ by less than this, 16.16."""

    bits: int
    one: int
    reach: int


class Pair(NamedTuple):
    """Two planes: values at pixels, int64 [n], modulo 2^32, and steps (x and y) of each. ``above``:
    units by which the first may be above the exact one."""

    values: tuple[np.ndarray, np.ndarray]
    ddx: tuple[int, int]
    ddy: tuple[int, int]
    above: int


class Spans(NamedTuple):
    """A polygon's pixels, line by line, int64 [n]."""

    y: np.ndarray
    x: np.ndarray


def spans(polygon: Polygon) -> Spans:
    """Returns the pixels of a set-up polygon."""
    counts = [max(0, line.right - line.left) for line in polygon.lines]
    y = np.repeat(np.arange(polygon.top, polygon.top + len(counts)), counts)
    runs = [np.arange(line.left, max(line.left, line.right)) for line in polygon.lines]
    return Spans(y, np.concatenate(runs) if runs else np.zeros(0, np.int64))


def set_up_pair(points: Sequence[tuple[int, int]], pair: Sequence[tuple[int, int]],
                frame: np.ndarray, settings: Settings, one: int | None = None) -> tuple[Spans, Pair] | None:
    """Returns the pixels and the pair's planes; None if nothing is drawn: no pixel, or values that
    differ by 2^31 or more. ``points``: x, y of the corners, 16.16; ``pair``: their values. If all
    are (``one``, 0), W is ``one`` everywhere and needs no plane."""
    height, width = frame.shape
    bases = [min(c) + max(c) >> 1 for c in zip(*pair)]
    moved = [(*point, *(value - base for value, base in zip(values, bases)))
             for point, values in zip(points, pair)]
    polygon = set_up(moved, width, height, True, settings, for_unit=True)
    if polygon is None:
        return None
    at, t = spans(polygon), polygon.texturing
    if one is not None and set(pair) == {(one, 0)}:
        return at, Pair(tuple(np.full(len(at.x), c, np.int64) for c in (one, 0)), (0, 0), (0, 0), 0)
    counts = [max(0, line.right - line.left) for line in polygon.lines]
    offsets = at.x - np.repeat([line.left for line in polygon.lines], counts)
    values = []
    for name, base in zip("uv", bases):
        starts = np.array([getattr(line, name) for line in polygon.lines], np.int64)
        step = getattr(t, f"d{name}dx")
        values.append(np.repeat(starts, counts) + offsets * step + (base & M32) & M32)
    return at, Pair(tuple(values), (t.dudx, t.dvdx), (t.dudy, t.dvdy), above(min(points, key=upper), t))


def upper(point: tuple[int, int]) -> tuple[int, int]:
    """Sorts points by their lines: planes begin at the first one."""
    return point[1], point[0]


def above(top: tuple[int, int], t: Texturing) -> int:
    """Returns the units by which u of a plane may be above the exact one at any pixel of the box:
    twice its shortfall (``texturing.shortfall``), with steps off by half a unit and gradients by
    less than a texel more than the steps."""
    ways = t.i - t.box[0], t.j - t.box[1]
    way = sum(ways) + 2 + sum(abs(signed((at << 16) - c)) >> 16 for at, c in zip((t.i, t.j), top))
    steep = sum(abs(signed(step)) >> 16 for step in (t.dudx, t.dudy)) + 7
    return sum(ways) + 2 * (steep * 2 * way >> 16) + 6


def iterators(corners: Sequence[tuple[int, int, int]], perspective: bool, scale: Scale):
    """Returns the values for the planes, S and T of corners (s, t, w) and W, and by how many bits S
    and T are shifted after set-up."""
    least = min(abs(w) for _, _, w in corners)
    if perspective and not least:
        raise UserError("polygon: a vertex's w is 0")
    first = corners[0][2]
    if not perspective or first > 0 and all(w == first for _, _, w in corners):
        return [(s, t) for s, t, _ in corners], [(scale.one, 0)] * len(corners), scale.bits
    one = scale.one if all(w > 0 for _, _, w in corners) else scale.one >> 1
    ws = [mul_div(one, least, abs(w)) * (1 if w > 0 else -1) for _, _, w in corners]
    return [(mul_div(s << scale.bits, w, scale.one), mul_div(t << scale.bits, w, scale.one))
            for (s, t, _), w in zip(corners, ws)], [(w, 0) for w in ws], 0


def divided_more(corners: Sequence[tuple[int, int, int]], key: int, w: Pair, scale: Scale) -> int:
    """Returns the units by which S (``key`` 0) or T (1) of divided corners is raised: s times the
    excess of W, which includes 3 units for W's rounding at the corners, and 3 for S's rounding."""
    largest = max(abs(corner[key]) for corner in corners) << scale.bits
    return mul_div(min(largest, 0x7FFFFFFF), w.above + 3, scale.one) + 3


def set_up_coordinates(points: Sequence[tuple[int, int]], corners: Sequence[tuple[int, int, int]],
                       perspective: bool, frame: np.ndarray, settings: Settings,
                       scale: Scale) -> tuple[Spans, Pair, Pair] | None:
    """Returns the pixels, the planes of S and T, and those of W and 0; None if nothing is drawn."""
    texture, ws, bits = iterators(corners, perspective, scale)
    found = [set_up_pair(points, texture, frame, settings),
             set_up_pair(points, ws, frame, settings, scale.one)]
    if None in found:
        return None
    (at, st), (_, w) = found
    more = (0, 0) if bits else [divided_more(corners, key, w, scale) for key in (0, 1)]
    values = [(value << bits) + m & M32 for value, m in zip(st.values, more)]
    ddx, ddy = ([step << bits & M32 for step in steps] for steps in (st.ddx, st.ddy))
    return at, Pair(tuple(values), tuple(ddx), tuple(ddy), st.above << bits), w


def is_narrow(corners: Sequence[tuple[int, int, int]], scale: Scale) -> bool:
    """Returns true if s and t stay within the range that a polygon may show."""
    return all(max(c) - min(c) < scale.reach for c in list(zip(*corners))[:2])
