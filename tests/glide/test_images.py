"""Mip maps of the texture unit: all levels, texels of every format, and texture memory."""

import numpy as np
import pytest

from tests.helpers.arrays import check_equal, check_within
from tmap.base.errors import UserError
from tmap.glide import images, ncc
from tmap.glide.mipmap import levels, shape_of, store
from tmap.glide.state import (A8, AP88, ARGB8332, AYIQ8422, FORMATS, P8, RGB332, RGB565,
                              UNIT_MEMORY, YIQ422, Modes, Ncc, Unit)
from tmap.glide.texels import decoded, fetch, level_size

SIDES = [1 << n for n in range(9)]
SIZES = [(w, h) for w in SIDES for h in SIDES if max(w, h) <= 8 * min(w, h)]


def noise(width: int, height: int, seed: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).integers(0, 256, (height, width, 4)).astype(np.uint8)


def smooth(side: int) -> np.ndarray:
    """A picture of gradients, with colour and alpha."""
    t, s = np.mgrid[:side, :side] / (side - 1)
    return np.rint(255 * np.stack([s, t, 1 - (s + t) / 2, s * t], -1)).astype(np.uint8)


@pytest.mark.parametrize("width, height", SIZES)
def test_sizes_of_all_levels(width, height):
    """The sizes are the unit's, for every legal size, down to 1 x 1."""
    largest, wide, aspect = shape_of(width, height)
    made = levels(noise(width, height), "box", gamma=False)
    modes = Modes(wide=wide, aspect=aspect)
    assert [level.shape[1::-1] for level in made] == [level_size(modes, n)
                                                      for n in range(largest, 9)]


@pytest.mark.parametrize("size, message", [
    ((0, 8), "0 texels wide"), ((12, 16), "12 texels wide"), ((16, 512), "512 texels high"),
    ((256, 16), "256 x 16 texels; sides may differ up to 8 times")])
def test_sizes_that_there_are_not(size, message):
    with pytest.raises(UserError, match=message):
        shape_of(*size)


