"""The colours of a scene: textures, materials, ramps and the palette they share."""

from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from tmap.base.fields import (REQUIRED, choice, colour, fail, flag, integer, join, number, one_of, rows,
                              table, text)
from tmap.base.fixed import fix
from tmap.base.pixel_formats import FORMATS, PixelFormat
from tmap.build import layout
from tmap.compiler import fog, glide, n64
from tmap.images import images, mipmap, palette
from tmap.scene_file.materials import SETTINGS, Material
from tmap.scene_file.textures import (IN_DEPTH, LAYOUTS, MAPPERS, MAPPER_LAYOUT, MIPMAPPED, ON_PLANE, UNITS, Texture,
                                      size_fault)
from tmap.setup import snapped
from tmap.setup.shading import LIT

SIDE_MAX = 1 << 15  # texels, of any map
TEXELS_MAX = 1 << 20
KEYED = "keyed"  # the mapper
MIPMAPS = ("none", "polygon")
LEVELS = 3  # of mip maps, unless stated
SHADES = 256  # of a vertex: from 0 to 255


def texture_schema():
    """Returns the check of a texture."""
    side = integer(1, SIDE_MAX, unit="texels")
    return table({"image": (text, REQUIRED, "a PNG or JPEG file beside the scene, or `package:NAME/path`, a file of an "
                                            "installed Python package"),
                  "width": (side, None, f"the map's width; without both sides, the longer one is {images.SIDE}, and the "
                                        f"other as well, or {images.SIDE // 2} if the picture is twice as long as wide, "
                                        f"and so on; without one, it is {images.SIDE}"),
                  "height": (side, None, f"the map's height; at most {TEXELS_MAX:,} texels together"),
                  "fit": (one_of("cut", "whole"), "cut", "a picture of other proportions: its middle is cut to the map's "
                                                         "shape, or all of it is stretched to it"),
                  "key": (colour, None, "colour of pixels that the mapper `keyed` leaves out, beside those whose alpha is "
                                        "below a half")})


#: What the settings of a material do.
SAYS = {"edges": "vertices cut to whole pixels; slopes rounded to 1/65536; vertices rounded to 1/16 pixel, then exact; "
                 "exact. Without it, snapped if triangle routines draw all such materials, else exact",
        "gradients": "steps of s, t and shades: of each line; of the longest line, for triangles; of the plane",
        "start": "where a line's first texel is taken: where the edge crosses it, or at the first pixel's centre",
        "clip": "what is off the screen is cut: its lines, or the polygon",
        "perspective": "none; exact every 16 or 8 pixels, with lines between; each pixel, within 1/32 or 1/128 texel"}


def material_schema():
    """Returns the check of a material."""
    settings = {name: (one_of(*SETTINGS[name]), None if name == "edges" else getattr(Material, name), SAYS[name])
                for name in SETTINGS if name != "mapper"} \
        | {"tolerance": (number(0, 1, "texels"), 0, "error that cheaper perspective may cause"),
           "fog": (flag, False, "objects in space fade into the scene's [fog](#fog): a `colour`, or a texture with the "
                                "mapper `lit` or `lit_gouraud`, on which no light shines then")}
    mappers = [mapper for mapper, each in MAPPER_LAYOUT.items() if each]
    levels = layout.load().constants["MIPMAP_LEVELS_MAX"]
    check = choice({
        "texture": {"texture": (text, REQUIRED, "a name of `[textures]`"),
                    "mapper": (one_of(*mappers), "affine", "[the loop that draws it](../../c/polygon/README.md)"),
                    "mipmap": (one_of(*MIPMAPS), "none", "[where texels are smaller than pixels](README.md#mip-maps), "
                                                         "smaller maps are drawn: one a polygon"),
                    "levels": (integer(1, levels), None, "smaller maps, 3 unless the map is too small for that; a level "
                                                         "takes as much memory as the map, 64 KB")},
        "colour": {"colour": (colour, REQUIRED, "one flat colour")},
        "n64": {"n64": (n64.schema(), REQUIRED, "[the N64's texture engine](../../c/n64/README.md)"),
                "mapper": (one_of("n64"), "n64", "may be left out")},
        "glide": {"glide": (glide.schema(), REQUIRED, "[Glide's texture units](../../c/glide/README.md)"),
                  "mapper": (one_of("glide"), "glide", "may be left out")},
        "shades": {"shades": (rows(colour, 2, 2), REQUIRED, "colours of shade 0 and of shade 255"),
                   "steps": (integer(2, 128), 64, "palette entries of the ramp between them")}},
        settings)

    def with_new_words(value, where):
        if isinstance(value, dict) and "tx" in value:
            fail(f"{where}.tx", "is called n64 now")
        if isinstance(value, dict) and value.get("mapper") == "unit":
            fail(f"{where}.mapper", '"unit" is called "n64" now')
        return check(value, where)
    return replace(check, check=with_new_words)


