"""Texture maps as numbers: their orders in memory (c/texture/map.h) and RGB565.

Arrays are [height][width], row 0 (v = 0) on top, of any integer type; a map in
memory is one-dimensional.
"""

import numpy as np

TILE = 8  # texels along a tile's side
COLUMN = 4  # texels across a column


def to_tiled(array: np.ndarray) -> np.ndarray:
    """Tiles of 8x8, columns of tiles from left to right: texel 8 height (u/8) + 8 v + u%8."""
    height, width = array.shape
    return array.reshape(height, width // TILE, TILE).transpose(1, 0, 2).reshape(-1)


def from_tiled(data: np.ndarray, width: int = 256, height: int = 256) -> np.ndarray:
    """The inverse of ``to_tiled``."""
    return data.reshape(width // TILE, height, TILE).transpose(1, 0, 2).reshape(height, width)


def to_columns(array: np.ndarray) -> np.ndarray:
    """Columns 4 texels wide, from left to right: texel 4 height (u/4) + 4 v + u%4."""
    height, width = array.shape
    return array.reshape(height, width // COLUMN, COLUMN).transpose(1, 0, 2).reshape(-1)


def from_columns(data: np.ndarray, width: int, height: int) -> np.ndarray:
    """The inverse of ``to_columns``."""
    return data.reshape(width // COLUMN, height, COLUMN).transpose(1, 0, 2).reshape(height, width)


def to_565(rgb: np.ndarray) -> np.ndarray:
    """uint8 (..., 3) to the nearest RGB565, uint16 (...)."""
    red, green, blue = (rgb[..., k].astype(np.uint32) for k in range(3))
    return ((red * 31 + 127) // 255 << 11 | (green * 63 + 127) // 255 << 5
            | (blue * 31 + 127) // 255).astype(np.uint16)


def from_565(pixels: np.ndarray) -> np.ndarray:
    """RGB565, uint16 (...), to uint8 (..., 3): low bits repeat the high ones."""
    red, green, blue = pixels >> 11 & 31, pixels >> 5 & 63, pixels & 31
    return np.stack([red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2],
                    axis=-1).astype(np.uint8)
