"""Cameras with keys: cuts, lenses and upward directions that change, and eyes that keys state alone."""

import numpy as np
import pytest

from tests.helpers.arrays import check_within
from tests.helpers.refusals import without_line
from tests.mesh.test_space import NOISE, ONE, UNIT, changed, folder, make  # noqa: F401
from tmap.base.errors import UserError

GUARD = 64  # pixels of the guard band for 64x48 pixels and 60 degrees
NARROW = 32 / np.tan(np.pi / 6)  # focal length, of 60 degrees; that of 90 degrees is 32


def filmed(camera: str) -> str:
    """The scene of test_space with another camera. Its first object is in the origin."""
    return changed("eye = [0, 0, 10]\n", camera)


def views(made) -> np.ndarray:
    """The first object's views: rows of factors for x, y and depth, and the moves."""
    rows = made.views[made.instances[0].view:][:made.instances[0].views]
    return np.concatenate([rows[:, :9] / UNIT, rows[:, 9:12] / ONE], axis=1)


def check_views(made, wanted) -> None:
    """Each view is the wanted one, but for the file's rounding: half a unit."""
    shown, wanted = views(made), list(wanted)
    check_within(shown[:, :9], [row[:9] for row in wanted], 0.5 / UNIT + NOISE, "factors: frame, factor")
    check_within(shown[:, 9:], [row[9:] for row in wanted], 0.5 / ONE + NOISE, "moves: frame, axis")


def from_front(depth: float, focal: float = NARROW) -> list[float]:
    """The view from a place on the z axis that looks at the origin."""
    return [focal / GUARD, 0, 0, 0, -focal / GUARD, 0, 0, 0, -1, 0, 0, depth]


def from_right(depth: float, focal: float) -> list[float]:
    """The view from a place on the x axis that looks at the origin, with z upright: y is to its right."""
    return [0, focal / GUARD, 0, 0, 0, -focal / GUARD, -1, 0, 0, 0, 0, depth]


CUT = """\
keys = [{ frame = 0, eye = [0, 0, 10] }, { frame = 2, eye = [0, 0, 6] },
        { frame = 4, cut = true, eye = [10, 0, 0], up = [0, 0, 3], fov = 90 },
        { frame = 6, eye = [20, 0, 0], up = [0, 0, 3], fov = 90 }]
"""


def test_cuts(folder):  # noqa: F811
    """The camera moves, rests, jumps with another lens and another side up, and moves again."""
    made = make(folder, filmed(CUT))
    assert 2 ** made.guard == GUARD
    check_views(made, [*map(from_front, (10, 8, 6, 6)),
                       *(from_right(depth, 32) for depth in (10, 15, 20, 20))])


def test_a_first_key_may_be_a_cut(folder):  # noqa: F811
    """Before it there is no other view, and its own holds."""
    made = make(folder, filmed("keys = [{ frame = 3, cut = true, eye = [0, 0, 5] }, "
                               "{ frame = 7, eye = [0, 0, 9] }]\n"))
    check_views(made, map(from_front, (5, 5, 5, 5, 6, 7, 8, 9)))


def test_zoom(folder):  # noqa: F811
    """The angle changes evenly; the guard band holds the longest focal length of all."""
    made = make(folder, filmed("eye = [0, 0, 5]\nfov = 1\nkeys = [{ frame = 1, fov = 90 }, { frame = 4, fov = 60 }]\n"))
    angles = np.radians([90, 90, 80, 70, 60, 60, 60, 60])
    assert 2 ** made.guard == GUARD
    check_views(made, [from_front(5, 32 / np.tan(angle / 2)) for angle in angles])


def test_up_leans(folder):  # noqa: F811
    """Halfway from y to x the diagonal is up."""
    made = make(folder, filmed("eye = [0, 0, 5]\nkeys = [{ frame = 0 }, { frame = 2, up = [1, 0, 0] }]\n"))
    half = NARROW / GUARD / np.sqrt(2)
    check_views(make(folder, filmed("eye = [0, 0, 5]\nup = [1, 1, 0]\n")),
                [[half, -half, 0, -half, -half, 0, 0, 0, -1, 0, 0, 5]] * 8)
    check_within(views(made)[1], [half, -half, 0, -half, -half, 0, 0, 0, -1, 0, 0, 5], 0.5 / ONE, "leaning: number")


@pytest.mark.parametrize("camera, message", [
    ("keys = [{ frame = 0, eye = [0, 0, 9] }, { frame = 3 }]\n",
     "camera.keys[1].eye: is missing here and beside keys"),
    ("target = [0, 0, 1]\n", "camera.eye: is missing"),
    ("eye = [0, 0, 9]\nkeys = [{ frame = 0, up = [0, 0, 0] }]\n", "camera.keys[0].up: must have a length"),
    ("eye = [0, 0, 9]\nkeys = [{ frame = 0 }, { frame = 3, up = [0, -1, 0] }, { frame = 3 }]\n",
     "camera.keys[2].frame: must be above 3"),
    ("eye = [0, 0, 9]\nkeys = [{ frame = 0 }, { frame = 4, up = [0, -1, 0] }]\n",
     "camera: eye, target and up are on one line in frame 2"),
    ("eye = [0, 0, 9]\nkeys = [{ frame = 0 }, { frame = 4, fov = 0 }]\n", "camera.keys[1].fov: must be from 1 to 170"),
    ("eye = [0, 0, 9]\nkeys = [{ frame = 0, cut = 1 }]\n", "camera.keys[0].cut: must be true or false"),
])
def test_refused(folder, camera: str, message: str):  # noqa: F811
    with pytest.raises(UserError) as caught:
        make(folder, filmed(camera))
    scene = folder / "scene.toml"
    assert without_line(str(caught.value), scene).startswith(f"{scene}: {message}"), caught.value


def test_too_narrow_at_a_key(folder):  # noqa: F811
    text = filmed("eye = [0, 0, 9]\nkeys = [{ frame = 0 }, { frame = 4, fov = 2 }]\n")
    with pytest.raises(UserError, match=r":18: camera.keys\[1\].fov: is too narrow for 1024 pixels"):
        make(folder, text.replace("width = 64", "width = 1024", 1))
