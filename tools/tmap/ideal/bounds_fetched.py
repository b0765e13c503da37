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

#: The most that double precision may add to a distance, texels (``ideal.Plane.errors``).
ROUNDING = 2.0**-30


def is_near(middle: np.ndarray, below, above, side) -> np.ndarray:
    """Returns which texels are near enough to the exact value. ``middle``: from that to their middles, modulo
    ``side``; ``below``, ``above``: how far from it their nearer ends may be, texels."""
    below, above = below + ROUNDING, above + ROUNDING
    return (middle + 0.5 + below) % side <= 1 + below + above


def judge_lines(lines: list[tuple], out) -> None:
    """``judge`` for many lines, all at once: those alone that it would complain about are judged by it.
    ``lines``: its arguments from ``key`` to ``y``, and ``allowed``."""
    if not lines:
        return
    counts = [len(texels) for (_, texels, *_), _ in lines]
    texels, values, errors = (np.concatenate([each[k] for each, _ in lines]) for k in (1, 2, 3))
    sides, below, above = (np.repeat(each, counts) for each in (
        [each[4] for each, _ in lines], *np.array([allowed for _, allowed in lines]).T))
    near = is_near(texels + 0.5 - values * UNIT + errors, below, above, sides)
    starts = np.cumsum([0, *counts[:-1]])
    for number in np.flatnonzero(~np.logical_and.reduceat(near, starts)):
        each, allowed = lines[number]
        judge(*each, allowed, out)


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
