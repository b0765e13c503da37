"""Compiles a scene file in TOML to the scene the Amiga loads.

What a field may be is in ``schema``. Angles are clockwise on the screen, whose
y runs down; an object's motion starts at the frame where it appears, and
``turns``, ``orbit`` and ``scale`` run through once per ``frames`` of the scene.
"""

import math
import tomllib
from pathlib import Path

import numpy as np

from . import (layout, materials, scene_glide, scene_glide_build, scene_primitives,
               scene_projectors, scene_space, scene_tx, scene_tx_build)
from .fields import (REQUIRED, choice, colour, fail, integer, named, number, one_of, rows, table,
                     text)
from .fixed import ONE, fix_all
from .map_range import MAP_CENTRE, check_engine, check_map, extent_of, inside
from .model_shading import LIT
from .pixel_formats import FORMATS
from .scene_file import IDENTITY, Object, Scene

CONCAVE = 1 / 64  # pixels a corner may be dented, for coordinates rounded in the file
UNEVEN = 1 / 64  # of s or t a corner may be off the plane where the map does not repeat
UNEVEN_SHADE = 0.5


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
    placing = {
        "centre": (pair, [0.0, 0.0]), "move": (pair, [0.0, 0.0]),  # pixels a frame
        "orbit": (orbit, {"radius": [0.0, 0.0], "turns": 0.0, "phase": 0.0}),
        "angle": (number(-3600, 3600), 0.0),  # degrees
        "turns": (turns, 0.0), "scale": (scaling, [1.0, 1.0])}
    colours = scene_primitives.colours_field(corners) | scene_glide.coordinates_fields(corners)
    shapes = {
        "sides": {"sides": (integer(3, corners), REQUIRED),
                  "radius": (number(0.01, far), REQUIRED),
                  "map_radius": (number(0, far - MAP_CENTRE), 128.0),  # texels
                  "map_turn": (number(-360, 360), 0.0),  # degrees
                  "shades": (rows(number(0, materials.SHADES - 1), 1, corners), None)}
        | colours | placing,
        "vertices": {"vertices": (rows(rows(place, 2, 6), 3, corners), REQUIRED)} | colours
        | placing,
        "rectangle": scene_primitives.rectangle_fields(far) | placing}
    shapes |= scene_space.object_schema(limits)
    always = {"material": (text, REQUIRED), "first": (frame, 0), "last": (frame, None)}
    side = limits["SCENE_SIDE_MAX"]
    return table({
        "title": (text, ""), "width": (integer(4, side, 4), REQUIRED),
        "height": (integer(1, side), REQUIRED),
        "frames": (integer(1, limits["SCENE_FRAMES_MAX"]), REQUIRED),
        "format": (one_of(*FORMATS), "chunky"), "background": (colour, REQUIRED),
        "textures": (named(materials.texture_schema()), {}),
        "materials": (named(materials.material_schema()), REQUIRED),
        **scene_space.schema(limits),
        "objects": (rows(choice(shapes, always), 1, limits["SCENE_COUNT_MAX"]), REQUIRED)})


def regular(spec: dict, extent: tuple[float, float]) -> list[list[float]]:
    """The vertices of a regular polygon, clockwise from the top: x, y, s, t, shade, w.

    ``extent``: s and t at the far ends of the map, 256 for the longer side.
    """
    wide, high = (end / (2 * MAP_CENTRE) for end in extent)
    shades = spec["shades"]
    if shades is None and spec["sides"] == 3:
        shades = [0.0, materials.SHADES - 1.0]
    out = []
    for i in range(spec["sides"]):
        angle = math.tau * i / spec["sides"]
        on_map = angle - math.radians(spec["map_turn"])
        shade = (materials.SHADES - 1) * (1 - math.cos(angle)) / 2  # down the polygon
        out.append([spec["radius"] * math.sin(angle), -spec["radius"] * math.cos(angle),
                    wide * (MAP_CENTRE + spec["map_radius"] * math.sin(on_map)),
                    high * (MAP_CENTRE - spec["map_radius"] * math.cos(on_map)),
                    shades[i % len(shades)] if shades else shade, 1.0])
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


def columns_of(material: dict) -> list[str]:
    """What a vertex of a material has after x and y."""
    mapper, looks = materials.mapper_of(material), scene_tx.looks(material)
    if mapper == "gouraud":
        return ["shade"]
    if mapper == "glide":
        return ["s", "t", *["w"] * material["glide"]["perspective"]]
    if looks:
        has_shade = looks.shade and not scene_primitives.is_coloured(material)
        return ["s", "t", *["w"] * looks.depth, *["shade"] * has_shade]
    return ["s", "t"] + (["shade"] if mapper in LIT else
                         ["w"] if material["perspective"] != "none" else [])


