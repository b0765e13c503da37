"""The integer model: the renderer's own arithmetic, in Python integers.

It follows c/polygon and src68k/polygon formula by formula and must agree with the
68020 bit for bit. It knows nothing of forms: addx, swap and C draw the same
picture, because every number that decides a pixel depends on the pixel alone.

All coordinates are 16.16 (units of 1/65536 pixel or texel); gradients of the
plane are 32.32 before they are rounded to steps.

What it may be off from the ideal, and why, stands in tools/ideal.py.
"""

from dataclasses import dataclass

import numpy as np

from . import model_logarithm, model_reciprocal, scene_pipes, scene_units
from .clip import clip, frame_window
from .fixed import M32, ONE, ceil16, mul, signed
from .model_edges import Edge, measure, side
from .model_mesh import polygons_at
from .model_perspective import PIECES, Perspective, ends, is_level, level, perspective
from .model_perspective import coordinates as perspective_coordinates
from .model_shading import LIT, Shading, level_of, light_lines, shading
from .model_spans import coordinates, pixels
from .model_tolerance import coarser, is_flat
from .model_texturing import (Line, Settings, Texturing, along, edge_starts, longest, plane,
                              scanline_line)
from .scene_textures import UNITS

__all__ = ["M32", "Edge", "Line", "Polygon", "Settings", "Texturing", "adapt", "ceil16",
           "coordinates", "draw", "prepare", "prepare_polygon", "render", "scanline_line", "set_up",
           "signed"]

FAR = 16384 << 16
INSET = ONE // 16  # see c/polygon/material.c
ON_PLANE = 3 * INSET // 4
STEEP = 4 << 16


@dataclass
class Polygon:
    """What the set-up makes of a polygon: its lines from ``top`` on."""

    top: int
    lines: list[Line]
    texturing: Texturing | None
    left_edges: list[Edge]
    right_edges: list[Edge]
    textured: bool
    perspective: Perspective | None = None  # instead of texturing
    setting: str = "none"  # how the perspective is drawn
    straight: bool = False  # the tolerance lets its lines be
    level: int = 0  # lit: the row of the light table
    shading: Shading | None = None  # lit Gouraud
    is_level: bool = False  # the perspective's depth does not change along lines
    constants: model_reciprocal.Constants | None = None  # of lines by tables

    @property
    def by(self):
        """The model of lines by tables."""
        return model_reciprocal if self.setting in PIECES else model_logarithm

    def taken(self, line: Line, y: int):
        """The line at y as it is drawn by tables; None if it is not."""
        return self.constants and self.by.line(self.perspective, self.constants, line.left,
                                               line.right, y)

    def coordinates(self, line: Line, y: int, mapper: str = "affine"):
        """u and v of the pixels of a line at y, int64, 16.16 modulo 2^32."""
        if not self.perspective:
            return coordinates(line, mapper, y)
        if self.is_level:
            return level(self.perspective, line.left, line.right, y)
        taken = self.taken(line, y)
        if taken:
            return self.by.coordinates(taken)
        return perspective_coordinates(ends(self.perspective, line.left, line.right, y),
                                       self.setting)

    @property
    def pixels(self) -> int:
        """Pixels drawn."""
        return sum(max(0, line.right - line.left) for line in self.lines)


def is_steep(settings: Settings, dudx: int, dvdx: int) -> bool:
    """Whether an edge's error may lead further out of the vertices' range than INSET."""
    return settings.gradients != "plane" or not all(
        -STEEP < signed(step) < STEEP for step in (dudx, dvdx))


def plane_range(vertices, t: Texturing) -> tuple[list[int], list[int]]:
    """The lowest u and v, and the highest, that the plane as it is stepped has at the vertices."""
    planes = ((t.u, signed(t.dudx), signed(t.dudy)), (t.v, signed(t.dvdx), signed(t.dvdy)))
    values = [[signed(at + mul(ddx, v[0] - (t.i << 16)) + mul(ddy, v[1] - (t.j << 16)))
               for v in vertices] for at, ddx, ddy in planes]
    return [min(c) for c in values], [max(c) for c in values]


def held_range(vertices, settings: Settings, size: tuple[int, int] | None, t: Texturing | None,
               steep: bool):
    """(low, high) of u and of v where lines must be held in a range; else None."""
    low, high = ([f(v[k] for v in vertices) for k in (2, 3)] for f in (min, max))
    if settings.mapper == "gouraud":
        ranges = [(low[0] & ~0xFFFF, high[0] | 0xFFFF), (0, 0)]
    elif settings.mapper == "arbitrary":
        ranges = [(0, (side << 16) - 1) for side in size]
    else:
        return None
    inset = INSET
    if len(vertices) > 3 and not steep:  # the plane need not run through all of them
        inset, (low, high) = ON_PLANE, plane_range(vertices, t)
    used = 1 if settings.mapper == "gouraud" else 2
    inside = all(a >= first + inset and b <= last - inset
                 for a, b, (first, last) in list(zip(low, high, ranges))[:used])
    return None if inside and not steep else ranges


