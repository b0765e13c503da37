"""Compiles polygons and rectangles of a scene's TOML to vertices and poses.

Corners are x, y, s, t, shade and w in floating point, before they are rounded for the file.
"""

import math

import numpy as np

from tmap.base.elementary import cos, sin
from tmap.base.fields import fail, number
from tmap.base.fixed import ONE, fix_all
from tmap.base.linear import length
from tmap.build import layout
from tmap.compiler import glide, materials, n64, primitives
from tmap.compiler.map_range import MAP_CENTRE, check_corners, inside_map, map_of
from tmap.scene_file.textures import UNITS
from tmap.setup.shading import LIT

CONCAVE = 1 / 64  # pixels: tolerance for dents, for coordinates rounded in the file


def regular(spec: dict, extent: tuple[float, float]) -> list[list[float]]:
    """Returns the vertices of a regular polygon, clockwise from the top: x, y, s, t, shade, w.

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
        shade = (materials.SHADES - 1) * (1 - cos(angle)) / 2  # down the polygon
        out.append([spec["radius"] * sin(angle), -spec["radius"] * cos(angle),
                    wide * (MAP_CENTRE + spec["map_radius"] * sin(on_map)),
                    high * (MAP_CENTRE - spec["map_radius"] * cos(on_map)),
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
        across = sides[i - 1] + side
        dent = turn.imag / (length((across.real, across.imag)) or 1.0) * math.copysign(1, area)
        if dent < -CONCAVE:
            fail(where, "the polygon is not convex")
        around += math.atan2(abs(turn.imag), turn.real)
    if around > 1.5 * math.tau:  # it is tau, or twice that and more: last bits do not matter
        fail(where, "the polygon crosses itself")


def columns_of(material: dict) -> list[str]:
    """Returns the names of a material's vertex values after x and y."""
    mapper, looks = materials.mapper_of(material), n64.looks(material)
    if mapper == "gouraud":
        return ["shade"]
    if mapper == "glide":
        return ["s", "t", *["w"] * material["glide"]["perspective"]]
    if looks:
        has_shade = looks.shade and not primitives.is_coloured(material)
        return ["s", "t", *["w"] * looks.depth, *["shade"] * has_shade]
    return ["s", "t", *["w"] * (material["perspective"] != "none"), *["shade"] * (mapper in LIT)]


def listed(spec: dict, material: dict, where: str) -> list[list[float]]:
    """Returns a vertex list as x, y, s, t, shade, w."""
    columns = columns_of(material)
    is_flat = materials.mapper_of(material) == "flat"
    form = f"[x, y, {', '.join(columns)}]" + is_flat * " or, as it is flat, [x, y]"
    limits = layout.load().constants
    place = number(1 - limits["POLYGON_FAR"], limits["POLYGON_FAR"] - 1)
    ranges = {"shade": number(0, materials.SHADES - 1),
              "w": number(limits["W_MIN"] / ONE, limits["W_MAX"] / ONE)}
    out = []
    for i, vertex in enumerate(spec["vertices"]):
        if len(vertex) != 2 + len(columns) and (len(vertex) > 2 or not is_flat):
            fail(f"{where}[{i}]", f"must be {form}")
        checked = {name: ranges.get(name, place)(value, f"{where}[{i}][{k}]")
                   for k, (name, value) in enumerate(zip(["x", "y", *columns], vertex))}
        corner = {"x": 0.0, "y": 0.0, "s": 0.0, "t": 0.0, "shade": 0.0, "w": 1.0} | checked
        out.append(list(corner.values()))
    check_convex(out, where)
    return out


def check_shades(spec: dict, material: dict, where: str) -> None:
    """Refuses shades that the material does not take, and too many shades."""
    if spec.get("shades") is None:
        return
    if materials.mapper_of(material) != "gouraud" and not materials.has_shades(material):
        fail(f"{where}.shades", f"material {spec['material']!r} has no shades")
    if len(spec["shades"]) > spec["sides"]:
        fail(f"{where}.shades", f"must have 1 to {spec['sides']} entries, "
                                f"not {len(spec['shades'])}")


def check_count(material: dict, name: str, count: int, at: str) -> None:
    """Refuses more corners than the material's gradients can draw; ``name``: the material's."""
    if count > 3 and materials.mapper_of(material) != "flat" and material["gradients"] == "polygon":
        fail(at, f"{count} corners, but material {name!r} has gradients \"polygon\", which are for "
                 "triangles")


