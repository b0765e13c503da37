"""The texture engine in C: named errors, syncs, generation counters; tested on the emulated
machine."""

import pytest
from tests.n64.guest import (BITS_16, BITS_32, BITS_4, BITS_8, CI, FULL_SYNC, I, IA, LOAD_SYNC,
                             PIPE_SYNC, RESULTS, RGBA, TILE_SYNC, YUV, Guest, edges, image, modes,
                             size, texture, tile)
from tests.helpers import vector_guest

AT = 0x1000  # of images
IMAGE = image(RGBA, BITS_16, 32, AT)
BLOCK = edges(0xF3, 7, 0, 0, 63, 512)
HALF = 256  # TMEM words
OUTSIDE = 0x100000 - 8  # the last word of the DRAM


def block(format: int, bits: int, texels: int, tmem: int = 0, at: int = AT) -> tuple:
    return (image(format, bits, 1, at), tile(7, format, bits, 0, tmem),
            edges(0xF3, 7, 0, 0, texels - 1, 0))


def rows(format: int, bits: int, columns: int, count: int, line: int, tmem: int = 0) -> tuple:
    """The words of a load tile from an image of as many columns."""
    return (image(format, bits, columns, AT), tile(7, format, bits, line, tmem),
            edges(0xF4, 7, 0, 0, columns - 1 << 2, count - 1 << 2))


def tlut(entries: int, tmem: int = HALF, bits: int = BITS_16, tile_bits: int = BITS_4,
         last_row: int = 0) -> tuple:
    return (image(RGBA, bits, 1, AT), tile(7, RGBA, tile_bits, 0, tmem),
            edges(0xF0, 7, 0, 0, entries - 1 << 2, last_row << 2))


def combine(rgb: tuple[int, int, int, int]) -> tuple[int, int]:
    """Set combine with the same colour codes in both cycles, alpha 0."""
    a, b, c, d = rgb
    return (0xFC << 24 | a << 20 | c << 15 | 7 << 12 | 7 << 9 | a << 5 | c,
            b << 28 | b << 24 | 7 << 21 | 7 << 18 | d << 15 | 7 << 12 | 7 << 9 | d << 6 | 7 << 3
            | 7)


