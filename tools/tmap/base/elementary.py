"""Sines, exponentials and similar functions with the same bits on every processor.

The C library and NumPy have several versions of these functions and choose one for the processor.
Their last bits differ, and rounding to integers may show that. The functions here compute in
decimal digits, which are integers. Each result except ``log2``'s is the float nearest to the true
value.
"""

import math
from collections.abc import Callable
from decimal import Context, Decimal, localcontext
from functools import lru_cache

import numpy as np

#: More than twice the digits of a float: the result is the nearest float unless the true value is
#: within 1e-20 of the middle between two floats.
DIGITS = Context(prec=40)
SMALL = Decimal("1e-40")
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899863")
TO_LOG2 = 2 / float(DIGITS.ln(Decimal(2)))


def series(square: Decimal, first: Decimal, number: int) -> Decimal:
    """Returns first - first x^2 / (n + 1)(n + 2) + ...; ``square`` is x^2, ``number`` is n."""
    total = term = first
    while abs(term) > SMALL:
        term = -term * square / ((number + 1) * (number + 2))
        total, number = total + term, number + 2
    return total


@lru_cache(1 << 12)
def digits_of_turn(angle: float) -> tuple[Decimal, Decimal]:
    """Returns the cosine and the sine of an angle in radians to DIGITS."""
    with localcontext(Context(prec=80)):  # the rest of large angles still has DIGITS
        quarters = (Decimal(angle) * 2 / PI).to_integral_value()
        rest = Decimal(angle) - quarters * PI / 2
    with localcontext(DIGITS):
        rest = +rest
        square = rest * rest
        c, s = series(square, Decimal(1), 0), series(square, rest, 1)
    return ((c, s), (-s, c), (-c, -s), (s, -c))[int(quarters) % 4]


def cos(angle: float) -> float:
    """Returns the cosine of an angle in radians."""
    return float(digits_of_turn(angle)[0])


def sin(angle: float) -> float:
    """Returns the sine of an angle in radians."""
    return float(digits_of_turn(angle)[1])


def tan(angle: float) -> float:
    """Returns the tangent of an angle in radians."""
    c, s = digits_of_turn(angle)
    return float(DIGITS.divide(s, c))


def atan2(y: float, x: float) -> float:
    """Returns the angle of a point, -pi to pi; 0 for the origin. The library's angle is off by less
    than 1e-15. The tangent of that error, whose square is negligible, corrects it."""
    about = math.atan2(y, x)
    c, s = digits_of_turn(about)
    with localcontext(DIGITS):
        y, x = Decimal(y), Decimal(x)
        along = x * c + y * s
        return float(Decimal(about) + (y * c - x * s) / along) if along else about


def exp(x: float) -> float:
    """Returns e to the x."""
    return float(DIGITS.exp(Decimal(x)))


def power(x: float, y: float) -> float:
    """Returns x to the y; x is above 0, or x is 0 and y is above 0."""
    return float(DIGITS.exp(DIGITS.multiply(DIGITS.ln(Decimal(x)), Decimal(y)))) if x else 0.0


def log2(values: np.ndarray) -> np.ndarray:
    """Returns the logarithms of an array's values, minus infinity for 0. They are computed by
    additions and products element by element, with errors below 4 units in the last place of 1 or
    of the result."""
    part, exponent = np.frexp(values)
    low = part < math.sqrt(0.5)
    part, exponent = np.where(low, 2 * part, part), exponent - low
    z = (part - 1) / (part + 1)  # at most 0.172: log(part) = 2 (z + z^3 / 3 + z^5 / 5 + ...)
    total = np.zeros_like(z)
    for odd in range(23, 0, -2):
        total = total * (z * z) + 1 / odd
    return np.where(np.asarray(values) > 0, exponent + z * total * TO_LOG2, -math.inf)


def each(function: Callable[..., float], values: np.ndarray, *more: float) -> np.ndarray:
    """Returns a function of each of an array's values; equal values are computed once."""
    different, where = np.unique(values, return_inverse=True)
    found = np.array([function(value, *more) for value in different.tolist()], float)
    return found[where].reshape(np.shape(values))
