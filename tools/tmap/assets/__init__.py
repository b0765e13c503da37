"""``python -m tmap.assets``: the meshes and pictures of tests/scenes that were computed, byte for
byte; FILES has them all. Pictures of what was drawn are not among them: ``scripts/tmap readme``."""

import io
from collections.abc import Callable
from functools import partial

import numpy as np
from PIL import Image

from tmap.assets import light, meshes, signs, surfaces, views


def rounded(picture: np.ndarray) -> Image.Image:
    """Levels to bytes."""
    return Image.fromarray(np.clip(np.rint(picture), 0, 255).astype(np.uint8))


def png(image: Image.Image) -> bytes:
    """A picture as file."""
    file = io.BytesIO()
    image.save(file, "PNG", optimize=True)
    return file.getvalue()


def plain(make: Callable[[], np.ndarray]) -> bytes:
    """The file of a maker's picture."""
    return png(rounded(make()))


def checker() -> bytes:
    """In a palette, in the order of its colours' making."""
    picture = rounded(signs.checker())
    return png(picture.quantize(palette=palette_of(signs.CHECKER), dither=Image.Dither.NONE))


def palette_of(colours: tuple[tuple[int, int, int], ...]) -> Image.Image:
    """A picture with these colours, for quantize."""
    image = Image.new("P", (1, 1))
    image.putpalette(np.array(colours, np.uint8).tobytes())
    return image


def sunset() -> bytes:
    """Some 90 colours: the demo's palette has 256 for all."""
    cut = Image.fromarray(np.clip(views.sunset(), 0, 255).astype(np.uint8))
    return png(cut.quantize(96).convert("RGB").quantize(96))


def size(side: int) -> bytes:
    """A square map of Glide's sizes."""
    if side < 8:
        return png(rounded(signs.smallest(side)))
    return png(rounded(signs.size(side, signs.SIZES[side])).quantize(64, dither=Image.Dither.NONE))


def aspect_name(width: int, height: int) -> str:
    """As in tests/scenes/glide_aspects.toml."""
    return f"tmu/aspect_{max(width // height, 1)}_{max(height // width, 1)}.png"


PICTURES = {"tx/bricks.png": surfaces.bricks, "tx/planks.png": surfaces.planks,
            "tx/plaster.png": surfaces.panels, "tx/pavement.png": surfaces.pavement,
            "tx/grain.png": surfaces.speckles, "tx/waves.png": surfaces.waves,
            "tx/landscape.png": views.landscape, "tx/painting.png": views.painting,
            "tx/letter.png": signs.letter, "tx/medallion.png": signs.medallion,
            "tx/palettes.png": signs.palettes,
            "tmu/stones.png": surfaces.stones, "tmu/rough.png": surfaces.rough,
            "tmu/grass.png": surfaces.grass, "tmu/boards.png": surfaces.boards,
            "tmu/plaster.png": surfaces.wainscot, "tmu/window.png": views.window,
            "tmu/pane.png": views.pane, "tmu/light.png": light.hall,
            "tmu/light_end.png": light.end}

# How to make each file, by its path in tests/scenes.
FILES: dict[str, Callable[[], bytes]] = {
    "checker.png": checker, "demo/sunset.png": sunset, **meshes.FILES,
    **{name: partial(plain, make) for name, make in PICTURES.items()},
    **{aspect_name(*shape): partial(plain, partial(signs.aspect, *shape, tint))
       for shape, tint in signs.ASPECTS.items()},
    **{f"tmu/size_{side}.png": partial(size, side) for side in (*signs.SIZES, 4, 2, 1)}}
