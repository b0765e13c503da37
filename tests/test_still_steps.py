"""Affine polygons whose u or v stands still along a line: the same picture, cheaper spans."""

import json

import numpy as np
import pytest
from PIL import Image

from tools import bench, model
from tools.__main__ import main
from tools.paths import BASELINE
from tools.scene import compile_scene

HEAD = """\
width = 96
height = 64
frames = {frames}
background = "#102030"
[textures]
wall.image = "noise.png"
[materials]
"""
#: What each frame shows: vertices [x, y, s, t] where s or t depends on y alone.
FLOORS = {
    "upright": [[3.3, 5.2, 10, 7], [90.1, 5.2, 70, 7], [90.1, 60.7, 70, 40], [3.3, 60.7, 10, 40]],
    "mirrored": [[3, 5, 200, 90], [90, 5, 20, 90], [90, 60, 20, 40], [3, 60, 200, 40]],
    "over v's wrap": [[3, 5, 10, 200], [90, 5, 700, 200], [90, 60, 700, 310], [3, 60, 10, 310]],
    "62 texels a pixel": [[0, 0, 0, 0], [96, 0, 5951, 0], [96, 64, 5951, 99], [0, 64, 0, 99]],
    "beyond the frame": [[-40, -9, 5, 3], [150, -9, 250, 3], [99, 80, 250, 99], [-3, 80, 5, 99]][:3],
    "one texel": [[3, 5, 10, 7], [90, 5, 10, 7], [90, 60, 10, 7], [3, 60, 10, 7]],
}


def turned(corners: list[list[float]]) -> list[list[float]]:
    """s and t changed over."""
    return [[x, y, t, s] for x, y, s, t in corners]


def a_little_more(corners: list[list[float]]) -> list[list[float]]:
    """s and t that grow by some units of 1/65536 a pixel: no step is 0."""
    return [[x, y, s + x / 4096, t + x / 4096] for x, y, s, t in corners]


def run(folder, shapes, settings: str = "", form: str = "addx"):
    """The scene, its frames and figures, one shape a frame."""
    text = HEAD.format(frames=len(shapes)) + f'it = {{texture = "wall"{settings}}}\n'
    for n, corners in enumerate(shapes):
        text += f'[[objects]]\nmaterial = "it"\nfirst = {n}\nlast = {n}\nvertices = {corners}\n'
    (folder / "scene.toml").write_text(text)
    out = folder / f"out-{form}"
    assert main(["run", str(folder / "scene.toml"), "-o", str(out), "--form", form]) == 0
    frames = [path.read_bytes() for path in sorted(out.glob("*.chunky"))]
    return (compile_scene(folder / "scene.toml"), frames,
            json.loads((out / "run.json").read_text())["frames"])


@pytest.fixture
def folder(tmp_path):
    noise = np.random.default_rng(2).integers(0, 256, (256, 256, 3)).astype(np.uint8)
    Image.fromarray(noise).save(tmp_path / "noise.png")
    return tmp_path


@pytest.mark.parametrize("kind, change", [("affine_row", list), ("affine_column", turned)])
@pytest.mark.parametrize("settings", ["", ', edges = "exact", start = "truncated"'])
def test_same_picture_by_the_cheap_span_alone(folder, kind, change, settings):
    shapes = [change(shape) for shape in FLOORS.values()]
    scene, frames, figures = run(folder, shapes, settings)
    assert frames == [model.render(scene, n).tobytes() for n in range(len(shapes))]
    for name, frame in zip(FLOORS, figures):
        used = "affine_row" if name == "one texel" else kind
        assert set(frame["spans"]) == {used}, (name, frame["spans"])
    assert run(folder, shapes, settings, "swap")[1] == frames


@pytest.mark.parametrize("change, row", [(list, "affine_row"), (turned, "affine_column")])
def test_cheaper(folder, change, row):
    """By what the bench rows of shorter lines differ, but for finding it out: some instructions a polygon."""
    shapes = [change(FLOORS["upright"]), a_little_more(change(FLOORS["upright"]))]
    _, _, (cheap, general) = run(folder, shapes)
    assert set(general["spans"]) == {"affine_addx"} and cheap["pixels"] == general["pixels"]
    figures = {bench.key(r): bench.cycles(r) for r in json.loads(BASELINE.read_text())["rows"]}
    saved = figures["affine_addx", "a1200-fast", 64] - figures[row, "a1200-fast", 64]
    assert saved > 1.5 and general["cycles"] - cheap["cycles"] > saved * cheap["pixels"] - 100


def test_too_fast_for_it(folder):
    """63 texels a pixel: the general spans, the same picture."""
    fast = [[0, 0, 0, 0], [96, 0, 6048, 0], [96, 64, 6048, 99], [0, 64, 0, 99]]
    scene, frames, figures = run(folder, [fast, turned(fast)])
    assert frames == [model.render(scene, n).tobytes() for n in range(2)]
    assert all(kind in ("affine_addx", "affine_addx_wrap") for f in figures for kind in f["spans"])
