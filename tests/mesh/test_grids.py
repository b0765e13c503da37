"""Faces cut along a grid: no gap between neighbours, corners on the planes, even values, the same area."""

from collections import Counter

import numpy as np
import pytest

from tests.mesh.test_lights import ALL, FACING, ONE, ROOF, START, make
from tests.mesh.test_meshes import assert_models
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.compiler import grids
from tmap.model import mesh16
from tmap.scene_file.scene_file import Scene

#: Corners of a closed body without parallel sides, whatever their places.
BODY = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]


def body(rng, grid: float, more: str = "") -> str:
    """Returns an object that is a random tetrahedron, seen from outside."""
    points = rng.uniform(-3, 3, (4, 3))
    if np.linalg.det(points[1:] - points[0]) < 0:
        points[[0, 1]] = points[[1, 0]]
    return f"[[objects]]\nmaterial = \"grey\"\npoints = {points.tolist()}\n" \
           f"faces = {[list(face) for face in BODY]}\ngrid = {grid}\n{more}"


def rings_of(made: Scene) -> list[list[int]]:
    """Returns the points of each face of a scene's only mesh."""
    return [made.corners[first:first + count, 0].tolist() for *_, first, count in made.faces.tolist()]


def area(ring: np.ndarray) -> float:
    """Returns a polygon's area."""
    return float(np.linalg.norm(np.cross(ring - ring[0], np.roll(ring, -1, 0) - ring[0]).sum(axis=0))) / 2


def has_16_bits(made: Scene) -> bool:
    """Returns True if some mesh has 16-bit operands in its first frame."""
    return any(each.view16 >= 0 and mesh16.is_used(made.materials[each.material], made.views16[each.view16])
               for each in made.instances)


@pytest.mark.parametrize("seed", range(24))
def test_closed_bodies_stay_closed(tmp_path, seed: int) -> None:
    """Each edge of a part has one neighbour, which runs the other way; no cell is larger than the pitch."""
    rng = np.random.default_rng(seed)
    pitch = float(rng.choice([0.3, 0.5, 0.77, 1.0, 2.5]))
    lights = ALL * (seed % 2)
    made = make(tmp_path, START + lights + body(rng, pitch, "turns = 1\n" * (seed % 3 == 0)))
    edges = Counter((a, b) for ring in rings_of(made) for a, b in zip(ring, ring[1:] + ring[:1]))
    assert len(made.faces) > 4 and set(edges.values()) == {1}
    assert all((b, a) in edges for a, b in edges)
    for ring in rings_of(made):
        assert np.ptp(made.points[ring], axis=0).max() <= pitch * ONE + 1


def test_new_corners_are_on_the_planes_and_values_are_even(tmp_path) -> None:
    """s and t grow with x and y; a square of 4 by 4 becomes 16 cells."""
    wall = '[[objects]]\nmaterial = "map"\npoints = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]\n' \
        f"faces = [[0, 1, 2, 3]]\nuvs = [[[0, 200], [100, 200], [100, 0], [0, 0]]]\ngrid = 1\n" \
        f'[textures]\nmap.image = "{SCENES / "checker.png"}"\n'
    made = make(tmp_path, START.replace("red.colour", 'map.texture = "map"\nred.colour') + wall)
    assert (len(made.faces), len(made.points)) == (16, 25)
    for point, _, s, t in made.corners.tolist():
        x, y, _ = made.points[point].tolist()
        assert x % ONE == y % ONE == 0 and (s, t) == (25 * x, 200 * ONE - 50 * y)
    rings = [made.points[ring] / ONE for ring in rings_of(made)]
    assert [area(ring) for ring in rings] == [1.0] * 16


def test_a_cut_depends_on_an_edges_ends_alone() -> None:
    rng = np.random.default_rng(5)
    for _ in range(300):
        a, b = (tuple(map(int, rng.integers(-10 ** 6, 10 ** 6, 3))) for _ in range(2))
        axis = int(rng.integers(3))
        low, high = sorted((a[axis], b[axis]))
        at = int(rng.integers(low, high + 1))
        if low < at < high:
            one, other = (grids.between((*c, 0.5), (*d, 7.25), axis, at) for c, d in ((a, b), (b, a)))
            assert one[:3] == other[:3] and one[axis] == at
            exact = [m + (n - m) * (at - a[axis]) / (b[axis] - a[axis]) for m, n in zip(a, b)]
            assert max(abs(n - m) for n, m in zip(one, exact)) <= 0.5 + 1e-6


def test_areas_are_kept(tmp_path) -> None:
    for seed in range(5):
        whole, cut = (make(tmp_path, START + body(np.random.default_rng(seed), grid)) for grid in (2048, 0.4))
        sums = [sum(area(made.points[ring] / ONE) for ring in rings_of(made)) for made in (whole, cut)]
        assert abs(sums[0] - sums[1]) < 1e-3 * sums[0]