def mapper_of(material: dict) -> str:
    """Returns the mapper of a checked material."""
    return material.get("mapper", "gouraud" if "shades" in material else "flat")


def is_keyed(material: dict) -> bool:
    """Returns true if a checked material has transparent texels."""
    return mapper_of(material) == KEYED


def has_shades(material: dict) -> bool:
    """Returns True if a checked material takes shades from 0 to 255. Gouraud materials do not
    count."""
    looks = n64.looks(material)
    return mapper_of(material) in LIT or bool(looks and looks.shade)


def is_for_triangles(material: dict) -> bool:
    """Returns true if routines for triangles draw a checked material."""
    settings = material["gradients"], material["start"], material["perspective"]
    mapper = mapper_of(material)
    return mapper == "flat" or mapper in snapped.VALUES and mapper != "arbitrary" \
        and settings == ("plane", "subtexel", "none")


def settle_edges(materials: dict[str, dict], once: bool) -> None:
    """Sets the edges of materials that state none, all the same, so that neighbours leave no gap: snapped
    if routines for triangles draw all of them, else exact. ``once``: each pixel is drawn once, which needs
    exact ones."""
    unstated = [m for m in materials.values() if not m["edges"]]
    edges = "snapped" if not once and all(map(is_for_triangles, unstated)) else "exact"
    for material in unstated:
        material["edges"] = edges


def check_units(material: dict, kind: str, frames: tuple[str, ...], pixel: PixelFormat,
                at: str) -> None:
    """Refuses texture units, in the table ``kind``, that do not fit their material or the scene's
    pixels."""
    if pixel.name not in frames:
        fail(f"{at}.{kind}", f"a scene in {pixel.name} has no texture engine of this kind; one in "
                             + " or ".join(frames) + " has")
    for field_ in ("gradients", "start", "perspective"):
        if material[field_] != getattr(Material, field_):
            fail(f"{at}.{field_}", "is not for a texture engine")
    if material["edges"] in ("integer", "snapped"):
        fail(f"{at}.edges", f'"{material["edges"]}" is not for a texture engine')


def check_n64(material: dict, pixel: PixelFormat, at: str) -> None:
    """Refuses a texture engine that does not fit its material or the scene's pixels."""
    check_units(material, "n64", n64.FRAMES, pixel, at)
    if n64.copies(material["n64"]) and pixel.name != n64.COPY_FRAMES:
        fail(f"{at}.n64.cycles", f'"{n64.COPY}" is for scenes in {n64.COPY_FRAMES}')
    n64.check(material["n64"], f"{at}.n64")


def check_settings(material: dict, pixel: PixelFormat, at: str) -> None:
    """Refuses settings that do not go together or do not suit the scene's pixels."""
    mapper, perspective = mapper_of(material), material["perspective"]
    drawn = MAPPERS[pixel.bytes]
    if mapper not in drawn and mapper not in UNITS:
        fail(at + (".shades" if mapper == "gouraud" else ".mapper"),
             f"a scene in {pixel.name} has flat colours and the mapper "
             + " or ".join(f'"{each}"' for each in drawn[1:] if each not in UNITS) + " only")
    if "n64" in material:
        check_n64(material, pixel, at)
    if "glide" in material:
        check_units(material, "glide", glide.FRAMES, pixel, at)
        glide.check(material["glide"], f"{at}.glide")
    on_plane = (material["gradients"], material["start"]) == ("plane", "subtexel")
    if perspective != "none" and not (mapper in IN_DEPTH and on_plane):
        allowed = " or ".join(f'"{each}"' for each in IN_DEPTH)
        fail(f"{at}.perspective", f'"{perspective}" needs the mapper {allowed}, gradients "plane" '
                                  'and start "subtexel"')
    if material["tolerance"] and perspective == "none":
        fail(f"{at}.tolerance", "there is no perspective that could become less")
    if mapper in ON_PLANE and not on_plane:
        fail(f"{at}.mapper", f'"{mapper}" needs gradients "plane" and start "subtexel"')


