"""Mutants of the integer model."""

from tests.mutants.changes import Mutant
from tests.mutants.judge import Verdict


def judge_model(mutant: Mutant) -> Verdict:
    """Tries a mutant of the model."""
    raise NotImplementedError
