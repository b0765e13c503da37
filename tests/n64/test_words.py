"""Command words: the manual's macros, their readable lines, and values that cannot be encoded."""

import numpy as np
import pytest

from tmap.base.errors import UserError
from tmap.n64 import commands
from tmap.n64.disassemble import line, listing
from tmap.n64.opcodes import NAMES
from tmap.n64.state import CI, I, RGBA, Inputs, Modes, State
from tmap.n64.words import Cycle, List, Wrap


def test_load_texture_block():
    """The manual's macro as lines; one of its words computed by hand."""
    words = List()
    words.load_texture_block(0x1000, RGBA, 2, 32, 16, s=Wrap(mask=5), t=Wrap(1, 1, 4, 2))
    assert listing(words.words).splitlines() == [
        "   0 set texture image RGBA 16 bits, width 1, address 0x1000",
        "   1 set tile 7: RGBA 16 bits, line 0, tmem 0, palette 0, s mask 5 shift 0, "
        "t clamp mirror mask 4 shift 2",
        "   2 load sync",
        "   3 load block 7: from (0, 0) to texel 511, dxt 256/2048",
        "   4 pipe sync",
        "   5 set tile 0: RGBA 16 bits, line 8, tmem 0, palette 0, s mask 5 shift 0, "
        "t clamp mirror mask 4 shift 2",
        "   6 set tile size 0: (0, 0) to (31, 15)"]
    assert words.words[1] == (0x35100000, 7 << 24 | 3 << 18 | 4 << 14 | 2 << 10 | 5 << 4)


def test_load_texture_tile_of_4_bits():
    """Loaded as half as many texels of 8 bits."""
    words = List()
    words.load_texture_tile(0, CI, 0, 64, (16, 2, 31, 9))
    assert [line(*word) for word in words.words[3:4]] == ["load tile 7: (8, 2) to (15.5, 9)"]
    assert line(*words.words[0]) == "set texture image CI 8 bits, width 32, address 0x0"
    assert line(*words.words[-1]) == "set tile size 0: (16, 2) to (31, 9)"


def test_modes():
    """All fields in one word, at the manual's places; running it sets the modes."""
    words = List()
    for call, choice in ((words.texture_perspective, True), (words.texture_detail, "sharpen"),
                         (words.texture_lod, True), (words.texture_lut, "ia16"),
                         (words.texture_filter, "average"),
                         (words.texture_convert, "filter, convert"), (words.cycle_type, "two")):
        call(choice)
    want = Modes(cycle=1, perspective=1, sharpen=1, lod=1, tlut=1, tlut_type=1, quad=1, mid=1,
                 filter0=1, convert_one=1)
    # the fields' places in the manual's macros
    assert words.words[-1] == (0x2F << 24 | 1 << 20 | 1 << 19 | 1 << 17 | 1 << 16 | 3 << 14
                               | 3 << 12 | 5 << 9, 0)
    state = State()
    commands.replay(state, words.words)
    assert state.modes == want == words.modes


def test_combine():
    """Both cycles' inputs at the manual's places, read back, and as a line."""
    words = List()
    zero = ("0", "0", "0", "texel0")
    words.combine_mode(Cycle(("texel1", "texel0", "lod fraction", "texel0"), zero),
                       Cycle(("combined", "0", "shade", "0"), ("0", "0", "0", "combined")))
    assert words.words == [(0x3C << 24 | 2 << 20 | 13 << 15 | 7 << 12 | 7 << 9 | 0 << 5 | 4,
                            1 << 28 | 15 << 24 | 7 << 21 | 7 << 18 | 1 << 15 | 7 << 12 | 1 << 9
                            | 7 << 6 | 7 << 3)]
    assert line(*words.words[0]) == (
        "set combine (texel1 - texel0) * lod fraction + texel0; (0 - 0) * 0 + texel0; "
        "(combined - 0) * shade + 0; (0 - 0) * 0 + combined")
    state = State()
    commands.replay(state, words.words)
    assert state.combine.rgb == (Inputs(2, 1, 13, 1), Inputs(0, 15, 4, 7))


