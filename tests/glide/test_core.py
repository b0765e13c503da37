"""The rules of Glide's texture unit on the emulated machine: examples computed by hand, and
comparisons with exact numbers."""

import random
from dataclasses import dataclass, field
from fractions import Fraction

import pytest

from tests.glide.guest import MASK, Guest
from tests.glide.reference import table_quotient
from tmap.base.paths import ROOT
from tmap.vectors.vector_text import xorshift

ONE = 1 << 18  # of s and t
W_ONE = 1 << 30
LEAST, MOST = -1 << 31, (1 << 31) - 1
LOD_ONE = 256
LODS = (0, 100, 255, 256, 356, 511, 700, 1300, 1791)  # 8.8
SEED = 43

# textureMode, from the registers' description
PERSPECTIVE, MINIFY, MAGNIFY, CLAMP_W, DITHER = (1 << n for n in range(5))
CLAMP_S, CLAMP_T = 1 << 6, 1 << 7
A8, ARGB4444, AI88 = (n << 8 for n in (2, 12, 13))
ZERO_OTHER, SUB_LOCAL, REVERSE, ADD_LOCAL = (1 << n | 1 << n + 9 for n in (12, 13, 17, 18))
TRILINEAR = 1 << 30
LOCAL = ZERO_OTHER | ADD_LOCAL
DETAIL_FACTOR, LOD_FACTOR = (n << 14 | n << 23 for n in (4, 5))
# tLOD
ODD, SPLIT, WIDE = 1 << 18, 1 << 19, 1 << 20


def lods(least: int, most: int, bias: int = 0, rest: int = WIDE) -> int:
    """The register tLOD; all levels are in quarters."""
    return least | most << 6 | (bias & 63) << 12 | rest


def details(bias: int, scale: int, most: int) -> int:
    """The register tDetail."""
    return most | (bias & 63) << 8 | scale << 14


@dataclass
class Questions:
    """Questions, each with the expected number."""

    guest: Guest = field(default_factory=Guest)
    expected: list[tuple[str, int]] = field(default_factory=list)

    def one(self, number: int, name: str, *values: int) -> None:
        """Adds a question whose answer is one number."""
        self.guest.one(name, *values)
        self.expected.append((f"{name}{values}", number))

    def regs(self, mode: int, lod: int = WIDE, detail: int = 0) -> None:
        """Sets the registers; the base address is 0."""
        self.guest.do("GLIDE_REGISTERS", mode, lod, detail, 0)

    def pixel(self, argb: int, s: int, t: int, w: int = W_ONE, other: int = 0, x: int = 0,
              y: int = 0) -> None:
        """Adds a question for a pixel."""
        self.one(argb, "PIXEL", s, t, w, other, x, y)

    def lod(self, level: Fraction) -> None:
        """Sets gradients whose LOD is an integer."""
        self.guest.do("GLIDE_GRADIENTS", int(2 ** level * ONE), 0, 0, 0)


def nearest_logarithm(x: int) -> int:
    """256 log2 x, rounded: the k for which 2^(2 k - 1) < x^512 < 2^(2 k + 1)."""
    power = (x ** 512).bit_length()  # 2^(power - 1) <= x^512 < 2^power
    return power // 2


