"""Compiles a scene file in TOML to the scene the Amiga loads.

``schema`` defines the fields. Angles are clockwise on the screen, whose y runs down. An object's
motion starts at the frame where it appears, and ``turns``, ``orbit`` and ``scale`` run through once
per ``frames`` of the scene.
"""

import sys
import tomllib
from pathlib import Path

import numpy as np

from tmap.base.fields import (REQUIRED, choice, colour, fail, integer, named, number, one_of, real,
                              rows, table, text)
from tmap.base.fixed import fix_all
from tmap.base.pixel_formats import FORMATS
from tmap.build import layout
from tmap.compiler import (glide, glide_build, materials, mtl_file, n64_build, objects as scene_space,
                           parts, primitives, projectors, views16)
from tmap.compiler.map_range import MAP_CENTRE
from tmap.compiler.polygons import check_reach, each_frame, object_corners, pose_at
from tmap.scene_file.scene_file import IDENTITY, Object, Scene
from tmap.setup import planarity


def scaling(value, where):
    """Checks a size, or [from, to]; always returns a pair."""
    size = number(0, 256)
    return rows(size, 2, 2)(value, where) if isinstance(value, list) else [size(value, where)] * 2


def schema(limits: dict[str, int]):
    """Returns the check of a whole scene. Lengths are pixels, or texels where noted."""
    far = limits["POLYGON_FAR"] - 1
    corners = limits["POLYGON_VERTICES_MAX"]
    frame = integer(0, limits["SCENE_FRAMES_MAX"] - 1)
    place = number(-far, far)
    pair = rows(place, 2, 2)
    turns = number(-1000, 1000)
    orbit = table({"radius": (pair, REQUIRED), "turns": (turns, REQUIRED), "phase": (turns, 0.0)})
    placing = {
        "centre": (pair, [0.0, 0.0]), "move": (pair, [0.0, 0.0]),  # pixels a frame
        "orbit": (orbit, {"radius": [0.0, 0.0], "turns": 0.0, "phase": 0.0}),
        "angle": (number(-3600, 3600), 0.0),  # degrees
        "turns": (turns, 0.0), "scale": (scaling, [1.0, 1.0])}
    colours = primitives.colours_field(corners) | glide.coordinates_fields(corners)
    shapes = {
        "sides": {"sides": (integer(3, corners), REQUIRED),
                  "radius": (number(0.01, far), REQUIRED),
                  "map_radius": (number(0, far - MAP_CENTRE), 128.0),  # texels
                  "map_turn": (number(-360, 360), 0.0),  # degrees
                  "shades": (rows(number(0, materials.SHADES - 1), 1, corners), None)}
        | colours | placing,
        "vertices": {"vertices": (rows(rows(real, 2, 6), 3, corners), REQUIRED)} | colours
        | placing,
        "rectangle": primitives.rectangle_fields(far) | placing}
    shapes |= scene_space.object_schema(limits)
    always = {"material": (text, None), "first": (frame, 0), "last": (frame, None)}
    side = limits["FRAME_SIDE_MAX"]
    return table({
        "title": (text, ""), "width": (integer(4, side, 4), REQUIRED),
        "height": (integer(1, side), REQUIRED),
        "frames": (integer(1, limits["SCENE_FRAMES_MAX"]), REQUIRED),
        "format": (one_of(*FORMATS), "chunky"), "background": (colour, REQUIRED),
        "textures": (named(materials.texture_schema()), {}),
        "materials": (named(materials.material_schema()), {}),
        **scene_space.schema(limits),
        "objects": (rows(choice(shapes, always), 1, limits["SCENE_COUNT_MAX"]), REQUIRED)})


def parse(path: Path) -> dict:
    """Returns the checked content of a scene's TOML with every default filled in."""
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
    mtl_file.add(spec, path.parent, where)
    materials.check(spec, where)
    spec["objects"] = parts.split(spec["objects"], spec["materials"], where)
    for obj in spec["objects"]:
        at = obj["at"]
        if not obj["first"] < spec["frames"]:
            fail(f"{at}.first", f"the scene ends with frame {spec['frames'] - 1}")
        if obj["last"] is not None and not obj["first"] <= obj["last"] < spec["frames"]:
            fail(f"{at}.last", f"must be from {obj['first']} to {spec['frames'] - 1}")
        primitives.check(obj, spec["materials"][obj["material"]], at)
        glide.check_object(obj, spec["materials"][obj["material"]], at)
    primitives.place(spec)
    scene_space.check(spec, where)
    return spec


