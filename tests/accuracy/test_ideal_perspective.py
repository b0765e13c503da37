"""The exact ideal of polygons with depth: compared with plain rational arithmetic, and its
properties."""

import random
from fractions import Fraction

import numpy as np
import pytest

from tmap.accuracy import perspective_curves
from tmap.ideal import ideal, perspective
from tmap.ideal.perspective import Curve
from tmap.scene_file.scene_file import ONE

W_MIN, W_MAX = 1 << 8, 1 << 30
COUNT = 300


def triangle(rng: random.Random, spread: float = 22) -> list[tuple]:
    """(x, y, u, v, w) of three corners with an area; w over ``spread`` binary orders."""
    while True:
        made = [(*(rng.randint(-40 << 16, 200 << 16) for _ in range(2)),
                 *(rng.randint(-1 << 30, (1 << 30) - 1) >> rng.randrange(16) for _ in range(2)),
                 min(max(round(2 ** (8 + rng.uniform(0, spread))), W_MIN), W_MAX)) for _ in range(3)]
        (ax, ay, *_), (bx, by, *_), (cx, cy, *_) = made
        if (bx - ax) * (cy - ay) != (cx - ax) * (by - ay):
            return made


def weights(three, x: int, y: int) -> list[Fraction]:
    """Barycentric coordinates of a point."""
    (ax, ay, *_), (bx, by, *_), (cx, cy, *_) = three
    whole = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    b = Fraction((x - ax) * (cy - ay) - (cx - ax) * (y - ay), whole)
    c = Fraction((bx - ax) * (y - ay) - (x - ax) * (by - ay), whole)
    return [1 - b - c, b, c]


def lines(three) -> list[tuple[int, np.ndarray]]:
    """(line, columns) of a triangle's pixels."""
    found = ideal.Picture([v[:4] for v in three], 160, 120).extents
    return [(j, np.arange(*ends)) for j, ends in found.items()]


