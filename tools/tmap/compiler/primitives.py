"""Further primitives of texture engines: polygons with colours at corners, texture rectangles."""

import copy

import numpy as np

from tmap.base.fields import REQUIRED, fail, flag, integer, number, rows
from tmap.base.fixed import ONE
from tmap.compiler import materials, n64
from tmap.compiler.n64 import colour_and_alpha
from tmap.n64.state import REACH
from tmap.scene_file import units

TEXEL = 32  # s10.5: parts of a texel in a rectangle's start
STEP = 1024  # s5.10: parts of a texel in its steps
STEP_MAX = 32  # texels
KEPT = {"angle": 0.0, "turns": 0.0, "scale": [1.0, 1.0]}  # fields that a rectangle cannot change


def colours_field(corners: int) -> dict:
    """Returns the field of a polygon for its corners' colours."""
    return {"colours": (rows(colour_and_alpha, 1, corners), None,
                        "a colour a corner, for an N64 material that reads shade")}


def rectangle_fields(far: int) -> dict:
    """Returns the fields of a texture rectangle."""
    steps = number(-STEP_MAX, STEP_MAX - 1 / STEP, "texels a pixel")
    return {"rectangle": (rows(integer(-far, far, unit="pixels"), 4, 4), REQUIRED,
                          "left, top, right, bottom; the last two are not drawn"),
            "texel": (rows(number(-REACH, REACH - 1 / TEXEL, "texels"), 2, 2), [0, 0],
                      f"s and t at the upper left pixel, multiples of 1/{TEXEL}"),
            "step": (rows(steps, 2, 2), [1, 1], f"s to the right and t downwards, multiples of 1/{STEP}"),
            "flip": (flag, False, "s downwards and t to the right instead")}


def kind_of(obj: dict) -> str:
    """Returns an object's kind, one of units.PRIMITIVES."""
    if "rectangle" in obj:
        return "flipped" if obj["flip"] else "rectangles"
    return "coloured" if obj.get("colours") else "polygons"


def whole(values: list[float], parts: int, where: str) -> list[int]:
    """Converts texels to whole parts of a texel; refuses values in between."""
    for i, value in enumerate(values):
        if value * parts % 1:
            fail(f"{where}[{i}]", f"must be a multiple of 1/{parts} texel")
    return [round(value * parts) for value in values]


def check_rectangle(obj: dict, material: dict, where: str) -> None:
    """Refuses a rectangle that is empty, turned, or of a material for polygons only."""
    left, top, right, bottom = obj["rectangle"]
    name = obj["material"]
    if left >= right or top >= bottom:
        fail(f"{where}.rectangle", "is empty: it must be [left, top, right, bottom], the last two "
                                   "behind its last pixel")
    for field, kept in KEPT.items():
        if obj[field] != kept:
            fail(f"{where}.{field}", "a texture rectangle is neither turned nor scaled")
    if n64.looks(material).depth:
        fail(f"{where}.rectangle", f"material {name!r} has perspective, but a texture rectangle no "
                                   "depth")
    if n64.looks(material).shade:
        fail(f"{where}.rectangle", f"material {name!r} reads shade, which a texture rectangle has "
                                   "not")
    copies = n64.copies(material["n64"])
    if copies and obj["flip"]:
        fail(f"{where}.flip", "copy mode does not flip")
    (_, _, s, t, *_), (_, _, dsdx, dtdy, *_) = corners_of(obj, material, where)
    if copies and abs(dsdx) >= STEP * STEP_MAX:
        fail(f"{where}.step[0]", f"copy mode's must be less than {STEP_MAX // 4} texels")
    units.check_range(units.rectangle_ends(
        tuple(obj["rectangle"]), (s, t), (dsdx, dtdy), copies, obj["flip"]), f"{where}.step")


def corners_of(obj: dict, material: dict, where: str) -> np.ndarray:
    """Returns a rectangle's two vertices as the file stores them, int64 [2, 6]."""
    left, top, right, bottom = obj["rectangle"]
    s, t = whole(obj["texel"], TEXEL, f"{where}.texel")
    dsdx, dtdy = whole(obj["step"], STEP, f"{where}.step")
    if n64.copies(material["n64"]):
        dsdx *= 4  # a step is over four pixels in copy mode
    return np.array([[left * ONE, top * ONE, s, t, 0, ONE],
                     [right * ONE, bottom * ONE, dsdx, dtdy, 0, ONE]], np.int64)


def check(obj: dict, material: dict, where: str) -> None:
    """Refuses an object that its material does not draw. ``where``: the object, for messages."""
    kind, name, looks = kind_of(obj), obj["material"], n64.looks(material)
    field = {"polygons": "material", "coloured": "colours"}.get(kind, "rectangle")
    if kind != "polygons" and not looks:
        fail(f"{where}.{field}", f"material {name!r} has no texture engine")
    if kind in units.RECTANGLES:
        check_rectangle(obj, material, where)
    elif looks and n64.copies(material["n64"]):
        fail(f"{where}.material", f"{name!r} is in copy mode, which draws texture rectangles only")
    elif kind == "coloured" and not looks.shade:
        fail(f"{where}.colours", f"material {name!r} reads no shade")
    elif kind == "coloured":
        if obj.get("shades"):
            fail(f"{where}.shades", "there are colours instead")
        corners = obj["sides"] if "sides" in obj else len(obj["vertices"])
        if len(obj["colours"]) != corners:
            fail(f"{where}.colours", f"must have {corners} entries, not {len(obj['colours'])}")


def place(spec: dict) -> None:
    """Sets each material's primitive to the kind of its objects. A material with objects of several
    kinds becomes several materials with the same texture engine."""
    made: dict[str, dict[str, str]] = {name: {} for name in spec["materials"]}
    for obj in spec["objects"]:
        name, kind = obj["material"], kind_of(obj)
        if kind not in made[name]:
            new = f"{name} ({kind})" if made[name] else name
            while made[name] and new in spec["materials"]:
                new += "'"
            if new != name:
                spec["materials"][new] = copy.deepcopy(spec["materials"][name])
            spec["materials"][new]["primitive"] = kind
            made[name][kind] = new
        obj["material"] = made[name][kind]


def shades_of(colours: list[tuple]) -> np.ndarray:
    """Packs colours into vertices' shades, int64 [n]."""
    packed = [int.from_bytes(bytes(colour), "big", signed=True) for colour in colours]
    return np.array(packed, np.int64)


def whole_pixels(poses: np.ndarray) -> np.ndarray:
    """Moves poses, 16.16, to the nearest whole pixels, in place."""
    poses[:, 4:] = poses[:, 4:] + ONE // 2 & -ONE
    return poses


def is_rectangle(obj: dict) -> bool:
    """Returns True if an object is a texture rectangle."""
    return kind_of(obj) in units.RECTANGLES


def is_coloured(material: dict) -> bool:
    """Returns True if a checked material's vertices have colours."""
    return material.get("primitive") == "coloured" and materials.mapper_of(material) == "n64"
