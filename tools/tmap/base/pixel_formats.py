"""The formats of pixels and texels: enum pixel_format of c/scene/scene_file.h, by name."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tmap.base import maps


@dataclass(frozen=True)
class PixelFormat:
    """A pixel format. ``numbers``: converts colours, uint8 [...][channels], to pixels;
    ``colours``: the inverse. Both are None if there is a palette instead."""

    name: str
    bytes: int
    channels: str = "RGB"  # a mode of Pillow's
    numbers: Callable[[np.ndarray], np.ndarray] | None = None
    colours: Callable[[np.ndarray], np.ndarray] | None = None

    @property
    def dtype(self) -> np.dtype:
        """The type of pixels, in the host's byte order."""
        return np.dtype(f"u{self.bytes}")

    def flat(self, colours: list[tuple[int, int, int]]) -> list[int]:
        """Converts opaque colours to pixels."""
        opaque = np.full((len(colours), len(self.channels)), 255, np.uint8)
        opaque[:, :3] = np.array(colours, np.uint8).reshape(-1, 3)  # there may be none
        return self.numbers(opaque).tolist()

    def picture(self, pixels: np.ndarray) -> np.ndarray:
        """The colours of pixels, uint8 [...][3], without alpha."""
        return self.colours(pixels)[..., :3]


#: By name, in the order of enum pixel_format.
FORMATS = {each.name: each for each in (
    PixelFormat("chunky", 1),
    PixelFormat("rgb565", 2, "RGB", maps.to_rgb565, maps.from_rgb565),
    PixelFormat("rgba5551", 2, "RGBA", maps.to_rgba5551, maps.from_rgba5551),
    PixelFormat("rgba8888", 4, "RGBA", maps.to_rgba8888, maps.from_rgba8888))}
