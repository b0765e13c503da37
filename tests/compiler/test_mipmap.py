"""Pictures of half the size: what filters keep, what they remove, and sRGB's linear light."""

import numpy as np
import pytest

from tmap.base.errors import UserError
from tmap.images.mipmap import FILTERS, LINEAR_UNTIL, from_light, halved, rounded, to_light, weights

AGAIN = "run again: .deps/venv/bin/python -m pytest -q tests/compiler/test_mipmap.py"
#: Rounding of sums of about a dozen products of doubles below 1.
EPSILON = 1e-13
BOTH = [(True, True), (True, False), (False, True), (False, False)]


def noise(width: int, height: int) -> np.ndarray:
    """A picture of random pixels."""
    return np.random.default_rng(width * 1000 + height).random((height, width, 4))


def sums(picture: np.ndarray, taps: np.ndarray, wrap: bool) -> np.ndarray:
    """Each texel of half the columns: the sum of taps over the texels around it. Beyond the ends
    the map is repeated, or its border is. One column stays."""
    width = picture.shape[1]
    if width == 1:
        return picture
    at = 2 * np.arange(width // 2)[:, None] + np.arange(taps.size) - (taps.size // 2 - 1)
    at = at % width if wrap else at.clip(0, width - 1)
    return (picture[:, at] * taps[:, None]).sum(2)


@pytest.mark.parametrize("wrap", BOTH)
@pytest.mark.parametrize("name", FILTERS)
@pytest.mark.parametrize("size", [(2, 2), (4, 1), (1, 8), (16, 8), (32, 16), (64, 64)])
def test_texels_are_sums(size, name, wrap):
    """In both directions; so one colour stays, and a mirrored or moved map gives the like."""
    picture, taps = noise(*size), np.array(weights(name))
    columns = sums(picture, taps, wrap[0])
    expected = sums(columns.swapaxes(0, 1), taps, wrap[1]).swapaxes(0, 1)
    found = halved(picture, name, wrap)
    assert found.shape == (max(size[1] // 2, 1), max(size[0] // 2, 1), 4)
    assert abs(found - expected).max() < EPSILON, AGAIN


def test_weights():
    """A box is the mean; a repeated map is the usual one. NumPy's sinc and I0 give the others'
    weights, except for last bits: symmetric ones, of which the sum is 1."""
    assert list(weights("box")) == [0.5, 0.5]
    assert np.array_equal(halved(noise(8, 8)), halved(noise(8, 8), "box", (True, True)))
    at = (np.arange(12) - 5.5) / 2
    for name, window in (("lanczos", np.sinc(at / 3)), ("kaiser", np.i0(4 * np.sqrt(1 - (at / 3) ** 2)))):
        found = np.sinc(at) * window
        assert abs(weights(name) - found / found.sum()).max() < EPSILON, AGAIN


def kept(name: str, period: float) -> float:
    """The remaining amplitude of a wave with this period in texels: the sum of the taps over the
    wave, which is real because the taps are symmetric about the middle."""
    taps = np.array(weights(name))
    at = np.arange(taps.size) - taps.size / 2 + 0.5
    return float(abs((taps * np.cos(2 * np.pi * at / period)).sum()))


@pytest.mark.parametrize("name", ["lanczos", "kaiser"])
def test_sinc_is_the_better_filter(name):
    """It keeps more than a box of waves that the smaller picture can show, and less of those that
    it cannot, from the middle of their range on."""
    for period in (32, 16, 8, 6):
        assert kept("box", period) < kept(name, period) < 2 - kept("box", period), AGAIN
    for period in (3, 2.7, 2.4, 2.1):
        assert kept(name, period) < kept("box", period), AGAIN
    wave = np.cos(2 * np.pi * (np.arange(32) + 0.5) / 8)[None, :, None]
    smaller = np.cos(2 * np.pi * (np.arange(16) + 0.5) / 4)[None, :, None]
    for each in ("box", name):
        assert abs(halved(wave, each) - kept(each, 8) * smaller).max() < EPSILON, AGAIN


def test_rounding():
    values = np.array([-3, 0, 0.49, 0.5, 254.5, 255, 270])
    assert rounded(values).tolist() == [0, 0, 0, 1, 255, 255, 255]


def test_light():
    """The conversion is reversible; numbers change half-way between two; both parts of the curve
    meet; half the light is number 188."""
    numbers = np.arange(256) / 255
    assert (from_light(to_light(numbers)) == np.arange(256)).all()
    middles = to_light((numbers[1:] + numbers[:-1]) / 2)
    assert (from_light(middles - 1e-9) == np.arange(255)).all(), AGAIN
    assert (from_light(middles + 1e-9) == np.arange(1, 256)).all(), AGAIN
    assert (to_light(numbers) <= numbers).all() and to_light(np.array(1.0)) == 1
    ends = to_light(np.array([LINEAR_UNTIL, np.nextafter(LINEAR_UNTIL, 1)]))
    assert abs(ends[1] - ends[0]) < 1e-7  # the precision of the standard's constants
    assert from_light(np.array([0.5, -1.0, 2.0])).tolist() == [188, 0, 255]


def test_unknown_filter():
    with pytest.raises(UserError, match="mip map: filter 'gauss' is none of box"):
        halved(noise(4, 4), "gauss")
