"""Whole pixels of the texture engine in C: samples and the combiner together, compared with
separate sums."""

import random

from tests.n64.guest import WRAPPED, Guest, modes, packed, texture

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
    """The combiner's sum for values of which only C may be negative; clamped."""
    value = ((a - b) * c + (d << 8) + 128 >> 8) & 511
    return 0 if value >= 384 else 255 if value >= 256 else value


def test_whole_pixels() -> None:
    """Texel, modulation, trilinear, constant colours, in one and two cycles."""
    chosen = random.Random(8)
    guest, cases = Guest(), []
    guest.do("TMEM_RANDOM", 5)
    primitive, environment = 0x10F08050, 0xF01030C0
    for n in range(4):
        guest.do("TILE", n, *WRAPPED[:8], n, 0, 0, 3, n, 0, 0, 0, 0)
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
        cases.append((first, f"s, t, w {numbers}, steps {steps}, shade {shade:08x}",
                      shade.to_bytes(4, "big")))
    answers = guest.run()
    for first, case, shade in cases:
        texel, pixel = answers[first + 9], answers[first + 11]
        fraction = (pixel[4] + 256 & 511) - 256
        texel0, texel1 = pixel[5:9], pixel[9:]
        constants = primitive.to_bytes(4, "big"), environment.to_bytes(4, "big")
        right = {"modulation": [blend(a, 0, b, 0) for a, b in zip(texel, shade)],
                 "trilinear": [blend(b, a, fraction, a) for a, b in zip(texel0, texel1)],
                 "constants": [blend(b, a, 100, a) for a, b in zip(*constants)],
                 "texel 1, then 0": texel0}
        for (name, expected), (found,) in zip(right.items(), answers[first + 1:first + 8:2],
                                              strict=True):
            assert found == packed(expected), f"{name}: {case}"