def test_value_is_what_interpolated_shares_give() -> None:
    """u is u/w divided by 1/w, each interpolated exactly over the triangle by the corners'
    barycentric coordinates: at a corner its own u and v. Q is a multiple of 1/w there."""
    rng, seen = random.Random(1), 0
    for _ in range(COUNT):
        three = triangle(rng)
        curves = perspective.curves(three)
        for part in ([rng.randint(0, 9) for _ in three], (1, 0, 0), (0, 1, 0), (0, 0, 1)):
            x, y = (sum(p * v[k] for p, v in zip(part, three)) // max(sum(part), 1) for k in (0, 1))
            shares = [b / v[4] for b, v in zip(weights(three, x, y), three)]
            if sum(shares) <= 0:
                continue
            for key, curve in zip((2, 3), curves):
                exact = sum(s * v[key] for s, v in zip(shares, three)) / sum(shares)
                assert curve.at(x, y) == exact
                seen += 1
        nearness = {Fraction(curves[0].terms(*p[:2])[1]) * p[4] for p in three}
        assert len(nearness) == 1 and nearness.pop() > 0 and perspective.in_front(three)
    assert seen > 7 * COUNT


def test_equal_depth_is_the_plane() -> None:
    """With equal depths the curve is the plane in every value, and the errors of a line are the
    same to the last bit."""
    rng = random.Random(2)
    for _ in range(COUNT):
        three = [(*v[:4], W_MAX >> rng.randrange(20)) for v in triangle(rng)]
        three = [(*v[:4], three[0][4]) for v in three]
        order = [three[k] for k in ideal.corners(three)]
        for key, curve in zip((2, 3), perspective.curves(three)):
            plane = ideal.Plane([v[:2] for v in order], [v[key] for v in order])
            x, y, found = rng.randint(-1 << 30, 1 << 30), rng.randint(-1 << 30, 1 << 30), rng.getrandbits(32)
            assert curve.at(x, y) == plane.at(x, y) and curve.vanishing() is None
            assert curve.error(found, x >> 16, y >> 16) == plane.error(found, x >> 16, y >> 16)
            columns = np.arange(7, 40)
            values = np.array([rng.getrandbits(32) for _ in columns])
            assert np.array_equal(curve.errors(values, columns, 9), plane.errors(values, columns, 9))


def test_lines_are_exact_to_the_stated_error() -> None:
    """Whole lines in double precision compared with Fractions, including depths four million to
    one."""
    rng, seen = random.Random(4), 0
    for _ in range(60):
        three = triangle(rng)
        u = perspective.curves(three)[0]
        for j, columns in rng.sample(lines(three), min(3, len(lines(three)))):
            exact = [u.at(int(i) << 16, j << 16) for i in columns]
            found = u.values(columns, j)
            assert all(abs(Fraction(float(f)) - e / ONE) < Fraction(1, 1 << 33)
                       for f, e in zip(found, exact)), three
            off = [rng.randint(-1 << 29, 1 << 29) for _ in columns]
            given = np.array([(round(e) + o) % (1 << 32) for e, o in zip(exact, off)])
            wanted = [float(round(e) + o - e) / ONE for e, o in zip(exact, off)]
            assert np.allclose(u.errors(given, columns, j), wanted, rtol=0, atol=2**-33)
            assert [u.error(int(g), int(i), j) for g, i in zip(given, columns)] == pytest.approx(
                wanted, rel=1e-12, abs=2**-40)
            seen += len(columns)
    assert seen > 2000


def test_chord_error_is_the_largest() -> None:
    """The closed form bounds the distance at every pixel, and is reached between pixels."""
    rng, seen = random.Random(5), 0
    for _ in range(COUNT):
        u = perspective.curves(triangle(rng, 12))[0]
        i, n, j = rng.randrange(100), rng.choice((4, 8, 16, 32)), rng.randrange(80)
        if min(u.term(u.inverse, k << 16, j << 16) for k in (i, i + n)) <= 0:
            continue
        found, most = u.chord_errors(i, n, j), u.chord_error(i, n, j)
        ends = [u.at(k << 16, j << 16) for k in (i, i + n)]
        for k, error in enumerate(found):
            chord = ends[0] + (ends[1] - ends[0]) * Fraction(k, n)
            assert error * ONE == u.at(i + k << 16, j << 16) - chord
        assert max(map(abs, found)) <= Fraction(most) * (1 + Fraction(1, 1 << 40))
        fine = max(abs(u.at((i << 16) + (k * n << 8), j << 16) - ends[0]
                       - (ends[1] - ends[0]) * Fraction(k, 256)) for k in range(257))
        assert fine / ONE >= Fraction(most) * Fraction(98, 100)  # the curve is flat at its maximum
        seen += most > 0
    assert seen > COUNT / 2


def test_vanishing_value_is_the_limit() -> None:
    """u = K + C / Q: along a line, uQ - KQ is constant."""
    rng, seen = random.Random(6), 0
    for _ in range(COUNT):
        for curve in perspective.curves(triangle(rng)):
            limit = curve.vanishing()
            if limit is None:
                continue
            for j in (3, 40):
                terms = [curve.terms(i << 16, j << 16) for i in (0, 17, 90)]
                assert len({n - limit * q for n, q in terms}) == 1
                seen += len({q for _, q in terms}) == 3
    assert seen > COUNT


def test_depth_ratios() -> None:
    """Depth ratios of a polygon by its vertices, of a line by its ends."""
    u = Curve([(0, 0), (256 << 16, 0), (0, 64 << 16)], [0, 256 << 16, 0], [ONE, 4 * ONE, ONE])
    assert u.ratio(0, 256, 0) == 4 == u.ratio(0, 256, 50)  # w is constant down each column
    assert u.ratio(0, 128, 0) == Fraction(8, 5) and u.vanishing() == -Fraction(256 << 16, 3)
    assert perspective.depth_ratio([(0, 0, 0, 0, w) for w in (W_MIN, ONE, W_MAX)]) == 1 << 22


def test_behind_the_viewer_nothing_is_defined() -> None:
    """A fourth vertex beyond the horizon of the other three, and vertices on a line, have no
    ideal."""
    three = [(x << 16, y << 16, 0, 0, w) for x, y, w in ((0, 0, 9 * ONE), (60, 30, ONE), (0, 60, 9 * ONE))]
    for x, is_defined in ((-7, True), (-8, False)):  # the horizon is at -7.5
        assert perspective.in_front([*three, (x << 16, 30 << 16, 0, 0, ONE)]) == is_defined
    assert not perspective.in_front([(k << 16, k << 16, 0, 0, ONE) for k in range(3)])


def test_curves_of_affine_pieces(tmp_path) -> None:
    """Shorter pieces are nearer, each with its largest chord error; the plot is written."""
    worst = {n: float(abs(perspective_curves.piece_errors(n)).max()) for n in perspective_curves.PIECES}
    curve = perspective_curves.span()
    for n, found in worst.items():
        most = max(curve.chord_error(i, n, 0) for i in range(0, perspective_curves.SPAN, n))
        assert 0.9 * most < found <= most
    assert worst[32] > 3 * worst[16] > 9 * worst[8] > 27 * worst[4] > 1
    perspective_curves.plot(tmp_path / "pieces.png")
    assert (tmp_path / "pieces.png").stat().st_size > 10_000
