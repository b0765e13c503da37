"""The integer model of drawing by a scene's texture units."""

import numpy as np

from tmap.base.fixed import M32
from tmap.glide import polygon
from tmap.n64 import polygon as n64_polygon
from tmap.n64.combiner import uses_shade
from tmap.n64.state import COPY, State
from tmap.scene_file.pipes import has_own, units_of
from tmap.scene_file.units import RECTANGLES, check_range, rectangle_ends
from tmap.setup import planarity
from tmap.setup.polygon import FAR
from tmap.setup.texturing import Settings


def settings_of(material) -> Settings:
    """Returns the settings with which units' polygons are set up (tmap.setup.unit_planes)."""
    return Settings(edges=material.edges, clip=material.clip, mapper="none")


def draw_rectangle(state: State, frame: np.ndarray, vertices: list[tuple], flip: bool) -> None:
    """Draws a rectangle from a scene's two vertices."""
    (left, top, s, t, *_), (right, bottom, dsdx, dtdy, *_) = vertices
    box = left >> 16, top >> 16, right >> 16, bottom >> 16
    if not (box[0] < box[2] and box[1] < box[3] and all(-FAR <= side << 16 < FAR for side in box)):
        return
    check_range(rectangle_ends(box, (s, t), (dsdx, dtdy), state.modes.cycle == COPY, flip),
                "rectangle")
    n64_polygon.rectangle(state, frame, box, state.primitive_tile, s, t, dsdx, dtdy, flip)


def draw_by_engine(state: State, frame: np.ndarray, material, vertices: list[tuple],
                   vouched: int) -> None:
    """Draws an object, vertices (x, y, s, t, shade, w), by the N64's texture engine; ``vouched``:
    kinds of values that are planar without a test."""
    if material.primitive in RECTANGLES:
        draw_rectangle(state, frame, vertices, material.primitive == "flipped")
        return
    check_range(vertices, "polygon")
    if len(vertices) > 3:
        shades = planarity.COLOURS if material.primitive == "coloured" else planarity.SHADES
        asked = asked_by(state.modes.perspective) | shades * uses_shade(state)
        asked &= ~vouched
        if planarity.planar(vertices, asked) != asked:
            for part in planarity.fan(vertices):
                draw_by_engine(state, frame, material, part, vouched)
            return
    if material.primitive == "coloured":
        corners = [n64_polygon.Vertex(x, y, s, t, w, tuple((shade & M32).to_bytes(4, "big")))
                   for x, y, s, t, shade, w in vertices]
    else:
        corners = [n64_polygon.Vertex(x, y, s, t, w, shade=shade)
                   for x, y, s, t, shade, w in vertices]
    n64_polygon.draw(state, frame, corners, settings_of(material))


def asked_by(perspective: bool) -> int:
    """Returns the kinds of values that a unit draws as planes."""
    return planarity.DEPTHS if perspective else planarity.TEXELS


def pipe_parts(units, first: list[tuple], own: list[tuple], vouched: int) -> list[list[tuple]]:
    """Returns the pieces in which a pipe draws a polygon. If the second unit has its own
    coordinates, its vertices follow each piece's."""
    shared = units[:1] if own else units
    planar = True
    for values, some in ((first, shared), (own, units[1:])) if len(first) > 3 else ():
        if values:
            asked = asked_by(any(unit.modes.perspective for unit in some)) & ~vouched
            places = [(*p[:2], *v[2:]) for p, v in zip(first, values)]
            planar &= planarity.planar(places, asked) == asked
    if planar:
        return [first + own]
    fans = [planarity.fan(values) for values in (first, own) if values]
    return [sum(parts, []) for parts in zip(*fans)]


def draw_by_pipe(scene, frame: np.ndarray, material, vertices: list[tuple], vouched: int) -> None:
    """Draws an object, vertices (x, y, s, t, shade, w), by a pipe of Glide's units. If the second
    unit has its own coordinates, they are the vertices' second half."""
    units, half = units_of(scene, material.unit), len(vertices)
    if has_own(scene, material):
        half //= 2
    for part in pipe_parts(units, vertices[:half], vertices[half:], vouched):
        draw_part(scene, units, frame, material, part)


def draw_part(scene, units, frame: np.ndarray, material, vertices: list[tuple]) -> None:
    """Draws a polygon of a pipe in one piece."""
    owns = [None] * len(vertices)
    if has_own(scene, material):
        half = len(vertices) // 2
        owns = [(s, t, w) for _, _, s, t, _, w in vertices[half:]]
        vertices = vertices[:half]
    corners = [polygon.Vertex(x, y, s, t, w, own)
               for (x, y, s, t, _, w), own in zip(vertices, owns)]
    polygon.draw(units, frame, corners, settings_of(material),
                 bool(scene.pipes[material.unit][4]))
