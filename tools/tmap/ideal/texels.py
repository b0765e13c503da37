"""Shared by the ideals of texture units: exact coordinates, the bilinear filter, errors."""

from typing import NamedTuple

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import ONE
from tmap.ideal.ideal import Plane


class Coordinate(NamedTuple):
    """Coordinates of pixels [n]: exact whole texels, int64; ``fraction``: float64, 0 <= f < 1."""

    index: np.ndarray
    fraction: np.ndarray

    @property
    def value(self) -> np.ndarray:
        """Texels, float64."""
        return self.index + self.fraction


class Quotients:
    """The exact s and t of a planar polygon, from three points (x, y), 16.16, and there s and t
    over a depth and 1 over it, all multiplied by one factor."""

    def __init__(self, points, overs, inverse):
        self.over = [Plane(points, values) for values in overs]
        self.inverse = Plane(points, inverse)
        if not self.inverse.d:
            raise UserError("ideal: the polygon has no area")

    def terms(self, x: np.ndarray, y: np.ndarray) -> list[np.ndarray]:
        """Returns the three values at pixels [n], all scaled by the same factor, as objects."""
        found = []
        for plane in (*self.over, self.inverse):
            rise = (np.asarray(x).astype(object) * ONE - plane.x0) * plane.nx
            rise = rise + (np.asarray(y).astype(object) * ONE - plane.y0) * plane.ny
            found.append((rise + plane.value0 * plane.d) * (1 if plane.d > 0 else -1))
        if (found[-1] <= 0).any():
            raise UserError("ideal: a pixel lies behind the viewer")
        return found

    def at(self, x: np.ndarray, y: np.ndarray) -> tuple[Coordinate, Coordinate]:
        """Returns s and t in texels at pixels [n], exact."""
        *overs, inverse = self.terms(x, y)
        index = [over // inverse for over in overs]
        return tuple(Coordinate(whole.astype(np.int64),
                                ((over - whole * inverse) / inverse).astype(np.float64))
                     for over, whole in zip(overs, index))


def scaled(c: Coordinate, shift: int) -> Coordinate:
    """Applies an N64 tile's shift: 0..10 shift right by that, 11..15 shift left by 16 - shift."""
    if shift <= 10:
        whole = c.index >> shift
        rest = (c.index - (whole << shift) + c.fraction) / (1 << shift)
    else:
        more = (c.fraction * (1 << 16 - shift))
        whole = (c.index << 16 - shift) + np.floor(more).astype(np.int64)
        rest = more % 1
    return Coordinate(whole, rest)


def bilinear(c: list[np.ndarray], fs: np.ndarray, ft: np.ndarray) -> np.ndarray:
    """Filters texels (this one, right, below, both) [n, channels] by fractions [n]."""
    (c00, c10, c01, c11), fs, ft = c, fs[:, None], ft[:, None]
    upper, lower = c00 + fs * (c10 - c00), c01 + fs * (c11 - c01)
    return upper + ft * (lower - upper)


class Error(NamedTuple):
    """The errors of colours, in 1/255 of the brightest."""

    most: float
    rms: float


def error(drawn: np.ndarray, ideal: np.ndarray, channels: int = 3) -> Error:
    """Compares colours [n, 4], drawn and ideal, in their first channels."""
    off = np.abs(drawn[..., :channels].astype(np.float64) - ideal[..., :channels])
    if not off.size:
        return Error(0.0, 0.0)
    return Error(float(off.max()), float(np.sqrt((off * off).mean())))