def hold(lines: list[Line], ranges) -> None:
    """Moves the lines, all of the same steps, so that no pixel leaves the ranges."""
    counts = [line.right - line.left for line in lines]
    longest_line = max(*counts, 1) - 1
    for line, count in zip(lines, counts):
        for coordinate, (low, high) in zip("uv", ranges):
            step = signed(getattr(line, f"d{coordinate}dx"))
            if longest_line:
                most = (high - low) // longest_line
                step = min(max(step, -most), most)
            setattr(line, f"d{coordinate}dx", step & M32)
            if count > 0:
                travel, start = (count - 1) * step, signed(getattr(line, coordinate))
                start = min(max(start, low - min(travel, 0)), high - max(travel, 0))
                setattr(line, coordinate, start & M32)


def scanline_lines(left: list[Edge], right: list[Edge], lines: list[Line],
                   settings: Settings) -> None:
    """Sets u, v and steps of each line by two divides."""
    sides = ([point for edge in edges for point in along(edge)] for edges in (left, right))
    for line, a, b in zip(lines, *sides):
        if line.right > line.left:
            scanline_line(line, a, b, settings.start == "truncated")


def outline(vertices, width: int, height: int, settings: Settings):
    """The corners that gradients come from, the vertices that edges do and their sides; None where
    nothing is covered."""
    sides = measure(vertices, width, height)
    if sides is None:
        return None
    corners = sides.corners
    if settings.clip == "vertices" and settings.edges != "exact":
        clipped = clip(vertices, frame_window(width, height))
        if clipped != vertices:
            vertices, sides = clipped, measure(clipped, width, height)
    return sides and (corners, vertices, sides)


def set_up(vertices, width: int, height: int, textured: bool, settings: Settings = Settings(),
           size: tuple[int, int] | None = None) -> Polygon | None:
    """Sets a polygon up for a frame; None where it is refused or covers nothing.

    ``vertices``: a list of (x, y, u, v), with a perspective (x, y, u, v, w), 16.16, lit ones
    with their level last, as ``adapt`` gives them; ``size`` is the map's, in texels.
    """
    n = len(vertices)
    if not 3 <= n <= 64 or any(not -FAR <= c < FAR for v in vertices for c in v[:4]):
        return None
    if textured and settings.gradients == "polygon" and n != 3:
        return None
    found = outline(vertices, width, height, settings)
    if found is None:
        return None
    corners, edge_vertices, sides = found
    box, direction, top = sides.box, sides.direction, sides.corners[0]
    exact = settings.edges == "exact"
    lefts = side(edge_vertices, top, direction, box[1], box[3], exact)
    rights = side(edge_vertices, top, -direction, box[1], box[3], exact)
    left = [e.column(y) for e in lefts for y in range(e.top, e.end)]
    right = [e.column(y) for e in rights for y in range(e.top, e.end)]
    lines = [Line(max(a, 0), min(b, width)) for a, b in zip(left, right)]
    if settings.perspective != "none" and not is_flat(vertices, settings.tolerance):
        deep = perspective(vertices, corners, box)
        if deep:
            across = box[2] - box[0]
            setting, straight = coarser(deep, across, settings.perspective, settings.tolerance)
            return Polygon(box[1], lines, None, lefts, rights, textured, deep, setting,
                           straight, is_level=straight or is_level(deep, across, setting),
                           constants=constants(deep, lines, box, setting))
    t = None
    if textured and settings.gradients == "scanline":
        scanline_lines(lefts, rights, lines, settings)
        groups = [[line] for line in lines if line.right > line.left]
    elif textured:
        t = plane(vertices, corners, box, settings) if settings.gradients == "plane" \
            else longest(vertices, corners, box, settings)
        if t is None:
            return None
        starts = [start for e in lefts for start in edge_starts(t, e, settings)]
        for line, a, (u, v) in zip(lines, left, starts):
            cut = line.left - a  # the frame's columns cut a line
            line.u, line.v = u + cut * t.dudx & M32, v + cut * t.dvdx & M32
            line.dudx, line.dvdx = t.dudx & M32, t.dvdx & M32
        groups = [lines]
    for group in groups if textured else []:
        ranges = held_range(vertices, settings, size, t,
                            is_steep(settings, group[0].dudx, group[0].dvdx))
        if ranges:
            hold(group, ranges)
    polygon = Polygon(box[1], lines, t, lefts, rights, textured)
    if settings.mapper == "lit":
        polygon.level = vertices[0][-1] >> 16
    elif settings.mapper == "lit_gouraud":
        polygon.shading = shading(vertices, corners, box)
        light_lines(lines, box[1], polygon.shading)
    return polygon


