"""The path to the screen: the meaning of bitplanes, and how HAM8 shows a frame.

tests/kernels/test_kernels.py compares the routines themselves with this code bit for bit.
"""

from types import SimpleNamespace

import numpy as np
import pytest

from tmap.base import maps, planar
from tmap.base.pixel_formats import FORMATS
from tmap.run import conversion

BACKGROUND = (2, 2, 2)  # palette entry 0, as c/screen/planar.h advises
ROUNDED = -1, 2  # error from the background's lower two bits: 2 - 3 to 2 - 0


def bit(block: np.ndarray, at: int, x: int) -> int:
    """A dot's bit in the row of a plane that begins at ``at``."""
    return int(block[at + x // 8]) >> 7 - x % 8 & 1


@pytest.mark.parametrize("row_pitch, plane_pitch", [(8, 24), (64, 8), (-8, 24), (12, -40)])
def test_decoder_reads_each_bit(row_pitch, plane_pitch):
    """Decodes noise bit by bit, for all arrangements of the planes; the encoder is the inverse."""
    planes = planar.Planes(64, 3, row_pitch, plane_pitch, planar.FORMS["c2p_8"].planes)
    block = np.random.default_rng(1).integers(0, 256, planes.size, np.uint8)
    dots = planes.decoded(block)
    for y in range(planes.rows):
        for x in range(planes.width):
            at = planes.first + y * row_pitch
            expected = sum(bit(block, at + k * plane_pitch, x) << k for k in range(8))
            assert dots[y, x] == expected, (row_pitch, plane_pitch, x, y)
    assert (planes.encoded(dots) == block[planes.offsets]).all()


def shown(dots: np.ndarray) -> np.ndarray:
    """The screen as the four dots of each pixel: int [row][x][dot][channel]."""
    coded = dots | planar.ham8_control(dots.shape[1])
    screen = planar.ham8_shown(coded, BACKGROUND).astype(int)
    return screen.reshape(len(dots), -1, len(planar.ORDER), 3)


@pytest.mark.parametrize("name, colours_of", [("c2p_ham8_16", maps.from_rgb565),
                                              ("c2p_ham8_5551", maps.from_rgba5551),
                                              ("c2p_ham8_32", maps.from_rgba8888)])
def test_pixels_right_halves_have_their_colour(name, colours_of):
    """The last two dots have the pixel's colour in the upper six bits; the first two have green or
    blue of the pixel to the left."""
    pixels = planar.noise(name, np.random.default_rng(2), 160, 64)
    found = shown(planar.FORMS[name].convert(pixels))
    colours = colours_of(pixels)[..., :3].astype(int)
    for dot in (2, 3):
        error = found[:, :, dot] - colours
        assert error.min() == ROUNDED[0] and error.max() == ROUNDED[1], (name, dot)
        assert (found[:, :, dot] >> 2 == colours >> 2).all(), (name, dot)
    last = found[:, :, 3]
    left = np.concatenate([np.full_like(last[:, :1], BACKGROUND), last[:, :-1]], axis=1)
    red, green, blue = range(3)
    means, ones = found.mean(axis=2), np.array((0, 1 / 4, 1 / 2))
    from_left = np.concatenate([np.full_like(colours[:, :1], 2), colours[:, :-1]], axis=1) - colours
    assert (abs(means - colours) <= 2 + abs(from_left) * ones).all()
    assert (found[:, :, 0] == np.stack([last[..., red], left[..., green], left[..., blue]], -1)).all()
    assert (found[:, :, 1] == np.stack([last[..., red], last[..., green], left[..., blue]], -1)).all()


def test_every_rgb565_colour_keeps_its_bits():
    """All 65,536 colours: five bits of red and blue and six of green can be read back from the
    screen."""
    pixels = np.arange(65536, dtype=maps.RGB565).reshape(256, 256)
    last = shown(planar.FORMS["c2p_ham8_16"].convert(pixels))[:, :, 3]
    again = last[..., 0] >> 3 << 11 | last[..., 1] >> 2 << 5 | last[..., 2] >> 3
    assert (again == pixels).all()


def test_alpha_does_not_count():
    """Frames that differ only in alpha have the same dots."""
    pixels = planar.noise("c2p_ham8_32", np.random.default_rng(3), 32, 4)
    convert = planar.FORMS["c2p_ham8_32"].convert
    assert (convert(pixels) == convert(pixels ^ 0xFF)).all()


@pytest.mark.parametrize("width, height, pixel, form, row", [
    (320, 256, (1, 1), "chunky", ("c2p_8_low", 320)), (160, 128, (2, 2), "chunky", ("c2p_8_2x1_low", 160)),
    (320, 128, (1, 2), "chunky", ("c2p_8_low", 320)), (160, 128, (1, 1), "rgb565", ("c2p_ham8_16_high", 160)),
    (168, 128, (1, 1), "rgb565", ("c2p_ham8_16_super", 160)), (168, 64, (1, 2), "rgba8888", ("c2p_ham8_32_super", 160)),
    (80, 256, (2, 1), "rgba5551", ("c2p_ham8_5551_high", 160)),
    (328, 8, (1, 1), "chunky", None), (168, 8, (2, 1), "chunky", None), (8, 129, (1, 2), "chunky", None),
    (12, 8, (1, 1), "chunky", None)])
def test_a_scenes_conversion_has_its_row_of_the_bench(width, height, pixel, form, row) -> None:
    """As struct screen_layout shows it; None where the screen refuses it."""
    scene = SimpleNamespace(width=width, height=height, pixel_width=pixel[0], pixel_height=pixel[1], format=form,
                            pixel=FORMATS[form])
    for machine, at in (("a1200", "a1200"), ("a1200-fast", "a1200-mixed"), ("a1200-030", "a1200-mixed")):
        for drawing, blits in ((0, "_blit_low"), (10 * conversion.FIELD, "_blits_low")):
            name = row and (row[0].replace("_low", blits) if machine != "a1200" else row[0])
            wanted = row and conversion.figures()[name, at, row[1]] * width * height
            assert conversion.cycles(scene, machine, drawing) == wanted
