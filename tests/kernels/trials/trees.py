"""Trials of src68k/mesh/mesh_walk.s against tools/tmap/model/trees.py."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.mesh import ONE, UNIT, number
from tmap.bench.mesh import longs, table
from tmap.bench.trial import Trial, Write, anything, long_write
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.model import trees


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


def walk_trial(rng, count: int, title: str) -> Trial:
    """A tree in which some slots are empty, seen from anywhere; every fourth time from the origin."""
    memory, nodes = Memory(), tree(rng, count)
    slots = nodes[-1][6] + nodes[-1][7]
    eye = [0, 0, 0] if rng.integers(4) == 0 else [number(rng, (1 << 31) - 1) for _ in range(3)]
    size = layout.load().struct("mesh_face").size
    faces = memory.add(b"".join(longs([0] * (size // 4)) for _ in range(slots + 1)), name="faces")
    seen = rng.integers(0, 2, slots).tolist()
    places = [faces + size * int(k) if is_seen else 0 for k, is_seen in zip(rng.permutation(slots), seen)]
    slots_at = memory.add(b"".join(longs((place,)) for place in (*places, 0)), name="slots")
    memory.pointers += [slots_at + 4 * k for k, place in enumerate(places) if place]
    steps = memory.blank(8 * count, "steps")
    plan = memory.struct("walk_plan", {"root": table(memory, "scene_node", nodes), "slots": slots_at, "steps": steps,
                                       "view": table(memory, "scene_view", [[*[0] * 12, *eye, *[0] * 10]])})
    order = [places[slot] for slot in trees.walk(nodes, 0, eye) if places[slot]]
    writes = [anything(steps, 8 * count), *(long_write(slots_at + 4 * k, 0) for k, is_seen in enumerate(seen) if is_seen)]
    writes += [Write(a + 4, longs((b,)), pointer=True) for a, b in zip(order, order[1:])]
    case = Case("mesh_walk", memory, pointers={"a0": plan})
    if not order:
        return Trial(case, title, {"d0": 0}, writes=writes)
    return Trial(case, title, near_ends={"d0": order[0]}, writes=[*writes, long_write(order[-1] + 4, 0)])


def trials() -> list[Trial]:
    rng = np.random.default_rng(81)
    return [walk_trial(rng, count, f"{count} nodes, number {k}") for k, count in enumerate((1, 2, 3, 4, 9, 60) * 12)]
