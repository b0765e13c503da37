"""Pictures of half the size: box and windowed-sinc filters, and light instead of sRGB's numbers.

A picture is float64 [height, width, channels]. Texels are squares with their centres in the
middle: a smaller picture's texel lies between two of the larger one.
"""

from functools import cache

import numpy as np

from .errors import UserError

#: Windowed sinc filters reach so far, in texels of the smaller picture.
REACH = 3
KAISER_SHAPE = 4.0  # the window's alpha: less rings more, more blurs more
FILTERS = ("box", "lanczos", "kaiser")
LINEAR_UNTIL = 0.04045  # of sRGB's curve, below which it is a straight line


def weights(name: str) -> np.ndarray:
    """A filter's weights, sum 1, of an even count of texels of the larger picture, around the
    smaller one's texel."""
    if name not in FILTERS:
        raise UserError(f"mip map: filter {name!r} is none of {', '.join(FILTERS)}")
    if name == "box":
        return np.array([0.5, 0.5])
    distance = (np.arange(4 * REACH) - 2 * REACH + 0.5) / 2  # in texels of the smaller one
    if name == "lanczos":
        window = np.sinc(distance / REACH)
    else:
        window = np.i0(KAISER_SHAPE * np.sqrt(1 - (distance / REACH) ** 2))
    found = np.sinc(distance) * window
    return found / found.sum()


@cache
def halving(side: int, name: str, wrap: bool) -> np.ndarray:
    """What makes ``side`` texels (even) half as many, [side / 2, side]; beyond its ends a row is
    repeated, or its last texel is."""
    taps = weights(name)
    matrix = np.zeros((side // 2, side))
    for row in range(side // 2):
        at = 2 * row + 1 - taps.size // 2 + np.arange(taps.size)
        np.add.at(matrix[row], at % side if wrap else np.clip(at, 0, side - 1), taps)
    return matrix


def halved(picture: np.ndarray, name: str = "box",
           wrap: tuple[bool, bool] = (True, True)) -> np.ndarray:
    """A picture of half its sides, which are even or 1; what is 1 stays. ``wrap``: of s and t,
    whether a map is repeated there or its edges are. Sinc filters overshoot."""
    height, width = picture.shape[:2]
    if height > 1:
        picture = np.tensordot(halving(height, name, wrap[1]), picture, 1)
    if width > 1:
        picture = np.tensordot(picture, halving(width, name, wrap[0]), (1, 1)).swapaxes(1, 2)
    return picture


def rounded(picture: np.ndarray) -> np.ndarray:
    """0..255 in 8 bits, halves up."""
    return np.floor(np.clip(picture, 0, 255) + 0.5).astype(np.uint8)


def to_light(value: np.ndarray) -> np.ndarray:
    """Amounts of light 0..1 of sRGB's numbers 0..1."""
    return np.where(value <= LINEAR_UNTIL, value / 12.92,
                    ((np.maximum(value, 0) + 0.055) / 1.055) ** 2.4)


def from_light(light: np.ndarray) -> np.ndarray:
    """sRGB's numbers 0..1 of amounts of light, which are cut to 0..1."""
    light = np.clip(light, 0, 1)
    return np.where(light <= LINEAR_UNTIL / 12.92, light * 12.92,
                    1.055 * light ** (1 / 2.4) - 0.055)