def test_colours_and_constants():
    """Running the words sets the state; reading them gives the arguments."""
    words = List()
    words.set_convert(175, -43, -89, 222, 114, 42)
    words.prim_colour(7, 130, (1, 2, 3, 4))
    words.env_colour((255, 254, 253, 252))
    words.texture(5, 6)
    state = State()
    commands.replay(state, words.words)
    assert state.k == [175, -43, -89, 222, 114, 42]
    assert (state.min_level, state.primitive_fraction, state.primitive) == (7, 130, (1, 2, 3, 4))
    assert state.environment == (255, 254, 253, 252)
    assert (state.max_level, state.primitive_tile) == (5, 6)
    assert [line(*word) for word in words.words] == [
        "set convert 175 -43 -89 222 114 42",
        "set primitive colour #01020304, lowest level 7/32, fraction 130/256",
        "set environment colour #fffefdfc", "texture 6, highest level 5"]


@pytest.mark.parametrize("call, message", [
    (lambda w: w.load_texture_block(4, RGBA, 2, 32, 32), "address 0x4 is not a multiple of 8"),
    (lambda w: w.load_texture_block(1 << 24, RGBA, 2, 32, 32), "address: 16777216 is not"),
    (lambda w: w.load_texture_block(0, RGBA, 2, 30, 32), "rows of 60 bytes"),
    (lambda w: w.load_texture_block(0, RGBA, 3, 2, 32), "multiple of 16"),
    (lambda w: w.load_texture_block(0, RGBA, 2, 64, 64), "4096 texels; there may be 2048"),
    (lambda w: w.load_texture_block(0, I, 1, 8 * 43, 8), "rows of 43 words drift"),
    (lambda w: w.load_texture_block(0, RGBA, 0, 32, 32), "no format 0 of size 0"),
    (lambda w: w.load_texture_tile(0, RGBA, 2, 32, (8, 0, 7, 0)), "no texels"),
    (lambda w: w.load_texture_tile(0, I, 0, 31, (0, 0, 7, 0)), "must be even"),
    (lambda w: w.load_texture_tile(0, I, 1, 1025, (0, 0, 7, 0)), "width - 1: 1024 is not"),
    (lambda w: w.load_texture_tile(0, I, 1, 1024, (0, 0, 1024, 0)), "sh: 4096 is not"),
    (lambda w: w.load_tlut(17, 500, 0), "words 256 to 511"),
    (lambda w: w.load_tlut(0, 256, 0), "0 entries"),
    (lambda w: w.load_tlut_pal16(16, 0), "palette: 16 is not"),
    (lambda w: w.set_tile(8, 0, 0, 0, 0), "tile: 8 is not"),
    (lambda w: w.set_tile(0, 0, 0, 0, 0, s=Wrap(shift=16)), "shift of s: 16 is not"),
    (lambda w: w.set_convert(256, 0, 0, 0, 0, 0), "k0: 256 is not a whole number from -256"),
    (lambda w: w.set_convert(1), "six constants"),
    (lambda w: w.texture_filter("cubic"), "'cubic' is none of 'point', 'bilerp'"),
    (lambda w: w.prim_colour(0, 0, (0, 0, 256, 0)), "b: 256 is not"),
    (lambda w: w.texture(8, 0), "highest level: 8"),
])
def test_refusals(call, message):
    """Values that do not fit a field, or calls that would not do what they say."""
    with pytest.raises(UserError, match=message):
        call(List())


def test_unknown_inputs_of_the_combiner():
    words, zero = List(), ("0",) * 4
    with pytest.raises(UserError, match="colour B: 'one' is none of combined"):
        words.combine_mode(Cycle(("one", "one", "0", "0"), zero), Cycle(zero, zero))


@pytest.mark.parametrize("operation", range(64))
def test_random_words_are_read(operation):
    """Every word has a line, whatever its other bits: for a known command it begins with the name,
    for others it is the word."""
    rng = np.random.default_rng(operation)
    for hi, lo in rng.integers(0, 1 << 32, (30, 2)).tolist():
        hi = hi & ~(63 << 24) | operation << 24
        said = line(hi, lo)
        if operation in NAMES:
            assert said.startswith(NAMES[operation]) and "\n" not in said, f"{hi:08x} {lo:08x}: {said}"
        else:
            assert said == f"{hi:08x} {lo:08x}"
