"""The cubics by which lines with perspective are drawn: see c/span/cubic.h and tmap.setup.cubic."""

from functools import cache
from math import pi, sqrt

from tmap.base.elementary import cos

ERROR = 1280  # that cubics may make where 2^(k + NEAR) texels are from K in row k, units of 1/65536 texel
NEAR, ROWS = 4, 13


@cache
def fits() -> list[tuple[int, int, int, int]]:
    """Returns lambda, 0.32, and the factors of the terms, 0.31, for each row.

    Over 0 to lambda, 1 / (1 + x) is p(x) = (1 - w(x) / w(-1)) / (1 + x), w a polynomial of degree 4 with its
    root at 0: p(0) = 1, and p is a cubic. Its error is |w(x)| / (w(-1) (1 + x)). With the roots of Chebyshev's
    polynomial, shifted so that the first is at 0, |w| is R^4 / 8 at most, R = lambda / (1 + cos(pi / 8)); lambda is
    the one with which this is the error allowed, for x = 0 in the divisor.
    """
    first = cos(pi / 8)
    roots = [first - cos(k * pi / 8) for k in (3, 5, 7)]  # over R
    rows = []
    for row in range(ROWS):
        w = 1.0
        for _ in range(60):  # it converges: w is below 4 and grows slower than lambda
            r = sqrt(sqrt(ERROR / (65536 << row + NEAR) * 8 * w))
            x = [r * root for root in roots]
            w3, w2, w1 = -sum(x), x[0] * x[1] + x[0] * x[2] + x[1] * x[2], -x[0] * x[1] * x[2]
            w = 1 - w3 + w2 - w1
        p1, p2, p3 = (-w2 - (1 - w3)) / w, (1 - w3) / w, -1 / w
        rows.append((int(r * (1 + first) * (1 << 32)), *(int(-n * (1 << 31)) for n in (p1, p2 / p1, p3 / p2))))
    return rows
