"""Checks that the texels that a polygon shows are those of its exact u and v.

Correct u and v are not enough: the column and row that a mapper derives from them may still be
wrong (by a carry of u into the row, for example). So the fetched texels are judged too, at every
pixel. Somewhere on the texel, from its first to its last unit, u and v must be within their bound
of the exact values, modulo the map's sides: a texel half a map away may be below or above them.
Nothing is added to the bound: the stepped u and v are on the correct texel and within it. Bounds
are convex along a line, as sums of distances from columns, so a line's ends have the largest.
"""

import numpy as np

from tmap.ideal.ideal import UNIT
from tmap.ideal.rows import Rows

#: The most that double precision may add to a distance, texels (``ideal.Plane.errors``).
ROUNDING = 2.0**-30


def is_near(middle: np.ndarray, below, above, side) -> np.ndarray:
    """Returns which texels are near enough to the exact value. ``middle``: from that to their middles, modulo
    ``side``; ``below``, ``above``: how far from it their nearer ends may be, texels."""
    below, above = below + ROUNDING, above + ROUNDING
    return (middle + 0.5 + below) % side <= 1 + below + above


def far_rows(rows: Rows, texels: np.ndarray, values: np.ndarray, errors: np.ndarray, side, allowed) -> np.ndarray:
    """Returns which rows ``judge`` would complain about. Its arguments, over the rows' pixels; ``side`` and
    ``allowed``, below and above, for each row, or one for all."""
    spread = [each if np.ndim(each) == 0 else rows.spread(each) for each in (*allowed, side)]
    return rows.some(~is_near(texels + 0.5 - values * UNIT + errors, *spread))


def judge(key: str, texels: np.ndarray, values: np.ndarray, errors: np.ndarray, side: int,
          left: int, y: int, allowed: tuple[float, float], out) -> None:
    """Adds a complaint to a Verdict if a texel of a line is too far below or above the exact value.
    ``texels``: fetched columns or rows from pixel ``left`` on, modulo ``side``; ``values``: stepped
    u or v (``key``), 16.16; ``errors``: their errors; ``allowed``: below, above; texels."""
    middle = (texels + 0.5 - values * UNIT + errors + side / 2) % side - side / 2  # from the exact value
    far = np.where(is_near(middle, *allowed, side), 0, middle)
    at = int(np.abs(far).argmax())
    if far[at]:
        # from a texel's last unit to the exact value, or from that to a texel's first unit
        word, most = ("above", allowed[1]) if far[at] > 0 else ("below", allowed[0])
        out.complain(f"the texel at pixel ({left + at}, {y}) lies {abs(far[at]) - 0.5:.9f} {word} the exact "
                     f"{key}, {most:.9f} are allowed")