#: Words of which the last is refused, and with which error; None if all are accepted.
LOADS = [
    ("UNKNOWN_COMMAND", ((0x10 << 24, 0),)),
    ("UNKNOWN_COMMAND", ((0xE3 << 24 | 1 << 8 | 31, 0),)),  # modes beyond the word
    (None, block(RGBA, BITS_16, 2048)),
    ("BLOCK_TOO_LARGE", block(RGBA, BITS_16, 2049)),
    ("BLOCK_TOO_LARGE", block(I, BITS_8, 2049)),
    ("LOAD_TOO_LARGE", block(RGBA, BITS_16, 2048, 1)),
    (None, block(RGBA, BITS_32, 1024)),
    ("LOAD_TOO_LARGE", block(RGBA, BITS_32, 1025)),
    (None, rows(IA, BITS_8, 64, 64, 8)),
    ("LOAD_TOO_LARGE", rows(IA, BITS_8, 64, 65, 8)),
    ("ILLEGAL_PAIR", block(RGBA, BITS_8, 64)),
    ("ILLEGAL_PAIR", block(I, BITS_32, 64)),
    ("ILLEGAL_PAIR", block(YUV, BITS_8, 64)),
    ("ILLEGAL_PAIR", block(5, BITS_16, 64)),
    ("ILLEGAL_PAIR", (image(RGBA, BITS_32, 1, AT), tile(7, RGBA, BITS_16), BLOCK)),
    (None, block(I, BITS_16, 64)),  # a view with another size
    ("IMAGE_MISALIGNED", block(RGBA, BITS_16, 64, at=AT + 4)),
    ("IMAGE_MISALIGNED", (image(RGBA, BITS_16, 1, AT + 2), tile(7, RGBA, BITS_4, 0, HALF),
                          edges(0xF0, 7, 0, 0, 60, 0))),
    ("IMAGE_4_BIT", block(CI, BITS_4, 64)),
    ("IMAGE_4_BIT", rows(I, BITS_4, 64, 2, 4)),
    (None, block(RGBA, BITS_16, 4, at=OUTSIDE)),
    ("OUTSIDE_DRAM", block(RGBA, BITS_16, 5, at=OUTSIDE)),
    ("OUTSIDE_DRAM", block(RGBA, BITS_16, 4, at=0xFFFFF8)),
    ("LOAD_BACKWARDS", (IMAGE, tile(7, RGBA, BITS_16), edges(0xF3, 7, 8, 0, 7, 0))),
    ("LOAD_BACKWARDS", (IMAGE, tile(7, RGBA, BITS_16, 8), edges(0xF4, 7, 0, 8, 60, 4))),
    (None, tlut(256)),
    (None, tlut(1, HALF + 255)),
    ("TLUT_ENTRIES", tlut(257)),
    ("TLUT_ENTRIES", tlut(2, HALF + 255)),
    ("TLUT_LOW", tlut(16, HALF - 1)),
    ("TLUT_ROWS", tlut(16, last_row=1)),
    ("TLUT_IMAGE", tlut(16, bits=BITS_32)),
    ("TLUT_TILE", tlut(16, tile_bits=BITS_8)),
    (None, block(CI, BITS_8, 2048)),
    ("INDEX_HIGH", block(CI, BITS_8, 8, HALF)),
    ("INDEX_HIGH", block(CI, BITS_8, 16, HALF - 1)),
    ("SPLIT_HIGH", block(RGBA, BITS_32, 4, HALF)),
    ("SPLIT_HIGH", block(YUV, BITS_16, 4, HALF)),
    (None, (combine((1, 15, 4, 7)),)),
    ("COMBINE_INPUT", (combine((7, 15, 4, 7)),)),
    ("COMBINE_INPUT", (combine((1, 6, 4, 7)),)),
    ("COMBINE_INPUT", (combine((1, 15, 6, 7)),)),
]
#: Errors that would hang the hardware or read beyond the DRAM: refused even without checks.
ALWAYS = {"IMAGE_4_BIT", "OUTSIDE_DRAM", "TLUT_ROWS", "TLUT_IMAGE"}


def ask_loads() -> Guest:
    """For each of LOADS: hash before, checked result and command, hash after; unchecked result and
    command."""
    guest = Guest()
    for _, words in LOADS:
        guest.do("RESET")
        guest.do("CHECKED", 1)
        guest.do("DRAM_RANDOM", 7)
        guest.words(*words[:-1])
        guest.ask("HASH", numbers=1)
        guest.words(*words)
        guest.ask("HASH", numbers=1)
        guest.do("CHECKED", 0)
        guest.words(*words)
    return guest


@pytest.mark.parametrize("number", range(len(LOADS)),
                         ids=[f"{n}-{name or 'done'}" for n, (name, _) in enumerate(LOADS)])
def test_commands_that_are_refused(number: int, answers) -> None:
    """The result names the error and the command, and nothing is changed; words just within limits
    are accepted."""
    name, words = LOADS[number]
    _, before, (code, place), after, (unchecked, _) = answers["loads"][5 * number:5 * number + 5]
    assert RESULTS[code] == (name or "DONE")
    assert place == len(words) - 1
    assert name is None or before == after
    assert RESULTS[unchecked] == (name if name in ALWAYS else "DONE")


