"""s and t of a scene's corners: how far they may go, and as the file has them."""

import numpy as np

from . import layout
from .fields import fail
from .fixed import ONE
from .scene_tx import REACH

MAP_CENTRE = 128.0  # of s along the longer side


def extent_of(size: tuple[int, int]) -> tuple[float, float]:
    """s and t at the far ends of a map: 256 for the longer side."""
    return tuple(2 * MAP_CENTRE * side / max(size) for side in size)


def inside(made: np.ndarray, texture: dict) -> np.ndarray:
    """Rows of s and t, 16.16, that rounding shall not lead out of a map that is not repeated."""
    size = np.array([texture["width"], texture["height"]])
    last = (((size << 16) + 1) * 256 - 1) // max(size)  # its texel is not beyond the side
    return made.clip(0, np.minimum(last, 256 * ONE))


def check_engine(corners: list[list[float]], where: str) -> None:
    """Refuses corners of one polygon whose s, t a texture engine cannot draw."""
    for noun, column in (("s", 2), ("t", 3)):
        values = [corner[column] for corner in corners]
        if not -REACH <= min(values) <= max(values) <= REACH - 1 / 32:
            fail(where, f"{noun} must be from -{REACH} to {REACH - 1 / 32:g} texels")
        if max(values) - min(values) >= REACH:
            fail(where, f"{noun} of two corners: {REACH} texels apart or more")


def check_map(corners: list[list[float]], mapper: str, size: tuple[int, int],
              extent: tuple[float, float], where: str) -> None:
    """Refuses s, t too far away for the set-up, or outside a map that is not repeated."""
    reach = layout.load().constants["POLYGON_FAR"]
    for corner in corners:
        if max(map(abs, corner[2:4])) * max(size) / (2 * MAP_CENTRE) >= reach:
            fail(where, f"s or t is {reach} texels or more from the map's corner")
        inside = all(-1e-6 < value < end + 1e-6 for value, end in zip(corner[2:4], extent))
        if mapper == "arbitrary" and not inside:
            fail(where, 'mapper "arbitrary" does not repeat: s must be from 0 to '
                        f"{extent[0]:g}, t from 0 to {extent[1]:g}")
