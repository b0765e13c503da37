"""The ideal of Glide's texture unit: exact perspective, unquantised filters, true levels.

s and t are quotients of two planes over the screen, so the texel of a pixel is decided in
integers; fractions, levels and colours are float64. A fraction is a quotient rounded once, and
colours change by 255 per texel at most, so that a filtered colour is off by less than 2^-40. A
level is the logarithm of two rounded quotients' length, below 64 in size and off by less than
2^-45. Colours between two levels change by 255 times that: less than 2^-36 in all. The unit's
remaining errors are its own: weights of 4 or 8 bits, a level whose w does not change inside a
pixel, sums and products cut to 8 bits.
"""

from typing import NamedTuple

import numpy as np

from tmap.base.elementary import log2
from tmap.base.errors import UserError
from tmap.base.fixed import ONE
from tmap.glide.combine import ALPHA
from tmap.glide.coordinates import sides, within
from tmap.glide.state import (DETAIL, LAST_LEVEL, LOCAL, LOCAL_ALPHA, LOD_FRACTION, ONE_W,
                              OTHER_ALPHA, Combination, Modes, Unit)
from tmap.glide.texels import fetch, owns
from tmap.ideal.ideal import corners
from tmap.ideal.texels import Coordinate, Quotients, bilinear, scaled

TO_WHOLE = 12  # s/w of 14.18 over 1/w of 2.30 is s over 2^12
FILTERS = ("point", "bilinear", "trilinear")


class Corner(NamedTuple):
    """A corner: ``x``, ``y``: 16.16; ``s``, ``t``: s/w and t/w, 14.18; ``w``: 1/w, 2.30."""

    x: int
    y: int
    s: int
    t: int
    w: int = ONE_W


class Surface(Quotients):
    """The exact s and t, in units of 1/256 of the longer side; ``perspective``: divided by 1/w."""

    def __init__(self, polygon: list[Corner], perspective: bool):
        three = [polygon[k] for k in corners(polygon)]
        super().__init__([c[:2] for c in three],
                         [[c[k] << TO_WHOLE for c in three] for k in (2, 3)],
                         [c.w if perspective else ONE_W for c in three])

    def level(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Returns the true level of detail at pixels [n]: of the longer of the vectors by which
        (s, t) changes to the right and down, from the derivatives there. Minus infinity where s and
        t are constant."""
        *overs, inverse = self.terms(x, y)
        lengths = []
        for name in ("nx", "ny"):
            steps = [getattr(plane, name) * ONE * (1 if plane.d > 0 else -1)
                     for plane in (*self.over, self.inverse)]
            slopes = [(step * inverse - over * steps[-1]) / (inverse * inverse)
                      for step, over in zip(steps[:2], overs)]
            across, down = (slope.astype(np.float64) for slope in slopes)
            lengths.append(np.sqrt(across * across + down * down))
        return log2(np.maximum(*lengths))


def limited(modes: Modes, level: np.ndarray) -> np.ndarray:
    """Adds the bias to a level and clamps it to the limits."""
    most = min(modes.lod_max / 4, LAST_LEVEL)
    return np.minimum(np.maximum(level + modes.lod_bias / 4, modes.lod_min / 4), most)


def sample_level(unit: Unit, s: Coordinate, t: Coordinate, level: np.ndarray,
                 linear: bool) -> np.ndarray:
    """Returns colours [n, 4], float64 0..255, of whole levels [n]; ``linear``: weighted by exact
    fractions between texels' centres, else the texel that contains the pixel."""
    modes, level = unit.modes, np.broadcast_to(level, s.index.shape)
    if not all(owns(modes, n) for n in np.unique(level)):
        raise UserError("ideal: the map lacks a level")
    found = np.zeros((s.index.size, 4))
    for n in np.unique(level).tolist():
        here, axes = level == n, []
        for axis, (c, clamp) in enumerate(((s, modes.clamp_s), (t, modes.clamp_t))):
            c = scaled(Coordinate(c.index[here], c.fraction[here]), n)
            moved = c.fraction - linear / 2
            down = np.floor(moved).astype(np.int64)
            side = sides(modes, axis)[n]
            axes.append([within(c.index + down + k, side, clamp) for k in (0, 1)])
            axes.append(moved - down)
        (i, fs), (j, ft), at = axes[:2], axes[2:], level[here]
        if linear:
            found[here] = bilinear([fetch(unit, at, a, b) for b in j for a in i], fs, ft)
        else:
            found[here] = fetch(unit, at, i[0], j[0])
    return found


def sample(unit: Unit, s: Coordinate, t: Coordinate, level: np.ndarray, how: str,
           other_levels: Unit | None = None) -> np.ndarray:
    """Returns colours [n, 4], float64 0..255, at levels [n] within 0..8; ``how``: one of FILTERS.

    Point and bilinear samples are of the level rounded down, as in the unit; trilinear ones are
    between that and the next. ``other_levels``: the unit with the levels that this one's map lacks.
    """
    if how not in FILTERS:
        raise UserError(f"ideal: filter {how!r} is none of {', '.join(FILTERS)}")
    whole = np.floor(level).astype(np.int64)

    def one(n: np.ndarray) -> np.ndarray:
        has = np.array([owns(unit.modes, k) for k in range(LAST_LEVEL + 1)])[n]
        found = np.zeros((n.size, 4))
        for each, here in ((unit, has), (other_levels or unit, ~has)):
            at = [Coordinate(c.index[here], c.fraction[here]) for c in (s, t)]
            found[here] = sample_level(each, *at, n[here], how != "point")
        return found

    fine = one(whole)
    if how != "trilinear":
        return fine
    coarse = one(np.minimum(whole + 1, LAST_LEVEL))
    return fine + (level - whole)[:, None] * (coarse - fine)


def factor(modes: Modes, half: Combination, level: np.ndarray, own: np.ndarray,
           local: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The factor of a half of the unit, 0..1: colours over 255, levels and detail as they are."""
    near = np.maximum(modes.detail_bias - level, 0) * 2.0 ** modes.detail_scale / 256
    choice = {LOCAL: own / 255, OTHER_ALPHA: other[:, ALPHA:] / 255,
              LOCAL_ALPHA: local[:, ALPHA:] / 255, LOD_FRACTION: (level % 1)[:, None],
              DETAIL: np.minimum(near, modes.detail_max / 255)[:, None]}
    found = choice.get(half.mselect, np.zeros((1, 1)))
    odd = np.floor(level).astype(np.int64) & modes.trilinear
    return np.where((odd == half.reverse)[:, None], 1 - found, found)


def combined(modes: Modes, level: np.ndarray, local: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The unit's ideal colours [n, 4], 0..255. ``level``: [n]; ``local``, ``other``: [n, 4]."""
    parts = []
    for half, channels in ((modes.rgb, slice(0, ALPHA)), (modes.alpha, slice(ALPHA, 4))):
        own, alpha = local[:, channels], local[:, ALPHA:]
        made = other[:, channels] * (1 - half.zero_other) - own * half.sub_local
        made = made * factor(modes, half, level, own, local, other)
        if channels.start == ALPHA:
            made = made + alpha * (half.add_local | half.add_alpha_local)
        else:
            made = made + own * half.add_local + alpha * half.add_alpha_local
        made = np.clip(made, 0, 255)
        parts.append(255 - made if half.invert else made)
    return np.concatenate(parts, -1)