def test_straight_corners_stay_between_neighbours(tmp_path) -> None:
    """The square has a corner in the middle of its upper side, where two squares meet it: the triangles that
    shades need all end there."""
    made = make(tmp_path, START + ALL + """[[objects]]
material = "grey"
normals = "faces"
points = [[-2, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [-2, 2, 0], [0, 4, 0], [2, 4, 0], [-2, 4, 0]]
faces = [[2, 3, 4, 0, 1], [3, 2, 6, 5], [4, 3, 5, 7]]
""")
    edges = Counter((a, b) for ring in rings_of(made) for a, b in zip(ring, ring[1:] + ring[:1]))
    outer = [(a, b) for a, b in edges if (b, a) not in edges]
    assert set(edges.values()) == {1} and len(outer) == 7
    assert sum(area(made.points[ring] / ONE) for ring in rings_of(made)) == 16


def test_opposite_normals_have_a_middle(tmp_path) -> None:
    """Between them, on a plane of the grid, the face's own normal is taken."""
    (tmp_path / "mesh.obj").write_text("v -1 0 0\nv 1 0 0\nv 0 2 0\nvn 1 0 0\nvn -3 0 0\nf 1//1 2//2 3//1\n")
    for motion in ("", "turns = 1\n"):
        made = make(tmp_path, START + ALL + f'[[objects]]\nmaterial = "grey"\nmesh = "mesh.obj"\ngrid = 1\n{motion}')
        assert len(made.faces) > 3


def test_frames_are_the_models(tmp_path) -> None:
    """On the emulated A1200: shades with 16-bit and 32-bit operands, lit textures in perspective, a tree."""
    lit = START.replace('grey.shades = ["#000000", "#ffffff"]',
                        'grey = { texture = "map", mapper = "lit_gouraud", perspective = "every16" }')
    maps = f'uvs = [[[0, 0], [250, 0], [250, 250], [0, 250]]]\n[textures]\nmap.image = "{SCENES / "checker.png"}"\n'
    near = ALL.replace("[light]", 'keys = [{ frame = 0, eye = [3, 2, 5] }, { frame = 8, eye = [-3, 3, 4] }]\n[light]')
    grey = 'grey = { shades = ["#000000", "#ffffff"], edges = "snapped" }'
    snapped = START.replace('grey.shades = ["#000000", "#ffffff"]', grey)
    exact = START.replace('grey.shades = ["#000000", "#ffffff"]', grey.replace("snapped", "exact"))
    scenes = {"exact": exact + near + ROOF + 'normals = "faces"\ngrid = 0.75\n',
              "snapped": snapped + near + ROOF + 'normals = "faces"\ngrid = 0.75\n',
              "smooth": snapped + near + ROOF, "lit": lit + near + ROOF + "grid = 1\n" + maps,
              "tree": START + near + ROOF + 'order = "bsp"\ngrid = 1\n'
              + ROOF + 'order = "bsp"\nrotation = [0, 50, 20]\n'}
    tiles = f'[{{ image = "{SCENES / "n64/bricks.png"}", format = "rgba16" }}]'
    units = START.replace('grey.shades = ["#000000", "#ffffff"]',
                          f'grey.n64 = {{ combine = "modulate", tiles = {tiles} }}')
    units = units.replace("[materials]", 'format = "rgba8888"\n[materials]')
    scenes["n64"] = units + near + ROOF + "grid = 1\nuvs = [[[0, 0], [9, 0], [9, 9], [0, 9]]]\n"
    made = {name: make(tmp_path, text) for name, text in scenes.items()}
    assert has_16_bits(made["snapped"]) and not has_16_bits(made["exact"])
    for frames in assert_models(made).values():
        assert all(len(np.unique(frame)) > 4 for frame in frames)


@pytest.mark.parametrize("text, message", [
    (FACING + "grid = 0\n", "objects[0].grid: must be from 0.0625 to 2048"),
    (FACING + "grid = true\n", "objects[0].grid: must be a number, not true or false"),
    (FACING + "grid = 0.0625\nsize = 100\n", "objects[0].faces[0]: the grid cuts it into more than 4096 parts"),
    (FACING + "grid = 0.0625\nsize = 1.2\n", "objects[0].faces: more than 4096 faces, those counted as triangles that "
                                             "are cut into them and as cells of the grid"),
    (START + '[[objects]]\nmaterial = "red"\nvertices = [[0, 0], [9, 0], [0, 9]]\ngrid = 1\n',
     "objects[0].grid: unknown field"),
])
def test_refused(tmp_path, text: str, message: str) -> None:
    with pytest.raises(UserError) as caught:
        make(tmp_path, text)
    assert message in str(caught.value) and str(caught.value).count("\n") == 0
