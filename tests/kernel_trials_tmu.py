"""Trials of the passes for Glide's texture unit against tools/tmu_examples.py."""

from kernel_checker import Trial
from kernel_trials_tx import COUNTS, ROUNDS, pass_trial
from tools import bench_tmu, tmu_examples

IN_C = [name for name in bench_tmu.NAMES if name.endswith("_c")] + [
    f"{name}_c" for name in tmu_examples.IN_C_ALONE]
MANY = "tmu_combine_line"  # each function with each factor, for colour and for alpha
NAMES = [name for name in bench_tmu.NAMES if not name.endswith("_c")] + IN_C


def rounds(name: str) -> int:
    """How often a pass is called with each count."""
    return 100 if name.startswith(MANY) else ROUNDS


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    return [pass_trial(name, count, 1000 * k + n, tmu_examples)
            for n, name in enumerate(NAMES)
            for k, count in enumerate(COUNTS * rounds(name))]
