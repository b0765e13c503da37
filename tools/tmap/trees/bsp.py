"""Builds a binary space partition of faces: nodes that divide their space by the plane of a face.

Faces that can hide none of the others are drawn before them, faces that none can hide after them,
wherever the eye is: nothing divides them. One face cannot hide another that is in front of its
plane, nor if it is behind the other's plane, since faces seen from the back are not drawn. So a
convex body or the inside of a convex room is one node, and the floor of a house stays in one piece.

The others are divided: of the planes of the faces the one is taken that has the least of WEIGHT
times its splits and the difference of both sides, the first of equal ones; if there are many, some
spread over them are tried. A second tree is made with planes across an axis too, where a face begins
or ends: these part objects that stand beside each other, and the rings of turned bodies. That of fewer
faces is taken. A keep of 168 walls and 13 urns of 50 faces has no split so, and else 266; walls that
cross at any angle are split less by their own planes.

Which faces can hide which, and which plane is best, is decided in floating point: a height is then
off by less than 2^-20 of a unit, as part of what polygons.py leaves between ON and OFF. NumPy's sums
and products of single elements are the same on every machine.
"""

from dataclasses import dataclass, field

import numpy as np

from tmap.trees.polygons import FINE, NORMAL, ON, Corner, Edge, Plane, Polygon, sides, split

