"""Small scenes of random numbers."""

import numpy as np

from tmap.scene_file.scene_file import Material, Object, Scene, Texture

LIGHT = Texture(np.arange(64 * 256, dtype=np.uint32).reshape(64, 256).astype(np.uint8), "light")


def vertices(random, count: int) -> np.ndarray:
    """Any numbers (w too: nothing has a perspective), shades inside the palette."""
    rows = random.integers(-2**31, 2**31, (count, 6))
    rows[:, 4] = random.integers(0, 256 << 16, count)
    return rows


def example(seed: int = 1, textures: int = 1) -> Scene:
    """A small scene of random numbers, with every table in use."""
    random = np.random.default_rng(seed)
    return Scene(
        width=8, height=5, frames=3, background=7,
        palette=random.integers(0, 256, (256, 3)).astype(np.uint8),
        textures=[Texture(random.integers(0, 256, (256, 256)).astype(np.uint8))
                  for _ in range(textures)],
        materials=[Material(colour=255), Material("affine", texture=textures - 1) if textures
                   else Material("gouraud", "exact", "plane", "truncated")],
        objects=[Object(0, 0, 3, 0, 3, 0), Object(1, 2, 4, 2, 2, 1)],
        vertices=vertices(random, 6),
        poses=random.integers(-2**31, 2**31, (4, 6)))
