"""Compiles a scene file in TOML to the scene the Amiga loads.

``schema`` defines the fields. Angles are clockwise on the screen, whose y runs down. An object's
motion starts at the frame where it appears, and ``turns``, ``orbit`` and ``scale`` run through once
per ``frames`` of the scene.
"""

import re
import sys
import tomllib
from pathlib import Path

import numpy as np

from tmap.base.fields import (REQUIRED, Reader, choice, colour, fail, integer, named, number, one_of, reader,
                              real, rows, table, text)
from tmap.base.fixed import fix_all
from tmap.base.pixel_formats import FORMATS
from tmap.base.toml_lines import located, with_line
from tmap.build import layout
from tmap.compiler import (fog, glide, glide_build, hierarchy, materials, mtl_file, n64_build, objects as
                           scene_space, pages, parts, primitives, projectors, views16)
from tmap.compiler.map_range import MAP_CENTRE
from tmap.compiler.polygons import check_reach, each_frame, object_corners, pose_at
from tmap.compiler.space import SIZES
from tmap.scene_file.scene_file import IDENTITY, Object, Scene
from tmap.setup import planarity
from tmap.shapes import billboards


@reader('colour, `"#rrggbb"`, or `"none"`')
def backdrop(value, where):
    """Checks a colour; None for no background."""
    return None if value == "none" else colour(value, where)


@reader("number, 0 to 256, or list of 2")
def scaling(value, where):
    """Checks a size, or [from, to]; always returns a pair."""
    size = number(0, 256)
    return rows(size, 2, 2)(value, where) if isinstance(value, list) else [size(value, where)] * 2


def placing_fields(far: int) -> dict:
    """Returns the fields that move an object on the screen, at most ``far`` pixels away."""
    pair = rows(number(-far, far, "pixels"), 2, 2)
    turns = number(-1000, 1000, "turns")
    orbit = table({"radius": (pair, REQUIRED, "of the ellipse, across and down"),
                   "turns": (turns, REQUIRED, "times around in the scene's `frames`, clockwise"),
                   "phase": (turns, 0, "where it begins: 0 is the right end, 0.25 the lower one")})
    return {"centre": (pair, [0, 0], "where the object's own 0, 0 is: x to the right, y down"),
            "move": (rows(number(-far, far, "pixels a frame"), 2, 2), [0, 0], "steady motion of the centre"),
            "orbit": (orbit, {"radius": [0, 0], "turns": 0}, "motion of the centre on an ellipse"),
            "angle": (number(-3600, 3600, "degrees"), 0, "turns the object about its centre, clockwise"),
            "turns": (turns, 0, "further turns about its centre in the scene's `frames`, clockwise"),
            "scale": (scaling, 1, "its size; two numbers: from the first to the second and back in `frames`")}


def schema(limits: dict[str, int]) -> Reader:
    """Returns the reader of a whole scene."""
    far = limits["POLYGON_FAR"] - 1
    corners = limits["POLYGON_VERTICES_MAX"]
    frame = integer(0, limits["SCENE_FRAMES_MAX"] - 1)
    placing = placing_fields(far)
    colours = primitives.colours_field(corners) | glide.coordinates_fields(corners)
    shapes = {
        "sides": {"sides": (integer(3, corners), REQUIRED, "corners of a regular polygon, clockwise from the top"),
                  "radius": (number(0.01, far, "pixels"), REQUIRED, "from its centre to its corners"),
                  "map_radius": (number(0, far - MAP_CENTRE), 128,
                                 "the same on the map, around its middle, in s and t"),
                  "map_turn": (number(-360, 360, "degrees"), 0, "turns the map on the polygon, clockwise"),
                  "shades": (rows(number(0, materials.SHADES - 1), 1, corners), None,
                             "of the corners, repeated in turn; without it, they grow downwards, or are full light")}
        | colours | placing,
        "vertices": {"vertices": (rows(rows(real, 2, 6), 3, corners), REQUIRED,
                                  "corners in order, [values that the material needs](#corners) for each")} | colours
        | placing,
        "rectangle": primitives.rectangle_fields(far) | placing}
    shapes |= scene_space.object_schema(limits)
    always = {"material": (text, None, "a name of `[materials]`; required, but for meshes with `materials`"),
              "first": (frame, 0, "the frame in which it appears and its motion starts"),
              "last": (frame, None, "the last frame that shows it; without it, the scene's last")}
    side = limits["FRAME_SIDE_MAX"]
    return table({
        "title": (text, "", "a line about the scene"),
        "width": (integer(4, side, 4, "pixels"), REQUIRED, "the picture's width, in pixels of 1x1"),
        "height": (integer(1, side, unit="pixels"), REQUIRED, "the picture's height, in pixels of 1x1"),
        "pixel": (one_of(*SIZES), "1x1", "a pixel's width and height on the screen: the same picture of fewer, larger "
                                                "pixels, which take less time to draw and to show"),
        "frames": (integer(1, limits["SCENE_FRAMES_MAX"]), REQUIRED, "number of pictures; then the first one follows"),
        "format": (one_of(*FORMATS), "chunky", "pixels: entries of a palette of 256 colours, or colours"),
        "background": (backdrop, REQUIRED, "colour of pixels that no object covers; `\"none\"` if there are none: they are not "
                                           "cleared, which saves some 70,000 cycles of a frame of 320x200"),
        "pages": (one_of("shared", "own"), "shared", "how small maps are in memory: side by side in pages of 256x256 texels, "
                                                     "where polygons read so little of them that this saves pages; or each "
                                                     "repeated over a page of its own"),
        "textures": (named(materials.texture_schema()), {}, "pictures for materials"),
        "materials": (named(materials.material_schema()), {}, "looks of objects"),
        **scene_space.schema(limits),
        "objects": (rows(choice(shapes, always), 1, limits["SCENE_COUNT_MAX"]), REQUIRED,
                    "what is drawn, in this order")})


