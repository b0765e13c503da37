"""Fixed-point arithmetic like that of src68k, in integers."""

from typing import TypeVar

import numpy as np

Number = TypeVar("Number", int, np.ndarray)

M32 = (1 << 32) - 1
ONE = 65536  # 1.0 in 16.16


def fix(value: float) -> int:
    """Returns the nearest 16.16 number; halves round to even."""
    return round(value * ONE)


def fix_all(values) -> np.ndarray:
    """Returns the nearest 16.16 numbers to those of an array or nested lists, int64."""
    return np.rint(np.asarray(values) * ONE).astype(np.int64)


def signed(value: Number, bits: int = 32) -> Number:
    """Returns the low ``bits`` of an integer, or of each in an int64 array, as a two's complement
    number."""
    value = value & (1 << bits) - 1
    return value - (value >> bits - 1 << bits)


def counted(counts) -> np.ndarray:
    """Returns 0 to n - 1 for each n of some counts, one after the other."""
    counts = np.asarray(counts)
    ends = np.cumsum(counts)
    return np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - counts, counts)


def swap(x: int) -> int:
    """Exchanges the words of a long: 16.16 to fraction:integer and back."""
    return (x >> 16 | x << 16) & M32


def step_swapped(x: int, step: int) -> int:
    """Returns x + step, both fraction:integer, modulo 2^32: add.l, then addx.w adds its carry."""
    total = x + step
    return total & 0xFFFF0000 | (total & 0xFFFF) + (total >> 32) & 0xFFFF


def ceil16(x: Number) -> Number:
    """Returns the smallest integer not below a 16.16 number."""
    return (x + 0xFFFF) >> 16


def mul(a: int, b: int) -> int:
    """Returns a * b of two 16.16 numbers, rounded down."""
    return a * b >> 16


def mul_div(a: int, b: int, c: int) -> int:
    """Returns a * b / c rounded to the nearest integer, c > 0."""
    return (a * b + (c >> 1)) // c


def cut_quotient(n: int, d: int) -> int:
    """Returns n / d cut towards zero, d > 0."""
    return n // d if n >= 0 else -(-n // d)


def quotient(n: int, d: int) -> int:
    """Returns n / d in 32.32 modulo 2^64 as ``texturing_plane`` divides: d is cut to 32 bits."""
    sign = -1 if (n < 0) != (d < 0) else 1
    n, d = abs(n), abs(d)
    cut = max(d.bit_length() - 32, 0)
    return signed(sign * (((n >> cut) << 32) // (d >> cut)), 64)


def wide_mul(gradient: int, offset: int) -> int:
    """Returns a 32.32 gradient times a 16.16 offset, in 16.16 modulo 2^32."""
    return (gradient * offset + (1 << 31)) >> 32 & M32


def step(gradient: int, cut: int) -> int:
    """Rounds a 32.32 gradient to the nearest 16.16 step modulo 2^32 with ``cut`` low bits of 0."""
    return ((gradient + (0x8000 << cut)) >> 16 & M32) >> cut << cut