def check_texture(material: dict, textures: dict[str, dict], at: str) -> None:
    """Refuses a texture that does not exist, or that the material's mapper cannot draw."""
    name, mapper, limits = material["texture"], mapper_of(material), layout.load().constants
    if name not in textures:
        fail(f"{at}.texture", f"there is no texture {name!r}")
    width, height = textures[name]["width"], textures[name]["height"]
    needs = size_fault(MAPPER_LAYOUT[mapper], width, height)
    if needs:
        fail(f"{at}.mapper", f'"{mapper}" needs {needs}; texture {name!r} is {width}x{height}')
    if material["mipmap"] == "none":
        if material["levels"]:
            fail(f"{at}.levels", "there is no mip map")
        return
    if mapper not in MIPMAPPED:
        fail(f"{at}.mipmap", f'"{mapper}" has none; ' + ", ".join(f'"{each}"' for each in MIPMAPPED) + " have")
    most = min(width, height).bit_length() - limits["MAP_SIDE_MIN"].bit_length()
    if not most:
        fail(f"{at}.mipmap", f"texture {name!r} is {width}x{height}; the least side of a level is {limits['MAP_SIDE_MIN']}")
    material["levels"] = material["levels"] or min(most, LEVELS)
    if material["levels"] > most:
        fail(f"{at}.levels", f"texture {name!r} is {width}x{height}: {most} at most")


def settle_sizes(spec: dict, folder: Path, where: str) -> None:
    """Sets the sides of maps that state none. Maps of mappers that take one size only, and of mirrors, are squares."""
    squares = {obj["material"] for obj in spec["objects"] if obj.get("mapping") == "environment"}
    square = {m.get("texture") for name, m in spec["materials"].items()
              if name in squares or MAPPER_LAYOUT.get(m.get("mapper")) in ("tiled", "margins")}
    for name, texture in spec["textures"].items():
        sides = texture["width"], texture["height"]
        if sides == (None, None) and name not in square:
            sides = images.size_like(texture["image"], folder, image_at(spec, name, where))
        texture["width"], texture["height"] = (side or images.SIDE for side in sides)


def check(spec: dict, where: str) -> None:
    """Refuses textures and materials that do not fit each other or the scene's pixels."""
    for name, texture in spec["textures"].items():
        if texture["width"] * texture["height"] > TEXELS_MAX:
            fail(join(f"{where}textures", name) + ".width",
                 f"{texture['width']}x{texture['height']} is more than {TEXELS_MAX} texels")
        if texture["key"] and not any(is_keyed(m) and m["texture"] == name for m in spec["materials"].values()):
            fail(join(f"{where}textures", name) + ".key", f'no material with mapper "{KEYED}" has this texture')
    fog.settle(spec, where)
    settle_edges(spec["materials"], spec["visible"] == "once")
    for name, material in spec["materials"].items():
        at = join(f"{where}materials", name)
        check_settings(material, FORMATS[spec["format"]], at)
        if "texture" in material:
            check_texture(material, spec["textures"], at)


@dataclass
class Pixels:
    """The exact colours of a scene: their pixel values, and the palette's first entries."""

    of: dict[tuple, int]  # flat colour: pixel
    ramps: dict[str, tuple[int, int]]  # material with shades: first entry, steps
    exact: list[tuple[int, int, int]] = field(default_factory=list)


def pixels(spec: dict) -> Pixels:
    """Returns palette entries, or colours in the scene's format."""
    materials = spec["materials"]
    flat = list(dict.fromkeys(filter(None, [spec["background"], *(m.get("colour") for m in materials.values())])))
    ramps = {name: (0, SHADES) for name, m in materials.items() if has_shades(m)}
    if FORMATS[spec["format"]].numbers:
        return Pixels(dict(zip(flat, FORMATS[spec["format"]].flat(flat))), ramps)
    clear = [(0, 0, 0)] * any(map(is_keyed, materials.values()))  # texels of 0 are transparent
    made = Pixels({rgb: i for i, rgb in enumerate(flat, len(clear))}, ramps, clear + flat)
    known = {}
    for name, material in materials.items():
        if "shades" not in material:
            continue
        steps, key = material["steps"], (*material["shades"], material["steps"])
        if key not in known:
            known[key] = len(made.exact)
            low, high = np.array(material["shades"], float)
            part = np.linspace(0, 1, steps)[:, None]
            made.exact += map(tuple, np.rint(low + (high - low) * part).astype(int).tolist())
        made.ramps[name] = known[key], steps
    return made


def shade_pixel(shade: float, ramp: tuple[int, int]) -> float:
    """Returns the pixel coordinate of a shade. It is half a step inside the ramp, so that the
    nearest entry is its floor and rounding cannot leave the ramp."""
    first, steps = ramp
    return first + 0.5 + shade * (steps - 1) / (SHADES - 1)


def image_at(spec: dict, name: str, where: str) -> str:
    """Returns the place of a texture's picture for messages: in the scene, or in a library."""
    return spec["textures"][name].get("at") or join(f"{where}textures", name) + ".image"