def listed(spec: dict, material: dict, where: str) -> list[list[float]]:
    """A vertex list as x, y, s, t, shade, w."""
    columns = columns_of(material)
    is_flat = materials.mapper_of(material) == "flat"
    form = f"[x, y, {', '.join(columns)}]" + is_flat * " or, as it is flat, [x, y]"
    limits = layout.load().constants
    ranges = {"shade": number(0, materials.SHADES - 1),
              "w": number(limits["W_MIN"] / ONE, limits["W_MAX"] / ONE)}
    out = []
    for i, (x, y, *rest) in enumerate(spec["vertices"]):
        if len(rest) != len(columns) and (rest or not is_flat):
            fail(f"{where}[{i}]", f"must be {form}")
        corner = {"s": 0.0, "t": 0.0, "shade": 0.0, "w": 1.0} | dict(zip(columns, rest))
        for name in ("shade", "w"):
            if name in columns:
                ranges[name](corner[name], f"{where}[{i}][{2 + columns.index(name)}]")
        out.append([x, y, *corner.values()])
    check_convex(spec["vertices"], where)
    return out


def check_even(corners: list[list[float]], columns: list[int], most: float, where: str) -> None:
    """Refuses corners whose values in these columns do not lie on one plane."""
    points = np.array(corners)
    basis = np.column_stack([points[:, :2], np.ones(len(points))])
    found = np.linalg.lstsq(basis, points[:, columns], rcond=None)[0]
    if abs(basis @ found - points[:, columns]).max() > most:
        noun = {1: "shades", 2: "s and t"}.get(len(columns), "colours")
        fail(where, f"{noun} of more than three corners must lie on one plane")


def corners_of(spec: dict, material: dict, texture: dict | None, where: str) -> list[list[float]]:
    """An object's vertices before its pose: x, y, s, t, shade, w. Refuses what the
    material cannot draw: ``where`` is the object."""
    mapper = materials.mapper_of(material)
    at = f"{where}.vertices" if "vertices" in spec else f"{where}.sides"
    has_shades = materials.has_shades(material)
    if spec.get("shades") is not None:
        if mapper != "gouraud" and not has_shades:
            fail(f"{where}.shades", f"material {spec['material']!r} has no shades")
        if len(spec["shades"]) > spec["sides"]:
            fail(f"{where}.shades", f"must have 1 to {spec['sides']} entries, "
                                    f"not {len(spec['shades'])}")
    size = (texture["width"], texture["height"]) if texture else (256, 256)
    if mapper == "glide":
        size = scene_glide_build.size_of(material)
    extent = scene_tx_build.size_of(material) if mapper == "unit" else extent_of(size)
    if has_shades and mapper != "lit_gouraud" and "sides" in spec and spec["shades"] is None:
        spec = spec | {"shades": [materials.SHADES - 1.0]}  # full light
    corners = regular(spec, extent) if "sides" in spec else listed(spec, material, at)
    if mapper != "flat" and len(corners) > 3:
        if material["gradients"] == "polygon":
            fail(at, f"{len(corners)} corners, but material {spec['material']!r} has gradients "
                     '"polygon", which are for triangles')
        even = material["gradients"] == "plane"  # others go from edge to edge
        if mapper in ("gouraud", "lit_gouraud", "unit") and even:
            shades_at = at if "vertices" in spec else f"{where}.shades"
            check_even(corners, [4], UNEVEN_SHADE, shades_at)
            if spec.get("colours"):
                check_even([[*corner[:2], *each] for corner, each in zip(corners, spec["colours"])],
                           [2, 3, 4, 5], UNEVEN_SHADE, f"{where}.colours")
        elif mapper == "arbitrary" and even:
            check_even(corners, [2, 3], UNEVEN, at)
    map_at = at if "vertices" in spec else f"{where}.map_radius"
    if texture:
        check_map(corners, mapper, size, extent, map_at)
    if mapper == "unit":
        check_engine(corners, map_at)
    if mapper == "glide":
        scene_glide.check_range([corner[2:4] for corner in corners], map_at)
    return corners


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
    materials.check(spec, where)
    for i, obj in enumerate(spec["objects"]):
        at = f"{where}objects[{i}]"
        if obj["material"] not in spec["materials"]:
            fail(f"{at}.material", f"there is no material {obj['material']!r}")
        if not obj["first"] < spec["frames"]:
            fail(f"{at}.first", f"the scene ends with frame {spec['frames'] - 1}")
        if obj["last"] is not None and not obj["first"] <= obj["last"] < spec["frames"]:
            fail(f"{at}.last", f"must be from {obj['first']} to {spec['frames'] - 1}")
        scene_primitives.check(obj, spec["materials"][obj["material"]], at)
        scene_glide.check_object(obj, spec["materials"][obj["material"]], at)
    scene_primitives.place(spec)
    scene_space.check(spec, where)
    return spec


