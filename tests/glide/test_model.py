"""The texture unit's model: reference data, and what they do not ask."""

from dataclasses import replace
from fractions import Fraction
from math import floor

import numpy as np
import pytest

from tests.helpers.arrays import check_equal
from tests.glide import reference
from tests.glide.reference import FOLDER, only, questions
from tmap.base.errors import UserError
from tmap.glide.coordinates import TOO_LARGE, TOO_SMALL, quotient, table_quotient
from tmap.glide.filters import sample
from tmap.glide.lod import LEAST, base, chosen, level_of_detail
from tmap.glide.logarithm import log2
from tmap.glide.registers import modes_of, ncc_of, words_of, words_of_ncc
from tmap.glide.state import AI88, FORMATS, ONE_W, UNIT_MEMORY, Combination, Modes, Unit
from tmap.glide.texels import level_bases, level_size
from tmap.vectors.glide_text import random_ncc, read

#: File: bits of its filter's weights.
FILES = {"tmu_combine": 4, "tmu_decal": 4, "tmu_fixedlod": 4, "tmu2_decal": 8}
ONE_14_18 = 1 << 18  # in 14.18


@pytest.mark.parametrize("name", FILES)
def test_agrees_with_reference_data(name):
    """Every answer agrees, although with perspective some could differ."""
    asked = list(questions(FOLDER / f"{name}.txt.gz", FILES[name]))
    wrong = [q for q in asked if q.answer != q.line.expected[0]]
    shown = "\n".join(f"{name}.txt.gz:{q.line.number}: {q.line.arguments}: expected "
                      f"{q.line.expected[0]:08x}, the model gives {q.answer:08x}"
                      for q in wrong[:3])
    assert len(asked) == 1000 and not wrong, f"{len(wrong)} of {len(asked)} differ:\n{shown}"


@pytest.mark.parametrize("text, message", [
    ("regs 1 2 3", "regs: 4 arguments expected, 3 found"),
    ("pix 1 2 3 4 5 6", "an answer of 1 numbers expected, 0 found"),
    ("tmemrand 5", "no command 'tmemrand'"), ("mode detail 1", "no command 'mode'"),
    ("grad 1 2 3 f", "'f' is not a decimal number")])
def test_bad_text(text, message, tmp_path):
    path = tmp_path / "x.txt"
    path.write_text(f"texrand 1\n{text}\n")
    with pytest.raises(UserError, match="x.txt:2: .*" + message):
        list(read(path))


def test_registers():
    """Every field alone, encoded and decoded."""
    modes = modes_of(0x40000001 | 10 << 8 | 0x2A << 12 | 0x111 << 21, 1 | 31 << 6 | 63 << 12
                     | 1 << 18 | 3 << 21, 200 | 32 << 8 | 7 << 14, 3, 4)
    assert modes == Modes(
        perspective=1, trilinear=1, format=10, lod_min=1, lod_max=31, lod_bias=-1, odd=1, aspect=3,
        detail_max=200, detail_bias=-32, detail_scale=7, base=24,
        rgb=Combination(sub_local=1, mselect=2, reverse=1),
        alpha=Combination(zero_other=1, mselect=4, invert=1))
    random = np.random.default_rng(3)
    for mode, lod, detail, start in random.integers(0, 1 << 32, (500, 4)).tolist():
        words = (mode & 0x7FFFF0FF | int(random.choice(list(FORMATS))) << 8, lod & 0x7FFFFF,
                 detail & 0x1FFFF, start & 0x7FFFF)
        assert words_of(modes_of(*words, 4)) == words
    with pytest.raises(UserError, match="format 7"):
        modes_of(7 << 8, 0, 0, 0, 4)


