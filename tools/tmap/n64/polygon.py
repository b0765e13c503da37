"""Draws polygons and rectangles bit for bit like the texture unit.

A polygon's iterators are planes over the screen, computed in pairs (tmap.setup.unit_planes):
(S, T), (W, 0) and, if the combiner reads shade, (R, G) and (B, A). Every rounding:

- s, t and w as in tmap.setup.unit_planes: S = 32 s is s15.16 of s10.5, exact, and W is
  0x7fff0000 if w is not used;
- a colour 0..255 is the whole part of 16.16, exact;
- the iterators' upper 16 bits are s, t and w;
- shade is the whole part of the iterator, clamped to 0..255.
"""

from typing import NamedTuple

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import M32, ONE, signed
from tmap.n64.combiner import uses_shade
from tmap.n64.copy import check as check_copy, copy
from tmap.n64.lod import Gradients
from tmap.n64.misuse import Misuse
from tmap.n64.pixels import pixels, store
from tmap.n64.state import COPY, REACH, State
from tmap.setup.texturing import Settings
from tmap.setup.unit_planes import Scale, Spans, is_narrow, set_up_coordinates, set_up_pair

SETTINGS = Settings(edges="exact", gradients="plane", start="subtexel", mapper="none")
SCALE = Scale(5, 0x7FFF0000, REACH << 16)


class Vertex(NamedTuple):
    """``x``, ``y``: pixels; ``s``, ``t``: texels; ``w``: depth, above 0; all 16.16.
    ``colour``: R, G, B, A, 0..255; ``shade``: an opaque grey instead, 16.16."""

    x: int
    y: int
    s: int = 0
    t: int = 0
    w: int = ONE
    colour: tuple[int, int, int, int] = (255, 255, 255, 255)
    shade: int | None = None

    @property
    def channels(self) -> tuple[int, int, int, int]:
        """The colour in 16.16."""
        if self.shade is not None:
            return self.shade, self.shade, self.shade, 255 << 16
        return tuple(c << 16 for c in self.colour)


def whole(iterator: np.ndarray) -> np.ndarray:
    """Clamps the whole part of a colour's iterator to 0..255."""
    return np.clip(signed(iterator) >> 16, 0, 255)


class Prepared(NamedTuple):
    """A polygon's pixels and the inputs for their pipeline (tmap.n64.pixels)."""

    at: Spans
    s: np.ndarray
    t: np.ndarray
    w: np.ndarray
    gradients: Gradients
    shade: np.ndarray | None


def prepare(state: State, frame: np.ndarray, vertices: list[Vertex],
            settings: Settings = SETTINGS) -> Prepared | None:
    """Sets a convex polygon up; returns None if nothing is drawn."""
    corners = [(v.s, v.t, v.w) for v in vertices]
    if not is_narrow(corners, SCALE):
        return None
    perspective = bool(state.modes.perspective)
    nearest = min(v.w for v in vertices)
    if perspective and nearest <= 0:
        raise UserError(f"polygon: a vertex's w is {nearest}; it must be above 0")
    points = [(v.x, v.y) for v in vertices]
    found = set_up_coordinates(points, corners, perspective, frame, settings, SCALE)
    shades = [set_up_pair(points, [v.channels[k:k + 2] for v in vertices], frame, settings)
              for k in (0, 2) if uses_shade(state)]
    if found is None or None in shades:
        return None
    at, st, w = found
    gradients = Gradients(*st.ddx, w.ddx[0], *st.ddy, w.ddy[0])
    shade = np.stack([whole(value) for _, pair in shades for value in pair.values], -1) if shades else None
    return Prepared(at, *st.values, w.values[0], gradients, shade)


def draw(state: State, frame: np.ndarray, vertices: list[Vertex],
         settings: Settings = SETTINGS) -> int:
    """Draws a convex polygon of 3 to 64 vertices into ``frame``, uint16 (5551) or uint32
    (8888) [height, width]; returns the number of its pixels.

    Its tile and highest level come from the state; edges and clip from the settings.
    """
    prepared = prepare(state, frame, vertices, settings) if len(vertices) > 2 else None
    if prepared is None or not prepared.at.x.size:
        return 0
    colours = pixels(state, *prepared[1:])
    store(frame, *prepared.at, colours)
    state.draws()
    return prepared.at.x.size


def rectangle(state: State, frame: np.ndarray, box: tuple[int, int, int, int], tile: int, s: int,
              t: int, dsdx: int, dtdy: int, flip: bool = False) -> None:
    """Draws a texture rectangle, cut to the frame.

    ``box``: left, top, right, bottom, whole pixels, the last two excluded (in copy mode too).
    ``s``, ``t``: s10.5 at the upper left pixel; ``dsdx``, ``dtdy``: s5.10 per pixel, in copy mode
    ``dsdx`` per four pixels. ``flip``: s runs down and t runs right.
    """
    left, top, right, bottom = box
    height, width = frame.shape
    y, x = (c.reshape(-1) for c in np.meshgrid(np.arange(max(top, 0), min(bottom, height)),
                                               np.arange(max(left, 0), min(right, width)),
                                               indexing="ij"))
    if not x.size:
        return
    state.forbids(state.modes.perspective != 0, "rectangle perspective",
                  "a texture rectangle has no w: perspective must be off")
    across, down = x - left, y - top
    steps = dsdx << 11, dtdy << 11  # to s15.16 of s10.5
    if state.modes.cycle == COPY:
        coordinates = ((s << 16) + (across >> 2) * steps[0] >> 16,
                       (t << 16) + down * steps[1] >> 16)
        copy_rectangle(state, frame, (y, x), tile, coordinates, across & 3, flip)
        return
    gradients = Gradients(dsdx=steps[0], dtdy=steps[1])
    if flip:
        across, down = down, across
        gradients = Gradients(dsdy=steps[0], dtdx=steps[1])
    old = state.primitive_tile, state.max_level
    state.primitive_tile, state.max_level = tile, 0  # its command has no level
    try:
        shade = None if state.checked else np.zeros((x.size, 4), np.int64)
        colours = pixels(state, (s << 16) + across * steps[0] & M32,
                         (t << 16) + down * steps[1] & M32, np.zeros_like(x), gradients, shade)
    finally:
        state.primitive_tile, state.max_level = old
    store(frame, y, x, colours)
    state.draws()


def copy_rectangle(state: State, frame: np.ndarray, at, tile: int, coordinates,
                   which: np.ndarray, flip: bool) -> None:
    """Copies texels to pixels; ``coordinates``: those of each pixel's group of four, s10.5;
    ``which``: the pixel's index in its group."""
    y, x = at
    if flip or frame.dtype != np.uint16:
        raise Misuse("copy mode", "copy mode draws texture rectangles into frames of 16 bits, "
                                  "and does not flip them")
    check_copy(state, tile)
    texels = copy(state, tile, *coordinates)
    frame[y, x] = texels[np.arange(x.size), which]
    state.draws()