def text_of(path: Path) -> str:
    """Returns the text of a scene's file."""
    try:
        return path.read_bytes().decode()
    except OSError as error:
        fail(str(path), error.strerror)
    except UnicodeDecodeError:
        fail(str(path), "is not UTF-8 text")


def content_of(text: str, path: Path) -> dict:
    """Returns the content of a TOML file."""
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        said, _, place = str(error).partition(" (at ")
        line = re.match(r"line (\d+)", place)  # else it is the end of the file
        fail(f"{path}:{line[1] if line else text.rstrip().count(chr(10)) + 1}", f"is not TOML: {said}")
    except (ValueError, RecursionError) as error:
        fail(str(path), f"is not TOML: {error}")


def parse(path: Path) -> dict:
    """Returns the checked content of a scene's TOML with every default filled in."""
    text = text_of(path)
    content = content_of(text, path)
    with located(str(path), text):
        return checked(content, path)


def settle_size(spec: dict, where: str) -> None:
    """Sets a scene's width and height to its frames', in pixels of its size."""
    for name, size, least in zip(("width", "height"), SIZES[spec["pixel"]], (4, 1)):
        if spec[name] % (size * least):
            fail(f"{where}{name}", f"{spec[name]} is not a multiple of {size * least}, with pixels of {spec['pixel']}")
        spec[name] //= size


def checked(content: dict, path: Path) -> dict:
    """Returns a scene's content, checked and with every default filled in."""
    where = f"{path}: "
    spec = schema(layout.load().constants)(content, where)
    settle_size(spec, where)
    mtl_file.add(spec, path.parent, where)
    materials.settle_sizes(spec, path.parent, where)
    materials.check(spec, where)
    billboards.complete(spec["objects"], where)
    hierarchy.check(spec["objects"], where)
    spec["objects"] = parts.split(spec["objects"], spec["materials"], where)
    for obj in spec["objects"]:
        at = obj["at"]
        if not obj["first"] < spec["frames"]:
            fail(f"{at}.first", f"the scene ends with frame {spec['frames'] - 1}")
        if obj["last"] is not None and not obj["first"] <= obj["last"] < spec["frames"]:
            fail(f"{at}.last", f"must be from {obj['first']} to {spec['frames'] - 1}")
        fog.check_object(obj, spec["materials"][obj["material"]], scene_space.is_mesh(obj))
        primitives.check(obj, spec["materials"][obj["material"]], at)
        if primitives.is_rectangle(obj) and spec["pixel"] != "1x1":
            fail(f"{at}.rectangle", f"has steps a pixel of 1x1, but the scene's are {spec['pixel']}")
        glide.check_object(obj, spec["materials"][obj["material"]], at)
    primitives.place(spec)
    scene_space.check(spec, where)
    return spec


def from_space(obj: dict, material: dict, space: scene_space.Space, lives: int, where: str
               ) -> list[tuple[np.ndarray, np.ndarray, int]]:
    """Returns an object in space that is not stored as a mesh, in the form of ``each_frame``."""
    faces, still = projectors.Faces(obj, material, space, where), np.array([IDENTITY])
    return [(corners, still, obj["first"] + age) for age in range(lives)
            for corners in faces.polygons(obj["first"] + age)]


def planar_of(obj: dict, material: dict, corners: np.ndarray) -> int:
    """Returns the values of an object's polygon that are planar or not drawn. Poses keep values
    planar."""
    if scene_space.is_mesh(obj):
        return planarity.IN_SPACE
    return planarity.vouched(corners.tolist(), materials.mapper_of(material), bool(obj.get("colours")),
                             1 + glide.has_own(material))