def numbers(q: Questions, choose: random.Random) -> None:
    """Logarithms, quotients, gradients."""
    for x in (1, 2, 3, MASK, 1 << 31, *(choose.getrandbits(choose.randint(1, 32)) | 1
                                        for _ in range(60))):
        q.one(nearest_logarithm(x), "LOGARITHM", 0, x)
    for k in choose.sample(range(256), 40):  # as near as possible to where they are rounded up
        for bits in (31, 12, 24):
            x = int_root(512 * bits + 2 * k + 1)
            for near in (x, x + 1):
                q.one(nearest_logarithm(near), "LOGARITHM", 0, near)
    for _ in range(40):
        x = choose.getrandbits(choose.randint(33, 64)) | 1 << 32
        q.one(nearest_logarithm(x), "LOGARITHM", x >> 32, x & MASK)
    edges = (0, 1, -1, 2, 3, 255, W_ONE, W_ONE - 1, -W_ONE, MOST, LEAST, LEAST + 1)
    for s in edges:
        for w in edges:
            q.one(table_quotient(s, w), "QUOTIENT", s, w)
    for _ in range(150):
        s, w = (choose.randrange(-1 << bits, 1 << bits)
                for bits in (choose.randint(1, 31), choose.randint(1, 31)))
        q.one(table_quotient(s, w), "QUOTIENT", s, w)
    q.one(-32768, "LOD", 0, 0, 0, 0)
    q.one(2 * LOD_ONE, "LOD", 4 * ONE, 0, 0, 0)
    q.one(-18 * LOD_ONE, "LOD", 0, 0, 0, -1)
    for axes in ((LEAST, LEAST, 0, 0), (0, 0, LEAST, LEAST), (LEAST, 5, LEAST, LEAST)):
        q.one(13 * LOD_ONE + 128, "LOD", *axes)
    for _ in range(60):
        four = [choose.randrange(-1 << bits, 1 << bits)
                for bits in choose.choices(range(1, 32), k=4)]
        most = max(four[0] ** 2 + four[1] ** 2, four[2] ** 2 + four[3] ** 2)
        q.one(int(Fraction(nearest_logarithm(most) - 36 * LOD_ONE, 2)), "LOD", *four)


def int_root(exponent: int) -> int:
    """The 512th root of 2^exponent, rounded down."""
    low, high = 0, 1 << 33
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle ** 512 <= 1 << exponent else (low, middle)
    return low


def fractions(q: Questions) -> None:
    """White times the LOD's fraction: clamped, biased, with w, dithered."""
    other = LOD_FACTOR | REVERSE
    for lod, bias, least, most, expected in (
            (2, 0, 0, 32, 0), (2, 1, 0, 32, 64), (2, -1, 0, 32, 192), (2, -1, 8, 32, 0),
            (2, 3, 0, 9, 64), (9, 3, 0, 63, 0), (-3, 0, 7, 32, 192), (3, 0, 9, 5, 64)):
        q.regs(other, lods(least, most, bias))
        q.lod(Fraction(lod))
        q.pixel((255 * (expected + 1) >> 8) * 0x01010101, 0, 0, other=MASK)
    q.regs(other | PERSPECTIVE, lods(0, 32, 1))
    q.lod(Fraction(2))
    for w in (1 << 29, 1 << 30, -1 << 29, 1 << 20):
        q.pixel((255 * 65 >> 8) * 0x01010101 if w != 1 << 20 else 0, 0, 0, w, MASK)
    q.pixel(0, 0, 0, 0, MASK)  # w = 0: the smallest level
    q.regs(other | DITHER, lods(0, 32, 0))
    for y, row in enumerate(((0, 8, 2, 10), (12, 4, 14, 6), (3, 11, 1, 9), (15, 7, 13, 5))):
        for x, value in enumerate(row):
            q.pixel((255 * (16 * value + 1) >> 8) * 0x01010101, 0, 0, other=MASK, x=x + 4, y=y - 8)


def detail_factors(q: Questions) -> None:
    """Detail factors computed by hand."""
    for bias, scale, most, lod, expected in ((4, 5, 200, 10, 48), (4, 5, 200, 0, 128),
                                             (4, 5, 200, 17, 0), (8, 5, 200, 4, 200),
                                             (-32, 7, 255, 0, 0), (31, 7, 255, 0, 255)):
        q.regs(DETAIL_FACTOR | REVERSE, lods(lod, 32), details(bias, scale, most))
        q.guest.do("GLIDE_GRADIENTS", 0, 0, 0, 0)
        q.pixel((255 * (expected + 1) >> 8) * 0x01010101, 0, 0, other=MASK)