def in_file(corners: list[list[float]], material: dict, texture: dict | None,
            ramp: tuple[int, int] | None, colours: list[tuple] | None) -> np.ndarray:
    """Corners as the file has them, 16.16: shades are pixels, or colours; rounding does not leave
    a map that is not repeated."""
    made = fix_all([[*corner[:4], materials.shade_pixel(corner[4], ramp) if ramp else 0.0, corner[5]]
                  for corner in corners])
    if materials.mapper_of(material) == "arbitrary":
        made[:, 2:4] = inside(made[:, 2:4], texture)
    if colours:
        made[:, 4] = scene_primitives.shades_of(colours)
    return made


def object_corners(obj: dict, material: dict, texture: dict | None, ramp: tuple[int, int] | None,
                   where: str) -> np.ndarray:
    """An object's vertices as the file has them, int64 [n, 6]."""
    if scene_primitives.is_rectangle(obj):
        return scene_primitives.corners_of(obj, material, where)
    made = in_file(corners_of(obj, material, texture, where), material, texture, ramp,
                   obj["colours"])
    return scene_glide.with_own(made, obj) if scene_glide.has_own(material) else made


def each_frame(obj: dict, corners: np.ndarray, poses: np.ndarray, material: dict,
               where: str) -> list[tuple[np.ndarray, np.ndarray, int]]:
    """A polygon or rectangle as objects: vertices and poses in 16.16, first frame. More than one
    where vertices are others in each frame."""
    if not scene_glide.slides(obj):
        return [(corners, poses, obj["first"])]
    return [(scene_glide.slid(corners, obj, material, age, where), poses[age:age + 1],
             obj["first"] + age) for age in range(len(poses))]


def from_space(obj: dict, material: dict, space: scene_space.Space, lives: int, where: str
               ) -> list[tuple[np.ndarray, np.ndarray, int]]:
    """An object in space that is no mesh: as ``each_frame``."""
    faces, still = scene_projectors.Faces(obj, material, space, where), np.array([IDENTITY])
    return [(corners, still, obj["first"] + age) for age in range(lives)
            for corners in faces.polygons(obj["first"] + age, age)]


def place_objects(spec: dict, count: int, ramps: dict[str, tuple[int, int]],
                  space: scene_space.Space, where: str) -> tuple[list, list, list]:
    """Objects, vertices and poses of the first ``count`` frames, the latter two in 16.16;
    meshes go into ``space``."""
    limits = layout.load().constants
    material_number = {name: i for i, name in enumerate(spec["materials"])}
    objects, vertices, poses = [], [], []
    for i, obj in enumerate(spec["objects"]):
        at = f"{where}objects[{i}]"
        material = spec["materials"][obj["material"]]
        texture = spec["textures"].get(material.get("texture"))
        last = count - 1 if obj["last"] is None else min(obj["last"], count - 1)
        lives = last - obj["first"] + 1
        if scene_space.is_mesh(obj) and not scene_glide.has_own(material):
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
            if scene_primitives.is_rectangle(obj):
                motion = scene_primitives.whole_pixels(motion)
            check_reach(corners, motion, obj["first"], limits["POLYGON_FAR"], at)
            made = each_frame(obj, corners, motion, material, at)
        for corners, motion, first in made:
            objects.append(Object(material_number[obj["material"]], len(vertices), len(corners),
                                  len(poses), len(motion), first))
            vertices += corners.tolist()
            poses += motion.tolist()
        for noun, rows_ in (("vertices", vertices), ("frames of objects", poses)):
            if len(rows_) > limits["SCENE_COUNT_MAX"]:
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
    pixels = materials.pixels(spec)
    engines, engine_tables = scene_tx_build.build(spec, path.parent, count, where)
    pipes, pipe_tables = scene_glide_build.build(spec, path.parent, where)
    space = scene_space.Space(spec, count, path.parent, where)
    objects, vertices, poses = place_objects(spec, count, pixels.ramps, space, where)
    colours, textures, looks = materials.build(spec, pixels, engines | pipes,
                                                path.parent, where)
    return Scene(spec["width"], spec["height"], count, pixels.of[spec["background"]], colours,
                 textures, looks, objects, np.array(vertices, np.int64).reshape(-1, 6),
                 np.array(poses, np.int64).reshape(-1, 6), spec["format"], **space.tables(),
                 **engine_tables, **pipe_tables)
