"""The order in which a tree's faces are drawn: the model of src68k/mesh/mesh_walk.s."""

from collections.abc import Iterator

from tmap.base.fixed import signed

NORMAL = 30  # fraction bits


def is_in_front(node: list[int], eye: list[int]) -> bool:
    """Returns true if the eye is in a node's plane or in front of it."""
    return signed(sum(n * e for n, e in zip(node[:3], eye)) >> NORMAL) >= node[3]


def walk(nodes: list[list[int]], root: int, eye: list[int]) -> Iterator[int]:
    """Yields a tree's slots, those of the farthest faces first: of each node those on the other side
    from the eye, its own, those on the eye's side."""
    todo = [(root, False)]  # nodes, and whether only their own slots are meant
    while todo:
        number, is_own = todo.pop()
        node = nodes[number]
        *_, front, back, slot, slots = node
        if is_own:
            yield from range(slot, slot + slots)
            continue
        parts = [number + 1] * bool(front), [number + 1 + front] * bool(back)
        near, far = parts if is_in_front(node, eye) else parts[::-1]
        todo += [*((each, False) for each in near), (number, True), *((each, False) for each in far)]