TRIED, TRIED_LEAST = 128, 16  # planes of a node, at most, and of a large one
FACES_TRIED = 1 << 16  # faces times planes
WEIGHT = 64  # of a split
TOGETHER = 8  # faces of a node that nothing divides, at most
HEIGHTS = 1 << 16  # of corners over planes, computed at a time
SCALE = 2.0 ** NORMAL
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

    def spans(self, axis: int) -> tuple[np.ndarray, np.ndarray]:
        """Returns the least and the greatest coordinate of each face."""
        along = (self.x, self.y, self.z)[axis]
        return np.minimum.reduceat(along, self.firsts), np.maximum.reduceat(along, self.firsts)

    def middles(self) -> np.ndarray:
        """Returns the middles of the faces' boxes, by axis."""
        return np.array([sum(self.spans(axis)) / 2 for axis in range(3)])

    def ends(self, planes: list[Plane]) -> tuple[np.ndarray, np.ndarray]:
        """Returns of each plane, by row, and each face whether all of it is in front of the plane, and whether all of it
        is behind it; what is on it is both."""
        front, back = (np.empty((len(planes), len(self.firsts)), bool) for _ in range(2))
        step = max(HEIGHTS // len(self.x), 1)
        for first in range(0, len(planes), step):
            a, b, c, d = np.array(planes[first:first + step], np.float64).T[:, :, None]
            heights = a / SCALE * self.x + b / SCALE * self.y + c / SCALE * self.z - d
            front[first:first + step] = np.minimum.reduceat(heights, self.firsts, axis=1) >= -ON
            back[first:first + step] = np.maximum.reduceat(heights, self.firsts, axis=1) <= ON
        return front, back


def hiding(faces: list[Polygon]) -> np.ndarray:
    """Returns which face, by row, must be drawn after which: it may hide that one from some eye that sees
    both, or is the later one in its plane."""
    count, heights = len(faces), Heights(faces)
    rows = {plane: row for row, plane in enumerate(dict.fromkeys(face.plane for face in faces))}
    in_front, behind = (ends[[rows[face.plane] for face in faces]] for ends in heights.ends([*rows]))
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


Rounds = list[list[Polygon]]


def sorted_out(faces: list[Polygon], is_root: bool) -> tuple[Rounds, list[Polygon], Rounds]:
    """Returns the faces that can be drawn before all others, the others, and those that can be drawn after all
    others. Faces of a round may be drawn in any order, rounds one after another."""
    if len(faces) > ORDERED and not is_root:
        return [], faces, []
    order = hiding(faces)
    first, last, left = [], [], np.ones(len(faces), bool)
    for table, rounds in ((order, first), (order.T, last)):
        counts = (table & left).sum(axis=1)
        while (free := np.flatnonzero(left & (counts == 0))).size:
            rounds.append([faces[k] for k in free])
            left[free] = False
            counts -= table[:, free].sum(axis=1)
    return first, [face for face, is_left in zip(faces, left) if is_left], last[::-1]


def gathered(rounds: Rounds) -> Rounds:
    """Returns the rounds, small ones joined with those that follow."""
    joined: Rounds = []
    for some in rounds:
        if joined and len(joined[-1]) + len(some) <= TOGETHER:
            joined[-1] = joined[-1] + some
        else:
            joined.append(some)
    return joined


def spread(node: Node, faces: list[Polygon]) -> Node:
    """Gives a node faces that may be drawn in any order, so that those of a node below it are near each other:
    what is outside the frame or hidden is then found for many of them at a time."""
    if len(faces) <= TOGETHER:
        node.faces = faces
        return node
    middles = Heights(faces).middles()
    axis = int(np.ptp(middles, axis=1).argmax())
    order = np.argsort(middles[axis], kind="stable").tolist()
    half = len(faces) >> 1
    plane = [0, 0, 0, int(middles[axis][order[half]])]
    plane[axis] = 1 << NORMAL
    node.plane = tuple(plane)
    node.back, node.front = (spread(Node([]), [faces[k] for k in sorted(some)])
                             for some in (order[:half], order[half:]))
    return node


def parted(node: Node, faces: list[Polygon], is_first: bool) -> Node:
    """Gives a node the faces of a round, and returns the node of what is drawn after them (``is_first``) or before."""
    rest, own = Node([]), None
    if len(faces) <= TOGETHER:
        node.faces = faces
    else:
        own = spread(Node([]), faces)
    node.front, node.back = (rest, own) if is_first else (own, rest)
    return rest


def score(front, back, on, count: int):
    """Returns how bad planes are that have these numbers of faces all in front of them, all behind them, and on
    them, which are in both."""
    return WEIGHT * (count - front - back + on) + abs(front - back)


def best_across(heights: Heights, axis: int) -> tuple[int, Plane] | None:
    """Returns score and plane of the best that is across an axis, where a face begins or ends; None if none has
    a face on either side that is clearly not on it, so that both sides are fewer faces."""
    lows, highs = heights.spans(axis)
    where, is_flat = np.unique(np.round(np.concatenate((lows, highs)))), highs - lows <= 2 * ON

    def above(lows: np.ndarray, height: int) -> np.ndarray:
        return len(lows) - np.searchsorted(np.sort(lows), where + height)

    def below(highs: np.ndarray, height: int) -> np.ndarray:
        return np.searchsorted(np.sort(highs), where + height, "right")

    front, back = above(lows, -ON), below(highs, ON)
    on = below(lows[is_flat], ON) - below(lows[is_flat], -ON)  # about: some of these are not flat enough
    some = np.flatnonzero((above(lows, 2 * ON) + above(lows[~is_flat], 0) > 0)
                          & (below(highs, -2 * ON) + below(highs[~is_flat], 0) > 0))
    if not some.size:
        return None
    scores = score(front[some], back[some], on[some], len(lows))
    best = int(scores.argmin())
    plane = [0, 0, 0, int(where[some[best]])]
    plane[axis] = 1 << NORMAL
    return int(scores[best]), tuple(plane)


def best_plane(faces: list[Polygon], is_across: bool) -> Plane:
    """Returns the plane that divides faces best. is_across: those across an axis are tried too."""
    planes = list(dict.fromkeys(face.plane for face in faces))
    most = max(TRIED_LEAST, min(TRIED, FACES_TRIED // len(faces)))
    tried = [planes[k * len(planes) // most] for k in range(most)] if len(planes) > most else planes
    heights = Heights(faces)
    front, back = heights.ends(tried)
    scores = score(front.sum(axis=1), back.sum(axis=1), (front & back).sum(axis=1), len(faces))
    found = [*zip(scores.tolist(), tried)]
    if is_across:
        found += [best for axis in range(3) if (best := best_across(heights, axis))]
    return min(found, key=lambda each: each[0])[1]


def divided(node: Node, faces: list[Polygon], cuts: dict[Edge, set[Corner]], is_root: bool, is_across: bool
            ) -> list[tuple[Node, list]]:
    """Makes a node of faces, and some below it; returns the children to be made, with their faces."""
    first, faces, last = sorted_out(faces, is_root)
    if not faces:
        *first, end = gathered(first + last) or [[]]
    for some in gathered(first):
        node = parted(node, some, True)
    if not faces:
        spread(node, end)
        return []
    for some in reversed(gathered(last)):
        node = parted(node, some, False)
    node.plane = best_plane(faces, is_across)
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


def made(faces: list[Polygon], most: int, is_across: bool) -> Tree | None:
    """Returns a tree of faces; None if splits made more faces than ``most``."""
    tree, root = Tree(), Node([])
    todo, count = [(root, faces)], len(faces)
    while todo:
        node, some = todo.pop()
        children = divided(node, some, tree.cuts, node is root, is_across)
        count += splits_of(some, children)
        if count > most:
            return None
        todo += children
    return in_rows(root, tree)


def build(faces: list[Polygon], most: int) -> Tree | None:
    """Returns the tree of faces; None if splits made more faces than ``most``."""
    trees = [tree for is_across in (False, True) if (tree := made(faces, most, is_across))]
    return min(trees, key=lambda tree: (sum(len(node.faces) for node in tree.nodes), len(tree.nodes)), default=None)


def splits_of(faces: list[Polygon], children: list[tuple[Node, list]]) -> int:
    """Returns how many faces a plane has split: those that are in both children."""
    return sum(len(some) for _, some in children) - len({id(face) for face in faces} & {
        id(face) for _, some in children for face in some}) >> 1
