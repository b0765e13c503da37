"""``tmap map``, ``tmap light`` and ``tmap picture``: convert pictures to texture maps in memory layout, make their
light tables, and convert maps back.

A map file holds the texels alone, in the order of c/texture/map.h. FILE.json beside it has width,
height, layout, format and, for chunky maps, the palette. Both ways are exact: a PNG with a palette,
or of at most 256 colours, returns unchanged; other formats keep every colour that they have.
Several pictures share one palette, exact too if their colours are not too many together.
"""

import json
import re
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PIL import Image

from tmap.base import maps, outputs
from tmap.base.errors import UserError
from tmap.base.pixel_formats import FORMATS
from tmap.images import images, palette as colours
from tmap.scene_file.scene_file import size_fault

LAYOUTS = ("linear", "tiled", "columns")
PALETTE = "palette"  # the file beside several maps: 256 entries of 4 bytes, 0, red, green, blue, for screen_palette


def padded(palette: np.ndarray) -> np.ndarray:
    """Pads a palette with black to 256 colours."""
    return np.pad(palette, ((0, 256 - len(palette)), (0, 0)))


def decoded(source: Path, decode: Callable):
    """Returns what ``decode`` makes of a picture's path; raises UserError."""
    try:
        return decode(source)
    except FileNotFoundError:
        raise UserError(f"{source}: no such file") from None
    except Exception as error:  # a damaged file can raise any of the decoders' exceptions
        raise UserError(f"{source}: not a usable PNG or JPEG picture: {error}") from None


def own_indices(path: Path) -> tuple[np.ndarray, bytes] | None:
    """Returns the palette indices, uint8 [height][width], and the palette of a picture that has one."""
    with images.opened(path) as image:
        return (np.array(image), bytes(image.getpalette("RGB"))) if image.mode == "P" else None


def indices(sources: list[Path], most: int = colours.COLOURS) -> tuple[list[np.ndarray], np.ndarray]:
    """Returns palette indices, uint8 [height][width], of pictures, and their palette, uint8 (256, 3), with at most so
    many entries in use; raises UserError. It is the pictures' own if all have the same, else that of their colours."""
    own = [decoded(source, own_indices) for source in sources]
    if all(own) and len({palette for _, palette in own}) == 1 and max(texels.max() for texels, _ in own) < most:
        palette = np.frombuffer(own[0][1], np.uint8).reshape(-1, 3)[:most]
        return [texels for texels, _ in own], padded(palette)
    palette, found = colours.shared([decoded(source, lambda path: np.array(images.decode(path))) for source in sources],
                                    most)
    return found, padded(palette)


def unlaid(texels: np.ndarray, layout: str, width: int, height: int) -> np.ndarray:
    """Returns the picture of texels in memory order."""
    if layout == "linear":
        return texels.reshape(height, width)
    return {"tiled": maps.from_tiled, "columns": maps.from_columns}[layout](texels, width, height)


def light_command(source: Path, out: Path, towards: str) -> int:
    """Writes the light table of a picture's palette: ``out`` and ``out``.json."""
    if not re.fullmatch("#[0-9a-fA-F]{6}", towards):
        raise UserError(f"--towards: {towards!r} is not a colour like #204060")
    (texels,), palette = indices([source])
    darkest = tuple(bytes.fromhex(towards[1:]))
    table = colours.light(palette, darkest)
    out.write_bytes(table.tobytes())
    about = {"width": table.shape[1], "height": table.shape[0], "layout": "light", "format": "chunky",
             "palette": palette.tolist()}
    out.with_name(out.name + ".json").write_text(json.dumps(about) + "\n")
    print(f"{out}: {len(table)} levels of {table.shape[1]} bytes")
    if (share := colours.coarse(texels, palette, darkest)) >= 1 / 2:
        print(f"{out}: warning: the palette has fewer than {len(colours.DIMMED) + 1} shades of the colours of {share:.0%} of "
              f"the picture: light will show steps; a palette with darker entries too has more", file=sys.stderr)
    return 0


def check_names(sources: list[Path]) -> None:
    """Refuses pictures whose maps in one folder would have the same name; the Amiga ignores case."""
    stems = [source.stem.lower() for source in sources]
    for number, stem in enumerate(stems):
        if stem in stems[:number]:
            raise UserError(f"{sources[number]}: its map would have the name of {sources[stems.index(stem)]}'s")


def map_command(sources: list[Path], out: Path, layout: str, pixel: str, most: int | None) -> int:
    """Writes a picture as a map: ``out`` and ``out``.json; or several to a folder, and their palette."""
    if most is not None and pixel != "chunky":
        raise UserError(f"--colours: texels in format {pixel} have no palette")
    if most is not None and not 1 <= most <= colours.COLOURS:
        raise UserError(f"--colours: {most}; a palette has 1 to {colours.COLOURS}")
    if len(sources) > 1:
        check_names(sources)
        outputs.check_directory(out)
    made, palette = FORMATS[pixel], None
    if pixel == "chunky":
        pictures, palette = indices(sources, most or colours.COLOURS)
    else:
        pictures = [made.numbers(decoded(source, lambda path: np.array(images.decode(path, made.channels))))
                    for source in sources]
    for source, (height, width) in zip(sources, (picture.shape for picture in pictures)):
        if needs := size_fault(layout, width, height):
            raise UserError(f"{source}: {width}x{height} texels; layout {layout} needs {needs}")
    if len(sources) == 1:
        write_map(out, pictures[0], layout, pixel, palette)
        tell(out, pictures[0], layout, pixel)
        return 0
    with outputs.replaced(out, (), PALETTE) as folder:
        for source, picture in zip(sources, pictures):
            write_map(folder / f"{source.stem}.map", picture, layout, pixel, palette)
        if palette is not None:
            (folder / PALETTE).write_bytes(np.pad(palette, ((0, 0), (1, 0))).tobytes())
    for source, picture in zip(sources, pictures):
        tell(out / f"{source.stem}.map", picture, layout, pixel)
    return 0


def write_map(out: Path, picture: np.ndarray, layout: str, pixel: str, palette: np.ndarray | None) -> None:
    """Writes one map and what it is."""
    height, width = picture.shape
    about = {"width": width, "height": height, "layout": layout, "format": pixel,
             "palette": None if palette is None else palette.tolist()}
    laid = {"linear": np.ravel, "tiled": maps.to_tiled, "columns": maps.to_columns}[layout](picture)
    out.write_bytes(laid.tobytes())
    out.with_name(out.name + ".json").write_text(json.dumps(about) + "\n")


def tell(out: Path, picture: np.ndarray, layout: str, pixel: str) -> None:
    """Prints what was written."""
    height, width = picture.shape
    print(f"{out}: {width}x{height}, {layout}, {pixel}")


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
