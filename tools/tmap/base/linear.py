"""Products of matrices, lengths, least squares, in a stated order or exactly.

BLAS and LAPACK add up in another order, and fuse products with additions, from processor to
processor; last bits differ then, and a rounding to integers may show that. NumPy's additions,
products and quotients element by element, and square roots, are the same everywhere.
"""

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np


def product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """a @ b of matrices or vectors, the products added from the first on."""
    return sum(np.multiply.outer(a[..., k], b[k]) for k in range(a.shape[-1]))


def length(vector: Sequence[float]) -> float:
    """Of a vector: the root of the sum of its squares, added from the first on."""
    return math.sqrt(sum(c * c for c in map(float, vector)))


def solved(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """x of left @ x = right: elimination column by column, no rows exchanged. ``left``: symmetric
    and positive definite, which needs no exchange."""
    table = np.column_stack([left, right]).astype(np.float64)
    for k, row in enumerate(table):
        shares = table[:, k] / row[k]
        shares[k] = 0
        table -= np.multiply.outer(shares, row)
    return table[:, -1] / np.diag(table)


def without(column: list[Fraction], axes: list[list[Fraction]]) -> list[Fraction]:
    """What of a column is at right angles to axes that are so to each other."""
    for axis in axes:
        part = sum(map(Fraction.__mul__, column, axis)) / sum(a * a for a in axis)
        column = [c - part * a for c, a in zip(column, axis)]
    return column


def off_plane(points: np.ndarray, values: np.ndarray) -> float:
    """The most by which values [n, m] of points [n, 2] are off the planes that suit them best by
    least squares; in fractions, rounded once."""
    axes: list[list[Fraction]] = []
    for column in np.column_stack([np.ones(len(points)), points]).T.tolist():
        rest = without(list(map(Fraction, column)), axes)
        if any(rest):
            axes.append(rest)
    return float(max(abs(off) for column in np.asarray(values).T.tolist()
                     for off in without(list(map(Fraction, column)), axes)))
