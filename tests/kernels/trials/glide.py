"""Trials of the passes for Glide's texture unit against tools/tmap/bench/examples/glide.py."""

from tests.kernels.trials.n64 import ROUNDS, trials_of
from tmap.bench.examples import glide as glide_examples
from tmap.bench.n64 import names
from tmap.bench.trial import Trial

IN_C = [f"{name}_c" for name in glide_examples.IN_C_ALONE]
MANY = "glide_combine_line"  # each function with each factor, for colour and for alpha
NAMES = [*names(glide_examples), *IN_C]
WITH_TABLE = ("glide_products", "glide_bilinear_times")  # of all products, in each call: one round


def trials() -> list[Trial]:
    return trials_of(NAMES, lambda name: 100 if name.startswith(MANY) else 1 if name.startswith(WITH_TABLE)
                     else ROUNDS, glide_examples)
