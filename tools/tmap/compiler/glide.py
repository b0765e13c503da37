"""Schema and checks of Glide's texture units in a scene's TOML: materials with a table ``glide``.

Names and values follow Glide where possible; c/glide/glide.h explains them.
"""

import numpy as np

from tmap.base.fields import REQUIRED, Reader, fail, flag, integer, number, one_of, reader, rows, table, text
from tmap.base.fixed import ONE, fix_all
from tmap.glide.state import LAST_LEVEL, REACH, SIDE, SUBDIVISIONS, W_MAX
from tmap.glide.words import FACTORS, FILTERS, FORMATS, FUNCTIONS, LEVELS, WRAPS
from tmap.images.mipmap import FILTERS as MIPMAP_FILTERS
from tmap.scene_file.pipes import PREFILTER_KB

FRAMES = ("rgb565", "rgba8888")  # formats of scenes that units draw into
LEAST_W = 1 / ONE  # least distance of w from 0
NO_MIPMAP = "none"  # only the picture, no further levels
#: The bilinear filter: exact, or replaced by dithered points.
BILINEAR = ("exact", "dithered")
#: How drawn pixels go into the frame: they replace its pixels, or are added to them.
BLENDS = ("replace", "add")
PREFILTER_MOST = 8192  # KB of prefiltered tiles


def quarters(low: float, high: float):
    """Returns the check of a multiple of 1/4 within limits."""
    limits = number(low, high)

    @reader(f"{limits.says}, a multiple of 1/4")
    def check(value, where):
        found = limits(value, where)
        if found * 4 % 1:
            fail(where, "must be a multiple of 1/4")
        return found
    return check


def combine_schema():
    """Returns the check of a unit's functions and factors. Those of alpha default to the
    colour's."""
    function, factor = one_of(*FUNCTIONS), one_of(*FACTORS)
    return table({"function": (function, "local", "what is made of local, the unit's own, and other, the next unit's"),
                  "factor": (factor, "zero", "the factor in it"),
                  "alpha_function": (function, None, "the same for alpha; without it, `function`"),
                  "alpha_factor": (factor, None, "the same for alpha; without it, `factor`"),
                  "invert": (flag, False, "inverts the colour's bits"),
                  "invert_alpha": (flag, False, "inverts alpha's bits")})


def unit_schema() -> Reader:
    """Returns the check of a unit."""
    level, side = integer(0, LAST_LEVEL), integer(1, SIDE, unit="texels")
    detail = table({"bias": (integer(-32, 31), 0, "the level below which the factor grows"),
                    "scale": (integer(0, 7), 0, "how often its growth is doubled"),
                    "max": (number(0, 1), 1, "the limit of the factor")})
    axis = one_of(*WRAPS)
    return table({
        "image": (text, REQUIRED, "a picture, as of `[textures]`"),
        "format": (one_of(*FORMATS), REQUIRED, "of its texels"),
        "width": (side, None, "a power of two; cuts and scales the picture; without it, the picture's own"),
        "height": (side, None, "the same for its height; one side is at most 8 times the other"),
        "mipmap": (one_of(NO_MIPMAP, *MIPMAP_FILTERS), "box", "filter that makes the levels; or one level only"),
        "min": (one_of(*FILTERS), "point", "filter where the map is reduced"),
        "mag": (one_of(*FILTERS), "point", "filter where the map is enlarged"),
        "s": (axis, "wrap", "what is beyond the map's left and right sides"),
        "t": (axis, "wrap", "what is beyond its upper and lower sides"),
        "dither": (flag, False, "spreads the choice of levels"),
        "lod_bias": (quarters(-8, 7.75), 0, "added to each pixel's level"),
        "min_level": (level, None, "the largest level that is drawn; 0 is 256 texels long"),
        "max_level": (level, None, "the smallest level that is drawn"),
        "detail": (detail, {}, "the detail factor"),
        "levels": (one_of(*LEVELS), "both", "which of the map's levels the unit holds"),
        "trilinear": (flag, False, "another unit blends the other levels in"),
        "combine": (combine_schema(), {}, "what the unit passes on"),
        "weights": (one_of_numbers(4, 8), 4, "bits of the bilinear filter's weights; Voodoo 2 has 8"),
        "bilinear": (one_of(*BILINEAR), BILINEAR[0],
                     "the filter, or [points](../../c/polygon/README.md#dithered-points) where they can replace it"),
        "subdivision": (one_of_numbers(*SUBDIVISIONS), 0, "pixels from one divide by w to the next; 0: all are exact"),
        "clamp_w": (flag, False, "makes s and t 0 where w is negative"),
        "own": (flag, False, "the second unit has s and t of its own")})


def one_of_numbers(*numbers: int):
    """Returns the check of one of these whole numbers."""
    @reader(", ".join(map(str, numbers)))
    def check(value, where):
        if type(value) is not int or value not in numbers:
            fail(where, "must be " + " or ".join(map(str, numbers)))
        return value
    return check


def schema() -> Reader:
    """Returns the check of a material's ``glide``."""
    return table({"perspective": (flag, False, "corners have w, a depth"),
                  "blend": (one_of(*BLENDS), BLENDS[0], "drawn pixels replace the frame's, or are added to them"),
                  "prefilter": (integer(0, PREFILTER_MOST, unit="KB"), PREFILTER_KB,
                                "memory for prefiltered tiles; 0: none"),
                  "units": (rows(unit_schema(), 1, 2), REQUIRED, "the units, the first nearest the frame")})


