"""How far u, v or a shade of a triangle with snapped vertices may be from the exact plane.

1 unit = U = 1/2^16. The plane is exact for the snapped vertices. g is its gradient a pixel, p the step
that is drawn with, n the number of lines below the first and k that of pixels from the long edge.

* A step along the long edge is a product with a reciprocal that is off by 1/2 (1/4 U for values up to
  1,024 apart), rounded down: off by 5/4 U. The value where the edge crosses the first line has less than
  one such step and is rounded down: 9/4 U.
* p is rounded towards zero, a whole negative step of shades away from it: U. It is 0 if it does not fit, or is SHADES_STEEP shades or more: g.
* The first pixel is less than a pixel from the crossing: p's error, and U by rounding the product. The
  distance itself is off by 4/2^16 pixel (2 by BELOW, 1/2 by a slope as 15.17, 1 by rounding): 4 g U.
* A line adds the step along the edge and p times the slope's fraction, rounded down: 9/4 U, of which
  5/4 U are on either side. Fractions that are off by 5,120/2^32 pixel add up to 1.4/2^16 pixel in 16
  lines, or 1/256 of that a line from FINER_HEIGHT on: 2 g U. Of the carries as many p were added as the
  fractions sum up to, but for one: p's error.
* A pixel adds p's error.

The sum is (6 + 5/4 n + 6 g) U + (k + 2) times p's error. u also counts how often v wraps: 5 U where v
stays within 1,024 texels, and (n + k) (1 + v's step / 2^23) U where that is 128 texels or more.

Values are raised by SNAPPED_RAISED = 512 U, those of triangles that are not small by 4 U more, from
FINER_HEIGHT on by 1/2 U: the register with the shift is added. So in fewer than SNAPPED_TALL lines of
SNAPPED_WIDTH pixels they are never below the exact ones, and at most 1/64 above, where g is up to 3:
13 + 5/4 n + k + 6 g is below 509 then, and 372 in 16 lines. In SNAPPED_LINES lines it is up to 669;
there TALL_RAISED = 160 U are added, so that they are never below, and at most 1/48 above.

Levels of light (lit Gouraud) are kept 1/16 inside their vertex's whole one instead, but for what
triangles that are not small add. Steps a pixel and a line, and the start, are cut to multiples of 4
units: p's error is 5 U at most and a line adds 4 U more. Below LEVELS_STEEP levels a pixel, in
SNAPPED_LINES lines of SNAPPED_WIDTH pixels, that is 10 + 21/4 n + 6 g + 5 (k + 2) units and TALL_RAISED,
3,504 at most and less than 1/16: so no pixel's level leaves those of the vertices. Steeper lines
have one pixel, whose level is the long edge's.
"""

from tmap.base.fixed import ONE
from tmap.ideal.ideal import UNIT
from tmap.setup import snapped

#: From this step on, texels a pixel, a quotient may not fit.
UNFIT = 32767.0


def level_bound(g: float, triangle: snapped.Triangle, i: int, y: int) -> float:
    """Returns how far a level may be from the exact one at pixel (i, y). ``g``: the magnitude of its
    exact gradient."""
    n, _, k = triangle.steps(y - triangle.top, i)
    off = 5.0 if g < snapped.STEEP_LEVELS - 1 else g / UNIT
    return (10 + 5.25 * n + 6 * g + (abs(k) + 2) * off + triangle.raised / 16 + snapped.INSET) * UNIT


def bound(g: float, triangle: snapped.Triangle, which: int, i: int, y: int) -> tuple[float, float]:
    """Returns how far below and above a value may be at pixel (i, y). ``g``: the magnitude of its
    exact gradient; ``which``: 0 for u, 1 for v."""
    n, _, k = triangle.steps(y - triangle.top, i)
    most = UNFIT if len(triangle.values) == 2 else snapped.STEEP - 1
    off = 1.0 if g < most else g / UNIT
    units = 6 + 1.25 * n + 6 * g + (abs(k) + 2) * off
    if which == 0 and len(triangle.values) == 2:
        step = max(abs(triangle.values[1].pixel), abs(triangle.values[1].line))
        units += 5 + (step >= 1 << 23) * (n + abs(k)) * (1 + step / (1 << 23))
    more = snapped.RAISED + triangle.raised / 16
    return max(0.0, units - more) * UNIT, (units + more) * UNIT
