"""The C calls and tools/tmap/n64/words.py, which are independent of each other, write the same
words; some words are computed by hand."""

import random

import pytest

from tests.n64.guest import BITS_16, RESULTS, RGBA, Guest
from tests.helpers import vector_guest
from tmap.build import layout
from tmap.n64.combiner import ALPHA_NAMES, RGB_NAMES
from tmap.n64.state import LEGAL
from tmap.n64.words import CONVERTS, CYCLES, DETAILS, FILTERS, TLUTS, Cycle, List, Wrap

PAIRS = 8  # size of the buffer for words, in pairs
ROUNDS = 25
ANY = 0x3FFFFFFF  # mask of a first word: the calls set the upper two bits, as the manual does
ZEROES = (15, 15, 31, 7), (7, 7, 7, 7)  # the combiner's codes of 0, for colour and alpha
#: Values of the manual's modes in C, in the order of the tools' names.
DETAIL_CODES = dict(zip(DETAILS, (0, 1, 2)))
LUT_CODES = dict(zip(TLUTS, (0, 2, 3)))
FILTER_CODES = dict(zip(FILTERS, (0, 2, 3)))
CONVERSION_CODES = dict(zip(CONVERTS, (6, 0, 5)))

#: Calls and their words, computed by hand: those that change modes, whose form the tools do not
#: write, and one of each other kind.
BY_HAND = {
    # 32x32 RGBA 16, mirrored in s, clamped in t: image, format, size, width, height, sl, tl, sh,
    # th, palette, then wrap, mask and shift of s and of t
    ("TEXTURE_BLOCK", 0x123450, RGBA, BITS_16, 32, 32, 0, 0, 0, 0, 0, 1, 5, 0, 2, 0, 0): (
        0xFD100000, 0x00123450, 0xF5100000, 0x07080150, 0xE6000000, 0, 0xF3000000, 0x073FF100,
        0xE7000000, 0, 0xF5101000, 0x00080150, 0xF2000000, 0x0007C07C),
    ("TLUT_16", 3, 0x2000): (
        0xFD100000, 0x00002000, 0xE8000000, 0, 0xF5000130, 0x07000000, 0xE6000000, 0,
        0xF0000000, 0x0703C000, 0xE7000000, 0),
    ("LOAD_BLOCK", 7, 0, 0, 5000, 256): (0xF3000000, 0x07FFF100),  # too large stays too large
    ("TEXTURE", 5, 2): (0xD7002A02, 0xFFFFFFFF),
    ("CYCLE", 1): (0xE3000A01, 0x00100000),
    ("PERSPECTIVE", 1): (0xE3000C00, 0x00080000),
    ("DETAIL", 2): (0xE3000D01, 0x00040000),
    ("LOD", 1): (0xE3000F00, 0x00010000),
    ("LUT", 3): (0xE3001001, 0x0000C000),
    ("FILTER", 2): (0xE3001201, 0x00002000),
    ("CONVERSION", 6): (0xE3001402, 0x00000C00),
    # texel 0 times shade, alpha too, in both cycles
    ("COMBINE", 1, 15, 4, 7, 1, 15, 4, 7, 1, 7, 4, 7, 1, 7, 4, 7): (0xFC121824, 0xFF33FFFF),
}


