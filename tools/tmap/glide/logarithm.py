"""Logarithms to base 2 of integers, rounded to the nearest exactly."""

from functools import cache
from math import isqrt

import numpy as np

WORD = 64  # bits to which numbers are shifted up
STEPS = 256  # of an octave


@cache
def thresholds() -> np.ndarray:
    """Of numbers from 2^63 to 2^64 the least whose logarithm, in 1/STEPS, is rounded up to
    63 * STEPS + 1, + 2, .., uint64 [STEPS].

    They are 2^(63 + (k + 1/2) / STEPS) rounded up: a root of degree 2 * STEPS, taken by as many
    square roots as that has bits. Floors of roots in turn are the floor of the whole root, and
    no such power is an integer, so that rounding up is adding 1.
    """
    found = []
    for k in range(STEPS):
        x = 1 << (WORD - 1) * 2 * STEPS + 2 * k + 1
        for _ in range((2 * STEPS).bit_length() - 1):
            x = isqrt(x)
        found.append(x + 1)
    return np.array(found, np.uint64)


def bit_length(x: np.ndarray) -> np.ndarray:
    """Bits of uint64 numbers, exact: floats hold 32-bit halves."""
    high, low = x >> np.uint64(32), x & np.uint64(0xFFFFFFFF)
    return np.where(high > 0, 32 + np.frexp(high.astype(np.float64))[1],
                    np.frexp(low.astype(np.float64))[1]).astype(np.int64)


def log2(x: np.ndarray) -> np.ndarray:
    """round(STEPS * log2(x)) of numbers from 1 to 2^64 - 1, int64, of which the upper 32 bits
    that count: the others are cut off. A logarithm never lies half way between two steps."""
    x = np.asarray(x, np.uint64)
    bits = bit_length(x)
    mantissa = x << (WORD - bits).astype(np.uint64) & np.uint64(0xFFFFFFFF << 32)
    return (bits - 1) * STEPS + np.searchsorted(thresholds(), mantissa, "right")
