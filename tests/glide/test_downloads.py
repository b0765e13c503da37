"""Maps downloaded to the emulated texture unit's memory and read back as colours, compared with a
copy of the memory in Python."""

import random
from typing import NamedTuple

import numpy as np
import pytest

from tests.glide.guest import LEVEL_NUMBERS, MASK, RESULTS, Guest, texture
from tmap.glide.words import (ASPECTS, LEVELS, level_bytes, level_size, memory_required, place,
                              texel_bytes)
from tmap.vectors.vector_text import xorshift

MEMORY = 1 << 18
FORMS = ("a8", "argb4444")  # one of each size; every bit of a texel shows in its colour
AROUND = 4  # longs read before and behind a map
SPLIT_ASPECTS = ("4x1", "1x1", "1x8")  # of maps that hold every other level
PARTS = 60  # number of maps of which one level or some rows are downloaded


class Map(NamedTuple):
    """The arguments of the calls."""

    start: int
    levels: str
    largest: int
    smallest: int
    aspect: str
    form: str

    def numbers(self) -> list[int]:
        """The arguments of glide_source, and of the downloads."""
        return [self.start, LEVEL_NUMBERS[self.levels],
                *texture(self.largest, self.smallest, self.aspect, self.form)]

    def places(self) -> dict[int, int]:
        return place(*self)

    def texels(self, level: int) -> int:
        columns, rows = level_size(self.aspect, level)
        return columns * rows