#: Tiles for drawing: the error or None, modes, words.
DRAWN = [
    (None, {}, (tile(0, RGBA, BITS_16, 8), size(0, 32, 32))),
    ("ILLEGAL_PAIR", {}, (tile(0, RGBA, BITS_8, 8), size(0, 32, 32))),
    ("ILLEGAL_PAIR", {}, (tile(0, IA, BITS_32, 8), size(0, 32, 32))),
    ("TLUT_MODE", {}, (tile(0, CI, BITS_8, 4), size(0, 32, 32))),
    ("TLUT_MODE", {"tlut": 1}, (tile(0, I, BITS_8, 4), size(0, 32, 32))),
    (None, {"tlut": 1}, (tile(0, CI, BITS_8, 4), size(0, 32, 64))),
    ("INDEX_HIGH", {"tlut": 1}, (tile(0, CI, BITS_8, 4), size(0, 32, 65))),
    ("INDEX_HIGH", {"tlut": 1}, (tile(0, CI, BITS_4, 1, HALF), size(0, 16, 1))),
    (None, {}, (tile(0, RGBA, BITS_32, 8), size(0, 32, 32))),
    ("TILE_OUTSIDE", {}, (tile(0, RGBA, BITS_32, 8), size(0, 32, 33))),
    ("SPLIT_HIGH", {}, (tile(0, RGBA, BITS_32, 8, HALF), size(0, 4, 1))),
    ("SPLIT_HIGH", {}, (tile(0, YUV, BITS_16, 8, HALF), size(0, 4, 1))),
    ("TILE_OUTSIDE", {}, (tile(0, I, BITS_4, 2, 1), size(0, 32, 256))),
    (None, {}, (tile(0, I, BITS_4, 2), size(0, 32, 256))),
    ("TILE_TOO_LARGE", {}, (tile(0, I, BITS_4, 1), size(0, 16, 257))),
    (None, {}, (tile(0, I, BITS_4, 64, s=(0, 0, 10, 0)), size(0, 1, 1))),
    ("TILE_OUTSIDE", {}, (tile(0, I, BITS_4, 64, s=(0, 0, 10, 0), t=(0, 0, 4, 0)), size(0, 1, 1))),
    (None, {}, (tile(0, I, BITS_4, 64, s=(0, 0, 10, 0), t=(1, 0, 4, 0)), size(0, 1, 1))),
    ("TILE_EDGES", {}, (tile(0, I, BITS_8, 1), edges(0xF2, 0, 16, 0, 12, 12))),
    (None, {}, (tile(0, I, BITS_8, 1, s=(0, 0, 3, 0)), edges(0xF2, 0, 16, 0, 12, 12))),
    ("CYCLE_TYPE", {"cycle": 2}, (tile(0, RGBA, BITS_32, 8), size(0, 4, 4))),
    ("CYCLE_TYPE", {"cycle": 2}, (tile(0, I, BITS_8, 8), size(0, 4, 4))),
    (None, {"cycle": 2}, (tile(0, RGBA, BITS_16, 8), size(0, 4, 4))),
    ("CYCLE_TYPE", {"cycle": 3}, (tile(0, RGBA, BITS_16, 8), size(0, 4, 4))),
]


def ask_drawing() -> Guest:
    """For each of DRAWN: result of its words, of the check before drawing, of the same check
    unchecked."""
    guest = Guest()
    for _, fields, words in DRAWN:
        guest.do("RESET")
        guest.do("CHECKED", 1)
        guest.words(modes(**fields), *words)
        guest.ask("CHECK_DRAWING", numbers=1)
        guest.do("CHECKED", 0)
        guest.ask("CHECK_DRAWING", numbers=1)
    return guest


def test_tiles_that_cannot_be_drawn(answers) -> None:
    """The check before drawing names the error of the tile in use; unchecked it accepts all."""
    for n, (name, *case) in enumerate(DRAWN):
        (code, _), (checked,), (unchecked,) = answers["drawing"][3 * n:3 * n + 3]
        assert code == 0, (case, RESULTS[code])
        assert RESULTS[checked] == (name or "DONE"), case
        assert unchecked == 0, case


def ask_mipmap() -> Guest:
    """Without and with detail, makes each of the eight tiles invalid in turn: result of the words,
    of the check before drawing."""
    guest = Guest()
    for detail in (0, 1):
        for bad in range(8):
            guest.do("RESET")
            guest.do("CHECKED", 1)
            guest.words(modes(cycle=1, lod=1, detail=detail), texture(2, 6),
                        *(tile(n, RGBA, BITS_8 if n == bad else BITS_16, 1) for n in range(8)))
            guest.ask("CHECK_DRAWING", numbers=1)
    return guest


