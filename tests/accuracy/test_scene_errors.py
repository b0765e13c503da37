"""The scenes of depth and effects: their report has the right figures. The bench refuses frames
that are not the model's (tests/accuracy/test_bench.py)."""

import numpy as np
import pytest
from PIL import Image

from tmap.accuracy import scene_errors
from tmap.base.paths import SCENES
from tmap.bench import scenes
from tmap.compiler.scene import compile_scene
from tmap.ideal import bounds
from tmap.model import model
from tmap.model.mesh import polygons_at

def test_bench_draws_each_scene() -> None:
    assert set(scene_errors.NAMES) <= set(scenes.NAMES)


def test_report_shows_each_scene(tmp_path, monkeypatch) -> None:
    """The report has a table with figures, and an animation in which something moves."""
    monkeypatch.setattr(scene_errors, "compile_scene", lambda path: compile_scene(path, 3))
    text = scene_errors.write(tmp_path, "a1200-fast", names=("cube", "rotator"))
    assert len(text.splitlines()) == 4 and "rotator" in text
    for name in ("cube", "rotator"):
        with Image.open(tmp_path / f"{name}.gif") as moving:
            assert moving.n_frames == 3
    assert "![cube](cube.gif)" in (tmp_path / "scenes.md").read_text()


@pytest.mark.parametrize("name", scene_errors.NAMES)
def test_errors_are_within_derived_bounds(name: str) -> None:
    """Every polygon of a frame is within the bounds of its settings; the report's figure is the
    largest error found. The frame has more than a few colours."""
    scene, total = compile_scene(SCENES / f"{name}.toml", 1), bounds.Verdict()
    for which, vertices in polygons_at(scene, 0):
        material = scene.materials[which]
        settings = model.Settings.of(material)
        size = scene.textures[material.texture].texels.shape[::-1] if material.texture >= 0 else (256, 256)
        adapted = model.adapt(vertices, settings, max(size))
        if bounds.has_ideal(adapted, settings):
            polygon = model.prepare_polygon(scene, which, vertices)
            total.merge(bounds.check_set_up(adapted, polygon, settings, scene.width, scene.height,
                                            size))
    assert not total.complaint and total.texel_ratio > 0.1
    assert len(np.unique(model.render(scene, 0))) > 4
    found = scene_errors.errors_of(scene)
    assert found.pixels > 1000
    if {m.gradients for m in scene.materials} == {"plane"}:  # otherwise the ideal is not the plane
        assert found.worst <= total.texel_error + 2**-24
