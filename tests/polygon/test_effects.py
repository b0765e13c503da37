"""The rotator and the lit scene: they equal the model's, and have the features they are meant to
show."""

import numpy as np

from tests.helpers.engine_scenes import explain, run_command
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.model import model
from tmap.run import run
from tmap.scene_file.scene_file import Scene


def drawn(name: str, frames: int) -> tuple[Scene, run.Rendered]:
    """Draws the first frames of one of the tests' scenes on the machine, and checks that they are
    the model's."""
    scene = compile_scene(SCENES / f"{name}.toml", frames)
    done = run.render(scene, "a1200-fast", "addx")
    for number, found in enumerate(done.frames):
        expected = model.render(scene, number)
        assert np.array_equal(found, expected), explain(
            f"{name}, frame {number}", expected, found, run_command(name, frames, None))
    return scene, done


def test_rotator() -> None:
    """The rotator covers the screen at every angle, and the spans depend only on the steps."""
    figures = drawn("rotator", 24)[1].figures
    kinds = [set(figure["spans"]) for figure in figures]
    assert kinds[0] == {"affine_row"} and kinds[16] == {"affine_column"}
    assert all(kind in ({"affine_addx"}, {"affine_addx_wrap"}) for n, kind in enumerate(kinds)
               if n % 16)
    assert {"affine_addx"} in kinds and {"affine_addx_wrap"} in kinds
    assert all(figure["pixels"] == 320 * 256 for figure in figures)


def test_lit_scene() -> None:
    """Eight panels along the top have one level each, ever brighter, then ever darker; the disc's
    levels change within its spans."""
    scene, done = drawn("lit", 1)
    assert set(done.figures[0]["spans"]) == {"lit", "lit_gouraud"}
    shown = scene.palette[done.frames[0]].astype(int).sum(axis=2)
    panels = [shown[:16, 40 * k:40 * k + 40].mean() for k in range(8)]
    assert panels[:4] == sorted(panels[:4]) and panels[4:] == sorted(panels[4:], reverse=True)
    light = scene.textures[scene.materials[0].light].texels
    assert (light[63] == np.arange(256)).all()
