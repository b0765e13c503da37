"""Small scenes of random numbers."""

import numpy as np

from tmap.scene_file.scene_file import Material, Object, Scene, Texture

LIGHT = Texture(np.arange(64 * 256, dtype=np.uint32).reshape(64, 256).astype(np.uint8), "light")


def vertices(random, count: int) -> np.ndarray:
    """Any numbers (w too: nothing has a perspective), shades inside the palette."""
    rows = random.integers(-2**31, 2**31, (count, 6))
    rows[:, 4] = random.integers(0, 256 << 16, count)
    return rows


def example(textures: int = 1, side: int = 8, corners: int = 6, seed: int = 1) -> Scene:
    """A scene of random numbers, with every table of plain mappers in use: two objects, or three
    overlapping ones from 20 corners on."""
    random = np.random.default_rng(seed)
    objects = [Object(0, 0, 3, 0, 3, 0), Object(1, 2, 4, 2, 2, 1)]
    if corners >= 20:
        objects += [Object(1, 3, corners - 3, 0, 3, 0)]
    return Scene(
        width=side, height=side, frames=3, background=7,
        palette=random.integers(0, 256, (256, 3)).astype(np.uint8),
        textures=[Texture(random.integers(0, 256, (256, 256)).astype(np.uint8))
                  for _ in range(textures)],
        materials=[Material(colour=255), Material("affine", texture=textures - 1) if textures
                   else Material("gouraud", "exact", "plane", "truncated")],
        objects=objects, vertices=vertices(random, corners),
        poses=random.integers(-2**31, 2**31, (4, 6)))
