"""The calls in C and tools/tx/words.py, which know nothing of each other, write the same words."""

import random

from tx_guest import Guest, result_name

from tools import layout
from tools.tx.combiner import ALPHA_NAMES, RGB_NAMES
from tools.tx.state import LEGAL
from tools.tx.words import CONVERTS, CYCLES, DETAILS, FILTERS, TLUTS, Cycle, List, Wrap

PAIRS = 8
ROUNDS = 25
ANY = 0x3FFFFFFF  # of a first word: the calls set the two bits above, as the manual does
ZEROES = (15, 15, 31, 7), (7, 7, 7, 7)  # the combiner's codes of 0, of colour and alpha
#: Values of the manual's modes in C, in the order of the tools' names.
DETAIL_CODES = dict(zip(DETAILS, (0, 1, 2)))
LUT_CODES = dict(zip(TLUTS, (0, 2, 3)))
FILTER_CODES = dict(zip(FILTERS, (0, 2, 3)))
CONVERSION_CODES = dict(zip(CONVERTS, (6, 0, 5)))


class Calls:
    """Calls of both: name and arguments in C, and the words of the tools."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.made: list[tuple[str, list[int], list[tuple[int, int]]]] = []

    def below(self, end: int) -> int:
        """0 to end - 1, often one of these two."""
        return self.random.choice((0, end - 1, *(self.random.randrange(end) for _ in range(4))))

    def add(self, name: str, arguments: list[int], method, *values, **named) -> None:
        """A call in C by name, and one of ``List``."""
        words = List()
        method(words, *values, **named)
        self.made.append((name, arguments, words.words))

    def wrap(self) -> tuple[list[int], Wrap]:
        """An axis as the calls and the tools have it."""
        wrap = Wrap(self.below(2), self.below(2), self.below(16), self.below(16))
        return [wrap.clamp << 1 | wrap.mirror, wrap.mask, wrap.shift], wrap

    def textures(self) -> None:
        """Both ways to load one."""
        form, size = self.random.choice(sorted(LEGAL))
        width, height = 16 << self.below(3), 1 + self.below(16)
        palette, tmem, tile = self.below(16), self.below(512), self.below(8)
        address = 8 * self.below(1 << 21)
        (cs, s), (ct, t) = self.wrap(), self.wrap()
        left, top = 2 * self.below(4), self.below(5)
        right, bottom = left + 1 + 2 * self.below(4), top + self.below(5)
        rest = [palette, *cs, *ct, tmem, tile]
        end = "_4B" if size == 0 else ""
        self.add(f"TEXTURE_BLOCK{end}", [address, form, size, width, height, 0, 0, 0, 0, *rest],
                 List.load_texture_block, address, form, size, width, height, palette, s, t,
                 tmem=tmem, tile=tile)
        self.add(f"TEXTURE_TILE{end}",
                 [address, form, size, width, 0, left, top, right, bottom, *rest],
                 List.load_texture_tile, address, form, size, width, (left, top, right, bottom),
                 palette, s, t, tmem=tmem, tile=tile)
        line = self.below(512)
        self.add("TILE", [form, size, line, tmem, tile, palette, *ct, *cs], List.set_tile, tile,
                 form, size, line, tmem, palette, s, t)
        self.add("IMAGE", [form, size, width, address], List.set_texture_image, form, size, width,
                 address)

    def loads(self) -> None:
        """Palettes and the plain words."""
        address, palette, tile = 8 * self.below(1 << 21), self.below(16), self.below(8)
        edges = [self.below(4096) for _ in range(4)]
        count = self.below(256) + 1
        self.add("TLUT_16", [palette, address], List.load_tlut_pal16, palette, address)
        self.add("TLUT_256", [address], List.load_tlut_pal256, address)
        self.add("TILE_SIZE", [tile, *edges], List.set_tile_size, tile, *edges)
        self.add("LOAD_TILE", [tile, *edges], List.load_tile, tile, *edges)
        self.add("LOAD_TLUT", [tile, count - 1], List.load_tlut_command, tile, count)
        first, step = self.below(2048), self.below(4096)
        block = [first, self.below(4096), min(first + self.below(2048), 4095), step]
        self.add("LOAD_BLOCK", [tile, *block], List.load_block, tile, *block)

    def cycle(self) -> tuple[list[list[int]], Cycle]:
        """Codes and names of a combiner's cycle."""
        codes, names = [], []
        for tables, zeroes in zip((RGB_NAMES, ALPHA_NAMES), ZEROES):
            chosen = [self.random.choice([name for name in table if name] + ["0"])
                      for table in tables]
            names.append(tuple(chosen))
            codes.append([zero if name == "0" else table.index(name)
                          for name, table, zero in zip(chosen, tables, zeroes)])
        return codes, Cycle(*names)

    def colours(self) -> None:
        """Combine mode, constants, syncs."""
        (first, names0), (second, names1) = self.cycle(), self.cycle()
        self.add("COMBINE", first[0] + second[0] + first[1] + second[1], List.combine_mode, names0,
                 names1)
        k = [self.below(512) - 256 for _ in range(6)]
        self.add("CONVERT", k, List.set_convert, *k)
        colour = tuple(self.below(256) for _ in range(4))
        packed = int.from_bytes(bytes(colour), "big")
        level, fraction = self.below(32), self.below(256)
        self.add("PRIMITIVE", [level, fraction, packed], List.prim_colour, level, fraction, colour)
        self.add("ENVIRONMENT", [packed], List.env_colour, colour)
        for name in ("load", "pipe", "tile", "full"):
            self.add(f"{name.upper()}_SYNC", [], getattr(List, f"{name}_sync"))


