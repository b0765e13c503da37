"""Compiles a scene file in TOML to the scene the Amiga loads.

What a field may be is in ``schema``. Angles are clockwise on the screen, whose
y runs down; an object's motion starts at the frame where it appears, and
``turns``, ``orbit`` and ``scale`` run through once per ``frames`` of the scene.
"""

import math
import tomllib
from pathlib import Path

import numpy as np

from . import images, layout, palette
from .fields import (REQUIRED, choice, colour, fail, integer, join, named, number, rows, table,
                     text)
from .scene_file import Object, Scene

ONE = 65536  # 1.0 in 16.16
MAP_CENTRE = 128.0  # texels
CONCAVE = 1 / 64  # pixels a corner may be dented, for coordinates rounded in the file


def scaling(value, where):
    """A size, or [from, to]: always a pair."""
    size = number(0, 256)
    return rows(size, 2, 2)(value, where) if isinstance(value, list) else [size(value, where)] * 2


def schema(limits: dict[str, int]):
    """The check of a whole scene. Lengths are pixels, texels where named so."""
    far = limits["POLYGON_FAR"] - 1
    corners = limits["POLYGON_VERTICES_MAX"]
    frame = integer(0, limits["SCENE_FRAMES_MAX"] - 1)
    place = number(-far, far)
    pair = rows(place, 2, 2)
    turns = number(-1000, 1000)
    orbit = table({"radius": (pair, REQUIRED), "turns": (turns, REQUIRED), "phase": (turns, 0.0)})
    shapes = {
        "sides": {"sides": (integer(3, corners), REQUIRED),
                  "radius": (number(0.01, far), REQUIRED),
                  "map_radius": (number(0, far - MAP_CENTRE), 128.0),  # texels
                  "map_turn": (number(-360, 360), 0.0)},  # degrees
        "vertices": {"vertices": (rows(rows(place, 2, 4), 3, corners), REQUIRED)}}
    placing = {
        "material": (text, REQUIRED),
        "centre": (pair, [0.0, 0.0]), "move": (pair, [0.0, 0.0]),  # pixels a frame
        "orbit": (orbit, {"radius": [0.0, 0.0], "turns": 0.0, "phase": 0.0}),
        "angle": (number(-3600, 3600), 0.0),  # degrees
        "turns": (turns, 0.0), "scale": (scaling, [1.0, 1.0]),
        "first": (frame, 0), "last": (frame, None)}
    side = limits["SCENE_SIDE_MAX"]
    return table({
        "title": (text, ""), "width": (integer(4, side, 4), REQUIRED),
        "height": (integer(1, side), REQUIRED),
        "frames": (integer(1, limits["SCENE_FRAMES_MAX"]), REQUIRED),
        "background": (colour, REQUIRED),
        "textures": (named(table({"image": (text, REQUIRED)})), {}),
        "materials": (named(choice({"texture": {"texture": (text, REQUIRED)},
                                    "colour": {"colour": (colour, REQUIRED)}}, {})), REQUIRED),
        "objects": (rows(choice(shapes, placing), 1, limits["SCENE_COUNT_MAX"]), REQUIRED)})


def regular(spec: dict) -> list[list[float]]:
    """The vertices of a regular polygon, clockwise from the top: x, y, s, t."""
    out = []
    for i in range(spec["sides"]):
        angle = math.tau * i / spec["sides"]
        on_map = angle - math.radians(spec["map_turn"])
        out.append([spec["radius"] * math.sin(angle), -spec["radius"] * math.cos(angle),
                    MAP_CENTRE + spec["map_radius"] * math.sin(on_map),
                    MAP_CENTRE - spec["map_radius"] * math.cos(on_map)])
    return out


def check_convex(corners: list[list[float]], where: str) -> None:
    """Refuses a vertex list that is dented or goes round more than once."""
    points = [complex(*corner[:2]) for corner in corners]
    points = [p for i, p in enumerate(points) if p != points[i - 1]]
    sides = [p - points[i - 1] for i, p in enumerate(points)]
    area = sum((p.conjugate() * s).imag for p, s in zip(points, sides))
    around = 0.0
    for i, side in enumerate(sides):
        turn = sides[i - 1].conjugate() * side  # real: dot product, imaginary: cross product
        dent = turn.imag / (abs(sides[i - 1] + side) or 1.0) * math.copysign(1, area)
        if dent < -CONCAVE:
            fail(where, "the polygon is not convex")
        around += math.atan2(abs(turn.imag), turn.real)
    if around > 1.5 * math.tau:
        fail(where, "the polygon crosses itself")


def corners_of(spec: dict, textured: bool, where: str) -> list[list[float]]:
    """An object's vertices before its pose: x, y, s, t."""
    if "sides" in spec:
        return regular(spec)
    for i, corner in enumerate(spec["vertices"]):
        if len(corner) != 4 and (textured or len(corner) != 2):
            fail(f"{where}.vertices[{i}]", "must be [x, y, s, t]" +
                 ("" if textured else " or, as it is flat, [x, y]"))
    check_convex(spec["vertices"], f"{where}.vertices")
    return [corner + [0.0] * (4 - len(corner)) for corner in spec["vertices"]]


