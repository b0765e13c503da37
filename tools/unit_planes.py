"""Planes over the screen that texture units iterate, a pair at a time.

A pair is set up as the renderer's polygons are (tools.model_polygon: plane gradients, sub-texel
starts, exact edges or subpixel ones). Every rounding:

- without perspective, or where all w are the same and above 0, planes of s and t are found in
  16.16, S and T are those times a power of two; W is ``one`` everywhere;
- else W = one * least |w| / w at each corner, half of that if the w of any is below 0, and
  S = s * the power of two * W / one, T alike, each to the nearest, halves up;
- each of a pair is moved by its base, floor((least + most) / 2), before set-up and back after;
- the plane's value at the box's middle, its steps and the lines' starts are rounded by set-up:
  gradients cut to 32.32, values and steps to the nearest 16.16 (tools.model_texturing.plane);
- iterators then step without rounding, modulo 2^32.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from .errors import UserError
from .fixed import M32, mul_div
from .model_polygon import Polygon, set_up
from .model_texturing import Settings


class Scale(NamedTuple):
    """How s, t and w become iterators. ``bits``: S is s times 2^bits; ``one``: W of the corner
    that is nearest; ``reach``: s and t of two corners are less than this apart, 16.16."""

    bits: int
    one: int
    reach: int


class Pair(NamedTuple):
    """Two planes: values at pixels, int64 [n], modulo 2^32, and steps (x and y) of each."""

    values: tuple[np.ndarray, np.ndarray]
    ddx: tuple[int, int]
    ddy: tuple[int, int]


class Spans(NamedTuple):
    """A polygon's pixels, line by line, int64 [n]."""

    y: np.ndarray
    x: np.ndarray


def spans(polygon: Polygon) -> Spans:
    """The pixels of a set-up polygon."""
    counts = [max(0, line.right - line.left) for line in polygon.lines]
    y = np.repeat(np.arange(polygon.top, polygon.top + len(counts)), counts)
    runs = [np.arange(line.left, max(line.left, line.right)) for line in polygon.lines]
    return Spans(y, np.concatenate(runs) if runs else np.zeros(0, np.int64))


def set_up_pair(points: Sequence[tuple[int, int]], pair: Sequence[tuple[int, int]],
                frame: np.ndarray, settings: Settings, one: int | None = None) -> tuple[Spans, Pair] | None:
    """The pixels and the pair's planes; None where nothing is drawn: no pixel, or values that
    differ by 2^31 or more. ``points``: x, y of the corners, 16.16; ``pair``: their values. Where all
    are (``one``, 0), W is that everywhere: no plane is found for it."""
    height, width = frame.shape
    bases = [min(c) + max(c) >> 1 for c in zip(*pair)]
    moved = [(*point, *(value - base for value, base in zip(values, bases)))
             for point, values in zip(points, pair)]
    polygon = set_up(moved, width, height, True, settings)
    if polygon is None:
        return None
    at, t = spans(polygon), polygon.texturing
    if one is not None and set(pair) == {(one, 0)}:
        return at, Pair(tuple(np.full(len(at.x), c, np.int64) for c in (one, 0)), (0, 0), (0, 0))
    counts = [max(0, line.right - line.left) for line in polygon.lines]
    offsets = at.x - np.repeat([line.left for line in polygon.lines], counts)
    values = []
    for name, base in zip("uv", bases):
        starts = np.array([getattr(line, name) for line in polygon.lines], np.int64)
        step = getattr(t, f"d{name}dx")
        values.append(np.repeat(starts, counts) + offsets * step + (base & M32) & M32)
    return at, Pair(tuple(values), (t.dudx, t.dvdx), (t.dudy, t.dvdy))


def iterators(corners: Sequence[tuple[int, int, int]], perspective: bool, scale: Scale):
    """What planes are found of, and by how many bits they are shifted then: S and T of corners
    (s, t, w), and W."""
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


def enlarged(pair: Pair, bits: int) -> Pair:
    """Planes times 2^bits."""
    return Pair(tuple(value << bits & M32 for value in pair.values),
                tuple(step << bits & M32 for step in pair.ddx),
                tuple(step << bits & M32 for step in pair.ddy))


def is_narrow(corners: Sequence[tuple[int, int, int]], scale: Scale) -> bool:
    """Whether s and t stay within what a polygon may show."""
    return all(max(c) - min(c) < scale.reach for c in list(zip(*corners))[:2])