def ask_call(guest: Guest, name: str, arguments: list[int]) -> int:
    """The answer's number: result, pairs, words."""
    return guest.ask("CALL", PAIRS, layout.load().constants[f"VECTOR_CALL_{name}"], *arguments,
                     numbers=2 + 2 * PAIRS)


def words_of(answer: list[int]) -> list[tuple[int, int]]:
    """The words that a call wrote."""
    assert result_name(answer[0]) == "DONE"
    halves = [half & 0xFFFFFFFF for half in answer[2:2 + 2 * answer[1]]]
    return list(zip(halves[::2], halves[1::2]))


def text(words: list[tuple[int, int]]) -> str:
    """For messages."""
    return " ".join(f"{hi:08x}:{lo:08x}" for hi, lo in words)


def test_calls_and_tools_write_the_same_words() -> None:
    """Random loads, tiles, constants; of a first word's upper two bits the calls set both."""
    calls, guest = Calls(11), Guest()
    for _ in range(ROUNDS):
        calls.textures()
        calls.loads()
        calls.colours()
    for name, arguments, _ in calls.made:
        ask_call(guest, name, arguments)
    for (name, arguments, words), answer in zip(calls.made, guest.run(), strict=True):
        found = words_of(answer)
        assert all(hi >> 30 == 3 for hi, _ in found), (name, text(found))
        assert [(hi & ANY, lo) for hi, lo in found] == words, (
            f"{name}{tuple(arguments)}: the call writes {text(found)}, the tools {text(words)}; "
            "again: .deps/venv/bin/python -m pytest tests/test_tx_calls.py")


def test_calls_and_tools_set_the_same_modes() -> None:
    """The calls change some modes and the tools all: after a call the tools' word changes
    nothing, which the modes' generation tells."""
    chosen, words, asked = random.Random(12), List(), []
    words.texture_convert("filter")
    first = Guest()
    for _ in range(4 * ROUNDS):
        name, method, codes = chosen.choice((
            ("CYCLE", words.cycle_type, CYCLES), ("DETAIL", words.texture_detail, DETAIL_CODES),
            ("PERSPECTIVE", words.texture_perspective, {False: 0, True: 1}),
            ("LOD", words.texture_lod, {False: 0, True: 1}),
            ("LUT", words.texture_lut, LUT_CODES), ("FILTER", words.texture_filter, FILTER_CODES),
            ("CONVERSION", words.texture_convert, CONVERSION_CODES)))
        choice = chosen.choice(list(codes))
        method(choice)
        asked.append((name, choice, [words.words[-1]]))
        ask_call(first, name, [int(codes[choice])])
    for level in range(8):
        texture = List()
        texture.texture(level, 7 - level)
        asked.append(("TEXTURE", level, texture.words))
        ask_call(first, "TEXTURE", [level, 7 - level])
    second = Guest()
    second.words(words.words[0])
    second.ask("GENERATIONS", 0, numbers=3)
    for (_, _, expected), answer in zip(asked, first.run(), strict=True):
        for run in (words_of(answer), expected):
            second.words(*run)
            second.ask("GENERATIONS", 0, numbers=3)
    answers = second.run()
    generations = [answer[2] for answer in answers[1::2]]
    assert all(result_name(answer[0]) == "DONE" for answer in answers[::2])
    for n, (name, choice, _) in enumerate(asked):
        assert generations[2 * n + 2] == generations[2 * n + 1], \
            f"call {n}, {name} {choice!r}: the tools' word changes the modes that it left"
    assert generations[-1] > len(asked) // 2  # most calls changed something
