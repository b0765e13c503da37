"""Decoded tiles of the texture engine: every texel and quad equals the general way's result; tiles
are decoded again only when needed."""

import random
from collections.abc import Iterator
from dataclasses import dataclass

import pytest
from tests.n64.guest import (BITS_16, BITS_32, BITS_4, BITS_8, CI, I, IA, RESULTS, RGBA, WRAPPED,
                             YUV, Guest, modes)
from tests.helpers import vector_guest

NEXT, CHROMA = 1, 2  # quads
RGBA_TLUT, IA_TLUT = {"tlut": 1}, {"tlut": 1, "tlut_type": 1}
#: Format, size, modes; no manual allows the last ones.
FORMATS = {
    "RGBA 16": (RGBA, BITS_16, {}), "RGBA 32": (RGBA, BITS_32, {}), "YUV": (YUV, BITS_16, {}),
    "IA 4": (IA, BITS_4, {}), "IA 8": (IA, BITS_8, {}), "IA 16": (IA, BITS_16, {}),
    "I 4": (I, BITS_4, {}), "I 8": (I, BITS_8, {}), "CI 4": (CI, BITS_4, RGBA_TLUT),
    "CI 8": (CI, BITS_8, RGBA_TLUT), "CI 4 by IA": (CI, BITS_4, IA_TLUT),
    "CI 8 by IA": (CI, BITS_8, IA_TLUT),
    "CI 4 as it is": (CI, BITS_4, {}), "RGBA 8": (RGBA, BITS_8, {}), "I 16": (I, BITS_16, {}),
    "IA 32": (IA, BITS_32, {}), "RGBA 16 by TLUT": (RGBA, BITS_16, RGBA_TLUT),
    "IA 8 by TLUT": (IA, BITS_8, RGBA_TLUT), "format 6": (6, BITS_4, {})}
#: Clamp, mirror, mask; texels between the edges; columns or rows to test.
AXES = {
    "wrap": (0, 0, 3, 8, 8), "wrap, long": (0, 0, 5, 5, 32), "mirror": (0, 1, 2, 4, 8),
    "one, mirrored": (0, 1, 0, 1, 3), "clamp": (1, 0, 0, 11, 13), "no mask": (0, 0, 0, 7, 9),
    "clamp, wrap": (1, 0, 2, 7, 9), "clamp, mirror": (1, 1, 2, 10, 12),
    "clamp within mask": (1, 0, 4, 6, 8), "clamp within mirror": (1, 1, 4, 21, 23),
    "one": (1, 0, 1, 1, 3)}
LINES = (1, 2, 3, 5, 7, 511)
PLACES = (0, 1, 77, 201, 254, 255, 256, 509, 510, 511)  # TMEM words
ROUNDS = 5


def tiles() -> Iterator[tuple[str, dict[str, int], tuple[int, ...], tuple[int, int]]]:
    """Yields name, modes, the fields of a line `tile` after n, columns and rows to test: each
    format in ROUNDS combinations of the other settings, no pair of axis settings twice."""
    chosen = random.Random(11)
    pairs = [(s, t) for s in AXES for t in AXES]
    chosen.shuffle(pairs)
    for number in range(ROUNDS * len(FORMATS)):
        form, (format, size, more) = list(FORMATS.items())[number % len(FORMATS)]
        across, down = pairs[number % len(pairs)]
        if format == YUV and AXES[across][1]:
            across = "clamp"  # mirrored chroma is undefined: c/n64/polygons/yuv.c
        line, tmem = chosen.choice(LINES), chosen.choice(PLACES)
        (*s, columns, wide), (*t, rows, high) = AXES[across], AXES[down]
        sl, tl = chosen.randrange(12), chosen.randrange(12)
        yield (f"{form}, {across} by {down}, line {line}, word {tmem}", more,
               (format, size, line, tmem, chosen.randrange(16), *s, 0, *t, 0, sl, tl,
                sl + 4 * (columns - 1), tl + 4 * (rows - 1)), (wide, high))


@dataclass
class Compared:
    """One comparison: a texel (``which`` 0) or a quad's result (1) at a place, computed both ways;
    the two answers follow each other from index ``answer`` on; ``mask``: the bits to compare."""

    name: str
    s: int
    t: int
    which: int
    mask: int
    answer: int


