"""Random polygons of texture engines, each in a frame of its own: the guest's against the model's,
bit for bit. An engine's name begins what chooses others: TX_SEED, TX_COUNT; TX_CASE draws one."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from tools import model, run
from tools.scene_file import ONE, Scene

BOOT = 100  # polygons: what engines keep decoded fills memory
NAMES = ("x", "y", "s", "t", "shade", "w")


def first_wrong(expected: np.ndarray, found: np.ndarray) -> str:
    """The first pixel of two frames that differ."""
    y, x = np.argwhere(found != expected)[0]
    digits = 2 + 2 * expected.itemsize
    return f"pixel ({x}, {y}) is {found[y, x]:#0{digits}x}, not {expected[y, x]:#0{digits}x}"


def vertex_lines(vertices, raw=()) -> list[str]:
    """Vertices of 16.16; the fields ``raw`` as they are."""
    return ["  " + ", ".join(f"{name} {value}" if name in raw else f"{name} {value / ONE:.6f}"
                             for name, value in zip(NAMES, vertex)) for vertex in vertices]


@dataclass(frozen=True)
class Polygons:
    """An engine's polygons."""

    engine: str
    count: int  # where the environment asks for no other
    case: Callable[[int, int, str], Any]  # of a seed, a number, a format of pixels
    scene: Callable[[list, int, str], Scene]  # of cases, the seed, pixels
    lines: Callable[[Any], list[str]]  # all there is to know of a case
    boot: int = BOOT

    def asked(self, name: str) -> str | None:
        return os.environ.get(f"{self.engine}_{name}")

    @property
    def seed(self) -> int:
        return int(self.asked("SEED") or 1)

    def numbers(self, off: str | None) -> list[int]:
        """Of the cases to be drawn: without rules of lowering fewer, and other ones."""
        if alone := self.asked("CASE"):
            return [int(alone)]
        count = int(self.asked("COUNT") or self.count)
        return list(range(count) if off is None else range(count, count + count // 4))

    def explain(self, number: int, pixels: str, each, expected: np.ndarray,
                found: np.ndarray) -> str:
        """All that is needed to look for the cause."""
        height, width = expected.shape
        return "\n".join([
            f"seed {self.seed}, polygon {number}, {pixels}: {(found != expected).sum()} pixels of "
            f"{width}x{height}; {first_wrong(expected, found)}", *self.lines(each),
            f"  again: {self.engine}_SEED={self.seed} {self.engine}_CASE={number} "
            f".deps/venv/bin/python -m pytest tests/test_{self.engine.lower()}_polygons.py -k {pixels}"])

    def draw(self, pixels: str, off: str | None) -> tuple[set[str], set[str]]:
        """Compares all frames, many in a boot; the rules and the spans that drew them."""
        numbers = self.numbers(off)
        wrong, rules, spans = [], set(), set()
        for k in range(0, len(numbers), self.boot):
            cases = [self.case(self.seed, number, pixels) for number in numbers[k:k + self.boot]]
            made = self.scene(cases, self.seed, pixels)
            done = run.render(made, "a1200-fast", "addx", off)
            rules |= {rule for material in done.executed for rule in material["rules"]}
            spans |= set(run.total(done.figures)["spans"])
            for frame, (number, each, found) in enumerate(zip(numbers[k:], cases, done.frames)):
                expected = model.render(made, frame)
                if not np.array_equal(found, expected):
                    wrong.append(self.explain(number, pixels, each, expected, found))
        assert not wrong, f"{len(wrong)} of {len(numbers)} polygons are wrong; the first:\n{wrong[0]}"
        return rules, spans
