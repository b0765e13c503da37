"""Shared by the ideals of texture units: exact coordinates, the bilinear filter, errors."""

from typing import NamedTuple

import numpy as np


class Coordinate(NamedTuple):
    """Coordinates of pixels [n]. ``index``: whole texels, int64, exact; ``fraction``: float64,
    0 <= f < 1."""

    index: np.ndarray
    fraction: np.ndarray

    @property
    def value(self) -> np.ndarray:
        """Texels, float64."""
        return self.index + self.fraction


def scaled(c: Coordinate, shift: int) -> Coordinate:
    """Applies an N64 tile's shift to a coordinate: 0..10 shift right by that, 11..15 shift left by
    16 - shift."""
    if shift <= 10:
        whole = c.index >> shift
        rest = (c.index - (whole << shift) + c.fraction) / (1 << shift)
    else:
        more = (c.fraction * (1 << 16 - shift))
        whole = (c.index << 16 - shift) + np.floor(more).astype(np.int64)
        rest = more % 1
    return Coordinate(whole, rest)


def bilinear(c: list[np.ndarray], fs: np.ndarray, ft: np.ndarray) -> np.ndarray:
    """Filters texels (this one, right, below, both) [n, channels] by fractions [n] of the
    square."""
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
