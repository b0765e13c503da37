"""The texture engine in C: calls that write words, decoded tiles, whole pixels."""

import random

from tx_guest import (BITS_4, BITS_8, BITS_16, BITS_32, CI, IA, RGBA, YUV, Guest, I, modes,
                      result_name, texture)

from tools import layout

PAIRS = 8
#: Arguments of a texture: image, format, size, width, height, sl, tl, sh, th, palette, then
#: wrap, mask and shift of s and of t, tmem, tile.
TEXTURES = {
    # 32x32 RGBA 16, mirrored in s, clamped in t
    ("TEXTURE_BLOCK", 0x123450, RGBA, BITS_16, 32, 32, 0, 0, 0, 0, 0, 1, 5, 0, 2, 0, 0): (
        0xFD100000, 0x00123450, 0xF5100000, 0x07080150, 0xE6000000, 0, 0xF3000000, 0x073FF100,
        0xE7000000, 0, 0xF5101000, 0x00080150, 0xF2000000, 0x0007C07C),
    # 64x16 I 8 as tile 2 from word 16 on, mask 6 and 4, shifts 1 and 15
    ("TEXTURE_BLOCK", 0x1000, I, BITS_8, 64, 16, 0, 0, 0, 0, 0, 0, 6, 1, 0, 4, 15, 16, 2): (
        0xFD900000, 0x00001000, 0xF5900010, 0x07013C61, 0xE6000000, 0, 0xF3000000, 0x071FF100,
        0xE7000000, 0, 0xF5881010, 0x02013C61, 0xF2000000, 0x020FC03C),
    # 16x16 RGBA 32: half of a row's bytes in each half of TMEM
    ("TEXTURE_BLOCK", 0x1000, RGBA, BITS_32, 16, 16): (
        0xFD180000, 0x00001000, 0xF5180000, 0x07000000, 0xE6000000, 0, 0xF3000000, 0x070FF100,
        0xE7000000, 0, 0xF5180800, 0x00000000, 0xF2000000, 0x0003C03C),
    # 16x8 YUV
    ("TEXTURE_BLOCK", 0x1000, YUV, BITS_16, 16, 8): (
        0xFD300000, 0x00001000, 0xF5300000, 0x07000000, 0xE6000000, 0, 0xF3000000, 0x0707F200,
        0xE7000000, 0, 0xF5300400, 0x00000000, 0xF2000000, 0x0003C01C),
    # 32x32 CI 4, palette 3
    ("TEXTURE_BLOCK_4B", 0x1000, CI, 0, 32, 32, 0, 0, 0, 0, 3): (
        0xFD500000, 0x00001000, 0xF5500000, 0x07000000, 0xE6000000, 0, 0xF3000000, 0x070FF400,
        0xE7000000, 0, 0xF5400400, 0x00300000, 0xF2000000, 0x0007C07C),
    # columns 8 to 23, rows 4 to 11 of a 64 columns wide IA 16 image
    ("TEXTURE_TILE", 0x1000, IA, BITS_16, 64, 64, 8, 4, 23, 11): (
        0xFD70003F, 0x00001000, 0xF5700800, 0x07000000, 0xE6000000, 0, 0xF4020010, 0x0705C02C,
        0xE7000000, 0, 0xF5700800, 0x00000000, 0xF2020010, 0x0005C02C),
    # the same of an I 4 image
    ("TEXTURE_TILE_4B", 0x1000, I, 0, 64, 64, 8, 4, 23, 11): (
        0xFD88001F, 0x00001000, 0xF5880200, 0x07000000, 0xE6000000, 0, 0xF4010010, 0x0702E02C,
        0xE7000000, 0, 0xF5800200, 0x00000000, 0xF2020010, 0x0005C02C),
}
#: Other calls: arguments to words.
CALLS = TEXTURES | {
    ("TLUT_16", 3, 0x2000): (
        0xFD100000, 0x00002000, 0xE8000000, 0, 0xF5000130, 0x07000000, 0xE6000000, 0,
        0xF0000000, 0x0703C000, 0xE7000000, 0),
    ("TLUT_256", 0x2000): (
        0xFD100000, 0x00002000, 0xE8000000, 0, 0xF5000100, 0x07000000, 0xE6000000, 0,
        0xF0000000, 0x073FC000, 0xE7000000, 0),
    ("IMAGE", IA, BITS_8, 320, 0xABCDE8): (0xFD68013F, 0x00ABCDE8),
    ("TILE", CI, BITS_8, 4, 2, 1, 0, 3, 5, 1, 1, 4, 2): (0xF5480802, 0x010D4542),
    ("TILE_SIZE", 3, 1, 2, 4, 8): (0xF2001002, 0x03004008),
    ("LOAD_BLOCK", 7, 0, 0, 5000, 256): (0xF3000000, 0x07FFF100),  # too large stays too large
    ("LOAD_TILE", 7, 4, 8, 60, 64): (0xF4004008, 0x0703C040),
    ("LOAD_TLUT", 7, 255): (0xF0000000, 0x073FC000),
    ("TEXTURE", 5, 2): (0xD7002A02, 0xFFFFFFFF),
    ("CYCLE", 1): (0xE3000A01, 0x00100000),
    ("PERSPECTIVE", 1): (0xE3000C00, 0x00080000),
    ("DETAIL", 2): (0xE3000D01, 0x00040000),
    ("LOD", 1): (0xE3000F00, 0x00010000),
    ("LUT", 3): (0xE3001001, 0x0000C000),
    ("FILTER", 2): (0xE3001201, 0x00002000),
    ("CONVERSION", 6): (0xE3001402, 0x00000C00),
    ("CONVERT", 175, -43, -89, 222, 114, 42): (0xEC15FD5D, 0x3B78E42A),
    # texel 0 times shade, alpha too, in both cycles
    ("COMBINE", 1, 15, 4, 7, 1, 15, 4, 7, 1, 7, 4, 7, 1, 7, 4, 7): (0xFC121824, 0xFF33FFFF),
    ("PRIMITIVE", 3, 128, 0x11223344): (0xFA000380, 0x11223344),
    ("ENVIRONMENT", 0x11223344): (0xFB000000, 0x11223344),
    ("LOAD_SYNC",): (0xE6000000, 0), ("PIPE_SYNC",): (0xE7000000, 0),
    ("TILE_SYNC",): (0xE8000000, 0), ("FULL_SYNC",): (0xE9000000, 0),
}


