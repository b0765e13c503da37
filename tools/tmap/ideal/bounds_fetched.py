"""Checks that the texels that a polygon shows are those of its exact u and v.

Correct u and v are not enough: the column and row that a mapper derives from them may still be
wrong (by a carry of u into the row, for example). So the fetched texels are judged too, at every
pixel. Somewhere on the texel, from its first to its last unit, u and v must be within their bound
of the exact values, modulo the map's sides. Nothing is added to the bound: the stepped u and v are
on the correct texel and within it. Bounds are convex along a line, as sums of distances from
columns, so a line's ends have the largest.
"""

import numpy as np

from tmap.ideal.ideal import UNIT

#: The most that double precision may add to a distance, texels (``ideal.Plane.errors``).
ROUNDING = 2.0**-30


def judge(key: str, texels: np.ndarray, values: np.ndarray, errors: np.ndarray, side: int,
          left: int, y: int, allowed: tuple[float, float], out) -> None:
    """Adds a complaint to a Verdict if a texel of a line is too far below or above the exact value.
    ``texels``: fetched columns or rows from pixel ``left`` on, modulo ``side``; ``values``: stepped
    u or v (``key``), 16.16; ``errors``: their errors; ``allowed``: below, above; texels."""
    middle = (texels + 0.5 - values * UNIT + errors + side / 2) % side - side / 2  # from the exact value
    low, high = int(middle.argmin()), int(middle.argmax())
    # from a texel's last unit to the exact value, and from that to a texel's first unit
    for off, most, at, word in ((-0.5 - middle[low], allowed[0], low, "below"),
                                (middle[high] - 0.5, allowed[1], high, "above")):
        if off > most + ROUNDING:
            out.complain(f"the texel at pixel ({left + at}, {y}) lies {off:.9f} {word} the exact "
                         f"{key}, {most:.9f} are allowed")