def load_pictures(spec: dict, used: set[tuple[str, bool]], folder: Path, where: str
                  ) -> tuple[dict[tuple[str, bool], np.ndarray], dict[int, np.ndarray]]:
    """Returns the pictures in use, uint8 (height, width, channels), by texture and whether some of it is transparent,
    and of the latter by their numbers which pixels are opaque. Unused ones are loaded too, to find their faults."""
    pictures, opaque = {}, {}
    for name, texture in spec["textures"].items():
        at = image_at(spec, name, where)
        source, whole = (texture["image"], folder, at, texture["width"], texture["height"]), texture["fit"] == "whole"
        picture = images.load(*source, FORMATS[spec["format"]].channels, whole)
        if (name, False) in used:
            pictures[name, False] = picture
        if (name, True) in used:
            pictures[name, True], mask = images.cut_out(*source, texture["key"], whole)
            opaque[len(pictures) - 1] = mask
            if not mask.any():
                fail(at, f"{texture['image']} has no opaque pixel")
    return pictures, opaque


def transparent(spec: dict, folder: Path, where: str) -> list[str]:
    """Returns a note on each texture in use that has transparent pixels, but is drawn as it is: no mapper blends them,
    not even in frames that have alpha. Texture units read their own pictures."""
    notes = []
    for name in dict.fromkeys(m["texture"] for m in spec["materials"].values()
                              if "texture" in m and not is_keyed(m)):
        texture, at = spec["textures"][name], image_at(spec, name, where)
        if images.is_transparent(texture["image"], folder, at, texture["width"], texture["height"],
                                 texture["fit"] == "whole"):
            notes.append(f"{at}: {texture['image']} has transparent pixels, which are drawn as they are")
    return notes


def build(spec: dict, made: Pixels, engines: dict[str, int], folder: Path,
          where: str) -> tuple[np.ndarray, list[Texture], list[Material]]:
    """Returns the palette, uint8 (256, 3), the textures, one for each layout in use, and the
    materials. ``engines``: numbers of materials' engines or pipes."""
    textured = [m for m in spec["materials"].values() if "texture" in m]
    wanted = {((m["texture"], is_keyed(m)), MAPPER_LAYOUT[m["mapper"]]) for m in textured}
    dark = {name: tuple(spec["fog"]["colour"]) if fog.is_foggy(m) else (0, 0, 0)
            for name, m in spec["materials"].items() if mapper_of(m) in LIT}
    pictures, opaque = load_pictures(spec, {name for name, _ in wanted}, folder, where)
    halves = {}
    for m in textured:
        halves[m["texture"]] = max(halves.get(m["texture"], 0), m["levels"] or 0)
    smaller = {(name, level): picture for name, most in halves.items() if most
               for level, picture in enumerate(mipmap.levels(pictures[name, False], most), 1)}
    drawn = [*pictures.values(), *smaller.values()]
    pixel = FORMATS[spec["format"]]
    if pixel.numbers:
        colours = np.zeros((256, 3), np.uint8)
        texels = [pixel.numbers(picture).astype(pixel.dtype) for picture in drawn]
    else:
        colours, texels = palette.build(made.exact, drawn, f"{where}materials",
                                        [(picture, towards) for (name, _), picture in pictures.items()
                                         for towards in sorted({dark[each] for each in dark
                                                                if spec["materials"][each]["texture"] == name})], opaque)
    stored, number = [], {}
    for name, array in zip(pictures, texels):
        for layout_ in LAYOUTS:
            if (name, layout_) in wanted:
                number[name, layout_] = len(stored)
                stored.append(Texture(array, layout_, name[0]))
    light = {towards: len(stored) + k for k, towards in enumerate(dict.fromkeys(dark.values()))}
    stored += [Texture(palette.light(colours, towards), "light", "(fog)" if any(towards) else "(light)") for towards in light]
    first = len(stored)
    stored += [Texture(array, "page", name) for (name, _), array in zip(smaller, texels[len(pictures):])]
    looks = [
        Material(mapper_of(m), m["edges"], m["gradients"], m["start"], m["clip"], m["perspective"],
                 number[(m["texture"], is_keyed(m)), MAPPER_LAYOUT[m["mapper"]]] if "texture" in m else -1,
                 made.of[m["colour"]] if "colour" in m else 0,
                 light[dark[name]] if name in dark else -1, fix(m["tolerance"]),
                 engines.get(name, -1), m.get("primitive", "polygons"))
        for name, m in spec["materials"].items()]
    return colours, stored, with_levels(looks, spec, {key: first + k for k, key in enumerate(smaller)})


def with_levels(looks: list[Material], spec: dict, smaller: dict[tuple[str, int], int]) -> list[Material]:
    """Returns materials, and behind them those of the levels of their mip maps. ``smaller``: the textures of levels, by
    their texture and level."""
    made, behind = [], []
    for look, m in zip(looks, spec["materials"].values()):
        count = m.get("levels") or 0
        made.append(replace(look, levels=count, level=(len(looks) + len(behind)) if count else 0))
        behind += [replace(look, texture=smaller[m["texture"], level + 1]) for level in range(count)]
    return made + behind
