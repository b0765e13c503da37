"""What a mutant is, and which of a file's mutants are chosen."""

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass


@dataclass(frozen=True)
class Mutant:
    """One line changed. ``within``: the routine, macro or function that has it, so that a mutant keeps its key when
    lines are added above; ``kind``: what was changed, of KINDS; ``before``, ``after``: the line without its
    comment, one blank for several; ``text``: the line as it is written into the file."""

    file: str
    line: int
    within: str
    kind: str
    before: str
    after: str
    text: str

    @property
    def key(self) -> tuple[str, str, str, str]:
        """What an explanation names: the same line twice in a routine has one."""
        return self.file, self.within, self.before, self.after

    def rank(self, seed: int) -> str:
        """Returns its place in a draw: of a line that does not change it depends on nothing else."""
        return hashlib.sha256(repr((seed, self.key, self.kind)).encode()).hexdigest()


#: The kinds of changes, in the order in which rooms take them in turn.
KINDS = ("condition", "carry", "constant", "size", "count", "sign", "operation", "removed", "offset")


def chosen(mutants: list[Mutant], seed: int) -> Iterator[Mutant]:
    """Yields mutants of each kind in turn, drawn by the seed."""
    by_key = {each.key: each for each in sorted(mutants, key=lambda each: (each.key, each.kind))}
    drawn = sorted(by_key.values(), key=lambda each: each.rank(seed))
    kinds = [[each for each in drawn if each.kind == kind] for kind in KINDS]
    for turn in range(max(map(len, kinds), default=0)):
        for some in kinds:
            if turn < len(some):
                yield some[turn]
