"""Texture maps in the layouts of c/texture/map.h, and colours of 16 and 32 bits.

Every conversion has its inverse; pictures are numpy arrays [height][width], maps in
memory have one dimension. Wide maps in memory are big-endian (``>u2``, ``>u4``).
"""

import numpy as np

TILE = 8  # texels on a side
COLUMN = 4  # texels in a row
RGB565 = RGBA5551 = np.dtype(">u2")
RGBA8888 = np.dtype(">u4")


def to_tiled(picture: np.ndarray) -> np.ndarray:
    """Converts to MAP_TILED: tiles of 8x8, column of tiles by column of tiles."""
    height, width = picture.shape
    tiles = picture.reshape(height, width // TILE, TILE)
    return tiles.transpose(1, 0, 2).reshape(-1)


def from_tiled(texels: np.ndarray, width: int = 256, height: int = 256) -> np.ndarray:
    """Returns the picture of a map in MAP_TILED."""
    return texels.reshape(width // TILE, height, TILE).transpose(1, 0, 2).reshape(height, width)


def to_columns(picture: np.ndarray) -> np.ndarray:
    """Converts to MAP_COLUMNS: columns 4 texels wide, one after the other."""
    height, width = picture.shape
    return picture.reshape(height, width // COLUMN, COLUMN).transpose(1, 0, 2).reshape(-1)


def from_columns(texels: np.ndarray, width: int, height: int) -> np.ndarray:
    """Returns the picture of a map in MAP_COLUMNS."""
    return texels.reshape(width // COLUMN, height, COLUMN).transpose(1, 0, 2).reshape(height, width)


def to_page(picture: np.ndarray) -> np.ndarray:
    """Converts to a MAP_PAGE of 256x256 texels; if texels have 2 or 4 bytes, the picture's lower
    half comes first in memory."""
    return (picture if picture.itemsize == 1 else np.roll(picture, 128, axis=0)).reshape(-1)


def widened(bits: int) -> np.ndarray:
    """Returns the 8-bit value of each ``bits``-bit one: its upper bits are repeated below it."""
    values = np.arange(1 << bits)
    return (values << 8 - bits | values >> 2 * bits - 8).astype(np.uint8)


def narrowed(bits: int) -> np.ndarray:
    """Returns, for each 8-bit value, the ``bits``-bit value whose ``widened`` value is nearest; the
    smaller of two."""
    values = widened(bits).astype(int)
    return np.abs(np.arange(256)[:, None] - values).argmin(axis=1)


def to_rgb565(colours: np.ndarray) -> np.ndarray:
    """Converts uint8 [...][3] to RGB565, each part to the nearest."""
    red, green, blue = (colours[..., k] for k in range(3))
    return (narrowed(5)[red] << 11 | narrowed(6)[green] << 5 | narrowed(5)[blue]).astype(RGB565)


def from_rgb565(pixels: np.ndarray) -> np.ndarray:
    """Converts RGB565 to uint8 [...][3]."""
    pixels = pixels.astype(int)
    return np.stack([widened(5)[pixels >> 11], widened(6)[pixels >> 5 & 63],
                     widened(5)[pixels & 31]], axis=-1)


def to_rgba5551(colours: np.ndarray) -> np.ndarray:
    """Converts uint8 [...][4] to 5 bits of red, green and blue, each to the nearest, and one bit
    of alpha."""
    red, green, blue = (narrowed(5)[colours[..., k]] for k in range(3))
    return (red << 11 | green << 6 | blue << 1 | colours[..., 3] >> 7).astype(RGBA5551)


def from_rgba5551(pixels: np.ndarray) -> np.ndarray:
    """Converts RGBA5551 to uint8 [...][4]."""
    pixels = pixels.astype(int)
    parts = [widened(5)[pixels >> shift & 31] for shift in (11, 6, 1)]
    return np.stack([*parts, ((pixels & 1) * 255).astype(np.uint8)], axis=-1)


def to_rgba8888(colours: np.ndarray) -> np.ndarray:
    """Converts uint8 [...][4] to red, green, blue and alpha, a byte each."""
    return np.ascontiguousarray(colours).view(RGBA8888)[..., 0]


def from_rgba8888(pixels: np.ndarray) -> np.ndarray:
    """Converts RGBA8888 to uint8 [...][4]."""
    return np.ascontiguousarray(pixels.astype(RGBA8888))[..., None].view(np.uint8)
