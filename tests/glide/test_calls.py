"""The C calls and tools/tmap/glide/words.py, which are independent of each other, set the same
registers; bad arguments have distinct results and change nothing."""

import random
from fractions import Fraction

import pytest

from tests.helpers import vector_guest
from tests.glide.guest import LEVEL_NUMBERS, MASK, RESULTS, Guest, texture
from tmap.glide.words import (ASPECTS, FACTORS, FIELDS, FILTERS, FORMATS, FUNCTIONS, MIPMAPS,
                              WRAPS, Words, memory_required)

ROUNDS = 60
FUNCTION_NUMBERS = {name: number for number, name in enumerate(FUNCTIONS)}
FACTOR_NUMBERS = {name: mselect if reverse else mselect | 8
                  for name, (mselect, reverse) in FACTORS.items()}
MEMORY = 1 << 18


class Calls:
    """Random calls: name and arguments in C, the tools' registers after them, and the call's return
    value if known."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.words = Words()
        self.made: list[tuple[str, list[int], tuple[int, ...], int]] = []

    def add(self, name: str, arguments: list[int], own: int = 0) -> None:
        self.made.append((name, arguments, self.words.words(), own))

    def source(self) -> None:
        """Adds a map that fits, and the question how much memory it needs."""
        choose = self.random
        largest = choose.randrange(9)
        smallest = choose.randrange(largest, 9)
        levels = choose.choice(list(LEVEL_NUMBERS))
        if largest == smallest and levels != "both":
            levels = ("even", "odd")[largest % 2]
        aspect, form = choose.choice(ASPECTS), choose.choice(list(FORMATS))
        shape = (levels, largest, smallest, aspect, form)
        needed = memory_required(*shape)
        last = MEMORY - needed
        start = choose.choice((0, last, 8 * choose.randrange(last // 8 + 1)))
        numbers = [LEVEL_NUMBERS[levels], *texture(largest, smallest, aspect, form)]
        self.add("MEMORY_REQUIRED", numbers, needed)
        self.words.source(start, *shape)
        self.add("SOURCE", [start, *numbers])

    def modes(self) -> None:
        choose, words = self.random, self.words
        on, other, first, second = (choose.randrange(2) for _ in range(4))
        match choose.randrange(9):
            case 0:
                words.filter(FILTERS[on], FILTERS[other])
                self.add("FILTER", [on, other])
            case 1:
                words.clamp(WRAPS[on], WRAPS[other])
                self.add("CLAMP", [on, other])
            case 2:
                mode = choose.randrange(3)
                words.mipmap(MIPMAPS[mode], bool(on))
                self.add("MIPMAP", [mode, on])
            case 3:
                bias = choose.choice((-8 << 16, 31 << 14, choose.randrange(-8 << 16, 31 << 14)))
                words.lod_bias(Fraction(bias, 1 << 16))
                self.add("LOD_BIAS", [bias])
            case 4:
                detail = [choose.choice((-32, 31, 0, 4)), choose.randrange(8),
                          choose.choice((0, 255, 100))]
                words.detail(*detail)
                self.add("DETAIL", detail)
            case 5:
                words.perspective(bool(on), bool(other))
                self.add("PERSPECTIVE", [on, other])
            case 6:
                words.ncc_select(on)
                self.add("NCC_SELECT", [on])
            case 7 if not words.fields["split"]:
                words.blend_levels(("even", "odd")[on])
                self.add("BLEND_LEVELS", [1 + on])
            case _:
                names = [choose.choice(list(table))
                         for table in (FUNCTIONS, FACTORS) * 2]
                words.combine(*names, bool(first), bool(second))
                self.add("COMBINE", [FUNCTION_NUMBERS[names[0]], FACTOR_NUMBERS[names[1]],
                                     FUNCTION_NUMBERS[names[2]], FACTOR_NUMBERS[names[3]],
                                     first, second])


def registers(answer: list[int] | tuple[int, ...]) -> str:
    return " ".join(f"{word & MASK:08x}" for word in answer)


def random_registers(choose: random.Random) -> list[int]:
    words = [choose.getrandbits(32), choose.getrandbits(23), choose.getrandbits(17),
             choose.getrandbits(29)]
    form = choose.choice(list(FORMATS.values()))
    words[0] = words[0] & 0x7FFFFFFF & ~(7 << 14 | 7 << 23 | 15 << 8) | form << 8
    return [words[0] | choose.randrange(6) << 14 | choose.randrange(6) << 23, *words[1:]]


#: Results of drawing polygons; no call returns them.
OF_POLYGONS = ("BAD_COORDINATE", "BAD_W", "NO_COORDINATES")
#: A source of 64 by 64 texels of 8 bits, levels 2 to 5, of which the even ones are stored, from
#: address 1024 on.
MAP = [1024, 1, 2, 5, 3, 3]
#: Call, arguments, result, after that source is set.
BAD = [
    *(("INIT", [size], "BAD_MEMORY") for size in (0, 4, 7, 3000, MEMORY - 8)),
    *((name, [*MAP[:2], *levels, *MAP[4:], *rest], result)
      for name, rest in (("SOURCE", []), ("DOWNLOAD", [1]), ("DOWNLOAD_LEVEL", [2, 1]),
                         ("DOWNLOAD_ROWS", [2, 0, 0, 1]))
      for levels, result in (([9, 9], "BAD_LEVEL"), ([0, 9], "BAD_LEVEL"),
                             ([MASK, MASK], "BAD_LEVEL"), ([3, 2], "BAD_LEVEL_ORDER"),
                             ([3, 3], "NO_LEVEL"))),
    *((name, [*before, *numbers, *rest], result)
      for name, before, rest in (("SOURCE", [0], []), ("DOWNLOAD", [0], [1]),
                                 ("MEMORY_REQUIRED", [], []))
      for numbers, result in (([0, 2, 5, 3, 3], "BAD_LEVELS"), ([4, 2, 5, 3, 3], "BAD_LEVELS"),
                              ([2, 4, 4, 3, 3], "NO_LEVEL"), ([3, 2, 5, 7, 3], "BAD_ASPECT"),
                              ([3, 2, 5, 3, 6], "BAD_FORMAT"), ([3, 2, 5, 3, 7], "BAD_FORMAT"),
                              ([3, 2, 5, 3, 15], "BAD_FORMAT"))),
    *((name, [start, 3, 0, 8, 3, 10, *rest], result)
      for name, rest in (("SOURCE", []), ("DOWNLOAD", [1]), ("DOWNLOAD_LEVEL", [8, 1]))
      for start, result in ((4, "BAD_START"), (1, "BAD_START"), (MEMORY, "OUTSIDE_MEMORY"),
                            (MEMORY - (0x2AAB0 - 8), "OUTSIDE_MEMORY"),
                            (MASK - 7, "OUTSIDE_MEMORY"))),
    ("DOWNLOAD_LEVEL", [*MAP, 9, 1], "BAD_LEVEL"),
    ("DOWNLOAD_LEVEL", [*MAP, 3, 1], "LEVEL_NOT_HELD"),
    ("DOWNLOAD_LEVEL", [*MAP, 0, 1], "LEVEL_NOT_HELD"),
    ("DOWNLOAD_LEVEL", [*MAP, 6, 1], "LEVEL_NOT_HELD"),
    ("DOWNLOAD_ROWS", [*MAP, 2, 5, 4, 1], "BAD_ROWS"),
    ("DOWNLOAD_ROWS", [*MAP, 2, 0, 64, 1], "BAD_ROWS"),
    ("DOWNLOAD_ROWS", [*MAP, 2, 0, MASK, 1], "BAD_ROWS"),
    ("PALETTE", [0, 256], "BAD_ENTRIES"), ("PALETTE", [5, 4], "BAD_ENTRIES"),
    ("PALETTE", [MASK, MASK], "BAD_ENTRIES"),
    ("NCC", [2], "BAD_NCC_TABLE"), ("NCC_REGISTERS", [2], "BAD_NCC_TABLE"),
    ("NCC_SELECT", [2], "BAD_NCC_TABLE"),
    *(("NCC", [1, *[0] * (16 + n), value], "BAD_NCC_VALUE")
      for n, value in ((0, -257), (11, 256), (12, 256), (23, -257))),
    ("FILTER", [2, 0], "BAD_FILTER"), ("FILTER", [0, 2], "BAD_FILTER"),
    *(("FRACTION_BITS", [bits], "BAD_FRACTION_BITS") for bits in (0, 5, 16)),
    *(("SUBDIVISION", [pixels], "BAD_SUBDIVISION") for pixels in (1, 4, 32, 256 + 8, MASK)),
    ("CLAMP", [2, 0], "BAD_WRAPPING"), ("CLAMP", [0, 2], "BAD_WRAPPING"),
    ("MIPMAP", [3, 0], "BAD_MIPMAP"), ("MIPMAP", [1, 2], "BAD_FLAG"),
    *(("BLEND_LEVELS", [levels], "BAD_LEVELS") for levels in (0, 1, 2, 3)),  # the map is split
    ("LOD_BIAS", [(-8 << 16) - 1], "BAD_LOD_BIAS"), ("LOD_BIAS", [(31 << 14) + 1], "BAD_LOD_BIAS"),
    ("DETAIL", [-33, 0, 0], "BAD_DETAIL_BIAS"), ("DETAIL", [32, 0, 0], "BAD_DETAIL_BIAS"),
    ("DETAIL", [0, 8, 0], "BAD_DETAIL_SCALE"), ("DETAIL", [0, 0, 256], "BAD_DETAIL_MAX"),
    ("COMBINE", [11, 0, 0, 0, 0, 0], "BAD_FUNCTION"),
    ("COMBINE", [0, 0, MASK, 0, 0, 0], "BAD_FUNCTION"),
    *(("COMBINE", [0, factor, 0, 0, 0, 0], "BAD_FACTOR") for factor in (6, 7, 14, 15, 16, MASK)),
    ("COMBINE", [0, 0, 0, 6, 0, 0], "BAD_FACTOR"),
    ("COMBINE", [0, 0, 0, 0, 2, 0], "BAD_FLAG"), ("COMBINE", [0, 0, 0, 0, 0, 2], "BAD_FLAG"),
    ("PERSPECTIVE", [2, 0], "BAD_FLAG"), ("PERSPECTIVE", [0, 2], "BAD_FLAG"),
    ("REGISTERS", [6 << 8, 0, 0, 0], "BAD_FORMAT"), ("REGISTERS", [15 << 8, 0, 0, 0], "BAD_FORMAT"),
    ("REGISTERS", [6 << 14, 0, 0, 0], "BAD_FACTOR"),
    ("REGISTERS", [7 << 23, 0, 0, 0], "BAD_FACTOR"),
    ("REGISTERS", [0, 1 << 23, 0, 0], "BAD_REGISTER"),
    ("REGISTERS", [0, 0, 1 << 17, 0], "BAD_REGISTER"),
    ("REGISTERS", [0, 0, 0, 1 << 29], "BAD_REGISTER"),
    ("CHAIN", [0, 0], "BAD_UNITS"), ("CHAIN", [3, 0], "BAD_UNITS"), ("CHAIN", [2, 4], "BAD_UNITS"),
]
#: Calls, and which generation each increases: memory, tables, modes. The second of two equal calls
#: leaves the modes unchanged.
CHANGES = [("FILTER", [1, 1]), ("FILTER", [1, 1]), ("FRACTION_BITS", [8]),
           ("SUBDIVISION", [16]), ("SUBDIVISION", [16]), ("SUBDIVISION", [0]), ("SUBDIVISION", [8]),
           ("DOWNLOAD", [*MAP, 1]), ("DOWNLOAD_LEVEL", [*MAP, 2, 1]),
           ("DOWNLOAD_ROWS", [*MAP, 2, 3, 4, 1]), ("PALETTE", [0, 0, 1]), ("NCC", [0]),
           ("SOURCE", MAP)]
GROWTH = [2, None, 2, 2, None, 2, 2, 0, 0, 0, 1, 1, None]
PALETTE = [n * 0x010203 & 0xFFFFFF for n in range(256)]
NCC = [*range(16), *range(-256, -244), *range(244, 256)]
NCC_WORDS = [0x03020100, 0x07060504, 0x0B0A0908, 0x0F0E0D0C,
             *((a & 511) << 18 | (a + 1 & 511) << 9 | a + 2 & 511
               for a in (*range(-256, -244, 3), *range(244, 256, 3)))]
TEXT_LONGS = 64


@pytest.fixture(scope="module")
def answers() -> dict:
    """Answers of all tests, from one boot, in lists; each begins with new units."""
    calls, choose = Calls(21), random.Random(22)
    calls.source()
    for _ in range(ROUNDS):
        for _ in range(8):
            calls.modes()
        calls.source()
    words = [random_registers(choose) for _ in range(ROUNDS)]
    guests = {name: Guest() for name in ("calls", "round", "bad", "generations", "tables", "texts")}
    every, again, bad, changes, tables, texts = guests.values()
    every.call("INIT", MEMORY)
    for name, arguments, _, _ in calls.made:
        every.call(name, *arguments)
    for four in words:
        again.call("REGISTERS", *four)
    for guest, some in ((bad, [each[:2] for each in BAD]), (changes, CHANGES)):
        guest.do("GLIDE_RESET", 4)
        guest.call("SOURCE", *MAP)
        guest.ask("GLIDE_GENERATIONS", numbers=3)
        for name, arguments in some:
            guest.call(name, *arguments)
            if guest is changes:
                guest.ask("GLIDE_GENERATIONS", numbers=3)
    bad.ask("GLIDE_GENERATIONS", numbers=3)
    tables.call("PALETTE", 0, 255, *PALETTE)
    tables.call("PALETTE", 3, 4, 0xFF123456, 0x654321)
    tables.call("NCC", 1, *NCC)
    tables.call("NCC_REGISTERS", 0, *NCC_WORDS)
    for n in range(len(RESULTS) + 1):
        texts.ask("GLIDE_RESULT_TEXT", n, numbers=TEXT_LONGS)
    return vector_guest.run_all(guests) | {"made": calls.made, "words": words}


def weighed(values: list[int]) -> int:
    """A checksum: the sum of the numbers, each times twice its index plus one."""
    return sum(value * (2 * n + 1) for n, value in enumerate(values)) & MASK


def test_calls_and_tools_set_the_same_registers(answers) -> None:
    """Random calls, all registers after each; sources that just fit; the memory they need."""
    assert registers(answers["calls"][0][1:5]) == registers(Words().words()), "as new"
    for (name, arguments, words, own), answer in zip(answers["made"], answers["calls"][1:],
                                                     strict=True):
        assert RESULTS[answer[0]] == "DONE", (name, arguments, RESULTS[answer[0]])
        assert registers(answer[1:5]) == registers(words), (
            f"{name}{tuple(arguments)}: registers {registers(answer[1:5])}, expected "
            f"{registers(words)}")
        assert answer[5] == own, f"{name}{tuple(arguments)}: found {answer[5]}, expected {own}"
    assert len({name for name, *_ in answers["made"]}) == 11


def test_registers_round_trip(answers) -> None:
    """All fields are random, and so are the bits between them: only bit 31 of the first register is
    dropped."""
    for words, answer in zip(answers["words"], answers["round"], strict=True):
        assert RESULTS[answer[0]] == "DONE", (registers(words), RESULTS[answer[0]])
        assert registers(answer[1:5]) == registers(words), (
            f"set {registers(words)}, read {registers(answer[1:5])}")
    used = [0] * 4
    for register, shift, bits in FIELDS.values():
        used[register] |= (1 << bits) - 1 << shift
    assert used == [0x7FFFFFFF, 0x7FFFFF, 0x1FFFF, 0x1FFFFFFF]


def test_bad_arguments_change_nothing(answers) -> None:
    """Each error has its name; registers and generations stay the same."""
    (_, *before, _), first, *found, last = answers["bad"]
    assert first == last, f"generations {first} became {last}"
    for (name, arguments, result), answer in zip(BAD, found, strict=True):
        assert RESULTS[answer[0]] == result, (
            f"{name}{tuple(arguments)}: expected {result}, found {RESULTS[answer[0]]}")
        assert answer[1:5] == before, f"{name}{tuple(arguments)} changes registers"
    assert {result for _, _, result in BAD} == {*RESULTS} - {"DONE", *OF_POLYGONS}


def test_what_grows(answers) -> None:
    found = answers["generations"][1::2]
    for n, ((name, _), which) in enumerate(zip(CHANGES, GROWTH, strict=True)):
        grown = [i for i in range(3) if found[n + 1][i] > found[n][i]]
        same = [i for i in range(3) if found[n + 1][i] == found[n][i]]
        assert grown == ([] if which is None else [which]) and len(grown + same) == 3, (
            f"change {n}, {name}: memory, tables, modes {found[n]}, then {found[n + 1]}")


def test_tables(answers) -> None:
    """Whole palettes; some entries, whose upper byte is ignored; NCC tables in both forms."""
    whole, some, values, words = (answer[5] & MASK for answer in answers["tables"])
    changed = [*PALETTE[:3], 0x123456, 0x654321, *PALETTE[5:]]
    assert whole == weighed(PALETTE) and some == weighed(changed)
    assert values == words == weighed(NCC)


def test_results_have_texts(answers) -> None:
    texts = ["".join(chr(c) for c in answer if c) for answer in answers["texts"]]
    assert texts[0] == "done" and texts[-1] == "unknown result"
    assert len(set(texts)) == len(texts) and all(0 < len(text) < TEXT_LONGS for text in texts)
