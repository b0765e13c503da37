"""Random polygons of texture engines, each in a frame of its own: the guest's against the model's,
bit for bit. An engine's name begins what chooses others: TX_SEED, TX_COUNT; TX_CASE draws one."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import guest_runs
import numpy as np
from arrays import first_wrong
from guest_runs import Asked, Drawn

from tools import guest_frames, model, run
from tools.scene_file import ONE, Scene

MOST = 100  # polygons of a scene: what engines keep decoded fills memory
FEW = 3
NAMES = ("x", "y", "s", "t", "shade", "w")


def vertex_lines(vertices, raw=()) -> list[str]:
    """Vertices of 16.16; the fields ``raw`` as they are."""
    return ["  " + ", ".join(f"{name} {value}" if name in raw else f"{name} {value / ONE:.6f}"
                             for name, value in zip(NAMES, vertex)) for vertex in vertices]


@dataclass(frozen=True)
class Part:
    """Some polygons of a format of pixels in one scene, and what the guest made of it."""

    numbers: list[int]
    cases: list
    asked: Asked
    drawn: Drawn


@dataclass(frozen=True)
class Polygons:
    """An engine's polygons."""

    engine: str
    count: int  # where the environment asks for no other
    case: Callable[[int, int, str], Any]  # of a seed, a number, a format of pixels
    scene: Callable[[list, int, str], Scene]  # of cases, the seed, pixels
    lines: Callable[[Any], list[str]]  # all there is to know of a case
    scene_size: int = MOST

    def asked(self, name: str) -> str | None:
        return os.environ.get(f"{self.engine}_{name}")

    @property
    def seed(self) -> int:
        return int(self.asked("SEED") or 1)

    def first(self, pixels: str) -> list:
        """The cases that are drawn with all rules, 100 at least: what a generator makes."""
        return [self.case(self.seed, number, pixels)
                for number in range(max(len(self.numbers(None)), 100))]

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
        count = int((found != expected).sum())
        first = first_wrong(expected, found) if count else "drawn once more it is right"
        return "\n".join([
            f"seed {self.seed}, polygon {number}, {pixels}: {count} pixels of {width}x{height}; "
            f"{first}", *self.lines(each),
            f"  again: {self.engine}_SEED={self.seed} {self.engine}_CASE={number} "
            f".deps/venv/bin/python -m pytest tests/test_{self.engine.lower()}_polygons.py -k {pixels}"])

    def draw(self, kinds: list[tuple[str, str | None]]) -> dict[tuple[str, str | None], list[Part]]:
        """Polygons of several (pixels, rules that are off), all in one boot. What is counted takes
        twice as long besides: without rules, when every pixel takes its time, only FEW are."""
        made = []
        for pixels, off in kinds:
            numbers = self.numbers(off)
            for k in range(0, len(numbers), self.scene_size):
                made.append(self.ask(pixels, off, numbers[k:k + self.scene_size], off is None))
            if off:
                made.append(self.ask(pixels, off, numbers[:FEW], True))
        found = {kind: [] for kind in kinds}
        for (kind, *rest), drawn in zip(made, guest_runs.draw([asked for *_, asked in made])):
            found[kind].append(Part(*rest, drawn))
        return found

    def ask(self, pixels: str, off: str | None, numbers: list[int], counted: bool) -> tuple:
        """Pixels and rules, numbers, cases, what is asked of the guest."""
        cases = [self.case(self.seed, number, pixels) for number in numbers]
        asked = Asked(self.scene(cases, self.seed, pixels), off, counted=counted)
        return (pixels, off), numbers, cases, asked

    def check(self, parts: list[Part], pixels: str) -> tuple[set[str], set[str]]:
        """Compares all frames; the rules and the spans that drew them."""
        wrong, count = [], sum(len(part.numbers) for part in parts)
        for part in parts:
            for frame, digest in enumerate(part.drawn.digests):
                if not guest_frames.is_models(model.render(part.asked.scene, frame), digest):
                    wrong.append((part, frame))
        if wrong:
            part, frame = wrong[0]
            found = run.render(part.asked.scene, "a1200-fast", "addx", part.asked.off).frames[frame]
            raise AssertionError(
                f"{len(wrong)} of {count} polygons are wrong; the first:\n" + self.explain(
                    part.numbers[frame], pixels, part.cases[frame],
                    model.render(part.asked.scene, frame), found))
        counted = [part.drawn for part in parts if part.asked.counted]
        return (set().union(*(drawn.rules for drawn in counted)),
                set().union(*(drawn.spans for drawn in counted)))
