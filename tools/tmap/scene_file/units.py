"""Texture engines in scene files: their display lists and DRAM, and checks for everything the Amiga
would refuse.

Formats are defined in c/scene/scene_file.h.
"""

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import ONE
from tmap.n64.commands import replay
from tmap.n64.state import REACH, State

#: Kinds of the objects of an engine's material: enum unit_primitive.
PRIMITIVES = ("polygons", "coloured", "rectangles", "flipped")
RECTANGLES = PRIMITIVES[2:]

#: Columns of the tables. An engine: first list, number of lists. A list: first word, number of
#: words. A word: its halves.
COLUMNS = {"units": ("list", "lists"), "lists": ("word", "words"), "words": ("hi", "lo")}


def empty(table: str) -> np.ndarray:
    """Returns a table without entries, int64."""
    return np.zeros((0, len(COLUMNS[table])), np.int64)


def words_of(scene, unit: int, number: int) -> list[list[int]]:
    """Returns the words (hi, lo) of an engine's list ``number``."""
    first = int(scene.units[unit][0])
    word, words = (int(n) for n in scene.lists[first + number])
    return scene.words[word:word + words].tolist()


def lists_until(scene, unit: int, frame: int) -> list[list[int]]:
    """Returns all words that an engine has received when a frame is drawn alone."""
    several = int(scene.units[unit][1]) > 1
    return words_of(scene, unit, 0) + (words_of(scene, unit, 1 + frame) if several else [])


def state_at(scene, unit: int, frame: int) -> State:
    """Returns the model of an engine's state when a frame is drawn."""
    state = State(np.frombuffer(scene.dram, np.uint8))
    replay(state, lists_until(scene, unit, frame))
    return state


def check_range(vertices: list[tuple], where: str) -> None:
    """Refuses vertices whose s and t an engine cannot draw."""
    for noun, column in (("s", 2), ("t", 3)):
        values = [vertex[column] for vertex in vertices]
        if not -REACH << 16 <= min(values) <= max(values) < REACH << 16:
            raise UserError(f"{where}: {noun} is not from -{REACH:,} to {REACH - 1 / 32:,.2f} "
                            "texels")
        if max(values) - min(values) >= REACH << 16:
            raise UserError(f"{where}: {noun} of two vertices are {REACH:,} texels or more apart")


def rectangle_ends(box: tuple[int, int, int, int], starts: tuple[int, int],
                   steps: tuple[int, int], copies: bool, flip: bool) -> list[tuple]:
    """Returns a rectangle's first corner (tmap.n64.polygon.rectangle) and the corner after its last
    pixel, as vertices with s and t in 16.16."""
    width, height = box[2] - box[0], box[3] - box[1]
    ways = (height, width) if flip else (width + 3 >> 2 if copies else width, height)
    ends = [start * 2048 + step * 64 * way for start, step, way in zip(starts, steps, ways)]
    return [(*box[:2], *(start * 2048 for start in starts)), (*box[2:], *ends)]


def check_rectangle(vertices: np.ndarray, poses: np.ndarray, name: str, where: str) -> None:
    """Refuses a rectangle's vertices and poses, rows of the scene's tables, that are not in whole
    pixels, s10.5 and s5.10, or that turn it."""
    for noun, column in (("x", 0), ("y", 1)):
        if (vertices[:, column] & 0xFFFF).any():
            raise UserError(f"{name}: {where}: {noun} of a rectangle is not in whole pixels")
    for noun, column in (("s", 2), ("t", 3)):
        for value in vertices[:, column].tolist():
            if not -1 << 15 <= value < 1 << 15:
                raise UserError(f"{name}: {where}: {noun}: {value} does not fit 16 bits")
    if (poses[:, :4] != (ONE, 0, 0, ONE)).any():
        raise UserError(f"{name}: {where}: a rectangle cannot be turned or scaled")
    if (poses[:, 4:] & 0xFFFF).any():
        raise UserError(f"{name}: {where}: a rectangle moves by whole pixels")


def check(scene, name: str) -> None:
    """Refuses lists and words that do not exist, and a DRAM that is no multiple of 8 bytes."""
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
