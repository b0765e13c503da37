"""Samples of one level: the nearest texel, or four weighted bilinearly."""

import numpy as np

from tmap.glide.coordinates import nearest, taps
from tmap.glide.lod import QUARTER, chosen
from tmap.glide.state import Modes, Unit
from tmap.glide.texels import fetch


def point(unit: Unit, s: np.ndarray, t: np.ndarray, level: np.ndarray) -> np.ndarray:
    """Returns colours [..., 4] of the texels that contain the pixels."""
    modes = unit.modes
    return fetch(unit, level, nearest(modes, s, level, 0), nearest(modes, t, level, 1))


def bilinear(unit: Unit, s: np.ndarray, t: np.ndarray, level: np.ndarray) -> np.ndarray:
    """Returns colours [..., 4] between four texels: weights of 8 or 16 bits, the sum cut off."""
    modes = unit.modes
    across, down = taps(modes, s, level, 0), taps(modes, t, level, 1)
    one = 1 << modes.fraction_bits
    fs, ft = across.fraction[..., None], down.fraction[..., None]
    total = 0
    for i, ws in ((across.first, one - fs), (across.second, fs)):
        for j, wt in ((down.first, one - ft), (down.second, ft)):
            total = total + fetch(unit, level, i, j) * ws * wt
    return total >> 2 * modes.fraction_bits


def filters_linearly(modes: Modes, lod: np.ndarray) -> np.ndarray:
    """Returns true for pixels that are filtered: at the least allowed level the map is
    magnified."""
    magnified = lod == modes.lod_min * QUARTER
    return np.where(magnified, modes.magnify, modes.minify).astype(bool)


def sample(unit: Unit, s: np.ndarray, t: np.ndarray, lod: np.ndarray) -> np.ndarray:
    """Returns texels [..., 4] of pixels at s, t (14.18) with their level of detail (8.8)."""
    level, linear = chosen(unit.modes, lod), filters_linearly(unit.modes, lod)
    if linear.all():
        return bilinear(unit, s, t, level)
    if not linear.any():
        return point(unit, s, t, level)
    return np.where(linear[..., None], bilinear(unit, s, t, level), point(unit, s, t, level))
