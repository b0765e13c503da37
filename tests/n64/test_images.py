"""Pictures in the texture formats: encoded and decoded, through DRAM and through TMEM."""

import numpy as np
import pytest
from PIL import Image

from tests.helpers.arrays import check_equal, check_within
from tests.n64.scene import noise, smooth
from tmap.base.errors import UserError
from tmap.n64 import images
from tmap.n64.state import CI, I, IA, RGBA, YUV

FORMATS = [(RGBA, 2), (RGBA, 3), (CI, 0), (CI, 1), (IA, 0), (IA, 1), (IA, 2), (I, 0), (I, 1),
           (YUV, 2)]


def grown(picture: np.ndarray) -> np.ndarray:
    """The picture with random alpha."""
    picture = picture.copy()
    picture[..., 3] = np.random.default_rng(9).integers(0, 256, picture.shape[:2])
    return picture


@pytest.mark.parametrize("form, size", FORMATS)
@pytest.mark.parametrize("width, height", [(16, 8), (13, 5), (1, 1)])
def test_what_a_texture_shows_stays(form, size, width, height):
    """A picture that a format can show is encoded without loss. For YUV, whose texels share chroma
    in pairs, only the size is tested: ``test_yuv_is_near`` has the rest."""
    picture = grown(noise(width, height))
    first = images.encode(picture, form, size)
    shown = images.decode(first)
    assert shown.shape == picture.shape
    assert len(first.data) == first.row_texels * height << size >> 1
    if form == YUV:
        return
    again = images.encode(shown, form, size)
    check_equal(images.decode(again), shown)


def test_all_16_bit_colours_are_exact():
    """Each RGBA texel is decoded and encoded to the same value."""
    values = np.arange(65536).reshape(256, 256)
    texture = images.Texture(RGBA, 2, 256, 256, 256, values.astype(">u2").tobytes())
    assert images.encode(images.decode(texture), RGBA, 2) == texture


@pytest.mark.parametrize("form, size, bits", [(RGBA, 2, 5), (RGBA, 3, 8), (IA, 2, 8), (IA, 1, 4),
                                              (IA, 0, 3), (I, 1, 8), (I, 0, 4)])
def test_formats_are_as_near_as_their_bits_allow(form, size, bits):
    """Bits are repeated to make 8: two neighbouring values differ by at most 255 / (2^bits - 1)
    rounded up, so the nearest one is within half of that. Intensity formats use grey pictures,
    which they can represent."""
    picture = noise(64, 64)
    if form in (IA, I):
        picture[..., 1] = picture[..., 2] = picture[..., 0]
    shown = images.decode(images.encode(picture, form, size))[..., :3]
    check_within(shown, picture[..., :3], -(-255 // ((1 << bits) - 1)) // 2, "row, column, channel")


def test_yuv_is_near():
    """A grey picture loses only the rounding of Y, 298/256 of half a step, and half a step of the
    result: less than 2. In a colour U and V are rounded too, with weights up to 445/256, and the
    sum is rounded before it is multiplied: (1/2 + 445/512 + 1/2) 298/256 + 1/2 is less than 3."""
    picture = np.repeat(np.arange(256, dtype=np.uint8).reshape(16, 16, 1), 4, -1)
    picture[..., 3] = 255
    check_within(images.decode(images.encode(picture, YUV, 2)), picture, 1, "grey: row, column")
    pairs = np.repeat(smooth(32)[:, ::2], 2, 1)  # pairs of texels share their chroma
    check_within(images.decode(images.encode(pairs, YUV, 2)), pairs, 2, "row, column, channel")


def rms(shown: np.ndarray, picture: np.ndarray) -> float:
    return np.sqrt(((shown.astype(float) - picture) ** 2).mean())


@pytest.mark.parametrize("size, count, fixed", [(0, 16, (2, 4, 2)), (1, 256, (8, 8, 4))])
def test_palettes(size, count, fixed):
    """Few colours are exact; for many, a palette is nearer than one of fixed steps."""
    few = noise(count, 1)[0][np.random.default_rng(1).integers(0, count, (16, 16))]
    texture = images.encode(few, CI, size)
    check_equal(images.decode(texture), images.decode(images.encode(few, RGBA, 2)))
    many = images.encode(smooth(64), CI, size)
    assert len(many.tlut) <= 2 * count
    steps = 256 / np.array(fixed)
    coarse = (smooth(64)[..., :3] // steps + 0.5) * steps
    assert rms(images.decode(many)[..., :3], smooth(64)[..., :3]) < rms(coarse, smooth(64)[..., :3])


@pytest.mark.parametrize("size", [0, 1])
def test_palettes_of_alpha(size):
    """Palettes of IA16 are nearer than fixed steps of intensity and alpha."""
    picture = grown(smooth(64))
    shown = images.decode(images.encode(picture, CI, size, ia=True))
    grey = images.decode(images.encode(picture, IA, 2))
    steps = 64 if size == 0 else 16  # of a fixed palette, in both channels
    coarse = (grey // steps + 0.5) * steps
    assert rms(shown, grey) < rms(coarse, grey)


def test_transparency_of_palettes():
    """Transparent texels have a separate entry."""
    picture = smooth(64)
    picture[:32, :, 3] = 0
    for size in (0, 1):
        check_equal(images.decode(images.encode(picture, CI, size))[..., 3], picture[..., 3])


def test_levels_are_means_of_four():
    """Of two if a side has only one texel; other sides must be even."""
    levels = images.chain(noise(8, 2), 4)
    assert [level.shape[:2] for level in levels] == [(2, 8), (1, 4), (1, 2), (1, 1)]
    mean = levels[0][:2, 2:4].astype(int).sum((0, 1)) + 2 >> 2
    check_equal(levels[1][0, 1], mean, "level 1")
    check_equal(levels[2][0, 0], levels[1][0, :2].astype(int).sum(0) + 1 >> 1, "level 2")
    with pytest.raises(UserError, match="6 x 3 texels has no half"):
        images.chain(noise(12, 6), 3)


def test_files(tmp_path):
    """Pictures are read unchanged; the error names a missing file."""
    picture = grown(noise(16, 8))
    Image.fromarray(picture).save(tmp_path / "a.png")
    check_equal(images.read("a.png", tmp_path, "here", 16, 8), picture)
    with pytest.raises(UserError, match="here: b.png: no such file"):
        images.read("b.png", tmp_path, "here", 16, 8)


@pytest.mark.parametrize("form, size", [(RGBA, 0), (YUV, 3), (IA, 3), (7, 2)])
def test_unknown_formats(form, size):
    with pytest.raises(UserError, match="texture: there is no"):
        images.encode(noise(8, 8), form, size)
