"""Logarithms to base 2 of integers, rounded exactly to the nearest."""

from functools import cache
from math import isqrt

import numpy as np

WORD = 64  # bits of numbers after normalisation
STEPS = 256  # per octave


@cache
def thresholds() -> np.ndarray:
    """Returns the least numbers from 2^63 to 2^64 whose logarithms, in 1/STEPS, are rounded up to
    63 * STEPS + 1, + 2, .., uint64 [STEPS].

    They are 2^(63 + (k + 1/2) / STEPS) rounded up: a root of degree 2 * STEPS, computed by
    log2(2 * STEPS) square roots in a row. Rounding each root down gives the whole root rounded
    down. No such power is an integer, so adding 1 rounds up.
    """
    found = []
    for k in range(STEPS):
        x = 1 << (WORD - 1) * 2 * STEPS + 2 * k + 1
        for _ in range((2 * STEPS).bit_length() - 1):
            x = isqrt(x)
        found.append(x + 1)
    return np.array(found, np.uint64)


def bit_length(x: np.ndarray) -> np.ndarray:
    """Returns the bit lengths of uint64 numbers, exact: floats hold 32-bit halves."""
    high, low = x >> np.uint64(32), x & np.uint64(0xFFFFFFFF)
    return np.where(high > 0, 32 + np.frexp(high.astype(np.float64))[1],
                    np.frexp(low.astype(np.float64))[1]).astype(np.int64)


def log2(x: np.ndarray) -> np.ndarray:
    """Returns round(STEPS * log2(x)) for numbers from 1 to 2^64 - 1, int64. Only the upper 32
    significant bits are used, the others are cut off. A logarithm is never halfway between two
    steps."""
    x = np.asarray(x, np.uint64)
    bits = bit_length(x)
    mantissa = x << (WORD - bits).astype(np.uint64) & np.uint64(0xFFFFFFFF << 32)
    return (bits - 1) * STEPS + np.searchsorted(thresholds(), mantissa, "right")
