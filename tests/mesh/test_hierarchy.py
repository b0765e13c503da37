"""Objects in the space of other objects: poses are products, computed here with 4x4 matrices."""

import numpy as np
import pytest

from tests.helpers.arrays import check_within
from tests.helpers.refusals import without_line
from tests.mesh.test_space import GOOD, NOISE, ONE, UNIT, folder, make  # noqa: F401
from tmap.base.errors import UserError
from tmap.model.mesh import transform

FRAMES, EYE = 8, 10
FOCAL = 32 / np.tan(np.pi / 6) / 64  # in guard bands
ERROR = 2 / ONE  # of a point: its move is rounded by half a unit, its sum cut by one; factors are finer
HEAD = GOOD[:GOOD.index("[[objects]]")]
#: From the hand up to the body: fields for TOML, with what is left out here at its default.
HAND = {"parent": "arm", "position": [0, 0.5, 0.25], "rotation": [20, 0, 70], "axis": [0.5, 1, 1], "turns": 3,
        "first": 1}
ARM = {"name": "arm", "parent": "body", "position": [1, 2, -0.5], "rotation": [-30, 10, 0], "size": 0.5, "first": 2,
       "keys": [{"frame": 0}, {"frame": 4, "position": [2, 2, 1.5]}]}
BODY = {"name": "body", "position": [-1, 0, 1], "size": 1.5, "turns": -1, "last": 3}


def toml(value) -> str:
    """Returns a value in TOML."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(each)}" for key, each in value.items()) + " }"
    if isinstance(value, list):
        return f"[{', '.join(map(toml, value))}]"
    return f'"{value}"' if isinstance(value, str) else str(value)


def listed(*objects: dict) -> str:
    """A scene of these objects, each a mesh in red."""
    return HEAD + "".join('[[objects]]\nmesh = "mesh.obj"\n' + "".join(
        f"{key} = {toml(value)}\n" for key, value in ({"material": "red"} | obj).items()) for obj in objects)


def turned(axis, degrees: float) -> np.ndarray:
    """The rotation about an axis, counterclockwise as seen from its end: Rodrigues' formula by rows."""
    axis = np.array(axis) / np.linalg.norm(axis)
    angle = np.radians(degrees)
    return np.array([row * np.cos(angle) + np.cross(axis, row) * np.sin(angle)
                     + axis * (axis @ row) * (1 - np.cos(angle)) for row in np.eye(3)]).T


def placed(obj: dict, frame: int) -> np.ndarray:
    """An object's matrix in its parent's space, without its size."""
    age = frame - obj.get("first", 0)
    x, y, z = obj.get("rotation", [0, 0, 0])
    made = np.eye(4)
    made[:3, :3] = turned(obj.get("axis", [0, 1, 0]), 360 * obj.get("turns", 0) * age / FRAMES) \
        @ turned([0, 0, 1], z) @ turned([0, 1, 0], y) @ turned([1, 0, 0], x)
    made[:3, 3] = obj.get("position", [0, 0, 0])
    if "keys" in obj:  # of ARM: a straight way in four frames
        part = min(max(age, 0), 4) / 4
        made[:3, 3] = (1 - part) * made[:3, 3] + part * np.array(obj["keys"][1]["position"])
    return made


def world(chain: list[dict], frame: int) -> np.ndarray:
    """The matrix to space of the first object in a chain of parents."""
    made = np.eye(4)
    for obj in reversed(chain):
        size = obj.get("size", 1)
        made = made @ placed(obj, frame) @ np.diag([size, size, size, 1])
    return made


@pytest.mark.parametrize("objects", [(HAND, ARM, BODY), (BODY, ARM, HAND), (ARM, HAND, BODY)])
def test_poses_are_products(folder, objects):  # noqa: F811
    """Three levels in any order, with rotations, turns, keys, sizes and first frames of their own: where
    each point is before the camera. A parent that is not shown yet, or no more, moves nevertheless."""
    made = make(folder, listed(*objects))
    chains = {"arm": [ARM, BODY], "body": [BODY], None: [HAND, ARM, BODY]}
    for obj, instance in zip(objects, made.instances):
        chain = chains[obj.get("name")]
        mesh = made.meshes[instance.mesh]
        points = made.points[mesh.point:mesh.point + mesh.points, :3].tolist()
        size = np.prod([each.get("size", 1) for each in chain])
        assert instance.views == {"arm": 6, "body": 4, None: 7}[obj.get("name")]
        for k in range(instance.views):
            matrix = world(chain, instance.first_frame + k)
            view = made.views[instance.view + k].tolist()
            shown = np.array([[p.x, p.y, p.w] for p in transform(made, points, view)])
            x, y, z, _ = matrix @ np.column_stack([np.array(points) / ONE / size, np.ones(len(points))]).T
            check_within(shown / ONE, np.column_stack([FOCAL * x, -FOCAL * y, EYE - z]), ERROR,
                         f"{obj.get('name')}, frame {instance.first_frame + k}: point, axis")


