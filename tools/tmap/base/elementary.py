"""Sines, exponentials and their like: the same bits on every processor.

The C library and NumPy have several versions of these functions and take the one for the processor;
their last bits differ, and a rounding to integers may show that. These are computed in decimal
digits, which are integers, and each is the float nearest to the true value; but for ``log2``.
"""

import math
from collections.abc import Callable
from decimal import Context, Decimal, localcontext
from functools import lru_cache

import numpy as np

#: More than twice the digits of a float: the result is the nearest float unless the true value is
#: within 1e-20 of the middle of two.
DIGITS = Context(prec=40)
SMALL = Decimal("1e-40")
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899863")
TO_LOG2 = 2 / float(DIGITS.ln(Decimal(2)))


def series(square: Decimal, first: Decimal, number: int) -> Decimal:
    """first - first x^2 / (n + 1)(n + 2) + ... of x^2; n: ``number``."""
    total = term = first
    while abs(term) > SMALL:
        term = -term * square / ((number + 1) * (number + 2))
        total, number = total + term, number + 2
    return total


@lru_cache(1 << 12)
def digits_of_turn(angle: float) -> tuple[Decimal, Decimal]:
    """The cosine and the sine of an angle in radians, DIGITS."""
    with localcontext(Context(prec=80)):  # large angles: what is left has DIGITS still
        quarters = (Decimal(angle) * 2 / PI).to_integral_value()
        rest = Decimal(angle) - quarters * PI / 2
    with localcontext(DIGITS):
        rest = +rest
        square = rest * rest
        c, s = series(square, Decimal(1), 0), series(square, rest, 1)
    return ((c, s), (-s, c), (-c, -s), (s, -c))[int(quarters) % 4]


def cos(angle: float) -> float:
    """Of radians."""
    return float(digits_of_turn(angle)[0])


def sin(angle: float) -> float:
    """Of radians."""
    return float(digits_of_turn(angle)[1])


def tan(angle: float) -> float:
    """Of radians."""
    c, s = digits_of_turn(angle)
    return float(DIGITS.divide(s, c))


def atan2(y: float, x: float) -> float:
    """The angle of a point, -pi to pi; 0 of the origin. The library's is off by less than 1e-15,
    of which the tangent, the square of that neglected, is found."""
    about = math.atan2(y, x)
    c, s = digits_of_turn(about)
    with localcontext(DIGITS):
        y, x = Decimal(y), Decimal(x)
        along = x * c + y * s
        return float(Decimal(about) + (y * c - x * s) / along) if along else about


def exp(x: float) -> float:
    """e to the x."""
    return float(DIGITS.exp(Decimal(x)))


def power(x: float, y: float) -> float:
    """x to the y; x is above 0, or 0 and y above."""
    return float(DIGITS.exp(DIGITS.multiply(DIGITS.ln(Decimal(x)), Decimal(y)))) if x else 0.0


def log2(values: np.ndarray) -> np.ndarray:
    """Of an array's values, minus infinity of 0: by additions and products element by element, off
    by less than 4 units of the last place of 1 or of the result."""
    part, exponent = np.frexp(values)
    low = part < math.sqrt(0.5)
    part, exponent = np.where(low, 2 * part, part), exponent - low
    z = (part - 1) / (part + 1)  # at most 0.172: log(part) = 2 (z + z^3 / 3 + z^5 / 5 + ...)
    total = np.zeros_like(z)
    for odd in range(23, 0, -2):
        total = total * (z * z) + 1 / odd
    return np.where(np.asarray(values) > 0, exponent + z * total * TO_LOG2, -math.inf)


def each(function: Callable[..., float], values: np.ndarray, *more: float) -> np.ndarray:
    """A function of each of an array's values; of equal ones once."""
    different, where = np.unique(values, return_inverse=True)
    found = np.array([function(value, *more) for value in different.tolist()], float)
    return found[where].reshape(np.shape(values))