def corners_of(spec: dict, material: dict, texture: dict | None, where: str) -> list[list[float]]:
    """Returns an object's vertices before its pose: x, y, s, t, shade, w. Refuses vertices that the
    material cannot draw. ``where``: the object, for messages."""
    mapper = materials.mapper_of(material)
    check_shades(spec, material, where)
    if "vertices" in spec:
        at = map_at = f"{where}.vertices"
        corners = listed(spec, material, at)
    else:
        at, map_at = f"{where}.sides", f"{where}.map_radius"
        takes_shades = materials.has_shades(material) and mapper != "lit_gouraud"
        if takes_shades and spec["shades"] is None:
            spec = spec | {"shades": [materials.SHADES - 1.0]}  # full light
        corners = regular(spec, map_of(material, texture).extent)
    check_count(material, spec["material"], len(corners), at)
    if texture or mapper in UNITS:
        check_corners(corners, mapper, map_of(material, texture), map_at)
    return corners


def pose_at(spec: dict, age: int, loop: int) -> list[float]:
    """Returns xx, xy, yx, yy, x0, y0 of an object ``age`` frames after it appeared."""
    life = age / loop
    low, high = spec["scale"]
    scale = low + (high - low) * (1 - cos(math.tau * life)) / 2
    angle = math.radians(spec["angle"]) + math.tau * spec["turns"] * life
    orbit = spec["orbit"]
    swing = math.tau * (orbit["turns"] * life + orbit["phase"])
    x, y = (c + m * age for c, m in zip(spec["centre"], spec["move"]))
    across, down = scale * cos(angle), scale * sin(angle)
    return [across, -down, down, across, x + orbit["radius"][0] * cos(swing),
            y + orbit["radius"][1] * sin(swing)]


def check_reach(corners: np.ndarray, poses: np.ndarray, first: int, far: int, where: str) -> None:
    """Refuses an object that leaves the range of polygons; 16.16 arguments."""
    x, y = corners[:, 0], corners[:, 1]
    xx, xy, yx, yy, x0, y0 = (column[:, None] for column in poses.T)  # frames down, corners across
    reach = np.maximum(abs((xx * x >> 16) + (xy * y >> 16) + x0),
                       abs((yx * x >> 16) + (yy * y >> 16) + y0))
    beyond = (reach.max(axis=1) >= far * ONE) | (abs(poses[:, 4:]).max(axis=1) >= far * ONE)
    if beyond.any():
        fail(where, f"reaches {far} pixels or more from the corner of the screen "
                    f"in frame {first + beyond.argmax()}")


def in_file(corners: list[list[float]], material: dict, texture: dict | None,
            ramp: tuple[int, int] | None, colours: list[tuple] | None) -> np.ndarray:
    """Returns corners as the file stores them, 16.16. Shades become pixels or colours. Rounding
    does not leave a map that does not repeat."""
    made = fix_all([[x, y, s, t, materials.shade_pixel(shade, ramp) if ramp else 0.0, w]
                    for x, y, s, t, shade, w in corners])
    if materials.mapper_of(material) == "arbitrary":
        made[:, 2:4] = inside_map(made[:, 2:4], texture)
    if colours:
        made[:, 4] = primitives.shades_of(colours)
    return made


def object_corners(obj: dict, material: dict, texture: dict | None, ramp: tuple[int, int] | None,
                   where: str) -> np.ndarray:
    """Returns an object's vertices as the file stores them, int64 [n, 6]."""
    if primitives.is_rectangle(obj):
        return primitives.corners_of(obj, material, where)
    made = in_file(corners_of(obj, material, texture, where), material, texture, ramp,
                   obj["colours"])
    return glide.with_own(made, obj) if glide.has_own(material) else made


def each_frame(obj: dict, corners: np.ndarray, poses: np.ndarray, material: dict,
               where: str) -> list[tuple[np.ndarray, np.ndarray, int]]:
    """Returns a polygon or rectangle as objects: vertices and poses in 16.16, first frame. There is
    one object for each frame if s and t move, else only one."""
    if not glide.slides(obj):
        return [(corners, poses, obj["first"])]
    return [(glide.slid(corners, obj, material, age, where), poses[age:age + 1],
             obj["first"] + age) for age in range(len(poses))]
