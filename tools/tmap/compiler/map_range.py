"""s and t of a scene's corners: the part of a map that they show, and their limits."""

from typing import NamedTuple

import numpy as np

from tmap.base.fields import fail
from tmap.base.fixed import ONE
from tmap.build import layout
from tmap.compiler import glide, glide_build, materials, n64_build
from tmap.n64.state import REACH

MAP_CENTRE = 128.0  # s at the map's centre along the longer side
MOST = REACH - 1 / 32  # texels: the greatest s or t of an engine, s10.5
#: Texels by which s and t may exceed a map that does not repeat: less than half a unit of 16.16, so
#: that rounding removes it.
SLACK = 1e-6


class Map(NamedTuple):
    """A map's sides in texels, and s and t at its far ends."""

    size: tuple[int, int]
    extent: tuple[float, float]


def extent_of(size: tuple[int, int]) -> tuple[float, float]:
    """Returns s and t at the far ends of a map: 256 for the longer side."""
    return tuple(2 * MAP_CENTRE * side / max(size) for side in size)


def map_of(material: dict, texture: dict | None) -> Map:
    """Returns the map of a checked material; one of 256 x 256 texels if it has no map. Maps of
    texture units must be built first. s and t of an N64 engine are texels."""
    mapper = materials.mapper_of(material)
    size = (texture["width"], texture["height"]) if texture else (256, 256)
    if mapper == "glide":
        size = glide_build.size_of(material)
    return Map(size, n64_build.size_of(material) if mapper == "n64" else extent_of(size))


def inside_map(corners: np.ndarray, texture: dict) -> np.ndarray:
    """Clamps rows of s and t, 16.16, to a map that does not repeat, in case rounding left it."""
    size = np.array([texture["width"], texture["height"]])
    last = (((size << 16) + 1) * 256 - 1) // max(size)  # the last value whose texel is inside
    return corners.clip(0, np.minimum(last, 256 * ONE))


def check_engine(corners: list[list[float]], where: str) -> None:
    """Refuses corners of one polygon whose s, t a texture engine cannot draw."""
    for noun, column in (("s", 2), ("t", 3)):
        values = [corner[column] for corner in corners]
        if not -REACH <= min(values) <= max(values) <= MOST:
            fail(where, f"{noun} must be from -{REACH} to {MOST} texels")
        if max(values) - min(values) >= REACH:
            fail(where, f"{noun} of two corners: {REACH} texels apart or more")


def check_map(corners: list[list[float]], mapper: str, shown: Map, where: str) -> None:
    """Refuses s, t too far away for the set-up, or outside a map that does not repeat."""
    reach = layout.load().constants["POLYGON_FAR"]
    for corner in corners:
        if max(map(abs, corner[2:4])) * max(shown.size) / (2 * MAP_CENTRE) >= reach:
            fail(where, f"s or t is {reach} texels or more from the map's corner")
        is_inside = all(-SLACK < value < end + SLACK
                        for value, end in zip(corner[2:4], shown.extent))
        if mapper == "arbitrary" and not is_inside:
            fail(where, 'mapper "arbitrary" does not repeat: s must be from 0 to '
                        f"{shown.extent[0]:g}, t from 0 to {shown.extent[1]:g}")


def check_corners(corners: list[list[float]], mapper: str, shown: Map, where: str) -> None:
    """Refuses corners of one polygon, (x, y, s, t, ...), whose s, t the mapper cannot draw."""
    if mapper == "n64":
        check_engine(corners, where)
    elif mapper == "glide":
        glide.check_range([corner[2:4] for corner in corners], where)
    else:
        check_map(corners, mapper, shown, where)
