"""Random polygons of texture engines, each in its own frame: the guest's frames are compared with
the model's, bit for bit. Environment variables that begin with the engine's name choose others:
N64_SEED, N64_COUNT; N64_CASE draws one."""

import os
from dataclasses import dataclass
from types import ModuleType

from tests.helpers import guest_runs
from tmap.guest import guest_frames
from tmap.guest.guest_frames import first_wrong
from tmap.model import model
from tmap.run import run

MACHINE = "a1200-fast"


@dataclass(frozen=True)
class Polygons:
    """The random polygons of one engine."""

    engine: str
    count: int  # unless the environment sets another
    made: ModuleType  # of tmap.corpus: case, scene, lines, MOST

    def asked(self, name: str) -> str | None:
        return os.environ.get(f"{self.engine}_{name}")

    @property
    def seed(self) -> int:
        return int(self.asked("SEED") or 1)

    def first(self, pixels: str) -> list:
        """The cases drawn with all rules, at least 100: a sample of what a generator makes."""
        return [self.made.case(self.seed, number, pixels)
                for number in range(max(len(self.numbers(None)), 100))]

    def numbers(self, off: str | None) -> list[int]:
        """The numbers of the cases to draw. With rules of lowering off they are fewer, and other
        ones."""
        if alone := self.asked("CASE"):
            return [int(alone)]
        count = int(self.asked("COUNT") or self.count)
        return list(range(count) if off is None else range(count, count + count // 4))

    def explain(self, number: int, pixels: str, off: str | None) -> str:
        """Draws a polygon once more and describes the failure: seed, case, first wrong pixel and
        the command to draw it again."""
        each = self.made.case(self.seed, number, pixels)
        made = self.made.scene([each], self.seed, pixels)
        expected, found = model.render(made, 0), run.render(made, MACHINE, "addx", off, timed=False).frames[0]
        height, width = expected.shape
        count = int((found != expected).sum())
        first = first_wrong(expected, found) if count else "drawn once more it is right"
        return "\n".join([
            f"seed {self.seed}, polygon {number}, {pixels}: {count} pixels of {width}x{height}; "
            f"{first}", *self.made.lines(each),
            f"  again: {self.engine}_SEED={self.seed} {self.engine}_CASE={number} "
            f".deps/venv/bin/python -m pytest tests/{self.engine.lower()}/test_polygons.py -k {pixels}"])

    def check(self, pixels: str, off: str | None = None) -> tuple[set[str], set[str]]:
        """Asserts that all frames are the model's, all in a boot; returns the rules and the spans
        that drew them."""
        numbers = self.numbers(off)
        parts = [numbers[k:k + self.made.MOST] for k in range(0, len(numbers), self.made.MOST)]
        cases = [[self.made.case(self.seed, number, pixels) for number in some] for some in parts]
        asked = [guest_runs.Asked(self.made.scene(some, self.seed, pixels), off) for some in cases]
        drawn = guest_runs.draw(asked, MACHINE)
        wrong = [number for some, each, found in zip(parts, asked, drawn)
                 for frame, (number, digest) in enumerate(zip(some, found.digests, strict=True))
                 if not guest_frames.is_models(model.render(each.scene, frame), digest)]
        assert not wrong, (f"{len(wrong)} of {len(numbers)} polygons are wrong; the first:\n"
                           + self.explain(wrong[0], pixels, off))
        return set().union(*(d.rules for d in drawn)), set().union(*(d.spans for d in drawn))
