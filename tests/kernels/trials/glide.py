"""Trials of the passes for Glide's texture unit against tools/tmap/bench/examples/glide.py."""

from tests.kernels.trials.n64 import COUNTS, ROUNDS, pass_trial
from tmap.bench import glide
from tmap.bench.examples import glide as glide_examples
from tmap.bench.trial import Trial

IN_C = [f"{name}_c" for name in glide_examples.IN_C_ALONE]
MANY = "glide_combine_line"  # each function with each factor, for colour and for alpha
NAMES = [*glide.NAMES, *IN_C]


def rounds(name: str) -> int:
    """How often a pass is called with each count."""
    return 100 if name.startswith(MANY) else ROUNDS


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    return [pass_trial(name, count, 1000 * k + n, glide_examples)
            for n, name in enumerate(NAMES)
            for k, count in enumerate(COUNTS * rounds(name))]
