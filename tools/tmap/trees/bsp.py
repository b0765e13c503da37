"""Builds a binary space partition of faces: nodes that divide their space by the plane of a face.

Faces that can hide none of the others are drawn before them, faces that none can hide after them,
wherever the eye is: nothing divides them. One face cannot hide another that is in front of its
plane, nor if it is behind the other's plane, since faces seen from the back are not drawn. So a
convex body or the inside of a convex room is one node, and the floor of a house stays in one piece.

The others are divided: of the planes of the faces the one is taken that has the least of WEIGHT
times its splits and the difference of both sides, the first of equal ones; if there are many, some
spread over them are tried.

Which faces can hide which, and which plane is best, is decided in floating point: a height is then
off by less than 2^-20 of a unit, as part of what polygons.py leaves between ON and OFF. NumPy's sums
and products of single elements are the same on every machine.
"""

from dataclasses import dataclass, field

import numpy as np

from tmap.trees.polygons import FINE, NORMAL, ON, Corner, Edge, Plane, Polygon, sides, split

TRIED, TRIED_LEAST = 128, 16  # planes of a node, at most, and of a large one
FACES_TRIED = 1 << 16  # faces times planes
WEIGHT = 16  # of a split
ORDERED = 1024  # faces of a part that are compared with each other, at most; of a whole tree all are


@dataclass
class Node:
    """Faces in their order, between the faces of ``back`` and those of ``front`` if the eye is in front of
    the plane, else the other way. Without a plane the eye is in front of it."""

    faces: list[Polygon]
    plane: Plane | None = None
    front: "Node | None" = None
    back: "Node | None" = None


@dataclass
class Tree:
    """The nodes, each before those of its front and these before those of its back; for each of them the
    numbers of nodes of front and back. ``cuts``: places where edges were cut."""

    nodes: list[Node] = field(default_factory=list)
    counts: list[tuple[int, int]] = field(default_factory=list)
    cuts: dict[Edge, set[Corner]] = field(default_factory=dict)


class Heights:
    """Heights of the corners of faces over planes, in units."""

    def __init__(self, faces: list[Polygon]) -> None:
        self.x, self.y, self.z = np.array([[float(c) for c in corner[:3]] for face in faces
                                           for corner in face.corners]).T / 2.0 ** FINE
        counts = [len(face.corners) for face in faces]
        self.firsts = np.cumsum([0, *counts[:-1]])

    def ends(self, plane: Plane) -> tuple[np.ndarray, np.ndarray]:
        """Returns of each face whether all of it is in front of a plane, and whether all of it is behind it;
        what is on it is both."""
        a, b, c = (n / 2.0 ** NORMAL for n in plane[:3])
        heights = a * self.x + b * self.y + c * self.z - plane[3]
        return np.minimum.reduceat(heights, self.firsts) >= -ON, np.maximum.reduceat(heights, self.firsts) <= ON


def hiding(faces: list[Polygon]) -> np.ndarray:
    """Returns which face, by row, must be drawn after which: it may hide that one from some eye that sees
    both, or is the later one in its plane."""
    count, heights = len(faces), Heights(faces)
    ends = {plane: heights.ends(plane) for plane in dict.fromkeys(face.plane for face in faces)}
    in_front = np.array([ends[face.plane][0] for face in faces])
    behind = np.array([ends[face.plane][1] for face in faces])
    single = np.array([not face.two_sided for face in faces])
    never = single[:, None] & in_front | single & behind.T
    numbers: dict[Plane, list[int]] = {}  # of the single faces, by plane
    for k in np.flatnonzero(single).tolist():
        numbers.setdefault(faces[k].plane, []).append(k)
    directions: dict[tuple, list[Plane]] = {}
    for plane in numbers:
        directions.setdefault(plane[:3], []).append(plane)
    for plane, some in numbers.items():  # no eye is in front of two planes that look away from each other
        for other in directions.get(tuple(-n for n in plane[:3]), []):
            if plane[3] + other[3] >= 0:
                never[np.ix_(some, numbers[other])] = True
    together = in_front & behind & in_front.T & behind.T
    later = together & np.tri(count, k=-1, dtype=bool) & never & never.T
    after = ~never | later
    np.fill_diagonal(after, False)
    return after


