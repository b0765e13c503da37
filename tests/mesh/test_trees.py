"""Trees of faces: along rays from any eye the face drawn last is the nearest, by exact fractions.

Where splits had to round, the order may be another within OFF of a dividing plane; that is counted.
"""

from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import pytest

from tmap.model import trees
from tmap.trees import bsp, polygons
from tmap.trees.polygons import OFF, Polygon

ONE = 1 << 16
MOST = 65536
RAYS = 60  # from each eye
EYES = 12


def cross(a, b):
    return tuple(a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3))


def dot(a, b):
    return sum(m * n for m, n in zip(a, b))


def less(a, b):
    return tuple(m - n for m, n in zip(a, b))


@dataclass
class Face:
    """A parallelogram or triangle, exactly plane, and the polygon that trees are built of."""

    corners: list[tuple[int, ...]]
    polygon: Polygon

    def hit(self, eye, target) -> Fraction | None:
        """How far along the ray its plane is met, 1 at the target; None: beside the face, on its edge or not
        before the eye."""
        normal = cross(less(self.corners[1], self.corners[0]), less(self.corners[2], self.corners[0]))
        way = dot(normal, less(target, eye))
        if not way:
            return None
        part = Fraction(dot(normal, less(self.corners[0], eye)), way)
        return part if part > 0 and is_inside(self.corners, normal, place(eye, target, part)) else None


def place(eye, target, part: Fraction):
    return tuple(e + part * (t - e) for e, t in zip(eye, target))


def is_inside(corners, normal, point) -> bool:
    """Whether a point is inside a convex polygon as seen along its normal; not on its edge."""
    axis = max(range(3), key=lambda k: abs(normal[k]))
    u, v = [k for k in range(3) if k != axis]
    turns = [(b[u] - a[u]) * (point[v] - a[v]) - (b[v] - a[v]) * (point[u] - a[u])
             for a, b in zip(corners, [*corners[1:], corners[0]])]
    return min(turns) > 0 or max(turns) < 0


def face(corners, number: int, two_sided: bool = False) -> Face:
    corners = [tuple(map(int, corner)) for corner in corners]
    values = [(0, 0, 0, 0, 0)] * len(corners)
    whole = [(*c, *v) for c, v in zip(corners, values)]
    return Face(corners, polygons.polygon_of(whole, polygons.plane_of(corners), number, two_sided))


def crossing(rng, count: int) -> list[Face]:
    """Parallelograms of any direction among each other, some seen from both sides."""
    made = []
    for k in range(count):
        at, u, v = rng.integers(-8 * ONE, 8 * ONE, (3, 3))
        made.append(face([at, at + u, at + u + v, at + v], k, rng.integers(4) == 0))
    return made