class Memory:
    """The expected content of the unit's memory, as the PC's bus sees it."""

    def __init__(self, seed: int) -> None:
        self.bytes = np.frombuffer(xorshift(seed, MEMORY // 4).astype("<u4").tobytes(),
                                   np.uint8).copy()

    def write(self, form: str, address: int, texels: np.ndarray) -> None:
        """Writes texels; ``texels`` has their bytes in the 68020's order."""
        if texel_bytes(form) == 2:
            texels = texels.reshape(-1, 2)[:, ::-1].ravel()
        self.bytes[address:address + len(texels)] = texels

    def total(self, form: str, address: int, count: int) -> int:
        """The checksum of the colours of texels."""
        if texel_bytes(form) == 1:
            colours = self.bytes[address:address + count].astype(np.uint32) * np.uint32(0x01010101)
        else:
            texels = self.bytes[address:address + 2 * count].view("<u2").astype(np.uint32)
            colours = sum((texels >> np.uint32(4 * n) & np.uint32(15)) << np.uint32(8 * n)
                          for n in range(4)) * np.uint32(17)
        weights = np.arange(1, 2 * count, 2, dtype=np.uint64)
        return int((colours.astype(np.uint64) * weights & np.uint64(MASK)).sum()) & MASK

    def longs(self, address: int, count: int) -> list[int]:
        """Big-endian longs; addresses wrap."""
        around = np.arange(address, address + 4 * count) % MEMORY
        return self.bytes[around].view(">u4").tolist()


def source(seed: int, texels: int, form: str) -> np.ndarray:
    """The bytes that a call reads."""
    size = texels * texel_bytes(form)
    return np.frombuffer(xorshift(seed, (size + 3) // 4).astype(">u4").tobytes(), np.uint8)[:size]


def whole_maps(choose: random.Random) -> list[Map]:
    """Maps from each size down to one texel, of each shape."""
    found = []
    for form in FORMS:
        for levels, parities in LEVELS.items():
            for aspect in ASPECTS if len(parities) == 2 else SPLIT_ASPECTS:
                for largest in range(9):
                    if largest == 8 and 0 not in parities:
                        continue
                    needed = memory_required(levels, largest, 8, aspect, form)
                    start = choose.choice((0, MEMORY - needed,
                                           8 * choose.randrange((MEMORY - needed) // 8)))
                    found.append(Map(start, levels, largest, 8, aspect, form))
    return found


class Replay:
    """Performs downloads on the guest and in Python: operations and expected answers."""

    def __init__(self, seed: int) -> None:
        self.guest, self.memory = Guest(), Memory(seed)
        self.guest.do("GLIDE_RESET", 4)
        self.guest.do("GLIDE_RANDOM", seed)
        self.expected: list[tuple[str, list[int]]] = []

    def call(self, name: str, *numbers: int) -> None:
        """Adds a call that must succeed."""
        self.guest.call(name, *numbers)
        self.expected.append((f"{name}{numbers}", []))

    def look(self, of: Map) -> None:
        """Reads the colours of all levels, and the memory around the map."""
        self.call("SOURCE", *of.numbers())
        for level, address in of.places().items():
            self.guest.one("SUM", level)
            self.expected.append((f"{of}: level {level}",
                                  [self.memory.total(of.form, address, of.texels(level))]))
        for address in (of.start - 4 * AROUND, of.start + memory_required(*of[1:])):
            address %= MEMORY
            self.guest.ask("GLIDE_BYTES_OF", address, AROUND, numbers=AROUND)
            self.expected.append((f"{of}: memory at {address}",
                                  self.memory.longs(address, AROUND)))

    def whole(self, of: Map, seed: int) -> None:
        """Downloads all levels; the unit stores those that it holds."""
        self.call("DOWNLOAD", *of.numbers(), seed)
        at, size = 0, texel_bytes(of.form)
        levels = range(of.largest, of.smallest + 1)
        texels = source(seed, sum(map(of.texels, levels)), of.form)
        for level in levels:
            end = at + of.texels(level) * size
            if level in of.places():
                self.memory.write(of.form, of.places()[level], texels[at:end])
            at = end

    def part(self, of: Map, level: int, rows: tuple[int, int] | None, seed: int) -> None:
        """Downloads a level, or some of its rows."""
        columns, height = level_size(of.aspect, level)
        first, last = rows or (0, height - 1)
        self.call("DOWNLOAD_ROWS" if rows else "DOWNLOAD_LEVEL", *of.numbers(), level,
                  *(rows or ()), seed)
        size = columns * texel_bytes(of.form)
        self.memory.write(of.form, of.places()[level] + first * size,
                          source(seed, (last + 1 - first) * columns, of.form))

    def check(self) -> None:
        for (what, numbers), answer in zip(self.expected, self.guest.run(), strict=True):
            if not numbers:
                assert RESULTS[answer[0]] == "DONE", (what, RESULTS[answer[0]])
                continue
            found = [value & MASK for value in answer]
            wrong = [n for n, number in enumerate(numbers) if found[n] != number]
            assert not wrong, (f"{what}: {len(wrong)} of {len(numbers)} longs are wrong; number "
                               f"{wrong[0]} is {found[wrong[0]]:08x}, not {numbers[wrong[0]]:08x}")


@pytest.fixture(scope="module")
def replay() -> Replay:
    choose, replay = random.Random(31), Replay(32)
    maps = whole_maps(choose)
    for of in maps:
        replay.whole(of, choose.getrandbits(32) | 1)
        replay.look(of)
    for _ in range(PARTS):
        of = choose.choice([of for of in maps if of.largest > 1])
        level = choose.choice(list(of.places()))
        height = level_size(of.aspect, level)[1]
        first = choose.randrange(height)
        rows = choose.choice((None, (first, choose.randrange(first, height))))
        replay.part(of, level, rows, choose.getrandbits(32) | 1)
        replay.look(of)
    for address in range(0, MEMORY, MEMORY // 8):
        replay.guest.ask("GLIDE_BYTES_OF", address, MEMORY // 32, numbers=MEMORY // 32)
        replay.expected.append((f"all memory from {address} on",
                                replay.memory.longs(address, MEMORY // 32)))
    return replay


def test_downloads_and_fetches(replay) -> None:
    """Each size, aspect ratio and kind of texel, whole maps and split ones; then parts of them."""
    replay.check()


@pytest.mark.parametrize(("shape", "size"), [
    (("both", 0, 8, "1x1", "rgb565"), 2 * 87_384),  # 65536 + 16384 + .. + 16 + 4 + 4 texels
    (("both", 8, 8, "1x1", "i8"), 8),  # 4 bytes after the start, as level 0 is 87380 bytes before
    (("both", 0, 0, "8x1", "i8"), 256 * 32),
    (("both", 5, 8, "8x1", "i8"), 24),  # 8 and three times 4 texels; level 5 is 8 by 1
    (("even", 6, 7, "1x1", "p8"), 16),
    (("odd", 6, 7, "1x1", "p8"), 8),
])
def test_memory_required_by_hand(shape: tuple, size: int) -> None:
    assert memory_required(*shape) == size
    assert level_bytes("8x1", "i8", 5) == 8 and level_bytes("1x8", "ai88", 8) == 8
