"""Points of meshes compared with exact numbers, within the bounds that tools/tmap/ideal/mesh.py
derives."""

from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest

from tmap.compiler import objects
from tmap.ideal import mesh
from tmap.model import mesh as model_mesh

ONE = 65536


def about(guard: int = 9, near: int = 256) -> SimpleNamespace:
    return SimpleNamespace(near_plane=near, guard=guard, width=320, height=256)


def turned(random) -> np.ndarray:
    q = np.linalg.qr(random.normal(size=(3, 3)))[0]
    return q * np.sign(np.linalg.det(q))


def row_of(factors: np.ndarray, move) -> list[int]:
    """A view's numbers, rounded as the compiler rounds them."""
    return [*objects.rounded(factors, 30), *objects.rounded(move, 16)]


@pytest.mark.parametrize("reach, away", [(1, 3), (1, 0.05), (40, 60), (2048, 3000), (2048, 10000),
                                         (0.01, 0.02), (500, 0)])
def test_projection_is_within_its_bound(reach, away):
    """Points near and far, small and large meshes, narrow and wide lenses."""
    random = np.random.default_rng(round(1000 * away + reach))
    worst, seen = 0.0, 0
    for k in range(60):
        guard = int(random.integers(6, 14))
        lens = np.array([random.uniform(0.5, 1)] * 2 + [1.0])
        factors = lens[:, None] * turned(random)
        move = lens * np.array([*random.uniform(-0.3, 0.3, 2) * away, away])
        points = np.rint(random.uniform(-reach, reach, (30, 3)) * ONE).astype(int).tolist()
        scene = about(guard)
        for point, made in zip(points, model_mesh.transform(scene, points, row_of(factors, move))):
            exact = mesh.camera(factors.tolist(), move.tolist(), point)
            error = max(abs(Fraction(a, ONE) - b) for a, b in zip((made.x, made.y, made.w), exact))
            assert error <= mesh.camera_error(reach)
            if made.screen:
                bound = mesh.screen_error(guard, float(exact[2]), reach)
                right = mesh.screen(guard, scene.width, scene.height, *exact)
                off = max(abs(Fraction(a, ONE) - b) for a, b in zip(made.screen, right))
                assert off <= bound, (k, point)
                worst, seen = max(worst, float(off / Fraction(bound))), seen + 1
    assert seen > 100 and worst > 0.1  # the bound is not too wide to test anything


def random_face(random, most: float, count: int) -> list[tuple]:
    """A convex polygon on a plane before, across or behind the camera: x, y, s, t, shade, w."""
    turn, middle = turned(random), random.uniform(-1, 1, 3) * most * 10 ** -random.uniform(0, 5)
    angles = np.sort(random.uniform(0, 2 * np.pi, count))
    ring = np.column_stack([np.cos(angles), np.sin(angles), 0 * angles]) * most @ turn + middle
    rest = random.integers(-200 * ONE, 200 * ONE, (count, 3))
    return [(*map(int, np.rint(np.array(p[:2]) * ONE)), *map(int, r), int(round(p[2] * ONE)))
            for p, r in zip(ring, rest)]


def as_exact(vertex) -> tuple:
    """x, y, w, s, t, shade as fractions."""
    x, y, s, t, shade, w = (Fraction(value, ONE) for value in vertex)
    return x, y, w, s, t, shade


@pytest.mark.parametrize("near", [256, ONE, 999 * ONE + 1])
def test_what_the_near_plane_cuts_is_within_half_a_unit(near):
    """x and y are at most as large as the near plane's distance, so that no other border cuts."""
    random, cuts = np.random.default_rng(near), 0
    for _ in range(200):
        face = [tuple(int(random.integers(-most, most + 1)) for most in
                      (near, near, 9000 * ONE, 40 * ONE, 255 * ONE, (1 << 30) - 1))
                for _ in range(int(random.integers(3, 6)))]
        cut = model_mesh.clip(face, near)
        exact = mesh.clip([as_exact(v) for v in face], Fraction(near, ONE))
        assert len(cut) == len(exact)
        for found, right in zip(cut, exact):
            assert max(abs(a - b) for a, b in zip(as_exact(found), right)) <= Fraction(1, 2 * ONE)
            cuts += found[5] == near
    assert cuts > 200


@pytest.mark.parametrize("near", [256, 5000, ONE])
def test_whatever_is_cut_lies_inside_and_on_the_screen(near):
    """All borders, any size and place, depths from 1/256 to nearly 16,384 in one polygon: the
    clipped polygon is within a unit of the borders, has no more corners than a convex one can, and
    is small on the screen."""
    random, scene, widest = np.random.default_rng(near), about(13, near), 0.0
    for most in (0.01, 1, 100, 4000, 16000):
        for _ in range(200):
            count = int(random.integers(3, 33))
            face = [(*(max(min(c, 2**30 - 1), 1 - 2**30) for c in v[:2]), *v[2:5],
                     max(min(v[5], 2**30 - 1), 1 - 2**30)) for v in random_face(random, most, count)]
            cut = model_mesh.clip(face, near)
            assert len(cut) <= count + 5
            for x, y, s, t, shade, w in cut:
                assert w >= near and max(abs(x), abs(y)) <= w + 1
                assert all(abs(c) < 16384 * ONE for c in model_mesh.project(scene, x, y, w))
                assert max(map(abs, (s, t, shade))) <= 200 * ONE
            if cut:
                widest = max(widest, max(v[5] for v in cut) / min(v[5] for v in cut))
    assert widest > 10000
