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
plain = {{texture = "wall"}}
truncated = {{texture = "wall", edges = "exact", start = "truncated"}}
"""
MATERIALS = ("plain", "truncated")
#: Polygons: vertices [x, y, s, t] where s or t depends on y alone.
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


#: The cheap span, and what makes a floor of FLOORS one that it draws.
CHANGES = {"affine_row": list, "affine_column": turned}
#: 63 texels a pixel: too many.
FAST = [[0, 0, 0, 0], [96, 0, 6048, 0], [96, 64, 6048, 99], [0, 64, 0, 99]]
#: What each frame shows, vertices by change, material and name.
SHAPES = {(kind, material, name): change(shape) for kind, change in CHANGES.items()
          for material in MATERIALS for name, shape in FLOORS.items()} | {
    (kind, "plain", name): shape for kind, change in CHANGES.items()
    for name, shape in (("general", a_little_more(change(FLOORS["upright"]))),
                        ("fast", change(FAST)))}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A directory with a picture, noise.png."""
    made = tmp_path_factory.mktemp("scene")
    noise = np.random.default_rng(2).integers(0, 256, (256, 256, 3)).astype(np.uint8)
    Image.fromarray(noise).save(made / "noise.png")
    return made


def run(folder, form: str) -> tuple[dict[tuple, bytes], dict[tuple, dict]]:
    """The dump and the figures of each of SHAPES, drawn in one boot."""
    out = folder / f"out-{form}"
    assert main(["run", str(folder / "scene.toml"), "-o", str(out), "--form", form]) == 0
    frames = [path.read_bytes() for path in sorted(out.glob("*.chunky"))]
    figures = json.loads((out / "run.json").read_text())["frames"]
    return dict(zip(SHAPES, frames, strict=True)), dict(zip(SHAPES, figures, strict=True))


@pytest.fixture(scope="module")
def drawn(folder):
    """The model's frames of SHAPES, and what ``run`` gives in both forms."""
    text = HEAD.format(frames=len(SHAPES))
    for n, ((_, material, _), corners) in enumerate(SHAPES.items()):
        text += (f'[[objects]]\nmaterial = "{material}"\nfirst = {n}\nlast = {n}\n'
                 f"vertices = {corners}\n")
    (folder / "scene.toml").write_text(text)
    scene = compile_scene(folder / "scene.toml")
    expected = {key: model.render(scene, n).tobytes() for n, key in enumerate(SHAPES)}
    return expected, run(folder, "addx"), run(folder, "swap")


@pytest.mark.parametrize("kind", CHANGES)
@pytest.mark.parametrize("material", MATERIALS)
def test_same_picture_by_the_cheap_span_alone(drawn, kind, material):
    expected, (frames, figures), (others, _) = drawn
    for name in FLOORS:
        key = kind, material, name
        assert frames[key] == expected[key], key
        used = "affine_row" if name == "one texel" else kind
        assert set(figures[key]["spans"]) == {used}, (key, figures[key]["spans"])
        assert others[key] == expected[key], key


@pytest.mark.parametrize("row", CHANGES)
def test_cheaper(drawn, row):
    """By what the bench rows of shorter lines differ, but for finding it out: some instructions a polygon."""
    _, (_, figures), _ = drawn
    cheap, general = (figures[row, "plain", name] for name in ("upright", "general"))
    assert set(general["spans"]) == {"affine_addx"} and cheap["pixels"] == general["pixels"]
    rows = {bench.key(r): bench.cycles(r) for r in json.loads(BASELINE.read_text())["rows"]}
    saved = rows["affine_addx", "a1200-fast", 64] - rows[row, "a1200-fast", 64]
    assert saved > 1.5 and general["cycles"] - cheap["cycles"] > saved * cheap["pixels"] - 100


def test_too_fast_for_it(drawn):
    """The general spans, the same picture."""
    expected, (frames, figures), _ = drawn
    for change in CHANGES:
        key = change, "plain", "fast"
        assert frames[key] == expected[key], key
        assert set(figures[key]["spans"]) <= {"affine_addx", "affine_addx_wrap"}, key
