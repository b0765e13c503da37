"""Concave faces become triangles: same area, same orientation, corners with their values."""

from itertools import combinations, product

import numpy as np
import pytest

from tmap.base.errors import UserError
from tmap.compiler import mesh_build
from tmap.shapes import cutting
from tmap.shapes.mesh_file import Shape

ONE = 65536


def star(random: np.random.Generator) -> np.ndarray:
    """A star-shaped polygon: corners at growing angles around a point, near and far."""
    count = random.integers(4, 33)
    angles = np.sort((np.arange(count) + random.uniform(0.1, 0.9, count)) * 2 * np.pi / count)
    far = random.uniform(0.2, 40, count)
    return np.column_stack([far * np.cos(angles), far * np.sin(angles)])


def comb(random: np.random.Generator) -> np.ndarray:
    """A comb with teeth of random lengths; its corners include ones on straight sides."""
    teeth = random.integers(2, 8)
    tops = [point for k in reversed(range(teeth)) for point in
            ((2 * k + 1, random.integers(2, 30)), (2 * k + 0.5, random.integers(2, 30)), (2 * k, 1))]
    return np.array([(0, 0), (teeth, 0), (2 * teeth - 1, 0), *tops], float)


def turned(random: np.random.Generator, flat: np.ndarray) -> np.ndarray:
    """A polygon of the plane, turned at random in space."""
    axes = np.linalg.qr(random.normal(size=(3, 3)))[0]
    return flat @ axes[:2] + random.uniform(-9, 9, 3)


def shoelace(corners: list) -> int:
    """Twice the area, by the products of neighbours."""
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, corners[1:] + corners[:1]))


@pytest.mark.parametrize("make", [star, comb])
def test_triangles_cover_the_polygon(make):
    """The triangles run counterclockwise and have the polygon's area together; every corner is of a
    triangle, and no side of a triangle crosses a side of the polygon."""
    random = np.random.default_rng(1)
    for case in range(60):
        corners = [tuple(map(int, corner)) for corner in np.rint(make(random) * ONE)]
        cuts = cutting.triangles(corners)
        areas = [shoelace([corners[k] for k in cut]) for cut in cuts]
        assert min(areas) > 0 and sum(areas) == shoelace(corners), f"case {case}"
        assert len(cuts) == len(corners) - 2 and {k for cut in cuts for k in cut} == set(range(len(corners)))
        inner = [(corners[a], corners[b]) for cut in cuts for a, b in combinations(cut, 2)]
        for (a, b), (c, d) in product(inner, zip(corners, corners[1:] + corners[:1])):
            signs = [np.sign(cutting.turn(*each)) for each in ((a, b, c), (a, b, d), (c, d, a), (c, d, b))]
            assert signs[0] * signs[1] >= 0 or signs[2] * signs[3] >= 0, f"case {case}"


@pytest.mark.parametrize("make", [star, comb])
def test_meshes_of_concave_faces(make):
    """In space: triangles have the face's normal and area, within rounding to 16.16, and each
    corner has the texel and the normal that it had in the face."""
    random = np.random.default_rng(2)
    for case in range(20):
        flat = make(random)
        points = turned(random, flat)
        count = len(points)
        texels = [(float(k), float(2 * k)) for k in range(count)]
        normals = [tuple(each) for each in random.normal(size=(count, 3)).tolist()]
        made = mesh_build.build(
            Shape(points, [list(range(count))], [texels], [normals]),
            mesh_build.Wishes(mapping="uv", light=True), f"case {case}")
        places = np.rint(points * ONE).astype(int).tolist()
        number = {tuple(place): k for k, place in enumerate(places)}
        whole = mesh_build.newell(points)
        total = 0
        for *plane, first, corners in made.faces.tolist():
            rows = made.corners[first:first + corners]
            ring = made.points[rows[:, 0], :3]
            total += np.linalg.norm(mesh_build.newell(ring / ONE))
            if np.linalg.norm(mesh_build.newell(ring / ONE)) > 0.1:  # else rounding turns it too far
                assert np.dot(plane[:3], whole) / np.linalg.norm(whole) / (1 << 30) > 0.999, f"case {case}"
            for place, (_, normal, s, t) in zip(ring.tolist(), rows.tolist()):
                k = number[tuple(place)]
                assert (s, t) == (k * ONE, 2 * k * ONE), f"case {case}: corner {k}"
                unit = np.array(normals[k]) / np.linalg.norm(normals[k])
                assert abs(made.normals[normal, :3] / 16384 - unit).max() < 1e-4, f"case {case}: corner {k}"
        assert total == pytest.approx(np.linalg.norm(whole), rel=1e-3), f"case {case}"


def test_a_hole_joined_to_the_border():
    """A square ring whose hole is joined to the border by two sides in one place."""
    outer, hole = [(0, 0), (9, 0), (9, 9), (0, 9)], [(3, 3), (3, 6), (6, 6), (6, 3)]
    corners = [*outer, outer[0], *hole, hole[0]]
    cuts = cutting.triangles(corners)
    areas = [shoelace([corners[k] for k in cut]) for cut in cuts]
    assert min(areas) > 0 and sum(areas) == 2 * (81 - 9)


def test_a_corner_on_a_side_is_kept():
    """A square with a corner in the middle of its first side, which cannot begin a fan."""
    corners = [(0, 0), (4, 0), (8, 0), (8, 8), (0, 8)]
    cuts = cutting.triangles(corners)
    assert len(cuts) == 3 and all(cutting.turn(*(corners[k] for k in cut)) > 0 for cut in cuts)


@pytest.mark.parametrize("corners, parts", [(32, 1), (33, 31), (128, 126)])
def test_faces_of_many_corners(corners, parts):
    """A mesh's face has up to 32 corners; a file's with more becomes triangles."""
    angles = np.arange(corners) * 2 * np.pi / corners
    shape = Shape(np.column_stack([np.cos(angles), np.sin(angles), 0 * angles]), [list(range(corners))])
    assert len(mesh_build.build(shape, mesh_build.Wishes(), "mesh").faces) == parts


def test_too_many_triangles():
    """4,096 at most, after cutting; the message says what is counted."""
    points = np.array([(x, y, 0) for y in (0, 1) for x in range(65)], float)
    face = [*range(65), *range(129, 64, -1)]
    with pytest.raises(UserError, match="mesh: more than 4096 faces, those counted as triangles that are cut"):
        mesh_build.build(Shape(points, [face[:128]] * 40), mesh_build.Wishes(), "mesh")


def test_bent_quadrilaterals():
    """No quadrilateral with four corners off one plane crosses itself, though it seems so from some
    sides: this one from x, from which it is seen as well as from z."""
    points = np.array([(3, 1, 1.5), (4, 1, 2), (4, 2, 0.5), (3, 2, 3)])
    made = mesh_build.build(Shape(points, [[0, 1, 2, 3]]), mesh_build.Wishes(), "mesh")
    assert made.faces[:, 5].tolist() == [3, 3]


@pytest.mark.parametrize("order", [[0, 2, 1, 3], [0, 2, 4, 1, 3], [0, 1, 3, 2, 4]])
def test_faces_that_cross_themselves_are_refused(order):
    """A bow tie with unequal wings, a star, and a pentagon with two corners exchanged."""
    angles = np.arange(len(order)) * 2 * np.pi / len(order)
    points = np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
    points[0, 0] = 1.5
    with pytest.raises(UserError, match=r"mesh\[0\]: crosses itself"):
        mesh_build.build(Shape(points, [order]), mesh_build.Wishes(), "mesh")