def test_calls_write_the_manuals_words() -> None:
    """Loads with their syncs, tiles, modes, colours: words worked out by hand. One pair of room
    less: none is written."""
    numbers = layout.load().constants
    guest = Guest()
    for (name, *arguments), words in CALLS.items():
        for room in (PAIRS, len(words) // 2 - 1):
            guest.ask("CALL", room, numbers[f"VECTOR_CALL_{name}"], *arguments,
                      numbers=2 + 2 * PAIRS)
    answers = guest.run()
    for n, (call, words) in enumerate(CALLS.items()):
        code, count, *found = answers[2 * n]
        found = [word & 0xFFFFFFFF for word in found[:2 * count]]
        assert (result_name(code), found) == ("DONE", list(words)), \
            (call, [f"{word:08x}" for word in found])
        assert (result_name(answers[2 * n + 1][0]), answers[2 * n + 1][1]) == ("LIST_FULL", 0)


def packed(colour: list[int]) -> int:
    """R G B A as one signed long."""
    value = int.from_bytes(bytes(colour), "big")
    return value - (1 << 32) if value >> 31 else value


#: Tiles as a vector line has them behind n: format, size, line, tmem, palette, clamp, mirror,
#: mask, shift of s, of t, sl, tl, sh, th.
TILES = {
    "wrapped RGBA 16": (RGBA, BITS_16, 4, 0, 0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0, 60, 28),
    "mirrored IA 8": (IA, BITS_8, 3, 16, 0, 0, 1, 3, 0, 0, 1, 4, 0, 0, 0, 60, 28),
    "clamped I 4": (I, BITS_4, 2, 32, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 88, 40),
    "clamped and mirrored IA 4": (IA, BITS_4, 2, 32, 0, 1, 1, 3, 0, 1, 1, 2, 0, 12, 6, 150, 90),
    "shifted IA 16": (IA, BITS_16, 4, 48, 0, 0, 0, 4, 1, 0, 1, 3, 14, 5, 9, 60, 28),
    "RGBA 32": (RGBA, BITS_32, 5, 48, 0, 1, 0, 0, 0, 0, 0, 3, 0, 0, 0, 76, 28),
    "one texel": (RGBA, BITS_16, 1, 200, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0),
    "long mask": (I, BITS_4, 64, 0, 0, 0, 0, 10, 0, 0, 0, 4, 0, 0, 0, 0, 0),
}
TLUT_TILES = {
    "CI 4": (CI, BITS_4, 2, 32, 5, 0, 0, 5, 0, 0, 1, 3, 0, 0, 0, 88, 40),
    "CI 8": (CI, BITS_8, 4, 32, 0, 1, 1, 4, 0, 1, 0, 5, 0, 0, 0, 100, 130),
}
PLACES = 60  # of each tile


def test_decoded_tiles_show_what_tmem_does() -> None:
    """At random coordinates texels are those of point sampling, quads' results those of the
    filter, three-point and average; for wrap, mirror, clamp, shifts, TLUT, all formats."""
    chosen = random.Random(5)
    guest = Guest()
    asked = []
    guest.do("TMEM_RANDOM", 99)
    guest.do("TLUT_RANDOM", 98)
    for tlut, tiles in ((0, TILES), (1, TLUT_TILES)):
        guest.words(modes(tlut=tlut))
        for n, (name, tile) in enumerate(tiles.items()):
            guest.do("TILE", n, *tile)
            guest.ask("DECODE", n, 1, numbers=5)
            for _ in range(PLACES):
                s, t = (chosen.choice((chosen.randrange(-32768, 32768), chosen.randrange(1024),
                                       chosen.randrange(32) * 32 + 16)) for _ in "st")
                first = len(guest.lengths)
                for mid in (0, 1):
                    guest.words(modes(tlut=tlut, quad=1, mid=mid))
                    guest.ask("DECODED", n, s, t, numbers=2)
                    guest.ask("SAMPLE", n, s, t, 0, numbers=4)
                guest.words(modes(tlut=tlut))
                guest.ask("SAMPLE", n, s, t, 0, numbers=4)
                asked.append((name, s, t, first))
    answers = guest.run()
    for name, s, t, first in asked:
        _, plain, filtered, _, middle, average, _, point = answers[first:first + 8]
        assert plain[0] == packed(point), (name, s, t)
        assert plain[1] == packed(filtered), (name, s, t)
        assert middle[1] == packed(average), (name, s, t)


def test_tiles_are_decoded_anew_only_after_a_change() -> None:
    """Of the tile itself, TMEM, TLUT mode; quads when they are first asked for."""
    guest = Guest()
    tile = TILES["wrapped RGBA 16"]
    smaller = (*tile[:7], 3, *tile[8:])
    same = 0xF5 << 24 | BITS_16 << 19 | 4 << 9, 3 << 14 | 4 << 4
    steps = [(("TMEM_RANDOM", 1), 0, 1), (None, 0, 0), (("WORDS", *same), 0, 0), (None, 1, 1),
             (None, 1, 0), (None, 0, 0), (("TMEM", 0, 1), 0, 1), (("TILE", 0, *smaller), 1, 1),
             (("WORDS", *modes(quad=1)), 1, 0), (("TILE", 1, *tile), 1, 0),
             (("WORDS", *modes(tlut=1)), 1, 1), (None, 1, 0), (("TILE", 0, *tile), 1, 1)]
    guest.do("TILE", 0, *tile)
    for change, quads, _ in steps:
        if change:
            guest.do(*change)
        guest.ask("DECODE", 0, quads, numbers=5)
    answers = guest.run()
    for n, (change, quads, made) in enumerate(steps):
        code, columns, rows, found, _ = answers[n]
        assert (result_name(code), found) == ("DONE", made), (n, change, quads)
        assert (columns, rows) == (3 if 7 <= n < 12 else 4, 3), n
    assert answers[-1][4] == answers[3][4]  # memory is used again


def test_tiles_that_cannot_be_decoded() -> None:
    """Larger than anything TMEM holds; what was decoded before is unharmed."""
    guest = Guest()
    largest = (I, BITS_4, 4, 0, 0, 0, 1, 6, 0, 0, 1, 7, 0, 0, 0, 0, 0)
    beyond = (*largest[:7], 7, *largest[8:])
    for tile, quads in ((largest, 1), (beyond, 0), (largest, 1)):
        guest.do("TILE", 0, *tile)
        guest.ask("DECODE", 0, quads, numbers=5)
    names = [(result_name(answer[0]), answer[3]) for answer in guest.run()]
    assert names == [("DONE", 1), ("DECODE_TOO_LARGE", 0), ("DONE", 0)]


#: Colour codes of both cycles and alpha's, (a, b, c, d) each, for the four units.
TEXEL0 = ((15, 15, 31, 1), (7, 7, 7, 1))
MODULATE = ((1, 15, 4, 7), (1, 7, 4, 7))
TRILINEAR = ((2, 1, 13, 1), (2, 1, 0, 1))
PASS = ((15, 15, 31, 0), (7, 7, 7, 0))
FADE = ((5, 3, 14, 3), (5, 3, 6, 3))  # from primitive to environment
TEXEL1_AGAIN = ((15, 15, 31, 2), (7, 7, 7, 2))


def combine(first, second) -> tuple[int, int]:
    """Set combine."""
    (a0, b0, c0, d0), (aa0, ab0, ac0, ad0) = first
    (a1, b1, c1, d1), (aa1, ab1, ac1, ad1) = second
    return (0xFC << 24 | a0 << 20 | c0 << 15 | aa0 << 12 | ac0 << 9 | a1 << 5 | c1,
            b0 << 28 | b1 << 24 | aa1 << 21 | ac1 << 18 | d0 << 15 | ab0 << 12 | ad0 << 9
            | d1 << 6 | ab1 << 3 | ad1)


def blend(a: int, b: int, c: int, d: int) -> int:
    """The combiner's sum for values that are not negative but C; clamped."""
    value = ((a - b) * c + (d << 8) + 128 >> 8) & 511
    return 0 if value >= 384 else 255 if value >= 256 else value


def test_whole_pixels() -> None:
    """Texel, modulation, trilinear, constant colours, in one and two cycles."""
    chosen = random.Random(8)
    guest = Guest()
    cases = []
    guest.do("TMEM_RANDOM", 5)
    primitive, environment = 0x10F08050, 0xF01030C0
    for n in range(4):
        guest.do("TILE", n, *TILES["wrapped RGBA 16"][:8], n, 0, 0, 3, n, 0, 0, 0, 0)
    for _ in range(30):
        numbers = [chosen.randrange(-1 << 26, 1 << 26) for _ in "stw"]
        steps = [chosen.randrange(-1 << 23, 1 << 23) for _ in range(6)]
        shade = chosen.randrange(1 << 32)
        first = len(guest.lengths)
        for words, cycle in ((combine(TEXEL0, MODULATE), 0), (combine(TRILINEAR, PASS), 1),
                             (combine(TEXEL0, FADE), 0), (combine(TEXEL0, TEXEL1_AGAIN), 1)):
            guest.words(modes(cycle=cycle, quad=1, lod=cycle), texture(3, 0), words,
                        (0xFA << 24 | 100, primitive), (0xFB << 24, environment))
            guest.ask("DRAW", *numbers, *steps, shade, numbers=1)
        guest.words(modes(quad=1))
        guest.ask("SAMPLE", 0, numbers[0] >> 16, numbers[1] >> 16, 0, numbers=4)
        guest.words(modes(quad=1, lod=1))
        guest.ask("PIXEL", *numbers, *steps, 0, 3, 0, numbers=13)
        cases.append((first, shade.to_bytes(4, "big")))
    answers = guest.run()
    for first, shade in cases:
        (lit,), (mixed,), (faded,), (again,) = answers[first + 1:first + 8:2]
        texel, pixel = answers[first + 9], answers[first + 11]
        fraction = (pixel[4] + 256 & 511) - 256
        texel0, texel1 = pixel[5:9], pixel[9:]
        assert lit == packed([blend(a, 0, b, 0) for a, b in zip(texel, shade)])
        assert mixed == packed([blend(b, a, fraction, a) for a, b in zip(texel0, texel1)])
        assert faded == packed([blend(b, a, 100, a) for a, b in zip(
            primitive.to_bytes(4, "big"), environment.to_bytes(4, "big"))])
        assert again == packed(texel0)
