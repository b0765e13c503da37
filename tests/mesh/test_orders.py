"""Scenes with ``order = "bsp"``: which objects are one tree, what is refused, and what is drawn."""

from pathlib import Path

import numpy as np
import pytest

from tests.helpers import mesh_cases
from tests.mesh.test_meshes import assert_models
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.model import mesh, model
from tmap.scene_file import scene_file

ONE = 1 << 16
START = """\
width = 96
height = 64
frames = 6
background = "#000000"
[materials]
red.colour = "#ff0000"
green.colour = "#00ff00"
blue.colour = "#0000ff"
[camera]
eye = [3, 2, 9]
target = [0, 0, 0]
keys = [{ frame = 0, eye = [3, 2, 9] }, { frame = 6, eye = [-9, 1, 2] }]
"""
BEAM = """\
[[objects]]
points = [[-3, -0.3, -0.3], [3, -0.3, -0.3], [-3, 0.3, -0.3], [3, 0.3, -0.3],
          [-3, -0.3, 0.3], [3, -0.3, 0.3], [-3, 0.3, 0.3], [3, 0.3, 0.3]]
faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3]]
"""
POLYGON = '[[objects]]\nmaterial = "red"\nsides = 3\nradius = 4\n'


def beam(material: str, *lines: str, order: str = "bsp") -> str:
    return "\n".join([f'{BEAM}material = "{material}"\norder = "{order}"', *lines, ""])


CROSS = beam("red") + beam("green", "rotation = [0, 0, 90]") + beam("blue", "rotation = [0, 90, 0]")


def make(folder: Path, text: str) -> scene_file.Scene:
    (folder / "scene.toml").write_text(START + text)
    made = compile_scene(folder / "scene.toml")
    scene_file.write(made)  # write checks the whole scene
    return made


def test_still_neighbours_are_one_tree(tmp_path, capsys) -> None:
    """At different places: their points are put there, all are seen from one eye, and a line says what the
    tree cost."""
    made = make(tmp_path, CROSS)
    assert [each.tree for each in made.instances] == [0, 0, 0]
    assert len({tuple(made.views[each.view, :15]) for each in made.instances}) == 1
    high = made.meshes[1]
    points = made.points[high.point:high.point + high.points]
    assert np.ptp(points, axis=0).tolist() == [39322, 6 * ONE, 39322]  # 0.6, rounded twice
    assert sorted(made.slots[:, 0].tolist()) == list(range(len(made.faces)))
    line = capsys.readouterr().err
    assert line.count("\n") == 1 and "objects[0]: a tree of 18 faces: " in line, line
    assert f"{len(made.faces) - 18} more by splits, {len(made.nodes)} nodes" in line


def test_by_depth_beams_cross_wrongly(tmp_path) -> None:
    """The same scene by depth is another picture; by the tree the nearest beam is where its side is."""
    tree, depth = make(tmp_path, CROSS), make(tmp_path, CROSS.replace("bsp", "depth"))
    assert (depth.nodes.shape[0], {each.tree for each in depth.instances}) == (0, {-1})
    wrong = [(model.render(tree, k) != model.render(depth, k)).sum() for k in range(6)]
    assert max(wrong) > 50


@pytest.mark.parametrize("between, trees", [
    (POLYGON, [0, 0, 1]), (beam("blue", order="depth"), [0, 0, -1, 1]), ("", [0, 0, 0])])
def test_others_between_part_trees(tmp_path, between: str, trees: list[int]) -> None:
    made = make(tmp_path, beam("red") + beam("green", "position = [0, 2, 0]") + between + beam("blue"))
    roots = sorted({each.tree for each in made.instances} - {-1})
    assert [roots.index(each.tree) if each.tree >= 0 else -1 for each in made.instances] == trees


