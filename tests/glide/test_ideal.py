"""The texture unit's ideal: exact coordinates and levels; bounds of the model's error."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from tests.helpers.arrays import check_equal, check_within
from tmap.base.errors import UserError
from tmap.glide import combine
from tmap.glide.chain import Point, chain_pixel
from tmap.glide.coordinates import TOO_LARGE, coordinates
from tmap.glide.filters import sample
from tmap.glide.functions import FACTORS, FUNCTIONS, combine as combine_by, trilinear_pair
from tmap.glide.lod import base, level_of_detail
from tmap.glide.state import ARGB4444, ONE_W, UNIT_MEMORY, Modes, Unit
from tmap.ideal import glide
from tmap.ideal.glide import Corner, Surface
from tmap.ideal.texels import Coordinate

ONE_14_18 = 1 << 18  # in 14.18
N = 65536  # in 16.16
ROUNDING = 2.0**-36  # error of the ideal itself
#: A polygon that recedes: s/w, t/w, 1/w.
FAR = [Corner(0, 0, 0, 0, ONE_W), Corner(60 * N, 3 * N, 100 * ONE_14_18, 7 * ONE_14_18, ONE_W // 2),
       Corner(5 * N, 50 * N, -9 * ONE_14_18, 40 * ONE_14_18, ONE_W // 7)]
FLAT = [corner._replace(w=ONE_W) for corner in FAR]
Y, X = (c.ravel() for c in np.mgrid[0:20:3, 0:30:4])


def unit(**modes) -> Unit:
    """A unit with noise in its memory."""
    memory = np.random.default_rng(2).integers(0, 256, UNIT_MEMORY).astype(np.uint8)
    return Unit(Modes(format=ARGB4444, minify=1, magnify=1, **modes), memory)


def share(polygon: list[Corner], x: int, y: int) -> list[Fraction]:
    """s/w, t/w and 1/w at a point, by barycentric coordinates."""
    (ax, ay), (bx, by), (cx, cy) = (corner[:2] for corner in polygon)
    area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    b = Fraction((x - ax) * (cy - ay) - (cx - ax) * (y - ay), area)
    c = Fraction((bx - ax) * (y - ay) - (x - ax) * (by - ay), area)
    return [(1 - b - c) * polygon[0][k] + b * polygon[1][k] + c * polygon[2][k] for k in (2, 3, 4)]


@pytest.mark.parametrize("perspective", [True, False])
@pytest.mark.parametrize("polygon", [FAR, FLAT, FAR[::-1]])
def test_coordinates_are_exact(polygon, perspective):
    """The integer part is exact, the fraction is the nearest double, compared with barycentric
    coordinates."""
    found = Surface(polygon, perspective).at(X, Y)
    for x, y, s_at, t_at in zip(X, Y, *(zip(*c) for c in found)):
        s, t, w = share(polygon, int(x) * N, int(y) * N)
        for name, value, at in (("s", s, s_at), ("t", t, t_at)):
            exact = value / (w if perspective else ONE_W) * Fraction(ONE_W, ONE_14_18)
            assert tuple(at) == (exact // 1, float(exact % 1)), f"{name} at pixel ({x}, {y})"


def test_levels_are_those_of_derivatives():
    """A quotient's change over any distance h, times the divisor there and over h, is its slope
    times the divisor here."""
    def at(x, y):
        s, t, w = share(FAR, x, y)
        return [s / w * 4096, t / w * 4096], w

    found = Surface(FAR, True).level(X, Y)
    for x, y, level in zip((X * N).tolist(), (Y * N).tolist(), found):
        here, w = at(x, y)
        most = 0
        for dx, dy in ((N, 0), (0, N)):
            there, divisor = at(x + dx, y + dy)
            most = max(most, sum(((b - a) * divisor / w) ** 2 for a, b in zip(here, there)))
        assert abs(level - np.log2(float(most)) / 2) < ROUNDING, f"at ({x / N:g}, {y / N:g})"
    still = [corner._replace(s=5, t=7) for corner in FLAT]
    assert (Surface(still, False).level(X, Y) == -np.inf).all()


def test_level_of_the_unit():
    """If w is constant the unit's level is the true one except for rounding: half of 1/256 for the
    gradients, and as much for w."""
    for w in (ONE_W, ONE_W // 3, 12345):
        polygon = [corner._replace(w=w) for corner in FAR]
        s, t = ([share(polygon, x, y)[k] for x, y in ((0, 0), (N, 0), (0, N))] for k in (0, 1))
        steps = [int(c[k] - c[0]) for k in (1, 2) for c in (s, t)]
        corners = [Corner(0, 0, 0, 0, w), Corner(N, 0, steps[0], steps[1], w),
                   Corner(0, N, steps[2], steps[3], w)]
        true = Surface(corners, True).level(np.array([0]), np.array([0]))
        limits = Modes(perspective=1)
        found = level_of_detail(limits, base(*steps), np.array(w), np.array(0), np.array(0))
        check_within(found / 256, glide.limited(limits, true), 1 / 256 + ROUNDING, f"w {w}")


def test_levels_are_biased_and_limited():
    """Limits and bias are in quarters."""
    modes = Modes(lod_min=2, lod_max=20, lod_bias=-6)
    assert glide.limited(modes, np.array([-np.inf, 1, 3, 9])).tolist() == [0.5, 0.5, 1.5, 5]


def placed(s: np.ndarray, t: np.ndarray) -> list[Coordinate]:
    """Exact coordinates of 14.18."""
    return [Coordinate(c >> 18, (c & ONE_14_18 - 1) / ONE_14_18) for c in (s, t)]


def weights_error(bits: int) -> float:
    """How far a bilinear sample may be below and above the ideal: fractions of both axes are cut to
    ``bits`` bits, each by less than a step, and colours change by up to 255 a texel; cutting the
    result adds 1."""
    return 2 * 255 / (1 << bits) + 1


@pytest.mark.parametrize("bits", [4, 8])
@pytest.mark.parametrize("clamp", [0, 1])
def test_bilinear_and_point_samples(bits, clamp):
    """Bilinear samples are within the error of cut weights; point samples show the ideal's
    texel."""
    random = np.random.default_rng(6)
    on = unit(fraction_bits=bits, clamp_s=clamp, clamp_t=clamp, aspect=1)
    s, t = random.integers(-1 << 28, 1 << 28, (2, 2000))
    level = random.integers(0, 9, 2000)
    drawn = sample(on, s, t, level * 256)
    wanted = glide.sample(on, *placed(s, t), level * 1.0, "bilinear")
    check_within(drawn, wanted, weights_error(bits), "bilinear: place, channel")
    on.modes = replace(on.modes, minify=0, magnify=0)
    wanted = glide.sample(on, *placed(s, t), level * 1.0, "point")
    check_equal(sample(on, s, t, level * 256), wanted, "point: place, channel")


def test_perspective():
    """Iterated numbers are rounded by half a unit each, so the error of s is half a unit of s/w
    plus s times half a unit of 1/w, over the rounded 1/w. The quotient is cut, and with the table
    has the reciprocal's error too."""
    shares = [share(FAR, int(x) * N, int(y) * N) for x, y in zip(X, Y)]
    iterated = [np.array([round(three[k]) for three in shares]) for k in range(3)]
    exacts = Surface(FAR, True).at(X, Y)
    ways = [(coordinates(Modes(perspective=1, table_quotients=k), *iterated), k * TOO_LARGE)
            for k in (0, 1)]
    for found, exact, part in ((*two, part) for drawn, part in ways for two in zip(drawn, exacts)):
        most = (0.5 / ONE_14_18
                + abs(exact.value) * 0.5 / ONE_W) / (iterated[2] / ONE_W) + 1 / ONE_14_18
        most += (abs(exact.value) + most) * part
        check_within(found / ONE_14_18, exact.value, most + ROUNDING, f"table's part {part}: pixel")


