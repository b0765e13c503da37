"""Random polygons of texture engines, each in its own frame: the guest's frames are compared with
the model's, bit for bit. Environment variables that begin with the engine's name choose others:
N64_SEED, N64_COUNT; N64_CASE draws one."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.helpers.arrays import first_wrong
from tmap.model import model
from tmap.run import run
from tmap.scene_file.scene_file import ONE, Scene

MOST = 100  # polygons in a scene: engines keep decoded fills, which take memory
NAMES = ("x", "y", "s", "t", "shade", "w")


def vertex_lines(vertices, raw=()) -> list[str]:
    """Formats vertices of 16.16; the fields in ``raw`` are printed as integers."""
    return ["  " + ", ".join(f"{name} {value}" if name in raw else f"{name} {value / ONE:.6f}"
                             for name, value in zip(NAMES, vertex)) for vertex in vertices]


@dataclass(frozen=True)
class Polygons:
    """The random polygons of one engine."""

    engine: str
    count: int  # unless the environment sets another
    case: Callable[[int, int, str], Any]  # makes a case from a seed, a number, a format of pixels
    scene: Callable[[list, int, str], Scene]  # makes a scene from cases, the seed, pixels
    lines: Callable[[Any], list[str]]  # describes a case completely
    scene_size: int = MOST

    def asked(self, name: str) -> str | None:
        return os.environ.get(f"{self.engine}_{name}")

    @property
    def seed(self) -> int:
        return int(self.asked("SEED") or 1)

    def first(self, pixels: str) -> list:
        """The cases drawn with all rules, at least 100: a sample of what a generator makes."""
        return [self.case(self.seed, number, pixels)
                for number in range(max(len(self.numbers(None)), 100))]

    def numbers(self, off: str | None) -> list[int]:
        """The numbers of the cases to draw. With rules of lowering off they are fewer, and other
        ones."""
        if alone := self.asked("CASE"):
            return [int(alone)]
        count = int(self.asked("COUNT") or self.count)
        return list(range(count) if off is None else range(count, count + count // 4))

    def explain(self, number: int, pixels: str, each, expected: np.ndarray,
                found: np.ndarray) -> str:
        """Describes a failure: seed, case, first wrong pixel and the command to draw it again."""
        height, width = expected.shape
        count = int((found != expected).sum())
        first = first_wrong(expected, found) if count else "drawn once more it is right"
        return "\n".join([
            f"seed {self.seed}, polygon {number}, {pixels}: {count} pixels of {width}x{height}; "
            f"{first}", *self.lines(each),
            f"  again: {self.engine}_SEED={self.seed} {self.engine}_CASE={number} "
            f".deps/venv/bin/python -m pytest tests/{self.engine.lower()}/test_polygons.py -k {pixels}"])

    def check(self, pixels: str, off: str | None = None) -> tuple[set[str], set[str]]:
        """Asserts that all frames are the model's, many in a boot; returns the rules and the spans
        that drew them."""
        numbers = self.numbers(off)
        wrong, rules, spans = [], set(), set()
        for k in range(0, len(numbers), self.scene_size):
            some = numbers[k:k + self.scene_size]
            cases = [self.case(self.seed, number, pixels) for number in some]
            made = self.scene(cases, self.seed, pixels)
            done = run.render(made, "a1200-fast", "addx", off)
            rules |= {rule for material in done.executed for rule in material["rules"]}
            spans |= set(run.total(done.figures)["spans"])
            for frame, (number, each, found) in enumerate(zip(some, cases, done.frames, strict=True)):
                expected = model.render(made, frame)
                if not np.array_equal(found, expected):
                    wrong.append(self.explain(number, pixels, each, expected, found))
        assert not wrong, f"{len(wrong)} of {len(numbers)} polygons are wrong; the first:\n{wrong[0]}"
        return rules, spans