def coordinates_fields(corners: int) -> dict:
    """Returns the fields of a polygon for its corners' coordinates of the second unit, and for
    moving coordinates."""
    place, depth = number(-REACH + 1 / 256, REACH - 1 / 256), number(-W_MAX, W_MAX)
    way = rows(place, 2, 2)
    return {"st1": (rows(rows(place, 2, 2), 3, corners // 2), None,
                    "s and t of each corner for a second Glide unit with `own`"),
            "w1": (rows(depth, 3, corners // 2), None, "w of each corner for that unit, also negative; without it, w"),
            "slide": (way, None, "motion of s and t from frame to frame, of Glide materials"),
            "slide1": (way, None, "the same for a second unit with `own`")}


def has_own(material: dict) -> bool:
    """Returns True if a material's second unit has separate coordinates."""
    return "glide" in material and material["glide"]["units"][-1]["own"]


def check_unit(unit: dict, number_: int, where: str) -> None:
    """Refuses settings of a unit that do not go together; fills in alpha's function and factor."""
    if unit["own"] and not number_:
        fail(f"{where}.own", "is for the second unit: the first goes by the vertices")
    if unit["mipmap"] == NO_MIPMAP and (unit["levels"] != "both" or unit["max_level"] is not None):
        fail(f"{where}.mipmap", f'"{NO_MIPMAP}": there is one level only')
    if unit["trilinear"] and unit["levels"] == "both":
        fail(f"{where}.trilinear", 'needs "levels" even or odd: another unit blends the others in')
    low, high = unit["min_level"], unit["max_level"]
    if low is not None and high is not None and low > high:
        fail(f"{where}.max_level", f"is below min_level, {low}")
    combine = unit["combine"]
    for kind in ("function", "factor"):
        if combine[f"alpha_{kind}"] is None:
            combine[f"alpha_{kind}"] = combine[kind]


def check(glide: dict, where: str) -> None:
    """Refuses settings of units that do not go together; fills in their defaults."""
    for n, unit in enumerate(glide["units"]):
        check_unit(unit, n, f"{where}.units[{n}]")


def with_own(corners: np.ndarray, obj: dict) -> np.ndarray:
    """Returns an object's vertices as the file stores them, int64 [n, 6], then the same number with
    the second unit's coordinates. Their depth is w1, or else the vertices' depth."""
    own = corners.copy()
    own[:, 2:4] = fix_all(obj["st1"])
    own[:, 4] = 0
    if obj["w1"] is not None:
        own[:, 5] = fix_all(obj["w1"])
    return np.concatenate([corners, own])


def slid(corners: np.ndarray, obj: dict, material: dict, age: int, where: str) -> np.ndarray:
    """Returns an object's vertices as the file stores them, ``age`` frames after it appeared."""
    made = corners.copy()
    second = len(made) // 2 if has_own(material) else len(made)
    for field, part in (("slide", made[:second]), ("slide1", made[second:])):
        if obj[field] is not None:
            part[:, 2:4] += fix_all([[age * step for step in obj[field]]])
            check_range((part[:, 2:4] / ONE).tolist(), f"{where}.{field}: frame {age}")
    return made


def slides(obj: dict) -> bool:
    """Returns True if an object's s and t move."""
    return any(obj.get(field) is not None for field in ("slide", "slide1"))


def check_object(obj: dict, material: dict, where: str) -> None:
    """Refuses an object without the coordinates that its material's second unit needs, or with
    coordinates that the material does not use."""
    st, name = obj.get("st1"), obj["material"]
    if obj.get("slide") is not None and "glide" not in material:
        fail(f"{where}.slide", f"material {name!r} has no texture unit of Glide's")
    if not has_own(material):
        for field in ("st1", "w1", "slide1"):
            if obj.get(field) is not None:
                fail(f"{where}.{field}", f"material {name!r} has no second unit with coordinates "
                                         "of its own")
        return
    if "points" in obj or "mesh" in obj:
        return  # checked by tmap.compiler.projectors
    if "sides" not in obj and "vertices" not in obj:
        fail(f"{where}.material", f"{name!r} has a unit with coordinates of its own, which "
                                  "rectangles have not")
    if st is None:
        fail(f"{where}.st1", f"is missing: material {name!r} has a unit with coordinates of its "
                             "own")
    corners = obj["sides"] if "sides" in obj else len(obj["vertices"])
    for field in ("st1", "w1"):
        if obj[field] is not None and len(obj[field]) != corners:
            fail(f"{where}.{field}", f"must have {corners} entries, not {len(obj[field])}")
    for i, w in enumerate(obj["w1"] or []):
        if abs(w) < LEAST_W:
            fail(f"{where}.w1[{i}]", f"must be 1/{ONE} or more away from 0")
    check_range(st, f"{where}.st1")


def check_range(corners: list, where: str) -> None:
    """Refuses corners (s, t) of one polygon that the units cannot draw."""
    for column, noun in enumerate("st"):
        values = [corner[column] for corner in corners]
        if not -REACH < min(values) <= max(values) < REACH:
            fail(where, f"{noun} must be above -{REACH} and below {REACH}")
        if max(values) - min(values) >= REACH:
            fail(where, f"{noun} of two corners: {REACH} apart or more")
