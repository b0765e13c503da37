"""``tmap map``, ``tmap light`` and ``tmap picture``: convert pictures to texture maps in memory layout, make their
light tables, and convert maps back.

A map file holds the texels alone, in the order of c/texture/map.h. FILE.json beside it has width,
height, layout, format and, for chunky maps, the palette. Both ways are exact: a PNG with a palette,
or of at most 256 colours, returns unchanged; other formats keep every colour that they have.
"""

import json
import re
from pathlib import Path

import numpy as np
from PIL import Image

from tmap.base import maps
from tmap.base.errors import UserError
from tmap.base.pixel_formats import FORMATS
from tmap.images import images, palette as colours
from tmap.scene_file.scene_file import size_fault

LAYOUTS = ("linear", "tiled", "columns")


def padded(palette: np.ndarray) -> np.ndarray:
    """Pads a palette with black to 256 colours."""
    return np.pad(palette, ((0, 256 - len(palette)), (0, 0)))


def indices(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Returns palette indices, uint8 [height][width], and the palette, uint8 (256, 3), of a PNG or
    JPEG. They are the picture's own or, without a palette, those of its colours in order; more than
    256 colours are reduced to 256."""
    with images.opened(path) as image:
        if image.mode == "P":
            found = np.array(image.getpalette("RGB"), np.uint8).reshape(-1, 3)
            return np.array(image), padded(found)
    image = images.decode(path)
    pixels = np.array(image)
    colours, where = np.unique(pixels.reshape(-1, 3), axis=0, return_inverse=True)
    if len(colours) > 256:
        reduced = image.quantize(256, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
        colours = np.array(reduced.getpalette(), np.uint8).reshape(-1, 3)
        where = np.array(reduced)
    return where.reshape(pixels.shape[:2]).astype(np.uint8), padded(colours)


def unlaid(texels: np.ndarray, layout: str, width: int, height: int) -> np.ndarray:
    """Returns the picture of texels in memory order."""
    if layout == "linear":
        return texels.reshape(height, width)
    return {"tiled": maps.from_tiled, "columns": maps.from_columns}[layout](texels, width, height)


def read(source: Path, pixel: str) -> tuple[np.ndarray, np.ndarray | None]:
    """Returns a picture's texels and, for chunky ones, its palette; raises UserError."""
    try:
        if pixel == "chunky":
            return indices(source)
        made = FORMATS[pixel]
        return made.numbers(np.array(images.decode(source, made.channels))), None
    except FileNotFoundError:
        raise UserError(f"{source}: no such file") from None
    except Exception as error:  # a damaged file can raise any of the decoders' exceptions
        raise UserError(f"{source}: not a usable PNG or JPEG picture: {error}") from None


def light_command(source: Path, out: Path, towards: str) -> int:
    """Writes the light table of a picture's palette: ``out`` and ``out``.json."""
    if not re.fullmatch("#[0-9a-fA-F]{6}", towards):
        raise UserError(f"--towards: {towards!r} is not a colour like #204060")
    _, palette = read(source, "chunky")
    darkest = tuple(bytes.fromhex(towards[1:]))
    table = colours.light(palette, darkest)
    out.write_bytes(table.tobytes())
    about = {"width": table.shape[1], "height": table.shape[0], "layout": "light", "format": "chunky",
             "palette": palette.tolist()}
    out.with_name(out.name + ".json").write_text(json.dumps(about) + "\n")
    print(f"{out}: {len(table)} levels of {table.shape[1]} bytes")
    return 0


def map_command(source: Path, out: Path, layout: str, pixel: str) -> int:
    """Writes a picture as a map: ``out`` and ``out``.json."""
    picture, palette = read(source, pixel)
    height, width = picture.shape
    needs = size_fault(layout, width, height)
    if needs:
        raise UserError(f"{source}: {width}x{height} texels; layout {layout} needs {needs}")
    about = {"width": width, "height": height, "layout": layout, "format": pixel,
             "palette": None if palette is None else palette.tolist()}
    laid = {"linear": np.ravel, "tiled": maps.to_tiled, "columns": maps.to_columns}[layout](picture)
    out.write_bytes(laid.tobytes())
    out.with_name(out.name + ".json").write_text(json.dumps(about) + "\n")
    print(f"{out}: {width}x{height}, {layout}, {pixel}")
    return 0


def picture_command(source: Path, out: Path) -> int:
    """Writes a map as a PNG."""
    side = source.with_name(source.name + ".json")
    try:
        about = json.loads(side.read_text())
        width, height = (int(about[key]) for key in ("width", "height"))
        layout, pixel = str(about["layout"]), str(about["format"])
        palette = np.array(about["palette"] or [], np.uint8).reshape(-1, 3)
    except (ValueError, KeyError, TypeError, OverflowError, RecursionError) as error:
        raise UserError(f"{side}: not what tmap map writes: {error}") from None
    if layout not in LAYOUTS or pixel not in FORMATS:
        raise UserError(f"{side}: layout {layout!r} in format {pixel!r} is not known")
    if len(palette) > 256:
        raise UserError(f"{side}: palette: has {len(palette)} colours, more than 256")
    if needs := size_fault(layout, width, height):
        raise UserError(f"{side}: {width}x{height} texels; layout {layout} needs {needs}")
    data, made = source.read_bytes(), FORMATS[pixel]
    if len(data) != width * height * made.bytes:
        raise UserError(f"{source}: has {len(data)} bytes, {side.name} says {width}x{height} texels of "
                        f"{made.bytes}")
    texels = np.frombuffer(data, made.dtype.newbyteorder(">"))
    picture = unlaid(texels, layout, width, height)
    if pixel == "chunky":
        image = Image.fromarray(picture, "P")
        image.putpalette(palette.tobytes())
    else:
        image = Image.fromarray(made.colours(picture))
    image.save(out)
    print(f"{out}: {width}x{height}")
    return 0
