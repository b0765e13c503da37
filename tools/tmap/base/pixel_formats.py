"""The formats of pixels and texels: enum pixel_format of c/scene/scene_file.h, by name."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tmap.base import maps


@dataclass(frozen=True)
class PixelFormat:
    """What a pixel's number means. ``numbers``: colours, uint8 [...][channels], as pixels;
    ``colours``: the inverse, None where there is a palette instead."""

    name: str
    bytes: int
    channels: str = "RGB"  # a mode of Pillow's
    numbers: Callable[[np.ndarray], np.ndarray] | None = None
    colours: Callable[[np.ndarray], np.ndarray] | None = None

    @property
    def dtype(self) -> np.dtype:
        """Of pixels, in the host's byte order."""
        return np.dtype(f"u{self.bytes}")

    def flat(self, colours: list[tuple[int, int, int]]) -> list[int]:
        """Opaque colours as pixels."""
        opaque = np.full((len(colours), len(self.channels)), 255, np.uint8)
        opaque[:, :3] = colours
        return self.numbers(opaque).tolist()

    def picture(self, pixels: np.ndarray) -> np.ndarray:
        """What pixels look like, uint8 [...][3]: alpha does not count."""
        return self.colours(pixels)[..., :3]


#: In the order of their numbers.
FORMATS = {each.name: each for each in (
    PixelFormat("chunky", 1),
    PixelFormat("rgb565", 2, "RGB", maps.to_rgb565, maps.from_rgb565),
    PixelFormat("rgba5551", 2, "RGBA", maps.to_rgba5551, maps.from_rgba5551),
    PixelFormat("rgba8888", 4, "RGBA", maps.to_rgba8888, maps.from_rgba8888))}