class Everything:
    """All texels and quads of ``tiles``: the comparisons, and the indices of the answers of
    decoding."""

    def __init__(self) -> None:
        self.guest, self.random = Guest(), random.Random(12)
        self.asked: list[Compared] = []
        self.decoded: list[tuple[str, int]] = []
        self.guest.do("TMEM_RANDOM", 3)
        self.guest.do("TLUT_RANDOM", 4)
        for name, more, tile, size in tiles():
            self.guest.do("TILE", 0, *tile)
            self.add(name, more, tile, size)

    def compare(self, name: str, s: int, t: int, which: int, mask: int,
                at: int | None = None) -> None:
        """``at``: the coordinate with the quad's fraction, if it is not s."""
        answer = self.guest.ask("DECODED", 0, s if at is None else at, t, numbers=2)
        self.guest.ask("SAMPLE", 0, s, t, 0, numbers=4)
        self.asked.append(Compared(name, s, t, which, mask, answer))

    def decode(self, name: str, quads: int) -> None:
        self.decoded.append((name, self.guest.ask("DECODE", 0, quads, numbers=5)))

    def add(self, name: str, more: dict[str, int], tile: tuple[int, ...],
            size: tuple[int, int]) -> None:
        """Adds a tile: point sampled, in both triangles and in the middle of each quad."""
        is_yuv, chosen, (wide, high) = tile[0] == YUV, self.random, size
        low_s, low_t = (8 * edge for edge in tile[13:15])
        corners = [(32 * i + low_s, 32 * j + low_t) for j in range(high) for i in range(wide)]
        self.guest.words(modes(**more))
        self.decode(name, NEXT)
        for s, t in corners:
            self.compare(name, s, t, 0, 0xFFFFFFFF)
        for mid in (0, 1):
            self.guest.words(modes(quad=1, mid=mid, **more))
            for s, t in corners:
                fs = 16 if mid else chosen.randrange(32)
                lower, upper = chosen.randrange(32 - fs), 31 - chosen.randrange(fs + 1)
                for ft in (16,) if mid else (lower, upper):
                    self.compare(name, s + fs, t + ft, 1, 0xFFFF if is_yuv else 0xFFFFFFFF)
        if is_yuv:
            self.add_chroma(name, tile, corners)

    def add_chroma(self, name: str, tile: tuple[int, ...], corners: list[tuple[int, int]]) -> None:
        """Adds quads of a YUV tile's U and V, which two texels share."""
        chosen = self.random
        self.guest.words(modes(quad=1))
        self.decode(f"{name}, chroma", CHROMA)
        clamps = tile[5] or not tile[7]
        for s, t in corners:
            if not clamps or s >> 3 < tile[15]:  # within the texel, and before the edge
                fs = min(chosen.randrange(32), 8 * tile[15] - 1 - s if clamps else 31)
                self.compare(name, s + fs, t + chosen.randrange(32), 1, 0xFFFF0000,
                             s + (fs >> 1) + 16 * (s - 8 * tile[13] >> 5 & 1))


def long_of(colour: list[int]) -> int:
    """R G B A as one unsigned long; 9-bit channels are cut to 8."""
    return int.from_bytes(bytes(channel & 255 for channel in colour), "big")


def test_every_texel_and_quad(asked) -> None:
    """n64_decode agrees with n64_sample when point sampled, in both triangles and in the middle of
    each quad, for tiles in every format, wrapped, mirrored, clamped, of any size, including tiles
    that wrap at TMEM's end or have rows of an odd number of words."""
    every, answers = asked["everything"], asked["answers"]["everything"]
    for name, at in every.decoded:
        assert (RESULTS[answers[at][0]], answers[at][3]) == ("DONE", 1), name
    for each in every.asked:
        colour = answers[each.answer + 1]
        if each.name.startswith("YUV"):
            colour = [colour[0] + 128, colour[1] + 128, *colour[2:]]
        expected, found = long_of(colour) & each.mask, answers[each.answer][each.which] & each.mask
        if expected != found:
            pytest.fail(f"{each.name}: {'quad' if each.which else 'texel'} at s {each.s / 32}, t "
                        f"{each.t / 32} is {found:08x}, expected {expected:08x}", pytrace=False)


#: Change before decoding, or None; whether quads are needed; whether the tile is decoded again.
SMALLER = (*WRAPPED[:7], 3, *WRAPPED[8:])
SAME = 0xF5 << 24 | BITS_16 << 19 | 4 << 9, 3 << 14 | 4 << 4
STEPS = [(("TMEM_RANDOM", 1), 0, 1), (None, 0, 0), (("WORDS", *SAME), 0, 0), (None, 1, 1),
         (None, 1, 0), (None, 0, 0), (("TMEM", 0, 1), 0, 1), (("TILE", 0, *SMALLER), 1, 1),
         (("WORDS", *modes(quad=1)), 1, 0), (("TILE", 1, *WRAPPED), 1, 0),
         (("WORDS", *modes(tlut=1)), 1, 1), (None, 1, 0), (("TILE", 0, *WRAPPED), 1, 1)]


def ask_steps() -> Guest:
    """Decodes tile 0 after each of STEPS."""
    guest = Guest()
    guest.do("TILE", 0, *WRAPPED)
    for change, quads, _ in STEPS:
        if change:
            guest.do(*change)
        guest.ask("DECODE", 0, quads, numbers=5)
    return guest


def test_tiles_are_decoded_anew_only_after_a_change(asked) -> None:
    """A change of the tile itself, TMEM or TLUT mode; quads also at their first use."""
    answers = asked["answers"]["steps"]
    for n, (change, quads, made) in enumerate(STEPS):
        code, columns, rows, found, _ = answers[n]
        assert (RESULTS[code], found) == ("DONE", made), (n, change, quads)
        assert (columns, rows) == (3 if 7 <= n < 12 else 4, 3), n
    assert answers[-1][4] == answers[3][4]  # the memory is reused


def ask_large() -> Guest:
    """Decodes the largest tile, a larger one, and the first once more."""
    guest = Guest()
    largest = (I, BITS_4, 4, 0, 0, 0, 1, 6, 0, 0, 1, 7, 0, 0, 0, 0, 0)
    beyond = (*largest[:7], 7, *largest[8:])
    for tile, quads in ((largest, 1), (beyond, 0), (largest, 1)):
        guest.do("TILE", 0, *tile)
        guest.ask("DECODE", 0, quads, numbers=5)
    return guest


def test_tiles_that_cannot_be_decoded(asked) -> None:
    """A tile that repeats over more than TMEM can hold is refused; the tile decoded before is
    unharmed."""
    names = [(RESULTS[answer[0]], answer[3]) for answer in asked["answers"]["large"]]
    assert names == [("DONE", 1), ("DECODE_TOO_LARGE", 0), ("DONE", 0)]


@pytest.fixture(scope="module")
def asked() -> dict:
    """The questions of all tests and their answers, from one boot."""
    every = Everything()
    return {"everything": every, "answers": vector_guest.run_all({
        "everything": every.guest, "steps": ask_steps(), "large": ask_large()})}
