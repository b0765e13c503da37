"""Decoded tiles of the texture engine: every texel and quad is what the general way finds."""

import random
from collections.abc import Iterator

import pytest
from tx_guest import (BITS_4, BITS_8, BITS_16, BITS_32, CI, IA, RGBA, YUV, Guest, I, modes,
                      result_name)

AGAIN = "again: .deps/venv/bin/python -m pytest -q tests/test_tx_decode.py"
NEXT, CHROMA = 1, 2  # quads
RGBA_TLUT, IA_TLUT = {"tlut": 1}, {"tlut": 1, "tlut_type": 1}
#: Format, size, modes; the last ones no manual allows.
FORMATS = {
    "RGBA 16": (RGBA, BITS_16, {}), "RGBA 32": (RGBA, BITS_32, {}), "YUV": (YUV, BITS_16, {}),
    "IA 4": (IA, BITS_4, {}), "IA 8": (IA, BITS_8, {}), "IA 16": (IA, BITS_16, {}),
    "I 4": (I, BITS_4, {}), "I 8": (I, BITS_8, {}), "CI 4": (CI, BITS_4, RGBA_TLUT),
    "CI 8": (CI, BITS_8, RGBA_TLUT), "CI 4 by IA": (CI, BITS_4, IA_TLUT),
    "CI 8 by IA": (CI, BITS_8, IA_TLUT),
    "CI 4 as it is": (CI, BITS_4, {}), "RGBA 8": (RGBA, BITS_8, {}), "I 16": (I, BITS_16, {}),
    "IA 32": (IA, BITS_32, {}), "RGBA 16 by TLUT": (RGBA, BITS_16, RGBA_TLUT),
    "IA 8 by TLUT": (IA, BITS_8, RGBA_TLUT), "format 6": (6, BITS_4, {})}
#: Clamp, mirror, mask; texels between the edges; columns or rows to look at.
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
    """Name, modes, fields of a line `tile` behind n, columns and rows to look at: each format with
    ROUNDS of everything else, each pair of an axis' forms in some format."""
    chosen = random.Random(11)
    pairs = [(s, t) for s in AXES for t in AXES]
    chosen.shuffle(pairs)
    for number in range(ROUNDS * len(FORMATS)):
        form, (format, size, more) = list(FORMATS.items())[number % len(FORMATS)]
        across, down = pairs[number % len(pairs)]
        if format == YUV and AXES[across][1]:
            across = "clamp"  # mirrored chroma is nobody's: c/tx/yuv.c
        line, tmem = chosen.choice(LINES), chosen.choice(PLACES)
        (*s, columns, wide), (*t, rows, high) = AXES[across], AXES[down]
        sl, tl = chosen.randrange(12), chosen.randrange(12)
        yield (f"{form}, {across} by {down}, line {line}, word {tmem}", more,
               (format, size, line, tmem, chosen.randrange(16), *s, 0, *t, 0, sl, tl,
                sl + 4 * (columns - 1), tl + 4 * (rows - 1)), (wide, high))


def long_of(colour: list[int]) -> int:
    """R G B A as one unsigned long; 9 bits are cut to 8."""
    return int.from_bytes(bytes(channel & 255 for channel in colour), "big")


def test_every_texel_and_quad() -> None:
    """Point sampled, in both triangles and in the middle of each quad: tx_decode's against
    tx_sample's, of tiles in every format, wrapped, mirrored, clamped, of any size, which go round
    TMEM's end or have rows of an odd number of words."""
    chosen = random.Random(12)
    guest = Guest()
    asked: list[tuple[str, int, int, int, int, int]] = []
    made: list[tuple[str, int]] = []

    def compare(name: str, s: int, t: int, which: int, mask: int, at: int | None = None) -> None:
        """``which``: texel (0) or quad's result (1); ``at``: where the quad's fraction is, if it
        is not s."""
        answer = guest.ask("DECODED", 0, s if at is None else at, t, numbers=2)
        guest.ask("SAMPLE", 0, s, t, 0, numbers=4)
        asked.append((name, s, t, which, mask, answer))

    guest.do("TMEM_RANDOM", 3)
    guest.do("TLUT_RANDOM", 4)
    for name, more, tile, (wide, high) in tiles():
        is_yuv = tile[0] == YUV
        low_s, low_t = (8 * edge for edge in tile[13:15])
        corners = [(32 * i + low_s, 32 * j + low_t) for j in range(high) for i in range(wide)]
        guest.do("TILE", 0, *tile)
        guest.words(modes(**more))
        made.append((name, guest.ask("DECODE", 0, NEXT, numbers=5)))
        for s, t in corners:
            compare(name, s, t, 0, 0xFFFFFFFF)
        for mid in (0, 1):
            guest.words(modes(quad=1, mid=mid, **more))
            for s, t in corners:
                fs = 16 if mid else chosen.randrange(32)
                lower, upper = chosen.randrange(32 - fs), 31 - chosen.randrange(fs + 1)
                for ft in (16,) if mid else (lower, upper):
                    compare(name, s + fs, t + ft, 1, 0xFFFF if is_yuv else 0xFFFFFFFF)
        if not is_yuv:
            continue
        guest.words(modes(quad=1))
        made.append((f"{name}, chroma", guest.ask("DECODE", 0, CHROMA, numbers=5)))
        clamps = tile[5] or not tile[7]
        for s, t in corners:
            if not clamps or s >> 3 < tile[15]:  # within the texel, and before the edge
                fs = min(chosen.randrange(32), 8 * tile[15] - 1 - s if clamps else 31)
                compare(name, s + fs, t + chosen.randrange(32), 1, 0xFFFF0000,
                        s + (fs >> 1) + 16 * (s - low_s >> 5 & 1))
    answers = guest.run()
    for name, at in made:
        assert (result_name(answers[at][0]), answers[at][3]) == ("DONE", 1), f"{name}; {AGAIN}"
    for name, s, t, which, mask, at in asked:
        colour = answers[at + 1]
        if name.startswith("YUV"):
            colour = [colour[0] + 128, colour[1] + 128, *colour[2:]]
        expected, found = long_of(colour) & mask, answers[at][which] & mask
        if expected != found:
            pytest.fail(f"{name}: {'quad' if which else 'texel'} at s {s / 32}, t {t / 32} is "
                        f"{found:08x}, expected {expected:08x}; {AGAIN}", pytrace=False)
