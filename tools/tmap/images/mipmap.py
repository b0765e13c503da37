"""Pictures of half the size: box and windowed-sinc filters, and linear light instead of sRGB.

A picture is float64 [height, width, channels]. Texels are squares with their centres in the
middle: a smaller picture's texel is between two of the larger one.
"""

import math
from fractions import Fraction
from functools import cache

import numpy as np

from tmap.base.elementary import each, power, sin
from tmap.base.errors import UserError

#: The reach of windowed sinc filters, in texels of the smaller picture.
REACH = 3
KAISER_SHAPE = 4  # the window's alpha: less makes more ringing, more makes more blur
KAISER_TERMS = 24  # of its series: the next is 4^24 / 24!^2 at most, 1e-33
FILTERS = ("box", "lanczos", "kaiser")
LINEAR_UNTIL = 0.04045  # sRGB's curve is a straight line below this


def sinc(x: float) -> float:
    """Returns sin(pi x) / (pi x); x is not 0."""
    return sin(math.pi * x) / (math.pi * x)


def kaiser(x: Fraction) -> float:
    """Returns the window at -1 < x < 1: I0(alpha sqrt(1 - x^2)) by its series, which needs only the
    square."""
    square = (1 - x * x) * KAISER_SHAPE * KAISER_SHAPE / 4
    term = total = Fraction(1)
    for n in range(1, KAISER_TERMS):
        term = term * square / (n * n)
        total += term
    return float(total)


@cache
def weights(name: str) -> list[float]:
    """Returns a filter's weights, sum 1, for an even count of the larger picture's texels around
    the smaller one's texel."""
    if name not in FILTERS:
        raise UserError(f"mip map: filter {name!r} is none of {', '.join(FILTERS)}")
    if name == "box":
        return [0.5, 0.5]
    distances = [Fraction(2 * k - 4 * REACH + 1, 4) for k in range(4 * REACH)]  # smaller texels
    found = [sinc(float(d)) * (sinc(float(d / REACH)) if name == "lanczos" else kaiser(d / REACH))
             for d in distances]
    return [weight / math.fsum(found) for weight in found]


def with_half_the_rows(picture: np.ndarray, name: str, wrap: bool) -> np.ndarray:
    """Halves the rows of a picture, which has an even count of them. Beyond its ends the picture is
    repeated (``wrap``), or its outermost row. Weighted rows are added from the first on: BLAS's
    order depends on the processor."""
    rows, taps = len(picture), weights(name)
    first = 2 * np.arange(rows // 2) + 1 - len(taps) // 2
    total = 0.0
    for k, weight in enumerate(taps):
        at = first + k
        total = total + weight * picture[at % rows if wrap else np.clip(at, 0, rows - 1)]
    return total


def halved(picture: np.ndarray, name: str = "box",
           wrap: tuple[bool, bool] = (True, True)) -> np.ndarray:
    """Halves a picture's sides, which are even or 1; a side of 1 stays. ``wrap``: for s and t, true
    to repeat the map beyond its ends, false to repeat its edges. Sinc filters overshoot."""
    height, width = picture.shape[:2]
    if height > 1:
        picture = with_half_the_rows(picture, name, wrap[1])
    if width > 1:
        picture = with_half_the_rows(picture.swapaxes(0, 1), name, wrap[0]).swapaxes(0, 1)
    return picture


def rounded(picture: np.ndarray) -> np.ndarray:
    """Rounds to 8 bits, clamped to 0..255, halves up."""
    return np.floor(np.clip(picture, 0, 255) + 0.5).astype(np.uint8)


@cache
def light_of(number: float) -> float:
    """Returns the linear light 0..1 of an sRGB value 0..1."""
    return number / 12.92 if number <= LINEAR_UNTIL else power((number + 0.055) / 1.055, 2.4)


def to_light(numbers: np.ndarray) -> np.ndarray:
    """Converts sRGB values 0..1 to linear light 0..1."""
    return each(light_of, numbers)


@cache
def limits() -> np.ndarray:
    """Returns the least light that rounds to each of the sRGB values 1 to 255, halves up."""
    return np.array([light_of((number - 0.5) / 255) for number in range(1, 256)])


def from_light(light: np.ndarray) -> np.ndarray:
    """Converts linear light, clamped to 0..1, to sRGB values 0..255; uint8."""
    return np.searchsorted(limits(), light, "right").astype(np.uint8)


def levels(picture: np.ndarray, count: int) -> list[np.ndarray]:
    """Returns ``count`` pictures, each of half the sides of the one before and averaged in linear light, of a picture
    whose edges repeat; uint8 [height, width, channels], a fourth channel being alpha."""
    made, state = [], picture / 255
    state[..., :3] = to_light(state[..., :3])
    for _ in range(count):
        state = halved(state)
        made.append(np.concatenate([from_light(state[..., :3]), rounded(state[..., 3:] * 255)], axis=2))
    return made