def test_all_tiles_of_a_mipmap_are_looked_at(answers) -> None:
    """Tiles from the first to the last level are checked, with detail one more, but not the
    next."""
    for detail in (0, 1):
        wrong = [n for n in range(8) if answers["mipmap"][16 * detail + 2 * n + 1] != [0]]
        assert wrong == sorted(n % 8 for n in range(6, 9 + detail)), f"detail {detail}"


#: Coordinates, 16.16, and 1 if they are out of range.
OUTSIDE_RANGE = {-1024 << 16: 0, (-1024 << 16) - 1: 1, (1024 << 16) - 1: 0, 1024 << 16: 1}


def ask_coordinates() -> Guest:
    """For each coordinate: the check's result for it as s and as t."""
    guest = Guest()
    guest.do("CHECKED", 1)
    for value in OUTSIDE_RANGE:
        guest.ask("CHECK_COORDINATES", value, 0, numbers=1)
        guest.ask("CHECK_COORDINATES", 0, value, numbers=1)
    return guest


def test_coordinates_out_of_range(answers) -> None:
    """The range is -1024.0 to 1023.96875 texels, for s and t alike."""
    wrong = RESULTS.index("COORDINATE_RANGE")
    assert answers["coordinates"] == [[wrong * outside] for outside in OUTSIDE_RANGE.values()
                                      for _ in "st"]


#: A load as the manual's macro writes it, with its syncs.
CALL = (IMAGE, tile(7, RGBA, BITS_16), LOAD_SYNC, BLOCK, PIPE_SYNC, tile(0, RGBA, BITS_16, 8),
        size(0, 32, 32))
#: Lists after a primitive that read tile 0 (and 1): result, number of the last command run or
#: refused.
AFTER_DRAWING = [
    ("DONE", len(CALL) - 1, CALL),
    ("NO_LOAD_SYNC", 2, CALL[:2] + CALL[3:]),
    ("NO_TILE_SYNC", 4, CALL[:4] + CALL[5:]),
    ("NO_LOAD_SYNC", 2, (TILE_SYNC, PIPE_SYNC, BLOCK)),
    ("NO_LOAD_SYNC", 1, (TILE_SYNC, edges(0xF4, 7, 0, 0, 60, 0))),
    ("NO_LOAD_SYNC", 1, (TILE_SYNC, edges(0xF0, 7, 0, 0, 60, 0))),
    ("NO_TILE_SYNC", 1, (LOAD_SYNC, edges(0xF4, 0, 0, 0, 60, 0))),
    ("NO_TILE_SYNC", 1, (LOAD_SYNC, size(0, 32, 32))),
    ("NO_TILE_SYNC", 0, (tile(1, RGBA, BITS_16),)),
    ("DONE", 0, (tile(2, RGBA, BITS_16),)),  # no primitive reads it
    ("DONE", 1, (TILE_SYNC, size(0, 32, 32))),
    ("NO_PIPE_SYNC", 2, (LOAD_SYNC, TILE_SYNC, modes())),
    ("NO_PIPE_SYNC", 0, ((0xE3 << 24 | 12 << 8 | 0, 1 << 19),)),
    ("NO_PIPE_SYNC", 0, (combine((1, 15, 4, 7)),)),
    ("NO_PIPE_SYNC", 0, ((0xEC << 24, 0),)),
    ("NO_PIPE_SYNC", 0, ((0xFB << 24, 0),)),
    ("DONE", 0, ((0xFA << 24, 0),)),
    ("DONE", 0, (IMAGE,)),
    ("DONE", 3, (PIPE_SYNC, modes(), combine((1, 15, 4, 7)), (0xEC << 24, 0))),
    ("DONE", 3, (FULL_SYNC, BLOCK, size(0, 32, 32), modes())),
]


