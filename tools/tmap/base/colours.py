"""Colours of few bits, brightness and small palettes, shared by the texture units' formats."""

import numpy as np
from PIL import Image

OPAQUE = 128  # the least alpha for which a one-bit alpha is set


def quantised(channel: np.ndarray, bits: int) -> np.ndarray:
    """Returns the nearest of 2^bits values for each 0..255, int64. It is also the nearest when its
    bits are repeated to fill 8."""
    top = (1 << bits) - 1
    return (channel.astype(np.int64) * top + 127) // 255


def five(x: np.ndarray) -> np.ndarray:
    """Expands the low 5 bits to 8."""
    x = x & 31
    return x << 3 | x >> 2


def intensity(picture: np.ndarray) -> np.ndarray:
    """Returns the brightness 0..255 of [..., 3 or 4] by video's weights, int64 [...]."""
    r, g, b = (picture[..., k].astype(np.int64) for k in range(3))
    return (299 * r + 587 * g + 114 * b + 500) // 1000


def reduced(colours: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Reduces colours [n, 3], uint8, by Pillow to (indices [n], palette [at most count, 3])."""
    image = Image.fromarray(np.ascontiguousarray(colours[None])).quantize(
        count, Image.Quantize.MEDIANCUT, kmeans=4, dither=Image.Dither.NONE)
    palette = np.array(image.getpalette("RGB"), np.uint8).reshape(-1, 3)
    return np.asarray(image, np.int64)[0], palette[:count]
