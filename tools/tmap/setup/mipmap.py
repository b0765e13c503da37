"""The integer model's choice of a mip map's level: c/mipmap/polygon.c."""

from tmap.base.fixed import signed


def area_of(first, a, b) -> tuple[int, int]:
    """Returns twice the area of a triangle: a number, and the log4 of its unit to that of 1/65536 by 1/65536."""
    ways = [signed(c - o) for corner in (a, b) for c, o in zip(corner, first)]
    scale = -(-max(max(way ^ way >> 31 for way in ways).bit_length() - 15, 0) // 4) * 4
    ax, ay, bx, by = (way >> scale for way in ways)
    return abs(ax * by - bx * ay), scale


def level_of(vertices, longer: int, levels: int) -> int:
    """Returns the level that draws a polygon of vertices (x, y, s, t, ...), not yet adapted: the first whose texels are
    at most twice as many as its pixels, or the last. ``longer``: the longer side of the map, a power of two;
    ``levels``: their number beyond the map."""
    n = len(vertices)
    corners = [vertices[k] for k in ((0, n // 3, 2 * n // 3) if n > 4 else (0, 1, 2))]
    pixels, pixel_scale = area_of(*(v[:2] for v in corners))
    texels, texel_scale = area_of(*(v[2:4] for v in corners))
    up = texel_scale - pixel_scale + longer.bit_length() - 9
    for level in range(levels):
        more = 2 * (up - level)
        if texels << max(more, 0) <= 2 * pixels << max(-more, 0):
            return level
    return levels
