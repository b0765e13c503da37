"""Checks that the texels that a polygon shows are those of its exact u and v.

Correct u and v are not enough: the column and row that a mapper derives from them may still be
wrong (by a carry of u into the row, for example). So the fetched texels are judged too, at every
pixel. Somewhere on the texel, from its first to its last unit, u and v must be within their bound
of the exact values, modulo the map's sides. Nothing is added to the bound: the stepped u and v are
on the correct texel and within it. Bounds are convex along a line, as sums of distances from
columns, so a line's ends have the largest.
"""

from dataclasses import dataclass

import numpy as np

from tmap.ideal.ideal import UNIT

#: The most that double precision may add to a distance, texels (``ideal.Plane.errors``).
ROUNDING = 2.0**-30


@dataclass
class Beside:
    """The texels of a line that are farthest below and above the exact values, and their pixels."""

    key: str  # u or v
    too_low: float  # texels from a texel's last unit to the exact value
    too_high: float  # from the exact value to a texel's first unit
    low_at: tuple[int, int]  # pixels
    high_at: tuple[int, int]

    def judge(self, low: float, high: float, out) -> None:
        """Adds a complaint to a Verdict if one is more than ``low`` or ``high`` away."""
        for off, allowed, pixel, word in ((self.too_low, low, self.low_at, "below"),
                                          (self.too_high, high, self.high_at, "above")):
            if off > allowed + ROUNDING:
                out.complain(f"the texel at pixel {pixel} lies {off:.9f} {word} the exact {self.key}, "
                             f"{allowed:.9f} are allowed")


def beside(key: str, texels: np.ndarray, values: np.ndarray, errors: np.ndarray, side: int,
           left: int, y: int) -> Beside:
    """Returns the Beside of the pixels from ``left`` on of line y. ``texels``: fetched columns or
    rows, modulo ``side``; ``values``: stepped u or v, 16.16; ``errors``: their errors, texels."""
    middle = (texels + 0.5 - values * UNIT + errors + side / 2) % side - side / 2  # from the exact value
    low, high = int(middle.argmin()), int(middle.argmax())
    return Beside(key, float(-0.5 - middle[low]), float(middle[high] - 0.5), (left + low, y),
                  (left + high, y))
