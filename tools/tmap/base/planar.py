"""Bitplanes: conversion between bits in memory and dots on the screen.

The leftmost of 8 dots is a byte's highest bit; a dot's lowest bit is in plane 0. A row of a plane
has a whole number of longwords, as struct planar_plan (c/screen/planar.h) requires.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tmap.base import maps


@dataclass(frozen=True)
class Planes:
    """The places of bitplanes in a block of memory, in bytes. ``numbers``: the planes in use;
    ``width`` (dots) and ``rows``: their size."""

    width: int
    rows: int
    row_pitch: int
    plane_pitch: int
    numbers: tuple[int, ...]

    @property
    def lines(self) -> np.ndarray:
        """Offsets of the rows from the first row of plane 0: [plane][row]."""
        return (np.array(self.numbers)[:, None] * self.plane_pitch
                + np.arange(self.rows) * self.row_pitch)

    @property
    def first(self) -> int:
        """The offset of plane 0's first row in the block; negative if plane 0 is not in use."""
        return -int(self.lines.min())

    @property
    def size(self) -> int:
        """Bytes of the block."""
        return self.first + int(self.lines.max()) + self.width // 8

    @property
    def offsets(self) -> np.ndarray:
        """The offsets of all bytes in the block: [plane][row][byte]."""
        return self.first + self.lines[..., None] + np.arange(self.width // 8)

    def encoded(self, dots: np.ndarray) -> np.ndarray:
        """Converts dots, uint8 [row][x], to the planes' bytes: [plane][row][byte]."""
        return np.packbits(dots >> np.array(self.numbers, np.uint8)[:, None, None] & 1, axis=2)

    def decoded(self, block: np.ndarray) -> np.ndarray:
        """Converts a block of memory to dots, uint8 [row][x]; planes that are not in use are 0."""
        bits = np.unpackbits(block[self.offsets], axis=2)
        return sum((bits[k] << number for k, number in enumerate(self.numbers)),
                   np.zeros((self.rows, self.width), np.uint8))


@dataclass(frozen=True)
class Form:
    """A format of frames: bytes and dots per pixel, the planes that a frame sets, and the function
    that converts pixels to dots, [row][x]."""

    bytes: int
    dots: int
    planes: tuple[int, ...]
    convert: Callable[[np.ndarray], np.ndarray]


#: The planes of HAM8 that select the colour that a dot changes, and their codes.
CONTROL = (0, 1)
BLUE, RED, GREEN = 1, 2, 3
#: The colours that the four dots of a pixel change, left to right.
ORDER = (RED, GREEN, BLUE, BLUE)
CHANNELS = {RED: 0, GREEN: 1, BLUE: 2}


def ham8_dots(colours: np.ndarray) -> np.ndarray:
    """Converts colours, uint8 [row][x][3 or more], to dots without control bits: [row][4 x]."""
    dots = colours[..., [CHANNELS[code] for code in ORDER]] & 0xFC
    return dots.reshape(len(colours), -1)


def ham8_control(width: int) -> np.ndarray:
    """Returns the control bits of a row of ``width`` dots."""
    return np.resize(np.array(ORDER, np.uint8), width)


def ham8_shown(dots: np.ndarray, background: tuple[int, int, int]) -> np.ndarray:
    """Returns the colours displayed for dots with control bits, none of them 0: uint8 [row][x][3].

    Each line begins with the background; a dot changes the upper six bits of one colour.
    """
    channels = np.array([CHANNELS.get(code, 0) for code in range(4)])
    now = np.tile(np.array(background, np.uint8), (len(dots), 1))
    shown = np.zeros((*dots.shape, 3), np.uint8)
    for x, column in enumerate(dots.T):
        channel = channels[column & 3]
        rows = np.arange(len(dots))
        now[rows, channel] = column & 0xFC | now[rows, channel] & 3
        shown[:, x] = now
    return shown


def halves(pixels: np.ndarray) -> np.ndarray:
    """Returns what the blitter merges by 2 to the planes of 8-bit pixels: half plane 4 b2 + 2 p1 + b0 has, at a dot with
    bit 1 = d1, the bit 4 b2 + 2 (1 - d1) + b0 of the pixel that is the dot with p1 as its bit 1."""
    x, found = np.arange(pixels.shape[1]), np.zeros_like(pixels)
    for b2, p1, b0 in np.ndindex(2, 2, 2):
        bits = pixels[:, x & ~2 | 2 * p1] >> (4 * b2 + 2 * (~x >> 1 & 1) + b0).astype(np.uint8)
        found |= (bits & 1) << np.uint8(4 * b2 + 2 * p1 + b0)
    return found


def fourths(pixels: np.ndarray) -> np.ndarray:
    """Returns what the blitter merges by 1 and by 2 to the planes of 8-bit pixels: quarter plane 4 b2 + 2 p1 + 1 - p0 has,
    at a dot with bits d1 d0, the bit 4 b2 + 2 (1 - d1) + 1 - d0 of the pixel that is the dot with p1 p0 as these bits."""
    x, found = np.arange(pixels.shape[1]), np.zeros_like(pixels)
    for b2, p1, p0 in np.ndindex(2, 2, 2):
        bits = pixels[:, x & ~3 | 2 * p1 | p0] >> (4 * b2 + 2 * (~x >> 1 & 1) + (~x & 1)).astype(np.uint8)
        found |= (bits & 1) << np.uint8(4 * b2 + 2 * p1 + 1 - p0)
    return found


def doubles(pixels: np.ndarray, merged: bool) -> np.ndarray:
    """Returns what the blitter doubles to the planes of pixels two dots wide: half plane b21 has, at the dot 2 p + d, the
    bit 2 b21 + 1 - d of pixel p. Not merged, it merges by 2 first: half plane 2 b2 + p0 has, at that dot, p's bit 0 = c, the
    bit 4 b2 + 2 (1 - c) + 1 - d of the pixel that is p with p0 as its bit 0."""
    x = np.arange(2 * pixels.shape[1])
    found = np.zeros((len(pixels), len(x)), np.uint8)
    for b2, k in np.ndindex(2, 2):
        b1 = k if merged else ~x >> 1 & 1
        bits = pixels[:, x >> 1 if merged else x >> 1 & ~1 | k] >> (4 * b2 + 2 * b1 + (~x & 1)).astype(np.uint8)
        found |= (bits & 1) << np.uint8(2 * b2 + k)
    return found


UPPER = (2, 3, 4, 5, 6, 7)
#: The frame format of each routine.
FORMS = {
    "c2p_8": Form(1, 1, (*CONTROL, *UPPER), lambda pixels: pixels),
    "c2p_8_2x1": Form(1, 2, (*CONTROL, *UPPER), lambda pixels: pixels.repeat(2, axis=1)),
    "c2p_8_blit": Form(1, 1, (*CONTROL, *UPPER), halves),
    "c2p_8_blits": Form(1, 1, (*CONTROL, *UPPER), fourths),
    "c2p_8_2x1_blit": Form(1, 2, (0, 1, 2, 3), lambda pixels: doubles(pixels, True)),
    "c2p_8_2x1_blits": Form(1, 2, (0, 1, 2, 3), lambda pixels: doubles(pixels, False)),
    "c2p_ham8_16": Form(2, 4, UPPER, lambda pixels: ham8_dots(maps.from_rgb565(pixels))),
    "c2p_ham8_5551": Form(2, 4, UPPER, lambda pixels: ham8_dots(maps.from_rgba5551(pixels))),
    "c2p_ham8_32": Form(4, 4, UPPER, lambda pixels: ham8_dots(maps.from_rgba8888(pixels)))}


def noise(name: str, rng, width: int, rows: int) -> np.ndarray:
    """Returns random pixels for a routine, big-endian: [row][x]."""
    size = FORMS[name].bytes
    return np.frombuffer(rng.bytes(rows * width * size), f">u{size}").reshape(rows, width)


def difference(expected: np.ndarray, found: np.ndarray) -> str | None:
    """Describes the first dot that differs; None if there is none."""
    wrong = np.argwhere(expected != found)
    if not len(wrong):
        return None
    y, x = wrong[0]
    return f"dot {x}, {y} is {found[y, x]:#04x}, expected {expected[y, x]:#04x}"