def in_pixels(corners: np.ndarray, poses: np.ndarray, size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Returns corners, 16.16, and poses, in pixels of 1x1, in pixels of another size. What is not turned keeps poses
    without a matrix."""
    across, down = size
    is_turned = poses[:, 1:3].any()
    matrix = np.array([across, across, down, down] if is_turned else [1.0] * 4)
    corners = corners.copy()
    if not is_turned:
        corners[:, :2] = np.rint(corners[:, :2] / size)
    return corners, poses / [*matrix, across, down]


def place_rows(table: list, rows: np.ndarray, known: dict[bytes, int]) -> int:
    """Returns where rows are in a table; appends them if they are new. ``known``: where rows are that were placed."""
    key = rows.tobytes()
    if key not in known:
        known[key] = len(table)
        table += rows.tolist()
    return known[key]


def place_objects(spec: dict, count: int, ramps: dict[str, tuple[int, int]],
                  space: scene_space.Space, where: str) -> tuple[list, list, list]:
    """Returns objects, vertices and poses of the first ``count`` frames, the latter two in 16.16;
    meshes go into ``space``."""
    limits = layout.load().constants
    material_number = {name: i for i, name in enumerate(spec["materials"])}
    objects, vertices, poses = [], [], []
    known: tuple[dict[bytes, int], ...] = {}, {}
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
            corners, motion = in_pixels(corners, np.array([pose_at(obj, age, spec["frames"]) for age in range(lives)]),
                                        SIZES[spec["pixel"]])
            motion = fix_all(motion)
            if primitives.is_rectangle(obj):
                motion = primitives.whole_pixels(motion)
            check_reach(corners, motion, obj["first"], limits["POLYGON_FAR"], at)
            made = each_frame(obj, corners, motion, material, at)
        for corners, motion, first in made:
            objects.append(Object(material_number[obj["material"]], place_rows(vertices, corners, known[0]), len(corners),
                                  place_rows(poses, motion, known[1]), len(motion), first,
                                  planar_of(obj, material, corners)))
        for noun, rows_ in (("vertices", vertices), ("frames of objects", poses)):
            if len(rows_) > limits["SCENE_COUNT_MAX"]:
                fail(at, f"more than {limits['SCENE_COUNT_MAX']} {noun} in the scene")
    return objects, vertices, poses


def compile_scene(path: Path, frames: int | None = None, order: str | dict[str, str] | None = None,
                  keys: dict | None = None) -> Scene:
    """Compiles the scene of a TOML file.

    ``frames``: how many frames to make, from the first, instead of the scene's number. Motion has
    the same speed. ``order``: of all meshes, instead of their own; ``keys``: of the scene, instead of the file's. Prints
    on stderr what the scene's author should know.
    """
    path = Path(path)
    text = text_of(path)
    content = content_of(text, path) | (keys or {})
    with located(str(path), text):
        spec = checked(content, path)
        for obj in filter(scene_space.is_mesh, spec["objects"]):
            obj["order"] = order.get(obj["order"], obj["order"]) if isinstance(order, dict) \
                else order or obj["order"]
        made, notes = compiled(spec, path, frames)
    for note in notes:
        print(f"tmap: {with_line(note, str(path), text)}", file=sys.stderr)
    return made


def compiled(spec: dict, path: Path, frames: int | None) -> tuple[Scene, list[str]]:
    """Returns a scene from its checked content, and notes for its author."""
    where = f"{path}: "
    limits = layout.load().constants
    if frames is not None:
        integer(1, limits["SCENE_FRAMES_MAX"])(frames, "frames")
    count = frames or spec["frames"]
    pixels = materials.pixels(spec)
    engines, engine_tables = n64_build.build(spec, path.parent, count, where)
    pipes, pipe_tables = glide_build.build(spec, path.parent, where)
    space = scene_space.Space(spec, count, path.parent, where)
    # Pictures before places, which may take seconds a hundred frames: a file with a fault is refused at once.
    colours, textures, looks = materials.build(spec, pixels, engines | pipes,
                                                path.parent, where)
    objects, vertices, poses = place_objects(spec, count, pixels.ramps, space, where)
    ground = spec["background"]
    made = Scene(spec["width"], spec["height"], count, pixels.of[ground] if ground else 0, colours,
                 textures, looks, objects, np.array(vertices, np.int64).reshape(-1, 6),
                 np.array(poses, np.int64).reshape(-1, 6), spec["format"], int(bool(ground)), int(spec["visible"] == "once"),
                 *SIZES[spec["pixel"]], **space.tables(),
                 **engine_tables, **pipe_tables)
    if spec["pages"] == "shared":
        made = pages.share(made)
    return views16.add(made), [*space.notes.values(), *materials.transparent(spec, path.parent, where)]