def test_moving_objects_have_trees_of_their_own(tmp_path) -> None:
    """A tree that moves as a whole stays in its mesh's space; parts that move as one are in one tree, also
    if some are not there all the time."""
    alone = make(tmp_path, beam("red", "turns = 1"))
    assert alone.meshes[0].faces == 6 and [each.tree for each in alone.instances] == [0]
    both = make(tmp_path, beam("red", "turns = 1") + beam("green", "turns = 1", "last = 3"))
    assert [(each.tree, each.views) for each in both.instances] == [(0, 6), (0, 4)]


def test_gaps_at_splits_are_closed(tmp_path) -> None:
    """A wall of two faces with beams through it hides all that is behind: no pixel of what is behind shows
    where faces were split."""
    wall = """[[objects]]
points = [[-9, -9, 0], [1, -9, 0.5], [9, -9, 0], [9, 9, 0], [1, 9, 0.5], [-9, 9, 0]]
faces = [[0, 1, 4, 5], [1, 2, 3, 4]]
material = "green"
order = "bsp"
"""
    behind = "\n".join(['[[objects]]', 'points = [[-90, -90, -5], [90, -90, -5], [90, 90, -5], [-90, 90, -5]]',
                        'faces = [[0, 1, 2, 3]]', 'material = "red"', ""])
    beams = "".join(beam("blue", f"rotation = [{7 * k}, {31 * k + 20}, {23 * k}]") for k in range(5))
    made = make(tmp_path, behind + wall + beams)
    green, red = (made.materials[k].colour for k in (1, 0))
    shown = [model.render(make(tmp_path, behind + some), k) for some in (wall, wall + beams) for k in range(6)]
    for plain, crossed in zip(shown[:6], shown[6:]):
        covered = plain == green
        assert covered.sum() > 1000 and not (crossed[covered] == red).any()


@pytest.mark.parametrize("text, said", [
    (beam("red") + beam("green", "turns = 1"),
     'objects[1].turns: moves, but the neighbour with order "bsp" not the same way: they cannot be in one tree'),
    (beam("red", "keys = [{ frame = 0 }]") + beam("green"), "objects[0].keys: moves, but the neighbour"),
    (beam("red", "turns = 1") + beam("green", "turns = 0.5"), "objects[1].turns: moves, but the neighbour"),
    (beam("red", order="y"), "objects[0].order: 'y' is not one of depth, bsp, z"),
    (POLYGON + 'order = "bsp"\n', "objects[0].order: unknown field"),
    (beam("red", "size = 1000"), "objects[0].faces: a point is more than 2048 units from the mesh's origin"),
    (beam("red") + beam("red", "position = [5000, 0, 0]"),
     "objects[0].faces: a point is more than 2048 units from the middle of its tree"),
    (beam("red") + beam("red", "position = [1, 0, 0]").replace("points", "uvs = [[[0, 0], [1, 0], [1, 1]]]\npoints"),
     "objects[1].uvs[0]: must have 4 entries"),
    (beam("red") + "[[objects]]\npoints = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\nfaces = [[3, 4, 5]]\nmaterial = \"red\"\n"
     'order = "bsp"\nposition = [1, 0, 0]\n', "objects[1].faces[0][0]: there is no point 3"),
])
def test_bad_orders_are_one_line(tmp_path, text: str, said: str) -> None:
    with pytest.raises(UserError) as refused:
        make(tmp_path, text)
    assert said in str(refused.value) and "\n" not in str(refused.value)


def test_children_are_refused(tmp_path) -> None:
    text = beam("red", 'name = "arm"', order="depth") + beam("green", 'parent = "arm"')
    with pytest.raises(UserError, match=r'objects\[1\].order: "bsp" is for objects without a parent$'):
        make(tmp_path, text)


def test_faces_for_a_second_unit_are_refused(tmp_path) -> None:
    """They are polygons of the scene, in no mesh."""
    text = (SCENES / "glide_lightmap.toml").read_text().replace("[[objects]]", '[[objects]]\norder = "bsp"', 1)
    (tmp_path / "glide").symlink_to(SCENES / "glide")
    (tmp_path / "scene.toml").write_text(text)
    with pytest.raises(UserError, match=r"objects\[0\].order: material '\w+' has coordinates of a second unit"):
        compile_scene(tmp_path / "scene.toml", 1)


