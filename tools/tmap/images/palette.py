"""One palette for a whole scene, and its textures as indices into it."""

import numpy as np
from PIL import Image

from tmap.base.fields import fail
from tmap.build import layout

COLOURS = 256
EXACT_MAX = 192  # most entries for exact colours if there are textures
DIMMED = (3 / 4, 1 / 2, 1 / 4, 0)  # levels of light in which lit pictures are counted too
AT_ONCE = 16384  # colours whose distances are computed together: 16 MB of distances
PACK = np.array([65536, 256, 1])  # of red, green, blue in a number
EVERY_PIXEL = 128 * 128  # pixels of the largest picture that is sampled fully, not by a quarter


def nearest(pixels: np.ndarray, palette: np.ndarray) -> np.ndarray:
    """Returns the palette index nearest to each pixel, the lowest of equals.

    pixels uint8 (..., 3), palette uint8 (n, 3); result uint8 (...). Squares and
    products stay below 2^24, so float32 holds them exactly on every machine.
    """
    packed = pixels.reshape(-1, 3) @ PACK
    colours, where = np.unique(packed, return_inverse=True)
    colours = np.stack([colours >> 16, colours >> 8 & 255, colours & 255], axis=1)
    entries = palette.astype(np.float32)
    length = (entries * entries).sum(axis=1)
    found = np.empty(len(colours), np.uint8)
    for start in range(0, len(colours), AT_ONCE):
        some = slice(start, start + AT_ONCE)
        found[some] = np.argmin(length - 2 * (colours[some].astype(np.float32) @ entries.T), axis=1)
    return found[where].reshape(pixels.shape[:-1])


def sample(picture: np.ndarray) -> np.ndarray:
    """Returns sample pixels (n, 3) of the picture: as good as all of them, four times quicker."""
    if picture.size <= 3 * EVERY_PIXEL:
        return picture.reshape(-1, 3)
    t, s = np.indices(picture.shape[:2])
    return picture[(s + t) % 4 == 0]  # from every row and column


def reduced(samples: list[np.ndarray], most: int) -> np.ndarray:
    """Returns at most so many colours, uint8 (n, 3), that serve samples (n, 3) of several pictures."""
    together = Image.fromarray(np.concatenate(samples)[None])
    found = together.quantize(most, Image.Quantize.MEDIANCUT, kmeans=1, dither=Image.Dither.NONE)
    return np.array(found.getpalette(), np.uint8).reshape(-1, 3)[:most]


def shared(pictures: list[np.ndarray], most: int) -> tuple[np.ndarray, list[np.ndarray]]:
    """Returns at most so many colours, uint8 (n, 3), that pictures, uint8 (height, width, 3), share, and the pictures
    as indices of them. They are the pictures' own colours in order; if these are more, they are reduced."""
    own = np.unique(np.concatenate([np.unique(picture.reshape(-1, 3) @ PACK) for picture in pictures]))
    colours = np.stack([own >> 16, own >> 8 & 255, own & 255], axis=1).astype(np.uint8)
    if len(own) > most:
        colours = reduced([sample(picture) for picture in pictures], most)
    return colours, [nearest(picture, colours) for picture in pictures]


def mixed(colours: np.ndarray, part, towards: tuple[int, int, int] = (0, 0, 0)) -> np.ndarray:
    """Returns colours, uint8 (..., 3), of which ``part`` is left: the rest is another colour, or black."""
    dark = np.array(towards, float)
    return np.rint(dark + (colours - dark) * part).astype(np.uint8)


def light(palette: np.ndarray, towards: tuple[int, int, int] = (0, 0, 0)) -> np.ndarray:
    """Returns the light table of a palette, uint8 (LIGHT_LEVELS, 256): at each level, the index
    nearest to each darkened entry, from black, or the fog's colour, at level 0 to the entry itself at the
    last one."""
    levels = layout.load().constants["LIGHT_LEVELS"]
    part = np.arange(levels)[:, None, None] / (levels - 1)
    table = nearest(mixed(palette, part, towards), palette)
    table[-1] = np.arange(COLOURS)
    return table


def coarse(texels: np.ndarray, palette: np.ndarray, towards: tuple[int, int, int] = (0, 0, 0)) -> float:
    """Returns the share of a picture's pixels whose colours have few shades in its palette's light table: fewer than the
    light that ``build`` counts lit pictures in, and their own. Colours near the darkest one need none."""
    shades = np.array([len(np.unique(column)) for column in light(palette, towards).T])
    far = abs(palette.astype(int) - towards).max(axis=1) >= COLOURS // len(DIMMED)
    return float(((shades < len(DIMMED) + 1) & far)[texels].mean())


def build(exact: list[tuple[int, int, int]], pictures: list[np.ndarray], where: str,
          lit: list[tuple[np.ndarray, tuple[int, int, int]]] = (), opaque: dict[int, np.ndarray] = {}) -> tuple[np.ndarray, list[np.ndarray]]:
    """Returns the palette, uint8 (256, 3), and the textures, uint8 (height, width) each.

    ``exact`` colours get the first entries, in their order. The pictures, uint8
    (height, width, 3), share the rest and are mapped without dithering; ``lit`` ones are
    also counted in less light, or in fog: each has the colour of its darkest level. Unused entries are black. ``opaque``: which pixels of a picture, by its number, are
    opaque; if there are such pictures, entry 0 is that of their other pixels alone.
    """
    most = EXACT_MAX if pictures else COLOURS
    if len(exact) > most:
        fail(where, f"{len(exact)} palette entries for flat colours, ramps and the background; "
                    f"{most} at most" + (" beside textures" if pictures else ""))
    palette = np.zeros((COLOURS, 3), np.uint8)
    palette[:len(exact)] = np.array(exact, np.uint8).reshape(-1, 3)
    if not pictures:
        return palette, []
    samples = [picture[opaque[k]] if k in opaque else sample(picture) for k, picture in enumerate(pictures)]
    samples += [mixed(sample(picture), part, towards) for picture, towards in lit for part in DIMMED]
    others = reduced(samples, COLOURS - len(exact))
    used = len(exact) + len(others)
    palette[len(exact):used] = others
    first = 1 if opaque else 0
    texels = [nearest(picture, palette[first:used]) + np.uint8(first) for picture in pictures]
    for k, mask in opaque.items():
        texels[k][~mask] = 0
    return palette, texels
