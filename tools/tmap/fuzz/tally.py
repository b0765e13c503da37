"""What the fuzzer counts, and the faults that it finds."""

from collections import Counter
from dataclasses import dataclass, field

from tmap.ideal.bounds import Verdict
from tmap.setup.texturing import Settings


@dataclass
class Fault:
    """A failing polygon. ``kind``: differs, bound, refused or crash; ``machine``: the one that fails, "" for all."""

    kind: str
    text: str
    machine: str = ""


@dataclass
class Tally:
    """The counts of a run: polygons, drawn, refused, judged ones, pixels."""

    counts: Counter = field(default_factory=Counter)
    coverage_errors: Counter = field(default_factory=Counter)  # by edges; judged ones
    worst: dict[str, float] = field(default_factory=dict)  # error / bound by mapper
    failed: dict[int, Fault] = field(default_factory=dict)  # by number

    def add(self, settings: Settings, verdict: Verdict, is_refused: bool, is_judged: bool) -> None:
        """Counts a polygon of the mapper; ``is_judged``: against the ideal."""
        judged = is_judged and settings.clip == "scissor"
        self.counts.update(polygons=1, drawn=int(verdict.pixels > 0), refused=int(is_refused), judged=int(judged),
                           pixels=verdict.pixels)
        if judged:
            self.coverage_errors[settings.edges] += verdict.coverage_errors
        self.worst[settings.mapper] = max(self.worst.get(settings.mapper, 0), verdict.texel_ratio)

    def merge(self, other: "Tally") -> None:
        """Adds another part's counts."""
        self.counts.update(other.counts)
        self.coverage_errors.update(other.coverage_errors)
        for mapper, ratio in other.worst.items():
            self.worst[mapper] = max(self.worst.get(mapper, 0), ratio)
        self.failed |= other.failed

    def __str__(self) -> str:
        n = self.counts
        text = (f"{n['polygons']} polygons, {n['drawn']} of them with pixels, {n['pixels']} pixels, "
                f"{n['refused']} refused")
        if not self.worst:
            return text
        wrong = ", ".join(f"{edges} {count}" for edges, count in sorted(self.coverage_errors.items()))
        worst = ", ".join(f"{mapper} {ratio:.3f}" for mapper, ratio in sorted(self.worst.items()))
        return (f"{text}; {n['judged']} judged against the ideal: pixels of wrong coverage by edges: {wrong or '-'}; "
                f"worst error / bound: {worst or '-'}")
