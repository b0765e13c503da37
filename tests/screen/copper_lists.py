"""Decodes what a copper list makes AGA show: registers, palette, and the dots of the planes it
names.

Written from the Hardware Reference Manual and its AGA supplement, for lists without skips and
without branches, whose waits divide them into regions from the top of the field down.
"""

from dataclasses import dataclass, field

import numpy as np

DIWSTRT, DIWSTOP, DDFSTRT, DDFSTOP, DMACON = 0x08E, 0x090, 0x092, 0x094, 0x096
BPL1PTH, BPLCON0, BPLCON1, BPLCON3 = 0x0E0, 0x100, 0x102, 0x106
BPL1MOD, BPL2MOD, COLOR00, DIWHIGH, FMODE = 0x108, 0x10A, 0x180, 0x1E4, 0x1FC
LOW_NIBBLES = 0x0200  # bit of BPLCON3
ROWS_TWICE = 0x4000  # bit of FMODE
#: Colour clocks of a move, and of a raster line.
MOVE, LINE = 4, 227
FIRST_DOT = 0x81, 0x38  # the beam position of the first dot, and the colour clock of its fetch


@dataclass
class Region:
    """The registers from one wait to the next, and the number of moves since the last wait."""

    line: int  # where the region begins
    moves: int
    registers: dict[int, int]
    palette: np.ndarray  # 256 x 3, 8 bits each


@dataclass
class Walker:
    """The copper: the values written so far."""

    registers: dict[int, int] = field(default_factory=dict)
    palette: np.ndarray = field(default_factory=lambda: np.zeros((256, 3), np.uint8))

    def move(self, register: int, value: int) -> None:
        """Writes a register; a colour is written to the bank in BPLCON3: both nibbles, or the lower
        one only."""
        if not COLOR00 <= register < COLOR00 + 64:
            self.registers[register] = value
            return
        control = self.registers[BPLCON3]
        number = (control >> 13) * 32 + (register - COLOR00) // 2
        nibbles = np.array([value >> 8 & 15, value >> 4 & 15, value & 15], np.uint8)
        if control & LOW_NIBBLES:
            self.palette[number] = self.palette[number] & 0xF0 | nibbles
        else:
            self.palette[number] = nibbles * 17


def regions(words: np.ndarray) -> list[Region]:
    """A list's regions, from line 0 on; the list ends with a wait that is never met."""
    walker, found, moves, line, wrapped = Walker(), [], 0, 0, 0
    pairs = words.reshape(-1, 2)
    ends = np.flatnonzero(pairs[:, 0] == 0xFFFF)  # most of the words are the memory behind the list
    assert len(ends), "the list has no end"
    for first, second in pairs[:ends[0] + 1].tolist():
        if not first & 1:
            walker.move(first, second)
            moves += 1
            continue
        assert second == 0xFFFE, f"a skip, or a wait by part of the beam's place: {first:04x} {second:04x}"
        if first == 0xFFDF:  # the last position in line 255 that a wait can name
            wrapped = 256
            continue
        found.append(Region(line, moves, dict(walker.registers), walker.palette.copy()))
        line, moves = wrapped + (first >> 8), 0
    return found


def signed(value: int) -> int:
    """A 16-bit word as a signed number."""
    return value - (value >> 15 << 16)


@dataclass
class Picture:
    """The dots inside a region's window, and its position: top and bottom line, left and right in
    DIWSTRT's units."""

    top: int
    bottom: int
    left: int
    right: int
    dots: np.ndarray  # uint8 [row][x]


def resolution(region: Region) -> int:
    """log2 of the dots in a pixel of low resolution."""
    control = region.registers[BPLCON0]
    return 1 if control & 0x8000 else 2 if control & 0x0040 else 0


def planes_of(region: Region) -> int:
    """The number of bitplanes."""
    control = region.registers[BPLCON0]
    return control >> 12 & 7 | (control & 0x10) >> 1


def picture(region: Region, memory: bytes, address: int) -> Picture:
    """The dots that the display fetches from ``memory``, which is at ``address``, 64 bits at a
    time."""
    r, shift = region.registers, resolution(region)
    assert r[FMODE] & 3 == 3 and r[BPLCON1] & 15 == r[BPLCON1] >> 4 & 15
    start, stop, high = r[DIWSTRT], r[DIWSTOP], r[DIWHIGH]
    top, bottom = start >> 8 | (high & 7) << 8, stop >> 8 | (high >> 8 & 7) << 8
    left, right = start & 255 | (high >> 5 & 1) << 8, stop & 255 | (high >> 13 & 1) << 8
    unit = 32 >> shift  # colour clocks from one fetch of a plane to the next
    assert (r[DDFSTRT] - FIRST_DOT[1]) % unit == 0
    assert (r[DDFSTOP] - r[DDFSTRT]) % unit == 0  # else it fetches up to the next multiple
    row_bytes = 8 * ((r[DDFSTOP] - r[DDFSTRT]) // unit + 1)
    delay = r[BPLCON1] & 15 | (r[BPLCON1] >> 10 & 3) << 4
    first = FIRST_DOT[0] + 2 * (r[DDFSTRT] - FIRST_DOT[1]) + delay
    assert delay < 64 >> shift
    from_dot, width = left - first << shift, right - left << shift
    assert 0 <= from_dot and from_dot + width <= 8 * row_bytes, "the window shows what is not fetched"
    pointers = [r[BPL1PTH + 4 * k] << 16 | r[BPL1PTH + 4 * k + 2] for k in range(planes_of(region))]
    assert all(p % 8 == 0 for p in pointers)
    dots = np.zeros((bottom - top, width), np.uint8)
    for line in range(top, bottom):
        for plane, at in enumerate(pointers):
            row = np.frombuffer(memory, np.uint8, row_bytes, at - address)
            dots[line - top] |= np.unpackbits(row)[from_dot:from_dot + width] << np.uint8(plane)
            second = (line ^ top) & 1 if r[FMODE] & ROWS_TWICE else plane & 1
            pointers[plane] += row_bytes + signed(r.get(BPL2MOD if second else BPL1MOD))
    return Picture(top, bottom, left, right, dots)
