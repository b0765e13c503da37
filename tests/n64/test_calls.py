"""The C calls and tools/tmap/n64/words.py, which are independent of each other, write the same
words; some words are computed by hand."""

import random
from dataclasses import dataclass

import pytest

from tests.n64.guest import BITS_16, BITS_32, BITS_8, CI, I, IA, RGBA, YUV, Guest, result_name
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

#: Arguments of a texture: image, format, size, width, height, sl, tl, sh, th, palette, then wrap,
#: mask and shift of s and of t, tmem, tile.
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
#: Further calls: arguments to words.
BY_HAND = TEXTURES | {
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
        """Both ways to load a texture."""
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
        """Palettes, and commands of a single word."""
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


def ask_call(guest: Guest, name: str, arguments: list[int], room: int = PAIRS) -> int:
    """Adds a call; returns the index of its answer: result, pairs, words."""
    return guest.ask("CALL", room, layout.load().constants[f"VECTOR_CALL_{name}"], *arguments,
                     numbers=2 + 2 * PAIRS)


def words_of(answer: list[int]) -> list[tuple[int, int]]:
    """The words that a call wrote."""
    assert result_name(answer[0]) == "DONE"
    halves = [half & 0xFFFFFFFF for half in answer[2:2 + 2 * answer[1]]]
    return list(zip(halves[::2], halves[1::2]))


def text(words: list[tuple[int, int]]) -> str:
    """Words as text, for messages."""
    return " ".join(f"{hi:08x}:{lo:08x}" for hi, lo in words)


def ask_by_hand() -> Guest:
    """Each of BY_HAND, then again with room for one pair less than it writes."""
    guest = Guest()
    for (name, *arguments), words in BY_HAND.items():
        for room in (PAIRS, len(words) // 2 - 1):
            ask_call(guest, name, arguments, room)
    return guest


def ask_calls(calls: Calls) -> Guest:
    """The calls one after the other."""
    guest = Guest()
    for name, arguments, _ in calls.made:
        ask_call(guest, name, arguments)
    return guest


@dataclass
class Modes:
    """Random calls that change modes: name, choice, the tools' words, which set all modes;
    ``first``: the words that set the initial modes."""

    guest: Guest
    first: tuple[int, int]
    made: list[tuple[str, object, list[tuple[int, int]]]]


def ask_modes() -> Modes:
    """Random calls, each of which sets only some modes; finally texture levels."""
    chosen, words = random.Random(12), List()
    words.texture_convert("filter")
    found = Modes(Guest(), words.words[0], [])
    for _ in range(4 * ROUNDS):
        name, method, codes = chosen.choice((
            ("CYCLE", words.cycle_type, CYCLES), ("DETAIL", words.texture_detail, DETAIL_CODES),
            ("PERSPECTIVE", words.texture_perspective, {False: 0, True: 1}),
            ("LOD", words.texture_lod, {False: 0, True: 1}),
            ("LUT", words.texture_lut, LUT_CODES), ("FILTER", words.texture_filter, FILTER_CODES),
            ("CONVERSION", words.texture_convert, CONVERSION_CODES)))
        choice = chosen.choice(list(codes))
        method(choice)
        found.made.append((name, choice, [words.words[-1]]))
        ask_call(found.guest, name, [int(codes[choice])])
    for level in range(8):
        texture = List()
        texture.texture(level, 7 - level)
        found.made.append(("TEXTURE", level, texture.words))
        ask_call(found.guest, "TEXTURE", [level, 7 - level])
    return found


@pytest.fixture(scope="module")
def asked() -> dict:
    """Random calls, calls that change modes, and the answers, from one boot."""
    calls = Calls(11)
    for _ in range(ROUNDS):
        calls.textures()
        calls.loads()
        calls.colours()
    changes = ask_modes()
    return {"calls": calls, "changes": changes} | {"answers": vector_guest.run_all({
        "by hand": ask_by_hand(), "calls": ask_calls(calls), "modes": changes.guest})}


def test_calls_write_the_manuals_words(asked) -> None:
    """Loads with their syncs, tiles, modes, colours: the words are those computed by hand. With
    room for one pair less nothing is written."""
    answers = asked["answers"]["by hand"]
    for n, (call, words) in enumerate(BY_HAND.items()):
        assert words_of(answers[2 * n]) == list(zip(words[::2], words[1::2])), (
            f"{call} writes {text(words_of(answers[2 * n]))}")
        code, count, *_ = answers[2 * n + 1]
        assert (result_name(code), count) == ("LIST_FULL", 0), call


def test_calls_and_tools_write_the_same_words(asked) -> None:
    """Random loads, tiles, constants; the calls set both upper bits of a first word."""
    for (name, arguments, words), answer in zip(asked["calls"].made, asked["answers"]["calls"],
                                                strict=True):
        found = words_of(answer)
        assert all(hi >> 30 == 3 for hi, _ in found), (name, text(found))
        assert [(hi & ANY, lo) for hi, lo in found] == words, (
            f"{name}{tuple(arguments)}: the call writes {text(found)}, the tools {text(words)}")


def test_calls_and_tools_set_the_same_modes(asked) -> None:
    """The calls set some modes, the tools all of them: the tools' word after a call changes
    nothing, so the modes' generation stays the same."""
    changes, guest = asked["changes"], Guest()
    guest.words(changes.first)
    guest.ask("GENERATIONS", 0, numbers=3)
    for (_, _, expected), answer in zip(changes.made, asked["answers"]["modes"], strict=True):
        for run in (words_of(answer), expected):
            guest.words(*run)
            guest.ask("GENERATIONS", 0, numbers=3)
    answers = guest.run()
    generations = [answer[2] for answer in answers[1::2]]
    assert all(result_name(answer[0]) == "DONE" for answer in answers[::2])
    for n, (name, choice, _) in enumerate(changes.made):
        assert generations[2 * n + 2] == generations[2 * n + 1], \
            f"call {n}, {name} {choice!r}: the tools' word changes the modes that it left"
    assert generations[-1] > len(changes.made) // 2  # most calls changed something