def ask_syncs() -> Guest:
    """For each of AFTER_DRAWING: results and commands of the words before and of its own words:
    strict after drawing, not strict, strict before any drawing."""
    guest = Guest()
    for _, _, words in AFTER_DRAWING:
        for strict, drawn in ((1, 1), (0, 1), (1, 0)):
            guest.do("RESET")
            guest.do("STRICT", strict)
            guest.words(modes(cycle=1), combine((2, 1, 13, 1)), IMAGE, tile(7, RGBA, BITS_16))
            if drawn:
                guest.do("DRAWN")
            guest.words(*words)
    return guest


def test_missing_syncs(answers) -> None:
    """If strict, each missing sync is reported at its command; if not strict, or before any
    drawing, no sync is required."""
    for n, (name, place, words) in enumerate(AFTER_DRAWING):
        _, told, _, loose, _, early = answers["syncs"][6 * n:6 * n + 6]
        assert (RESULTS[told[0]], told[1]) == (name, place), words
        assert (RESULTS[loose[0]], loose[1]) == ("DONE", len(words) - 1), words
        assert (RESULTS[early[0]], early[1]) == ("DONE", len(words) - 1), words


#: Successive words, and how much each increases the generations of TMEM, tile 0 and modes.
GROWTH = [
    (tile(0, RGBA, BITS_16, 8), (0, 1, 0)), (tile(0, RGBA, BITS_16, 8), (0, 0, 0)),
    (size(0, 32, 32), (0, 1, 0)), (size(0, 32, 32), (0, 0, 0)),
    (tile(1, I, BITS_8), (0, 0, 0)), (modes(quad=1), (0, 0, 1)),
    (modes(quad=1), (0, 0, 0)), (texture(3, 1), (0, 0, 2)), (texture(3, 1), (0, 0, 0)),
    (combine((1, 15, 4, 7)), (0, 0, 1)), (combine((1, 15, 4, 7)), (0, 0, 0)),
    (IMAGE, (0, 0, 0)), (edges(0xF4, 0, 0, 0, 124, 124), (1, 0, 0)),
    (edges(0xF4, 0, 0, 0, 60, 0), (1, 1, 0)), ((0xEC << 24 | 1, 0), (0, 0, 1)),
    ((0xEC << 24 | 1, 0), (0, 0, 0)), (LOAD_SYNC, (0, 0, 0))]


def ask_generations() -> Guest:
    """Reads the generations before the first of GROWTH and after each."""
    guest = Guest()
    guest.do("RESET")
    guest.ask("GENERATIONS", 0, numbers=3)
    for words, _ in GROWTH:
        guest.do("WORDS", *words)
        guest.ask("GENERATIONS", 0, numbers=3)
    return guest


def test_generations(answers) -> None:
    """Generations grow with each real change, and not if words repeat the current state."""
    numbers = answers["generations"]
    for n, (words, grown) in enumerate(GROWTH):
        found = tuple(b - a for a, b in zip(numbers[n], numbers[n + 1]))
        assert found == grown, f"step {n}: {words[0]:08x} {words[1]:08x}"


def ask_texts() -> Guest:
    """The text of each result, and of the number after the last."""
    guest = Guest()
    for number in range(len(RESULTS) + 1):
        guest.ask("RESULT_TEXT", number, numbers=64)
    return guest


def test_every_result_has_its_text(answers) -> None:
    """Some texts are known; all differ, and none is too long."""
    known = {"DONE": "done", "TLUT_ROWS": "TLUT load over more than one row",
             "NO_PIPE_SYNC": "no pipe sync"}
    *texts, beyond = [bytes(answer).rstrip(b"\0").decode() for answer in answers["texts"]]
    assert len(RESULTS) == len(set(texts)) == len(texts) and beyond == "unknown result"
    assert all(0 < len(text) < 64 for text in texts)
    assert {name: texts[RESULTS.index(name)] for name in known} == known


@pytest.fixture(scope="module")
def answers() -> dict[str, list[list[int]]]:
    return vector_guest.run_all({
        "loads": ask_loads(), "drawing": ask_drawing(), "mipmap": ask_mipmap(),
        "coordinates": ask_coordinates(), "syncs": ask_syncs(), "generations": ask_generations(),
        "texts": ask_texts()})
