"""Random maps and palettes, the same in every run: 255 of 256 wrong texels are detected."""

import numpy as np

SIDE = 256  # texels of a page


def page() -> np.ndarray:
    """Returns a page, uint8 (256, 256): [v][u]."""
    return np.random.default_rng(SIDE).integers(0, 256, (SIDE, SIDE), dtype=np.uint8)


def of_size(width: int, height: int) -> np.ndarray:
    """Returns a map, uint8 (height, width); each size has different texels."""
    return np.random.default_rng(width << 16 | height).integers(0, 256, (height, width), np.uint8)


def palette() -> np.ndarray:
    """Returns a palette, uint8 (256, 3): red, green, blue."""
    return np.random.default_rng(1).integers(0, 256, (256, 3), dtype=np.uint8)
