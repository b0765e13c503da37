"""The exact rational ideal of a polygon with depth, and the errors of affine pieces against it.

Vertices are (x, y, u, v, w), 16.16: those of ``model.adapt``, and the depth. 1/w, u/w and v/w are
planes over the screen, through the three corners that tools/tmap/ideal/ideal.py chooses. With w_k
the corners' depths and p_k = w_0 w_1 w_2 / w_k, divided by their greatest common divisor, u is one
plane over another, N / Q:

    u = (plane through u_k p_k) / (plane through p_k)

Both planes have the same divisor, which cancels: N and Q are integers wherever x and y are.
If w is the same everywhere, Q is constant and u is tools/tmap/ideal/ideal.py's plane. u is defined
in front of the viewer, where Q > 0: in the whole polygon if w is positive at its vertices, and
beyond its edges up to the horizon.

**A line.** N = a + b i and Q = c + d i, so u = b/d + (a - b c/d) / Q. As Q grows without limit,
towards the viewer, u tends to b/d, the vanishing value, which is the same on every line.

**Affine pieces.** A piece of n pixels is exact at both its ends, u_0 with Q_0 and u_1 with Q_1,
and on the chord between them. At k pixels, with t = k/n, the curve is
(u_0 Q_0 (1 - t) + u_1 Q_1 t) / (Q_0 (1 - t) + Q_1 t), the chord u_0 (1 - t) + u_1 t, and the
curve minus the chord

    (u_1 - u_0) (Q_1 - Q_0) t (1 - t) / (Q_0 (1 - t) + Q_1 t).

Its derivative vanishes where Q_0 (1 - t)^2 = Q_1 t^2, at t = r_0 / (r_0 + r_1) with r = sqrt(Q).
There the denominator is r_0 r_1 and t (1 - t) is r_0 r_1 / (r_0 + r_1)^2, so the largest
distance is

    |u_1 - u_0| |r_1 - r_0| / (r_1 + r_0) = |u_1 - u_0| |Q_1 - Q_0| / (r_1 + r_0)^2.
"""

from dataclasses import dataclass
from fractions import Fraction
from math import gcd, sqrt

import numpy as np

from tmap.ideal import ideal
from tmap.ideal.ideal import UNIT, Plane
from tmap.ideal.rows import Rows

FLOAT = 2.0**-32  # what values and errors are rounded by, texels


@dataclass
class Rates:
    """How u goes on from the deepest pixel of each of some rows: its column, N and Q there, the growth of u a pixel, in
    texels, and that of Q as a part of Q."""

    columns: np.ndarray
    n: list[int]
    q: list[int]
    first: np.ndarray
    ratio: np.ndarray

    def moved(self, away: np.ndarray, rows: Rows | None = None) -> np.ndarray:
        """Returns what u has grown by, in texels, ``away`` pixels right of the deepest one, of one row or of the
        pixels of ``rows``."""
        first, ratio = (rows.spread(each) if rows else each for each in (self.first, self.ratio))
        return away * first / (1 + away * ratio)