def constants(deep: Perspective, lines: list[Line], box, setting: str):
    """The constants of lines by tables; None where there are none."""
    first = next((k for k, line in enumerate(lines) if line.right > line.left), None)
    if setting == "fine" or first is None:
        return None
    piece = PIECES[setting].bit_length() - 1 if setting in PIECES else None
    return model_reciprocal.find(deep, piece, box[2] - box[0], lines[first].left - box[0], first)


def adapt(vertices, settings: Settings, longer: int) -> list[tuple]:
    """(x, y, s, t, shade, w) as ``set_up`` takes them: x and y in whole pixels where edges are;
    s and t in texels of a map whose longer side is given, rounded down, w, and a lit mapper's
    level; or the shade as u, kept INSET inside the range of the pixels it may become."""
    if settings.edges == "integer":
        vertices = [(v[0] & ~0xFFFF, v[1] & ~0xFFFF, *v[2:]) for v in vertices]
    if settings.mapper == "gouraud":
        shades = [v[4] for v in vertices]
        low, high = (min(shades) & ~0xFFFF) + INSET, (max(shades) | 0xFFFF) - INSET
        return [(x, y, min(max(shade, low), high), 0, *w)
                for x, y, _, _, shade, *w in vertices]
    lit = settings.mapper in LIT
    return [(x, y, signed(s * longer >> 8), signed(t * longer >> 8), *w, *[level_of(shade)][:lit])
            for x, y, s, t, shade, *w in vertices]


def draw(frame: np.ndarray, polygon: Polygon, texture: np.ndarray | None, colour: int,
         mapper: str = "affine", light: np.ndarray | None = None) -> None:
    """Draws a set-up polygon into ``frame`` (height x width). ``texture``: [v][u]; ``light``:
    [level][texel], of the lit mappers."""
    if mapper == "lit":
        light = light[polygon.level]
    for y, line in enumerate(polygon.lines, polygon.top):
        if line.right > line.left and polygon.perspective:
            u, v = polygon.coordinates(line, y)
            height, width = texture.shape
            frame[y, line.left:line.right] = texture[(v >> 16) % height, (u >> 16) % width]
        elif line.right > line.left:
            frame[y, line.left:line.right] = pixels(line, mapper, texture, light, y) \
                if polygon.textured else colour


def prepare_polygon(scene, number: int, vertices) -> Polygon | None:
    """Vertices on the screen as they are set up with a scene's material; None where nothing
    is drawn."""
    material = scene.materials[number]
    settings = Settings(material.edges, material.gradients, material.start, material.clip,
                        material.perspective, material.mapper, material.tolerance)
    texture = scene.textures[material.texture].texels if material.texture >= 0 else None
    return set_up(adapt(vertices, settings, 256 if texture is None else max(texture.shape)),
                  scene.width, scene.height, material.mapper not in ("flat", *UNITS), settings,
                  None if texture is None else texture.shape[::-1])


def prepare(scene, obj, number: int) -> Polygon | None:
    """An object of a scene as it is set up in frame ``number``; None where it draws nothing."""
    from .scene_file import vertices_at

    vertices = vertices_at(scene, obj, number)
    return prepare_polygon(scene, obj.material, vertices) if vertices else None


def render(scene, number: int) -> np.ndarray:
    """Frame ``number`` of a scene (tools.scene_file.Scene), height x width of its pixels."""
    frame = np.full((scene.height, scene.width), scene.background, scene.pixel.dtype)
    states = {}
    for which, vertices in polygons_at(scene, number):
        material = scene.materials[which]
        if material.mapper == "unit":
            if material.unit not in states:
                states[material.unit] = scene_units.state_at(scene, material.unit, number)
            scene_units.draw(scene, states[material.unit], frame, material, vertices)
            continue
        if material.mapper == "glide":
            scene_pipes.draw(scene, frame, material, vertices)
            continue
        polygon = prepare_polygon(scene, which, vertices)
        if polygon:
            texture = scene.textures[material.texture].texels if material.texture >= 0 else None
            light = scene.textures[material.light].texels if material.light >= 0 else None
            draw(frame, polygon, texture, material.colour, material.mapper, light)
    return frame
