"""Trials of src68k/mesh/mesh_walk.s against tools/tmap/model/trees.py."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.mesh import ONE, UNIT, number
from tmap.bench.mesh import walk_trial
from tmap.bench.trial import Trial


def tree(rng, count: int) -> list[list[int]]:
    """The nodes of a tree of any form and planes. Some planes go through the origin."""
    sizes, nodes, slot = [count], [], 0
    while sizes:
        left = sizes.pop() - 1
        front = int(rng.choice((0, left, rng.integers(0, left + 1))))
        slots = int(rng.integers(0, 4))
        distance = int(rng.choice((0, number(rng, 12000 * ONE))))
        nodes.append([*(number(rng, UNIT) for _ in range(3)), distance, front, left - front, slot, slots])
        sizes += [part for part in (left - front, front) if part]
        slot += slots
    return nodes


def trials() -> list[Trial]:
    """Some slots are empty; the eye is anywhere, every fourth time in the origin."""
    rng, made = np.random.default_rng(81), []
    for k, count in enumerate((1, 2, 3, 4, 9, 60) * 12):
        nodes = tree(rng, count)
        slots = nodes[-1][6] + nodes[-1][7]
        seen = [int(face) if rng.integers(2) else None for face in rng.permutation(slots)]
        eye = [0, 0, 0] if rng.integers(4) == 0 else [number(rng, (1 << 31) - 1) for _ in range(3)]
        made.append(walk_trial(Memory(), nodes, seen, eye, f"{count} nodes, number {k}"))
    return made
