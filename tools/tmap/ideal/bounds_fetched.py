"""Whether the texels that a polygon shows are those of its exact u and v.

Right u and v do not make a right texel: what a mapper makes of them, column and row of its map, may
still be another (a carry of u into the row, for one). So what is fetched is judged too, at every
pixel: somewhere on the texel, from its first to its last unit, u and v must be as near to the exact
ones as their bound, modulo the map's sides. Nothing is added to the bound for that: u and v as
they are stepped lie on the texel that is right, and keep it. Bounds are convex along a line, being
sums of distances from columns, so a line's ends have the largest.
"""

from dataclasses import dataclass

import numpy as np

from tmap.ideal.ideal import UNIT

#: What double precision may add to a distance, texels (``ideal.Plane.errors``).
ROUNDING = 2.0**-30


@dataclass
class Beside:
    """The texels of a line that lie farthest below and above the exact values, and where."""

    key: str  # u or v
    too_low: float  # texels from a texel's last unit to the exact value
    too_high: float  # from the exact value to a texel's first unit
    low_at: tuple[int, int]  # pixels
    high_at: tuple[int, int]

    def judge(self, low: float, high: float, out) -> None:
        """Adds a complaint to a Verdict where one is more than ``low`` or ``high`` away."""
        for off, allowed, pixel, word in ((self.too_low, low, self.low_at, "below"),
                                          (self.too_high, high, self.high_at, "above")):
            if off > allowed + ROUNDING:
                out.complain(f"the texel at pixel {pixel} lies {off:.9f} {word} the exact {self.key}, "
                             f"{allowed:.9f} are allowed")


def beside(key: str, texels: np.ndarray, values: np.ndarray, errors: np.ndarray, side: int,
           left: int, y: int) -> Beside:
    """Of the pixels from ``left`` on of line y. ``texels``: columns or rows that are fetched of
    ``side``; ``values``: u or v as stepped, 16.16, ``errors``: what those are off, texels."""
    middle = (texels + 0.5 - values * UNIT + errors + side / 2) % side - side / 2  # from the exact value
    low, high = int(middle.argmin()), int(middle.argmax())
    return Beside(key, float(-0.5 - middle[low]), float(middle[high] - 0.5), (left + low, y),
                  (left + high, y))
