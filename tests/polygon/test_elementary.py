"""Functions and products that are the same on every processor, compared with libraries and exact
values."""

import math
import random

import numpy as np
import pytest

from tmap.base import elementary
from tmap.base.linear import length, off_plane, product, solved

RNG = random.Random(1)
ANGLES = [RNG.uniform(-10, 10) for _ in range(300)] + [RNG.uniform(-1e6, 1e6) for _ in range(100)]
ABOVE_0 = [RNG.uniform(0, 4) for _ in range(300)] + [2.0 ** n for n in range(-40, 41, 8)]
POINTS = [(RNG.uniform(-1, 1), RNG.uniform(-1, 1) * 10 ** RNG.uniform(-9, 9)) for _ in range(300)]
#: A function, the C library's version, which is off by 1 unit of its last place, and arguments.
BESIDE = [(elementary.sin, math.sin, [(x,) for x in ANGLES]),
          (elementary.cos, math.cos, [(x,) for x in ANGLES]),
          (elementary.tan, math.tan, [(x,) for x in ANGLES]),
          (elementary.exp, math.exp, [(x,) for x in ANGLES if abs(x) <= 10]),
          (elementary.power, math.pow, [(x, y) for x, (_, y) in zip(ABOVE_0, POINTS) if 0 < y < 10]),
          (elementary.atan2, math.atan2, POINTS)]


@pytest.mark.parametrize("ours, theirs, questions", BESIDE, ids=lambda each: getattr(each, "__name__", ""))
def test_beside_the_library(ours, theirs, questions) -> None:
    for question in questions:
        found, wanted = ours(*question), theirs(*question)
        assert abs(found - wanted) <= math.ulp(wanted), f"{question!r}: {found!r}, {wanted!r}"


def test_known_values() -> None:
    """Arguments whose result is itself a float, and pi, compared with its digits."""
    assert (elementary.sin(0.0), elementary.cos(0.0), elementary.tan(0.0)) == (0, 1, 0)
    assert elementary.sin(math.pi) == 1.2246467991473532e-16  # pi minus its float
    assert elementary.atan2(0.0, -1.0) == math.pi and elementary.atan2(1.0, 1.0) == math.pi / 4
    assert elementary.atan2(0.0, 0.0) == 0
    assert elementary.power(2, 10) == 1024 and elementary.power(0.0, 2.4) == 0 and elementary.exp(0) == 1


def test_logarithms() -> None:
    """Logarithms of powers of two are exact; others are within the documented error."""
    powers = np.arange(-60, 61)
    assert (elementary.log2(2.0 ** powers) == powers).all()
    assert elementary.log2(np.zeros(1))[0] == -math.inf
    for x, found in zip(ABOVE_0, elementary.log2(np.array(ABOVE_0)).tolist()):
        wanted = math.log2(x)
        assert abs(found - wanted) <= 4 * math.ulp(max(abs(wanted), 1)), x


def test_each_value() -> None:
    values = np.array([[1.0, 2.0], [2.0, 1.0]])
    assert elementary.each(lambda x, y: x + y, values, 3).tolist() == [[4, 5], [5, 4]]


def test_products() -> None:
    rng = np.random.default_rng(2)
    a, b = rng.integers(-99, 99, (4, 3)), rng.integers(-99, 99, (3, 5))
    assert (product(a, b) == a @ b).all()
    assert (product(a, b[:, 0]) == a @ b[:, 0]).all() and product(a[0], b[:, 0]) == a[0] @ b[:, 0]
    assert length((2, 3, 6)) == 7


@pytest.mark.parametrize("count", [1, 3, 40])
def test_solutions(count: int) -> None:
    """Integer solutions are recovered, except for the rounding of a well-posed problem."""
    rng = np.random.default_rng(count)
    half, wanted = rng.integers(-3, 4, (count, count)), rng.integers(-99, 100, count)
    left = half @ half.T + np.eye(count, dtype=int) * 10
    assert abs(solved(left, left @ wanted) - wanted).max() < 1e-9


def test_planes() -> None:
    """If one corner of a square is off by 1, each is 1/4 off the fitted plane; every other one off,
    1/2; a plane is exact. Points on a line may have any values along it."""
    corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    for values, off in (([0, 0, 1, 0], 0.25), ([0, 1, 0, 1], 0.5), ([7, 10, 5, 2], 0)):
        assert off_plane(corners, np.array([values]).T) == off
        assert off_plane(corners / 4 + 0.1, np.array([values, [0] * 4]).T) <= off + 1e-15
    assert off_plane(np.array([(0, 0), (1, 2), (2, 4)]), np.array([[0], [3], [0]])) == 2