def sorted_out(faces: list[Polygon], is_root: bool) -> tuple[list[Polygon], list[Polygon], list[Polygon]]:
    """Returns the faces that can be drawn before all others, in order, the others, and those of them that
    can be drawn after all others, in order."""
    if len(faces) > ORDERED and not is_root:
        return [], faces, []
    after = hiding(faces)
    first, last, left = [], [], np.ones(len(faces), bool)
    for table, found in ((after, first), (after.T, last)):
        counts = (table & left).sum(axis=1)
        while (free := np.flatnonzero(left & (counts == 0))).size:
            chosen = int(free[0] if table is after else free[-1])
            found.append(faces[chosen])
            left[chosen] = False
            counts -= table[:, chosen]
    return first, [face for face, is_left in zip(faces, left) if is_left], last[::-1]


def best_plane(faces: list[Polygon]) -> Plane:
    """Returns the plane that divides faces best."""
    planes = list(dict.fromkeys(face.plane for face in faces))
    most = max(TRIED_LEAST, min(TRIED, FACES_TRIED // len(faces)))
    tried = [planes[k * len(planes) // most] for k in range(most)] if len(planes) > most else planes
    heights, scores = Heights(faces), []
    for number, plane in enumerate(tried):
        front, back = heights.ends(plane)
        balance = abs(int((front & ~back).sum()) - int((back & ~front).sum()))
        scores.append((WEIGHT * int((~front & ~back).sum()) + balance, number))
    return tried[min(scores)[1]]


def divided(node: Node, faces: list[Polygon], cuts: dict[Edge, set[Corner]], is_root: bool
            ) -> list[tuple[Node, list]]:
    """Makes a node of faces, and some below it; returns the children to be made, with their faces."""
    first, faces, last = sorted_out(faces, is_root)
    if not faces:
        node.faces = first + last
        return []
    if first:
        node.faces, node.front = first, Node([])
        node = node.front
    if last:
        node.faces, node.back = last, Node([])
        node = node.back
    node.plane = best_plane(faces)
    front: list[Polygon] = []
    back: list[Polygon] = []
    for face in faces:
        where = set() if face.plane == node.plane else set(sides(node.plane, face))
        if {1, -1} <= where:
            for part, to in zip(split(face, node.plane, cuts), (front, back)):
                to.append(part)
        else:
            (front if 1 in where else back if -1 in where else node.faces).append(face)
    node.front, node.back = Node([]) if front else None, Node([]) if back else None
    return [(child, some) for child, some in ((node.front, front), (node.back, back)) if child]


def in_rows(root: Node, tree: Tree) -> Tree:
    """Sets a tree's nodes and counts."""
    todo = [root]
    while todo:
        tree.nodes.append(todo.pop())
        todo += [child for child in (tree.nodes[-1].back, tree.nodes[-1].front) if child]
    sizes: dict[int, int] = {}
    for node in reversed(tree.nodes):
        front, back = (sizes[id(child)] if child else 0 for child in (node.front, node.back))
        sizes[id(node)] = 1 + front + back
        tree.counts.append((front, back))
    tree.counts.reverse()
    return tree


def build(faces: list[Polygon], most: int) -> Tree | None:
    """Returns the tree of faces; None if splits made more faces than ``most``."""
    tree, root = Tree(), Node([])
    todo, count = [(root, faces)], len(faces)
    while todo:
        node, some = todo.pop()
        made = divided(node, some, tree.cuts, node is root)
        count += splits_of(some, made)
        if count > most:
            return None
        todo += made
    return in_rows(root, tree)


def splits_of(faces: list[Polygon], children: list[tuple[Node, list]]) -> int:
    """Returns how many faces a plane has split: those that are in both children."""
    return sum(len(some) for _, some in children) - len({id(face) for face in faces} & {
        id(face) for _, some in children for face in some}) >> 1