def test_tables_of_ncc():
    """Each field alone, and random tables, encoded and decoded."""
    words = np.arange(12, dtype=np.int64)
    words[0], words[4], words[11] = 0x44332211, 0x1FF << 18 | 0x100 << 9 | 0xFF, 5 << 18
    table = ncc_of(words)
    assert list(table.y[:5]) == [0x11, 0x22, 0x33, 0x44, 1]
    assert list(table.i[0]) == [-1, -256, 255] and list(table.q[3]) == [5, 0, 0]
    for seed in range(1, 9):
        for made in random_ncc(seed):
            again = ncc_of(words_of_ncc(made))
            for name in ("y", "i", "q"):
                check_equal(getattr(again, name), getattr(made, name), f"seed {seed}, {name}")


def numbered(modes: Modes) -> Unit:
    """A unit whose 16-bit texels hold their addresses, in texels."""
    memory = np.arange(UNIT_MEMORY // 2).astype("<u2").view(np.uint8)
    return Unit(replace(modes, format=AI88), memory)


def places(unit: Unit, s: np.ndarray, t: np.ndarray, lod: np.ndarray) -> np.ndarray:
    """The addresses of the texels that a numbered unit shows."""
    found = sample(unit, s, t, lod)
    return found[..., 3] << 8 | found[..., 0]


@pytest.mark.parametrize("linear, bits", [(0, 4), (1, 4), (1, 8)])
@pytest.mark.parametrize("wide", [0, 1])
@pytest.mark.parametrize("aspect", range(4))
def test_all_texel_centres(aspect, wide, linear, bits):
    """At (i + 1/2) 2^n only texel i is shown, for every level of every aspect ratio. The longer
    side ends at 256, the shorter at 256 >> aspect; if a side has one texel any coordinate shows it,
    including the middle of the side's range."""
    for level in range(9):
        unit = numbered(only(level, linear, aspect=aspect, wide=wide, fraction_bits=bits))
        width, height = level_size(unit.modes, level)
        start = level_bases(unit.modes)[level] // 2
        j, i = np.mgrid[:height, :width]
        want = start + j * width + i & 0xFFFF
        s, t = ((2 * c + 1) * (ONE_14_18 << level) // 2 for c in (i, j))
        lod = np.full(i.shape, 256 * level)
        for moved in (0, 256 * ONE_14_18, -512 * ONE_14_18):
            for name, at in (("s", (s + moved, t)), ("t", (s, t + moved))):
                check_equal(places(unit, *at, lod), want,
                            f"level {level}, {name} {moved // ONE_14_18} farther: row, column")
        longer, shorter = (s, t) if wide else (t, s)
        assert longer.max() + (ONE_14_18 << level) // 2 == 256 * ONE_14_18
        if 256 >> aspect >= 1 << level:
            assert shorter.max() + (ONE_14_18 << level) // 2 == (256 >> aspect) * ONE_14_18
        else:
            shorter[:] = (256 >> aspect) * ONE_14_18 // 2
            check_equal(places(unit, s, t, lod), want, f"level {level}, one texel: row, column")


def test_quotients():
    """The exact quotient; the table's quotient by its rules, within its bounds, and exact for
    powers of two."""
    random = np.random.default_rng(1)
    c = random.integers(-1 << 31, 1 << 31, 4000) >> random.integers(0, 31, 4000)
    w = random.integers(-1 << 31, 1 << 31, 4000) >> random.integers(0, 31, 4000)
    c[:4], w[:4] = (-1 << 31, -1 << 31, 5, 7), (-1, 1, 0, -ONE_W)
    least, most = -1 << 31, (1 << 31) - 1
    both = zip(quotient(c, w).tolist(), table_quotient(c, w).tolist())
    for a, b, (found, by_table) in zip(c.tolist(), w.tolist(), both):
        exact = Fraction(a << 30, b) if b else Fraction(0)
        want = max(least, min(floor(exact), most))
        ends = [exact * (1 + part) for part in (Fraction(TOO_LARGE), -Fraction(TOO_SMALL))]
        low, high = (max(least, min(floor(end), most)) for end in sorted(ends))
        assert found == want, f"{a} / {b}"
        assert low <= by_table <= high, f"{a} / {b} by the table"
        assert by_table == reference.table_quotient(a, b), f"{a} / {b} by the table"
        if b and abs(b) & abs(b) - 1 == 0:
            assert by_table == want, f"{a} / {b} by the table: a power of two"


def exact_log2(x: int) -> int:
    """round(256 * log2(x)) from the size of a power: with 2^(k - 1/2) <= x^256 < 2^(k + 1/2) the
    square of x^256 has 2k or 2k + 1 bits."""
    return (x ** 512).bit_length() // 2


def test_logarithm():
    """Small numbers, numbers around powers of two, and around all steps between two powers; of
    large numbers only the upper 32 bits count."""
    numbers = {*range(1, 600), *((1 << n) + d for n in range(2, 64) for d in (-1, 0, 1)),
               (1 << 64) - 1}
    for k in range(256):
        for octave in (25, 40):
            edge = round(2 ** (octave + (k + .5) / 256))
            numbers |= {edge + d for d in range(-2, 3)}
    numbers = sorted(numbers)
    cut = [x >> (n := max(x.bit_length() - 32, 0)) << n for x in numbers]
    found = log2(np.array(numbers, np.uint64)).tolist()
    wrong = [(x, logarithm, exact) for x, logarithm, exact in
             zip(numbers, found, map(exact_log2, cut), strict=True) if logarithm != exact]
    assert not wrong, f"{len(wrong)} are wrong; the first (x, found, expected): {wrong[0]}"


def test_level_of_detail():
    """The level is log2 of the longer gradient in texels, 8.8; then w, bias and limits."""
    start = base(4 * ONE_14_18, 0, 0, 0)
    assert start == 0x200
    x = y = np.array(0)
    assert level_of_detail(Modes(), start, np.array(1 << 29), x, y) == 0x200
    assert level_of_detail(Modes(perspective=1), start, np.array(1 << 29), x, y) == 0x300
    assert level_of_detail(Modes(perspective=1), start, np.array(-1 << 29), x, y) == 0x300
    assert level_of_detail(Modes(perspective=1), start, np.array(0), x, y) == 0x800
    assert base(0, 0, 3, -4) == base(0, 0, 5, 0) == base(5, 0, 1, 1)
    most = -1 << 31
    assert base(most, most, 0, 0) == 256 * 13 + 128 and base(0, 0, 0, 0) == LEAST
    bias = Modes(lod_bias=-6, lod_min=1)
    assert level_of_detail(bias, start, np.array(ONE_W), x, y) == 0x80
    assert level_of_detail(bias, base(ONE_14_18, 0, 0, 0), np.array(ONE_W), x, y) == 0x40
    assert level_of_detail(Modes(lod_max=63), np.array(0xF00), np.array(ONE_W), x, y) == 0x800


def test_dither_of_levels():
    """Sixteenths of a level in the order of a square of 4x4 pixels, which repeats."""
    y, x = np.mgrid[:8, :8]
    lod = level_of_detail(Modes(dither=1), np.array(0x100), np.array(ONE_W), x, y)
    order = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]]
    check_equal(lod, 0x100 + 16 * np.tile(order, (2, 2)), "row, column")


def test_levels_of_split_maps():
    """A unit with every other level shows the next smaller one for a missing level; so does a whole
    map whose other levels are blended in by another unit."""
    lod = np.arange(0, 0x801, 0x80)
    assert list(chosen(Modes(), lod)) == [n // 2 for n in range(17)]
    even, odd = (list(chosen(Modes(split=1, odd=k), lod)[::2]) for k in (0, 1))
    assert even == [0, 2, 2, 4, 4, 6, 6, 8, 8] and odd == [1, 1, 3, 3, 5, 5, 7, 7, 8]
    whole = Modes(trilinear=1, odd=1)
    assert list(chosen(whole, lod)[::2]) == odd


def test_memory_is_a_ring():
    """Addresses wrap at the memory's size."""
    unit = numbered(only(0, 0, base=UNIT_MEMORY - 8))
    s = np.arange(8) * ONE_14_18
    assert list(places(unit, s, s * 0, s * 0)) == [n & 0xFFFF for n in (*range(-4, 0), 0, 1, 2, 3)]