def test_box_levels_are_means():
    """Levels are means of the whole picture, not of rounded levels: within half a step of 8
    bits."""
    picture = noise(32, 16)
    for n, level in enumerate(levels(picture, "box", gamma=False)):
        height, width = level.shape[:2]
        blocks = picture.reshape(height, 16 // height, width, 32 // width, 4)
        check_within(level, blocks.mean((1, 3)), 0.5 + 1e-9, f"level {n}: row, column, channel")


@pytest.mark.parametrize("how", ["box", "lanczos", "kaiser"])
def test_light_is_averaged(how):
    """Alternate texels of 0 and 254: half of 254's light is that of 187; alpha is averaged
    linearly."""
    picture = np.zeros((16, 16, 4), np.uint8)
    picture[::2, ::2] = picture[1::2, 1::2] = 254
    half = ((254 / 255 + 0.055) / 1.055) ** 2.4 / 2
    assert round(255 * (1.055 * half ** (1 / 2.4) - 0.055)) == 187
    for gamma, want in ((True, 187), (False, 127)):
        for n, level in enumerate(levels(picture, how, gamma=gamma)[1:], 1):
            check_equal(level, [want] * 3 + [127], f"level {n}, gamma {gamma}")


def test_float_pictures():
    """Pictures from 0 to 1 have the same levels as those of 8 bits; the first level is the
    picture."""
    picture = noise(16, 16)
    for gamma in (False, True):
        made = [levels(kind, gamma=gamma) for kind in (picture, picture / 255)]
        for n, (whole, of_floats) in enumerate(zip(*made, strict=True)):
            check_equal(of_floats, whole, f"level {n}, gamma {gamma}")
    check_equal(levels(picture)[0], picture)


def test_colours_by_alpha():
    """Transparent texels do not affect visible ones; if all are transparent colours are averaged as
    usual."""
    picture = np.zeros((4, 4, 4), np.uint8)
    picture[:, ::2] = 200, 100, 50, 255
    first = levels(picture, "box", gamma=False, by_alpha=True)[1]
    assert (first == [200, 100, 50, 128]).all()
    assert (levels(picture, "box", gamma=False)[1] == [100, 50, 25, 128]).all()
    picture[..., 3] = 0
    assert (levels(picture, "box", gamma=False, by_alpha=True)[1] == [100, 50, 25, 0]).all()


@pytest.mark.parametrize("form", FORMATS)
def test_what_a_map_shows_stays(form):
    """A picture that a format can show is encoded without loss; in NCC formats, whose tables are
    approximations, only its alpha."""
    shown = images.decode(images.encode(levels(noise(16, 8)), form))
    again = images.decode(images.encode(shown, form))
    channels = slice(3, 4) if form in (YIQ422, AYIQ8422) else slice(4)
    for n, (a, b) in enumerate(zip(shown, again, strict=True)):
        check_equal(b[..., channels], a[..., channels], f"level {n}")


@pytest.mark.parametrize("form", [f for f in FORMATS if f not in (P8, AP88, YIQ422, AYIQ8422)])
def test_nearest_colours(form):
    """No other value of the format is nearer in any channel: compares all its values with all
    values of a channel. Intensities are compared with grey pictures."""
    picture = np.repeat(np.arange(256, dtype=np.uint8)[None, :, None], 4, -1)
    shown = images.decode(images.encode([picture], form))[0].astype(int)
    every = decoded(form, np.arange(65536 if form >= ARGB8332 else 256))
    for channel in range(4):
        if form == A8 and channel < 3:
            continue
        values = np.unique(every[..., channel])
        least = abs(values - np.arange(256)[:, None]).min(1)
        check_equal(abs(shown[0, :, channel] - np.arange(256)), least,
                    f"channel {channel}, distance from the picture's value")


@pytest.mark.parametrize("form", [P8, AP88])
def test_palettes(form):
    """256 colours are exact; with more, each texel has the nearest entry, and the error is smaller
    than with fixed steps of 8, 8 and 4."""
    few = noise(16, 16)
    shown = images.decode(images.encode([few], form))[0]
    check_equal(shown[..., :3], few[..., :3], "256 colours: row, column, channel")
    check_equal(shown[..., 3], few[..., 3] if form == AP88 else 255, "alpha: row, column")
    picture = smooth(64)
    made = images.encode(levels(picture), form)
    shown = images.decode(made)
    for level, found in zip(levels(picture), shown, strict=True):
        every = ((level[..., None, :3].astype(int) - made.palette) ** 2).sum(-1).min(-1)
        off = ((level[..., :3].astype(int) - found[..., :3]) ** 2).sum(-1)
        check_equal(off, every, "squared distance from the colour asked for, from the nearest entry")
    coarse = images.decode(images.encode([picture], RGB332))[0]
    assert rms(shown[0], picture) < rms(coarse, picture)


def rms(shown: np.ndarray, picture: np.ndarray) -> float:
    off = shown[..., :3].astype(float) - picture[..., :3]
    return float(np.sqrt((off * off).mean()))


def with_table(table: Ncc, picture: np.ndarray) -> float:
    return rms(ncc.colours_of(table)[ncc.indices(table, picture[..., :3])], picture)


@pytest.mark.parametrize("seed", range(3))
def test_ncc_of_many_colours(seed):
    """A fit is never worse than its starting tables. If there are too many colours it uses means of
    similar ones; all pixels are counted."""
    pictures = (noise(256, 128, seed), smooth(64), noise(16, 16, seed) // 4 + smooth(16) // 2)
    picture = pictures[seed]
    colours, counts = ncc.grouped(picture[..., :3].reshape(-1, 3))
    assert counts.sum() == picture[..., 0].size and len(colours) <= ncc.MOST_COLOURS
    mean = (colours * counts[:, None]).sum(0) / counts.sum()
    assert abs(mean - picture[..., :3].mean((0, 1))).max() <= 0.5
    table = ncc.fit([picture])
    found = with_table(table, picture)
    assert 0 <= table.y.min() <= table.y.max() <= 255
    for part in (table.i, table.q):
        assert -256 <= part.min() <= part.max() <= 255
    for start in ncc.starts(colours, counts):
        assert found <= with_table(start, picture) + 1e-9


def test_ncc_of_greys():
    """All 256 greys are exact: Y, I and Q act as digits."""
    picture = np.repeat(np.arange(256, dtype=np.uint8).reshape(16, 16, 1), 4, -1)
    shown = images.decode(images.encode([picture], AYIQ8422))[0]
    check_equal(shown, picture)


def test_ncc_of_few_colours():
    """One colour alone, and four of equal brightness, are exact except for the rounding of three
    numbers."""
    for colours in ([[9, 200, 77]], [[90, 0, 0], [0, 90, 0], [0, 0, 90], [30, 30, 30]]):
        picture = np.full((4, 4, 4), 255, np.uint8)
        picture[..., :3] = np.array(colours)[np.arange(16).reshape(4, 4) % len(colours)]
        off = with_table(ncc.fit([picture]), picture)
        assert off <= 1.5, f"{len(colours)} colours: rms {off}"


def test_ncc_is_nearer_than_fixed_steps():
    """For colours as dull as in photographs; RGB332 is better for the most saturated."""
    picture = smooth(64) // 4 + 96
    fixed = images.decode(images.encode([picture], RGB332))[0]
    fitted = images.decode(images.encode([picture], YIQ422))[0]
    assert rms(fitted, picture) < rms(fixed, picture)


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("size, base, odd", [((32, 32), 0, None), ((64, 8), 4096, None),
                                             ((4, 8), UNIT_MEMORY - 65536, None),
                                             ((16, 32), 64, 0), ((32, 16), 64, 1)])
def test_memory_shows_what_was_stored(form, size, base, odd):
    """All stored levels are read back texel by texel; other memory is unchanged."""
    made = images.encode(levels(noise(*size)), form)
    unit = Unit()
    unit.memory = noise(UNIT_MEMORY // 4, 1).reshape(-1)
    before = unit.memory.copy()
    store(unit, made, base, odd)
    stored = 0
    for n, picture in enumerate(images.decode(made), shape_of(*size)[0]):
        if odd is None or n % 2 == odd:
            j, i = np.mgrid[:picture.shape[0], :picture.shape[1]]
            check_equal(fetch(unit, np.full(i.shape, n), i, j), picture,
                        f"level {n}: row, column, channel")
            stored += i.size * (2 if form >= ARGB8332 else 1)
    assert 0 < (unit.memory != before).sum() <= stored
    assert (unit.modes.lod_min, unit.modes.lod_max) == (4 * shape_of(*size)[0], 32)


def test_what_cannot_be_stored():
    made = images.encode(levels(noise(16, 16)), RGB565)
    with pytest.raises(UserError, match="base 12: not a multiple of 8"):
        store(Unit(), made, 12)
    with pytest.raises(UserError, match="level 5 has 4 x 4 texels"):
        store(Unit(), images.Map(RGB565, made.levels[::2]))
    with pytest.raises(UserError, match="no format 7"):
        images.encode(levels(noise(4, 4)), 7)
