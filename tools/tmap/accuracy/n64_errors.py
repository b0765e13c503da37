"""Errors of the N64's modes against their ideal (tmap.ideal.n64).

The texels are those in TMEM, so loss from a texel format is not an error of a mode.
"""

from dataclasses import replace
from functools import cache
from typing import NamedTuple

import numpy as np

from tmap.bench.modes.measure import FIRST, HEIGHT, WIDTH, scene_of
from tmap.bench.modes.n64 import Mode
from tmap.ideal import n64
from tmap.ideal.texels import Error, error
from tmap.model import model
from tmap.n64.pixels import picture
from tmap.n64.polygon import SETTINGS, Vertex, prepare
from tmap.n64.state import State
from tmap.scene_file.units import state_at


class Pixels(NamedTuple):
    """A mode's polygon on a kind of picture: its engine, vertices and pixels."""

    state: State
    vertices: list[Vertex]
    surface: n64.Surface
    x: np.ndarray
    y: np.ndarray


def pixels_of(mode: Mode, kind: str) -> Pixels:
    """Returns the pixels of a mode's polygon; ``kind``: of modes.KINDS."""
    scene = scene_of(mode, kind)
    state = state_at(scene, 0, FIRST)
    vertices = [Vertex(x, y, s, t, w, shade=shade) for x, y, s, t, shade, w in mode.vertices]
    settings = replace(SETTINGS, edges=scene.materials[0].edges)
    at = prepare(state, np.zeros((HEIGHT, WIDTH), np.uint32), vertices, settings).at
    return Pixels(state, vertices, n64.Surface(vertices, bool(state.modes.perspective)), at.x, at.y)


def shades(on: Pixels) -> np.ndarray:
    """Returns the exact opaque greys at the pixels, float64 [n, 4]."""
    flat = [v._replace(s=v.shade, t=0) for v in on.vertices]
    grey = n64.Surface(flat, False).at(on.x, on.y)[0].value
    return np.stack([grey, grey, grey, np.full_like(grey, 255)], -1)


def colours_of(mode: Mode, kind: str) -> tuple[np.ndarray, np.ndarray]:
    """Returns the colours [n, 4] of a mode's pixels: as drawn, and ideal."""
    on = pixels_of(mode, kind)
    drawn = picture(model.render(scene_of(mode, kind), FIRST))[on.y, on.x]
    found = n64.texels(on.state, on.surface, on.x, on.y, mode.filter)
    return drawn, n64.combined(on.state, found, shades(on))


@cache
def error_of(mode: Mode, kind: str) -> Error:
    """Returns a mode's error on a kind of picture, over R, G and B as the frame stores them."""
    return error(*colours_of(mode, kind))