class Calls:
    """Random calls: name and arguments in C, and the words of the tools."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.made: list[tuple[str, list[int], list[tuple[int, int]]]] = []

    def below(self, end: int) -> int:
        """A random number from 0 to end - 1, often one of these two."""
        return self.random.choice((0, end - 1, *(self.random.randrange(end) for _ in range(4))))

    def add(self, name: str, arguments: list[int], method, *values, **named) -> None:
        """Adds a call in C by name, and the equivalent call of ``List``."""
        words = List()
        method(words, *values, **named)
        self.made.append((name, arguments, words.words))

    def wrap(self) -> tuple[list[int], Wrap]:
        """A random axis in the forms of the calls and of the tools."""
        wrap = Wrap(self.below(2), self.below(2), self.below(16), self.below(16))
        return [wrap.clamp << 1 | wrap.mirror, wrap.mask, wrap.shift], wrap

    def textures(self) -> None:
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


def ask_call(guest: Guest, name: str, arguments: list[int], room: int = PAIRS) -> int:
    """Adds a call; returns the index of its answer: result, pairs, words."""
    return guest.ask("CALL", room, layout.load().constants[f"VECTOR_CALL_{name}"], *arguments,
                     numbers=2 + 2 * PAIRS)


def words_of(answer: list[int]) -> list[tuple[int, int]]:
    assert RESULTS[answer[0]] == "DONE"
    halves = [half & 0xFFFFFFFF for half in answer[2:2 + 2 * answer[1]]]
    return list(zip(halves[::2], halves[1::2]))


def text(words: list[tuple[int, int]]) -> str:
    return " ".join(f"{hi:08x}:{lo:08x}" for hi, lo in words)


def ask_calls(calls: Calls) -> Guest:
    """The calls one after the other, then each with room for one pair less than it writes."""
    guest = Guest()
    for less in (False, True):
        for name, arguments, words in calls.made:
            ask_call(guest, name, arguments, len(words) - 1 if less else PAIRS)
    return guest


def ask_modes(guest: Guest) -> list[tuple[str, object, list[tuple[int, int]]]]:
    """Random calls, each of which sets only some modes; finally texture levels: name, choice, the
    tools' words, which set all modes. First are the words that set the initial modes."""
    chosen, words = random.Random(12), List()
    words.texture_convert("filter")
    made = [("", "", words.words[:1])]
    for _ in range(4 * ROUNDS):
        name, method, codes = chosen.choice((
            ("CYCLE", words.cycle_type, CYCLES), ("DETAIL", words.texture_detail, DETAIL_CODES),
            ("PERSPECTIVE", words.texture_perspective, {False: 0, True: 1}),
            ("LOD", words.texture_lod, {False: 0, True: 1}),
            ("LUT", words.texture_lut, LUT_CODES), ("FILTER", words.texture_filter, FILTER_CODES),
            ("CONVERSION", words.texture_convert, CONVERSION_CODES)))
        choice = chosen.choice(list(codes))
        method(choice)
        made.append((name, choice, [words.words[-1]]))
        ask_call(guest, name, [int(codes[choice])])
    for level in range(8):
        texture = List()
        texture.texture(level, 7 - level)
        made.append(("TEXTURE", level, texture.words))
        ask_call(guest, "TEXTURE", [level, 7 - level])
    return made


@pytest.fixture(scope="module")
def asked() -> dict:
    """Random calls, calls that change modes, and the answers, from one boot."""
    calls = Calls(11)
    for _ in range(ROUNDS):
        calls.textures()
        calls.loads()
        calls.colours()
    by_hand, modes = Guest(), Guest()
    for name, *arguments in BY_HAND:
        ask_call(by_hand, name, arguments)
    return {"calls": calls, "changes": ask_modes(modes)} | {"answers": vector_guest.run_all({
        "by hand": by_hand, "calls": ask_calls(calls), "modes": modes})}


def test_calls_write_the_manuals_words(asked) -> None:
    for (call, words), answer in zip(BY_HAND.items(), asked["answers"]["by hand"], strict=True):
        assert words_of(answer) == list(zip(words[::2], words[1::2])), (
            f"{call} writes {text(words_of(answer))}")


def test_calls_and_tools_write_the_same_words(asked) -> None:
    """Random loads, tiles, constants; the calls set both upper bits of a first word. With room for
    one pair less nothing is written."""
    made, answers = asked["calls"].made, asked["answers"]["calls"]
    for (name, arguments, words), answer in zip(made, answers[:len(made)], strict=True):
        found = words_of(answer)
        assert all(hi >> 30 == 3 for hi, _ in found), (name, text(found))
        assert [(hi & ANY, lo) for hi, lo in found] == words, (
            f"{name}{tuple(arguments)}: the call writes {text(found)}, the tools {text(words)}")
    for (name, *_), (code, count, *_) in zip(made, answers[len(made):], strict=True):
        assert (RESULTS[code], count) == ("LIST_FULL", 0), name


def test_calls_and_tools_set_the_same_modes(asked) -> None:
    """The calls set some modes, the tools all of them: the tools' word after a call changes
    nothing, so the modes' generation stays the same."""
    ((*_, first), *changes), guest = asked["changes"], Guest()
    guest.words(*first)
    guest.ask("GENERATIONS", 0, numbers=3)
    for (_, _, expected), answer in zip(changes, asked["answers"]["modes"], strict=True):
        for run in (words_of(answer), expected):
            guest.words(*run)
            guest.ask("GENERATIONS", 0, numbers=3)
    answers = guest.run()
    generations = [answer[2] for answer in answers[1::2]]
    assert all(RESULTS[answer[0]] == "DONE" for answer in answers[::2])
    for n, (name, choice, _) in enumerate(changes):
        assert generations[2 * n + 2] == generations[2 * n + 1], \
            f"call {n}, {name} {choice!r}: the tools' word changes the modes that it left"
    assert generations[-1] > len(changes) // 2  # most calls changed something
