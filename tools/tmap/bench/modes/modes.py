"""Modes of a texture engine that are priced: a material and a polygon of some 2,000 pixels each.

Materials are what a scene's TOML says of them; tmap.bench.modes.n64 and tmap.bench.modes.glide list them.
"""

import math
from abc import ABC, abstractmethod
from copy import deepcopy
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType
from typing import ClassVar

import numpy as np

from tmap.base.elementary import cos, each, sin

KINDS = ("smooth", "noise")
SIDE, FINE_SIDE = 32, 128  # texels of pictures
#: What maps show: file to its side, its seed and whether its alpha differs from 255.
PICTURE, OTHER, FINE, SHEER = "picture.png", "other.png", "fine.png", "sheer.png"
PICTURES = {PICTURE: (SIDE, 0, False), OTHER: (SIDE, 1, False), FINE: (FINE_SIDE, 2, False),
            SHEER: (SIDE, 3, True)}

#: x and y of a triangle turned off the axes, and of a square.
TRIANGLE = ((20.3, 10.6), (90.9, 33.8), (43.6, 75.0))
SQUARE = ((20, 16), (65, 16), (65, 61), (20, 61))
LEVEL = (1, 1, 1, 1)  # depths without perspective

#: Corners by name: points, s and t in texels of a map of SIDE, depths. "far" goes from a third of a
#: texel a pixel to 12 of them, "near" to 2.
POLYGONS = {
    "turned": (TRIANGLE, ((3.2, 4.1), (54, 20.3), (12.4, 51.7)), LEVEL),
    "inside": (TRIANGLE, ((3.2, 2.1), (28.7, 9.3), (10.4, 28.9)), LEVEL),
    "outside": (TRIANGLE, ((-9.2, -6.1), (86, 10.3), (31.4, 57.7)), LEVEL),
    "upright": (SQUARE, tuple((x - 13, y - 9) for x, y in SQUARE), LEVEL),
    "between": (SQUARE, tuple((x - 12.5, y - 8.5) for x, y in SQUARE), LEVEL),
    "deep": (TRIANGLE, ((3.2, 4.1), (74, 26.3), (16.4, 70.7)), (1, 2.2, 3.1)),
    "near": (TRIANGLE, ((3.2, 4.1), (44, 16.3), (14.4, 50.7)), (1, 2.2, 3.1)),
    "far": (TRIANGLE, ((3.2, 4.1), (144, 26.3), (16.4, 120.7)), (1, 6.2, 8.1)),
}


def picture(kind: str, seed: int, side: int = SIDE, sheer: bool = False) -> np.ndarray:
    """A picture, uint8 [side, side, 4]: periodic, neighbours differing by at most 20 * 32 / side,
    or random colours; opaque unless it is ``sheer``."""
    if kind == "smooth":
        y, x = np.mgrid[:side, :side]
        turn = 2 * math.pi / side
        waves = np.stack([each(sin, x * turn), each(cos, y * turn + seed), each(sin, (x + y) * turn),
                          each(sin, (x - y) * turn) if sheer else np.ones(x.shape)], -1)
        return np.rint(waves * [100, 100, 100, 100 if sheer else 127] + 128).astype(np.uint8)
    made = np.random.default_rng(seed).integers(0, 256, (side, side, 4), np.uint8)
    if not sheer:
        made[..., 3] = 255
    return made


@dataclass(frozen=True)
class Mode(ABC):
    """What is drawn. ``table``: what a material's table TABLE says; ``filter``: of the engine's
    ideal.FILTERS, what it is meant to be."""

    name: str
    title: str
    table: dict = field(hash=False)
    polygon: str = "turned"
    filter: str = "point"
    pixels: str = "rgba8888"
    in_c: bool = True  # drawn pixel by pixel in plain C too

    POLYGONS: ClassVar[dict] = POLYGONS
    TABLE: ClassVar[str]  # of a material
    SCHEMA: ClassVar[ModuleType]  # that checks the table
    MAPPER: ClassVar[str]
    PLAIN: ClassVar[str]  # rules of lowering without which plain C draws pixel by pixel
    PLAIN_SHIFT: ClassVar[int]  # polygons in plain C are 2^n times as small each way

    @property
    @abstractmethod
    def vertices(self) -> list[tuple[int, ...]]:
        """x, y, s, t, shade, w of the corners, 16.16; and once more where units have
        coordinates of their own."""

    @property
    def corners(self) -> int:
        """How many the polygon has."""
        return len(self.POLYGONS[self.polygon][0])

    @abstractmethod
    def tables(self, spec: dict, folder: Path, frames: int, where: str) -> dict:
        """What a Scene has of a specification with one material."""

    def material(self) -> dict:
        """The checked content of the material's table, every default filled in."""
        made = self.SCHEMA.schema()(deepcopy(self.table), f"mode {self.name}")
        self.SCHEMA.check(made, f"mode {self.name}")
        return made
