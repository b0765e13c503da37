"""Trees in scene files: checks for everything the Amiga would refuse."""

from tmap.base.errors import UserError, require
from tmap.build import layout

FRONT, BACK, SLOT, SLOTS = 4, 5, 6, 7  # columns of a node


def size_of(node: list[int]) -> int:
    """Returns the nodes of a part, by its first one."""
    return 1 + node[FRONT] + node[BACK]


def check_tree(nodes: list[list[int]], root: int, name: str) -> int:
    """Refuses a tree of which not every node and slot is used once; returns the number of its slots."""
    unit, slot = 1 << 30, 0
    end = root + size_of(nodes[root])
    for number in range(root, end):
        node, where = nodes[number], f"nodes[{number}]"
        left = end - number - 1
        require(name, f"{where}.front", node[FRONT], 0, left)
        require(name, f"{where}.back", node[BACK], 0, left - node[FRONT])
        for part, first in ((FRONT, number + 1), (BACK, number + 1 + node[FRONT])):
            if node[part] and size_of(nodes[first]) != node[part]:
                raise UserError(f"{name}: {where}: {node[part]} nodes, but nodes[{first}] begins "
                                f"{size_of(nodes[first])}")
        for axis, value in zip("xyz", node):
            require(name, f"{where}.{axis}", value, -unit, unit)
        require(name, f"{where}.slot", node[SLOT], slot, slot)
        slot += node[SLOTS]
        require(name, f"{where}.slots", slot, 0, layout.load().constants["SCENE_COUNT_MAX"])
    return slot


def check_tested(scene, number: int, where: str) -> None:
    """Refuses an instance whose pixels cannot be tested one by one."""
    instance = scene.instances[number]
    material = scene.materials[instance.material]
    if material.edges not in ("snapped", "exact") or material.mapper in ("n64", "glide") \
            or scene.pixel.bytes != 1:
        raise UserError(f"{where}: material {instance.material} and the frame's format do not go with z")
    before = scene.instances[number - 1] if number else None
    if before and before.before == instance.before and before.tree != instance.tree:
        raise UserError(f"{where}: those with z must be the first")


def check(scene, name: str) -> None:
    """Refuses trees, and instances that are not in theirs."""
    nodes, slots = scene.nodes.tolist(), scene.slots[:, 0].tolist()
    none = tree = layout.load().constants["NO_TREE"]
    ended = count = 0
    for i, instance in enumerate(scene.instances):
        where = f"instances[{i}]"
        if instance.tree == layout.load().constants["TREE_Z"]:
            check_tested(scene, i, f"{name}: {where}.tree")
            tree = none
            continue
        if instance.tree not in (none, tree):
            require(name, f"{where}.tree", instance.tree, ended, min(ended, len(nodes) - 1))
            require(name, f"nodes[{ended}].front", nodes[ended][FRONT], 0, len(nodes) - ended - 1)
            require(name, f"nodes[{ended}].back", nodes[ended][BACK], 0,
                    len(nodes) - ended - 1 - nodes[ended][FRONT])
            count = check_tree(nodes, ended, name)
            ended += size_of(nodes[ended])
        tree = instance.tree
        if tree != none:
            faces = scene.meshes[instance.mesh].faces
            require(name, f"{where}.slot", instance.slot, 0, len(slots) - faces)
            for k in range(instance.slot, instance.slot + faces):
                require(name, f"slots[{k}].slot", slots[k], 0, count - 1)
    require(name, "nodes", len(nodes), ended, ended)
