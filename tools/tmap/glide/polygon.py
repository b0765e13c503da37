"""Draws polygons bit for bit like the texture units.

The iterated values are planes over the screen (tmap.setup.unit_planes): S = 4 s is 14.18 if w is
not used, W of the nearest corner is 2^30. A unit with its own corners has its own planes; the
others share the vertices'. A polygon's level of detail comes from the planes' steps. A unit with a
subdivision divides at the ends of pieces of a line, which begin with its first pixel in the frame.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import ONE, signed
from tmap.glide.chain import Point, chain_pixel
from tmap.glide.dithered import lines
from tmap.glide.lod import base
from tmap.glide.state import ONE_W, REACH, W_MAX, Unit
from tmap.glide.texels import five, six
from tmap.setup.polygon import Polygon
from tmap.setup.texturing import Settings
from tmap.setup.unit_planes import Scale, Spans, is_narrow, set_up_coordinates

SCALE = Scale(2, ONE_W, REACH << 16)


class Vertex(NamedTuple):
    """``x``, ``y``: pixels; ``s``, ``t``: 0 to 256 along a map's longer side; ``w``: depth, not 0;
    all 16.16. ``own``: s, t and w of the second unit if it has its own."""

    x: int
    y: int
    s: int = 0
    t: int = 0
    w: int = ONE
    own: tuple[int, int, int] | None = None


def check(corners: list[tuple[int, int, int]], perspective: bool) -> None:
    """Refuses coordinates (s, t, w) that units do not draw."""
    if not all(abs(c) < REACH << 16 for s, t, _ in corners for c in (s, t)):
        raise UserError(f"polygon: s or t is {REACH:,} or more away from 0")
    if not is_narrow(corners, SCALE):
        raise UserError(f"polygon: s or t of two vertices are {REACH:,} or more apart")
    if perspective and not all(0 < abs(w) <= W_MAX << 16 for *_, w in corners):
        raise UserError(f"polygon: a vertex's w is 0 or above {W_MAX:,}")


def sides(at: Spans) -> tuple[np.ndarray, np.ndarray]:
    """Returns how many pixels of its line are before and behind each pixel."""
    _, first, line, count = np.unique(at.y, return_index=True, return_inverse=True,
                                      return_counts=True)
    before = np.arange(at.y.size) - first[line]
    return before, count[line] - 1 - before


def points(screen: list[tuple[int, int]], corners: list[tuple[int, int, int]], perspective: bool,
           frame: np.ndarray, settings: Settings) -> tuple[Spans, Point] | None:
    """Returns a polygon's pixels and their iterated values; None if there are no pixels.
    ``screen``: x, y of the corners, ``corners``: their s, t, w, all 16.16."""
    check(corners, perspective)
    found = set_up_coordinates(screen, corners, perspective, frame, settings, SCALE)
    if found is None:
        return None
    at, st, w = found
    steps = [signed(c) for c in (*st.ddx, *st.ddy)]
    is_one = not w.ddx[0] and not w.ddy[0] and bool((w.values[0] == ONE_W).all())
    return at, Point(*(signed(c) for c in (*st.values, w.values[0])), base(*steps), at.x, at.y,
                     *((0, 0) if is_one else sides(at)))  # w of 1.0 divides nothing


def stored(frame: np.ndarray, colours: np.ndarray) -> np.ndarray:
    """Converts colours [n, 4] to pixels: R, G, B of 5, 6, 5 bits, or R, G, B, A of 8."""
    r, g, b, a = (colours[:, k] for k in range(4))
    if frame.dtype == np.uint16:
        return r >> 3 << 11 | g >> 2 << 5 | b >> 3
    return r << 24 | g << 16 | b << 8 | a


def widened(pixels: np.ndarray) -> np.ndarray:
    """Converts pixels to colours [n, 4] of 8 bits per channel; 16-bit pixels like texels, with
    alpha 0."""
    value = pixels.astype(np.int64)
    if pixels.dtype != np.uint16:
        return np.stack([value >> shift & 255 for shift in (24, 16, 8, 0)], -1)
    return np.stack([five(value >> 11), six(value >> 5), five(value), 0 * value], -1)


def blended(pixels: np.ndarray, colours: np.ndarray, adds: bool) -> np.ndarray:
    """Returns the frame's new pixels; ``adds``: colours are added to the old ones, up to 255 in
    each channel."""
    return stored(pixels, np.minimum(widened(pixels) + colours, 255) if adds else colours)


def draw_lines(frame: np.ndarray, polygon: Polygon | None, colours: list) -> int:
    """Draws the colours of a polygon's lines; returns the number of pixels."""
    if polygon is None:
        return 0
    for y, (line, some) in enumerate(zip(polygon.lines, colours), polygon.top):
        if line.right > line.left:
            frame[y, line.left:line.right] = stored(frame, some)
    return polygon.pixels


def draw(units: Sequence[Unit], frame: np.ndarray, vertices: Sequence[Vertex],
         settings: Settings, adds: bool = False) -> int:
    """Draws a convex polygon of 3 to 64 vertices into ``frame``, uint16 (565) or uint32 (8888)
    [height, width], by one or two units, the first nearest the frame; returns the number of its
    pixels. The second unit uses its own corners if the vertices have them. ``adds``: colours are
    added to the frame's."""
    if len(vertices) < 3:
        return 0
    screen = [(v.x, v.y) for v in vertices]
    has_own = len(units) > 1 and vertices[0].own is not None
    shared = units[:1] if has_own else units
    check([(v.s, v.t, v.w) for v in vertices], any(unit.modes.perspective for unit in shared))
    dithered = None if adds else lines(units, frame, vertices, settings)
    if dithered:
        return draw_lines(frame, *dithered)
    found = [points(screen, [(v.s, v.t, v.w) for v in vertices],
                    any(unit.modes.perspective for unit in shared), frame, settings)]
    if has_own:
        found.append(points(screen, [v.own for v in vertices],
                            bool(units[1].modes.perspective), frame, settings))
    if any(f is None for f in found) or not found[0][0].x.size:
        return 0
    at = found[0][0]
    colours = chain_pixel(units, [found[min(n, len(found) - 1)][1] for n in range(len(units))])
    frame[at] = blended(frame[at], np.broadcast_to(colours, (at.x.size, 4)), adds)
    return at.x.size
