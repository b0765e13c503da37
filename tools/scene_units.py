"""Texture engines in scene files: their display lists and DRAM.

Formats stand in c/scene/scene_file.h.
"""

import numpy as np

from .errors import UserError

#: The tables, with their columns: an engine's first list and how many; a list's first word and
#: how many; a word's halves.
COLUMNS = {"units": ("list", "lists"), "lists": ("word", "words"), "words": ("hi", "lo")}


def empty(table: str) -> np.ndarray:
    """A table without entries, int64."""
    return np.zeros((0, len(COLUMNS[table])), np.int64)


def words_of(scene, unit: int, number: int) -> list[list[int]]:
    """The words (hi, lo) of an engine's list ``number``."""
    first = int(scene.units[unit][0])
    word, words = (int(n) for n in scene.lists[first + number])
    return scene.words[word:word + words].tolist()


def lists_until(scene, unit: int, frame: int) -> list[list[int]]:
    """All words that an engine has been given when a frame is drawn on its own."""
    several = int(scene.units[unit][1]) > 1
    return words_of(scene, unit, 0) + (words_of(scene, unit, 1 + frame) if several else [])


def check(scene, name: str) -> None:
    """Refuses lists and words that are not there, and an odd DRAM."""
    for i, (first, count) in enumerate(scene.lists.tolist()):
        if not 0 <= first <= first + count <= len(scene.words):
            raise UserError(f"{name}: lists[{i}].words: {first} and {count} of {len(scene.words)}")
    for i, (first, count) in enumerate(scene.units.tolist()):
        if count not in (1, scene.frames + 1):
            raise UserError(f"{name}: units[{i}].lists: {count} is not 1 or {scene.frames + 1}")
        if not 0 <= first <= first + count <= len(scene.lists):
            raise UserError(f"{name}: units[{i}].lists: {first} and {count} of {len(scene.lists)}")
    if len(scene.dram) % 8:
        raise UserError(f"{name}: dram: {len(scene.dram)} bytes are not a multiple of 8")
