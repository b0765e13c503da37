"""The guest's texture engines asked step by step."""

from tmap.vectors import vector_file


class Guest:
    """Operations and their answers: ``ask`` returns a number by which the answer is found
    after ``run``, one boot for all."""

    def __init__(self) -> None:
        self.operations = vector_file.Operations()
        self.lengths: list[int] = []
        self.answers: list[list[int]] = []

    def do(self, name: str, *values: int) -> None:
        """An operation without an answer."""
        self.operations.add(name, *values)

    def ask(self, name: str, *values: int, numbers: int) -> int:
        """An operation whose answer has so many numbers."""
        self.operations.add(name, *values)
        self.lengths.append(numbers)
        return len(self.lengths) - 1

    def run(self) -> list[list[int]]:
        """Asks; all answers in order."""
        return self.parts(vector_file.ask(self.operations).tolist())

    def parts(self, found: list[int]) -> list[list[int]]:
        """Notes all numbers of all answers."""
        assert len(found) == sum(self.lengths), (
            f"{sum(self.lengths)} numbers were asked for, {len(found)} came")
        at = 0
        for length in self.lengths:
            self.answers.append(found[at:at + length])
            at += length
        return self.answers


def run_all(guests: dict[str, Guest]) -> dict[str, list[list[int]]]:
    """Asks several in one boot, of whom each finds the engines as new; by the same names their
    answers."""
    found = vector_file.ask_all([guest.operations for guest in guests.values()])
    return {name: guest.parts(numbers.tolist())
            for (name, guest), numbers in zip(guests.items(), found, strict=True)}
