"""The scenes of depth and effects: drawn as the model does, and what their report says."""

import numpy as np
import pytest
from PIL import Image

from tools import model, run, showcase
from tools.paths import SCENES
from tools.scene import compile_scene

FRAMES = {"cube": 2, "floor": 2, "corridor": 2, "environment": 1, "rotator": 2, "lit": 1,
          "shaded": 1}
#: Texels: every16 in the corridor may be off as far as its pieces are; the cube's affine
#: triangles are held to the plane.
WORST = {"cube": 1 / 16, "rotator": 1 / 128, "lit": 1 / 128, "environment": 1 / 128, "shaded": 1 / 128}


@pytest.mark.parametrize("name", showcase.NAMES)
def test_frames_are_the_models(name: str) -> None:
    """The first frames of each scene, bit for bit."""
    scene = compile_scene(SCENES / f"{name}.toml", FRAMES[name])
    frames, figures = run.render(scene, "a1200-fast", "addx")
    for number, frame in enumerate(frames):
        assert np.array_equal(frame, model.render(scene, number)), number
        assert len(np.unique(frame)) > 4
    assert all(figure["polygons"] for figure in figures)


def test_report_shows_each_scene(tmp_path, monkeypatch) -> None:
    """A table with figures, and an animation that moves; errors are within what settings promise."""
    monkeypatch.setattr(showcase, "compile_scene", lambda path: compile_scene(path, 3))
    text = showcase.write(tmp_path, "a1200-fast", names=("cube", "rotator"))
    assert len(text.splitlines()) == 4 and "rotator" in text
    for name in ("cube", "rotator"):
        with Image.open(tmp_path / f"{name}.gif") as moving:
            assert moving.n_frames == 3
    for name, worst in WORST.items():
        scene = compile_scene(SCENES / f"{name}.toml", 1)
        found = showcase.errors_of(scene)
        assert found.pixels > 1000 and found.worst < worst, (name, found.worst)
    assert "![cube](cube.gif)" in (tmp_path / "scenes.md").read_text()
