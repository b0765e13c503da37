"""Sends operations to the guest's texture engines, step by step."""

from tmap.build import layout
from tmap.vectors import vector_file


class Guest:
    """Collects operations. ``ask`` returns an index under which the answer is found after ``run``,
    which takes one boot for all."""

    def __init__(self) -> None:
        self.operations = vector_file.Operations()
        self.lengths: list[int] = []
        self.answers: list[list[int]] = []

    def do(self, name: str, *values: int) -> None:
        """Adds an operation without an answer."""
        self.operations.add(name, *values)

    def ask(self, name: str, *values: int, numbers: int) -> int:
        """Adds an operation whose answer has ``numbers`` numbers; returns the answer's index."""
        self.operations.add(name, *values)
        self.lengths.append(numbers)
        return len(self.lengths) - 1

    def run(self) -> list[list[int]]:
        """Runs all operations; returns the answers in order."""
        return self.parts(vector_file.ask(self.operations).tolist())

    def parts(self, found: list[int]) -> list[list[int]]:
        """Splits the flat list of numbers into answers; stores and returns them."""
        assert len(found) == sum(self.lengths), (
            f"{sum(self.lengths)} numbers were asked for, {len(found)} came")
        at = 0
        for length in self.lengths:
            self.answers.append(found[at:at + length])
            at += length
        return self.answers


def run_all(guests: dict[str, Guest]) -> dict[str, list[list[int]]]:
    """Runs several guests in one boot, each starting with new engines; returns their answers by the
    same names."""
    found = vector_file.ask_all([guest.operations for guest in guests.values()])
    return {name: guest.parts(numbers.tolist())
            for (name, guest), numbers in zip(guests.items(), found, strict=True)}


def results(engine: str) -> list[str]:
    """The names of an engine's results, without its own, in the order of their numbers."""
    names = list(layout.load().constants)
    some = names[names.index(f"{engine}_DONE"):names.index(f"{engine}_RESULTS")]
    return [name.removeprefix(f"{engine}_") for name in some]
