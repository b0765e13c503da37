"""Layouts of texture maps, and 16-bit colours: conversions in both directions, for all sizes."""

import itertools
from math import floor

import numpy as np
import pytest

from tmap.base import maps
from tmap.model import model
from tmap.setup import spans

SIDES = [1 << k for k in range(3, 16)]
SIZES = [size for size in itertools.product(SIDES, SIDES) if size[0] * size[1] <= 1 << 18]
TEXELS = [np.dtype(np.uint8), maps.RGB565]


def picture(width: int, height: int, texel: np.dtype) -> np.ndarray:
    noise = np.random.default_rng([width, height])
    return noise.integers(0, 256 ** texel.itemsize, (height, width)).astype(texel)


@pytest.mark.parametrize("texel", TEXELS)
def test_columns(texel) -> None:
    """Texel (u, v) is at the place that map.h says, and converting back gives the picture."""
    for width, height in SIZES:
        this = picture(width, height, texel)
        stored = maps.to_columns(this)
        assert stored.dtype == texel and stored.shape == (width * height,)
        v, u = np.indices(this.shape)
        assert np.array_equal(stored[4 * height * (u // 4) + 4 * v + u % 4], this)
        assert np.array_equal(maps.from_columns(stored, width, height), this)
        assert maps.from_columns(stored, width, height).dtype == texel


@pytest.mark.parametrize("texel", TEXELS)
def test_tiled(texel) -> None:
    """Tiles: texels are at their place, and converting back gives the picture."""
    this = picture(256, 256, texel)
    stored = maps.to_tiled(this)
    v, u = np.indices(this.shape)
    assert stored.dtype == texel
    assert np.array_equal(stored[2048 * (u // 8) + 8 * v + u % 8], this)
    assert np.array_equal(maps.from_tiled(stored), this)


def test_rgb565_to_rgb888_and_back() -> None:
    """Every 16-bit colour is widened by replicating bits; converting back is exact."""
    pixels = np.arange(65536).astype(maps.RGB565)
    colours = maps.from_rgb565(pixels)
    assert colours.dtype == np.uint8
    for value in (0x0000, 0xFFFF, 0x8410, 0x1234):
        r, g, b = value >> 11, value >> 5 & 63, value & 31
        assert colours[value].tolist() == [r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2]
    assert np.array_equal(maps.to_rgb565(colours), pixels)


def test_rgba5551_to_rgba8888_and_back() -> None:
    """Every 16-bit colour, likewise; alpha, the lowest bit, becomes all or nothing."""
    pixels = np.arange(65536).astype(np.uint16)
    colours = maps.from_rgba5551(pixels)
    assert colours.dtype == np.uint8
    for value in (0x0000, 0xFFFF, 0xF800, 0xF801, 0x8421, 0x1234):
        r, g, b = value >> 11, value >> 6 & 31, value >> 1 & 31
        assert colours[value].tolist() == [*(c << 3 | c >> 2 for c in (r, g, b)), 255 * (value & 1)]
    assert np.array_equal(maps.to_rgba5551(colours), pixels)


def test_rgb888_to_rgb565_is_the_nearest() -> None:
    """No other 16-bit colour is nearer in any component; big-endian in memory."""
    grey = np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, axis=1)
    error = np.abs(maps.from_rgb565(maps.to_rgb565(grey)).astype(int) - grey)
    assert error.max(axis=0).tolist() == [4, 2, 4]
    for part, bits in enumerate((5, 6, 5)):
        every = np.abs(maps.widened(bits).astype(int) - np.arange(256)[:, None])
        assert np.array_equal(error[:, part], every.min(axis=1))
    assert maps.to_rgb565(np.array([[255, 0, 0]], np.uint8)).tobytes() == b"\xf8\x00"


def test_model_of_a_line() -> None:
    """The coordinates that the model reads along a line are off by no more than each mapper's cut
    allows."""
    rng = np.random.default_rng(7)
    for _ in range(200):
        line = model.Line(0, 300, *(int(n) for n in rng.integers(0, 1 << 32, 2)),
                          *(int(n) for n in rng.integers(-1 << 20, 1 << 20, 2)))
        exact = model.coordinates(line)
        for mapper, cut in spans.CUT.items():
            found = model.coordinates(line, mapper)
            for one, two, bits in zip(exact, found, cut):
                off = one - two & model.M32
                assert (off <= ((1 << bits) - 1) * (np.arange(300) + 1)).all()


@pytest.mark.parametrize("way", [1, -1])
def test_steps_of_generated_code_do_not_fall_short(way: int) -> None:
    """From a texel's border, steps of any fraction down to 1/63 show the exact texels for 1,024
    pixels: with the step rounded to nearest, and with the step lower by as much as a gradient's own
    error."""
    n = np.arange(1024)
    for part in range(1, 64):
        for whole in (1, part - 1, part + 1, 100 * part + 1, 256 * part - 1):
            exact = n * way * whole // part
            step = way * whole * 65536 / part
            low = step - (whole / part / 2**15 + 3 / 2**16)
            steps = {round(step), floor(low + 0.5)}
            for step in steps:
                offsets = spans.generated_offsets(0, step, len(n))
                assert np.array_equal(offsets, model.signed(256 * exact, 16)), (way * whole, part, step)
            if whole < part:
                at = spans.texel_generated(3 << 16, 7 << 16, steps.pop(), 0, 200)
                assert np.array_equal(at, 256 * 7 + 3 + exact[:200])
