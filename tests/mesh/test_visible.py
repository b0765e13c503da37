"""Every pixel shows the nearest face, against what faces cover by the scene file's own numbers."""

import numpy as np
import pytest

from tests.mesh.test_orders import CROSS, make
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.ideal import visible

SQUARES = """
[[objects]]
points = [[-1, -1, {near}], [1, -1, {near}], [1, 1, {near}], [-1, 1, {near}]]
faces = [[0, 1, 2, 3]]
material = "red"
order = "{order}"
[[objects]]
points = [[-1, -1, -2], [1, -1, -2], [1, 1, -2], [-1, 1, -2]]
faces = [[0, 1, 2, 3]]
material = "blue"
order = "{order}"
"""


@pytest.mark.parametrize("name, step", [("keep", 8), ("rooms", 9), ("movers", 8), ("grove", 12)])
def test_scenes_show_the_nearest_faces(name: str, step: int) -> None:
    """Scenes with a right order, and ``grove``, whose plants stand apart, by depth."""
    scene = compile_scene(SCENES / f"{name}.toml")
    for number in range(step // 3, scene.frames, step):
        wrong = np.argwhere(visible.wrong(scene, number))
        assert not len(wrong), f"{name}, frame {number}: (y, x) {wrong[:8].tolist()}, {len(wrong)} in all"


def test_by_depth_some_are_wrong(tmp_path) -> None:
    scene = compile_scene(SCENES / "rooms.toml", order="depth")
    assert min(visible.wrong(scene, number).sum() for number in range(3, scene.frames, 9)) > 50
    crossed, right = (make(tmp_path, CROSS.replace("bsp", order)) for order in ("depth", "bsp"))
    assert [visible.wrong(right, k).sum() for k in range(6)] == [0] * 6
    assert max(visible.wrong(crossed, k).sum() for k in range(6)) > 50


@pytest.mark.parametrize("order", ("bsp", "depth", "z"))
def test_each_pixel_of_a_face_drawn_too_early_is_found(tmp_path, monkeypatch, order: str) -> None:
    """Two squares, drawn in the wrong order: the pixels are wrong that both cover."""
    scene = make(tmp_path, SQUARES.format(near=2, order=order))
    assert not visible.wrong(scene, 0).any()
    frame = visible.Frame(scene, 0)
    near, far = (frame.covered(face, frame.rays()) for face in sorted(frame.faces, key=lambda f: -f.height))
    steps = list(visible.steps_at(scene, 0))
    if order == "z":
        steps = [("begin", steps[0][1][:0], []), *(("draw", *step[1:]) for step in reversed(steps[1:]))]
    else:
        steps = [("draw", steps[0][1][::-1], [])]
    monkeypatch.setattr(visible, "steps_at", lambda *_: steps)
    wrong = visible.wrong(scene, 0)
    assert (near & far).sum() > 20 and (wrong >= near & far).all() and (wrong <= near).all()


def test_a_hole_is_wrong(tmp_path, monkeypatch) -> None:
    """A face that is not drawn: its pixels are wrong, whether another is behind them or none."""
    scene = make(tmp_path, SQUARES.format(near=2, order="bsp"))
    frame = visible.Frame(scene, 0)
    covered = [frame.covered(face, frame.rays()) for face in frame.faces]
    monkeypatch.setattr(visible, "steps_at", lambda *_: [])
    assert (visible.wrong(scene, 0) == covered[0] | covered[1]).all() and covered[0].sum() > 50