@pytest.mark.parametrize("table, row, column, value, said", [
    ("nodes", 0, 4, 3, r"nodes\[0\]: 3 nodes, but nodes\[1\] begins 2"),
    ("nodes", 0, 4, 6, r"nodes\[0\].front: 6 is not"), ("nodes", 0, 5, -1, r"nodes\[0\].back: -1 is not"),
    ("nodes", 1, 4, 0, r"nodes\[0\]: 2 nodes, but nodes\[1\] begins 1"),
    ("nodes", 2, 0, (1 << 30) + 1, r"nodes\[2\].x: 1073741825 is not"),
    ("nodes", 3, 6, 99, r"nodes\[3\].slot: 99 is not"), ("nodes", 4, 7, 65537, r"nodes\[4\].slots: \d+ is not"),
    ("slots", 5, 0, 12, r"slots\[5\].slot: 12 is not from 0 to 11")])
def test_wrong_trees_are_not_written(table: str, row: int, column: int, value: int, said: str) -> None:
    scene = mesh_cases.trees(1)
    scene_file.write(scene)
    getattr(scene, table)[row, column] = value
    with pytest.raises(UserError, match=said):
        scene_file.write(scene)


@pytest.mark.parametrize("which, field, value, said", [
    (0, "tree", 5, r"instances\[0\].tree: 5 is not from 0 to 0"), (1, "tree", 1, r"instances\[1\].tree: 1 is not"),
    (2, "tree", -1, "scene: nodes: 6 is not from 5 to 5"),
    (1, "slot", 13, r"instances\[1\].slot: 13 is not from 0 to 12")])
def test_instances_in_wrong_trees_are_not_written(which: int, field: str, value: int, said: str) -> None:
    scene = mesh_cases.trees(1)
    setattr(scene.instances[which], field, value)
    with pytest.raises(UserError, match=said):
        scene_file.write(scene)


def test_too_many_faces_are_refused(tmp_path) -> None:
    random = np.random.default_rng(1)
    points, faces = [], []
    for k in range(250):
        at, u, v = random.uniform(-8, 8, (3, 3)).round(3)
        points += [[float(c) for c in p] for p in (at, at + u, at + u + v, at + v)]
        faces.append([4 * k + n for n in range(4)])
    with pytest.raises(UserError, match=r"objects\[0\].order: \d+ (points|faces) with those that splits make; "
                                        "4096 at most"):
        make(tmp_path, f'[[objects]]\npoints = {points}\nfaces = {faces}\nmaterial = "red"\norder = "bsp"\n')


def test_faces_of_many_corners_are_cut(tmp_path) -> None:
    """A split face of 32 corners gets more, and becomes triangles."""
    ring = [[round(4 * float(np.cos(a)), 3), round(4 * float(np.sin(a)), 3), 0.0]
            for a in 2 * np.pi * (np.arange(32) + 0.3) / 32]
    made = make(tmp_path, f"""[[objects]]
points = {[[3.99, -5, -5], [3.99, 5, -5], [3.99, 5, 5], [3.99, -5, 5], *ring]}
faces = [[0, 1, 2, 3], {list(range(4, 36))}]
material = "red"
order = "bsp"
two_sided = true
""")
    assert made.faces[:, 5].max() <= 32 and len(made.faces) > 30
    assert sum(len(vertices) for _, vertices in mesh.polygons_at(made, 0)) > 90


def test_the_amiga_draws_the_models_frames(tmp_path) -> None:
    """Trees that stand still, move, come and go, with others between."""
    parts = beam("red", "turns = 0.3") + beam("green", "turns = 0.3", "first = 0", "last = 3")
    assert_models({"cross": make(tmp_path, CROSS),
                   "others": make(tmp_path, beam("red") + beam("green", "position = [0, 0.4, 0]", "first = 2") + POLYGON
                                  + beam("blue", "turns = 1") + beam("red", "rotation = [50, 50, 0]", order="depth")),
                   "moving": make(tmp_path, parts)})
