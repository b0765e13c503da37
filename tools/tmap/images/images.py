"""Texture pictures: found, checked and cut to a map's size in RGB."""

import os
import warnings
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from PIL import Image, ImageOps

from tmap.base.errors import UserError

SIDE = 256  # texels of a map's longer side by default
SIDE_LEAST = 8  # of its shorter side
SIDE_MAX = 8192  # pixels; more is a mistake or an attack
PACKAGE = "package:"
NEARLY = 1 / 32  # of a picture's longer side that its map's may be longer
ORIENTATION = 0x0112  # Exif's


def locate(reference: str, folder: Path, where: str) -> Path:
    """Returns the path of the file that a reference names.

    ``package:NAME/path`` is a file in an installed Python package, which is not
    imported; anything else is a path relative to ``folder``, the scene file's.
    """
    if not reference.startswith(PACKAGE):
        path = folder / reference
    else:
        package, _, inside = reference.removeprefix(PACKAGE).partition("/")
        try:
            spec = find_spec(package) if package.isidentifier() else None
        except ValueError:  # a module without a spec, such as __main__
            spec = None
        if spec is None or not spec.submodule_search_locations:
            raise UserError(f"{where}: {reference}: there is no Python package {package!r}")
        path = Path(spec.submodule_search_locations[0]) / inside
    if not os.path.isfile(path):  # unlike Path.is_file, False for impossible names too
        raise UserError(f"{where}: {reference}: no such file")
    return path


def opened(path: Path) -> Image.Image:
    """Opens a PNG or JPEG file without decoding it. Raises ValueError if it is too large, and
    Pillow's exceptions for other faults."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", Image.DecompressionBombWarning)
        image = Image.open(path, formats=("PNG", "JPEG"))
    if not 1 <= min(image.size) <= max(image.size) <= SIDE_MAX:
        width, height = image.size
        image.close()
        raise ValueError(f"{width}x{height} pixels; a side must be from 1 to {SIDE_MAX}")
    return image


def decode(path: Path, mode: str = "RGB") -> Image.Image:
    """Returns the picture in a PNG or JPEG, upright, in Pillow's ``mode``. Raises like
    ``opened``."""
    with opened(path) as image:
        image.load()
        if image.mode.startswith("I"):  # 16-bit grey: Pillow would clip, not scale
            image = Image.fromarray((np.asarray(image, np.int64) >> 8).astype(np.uint8))
        return ImageOps.exif_transpose(image).convert(mode)


def picture(reference: str, folder: Path, where: str, mode: str = "RGB") -> Image.Image:
    """Returns the referenced picture in its own size.

    ``where`` (scene file and field) starts the message of every refusal.
    """
    path = locate(reference, folder, where)
    try:
        return decode(path, mode)
    except Image.UnidentifiedImageError:
        raise UserError(f"{where}: {reference}: not a PNG or JPEG picture") from None
    except Image.DecompressionBombError:
        raise UserError(f"{where}: {reference}: a side must be from 1 to {SIDE_MAX}") from None
    except Exception as error:  # a damaged file fails in as many ways as there are decoders
        text = " ".join(str(error).split()) or type(error).__name__
        raise UserError(f"{where}: {reference}: cannot be read: {text}") from None


def middle(image: Image.Image, width: int, height: int) -> Image.Image:
    """Returns the middle of a picture, cut to the shape of width x height."""
    wide, high = image.size
    cut_wide = max(1, min(wide, high * width // height))
    cut_high = max(1, min(high, wide * height // width))
    left, top = (wide - cut_wide) // 2, (high - cut_high) // 2
    return image.crop((left, top, left + cut_wide, top + cut_high))


def size_like(reference: str, folder: Path, where: str) -> tuple[int, int]:
    """Returns a map's sides, powers of two and the longer one SIDE, as long as a picture but for NEARLY or less, so
    that its middle has all of its shorter side. Those of a square if it cannot be read, which ``picture`` refuses."""
    try:
        with opened(locate(reference, folder, where)) as image:
            wide, high = image.size
            if image.getexif().get(ORIENTATION, 1) > 4:  # lies on its side
                wide, high = high, wide
    except Exception:
        return SIDE, SIDE
    shorter, longer = sorted((wide, high))
    shift = 0
    while shorter << shift + 1 <= longer * (1 + NEARLY) and SIDE >> shift > SIDE_LEAST:
        shift += 1
    return (SIDE, SIDE >> shift) if wide > high else (SIDE >> shift, SIDE)


def fitted(image: Image.Image, width: int, height: int, whole: bool) -> Image.Image:
    """Returns a picture, or the ``middle`` of it, scaled to width x height."""
    image = image if whole else middle(image, width, height)
    return image.resize((width, height), Image.Resampling.LANCZOS)


def load(reference: str, folder: Path, where: str, width: int = SIDE,
         height: int = SIDE, mode: str = "RGB", whole: bool = False) -> np.ndarray:
    """Returns a ``picture``, ``fitted``, as uint8 (height, width, channels), row 0 on top.

    It is resized by Pillow, in integers with weights of 22 bits. A sine's last bit can change a weight
    only if the exact one is halfway between two.
    """
    return np.array(fitted(picture(reference, folder, where, mode), width, height, whole))


def cut_out(reference: str, folder: Path, where: str, width: int = SIDE, height: int = SIDE,
            key: tuple[int, int, int] | None = None, whole: bool = False) -> tuple[np.ndarray, np.ndarray]:
    """Returns the picture that ``load`` returns, and which of its pixels are at least half opaque, bool
    (height, width). ``key``: a colour whose pixels are transparent. Colours are weighted by their alpha, so that
    those of transparent pixels do not show at the edges."""
    image = picture(reference, folder, where, "RGBA")
    if key:
        pixels = np.array(image)
        pixels[(pixels[..., :3] == key).all(axis=-1), 3] = 0
        image = Image.fromarray(pixels)
    made = np.array(fitted(image, width, height, whole))
    return made[..., :3], made[..., 3] >= 128


def is_transparent(reference: str, folder: Path, where: str, width: int = SIDE, height: int = SIDE,
                   whole: bool = False) -> bool:
    """Returns true if pixels are not opaque in the part of a picture that ``load`` takes. It is a picture
    that ``load`` does not refuse."""
    with opened(locate(reference, folder, where)) as image:
        if not image.has_transparency_data:  # most have none and need not be decoded again
            return False
    image = picture(reference, folder, where, "RGBA")
    part = image if whole else middle(image, width, height)
    return part.getchannel("A").getextrema()[0] < 255
