"""Materials in scene files: their settings, and checks for everything the Amiga would refuse.

Formats are defined in c/scene/scene_file.h.
"""

from dataclasses import dataclass, replace

from tmap.base.errors import UserError, require
from tmap.base.pixel_formats import PixelFormat
from tmap.build import layout
from tmap.scene_file.textures import (IN_DEPTH, MAPPERS, MAPPER_LAYOUT, MIPMAPPED, ON_PLANE, UNITS,
                                      UNIT_FORMATS)
from tmap.scene_file.units import PRIMITIVES
from tmap.setup.shading import LIT

#: The settings of a material by their names, and the prefix of each one's enumerators.
SETTINGS = {"mapper": tuple(MAPPER_LAYOUT), "edges": ("integer", "subpixel", "snapped", "exact"),
            "gradients": ("scanline", "polygon", "plane"), "start": ("truncated", "subtexel"),
            "clip": ("scissor", "vertices"),
            "perspective": ("none", "every16", "every8", "pixel", "fine")}


@dataclass(frozen=True)
class Material:
    """A polygon's drawing settings: struct scene_material, enumerators by name."""

    mapper: str = "flat"
    edges: str = "subpixel"
    gradients: str = "plane"
    start: str = "subtexel"
    clip: str = "scissor"
    perspective: str = "none"
    texture: int = -1  # index, or NO_TEXTURE
    colour: int = 0  # pixel
    light: int = -1  # index of a light table, or NO_TEXTURE
    tolerance: int = 0  # 16.16 texels of error that cheaper perspective may cause
    unit: int = -1  # index of a texture engine or a pipe, or NO_UNIT
    primitive: str = "polygons"  # kind of an engine's objects: of PRIMITIVES
    levels: int = 0  # of its mip map, beyond the map itself: materials from ``level`` on
    level: int = 0


def number_of(kind: str, value: str, name: str, where: str) -> int:
    """Returns the number of a setting."""
    if value not in SETTINGS[kind]:
        raise UserError(f"{name}: {where}: {value!r} is not one of {', '.join(SETTINGS[kind])}")
    return SETTINGS[kind].index(value)


def check_settings(material: Material, name: str, where: str) -> None:
    """Refuses settings that are unknown or do not go together."""
    for kind in SETTINGS:
        number_of(kind, getattr(material, kind), name, f"{where}.{kind}")
    on_plane = (material.gradients, material.start) == ("plane", "subtexel")
    if material.perspective != "none" and not (material.mapper in IN_DEPTH and on_plane):
        raise UserError(f"{name}: {where}.perspective: {material.perspective!r} needs mapper "
                        f"{' or '.join(map(repr, IN_DEPTH))}, gradients 'plane' and start 'subtexel'")
    if material.mapper in ON_PLANE and not on_plane:
        raise UserError(f"{name}: {where}.mapper: {material.mapper!r} needs gradients 'plane' and "
                        "start 'subtexel'")
    most = layout.load().constants["TOLERANCE_MAX"] if material.perspective != "none" else 0
    require(name, f"{where}.tolerance", material.tolerance, 0, most)


def check_pixels(pixel: PixelFormat, material: Material, name: str, where: str) -> None:
    """Refuses a material that cannot draw a scene's pixels."""
    if pixel.bytes == 2 and pixel.name != UNIT_FORMATS.get(material.mapper, pixel.name):
        raise UserError(f"{name}: {where}.mapper: {material.mapper!r} is not for {pixel.name}")
    if material.mapper not in MAPPERS[pixel.bytes]:
        raise UserError(f"{name}: {where}.mapper: {material.mapper!r} is not for pixels of "
                        f"{pixel.bytes} bytes")
    require(name, f"{where}.colour", material.colour, 0, 256**pixel.bytes - 1)


def check_unit(scene, material: Material, name: str, where: str) -> None:
    """Refuses a texture unit that does not exist, and a primitive that the mapper does not draw."""
    none = layout.load().constants["NO_UNIT"]
    if material.mapper in UNITS:
        there = scene.units if material.mapper == "n64" else scene.pipes
        require(name, f"{where}.unit", material.unit, 0, len(there) - 1)
        if material.edges in ("integer", "snapped"):
            raise UserError(f"{name}: {where}.edges: 'integer' is not for a texture unit")
    else:
        require(name, f"{where}.unit", material.unit, none, none)
    primitives = PRIMITIVES if material.mapper == "n64" else PRIMITIVES[:1]
    if material.primitive not in primitives:
        raise UserError(f"{name}: {where}.primitive: {material.primitive!r} is not for mapper "
                        f"{material.mapper!r}")


def check_maps(scene, material: Material, name: str, where: str) -> None:
    """Refuses a texture or a light table with another layout than the mapper's."""
    none = layout.load().constants["NO_TEXTURE"]
    light = "light" if material.mapper in LIT else None
    for kind, index, wanted in (("texture", material.texture, MAPPER_LAYOUT[material.mapper]),
                                ("light", material.light, light)):
        if wanted is None:
            require(name, f"{where}.{kind}", index, none, none)
            continue
        require(name, f"{where}.{kind}", index, 0, len(scene.textures) - 1)
        found = scene.textures[index].layout
        if found != wanted:
            raise UserError(f"{name}: {where}.{kind}: its layout is {found}, not {wanted}")


def check_levels(scene, material: Material, name: str, where: str) -> None:
    """Refuses levels of a mip map that differ from their material in more than the map, half as large as the one
    before."""
    where, most = f"{where}.levels", layout.load().constants["MIPMAP_LEVELS_MAX"]
    require(name, where, material.levels, 0, most if material.mapper in MIPMAPPED else 0)
    if not material.levels:
        require(name, f"{where}: first", material.level, 0, 0)
        return
    own = max(k for k, each in enumerate(scene.materials) if each == material)
    require(name, f"{where}: first", material.level, own + 1, len(scene.materials) - material.levels)
    whole = scene.textures[material.texture].texels.shape
    for level in scene.materials[material.level:material.level + material.levels]:
        require(name, f"{where}: texture", level.texture, 0, len(scene.textures) - 1)
        half = scene.textures[level.texture].texels.shape
        if replace(level, texture=material.texture) != replace(material, levels=0, level=0) \
                or [2 * side for side in half] != list(whole):
            raise UserError(f"{name}: {where}: they differ from their material in more than maps, each half as large "
                            "as the one before")
        whole = half


def check(scene, material: Material, name: str, where: str) -> None:
    """Refuses a material that a scene (tmap.scene_file.scene_file) cannot have."""
    check_settings(material, name, where)
    check_unit(scene, material, name, where)
    check_pixels(scene.pixel, material, name, where)
    check_maps(scene, material, name, where)
    check_levels(scene, material, name, where)