def test_views_are_products(folder):  # noqa: F811
    """The factors of a child's view, and the eye in its space, by which faces seen from behind are found."""
    made = make(folder, listed(HAND, ARM, BODY))
    instance = made.instances[0]
    for k, row in enumerate(made.views[instance.view:][:instance.views].tolist()):
        matrix = world([HAND, ARM, BODY], instance.first_frame + k)
        turn = matrix[:3, :3] / 0.75
        check_within(np.array(row[12:15]) / ONE, turn.T @ ([0, 0, EYE] - matrix[:3, 3]), 0.5 / ONE + NOISE, "eye: axis")
        factors = np.diag([FOCAL, -FOCAL, -1]) @ turn
        check_within(np.array(row[:9]) / UNIT, factors.ravel(), 0.5 / UNIT + NOISE, "factors: factor")


def test_parts_of_several_materials_have_one_parent(folder):  # noqa: F811
    """Each part of a file moves with the parent, and is one parent for its children."""
    (folder / "two.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 2\n")
    obj = "mesh = \"two.obj\"\nmaterials = { a = 'red', b = 'glow' }\n"
    text = HEAD + f'[[objects]]\n{obj}name = "x"\nturns = 1\n[[objects]]\n{obj}parent = "x"\nposition = [2, 0, 0]\n'
    made = make(folder, text)
    parents, children = made.instances[:2], made.instances[2:]
    assert len(children) == 2
    for pair in parents, children:
        rows = [made.views[each.view:][:8, :12] for each in pair]
        assert np.array_equal(*rows)
    parent, child = (made.views[pair[0].view:][:8] for pair in (parents, children))
    check_within(child[:, :9] / UNIT, parent[:, :9] / UNIT, NOISE, "factors of both")
    moves = parent[:, 9:12] / ONE + 2 * parent[:, [0, 3, 6]] / UNIT
    check_within(child[:, 9:12] / ONE, moves, 1 / ONE + 1 / UNIT + NOISE, "moves of a child two units along x")


@pytest.mark.parametrize("objects, message", [
    ([{"parent": "x"}], "objects[0].parent: there is no object in space called 'x'"),
    ([{"name": "x"}, {"name": "y", "parent": "x"}, {"name": "x"}], "objects[2].name: another object is called 'x' too"),
    ([{"name": "x", "parent": "x"}], "objects[0].parent: leads in a circle: 'x' in 'x'"),
    ([{"parent": "y"}, {"name": "x", "parent": "y"}, {"name": "y", "parent": "x"}],
     "objects[0].parent: leads in a circle: 'y' in 'x' in 'y'"),
    ([{"name": "x", "position": [9e4, 0, 0]}, {"parent": "x", "position": [1, 0, 0]}],
     "objects[0]: is 10240 units or more from the camera in frame 0"),
    ([{"name": "x", "size": 1000}, {"parent": "x", "size": 3}],
     "objects[0].mesh: mesh.obj: a point is more than 2048 units from"),
])
def test_refused(folder, objects, message):  # noqa: F811
    with pytest.raises(UserError) as caught:
        make(folder, listed(*objects))
    scene = folder / "scene.toml"
    assert without_line(str(caught.value), scene).startswith(f"{scene}: {message}"), caught.value


def test_polygons_are_no_parents(folder):  # noqa: F811
    """Only objects in space have names and parents."""
    with pytest.raises(UserError, match=r":20: objects\[0\].name: unknown field; known are sides"):
        make(folder, HEAD + '[[objects]]\nname = "x"\nmaterial = "red"\nsides = 3\nradius = 9\n')