class Curve:
    """One exact coordinate over the screen, from (x, y) of three points, its values there, and
    their depths, all in units; depths above 0."""

    def __init__(self, points, values, depths) -> None:
        near = [depths[k - 1] * depths[k - 2] for k in range(3)]
        common = gcd(*near)
        near = [p // common for p in near]
        self.over = Plane(points, [value * p for value, p in zip(values, near)])
        self.inverse = Plane(points, near)
        self.sign = -1 if self.inverse.d < 0 else 1

    def term(self, plane: Plane, x: int, y: int) -> int:
        """Returns N or Q at a point, from its plane."""
        rise = plane.nx * (x - plane.x0) + plane.ny * (y - plane.y0)
        return self.sign * (plane.value0 * plane.d + rise)

    def terms(self, x: int, y: int) -> tuple[int, int]:
        """Returns N and Q at a point: the value is N / Q in units, Q is proportional to 1/w."""
        return self.term(self.over, x, y), self.term(self.inverse, x, y)

    def at(self, x: int, y: int) -> Fraction:
        """Returns the exact value at a point; all in units."""
        return Fraction(*self.terms(x, y))

    def texels(self, first: int, end: int, j: int) -> list[int]:
        """The exact value at pixels ``first`` to ``end`` - 1 of line j, in texels, rounded down."""
        n, q = self.terms(first << 16, j << 16)
        dn, dq = (self.sign * plane.nx << 16 for plane in (self.over, self.inverse))
        return [(n + k * dn) // (q + k * dq << 16) for k in range(end - first)]

    def vanishing(self) -> Fraction | None:
        """The value's limit along a line, towards the viewer, in units; None at constant depth."""
        return Fraction(self.over.nx, self.inverse.nx) if self.inverse.nx else None

    def ratio(self, first: int, last: int, j: int) -> Fraction:
        """Returns the ratio of the depths at both ends of a line's pixels: 1 or more."""
        ends = [self.term(self.inverse, i << 16, j << 16) for i in (first, last)]
        return Fraction(max(ends), min(ends))

    def error(self, found: int, i: int, j: int) -> float:
        """Returns found (16.16 modulo 2^32) minus the exact value at pixel (i, j), in texels."""
        n, q = self.terms(i << 16, j << 16)
        error = (found * q - n) % (q << 32)
        return (error - (q << 32) if error >= q << 31 else error) / (q << 16)

    def terms_at(self, columns: np.ndarray, ys: np.ndarray) -> tuple[list[int], list[int]]:
        """Returns ``terms`` of several pixels: N of each, Q of each."""
        n, q = self.terms(0, 0)
        steps = [self.sign * n << 16 for plane in (self.over, self.inverse) for n in (plane.nx, plane.ny)]
        pixels = list(zip(columns.tolist(), ys.tolist()))
        return ([n + x * steps[0] + y * steps[1] for x, y in pixels],
                [q + x * steps[2] + y * steps[3] for x, y in pixels])

    def rates(self, rows: Rows) -> "Rates":
        """Returns the rates of rows in front of the viewer; others have any.

        u is k (b Q - d N) / (Q (Q + k d)) more k pixels from the deepest one than there, with N and Q there; k d
        is above 0, so nothing cancels. Six roundings of 2^-53 in a way of 2^16 texels at most: under 2^-34 texel.
        """
        dn, dq = (self.sign * plane.nx << 16 for plane in (self.over, self.inverse))
        columns = rows.lefts if dq >= 0 else rows.ends - 1
        n, q = self.terms_at(columns, rows.ys)
        first = [(dn * b - dq * a) / (b * b << 16) if b > 0 else 0.0 for a, b in zip(n, q)]
        return Rates(columns, n, q, np.array(first), np.array([dq / b if b > 0 else 0.0 for b in q]))

    def values(self, columns: np.ndarray, j: int) -> np.ndarray:
        """Returns the value at adjacent pixels ``columns`` of line j, in texels: the deepest one's
        is exact, the others' are rounded to some 2^-33 texel."""
        rates = self.rates(Rows.of(columns, j))
        return rates.n[0] / (rates.q[0] << 16) + rates.moved(columns - rates.columns)

    def errors(self, found: np.ndarray, columns: np.ndarray, j: int) -> np.ndarray:
        """Returns ``error`` for adjacent pixels ``columns`` of line j, all in front of the viewer;
        the deepest one's is exact, the others' are rounded to some 2^-33 texel."""
        return self.row_errors(found, Rows.of(columns, j))

    def row_errors(self, found: np.ndarray, rows: Rows, rates: "Rates | None" = None) -> np.ndarray:
        """Returns ``errors`` for the pixels of several rows. ``rates``: those of the rows, if they are known."""
        rates = rates or self.rates(rows)
        at = found[rows.starts + rates.columns - rows.lefts]
        exact = []
        for a, n, q in zip(at.tolist(), rates.n, rates.q):
            error = (a * q - n) % (q << 32)
            exact.append((error - (q << 32) if error >= q << 31 else error) / (q << 16))
        moved = (found - rows.spread(at)).astype(np.int32)  # modulo 2^32
        error = rows.spread(exact) + moved * UNIT - rates.moved(rows.columns - rows.spread(rates.columns), rows)
        return (error + 32768) % 65536 - 32768

    def chord_error(self, i: int, n: int, j: int) -> float:
        """Returns the largest distance of the curve from its chord over n pixels from pixel i of
        line j on, at any point between, in texels."""
        (n0, q0), (n1, q1) = (self.terms(k << 16, j << 16) for k in (i, i + n))
        rise, flatter = Fraction(n1, q1) - Fraction(n0, q0), Fraction(min(q0, q1), max(q0, q1))
        root = 1 + sqrt(flatter)
        return float(abs(rise) * (1 - flatter)) * UNIT / (root * root)

    def chord_errors(self, i: int, n: int, j: int) -> list[Fraction]:
        """The curve minus its chord over n pixels at each of them and at the end, exact; texels."""
        (n0, q0), (n1, q1) = (self.terms(k << 16, j << 16) for k in (i, i + n))
        rise = (Fraction(n1, q1) - Fraction(n0, q0)) * (q1 - q0) * Fraction(UNIT)
        return [rise * Fraction(k * (n - k), n * (q0 * (n - k) + q1 * k)) for k in range(n + 1)]


def curves(vertices) -> tuple[Curve, Curve]:
    """Returns the curves of u and v through a polygon's vertices (x, y, u, v, w)."""
    return curves_through([vertices[k] for k in ideal.corners(vertices)])


def curves_through(three) -> tuple[Curve, Curve]:
    """Returns the curves of u and v through three vertices."""
    points, depths = [v[:2] for v in three], [v[4] for v in three]
    return tuple(Curve(points, [v[k] for v in three], depths) for k in (2, 3))


def in_front(vertices) -> bool:
    """Returns true if u and v are defined in the whole polygon: it has an area, and the plane of
    1/w is positive at every vertex (more than three need not be on it)."""
    curve = curves(vertices)[0]
    return curve.inverse.d != 0 and all(curve.term(curve.inverse, *v[:2]) > 0 for v in vertices)


def depth_ratio(vertices) -> Fraction:
    """Returns the ratio of the deepest vertex's depth to the nearest one's: 1 or more."""
    depths = [v[4] for v in vertices]
    return Fraction(max(depths), min(depths))


class Picture(ideal.Picture):
    """The ideal of a triangle with depth in a frame: ``planes`` are the curves of u and v."""

    def __init__(self, vertices, width: int, height: int) -> None:
        super().__init__([v[:4] for v in vertices], width, height)
        self.planes = curves(vertices)
        self.endless = False  # the horizon may be beyond the polygon
