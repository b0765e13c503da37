"""The combine unit: this unit's texel and the colour of the next unit upstream."""

import numpy as np

from tmap.glide.lod import ONE_8_8
from tmap.glide.state import (DETAIL, LOCAL, LOCAL_ALPHA, LOD_FRACTION, OTHER_ALPHA, Combination,
                              Modes)

ALPHA = 3


def detail_factor(modes: Modes, lod: np.ndarray) -> np.ndarray:
    """Returns the weight of a detail map, 0..detail_max; it grows with nearness."""
    near = np.maximum(modes.detail_bias * ONE_8_8 - lod, 0)
    return np.minimum(near << modes.detail_scale >> 8, modes.detail_max)


def factor(modes: Modes, half: Combination, lod: np.ndarray, own: np.ndarray,
           local: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Returns the factor 0..255 of a half of the unit, [..., 1 or 3]; ``own``: the texel's channels
    of that half. mselect 6 and 7 give 0."""
    zero = np.zeros_like(own)
    choice = {LOCAL: own, OTHER_ALPHA: other[..., ALPHA:], LOCAL_ALPHA: local[..., ALPHA:],
              DETAIL: detail_factor(modes, lod)[..., None], LOD_FRACTION: (lod & 255)[..., None]}
    found = zero + choice.get(half.mselect, zero)
    flips = (lod >> 8 & modes.trilinear & 1) ^ (half.reverse ^ 1)
    return found ^ 255 * flips[..., None]


def combined(modes: Modes, lod: np.ndarray, local: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Returns the unit's output colours [..., 4]. ``lod``: 8.8 [...]; ``local``, ``other``:
    [..., 4]."""
    parts = []
    for half, channels in ((modes.rgb, slice(0, ALPHA)), (modes.alpha, slice(ALPHA, 4))):
        own, theirs = local[..., channels], other[..., channels]
        x = theirs * (1 - half.zero_other) - own * half.sub_local
        y = x * (factor(modes, half, lod, own, local, other) + 1) >> 8
        if channels.start == ALPHA:
            y = y + own * (half.add_local | half.add_alpha_local)
        else:
            y = y + own * half.add_local + local[..., ALPHA:] * half.add_alpha_local
        y = np.clip(y, 0, 255)
        parts.append(255 - y if half.invert else y)
    return np.concatenate(parts, -1)
