"""Glide's texture units in scene files: their registers and memory, and checks for everything the
Amiga would refuse.

Formats are defined in c/scene/scene_file.h.
"""

from dataclasses import replace

import numpy as np

from tmap.base.errors import UserError
from tmap.glide.registers import NCC_REGISTERS, modes_of, ncc_of, words_of
from tmap.glide.state import (LOD_FRACTION, SUBDIVISIONS, VOODOO2_BITS, VOODOO_BITS, W_MAX, Unit,
                              unpacked)

UNITS = 2  # of a pipe at most
LEAST_BYTES = 8  # of a unit's memory
NO_TABLE = -1
PREFILTER_KB = 1024  # of prefiltered tiles, unless a pipe has another number
PALETTE_BYTES, NCC_BYTES = 256 * 4, 2 * NCC_REGISTERS * 4
RESERVED_MODE = 1 << 31  # without meaning here

#: Columns of the tables. A unit: registers, offset and bytes of its memory, offsets of its palette
#: and NCC tables, three settings. A pipe: first unit, number of units, which of them has separate
#: coordinates (2, or 0: none), bytes that prefiltered tiles may take, whether it adds to the frame.
COLUMNS = {"glide_units": ("mode", "lod", "detail", "base", "memory", "bytes", "palette", "ncc",
                           "fraction_bits", "dithered", "subdivision"),
           "pipes": ("glide", "glide_units", "own", "prefilter", "adds")}


def empty(table: str) -> np.ndarray:
    """Returns a table without entries, int64."""
    return np.zeros((0, len(COLUMNS[table])), np.int64)


def longs(scene, at: int, count: int) -> np.ndarray:
    """Returns big-endian longs of the texture memory."""
    return np.frombuffer(scene.glide_memory, ">u4", count, at).astype(np.int64)


def unit_of(scene, number: int) -> Unit:
    """Returns the model of a unit."""
    *words, memory, size, palette, ncc, bits, dithered, pixels = scene.glide_units[number].tolist()
    unit = Unit(replace(modes_of(*words, bits), dithered=dithered, subdivision=pixels),
                np.frombuffer(scene.glide_memory, np.uint8, size, memory))
    if palette != NO_TABLE:
        unit.palette = unpacked(longs(scene, palette, 256))[:, :3]
    if ncc != NO_TABLE:
        unit.ncc = [ncc_of(words) for words in
                    longs(scene, ncc, 2 * NCC_REGISTERS).reshape(2, NCC_REGISTERS)]
    return unit


def units_of(scene, pipe: int) -> list[Unit]:
    """Returns the models of a pipe's units, the one nearest the frame first."""
    first, count, *_ = scene.pipes[pipe].tolist()
    return [unit_of(scene, first + n) for n in range(count)]


def has_own(scene, material) -> bool:
    """Returns True if the second half of an object's vertices has its second unit's coordinates."""
    return material.mapper == "glide" and bool(scene.pipes[material.unit][2])


def check_own(corners: np.ndarray, name: str, where: str) -> None:
    """Refuses an object's vertices, rows of the table, that are not twice as many as its corners,
    or that have a depth by which the second unit cannot divide."""
    if len(corners) < 6 or len(corners) % 2:
        raise UserError(f"{name}: {where}.vertices: {len(corners)} are not twice as many as a "
                        "polygon has corners")
    for w in corners[len(corners) // 2:, 5].tolist():
        if not 0 < abs(w) <= W_MAX << 16:
            raise UserError(f"{name}: {where}: w: {w} is 0 or more than {W_MAX << 16} away from it")


def check_unit(row: list[int], size: int, name: str, where: str) -> None:
    """Refuses registers without meaning and memory that does not exist; ``size``: bytes of all
    memory."""
    *words, memory, count, palette, ncc, bits, dithered, pixels = row
    for column, word in zip(COLUMNS["glide_units"], words):
        if not 0 <= word < 1 << 32:
            raise UserError(f"{name}: {where}.{column}: {word} is no register")
    if count < LEAST_BYTES or count & count - 1:
        raise UserError(f"{name}: {where}.bytes: {count} is not a power of two of at least "
                        f"{LEAST_BYTES}")
    for column, at, least, needed in (("memory", memory, 0, count),
                                      ("palette", palette, NO_TABLE, PALETTE_BYTES),
                                      ("ncc", ncc, NO_TABLE, NCC_BYTES)):
        if at == least == NO_TABLE:
            continue
        if not 0 <= at <= size - needed or at % 4:
            raise UserError(f"{name}: {where}.{column}: {at} of {size} bytes")
    if bits not in (VOODOO_BITS, VOODOO2_BITS):
        raise UserError(f"{name}: {where}.fraction_bits: {bits} is neither 4 nor 8")
    if dithered not in (0, 1):
        raise UserError(f"{name}: {where}.dithered: {dithered} is neither 0 nor 1")
    if pixels not in SUBDIVISIONS:
        raise UserError(f"{name}: {where}.subdivision: {pixels} is none of 0, 8 and 16")
    try:
        modes = modes_of(*words, bits)
    except UserError as error:
        raise UserError(f"{name}: {where}.mode: {error}") from error
    if max(modes.rgb.mselect, modes.alpha.mselect) > LOD_FRACTION:
        raise UserError(f"{name}: {where}.mode: there is no such factor")
    if words_of(modes) != (words[0] & ~RESERVED_MODE, *words[1:]):
        raise UserError(f"{name}: {where}.mode, lod, detail or base: bits that mean nothing")


def check(scene, name: str) -> None:
    """Refuses invalid units and pipes."""
    if len(scene.glide_memory) % 8:
        raise UserError(f"{name}: glide_memory: {len(scene.glide_memory)} bytes are not a multiple "
                        "of 8")
    for i, row in enumerate(scene.glide_units.tolist()):
        check_unit(row, len(scene.glide_memory), name, f"glide_units[{i}]")
    for i, (first, count, own, prefilter, adds) in enumerate(scene.pipes.tolist()):
        if not (1 <= count <= UNITS and 0 <= first <= len(scene.glide_units) - count):
            raise UserError(f"{name}: pipes[{i}].glide_units: {first} and {count} of {len(scene.glide_units)}")
        if own and (own, count) != (2, 2):
            raise UserError(f"{name}: pipes[{i}].own: {own} is no hint for {count} units")
        if not 0 <= prefilter < 1 << 32:
            raise UserError(f"{name}: pipes[{i}].prefilter: {prefilter} bytes")
        if adds not in (0, 1):
            raise UserError(f"{name}: pipes[{i}].adds: {adds} is neither 0 nor 1")
