"""The rotator and the lit scene: as the model has them, and what they need of it."""

import json

import numpy as np
import pytest

from tools import bench_effects, model
from tools.__main__ import main
from tools.paths import SCENES
from tools.scene import compile_scene


def run(name: str, frames: int, out):
    """A scene of the tests, its first frames as the machine draws them, and their figures."""
    assert main(["run", str(SCENES / f"{name}.toml"), "-o", str(out), "--frames", str(frames)]) == 0
    scene = compile_scene(SCENES / f"{name}.toml", frames)
    found = [np.fromfile(out / f"frame_{n:03}.chunky", np.uint8).reshape(256, 320)
             for n in range(frames)]
    for number, frame in enumerate(found):
        assert (frame == model.render(scene, number)).all(), number
    return scene, found, json.loads((out / "run.json").read_text())["frames"]


def test_rotator(tmp_path):
    """It covers the screen at every angle; the spans are chosen by the steps alone."""
    scene, frames, figures = run("rotator", 24, tmp_path)
    kinds = [set(figure["spans"]) for figure in figures]
    assert kinds[0] == {"affine_row"} and kinds[16] == {"affine_column"}
    assert all(kind in ({"affine_addx"}, {"affine_addx_wrap"}) for n, kind in enumerate(kinds)
               if n % 16)
    assert {"affine_addx"} in kinds and {"affine_addx_wrap"} in kinds
    assert all(figure["pixels"] == 320 * 256 for figure in figures)


def test_lit_scene(tmp_path):
    """A panel has one level; the disc is bright in its middle and darker around it."""
    scene, frames, figures = run("lit", 2, tmp_path)
    assert set(figures[0]["spans"]) == {"lit", "lit_gouraud"}
    shown = scene.palette[frames[0]].astype(int).sum(axis=2)
    panels = [shown[:16, 40 * k:40 * k + 40].mean() for k in range(8)]
    assert panels[:4] == sorted(panels[:4]) and panels[4:] == sorted(panels[4:], reverse=True)
    light = scene.textures[scene.materials[0].light].texels
    assert (light[63] == np.arange(256)).all()


@pytest.mark.parametrize("name, most", [("rotator", 0), ("rotator_wrap", 0), ("rotator_swap", 0),
                                        ("rotator_generated", 1)])
def test_rotators_texels(name, most):
    """All are exact but generated code, that shows the texel beside in most pixels: by one in
    u and v, and a row further where u leaves the map."""
    kernel, _, steps = bench_effects.ROTATORS[name]
    found, exact = (bench_effects.screen(k, steps) for k in (kernel, "exact"))
    if not most:
        assert (found == exact).all() and bench_effects.wrong_texels(kernel, steps) == 0
        return
    assert 0.5 < bench_effects.wrong_texels(kernel, steps) < 0.9
    u, v = (abs(((found >> shift) - (exact >> shift) + 128 & 0xFF) - 128) for shift in (0, 8))
    assert u.max() == 1 and v.max() <= 2
