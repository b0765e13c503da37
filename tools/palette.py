"""One palette for a whole scene, and its textures as indices into it."""

import numpy as np
from PIL import Image

from .errors import UserError

COLOURS = 256
EXACT_MAX = 128  # what exact colours may take; the rest is the textures'


def nearest(pixels: np.ndarray, palette: np.ndarray) -> np.ndarray:
    """The palette index nearest to each pixel, the lowest of equals.

    pixels uint8 (..., 3), palette uint8 (n, 3); result uint8 (...). Squares and
    products stay below 2^24, so float32 holds them exactly on every machine.
    """
    packed = pixels.reshape(-1, 3) @ np.array([65536, 256, 1])
    colours, where = np.unique(packed, return_inverse=True)
    colours = np.stack([colours >> 16, colours >> 8 & 255, colours & 255], axis=1)
    entries = palette.astype(np.float32)
    length = (entries * entries).sum(axis=1)
    found = np.empty(len(colours), np.uint8)
    for start in range(0, len(colours), 16384):
        some = slice(start, start + 16384)
        found[some] = np.argmin(length - 2 * (colours[some].astype(np.float32) @ entries.T), axis=1)
    return found[where].reshape(pixels.shape[:-1])


def build(exact: list[tuple[int, int, int]], pictures: list[np.ndarray],
          where: str) -> tuple[np.ndarray, np.ndarray]:
    """The palette, uint8 (256, 3), and the textures, uint8 (n, 256, 256).

    ``exact`` colours get the first entries, in their order, each once; the
    pictures, uint8 (256, 256, 3), share what is left and are mapped without
    dithering. Unused entries are black.
    """
    distinct = list(dict.fromkeys(exact))
    if len(distinct) > EXACT_MAX:
        raise UserError(f"{where}: {len(distinct)} different flat colours; "
                        f"{EXACT_MAX} at most, the background included")
    palette = np.zeros((COLOURS, 3), np.uint8)
    palette[:len(distinct)] = np.array(distinct, np.uint8).reshape(-1, 3)
    if not pictures:
        return palette, np.zeros((0, 256, 256), np.uint8)
    # A quarter of the pixels, from every row and column: as good, five times quicker.
    t, s = np.indices(pictures[0].shape[:2])
    together = Image.fromarray(np.stack([picture[(s + t) % 4 == 0] for picture in pictures]))
    reduced = together.quantize(COLOURS - len(distinct), Image.Quantize.MEDIANCUT, kmeans=1,
                                dither=Image.Dither.NONE)
    shared = np.array(reduced.getpalette(), np.uint8).reshape(-1, 3)[:COLOURS - len(distinct)]
    used = len(distinct) + len(shared)
    palette[len(distinct):used] = shared
    maps = np.stack([nearest(picture, palette[:used]) for picture in pictures])
    return palette, maps
