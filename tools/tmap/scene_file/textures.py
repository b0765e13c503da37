"""Maps in scene files: their layouts, sizes and texels.

Formats are defined in c/scene/scene_file.h.
"""

from dataclasses import dataclass, field

import numpy as np

from tmap.base import c_lists, maps
from tmap.base.errors import UserError, require
from tmap.base.pixel_formats import PixelFormat
from tmap.build import layout

#: What c/polygon/mapper_list.h says of each mapper: layout, bytes of its pixels, traits.
LISTED = {name: (layout, bytes_, traits)
          for _, name, layout, bytes_, traits, *_ in c_lists.rows("polygon/mapper_list.h", "MAPPER")}
#: A mapper and the layout of its maps, by their names without MAPPER_ and MAP_.
MAPPER_LAYOUT = {name: None if map_ == "MAP_LAYOUTS" else map_.removeprefix("MAP_").lower()
                 for name, (map_, _, _) in LISTED.items()}
LAYOUTS = ("page", "linear", "tiled", "columns", "margins", "light")
#: Mappers that are texture units.
UNITS = tuple(name for name, (*_, traits) in LISTED.items() if "MAPPER_UNIT" in traits)
#: What draws pixels of so many bytes.
MAPPERS = {size: tuple(name for name, (_, sizes, _) in LISTED.items() if str(size) in sizes)
           for size in (1, 2, 4)}
#: Mappers whose map repeats in both directions: their coordinates may leave it.
REPEATING = tuple(name for name, layout in MAPPER_LAYOUT.items() if layout not in (None, "linear"))
#: Mappers that draw mip maps.
MIPMAPPED = tuple(name for name, layout in MAPPER_LAYOUT.items() if layout == "page" and name != "keyed")
#: Mappers whose u and v come from one plane, to each first pixel.
ON_PLANE = tuple(name for name, (*_, traits) in LISTED.items() if "MAPPER_PLANE" in traits)
#: Mappers that draw perspective.
IN_DEPTH = tuple(name for name, (*_, traits) in LISTED.items() if "MAPPER_PERSPECTIVE" in traits)
#: The format with 2 bytes a pixel that each kind of unit draws.
UNIT_FORMATS = {"n64": "rgba5551", "glide": "rgb565"}


@dataclass(eq=False, frozen=True)
class Texture:
    """A map, and the layout its mapper reads."""

    texels: np.ndarray = field(repr=False)  # (height, width): [t][s], of the scene's pixels
    layout: str = "page"  # of LAYOUTS
    name: str = ""  # the scene's, for messages
    maps: int = 1  # more: a page that they share

    def __eq__(self, other) -> bool:
        return self.layout == other.layout and np.array_equal(self.texels, other.texels)


def size_fault(kind: str, width: int, height: int) -> str | None:
    """Returns a text on the sizes that a layout allows, or None if this size is one of them."""
    limits = layout.load().constants
    least, page, most = (limits[n] for n in ("MAP_SIDE_MIN", "MAP_PAGE_SIDE", "MAP_LINEAR_MAX"))
    low, high = sorted((width, height))
    powers = not width & width - 1 and not height & height - 1
    if kind == "page":
        fits = powers and least <= low <= high <= page
        return None if fits else f"sides that are powers of two from {least} to {page}"
    if kind == "linear":
        return None if 1 <= low <= high <= most else f"sides from 1 to {most}"
    if kind == "columns":
        texels = 1 << limits["MAP_COLUMNS_BITS"]
        fits = powers and least <= low and width * height <= texels
        return None if fits else (f"sides that are powers of two from {least} and at most "
                                  f"{texels} texels")
    if kind == "light":
        levels = limits["LIGHT_LEVELS"]
        return None if (width, height) == (page, levels) else f"{page}x{levels}"
    return None if low == high == page else f"{page}x{page}"


def check_texture(texture: Texture, pixel: PixelFormat, name: str, where: str) -> None:
    """Refuses a map that no mapper can draw."""
    drawn = [MAPPER_LAYOUT[mapper] for mapper in MAPPERS[pixel.bytes]]
    if texture.layout not in drawn and not (texture.layout == "light" and pixel.bytes == 1):
        raise UserError(f"{name}: {where}.layout: {texture.layout!r} is not for these pixels")
    if texture.texels.dtype != pixel.dtype:
        raise UserError(f"{name}: {where}.texel_bytes: {texture.texels.itemsize} "
                        f"where {pixel.bytes} is right")
    height, width = texture.texels.shape
    needs = size_fault(texture.layout, width, height)
    if needs:
        raise UserError(f"{name}: {where}.width or height: {width}x{height} is not {needs}")


def check_on_map(corners: np.ndarray, texture: Texture, name: str, where: str) -> None:
    """Refuses corners, rows of s and t in 16.16, outside a map that does not repeat."""
    height, width = texture.texels.shape
    for s, t in corners.tolist():
        for noun, value, side in (("s", s, width), ("t", t, height)):
            require(name, f"{where}: {noun}", value, 0, 256 << 16)
            require(name, f"{where}: texel of {noun}", value * max(width, height) >> 8, 0,
                    side << 16)


def ordered(texture: Texture) -> bytes:
    """Returns the texels as the file stores them: in the layout's order, big-endian."""
    texels = texture.texels.astype(texture.texels.dtype.newbyteorder(">"))
    if texture.layout == "tiled":
        texels = maps.to_tiled(texels)
    elif texture.layout == "columns":
        texels = maps.to_columns(texels)
    return texels.tobytes()