@pytest.mark.parametrize("size", [8, 16])
def test_perspective_in_pieces(size):
    """Lines of 1 to 70 pixels, w rising and falling up to 300 times, of both signs. A value is on
    the straight line between exact quotients; the true curve bends away from it by up to
    |difference of the ends| * |r - 1| / (r + 1), and ``size`` roundings lower the value."""
    random, bent = np.random.default_rng(5), 0
    for count in (1, 2, size, size + 1, 2 * size, 70, 70, 70, 70):
        ends = np.exp(random.uniform(0, 5.7, 2)) * random.choice((1, -1)) * 3e6
        w = np.linspace(*ends, count).astype(np.int64)
        w = w[0] + np.arange(count) * ((w[-1] - w[0]) // max(count - 1, 1))
        place = np.arange(count)
        s = place * int(random.integers(-90000, 90000)) + int(random.integers(-1 << 20, 1 << 20))
        modes = Modes(perspective=1, subdivision=size)
        found, _ = coordinates(modes, s, s, w, place, count - 1 - place)
        exact = [Fraction(int(a) << 30, int(b)) for a, b in zip(s, w)]
        for n in range(count):
            first = n // size * size
            last = min(first + size, count - 1)
            r = np.sqrt(w[last] / w[first])
            most = float(abs(exact[last] - exact[first])) * abs(r - 1) / (r + 1) * (1 + ROUNDING)
            off = float(found[n] - exact[n])
            assert -most - size <= off <= most + ROUNDING, (
                f"{count} pixels, w {w[0]} to {w[-1]}, pixel {n}: off by {off} units of 1/2^18; "
                f"from {-most - size} to {most} may be")
            bent = max(bent, abs(off) - size)
    assert bent > ONE_14_18 / 64  # some lines do bend


def test_trilinear_samples():
    """One pass compared with the ideal at the same level: the error is the larger of both samples'
    errors, as they are mixed, plus 255/256 for the weight w + 1 instead of w, plus the cut of the
    result."""
    random = np.random.default_rng(7)
    s, t = random.integers(-1 << 28, 1 << 28, (2, 2000))
    lod = random.integers(0, 0x801, 2000)
    for bits in (4, 8):
        on = unit(fraction_bits=bits, split=1)
        units = [Unit(modes, on.memory) for modes in trilinear_pair(on.modes)]
        point = Point(s, t, ONE_W, lod)
        drawn = chain_pixel(units, [point, point])
        wanted = glide.sample(units[0], *placed(s, t), lod / 256, "trilinear", units[1])
        inside = lod < 0x800  # after level 8 there is no level: the unit of odd levels is undefined
        check_within(drawn[inside], wanted[inside], weights_error(bits) + 255 / 256 + 1,
                     f"weights of {bits} bits: place, channel")


@pytest.mark.parametrize("factor", FACTORS)
@pytest.mark.parametrize("function", FUNCTIONS)
def test_combine_unit(function, factor):
    """(m + 1) / 256 differs from m / 255 or m / 256 by 1/256 at most. A detail factor is also cut
    to 1/256 and limited to max out of 255: 1/256 more each. Differences of colours are up to 255;
    the product is cut. Sums and limits add nothing."""
    random = np.random.default_rng(9)
    local, other = random.integers(0, 256, (2, 400, 4))
    lod = random.integers(0, 0x801, 400)
    steps = 3 if "detail" in factor else 1
    for trilinear in (0, 1):
        for invert in (0, 1):
            modes = combine_by(Modes(trilinear=trilinear, detail_bias=6, detail_scale=5,
                                     detail_max=170), function, factor, invert)
            drawn = combine.combined(modes, lod, local, other)
            wanted = glide.combined(modes, lod / 256, local * 1.0, other * 1.0)
            check_within(drawn, wanted, steps * 255 / 256 + 1,
                         f"trilinear {trilinear}, inverted {invert}: case, channel")


def test_refusals():
    on = unit(split=1, odd=1)
    at = placed(*np.zeros((2, 3), np.int64))
    with pytest.raises(UserError, match="the map lacks a level"):
        glide.sample(on, *at, np.zeros(3), "bilinear")
    with pytest.raises(UserError, match="filter 'cubic' is none of point"):
        glide.sample(on, *at, np.zeros(3), "cubic")
    with pytest.raises(UserError, match="behind the viewer"):
        Surface([corner._replace(w=-5) for corner in FAR], True).at(X, Y)
    with pytest.raises(UserError, match="no area"):
        Surface([FAR[0]] * 3, True)