def from_space(obj: dict, material: dict, space: scene_space.Space, lives: int, where: str
               ) -> list[tuple[np.ndarray, np.ndarray, int]]:
    """Returns an object in space that is not stored as a mesh, in the form of ``each_frame``."""
    faces, still = projectors.Faces(obj, material, space, where), np.array([IDENTITY])
    return [(corners, still, obj["first"] + age) for age in range(lives)
            for corners in faces.polygons(obj["first"] + age, age)]


def planar_of(obj: dict, material: dict, corners: np.ndarray) -> int:
    """Returns the values of an object's polygon that are planar or not drawn. Poses keep values
    planar."""
    if scene_space.is_mesh(obj):
        return planarity.IN_SPACE
    return planarity.vouched(corners.tolist(), materials.mapper_of(material), bool(obj.get("colours")),
                             1 + glide.has_own(material))


def place_objects(spec: dict, count: int, ramps: dict[str, tuple[int, int]],
                  space: scene_space.Space, where: str) -> tuple[list, list, list]:
    """Returns objects, vertices and poses of the first ``count`` frames, the latter two in 16.16;
    meshes go into ``space``."""
    limits = layout.load().constants
    material_number = {name: i for i, name in enumerate(spec["materials"])}
    objects, vertices, poses = [], [], []
    for obj in spec["objects"]:
        at = obj["at"]
        material = spec["materials"][obj["material"]]
        texture = spec["textures"].get(material.get("texture"))
        lives = scene_space.lives_of(obj, count)
        if scene_space.is_mesh(obj) and not glide.has_own(material):
            space.place(obj, (material_number[obj["material"]], material, texture,
                              ramps.get(obj["material"])), len(objects), at)
            continue
        if scene_space.is_mesh(obj):
            made = from_space(obj, material, space, lives, at)
        else:
            corners = object_corners(obj, material, texture, ramps.get(obj["material"]), at)
            if lives < 1:
                continue
            motion = fix_all([pose_at(obj, age, spec["frames"]) for age in range(lives)])
            if primitives.is_rectangle(obj):
                motion = primitives.whole_pixels(motion)
            check_reach(corners, motion, obj["first"], limits["POLYGON_FAR"], at)
            made = each_frame(obj, corners, motion, material, at)
        for corners, motion, first in made:
            objects.append(Object(material_number[obj["material"]], len(vertices), len(corners),
                                  len(poses), len(motion), first, planar_of(obj, material, corners)))
            vertices += corners.tolist()
            poses += motion.tolist()
        for noun, rows_ in (("vertices", vertices), ("frames of objects", poses)):
            if len(rows_) > limits["SCENE_COUNT_MAX"]:
                fail(at, f"more than {limits['SCENE_COUNT_MAX']} {noun} in the scene")
    return objects, vertices, poses


def compile_scene(path: Path, frames: int | None = None, order: str | None = None) -> Scene:
    """Compiles the scene of a TOML file.

    ``frames``: how many frames to make, from the first, instead of the scene's number. Motion has
    the same speed. ``order``: of all meshes, instead of their own. Prints on stderr what the scene's
    author should know.
    """
    path = Path(path)
    where = f"{path}: "
    spec = parse(path)
    for obj in filter(scene_space.is_mesh, spec["objects"]):
        obj["order"] = order or obj["order"]
    limits = layout.load().constants
    if frames is not None:
        integer(1, limits["SCENE_FRAMES_MAX"])(frames, "frames")
    count = frames or spec["frames"]
    pixels = materials.pixels(spec)
    engines, engine_tables = n64_build.build(spec, path.parent, count, where)
    pipes, pipe_tables = glide_build.build(spec, path.parent, where)
    space = scene_space.Space(spec, count, path.parent, where)
    objects, vertices, poses = place_objects(spec, count, pixels.ramps, space, where)
    colours, textures, looks = materials.build(spec, pixels, engines | pipes,
                                                path.parent, where)
    made = Scene(spec["width"], spec["height"], count, pixels.of[spec["background"]], colours,
                 textures, looks, objects, np.array(vertices, np.int64).reshape(-1, 6),
                 np.array(poses, np.int64).reshape(-1, 6), spec["format"], **space.tables(),
                 **engine_tables, **pipe_tables)
    for note in (*space.notes.values(), *materials.transparent(spec, path.parent, where)):
        print(f"tmap: {note}", file=sys.stderr)
    return views16.add(made)
