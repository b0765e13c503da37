"""The makers of the meshes and pictures of tests/scenes that were computed, byte for byte.

``python -m tmap.assets`` writes all FILES. ``scripts/tmap readme`` makes the rendered pictures.
"""

import io
from collections.abc import Callable
from functools import partial

import numpy as np
from PIL import Image

from tmap.assets import hall, keep, light, meshes, mist, plants, rooms, signs, surfaces, views


def rounded(picture: np.ndarray) -> Image.Image:
    """Rounds levels to bytes."""
    return Image.fromarray(np.clip(np.rint(picture), 0, 255).astype(np.uint8))


def png(image: Image.Image) -> bytes:
    """Returns a picture as a PNG file."""
    file = io.BytesIO()
    image.save(file, "PNG", optimize=True)
    return file.getvalue()


def plain(make: Callable[[], np.ndarray]) -> bytes:
    """Returns the PNG file of a maker's picture."""
    return png(rounded(make()))


def checker() -> bytes:
    """Returns the checker with a palette, in the order of signs.CHECKER."""
    picture = rounded(signs.checker())
    return png(picture.quantize(palette=palette_of(signs.CHECKER), dither=Image.Dither.NONE))


def palette_of(colours: tuple[tuple[int, int, int], ...]) -> Image.Image:
    """Returns an image with these colours as its palette, for quantize."""
    image = Image.new("P", (1, 1))
    image.putpalette(np.array(colours, np.uint8).tobytes())
    return image


def sunset() -> bytes:
    """Returns the sunset in some 90 colours: the demo's scenes share a palette of 256."""
    cut = Image.fromarray(np.clip(views.sunset(), 0, 255).astype(np.uint8))
    return png(cut.quantize(96).convert("RGB").quantize(96))


def few(make: Callable[[], np.ndarray]) -> bytes:
    """Returns the PNG file of a maker's picture in 24 colours: scenes with many share a palette of 256."""
    return png(rounded(make()).quantize(24, dither=Image.Dither.NONE))


def size(side: int) -> bytes:
    """Returns a square map for Glide's sizes."""
    if side < 8:
        return png(rounded(signs.smallest(side)))
    return png(rounded(signs.size(side, signs.SIZES[side])).quantize(64, dither=Image.Dither.NONE))


def aspect_name(width: int, height: int) -> str:
    """Returns the name in tests/scenes/glide_aspects.toml."""
    return f"glide/aspect_{max(width // height, 1)}_{max(height // width, 1)}.png"


PICTURES = {"n64/bricks.png": surfaces.bricks, "n64/planks.png": surfaces.planks,
            "n64/plaster.png": surfaces.panels, "n64/pavement.png": surfaces.pavement,
            "n64/grain.png": surfaces.speckles, "n64/waves.png": surfaces.waves,
            "n64/landscape.png": views.landscape, "n64/painting.png": views.painting,
            "pine.png": plants.pine, "bush.png": plants.bush,
            "n64/letter.png": signs.letter, "n64/medallion.png": signs.medallion,
            "n64/palettes.png": signs.palettes,
            "glide/stones.png": surfaces.stones, "glide/rough.png": surfaces.rough,
            "glide/grass.png": surfaces.grass, "glide/boards.png": surfaces.boards,
            "glide/plaster.png": surfaces.wainscot, "glide/window.png": views.window,
            "glide/pane.png": views.pane, "glide/light.png": light.hall,
            "glide/light_end.png": light.end}

# The maker of each file, by its path in tests/scenes.
FILES: dict[str, Callable[[], bytes]] = {
    "checker.png": checker, "demo/sunset.png": sunset, **hall.FILES, **meshes.FILES, **rooms.FILES,
    **keep.FILES, **mist.FILES, **{name: partial(few, make) for name, make in (keep.PICTURES | mist.PICTURES).items()},
    **{name: partial(plain, make) for name, make in PICTURES.items()},
    **{aspect_name(*shape): partial(plain, partial(signs.aspect, *shape, tint))
       for shape, tint in signs.ASPECTS.items()},
    **{f"glide/size_{side}.png": partial(size, side) for side in (*signs.SIZES, 4, 2, 1)}}