def slivers(rng, count: int) -> list[Face]:
    """Triangles of which most are some units high, beside large ones."""
    made = []
    for k in range(count):
        at, along = rng.integers(-8 * ONE, 8 * ONE, (2, 3))
        across = rng.integers(-40, 41, 3) if k % 3 else rng.integers(-8 * ONE, 8 * ONE, 3)
        made.append(face([at, at + along, at + along // 2 + across], k))
    return made


def grid(rng, count: int) -> list[Face]:
    """Rectangles on few planes, so that many are in one plane, touch or cover each other."""
    made = []
    for k in range(count):
        axis = int(rng.integers(3))
        at, u, v = np.zeros((3, 3), int)
        at[:] = rng.integers(-3, 4, 3) * 2 * ONE
        u[axis - 2], v[axis - 1] = rng.integers(1, 5, 2) * ONE
        made.append(face([at, at + u, at + u + v, at + v][::int(rng.choice((-1, 1)))], k))
    return made


def boxes(rng, count: int) -> list[Face]:
    """Closed boxes that run into each other, turned ones too."""
    made: list[Face] = []
    for _ in range(count // 6):
        at, ways = rng.integers(-6 * ONE, 6 * ONE, 3), np.diag(rng.integers(ONE // 8, 5 * ONE, 3))
        if rng.integers(2):
            a = rng.integers(1, 300, 3)
            ways = np.array([a, cross(a, (1, 2, 3)), cross(a, cross(a, (1, 2, 3)))], object)
            ways = np.array([[int(n) * 3 * ONE // max(map(abs, row)) for n in row] for row in ways.tolist()])
        for k in range(3):
            u, v, w = ways[k - 2], ways[k - 1], ways[k]
            for ring in ([at, at + v, at + u + v, at + u], [at + w, at + w + u, at + w + u + v, at + w + v]):
                made.append(face(ring, len(made)))
    return made


def rows_of(tree: bsp.Tree) -> tuple[list[list[int]], list[Polygon]]:
    """The nodes as in a scene file, and their faces by slot."""
    rows, faces = [], []
    for node, counts in zip(tree.nodes, tree.counts):
        rows.append([*(node.plane or (0, 0, 0, 0)), *counts, len(faces), len(node.faces)])
        faces += node.faces
    return rows, faces


def is_seen(polygon: Polygon, eye) -> bool:
    """As src68k/mesh/mesh_faces_wide.s takes it."""
    return polygon.two_sided or dot(polygon.plane[:3], eye) >> 30 > polygon.plane[3]


def is_near(a: Polygon, b: Polygon, first, second) -> bool:
    """Whether one of two faces' points on a ray is so near to the other's plane that rounding decides."""
    return any(abs(dot(polygon.plane[:3], point) / (1 << 30) - polygon.plane[3]) <= 2 * OFF
               for polygon, point in ((a, second), (b, first)))


@pytest.mark.parametrize("make, count", [(crossing, 14), (slivers, 40), (grid, 40), (boxes, 42)])
@pytest.mark.parametrize("seed", range(3))
def test_the_nearest_face_is_drawn_last(make, count: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    faces = make(rng, count)
    tree = bsp.build([each.polygon for each in faces], MOST)
    nodes, parts = rows_of(tree)
    stored = [[c[:3] for c in polygons.in_file(polygons.with_cuts(part, tree.cuts))] for part in parts]
    split = len(parts) > len(faces)
    assert split or make is not crossing
    hits = beside = unsure = 0
    for _ in range(EYES):
        eye = tuple(rng.integers(-9 * ONE, 9 * ONE, 3).tolist())
        order = list(trees.walk(nodes, 0, eye))
        assert sorted(order) == list(range(len(parts)))
        for _ in range(RAYS):
            corners = np.array(faces[rng.integers(len(faces))].corners)
            target = tuple((corners * rng.dirichlet(np.ones(len(corners)))[:, None]).sum(axis=0).astype(int).tolist())
            met = {k: part for k, each in enumerate(faces) if is_seen(each.polygon, eye)
                   and (part := each.hit(eye, target)) is not None}
            if not met:
                continue
            points = {k: place(eye, target, part) for k, part in met.items()}
            drawn = [parts[slot].source for slot in order if parts[slot].source in met and stored[slot]
                     and is_inside(stored[slot], parts[slot].plane, points[parts[slot].source])]
            if set(drawn) != set(met):  # on the edge of a part, to a unit
                beside += 1
                continue
            hits += 1
            last = drawn[-1]
            if met[last] != min(met.values()):
                nearest = min(met, key=met.get)
                assert is_near(faces[last].polygon, faces[nearest].polygon, points[last], points[nearest]), (
                    f"{make.__name__}, seed {seed}: eye {eye}, target {target}: face {last} is drawn over "
                    f"face {nearest}; .deps/venv/bin/python -m pytest tests/mesh/test_trees.py")
                unsure += 1
            elif make is grid:  # in one plane the later one is seen
                same = [k for k in met if met[k] == met[last]
                        and faces[k].polygon.plane == faces[last].polygon.plane]
                assert last == max(same)
    assert hits > 100
    assert beside <= hits // 50 and unsure <= hits // 200, (hits, beside, unsure)


def test_corners_are_as_near_to_planes_as_is_derived() -> None:
    """No stored corner of a part is farther than OFF on the wrong side of a plane above it in the tree, nor
    off its face's own plane."""
    worst = 0.0
    for seed, make in enumerate((crossing, boxes, slivers, grid)):
        tree = bsp.build([each.polygon for each in make(np.random.default_rng(seed + 9), 24)], MOST)
        todo = [(0, [])]
        while todo:
            number, above = todo.pop()
            node, (front, back) = tree.nodes[number], tree.counts[number]
            for part in node.faces:
                for corner in polygons.in_file(polygons.with_cuts(part, tree.cuts)):
                    off = [abs(height(part.plane, corner))]
                    off += [-sign * height(plane, corner) for plane, sign in above]
                    worst = max(worst, *off)
                    assert max(off) <= OFF
            for child, count, sign in ((number + 1, front, 1), (number + 1 + front, back, -1)):
                if count:
                    todo.append((child, [*above, (node.plane, sign)] if node.plane else above))
    assert worst > 0.5  # the bound is not too wide to test anything


def height(plane, corner) -> float:
    """Over a plane, in units."""
    return float(Fraction(dot(plane[:3], corner[:3]), 1 << 30) - plane[3])


def test_values_of_new_corners_are_even() -> None:
    """s, t and normals of a split square are those of its plane, to the last bit where the cut is."""
    corners = [(0, 0, 0, 0, 0, 0, 0, 16384), (4 * ONE, 0, 0, 256 * ONE, 0, 16384, 0, 0),
               (4 * ONE, 4 * ONE, 0, 256 * ONE, 256 * ONE, 16384, 0, 0), (0, 4 * ONE, 0, 0, 256 * ONE, 0, 0, 16384)]
    square = polygons.polygon_of(corners, (0, 0, 1 << 30, 0), 0, False)
    cuts: dict = {}
    for part in polygons.split(square, (1 << 30, 0, 0, ONE), cuts):
        for x, y, z, s, t, nx, ny, nz in polygons.in_file(part.corners):
            assert (z, s, t, nx, ny, nz) == (0, 64 * x, 64 * y, x // 16, 0, 16384 - x // 16)
    assert sorted(len(places) for places in cuts.values()) == [1, 1]


def test_neighbours_get_each_others_corners() -> None:
    """Where an edge that two faces share is cut in one of them, the other gets the corner too."""
    left = face([(0, 0, 0), (ONE, 0, 0), (ONE, ONE, 0), (0, ONE, 0)], 0).polygon
    right = face([(ONE, 0, 0), (2 * ONE, 0, ONE), (2 * ONE, ONE, ONE), (ONE, ONE, 0)], 1).polygon
    cuts: dict = {}
    polygons.split(left, (0, 1 << 30, 0, 12345), cuts)
    assert [c[:3] for c in polygons.in_file(polygons.with_cuts(right, cuts))] == [
        (ONE, 0, 0), (2 * ONE, 0, ONE), (2 * ONE, ONE, ONE), (ONE, ONE, 0), (ONE, 12345, 0)]


@pytest.mark.parametrize("seed", range(4))
def test_convex_bodies_and_rooms_are_one_node(seed: int) -> None:
    """A box seen from outside, and one seen from inside, need no plane that divides them."""
    box = boxes(np.random.default_rng(seed), 6)
    room = [face(each.corners[::-1], k) for k, each in enumerate(box)]
    for some in (box, room):
        assert len(bsp.build([each.polygon for each in some], MOST).nodes) == 1


def test_too_many_faces_are_given_up() -> None:
    faces = [each.polygon for each in crossing(np.random.default_rng(1), 12)]
    assert bsp.build(faces, 12) is None
