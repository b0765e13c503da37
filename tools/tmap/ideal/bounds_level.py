"""How far lines that are drawn as if they were affine may be from the exact curve, or, if they are straight from
their first pixel to their last, from the chord between its values there. Letters and units as in
tools/tmap/ideal/bounds_perspective.py; n steps, values less the base.

**The first pixel** is the other settings': b0. With the planes' S and the held q its value is u0 = S0 / q0 + d, d being
the cut, less than a unit, and what the clamp to the vertices' range adds or takes: as much as the exact value, or its
value with the planes' errors, is beyond that. Polygons of more than three vertices may be far off the planes.

**The last pixel.** The step is (S(n) - S0 - u0 (q(n) - q0)) / n q(n), so that it leads to

    u0 + n step = (S0 + S(n) - S0 + d q0) / q(n) = S(n) / q(n) + d q0 / q(n):

what the first pixel is off from its planes is stretched by q0 / q(n) at the last one, where q is smaller. What
the clamp has taken is added to the steps, so that q0 / q(n) - 1 of it are left. S(n) / q(n) has S's error and, times
u, q's: that of the plane, its cut, the tilt's cut to 2^-8 a pixel, and what q0 is held above its plane. The
last pixel's value is not clamped: u may be beyond the range. If q(n) is held too, u0 is in what that adds, which counts
times the way. Without a tilt q(n) is q0, and the setting has an error for q's change (``LEVEL``), almost half or a
quarter of its tolerance.

**Between them** the error is linear: it is at most that of the worse end.

**Steps** are rounded up: a unit a pixel. What the clamp has taken is rounded up to a unit a pixel too. In a chain
u is also off by the times that v wraps, half a unit per step at most, and its steps are a unit more where v goes
down: another unit per step.

If q does not change along lines, they are never below the exact value: neither is the first pixel, nor S(n) / q.

**Lines by reciprocals** (tmap.setup.level_reciprocal) have no clamp. Letters as there; f is the line that is farthest, all
q are in the middle of the width, [q] is q cut to a whole number. Let k be what K is cut by: less than a unit, and |K| / 2^31 for
the divisor's cut, 5/4 in all. The planes' S / q is then K + k (1 - q(f) / q) + (S(f) - K q(f)) / q. Drawn is, by turns:

* k is left out: 5/4 at most either way, as q(f) is the least.
* C has A more and a unit, A being |K| and the range, at least |u - K|: up to A / q + 1 / q higher.
* [q] for q: C / [q] - C / q is |u - K| / q at most either way, which A makes up for. q is stepped with 16 bits of fraction:
  each step loses less than 2^-16, and q begins (count + 1) 2^-16 further up, cut, so that it is above the plane's by 2^-6
  at most, and [q] within 1 of that.
* C is rounded up, and so is dC: a unit each, times R / 2^32; x pixels right of the left 1 + x of them.
* R is cut: by less than 1, times C / 2^32, half a unit. The product is cut: another unit.
* Steps are rounded up: a unit a pixel, or two in a chain, as above; R's cut takes a unit from all of them at most.
  Columns on which s does not change have no step of u, and v's wraps no part in it; lines and columns on which t does
  not change have none of v: less than that.

Lines are raised by 3 units and the base's one, so they are never below: 5/4 + 1/2 + 1 + 1 < 4. They are above by
4 + 5/4 + 1, 2 A / q, and the steps.
"""

from typing import TypeVar

import numpy as np

from tmap.ideal.ideal import UNIT
from tmap.ideal.perspective import FLOAT, Rates
from tmap.ideal.rows import Rows

Number = TypeVar("Number", float, np.ndarray)

LEVEL = {"every16": 1 / 2, "every8": 1 / 4, "pixel": 1020 * UNIT, "fine": 128 * UNIT}  # texels
MOST = 2.0**31  # units: values are modulo twice that


def straight_bound(bound, left: np.ndarray, n: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Returns the bounds in units of the pixels left to left + n of lines y, before the error for q's change and the
    steps' rounding; at most MOST. ``bound``: a ``bounds_perspective.Bound``."""
    first, last, p = bound.at(left, y), bound.at(left + n, y), bound.p
    near, start = bound.quotient(first), bound.end(first)[0]
    added = np.maximum(0.0, bound.low - first.value + near)
    taken = np.maximum(0.0, first.value + near - bound.high)
    held = np.maximum(0.0, p.least - first.q + first.off_q)
    q, off, more, stretched, shrunk = first.q, first.off_q, 0.0, 1.0, 1.0
    if p.tilt:
        q, off = last.q, last.off_q + 1 + n / 256
        more = np.maximum(0.0, p.least - q + off)
        stretched = np.maximum(first.q + first.off_q, p.least) / np.maximum(q - off, p.least)
        shrunk = np.maximum(first.q - first.off_q, p.least) / np.maximum(q + off + held, p.least)
    far = np.maximum(bound.largest, abs(last.value - bound.base))
    way = abs(last.value - first.value) + start
    # a unit for the base, one for the first quotient's cut
    reached = (last.off_s + (off + held) * far + more * way + n) / np.maximum(q - off, p.least) + 1 + stretched
    reached += added * stretched + taken * np.maximum(stretched - 1, 1 - shrunk) + n * (taken > 0)
    reached = np.minimum(np.maximum(start, reached), MOST)
    # the steps do not make up for so much
    reached = np.where(first.value + near - bound.base >= MOST, MOST, reached)
    return np.where(first.is_ahead & last.is_ahead & (n > 0), reached, start)


def reciprocal_bound(bound, left: np.ndarray, n: np.ndarray, y: np.ndarray) -> np.ndarray:
    """``straight_bound`` of lines that are made by a reciprocal; with what the steps of C add."""
    first, last, p = bound.at(left, y), bound.at(left + n, y), bound.p
    made, key = p.inverse, 0 if bound.plane is p.s else 1
    cut = 4.0 if p.q.dx else 0.0  # below 2^-8 a pixel; what grows more is within LEVEL or the tolerance
    planes = np.maximum(*((at.off_s + (at.off_q + cut) * np.maximum(bound.largest, abs(at.value - bound.base)))
                          / np.maximum(at.q - at.off_q, 1) for at in (first, last)))
    q = np.maximum(np.minimum(first.q - first.off_q, last.q - last.off_q), 1)
    found = planes + 8 + (2 * made.away[key] + 2) / q + (left + n + 1 - p.i) * (made.farthest + 1) / 2.0**32
    return np.where(first.is_ahead & last.is_ahead, found, MOST)


def level_bound(b: Number, setting: str, n: Number, chained: bool) -> Number:
    """Returns the bound of level lines of n steps against the exact value, or the chord, in texels; ``b``: of
    ``straight_bound``, in texels."""
    return b + LEVEL.get(setting, 0) + ((1 + chained) * n + 1) * UNIT + FLOAT


def chords(rates: Rates, rows: Rows) -> np.ndarray:
    """The intended error of rows that are straight from their first pixel to their last; ``rates``: theirs."""
    ends = [rates.moved(end - rates.columns) for end in (rows.lefts, rows.ends - 1)]
    slope = rows.spread((ends[1] - ends[0]) / np.maximum(rows.counts - 1, 1))
    return (rows.spread(ends[0]) + slope * (rows.columns - rows.spread(rows.lefts))
            - rates.moved(rows.columns - rows.spread(rates.columns), rows))
