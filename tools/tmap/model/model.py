"""The integer model: the renderer's own arithmetic, in Python integers.

It follows c/polygon and src68k/polygon formula by formula and must agree with the
68020 bit for bit. It does not distinguish forms: addx, swap and C draw the same
picture, because every number that decides a pixel depends on the pixel alone.

All coordinates are 16.16 (units of 1/65536 pixel or texel). Set-up is in
tools/tmap/setup/polygon.py, its parts in the other files of that folder. The bounds of the model's
error against the ideal are derived in tools/tmap/ideal/ideal.py.
"""

import numpy as np

from tmap.base.fixed import M32, ceil16, counted, signed
from tmap.model import units
from tmap.model.depths import Depths
from tmap.model.mesh import steps_at
from tmap.scene_file.scene_file import vertices_at
from tmap.scene_file.textures import UNITS
from tmap.scene_file.units import state_at
from tmap.setup.edges import Edge
from tmap.setup.mipmap import level_of
from tmap.setup.planarity import parts
from tmap.setup.polygon import FAR, INSET, Polygon, adapt, held_range, is_steep, plane_range, set_up
from tmap.setup.shading import LIT
from tmap.setup.spans import coordinates, lit, pixels, repeated
from tmap.setup.texturing import Line, Settings, Texturing, scanline_line

__all__ = ["FAR", "INSET", "M32", "Edge", "Line", "Polygon", "Settings", "Texturing", "adapt",
           "ceil16", "coordinates", "draw", "held_range", "is_steep", "parts", "plane_range", "prepare",
           "prepare_polygon", "render", "scanline_line", "set_up", "signed"]


def draw(frame: np.ndarray, polygon: Polygon, texture: np.ndarray | None, colour: int,
         light: np.ndarray | None = None) -> None:
    """Draws a set-up polygon into ``frame`` (height x width). ``texture``: [v][u]; ``light``:
    [level][texel], for the lit mappers."""
    if polygon.mapper == "lit":
        light = light[polygon.level]
    drawn = [(y, line) for y, line in enumerate(polygon.lines, polygon.top) if line.right > line.left]
    if polygon.columns:
        draw(frame.T, polygon.columns, texture, colour)
        drawn = drawn if polygon.mapper in LIT else []
    if not drawn:
        return
    lines = [line for _, line in drawn]
    counts = [line.right - line.left for line in lines]
    ys = np.repeat([y for y, _ in drawn], counts)
    xs = np.repeat([line.left for line in lines], counts) + counted(counts)
    # columns of outlines that cross themselves cover other pixels than their lines do
    stepped = polygon.stepped if polygon.textured and not polygon.columns else None
    if polygon.perspective:
        texels = frame[ys, xs]
        if not polygon.columns:
            height, width = texture.shape
            texels = texture[repeated(stepped.v, height), repeated(stepped.u, width)]
        frame[ys, xs] = lit(lines, texels, light) if polygon.mapper in LIT else texels
        return
    made = pixels(lines, polygon.mapper, texture, light, (stepped.u, stepped.v)) if polygon.textured else colour
    frame[ys, xs] = np.where(made, made, frame[ys, xs]) if polygon.mapper == "keyed" else made


def prepare_polygon(scene, number: int, vertices) -> Polygon | None:
    """Sets up vertices on the screen with a scene's material; returns None if nothing is drawn."""
    material = scene.materials[number]
    settings = Settings.of(material)
    texture = scene.textures[material.texture].texels if material.texture >= 0 else None
    return set_up(adapt(vertices, settings, 256 if texture is None else max(texture.shape)),
                  scene.width, scene.height, material.mapper not in ("flat", *UNITS), settings,
                  None if texture is None else texture.shape[::-1], scene.pixel.bytes)


def prepare(scene, obj, number: int) -> Polygon | None:
    """Sets up an object of a scene, in one piece, for frame ``number``; returns None if it draws
    nothing."""
    vertices = vertices_at(scene, obj, number)
    return prepare_polygon(scene, obj.material, vertices) if vertices else None


def draw_placed(scene, number: int, frame: np.ndarray, placed, states: dict) -> None:
    """Draws polygons of frame ``number``. ``states``: of the units that have drawn before in it."""
    for which, vertices, vouched in placed:
        material = scene.materials[which]
        if material.mapper == "n64":
            if material.unit not in states:
                states[material.unit] = state_at(scene, material.unit, number)
            units.draw_by_engine(states[material.unit], frame, material, vertices, vouched)
            continue
        if material.mapper == "glide":
            units.draw_by_pipe(scene, frame, material, vertices, vouched)
            continue
        texture = scene.textures[material.texture].texels if material.texture >= 0 else None
        if material.levels and len(vertices) > 2:
            level = level_of(vertices, max(texture.shape), material.levels)
            if level:
                which = material.level + level - 1
                material = scene.materials[which]
                texture = scene.textures[material.texture].texels
        light = scene.textures[material.light].texels if material.light >= 0 else None
        longer = 256 if texture is None else max(texture.shape)
        for part in parts(vertices, material, scene.frame_shape, longer, vouched):
            polygon = prepare_polygon(scene, which, part)
            if polygon:
                draw(frame, polygon, texture, material.colour, light)


def render(scene, number: int) -> np.ndarray:
    """Draws frame ``number`` of a scene (tmap.scene_file.scene_file.Scene): its pixels, height x
    width."""
    frame = np.full((scene.height, scene.width), scene.background, scene.pixel.dtype)  # of cleared scenes
    aside, depths, states = np.zeros_like(frame), None, {}
    for what, faces, placed in steps_at(scene, number):
        if what == "begin":
            depths = Depths(scene, faces)
        aside[:] = 0
        draw_placed(scene, number, aside if what == "test" else frame, placed, states)
        for face in faces if depths else []:
            if what.startswith("fill"):
                depths.fill(*face, what == "fill_first")
            elif what == "test":
                depths.copy(frame, aside, *face)
    return frame
