"""Trials of the texture engine's passes against tools/tmap/bench/examples/n64.py."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tmap.bench import n64
from tmap.bench.examples import n64 as n64_examples
from tmap.bench.trial import Trial, Write

COUNTS = (1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 33, 100)
ROUNDS = 4
WITH_TABLE = ("n64_divide", "n64_lod", "n64_reciprocals")  # of 128 KB, in each call: fewer rounds
IN_C = [f"{name}_c" for name in n64_examples.IN_C_ALONE]
NAMES = [*n64.NAMES, *IN_C]


def pass_trial(name: str, count: int, seed: int, examples=n64_examples) -> Trial:
    """One call on random input, its output between guards."""
    example, kernel = n64.example_of(examples, name, np.random.default_rng(seed), count)
    near, far = Memory(seed), Memory(seed + 1)
    case, written = n64.place(example, kernel, near, far)

    def where(offset: int, is_far: bool) -> str | None:
        for at, block in written.items():
            pixel, byte = divmod(offset - at, max(len(block) // count, 1))
            if is_far and 0 <= offset - at < len(block):
                return f"pixel {pixel}, byte {byte} of an output"
        return None

    return Trial(case, f"{count} pixels, seed {seed}",
                 writes=[Write(at, block, far=True) for at, block in written.items()],
                 where=where)


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    return [pass_trial(name, count, 1000 * k + n)
            for n, name in enumerate(NAMES)
            for k, count in enumerate(COUNTS * (2 if name.startswith(WITH_TABLE) else ROUNDS))]