def pose_at(spec: dict, age: int, loop: int) -> list[float]:
    """xx, xy, yx, yy, x0, y0 of an object ``age`` frames after it appeared."""
    life = age / loop
    low, high = spec["scale"]
    scale = low + (high - low) * (1 - math.cos(math.tau * life)) / 2
    angle = math.radians(spec["angle"]) + math.tau * spec["turns"] * life
    orbit = spec["orbit"]
    swing = math.tau * (orbit["turns"] * life + orbit["phase"])
    x, y = (c + m * age for c, m in zip(spec["centre"], spec["move"]))
    cos, sin = scale * math.cos(angle), scale * math.sin(angle)
    return [cos, -sin, sin, cos, x + orbit["radius"][0] * math.cos(swing),
            y + orbit["radius"][1] * math.sin(swing)]


def fixed(values: list[list[float]]) -> np.ndarray:
    """The nearest 16.16 numbers, int64."""
    return np.rint(np.array(values) * ONE).astype(np.int64)


def check_reach(corners: np.ndarray, poses: np.ndarray, first: int, far: int, where: str) -> None:
    """Refuses an object that leaves the range polygons may have; 16.16 arguments."""
    x, y = corners[:, 0], corners[:, 1]
    xx, xy, yx, yy, x0, y0 = (column[:, None] for column in poses.T)  # frames down, corners across
    reach = np.maximum(abs((xx * x >> 16) + (xy * y >> 16) + x0),
                       abs((yx * x >> 16) + (yy * y >> 16) + y0))
    beyond = (reach.max(axis=1) >= far * ONE) | (abs(poses[:, 4:]).max(axis=1) >= far * ONE)
    if beyond.any():
        fail(where, f"reaches {far} pixels or more from the corner of the screen "
                    f"in frame {first + beyond.argmax()}")


def parse(path: Path) -> dict:
    """The checked content of a scene's TOML, every default filled in."""
    where = f"{path}: "
    try:
        content = tomllib.loads(path.read_bytes().decode())
    except OSError as error:
        fail(str(path), error.strerror)
    except UnicodeDecodeError:
        fail(str(path), "is not UTF-8 text")
    except (ValueError, RecursionError) as error:
        fail(str(path), f"is not TOML: {error}")
    spec = schema(layout.load().constants)(content, where)
    for name, material in spec["materials"].items():
        if material.get("texture", None) not in (None, *spec["textures"]):
            fail(join(f"{where}materials", name) + ".texture",
                 f"there is no texture {material['texture']!r}")
    for i, obj in enumerate(spec["objects"]):
        at = f"{where}objects[{i}]"
        if obj["material"] not in spec["materials"]:
            fail(f"{at}.material", f"there is no material {obj['material']!r}")
        if not obj["first"] < spec["frames"]:
            fail(f"{at}.first", f"the scene ends with frame {spec['frames'] - 1}")
        if obj["last"] is not None and not obj["first"] <= obj["last"] < spec["frames"]:
            fail(f"{at}.last", f"must be from {obj['first']} to {spec['frames'] - 1}")
    return spec


def place_objects(spec: dict, count: int, where: str) -> tuple[list, list, list]:
    """Objects, vertices and poses of the first ``count`` frames, the latter two in 16.16."""
    limits = layout.load().constants
    material_number = {name: i for i, name in enumerate(spec["materials"])}
    objects, vertices, poses = [], [], []
    for i, obj in enumerate(spec["objects"]):
        at = f"{where}objects[{i}]"
        textured = "texture" in spec["materials"][obj["material"]]
        corners = fixed(corners_of(obj, textured, at))
        last = count - 1 if obj["last"] is None else min(obj["last"], count - 1)
        lives = last - obj["first"] + 1
        if lives < 1:
            continue
        motion = fixed([pose_at(obj, age, spec["frames"]) for age in range(lives)])
        check_reach(corners, motion, obj["first"], limits["POLYGON_FAR"], at)
        objects.append(Object(material_number[obj["material"]], len(vertices), len(corners),
                              len(poses), lives, obj["first"]))
        vertices += corners.tolist()
        poses += motion.tolist()
        for noun, made in (("vertices", vertices), ("frames of objects", poses)):
            if len(made) > limits["SCENE_COUNT_MAX"]:
                fail(at, f"more than {limits['SCENE_COUNT_MAX']} {noun} in the scene")
    return objects, vertices, poses


def compile_scene(path: Path, frames: int | None = None) -> Scene:
    """The scene of a TOML file.

    ``frames`` is how many frames to make, from the first, instead of the
    scene's own number; how fast things move does not change.
    """
    path = Path(path)
    where = f"{path}: "
    spec = parse(path)
    limits = layout.load().constants
    if frames is not None:
        integer(1, limits["SCENE_FRAMES_MAX"])(frames, "frames")
    count = frames or spec["frames"]
    objects, vertices, poses = place_objects(spec, count, where)

    exact = [spec["background"]]
    exact += [m["colour"] for m in spec["materials"].values() if "colour" in m]
    entry = {rgb: i for i, rgb in enumerate(dict.fromkeys(exact))}
    texture_number = {name: i for i, name in enumerate(spec["textures"])}
    materials = [(limits["NO_TEXTURE"], entry[m["colour"]]) if "colour" in m
                 else (texture_number[m["texture"]], 0) for m in spec["materials"].values()]
    pictures = [images.load(t["image"], path.parent, join(f"{where}textures", name) + ".image")
                for name, t in spec["textures"].items()]
    colours, maps = palette.build(exact, pictures, f"{where}materials")
    return Scene(spec["width"], spec["height"], count, entry[spec["background"]], colours, maps,
                 materials, objects, np.array(vertices, np.int64).reshape(-1, 4),
                 np.array(poses, np.int64).reshape(-1, 6))
