"""Products of matrices, lengths, least squares, in a stated order or exactly.

The order in which BLAS and LAPACK add, and whether they fuse products with additions, depends on
the processor. The last bits then differ, and rounding to integers may show that. NumPy's additions,
products and quotients element by element, and its square roots, are the same everywhere.
"""

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np


def product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns a @ b for matrices or vectors; the products are added from the first on."""
    return sum(np.multiply.outer(a[..., k], b[k]) for k in range(a.shape[-1]))


def length(vector: Sequence[float]) -> float:
    """Returns a vector's length; the squares are added from the first on."""
    return math.sqrt(sum(c * c for c in map(float, vector)))


def solved(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Solves left @ x = right for x by elimination column by column. Rows are not exchanged, which
    is safe as ``left`` is symmetric and positive definite."""
    table = np.column_stack([left, right]).astype(np.float64)
    for k, row in enumerate(table):
        shares = table[:, k] / row[k]
        shares[k] = 0
        table -= np.multiply.outer(shares, row)
    return table[:, -1] / np.diag(table)


def whole_numbers(rows: list[list[Fraction]]) -> tuple[int, list[list[int]]]:
    """Returns the least common multiple of the denominators, and all fractions times that: sums of whole numbers take
    a fifth of the time."""
    common = math.lcm(*(n.denominator for row in rows for n in row))
    return common, [[n.numerator * (common // n.denominator) for n in row] for row in rows]


def without(column: list[Fraction], axes: list[list[Fraction]]) -> list[Fraction]:
    """Returns the part of a column that is orthogonal to mutually orthogonal axes."""
    for axis in axes:
        part = sum(map(Fraction.__mul__, column, axis)) / sum(a * a for a in axis)
        column = [c - part * a for c, a in zip(column, axis)]
    return column


def off_plane(points: np.ndarray, values: np.ndarray) -> float:
    """Returns the largest distance between values [n, m] at points [n, 2] and the planes that fit
    them by least squares; computed in fractions, rounded once."""
    axes: list[list[Fraction]] = []
    for column in np.column_stack([np.ones(len(points)), points]).T.tolist():
        rest = without(list(map(Fraction, column)), axes)
        if any(rest):
            axes.append(rest)
    return float(max(abs(off) for column in np.asarray(values).T.tolist()
                     for off in without(list(map(Fraction, column)), axes)))
