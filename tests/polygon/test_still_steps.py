"""Affine polygons whose u or v is constant along a line: the same picture with cheaper spans."""

import json

import pytest

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tests.polygon.floors import FLOORS, turned
from tests.helpers.engine_scenes import compiled, save_noise
from tmap.base.paths import BASELINE
from tmap.bench import bench
from tmap.guest import guest_frames
from tmap.model import model

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


def a_little_more(corners: list[list[float]]) -> list[list[float]]:
    """Makes s and t grow by some units of 1/65536 a pixel, so that no step is 0."""
    return [[x, y, s + x / 4096, t + x / 4096] for x, y, s, t in corners]


#: The cheap span, and the change to FLOORS that makes it apply.
CHANGES = {"affine_row": list, "affine_column": turned}
#: 63 texels a pixel: too many for the cheap spans.
FAST = [[0, 0, 0, 0], [96, 0, 6048, 0], [96, 64, 6048, 99], [0, 64, 0, 99]]
#: The vertices of each frame, by (cheap span, material, name).
SHAPES = {(kind, material, name): change(shape) for kind, change in CHANGES.items()
          for material in MATERIALS for name, shape in FLOORS.items()} | {
    (kind, "plain", name): shape for kind, change in CHANGES.items()
    for name, shape in (("general", a_little_more(change(FLOORS["upright"]))),
                        ("fast", change(FAST)))}


@pytest.fixture(scope="module")
def drawn(tmp_path_factory) -> dict[tuple, tuple]:
    """For each of SHAPES: the model's frame, the guest's digest and figures, and the digest of the
    swap form; all from one boot."""
    folder = tmp_path_factory.mktemp("scene")
    save_noise(folder, 2, noise=(256, 256))
    text = HEAD.format(frames=len(SHAPES))
    for n, ((_, material, _), corners) in enumerate(SHAPES.items()):
        text += (f'[[objects]]\nmaterial = "{material}"\nfirst = {n}\nlast = {n}\n'
                 f"vertices = {corners}\n")
    scene = compiled(folder, text)
    addx, swap = guest_runs.draw([Asked(scene), Asked(scene, form="swap", counted=False)])
    frames = [model.render(scene, number) for number in range(scene.frames)]
    return dict(zip(SHAPES, zip(frames, addx.digests, addx.figures, swap.digests, strict=True),
                    strict=True))


@pytest.mark.parametrize("kind", CHANGES)
@pytest.mark.parametrize("material", MATERIALS)
def test_same_picture_by_the_cheap_span_alone(drawn, kind, material):
    """Both forms draw the model's picture; a polygon that is one texel in both directions is drawn
    as a row."""
    for name in FLOORS:
        key = kind, material, name
        expected, digest, figures, other = drawn[key]
        assert guest_frames.is_models(expected, digest), f"{key}: not the model's"
        assert guest_frames.is_models(expected, other), f"{key}, form swap: not the model's"
        used = "affine_row" if name == "one texel" else kind
        assert set(figures["spans"]) == {used}, (key, figures["spans"])


@pytest.mark.parametrize("row", CHANGES)
def test_cheaper(drawn, row):
    """Saves what the bench rows of shorter lines predict, less the cost of the test: some
    instructions a polygon."""
    cheap, general = (drawn[row, "plain", name][2] for name in ("upright", "general"))
    assert set(general["spans"]) == {"affine_addx"} and cheap["pixels"] == general["pixels"]
    rows = {bench.key(r): bench.cycles(r) for r in json.loads(BASELINE.read_text())["rows"]}
    saved = rows["affine_addx", "a1200-fast", 64] - rows[row, "a1200-fast", 64]
    less = general["cycles"] - cheap["cycles"]
    assert saved > 1.5 and less > saved * cheap["pixels"] - 100, (
        f"{row}: {less} cycles less; its bench rows say {saved:.1f} a pixel of {cheap['pixels']}")


def test_too_fast_for_it(drawn):
    """With too large a step the general spans draw the same picture."""
    for change in CHANGES:
        expected, digest, figures, _ = drawn[change, "plain", "fast"]
        assert guest_frames.is_models(expected, digest), f"{change}: not the model's"
        assert set(figures["spans"]) <= {"affine_addx", "affine_addx_wrap"}, (change, figures)
