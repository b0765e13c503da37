"""Trials of the texture engine's passes against tools/tmap/bench/examples/n64.py."""

from collections.abc import Callable

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.base.paths import ROOT
from tmap.bench import n64
from tmap.bench.examples import n64 as n64_examples
from tmap.bench.trial import Trial
from tmap.build import contracts

COUNTS = (1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 33, 100)
ROUNDS = 4
WITH_TABLE = ("n64_divide", "n64_lod", "n64_reciprocals")  # of 128 KB, in each call: fewer rounds
IN_C = [f"{name}_c" for name in n64_examples.IN_C_ALONE]
NAMES = [*n64.names(n64_examples), *IN_C]


def in_place() -> set[str]:
    """Returns the passes whose contracts say that input and output may be the same memory."""
    return {each.name for each in contracts.kernels(ROOT / "src68k") for argument in each.inputs
            if argument.register == "a1" and "the same memory" in argument.meaning}


def trials_of(names: list[str], rounds: Callable[[str], int], examples) -> list[Trial]:
    """Calls on random input, as often with each count as ``rounds`` says of a name; in place in turn."""
    same = in_place()
    return [n64.pass_trial(name, np.random.default_rng(seed), count, Memory(seed), Memory(seed + 1),
                           f"{count} pixels, seed {seed}", examples,
                           bool(k & 1) and examples.FORMS.get(name, name) in same)
            for n, name in enumerate(names) for k, count in enumerate(COUNTS * rounds(name))
            for seed in [1000 * k + n]]


def trials() -> list[Trial]:
    return trials_of(NAMES, lambda name: 2 if name.startswith(WITH_TABLE) else ROUNDS, n64_examples)
