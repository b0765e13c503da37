"""Random maps and palettes, the same in every run: a wrong texel is seen with 255 chances in 256."""

import numpy as np

SIDE = 256  # texels of a page


def page() -> np.ndarray:
    """A page, uint8 (256, 256): [v][u]."""
    return np.random.default_rng(SIDE).integers(0, 256, (SIDE, SIDE), dtype=np.uint8)


def of_size(width: int, height: int) -> np.ndarray:
    """A map, uint8 (height, width); each size has its own."""
    return np.random.default_rng(width << 16 | height).integers(0, 256, (height, width), np.uint8)


def palette() -> np.ndarray:
    """uint8 (256, 3): red, green, blue."""
    return np.random.default_rng(1).integers(0, 256, (256, 3), dtype=np.uint8)
