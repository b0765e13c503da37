"""Errors of Glide's modes against their ideal (tmap.ideal.glide).

The texels are those in texture memory, so loss from a texel format is not an error of a mode.
Levels of detail are the true ones: they include the change of w within a pixel, which the unit
leaves out.
"""

from functools import cache
from math import prod
from typing import NamedTuple

import numpy as np

from tmap.bench.modes.glide import Mode
from tmap.bench.modes.measure import FIRST, HEIGHT, WIDTH, scene_of
from tmap.glide.state import Unit
from tmap.ideal import glide
from tmap.ideal.glide import Corner, Surface
from tmap.ideal.texels import Error, error
from tmap.model import model
from tmap.scene_file.pipes import units_of
from tmap.setup.unit_planes import spans

ONE = 1 << 16 + glide.TO_WHOLE  # 1 as a 1/w, if s/w is s in 16.16 divided by w


class Pixels(NamedTuple):
    """A mode's polygon on a kind of picture: its units, a surface for each, and its pixels."""

    units: list[Unit]
    surfaces: list[Surface]
    x: np.ndarray
    y: np.ndarray

    def level(self, number: int) -> np.ndarray:
        """The true level of detail of a unit's pixels, with its bias and within its limits."""
        true = self.surfaces[number].level(self.x, self.y)
        return glide.limited(self.units[number].modes, true)


def surface(corners: list[tuple[int, ...]], perspective: bool) -> Surface:
    """The exact surface of corners (x, y, s, t, any, w), multiplied by the product of all w."""
    depths = [corner[5] if perspective else 1 for corner in corners]
    shares = [prod(depths) // depth for depth in depths]
    return Surface([Corner(x, y, s * share, t * share, ONE * share)
                    for (x, y, s, t, *_), share in zip(corners, shares)], True)


def pixels_of(mode: Mode, kind: str) -> Pixels:
    """Returns the pixels of a mode's polygon; ``kind``: of modes.KINDS."""
    scene = scene_of(mode, kind)
    units, corners = units_of(scene, 0), mode.vertices
    screen = [corner[:4] for corner in corners[:mode.corners]]
    made = model.set_up(screen, WIDTH, HEIGHT, False, model.Settings(scene.materials[0].edges))
    surfaces = [surface(corners[first:first + mode.corners], mode.table.get("perspective", False))
                for first in range(0, len(corners), mode.corners)]
    at = spans(made)
    return Pixels(units, [surfaces[min(n, len(surfaces) - 1)] for n in range(len(units))],
                  at.x, at.y)


def intended(on: Pixels, how: str) -> np.ndarray:
    """Returns the ideal colours [n, 4], 0..255; ``how``: of ideal.FILTERS. The ideal of two units
    that filter trilinearly is one unit with all levels."""
    if how == "trilinear" and len(on.units) > 1:
        return glide.sample(on.units[0], *on.surfaces[0].at(on.x, on.y), on.level(0), how,
                            on.units[1])
    colours = np.zeros((on.x.size, 4))
    for number in reversed(range(len(on.units))):
        unit, level = on.units[number], on.level(number)
        texels = glide.sample(unit, *on.surfaces[number].at(on.x, on.y), level, how)
        colours = glide.combined(unit.modes, level, texels, colours)
    return colours


def colours_of(mode: Mode, kind: str) -> tuple[np.ndarray, np.ndarray]:
    """Returns the colours [n, 4] of a mode's pixels: as drawn, and ideal."""
    on, scene = pixels_of(mode, kind), scene_of(mode, kind)
    return scene.pixel.picture(model.render(scene, FIRST))[on.y, on.x], intended(on, mode.filter)


@cache
def error_of(mode: Mode, kind: str) -> Error:
    """Returns a mode's error on a kind of picture, over R, G and B as the frame stores them."""
    return error(*colours_of(mode, kind))
