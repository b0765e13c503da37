"""Pictures of half the size: box and windowed-sinc filters, and light instead of sRGB's numbers.

A picture is float64 [height, width, channels]. Texels are squares with their centres in the
middle: a smaller picture's texel lies between two of the larger one.
"""

import math
from fractions import Fraction
from functools import cache

import numpy as np

from tmap.base.elementary import each, power, sin
from tmap.base.errors import UserError

#: Windowed sinc filters reach so far, in texels of the smaller picture.
REACH = 3
KAISER_SHAPE = 4  # the window's alpha: less rings more, more blurs more
KAISER_TERMS = 24  # of its series: the next is 4^24 / 24!^2 at most, 1e-33
FILTERS = ("box", "lanczos", "kaiser")
LINEAR_UNTIL = 0.04045  # of sRGB's curve, below which it is a straight line


def sinc(x: float) -> float:
    """sin(pi x) / (pi x), of x other than 0."""
    return sin(math.pi * x) / (math.pi * x)


def kaiser(x: Fraction) -> float:
    """The window at -1 < x < 1: I0(alpha sqrt(1 - x^2)) by its series, which has the square alone."""
    square = (1 - x * x) * KAISER_SHAPE * KAISER_SHAPE / 4
    term = total = Fraction(1)
    for n in range(1, KAISER_TERMS):
        term = term * square / (n * n)
        total += term
    return float(total)


@cache
def weights(name: str) -> list[float]:
    """A filter's weights, sum 1, of an even count of texels of the larger picture, around the
    smaller one's texel."""
    if name not in FILTERS:
        raise UserError(f"mip map: filter {name!r} is none of {', '.join(FILTERS)}")
    if name == "box":
        return [0.5, 0.5]
    distances = [Fraction(2 * k - 4 * REACH + 1, 4) for k in range(4 * REACH)]  # smaller texels
    found = [sinc(float(d)) * (sinc(float(d / REACH)) if name == "lanczos" else kaiser(d / REACH))
             for d in distances]
    return [weight / math.fsum(found) for weight in found]


def with_half_the_rows(picture: np.ndarray, name: str, wrap: bool) -> np.ndarray:
    """Beyond its ends a picture, of an even count of rows, is repeated, or its last row is. Weighed
    rows are added from the first on: BLAS's order depends on the processor."""
    rows, taps = len(picture), weights(name)
    first = 2 * np.arange(rows // 2) + 1 - len(taps) // 2
    total = 0.0
    for k, weight in enumerate(taps):
        at = first + k
        total = total + weight * picture[at % rows if wrap else np.clip(at, 0, rows - 1)]
    return total


def halved(picture: np.ndarray, name: str = "box",
           wrap: tuple[bool, bool] = (True, True)) -> np.ndarray:
    """A picture of half its sides, which are even or 1; what is 1 stays. ``wrap``: of s and t,
    whether a map is repeated there or its edges are. Sinc filters overshoot."""
    height, width = picture.shape[:2]
    if height > 1:
        picture = with_half_the_rows(picture, name, wrap[1])
    if width > 1:
        picture = with_half_the_rows(picture.swapaxes(0, 1), name, wrap[0]).swapaxes(0, 1)
    return picture


def rounded(picture: np.ndarray) -> np.ndarray:
    """0..255 in 8 bits, halves up."""
    return np.floor(np.clip(picture, 0, 255) + 0.5).astype(np.uint8)


@cache
def light_of(number: float) -> float:
    """The amount of light 0..1 of sRGB's number 0..1."""
    return number / 12.92 if number <= LINEAR_UNTIL else power((number + 0.055) / 1.055, 2.4)


def to_light(numbers: np.ndarray) -> np.ndarray:
    """Amounts of light 0..1 of sRGB's numbers 0..1."""
    return each(light_of, numbers)


@cache
def limits() -> np.ndarray:
    """The light from which sRGB's numbers 1 to 255 show, halves up."""
    return np.array([light_of((number - 0.5) / 255) for number in range(1, 256)])


def from_light(light: np.ndarray) -> np.ndarray:
    """sRGB's numbers 0..255 of amounts of light, which are cut to 0..1; uint8."""
    return np.searchsorted(limits(), light, "right").astype(np.uint8)