def samples(q: Questions, memory: bytes) -> None:
    """Level 2 of 64 by 64 texels of 8 bits, and narrow levels; the memory is random."""
    def grey(address: int) -> int:
        return memory[address] * 0x01010101

    def at(i: int, j: int) -> int:
        return 65536 + 16384 + 64 * j + i

    def mean(weights: dict[int, int], bits: int) -> int:
        return (sum(weight * memory[address] for address, weight in weights.items()) >> bits) \
            * 0x01010101

    level_2 = lods(8, 8)
    q.regs(LOCAL | A8 | MINIFY | MAGNIFY, level_2)
    q.pixel(grey(at(0, 0)), 2 * ONE, 2 * ONE)  # the first texel's centre
    q.pixel(mean({at(63, 0): 128, at(0, 0): 128}, 8), 0, 2 * ONE)
    q.pixel(mean({at(5, 7): 12 * 4, at(6, 7): 4 * 4, at(5, 8): 12 * 12, at(6, 8): 4 * 12}, 8),
            23 * ONE, 33 * ONE)
    q.regs(LOCAL | A8 | MINIFY | MAGNIFY | CLAMP_S | CLAMP_T, level_2)
    q.pixel(grey(at(0, 0)), 0, 2 * ONE)
    q.pixel(grey(at(63, 63)), MOST, MOST)
    q.pixel(mean({at(0, 63): 64, at(0, 62): 192}, 8), LEAST, 251 * ONE)
    q.regs(LOCAL | A8, level_2)
    for s, t, i, j in ((0, 0, 0, 0), (-1, -4 * ONE - 1, 63, 62), (4 * ONE - 1, 256 * ONE, 0, 0),
                       (259 * ONE, 255 * ONE, 0, 63)):
        q.pixel(grey(at(i, j)), s, t)
    q.regs(LOCAL | A8 | CLAMP_S | CLAMP_T, level_2)
    q.pixel(grey(at(0, 63)), -1, 256 * ONE)
    # only the filter for magnification, then that for minification
    q.regs(LOCAL | A8 | MAGNIFY, level_2)
    q.pixel(mean({at(63, 0): 128, at(0, 0): 128}, 8), 0, 2 * ONE)
    q.regs(LOCAL | A8 | MAGNIFY, lods(0, 8))
    q.lod(Fraction(5))
    q.pixel(grey(at(0, 0)), 0, 2 * ONE)
    # with w: a half doubles the distance; if w is negative, the first texel
    q.regs(LOCAL | A8 | PERSPECTIVE, level_2)
    q.pixel(grey(at(14, 6)), 28 * ONE, 12 * ONE, W_ONE // 2)
    q.pixel(grey(at(49, 57)), 28 * ONE + 1, 12 * ONE + 1, -W_ONE // 2)
    q.pixel(grey(at(0, 0)), 28 * ONE, 12 * ONE, 0)
    for mode in (0, PERSPECTIVE):
        q.regs(LOCAL | A8 | CLAMP_W | mode, level_2)
        q.pixel(grey(at(0, 0)), 28 * ONE, 12 * ONE, -W_ONE // 2)
    # 256 by 32: level 6 has 4 by 1 texels, after 8192 + 2048 + 512 + 128 + 32 + 8
    q.regs(LOCAL | A8, lods(24, 24, rest=WIDE | 3 << 21))
    for s, t, i in ((0, 0, 0), (64 * ONE, 31 * ONE, 1), (-1, -1, 3)):
        q.pixel(grey(10920 + i), s, t)
    # odd levels only: level 2.0 is drawn from level 3, which follows level 1
    q.regs(LOCAL | A8, lods(8, 8, rest=WIDE | SPLIT | ODD))
    q.pixel(grey(16384 + 32 + 3), 24 * ONE, 8 * ONE)
    # level 8.0, which is missing: read after all odd ones, 16384 + 1024 + 64 + 4
    q.regs(LOCAL | A8, lods(32, 32, rest=WIDE | SPLIT | ODD))
    q.pixel(grey(17476), 0, 0)
    # little-endian texels of 16 bits
    q.regs(LOCAL | ARGB4444, lods(0, 0))
    q.pixel(sum(17 * (memory[514 + n // 2] >> 4 * (n % 2) & 15) << 8 * n for n in range(4)),
            ONE, ONE)
    q.guest.call("FRACTION_BITS", 8)
    q.expected.append(("FRACTION_BITS", 0))
    q.regs(LOCAL | A8 | MINIFY | MAGNIFY, level_2)
    q.pixel(mean({at(0, 0): 255 << 8, at(1, 0): 1 << 8}, 16), 2 * ONE + 4 * ONE // 256, 2 * ONE)
    q.guest.call("FRACTION_BITS", 4)
    q.expected.append(("FRACTION_BITS", 0))


class Chain:
    """Two units, one with the even levels and one with the odd ones; and two passes of one unit."""

    def __init__(self, guest: Guest) -> None:
        self.guest = guest
        self.trilinear: list[tuple[int, int, int, int, int]] = []  # LOD, even first, 3 answers
        self.passes: list[tuple[int, int, int, int, int]] = []  # LOD, 4 answers
        self.hints: list[tuple[int, int, int, int]] = []  # units, own, 2 answers

    def regs(self, unit: int, mode: int, rest: int) -> None:
        """Sets the registers of one unit."""
        self.guest.do("GLIDE_CHOOSE", unit)
        self.guest.do("GLIDE_REGISTERS", mode | AI88, lods(0, 32, rest=WIDE | rest), 0, 0)

    def chain(self, units: int, own: int, *points: tuple[int, int]) -> int:
        """A pixel of units in a chain."""
        first, second = ((*point, W_ONE) for point in points)
        return self.guest.one("CHAIN", units, own, *first, *second, 0, 0)

    def blend(self, lod: int, even_first: bool) -> None:
        """Trilinear filtering in one pass; also each unit's colour alone."""
        self.guest.do("GLIDE_GRADIENTS", *gradients(lod))
        parities = (SPLIT, SPLIT | ODD) if even_first else (SPLIT | ODD, SPLIT)
        point = 37 * ONE, 91 * ONE
        own = []
        for unit, rest in enumerate(parities):
            self.regs(unit, LOCAL | MINIFY | MAGNIFY, rest)
            own.append(self.guest.one("PIXEL", *point, W_ONE, 0, 0, 0))
        blend = SUB_LOCAL | ADD_LOCAL | LOD_FACTOR | (REVERSE if even_first else 0)
        self.regs(0, blend | TRILINEAR | MINIFY | MAGNIFY, parities[0])
        self.regs(1, LOCAL | TRILINEAR | MINIFY | MAGNIFY, parities[1])
        self.trilinear.append((lod, even_first, *own, self.chain(2, 0, point, (0, 0))))

    def two_passes(self, lod: int) -> None:
        """Two passes over a whole map: even levels, then odd ones; before them, the colours of both
        levels."""
        self.guest.do("GLIDE_GRADIENTS", *gradients(lod))
        point = 200 * ONE, 17 * ONE, W_ONE, 0, 0, 0
        asked = []
        for level in (lod >> 8, (lod >> 8) + 1):
            self.guest.do("GLIDE_REGISTERS", LOCAL | AI88, lods(4 * level, 4 * level), 0, 0)
            asked.append(self.guest.one("PIXEL", *point))
        for reverse, rest in ((REVERSE, 0), (0, ODD)):
            self.regs(0, ZERO_OTHER | SUB_LOCAL | ADD_LOCAL | LOD_FACTOR | reverse | TRILINEAR,
                      rest)
            asked.append(self.guest.one("PIXEL", *point))
        self.passes.append((lod, *asked))

    def whose_points(self) -> None:
        """Shows only the upstream unit; its point is separate or that of unit 0."""
        for unit, mode in enumerate((0, LOCAL)):
            self.regs(unit, mode, 0)
        here, there = (3 * ONE, 5 * ONE), (90 * ONE, 71 * ONE)
        for own, point in ((0, here), (1, here), (2, there), (3, there)):
            alone = self.guest.one("PIXEL", *point, W_ONE, 0, 0, 0)
            self.hints.append((2, own, alone, self.chain(2, own, here, there)))
        self.regs(0, LOCAL, 0)
        alone = self.guest.one("PIXEL", *here, W_ONE, 0, 0, 0)
        self.hints.append((1, 0, alone, self.chain(1, 0, here, there)))


def gradients(lod: int) -> list[int]:
    """Gradients with this LOD, 8.8: rounding loses at most half a unit of the logarithm."""
    return [int(ONE * 2 ** ((lod + 0.25) / LOD_ONE)), 0, 0, 0]


def channels(argb: int) -> list[int]:
    """A R G B."""
    return [argb >> shift & 255 for shift in (24, 16, 8, 0)]


@pytest.fixture(scope="module")
def answers() -> tuple[Questions, Chain, list[int]]:
    """All answers, from one boot."""
    q = Questions()
    numbers(q, random.Random(41))
    q.guest.do("GLIDE_RESET", 4)
    fractions(q)
    detail_factors(q)
    q.guest.do("GLIDE_RANDOM", SEED)
    samples(q, xorshift(SEED, 1 << 16).astype("<u4").tobytes())
    chain = Chain(q.guest)
    q.guest.do("GLIDE_CHOOSE", 1)
    q.guest.do("GLIDE_RANDOM", SEED)
    for lod in LODS:
        chain.blend(lod, True)
        chain.blend(lod, False)
    q.guest.do("GLIDE_CHOOSE", 0)
    for lod in LODS:
        chain.two_passes(lod)
    chain.whose_points()
    return q, chain, [answer[0] & MASK for answer in q.guest.run()]


def test_numbers_and_rules(answers) -> None:
    """Logarithms, quotients, LOD, detail, samples."""
    questions, _, found = answers
    wrong = [f"{what}: expected {expected & MASK:x}, found {answer:x}"
             for (what, expected), answer in zip(questions.expected, found)
             if answer != expected & MASK]
    assert not wrong, "\n".join([f"{len(wrong)} of {len(questions.expected)} are wrong", *wrong[:10]])


def test_trilinear_filtering(answers) -> None:
    """Both orders of the units: local + (other - local) (m + 1) / 256, where the odd level's weight
    is the LOD's fraction, or one minus it if the finer level is odd."""
    _, chain, found = answers
    for lod, even_first, *places in chain.trilinear:
        local, other, blended = (channels(found[place]) for place in places)
        odd_weight = 255 - (lod & 255) if lod >> 8 & 1 else lod & 255
        m = odd_weight if even_first else 255 - odd_weight
        expected = [a + ((b - a) * (m + 1) >> 8) for a, b in zip(local, other)]
        assert local != other and blended == expected, (
            f"LOD {lod}/256, even levels {'first' if even_first else 'second'}: {local} and {other} "
            f"make {blended}, not {expected}")


def test_trilinear_filtering_in_two_passes(answers) -> None:
    """Each pass draws its level's part, rounded down: the sum is that of one pass, or one or two
    less."""
    _, chain, found = answers
    for lod, *places in chain.passes:
        near, far, first, second = (channels(found[place]) for place in places)
        part = lod & 255
        for a, b, got in zip(near, far, map(sum, zip(first, second))):
            expected = (a * (255 - part) >> 8) + (b * part >> 8)
            even, odd, weight = (b, a, 255 - part) if lod >> 8 & 1 else (a, b, part)
            blend = even + ((odd - even) * (weight + 1) >> 8)
            assert got == expected and 0 <= blend - got <= 2, (
                f"LOD {lod}/256: {a} and {b} make {got} in two passes, not {expected}; {blend} in "
                "one")


def test_whose_points_count(answers) -> None:
    """If bit n is set unit n has a separate point, otherwise it uses that of unit 0."""
    _, chain, found = answers
    for units, own, alone, together in chain.hints:
        assert found[alone] == found[together], (
            f"{units} units, own {own}: {found[together]:08x}, not {found[alone]:08x}")
    assert len({found[alone] for _, _, alone, _ in chain.hints}) > 1, "both places look the same"


def test_programs_carry_what_they_call() -> None:
    """The linker leaves out unused routines."""
    maps = {name: (ROOT / "build" / "programs" / f"{name}.map").read_text()
            for name in ("vectors", "render", "bench")}
    assert "glide_pixel" in maps["vectors"] and "glide_pixel" in maps["render"]
    assert "glide_pixel" not in maps["bench"], "bench has passes alone"
    for call in ("glide_download_rows", "glide_registers_of"):
        assert call in maps["vectors"] and call not in maps["render"], call
