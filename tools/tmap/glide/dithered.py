"""Polygons that are drawn with moved points instead of the bilinear filter. They are drawn by one
unit with this mode, from one level, without division, away from clamped texels. s and t become
texels of the level, rounded down, on planes stepped like those of the plain mappers."""

from dataclasses import replace

import numpy as np

from tmap.glide.combine import combined
from tmap.glide.filters import filters_linearly
from tmap.glide.lod import ONE_8_8, QUARTER, chosen, within_limits
from tmap.glide.state import LAST_LEVEL, Modes, Unit
from tmap.glide.texels import fetch, level_size
from tmap.setup.polygon import set_up
from tmap.setup.spans import coordinates
from tmap.setup.texturing import Line, Settings

MARGIN = 2 << 16  # texels to the place where they are clamped


def only_lod(modes: Modes) -> int | None:
    """Returns the level of detail of all pixels, 8.8, if the limits allow only one, else None."""
    least, most = modes.lod_min * QUARTER, min(modes.lod_max * QUARTER, LAST_LEVEL * ONE_8_8)
    return int(within_limits(modes, np.int64(least))) if least >= most else None


def corners_of(modes: Modes, vertices, level: int) -> list[tuple[int, int, int, int]] | None:
    """Returns x, y, and s and t in texels; None if some may be clamped."""
    corners = [(v.x, v.y, v.s >> level, v.t >> level) for v in vertices]
    for k, clamps, side in zip((2, 3), (modes.clamp_s, modes.clamp_t), level_size(modes, level)):
        if clamps and not all(MARGIN <= c[k] < (side << 16) - MARGIN for c in corners):
            return None
    return corners


def lines(units, frame: np.ndarray, vertices, settings: Settings):
    """Returns (polygon, colours of its pixels, [n, 4], line by line), or None if the filter is
    used; a polygon of None covers no pixel."""
    modes = units[0].modes
    lod = only_lod(modes)
    if len(units) > 1 or not modes.dithered or lod is None or not filters_linearly(modes, lod):
        return None
    if modes.perspective and not (vertices[0].w > 0 and len({v.w for v in vertices}) == 1):
        return None
    level = int(chosen(modes, np.int64(lod)))
    corners = corners_of(modes, vertices, level)
    if corners is None:
        return None
    height, width = frame.shape
    polygon = set_up(corners, width, height, True, replace(settings, mapper="dithered"),
                     level_size(modes, level), for_unit=True)
    if polygon is None:
        return None, []
    return polygon, [colours(units[0], level, lod, line, y)
                     for y, line in enumerate(polygon.lines, polygon.top)]


def colours(unit: Unit, level: int, lod: int, line: Line, y: int) -> np.ndarray:
    """Returns the colours of a line's pixels."""
    u, v = (c >> 16 for c in coordinates(line, "dithered", y))
    width, height = level_size(unit.modes, level)
    texels = fetch(unit, np.full(u.shape, level), u & width - 1, v & height - 1)
    return combined(unit.modes, np.full(u.shape, lod), texels, np.zeros(4, np.int64))
