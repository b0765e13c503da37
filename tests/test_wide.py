"""Affine polygons in 16- and 32-bit frames: their spans by the rules, and the example scenes."""

import json
from dataclasses import replace

import numpy as np
import pytest

from test_still_steps import FLOORS, folder, turned  # noqa: F401
from tools import fuzz_polygons, guest_frames, model, run
from tools.__main__ import main
from tools.paths import SCENES
from tools.pixel_formats import FORMATS
from tools.scene import compile_scene
from tools.scene_file import Material, Scene, Texture

SEED, FUZZED_BLOCKS, FUZZED = 9, 3, 300

HEAD = """\
width = 96
height = 64
frames = {frames}
format = "{pixels}"
background = "#102030"
[textures]
wall.image = "noise.png"
[materials]
it = {{texture = "wall"}}
"""
#: Vertices [x, y, s, t] of upright pictures, a texel a pixel: inside the map, over its sides, more
#: than twice round it, mirrored in t.
COPIES = {
    "inside": [[3, 5, 10, 7], [90, 5, 97, 7], [90, 60, 97, 62], [3, 60, 10, 62]],
    "odd": [[3.5, 5.5, 10.25, 7], [90.5, 5.5, 97.25, 7], [90.5, 60.5, 97.25, 62],
            [3.5, 60.5, 10.25, 62]],
    "over the sides": [[2, 5, 222, 222], [91, 5, 311, 222], [91, 60, 311, 277], [2, 60, 222, 277]],
    "mirrored": [[0, 0, -30, 64], [96, 0, 66, 64], [96, 64, 66, 0], [0, 64, -30, 0]],
    "slanted": [[20, 0, 276, 0], [90, 0, 346, 0], [40, 64, 296, 64]],
}
KINDS = {"rgb565": "affine_16", "rgba5551": "affine_16", "rgba8888": "affine_32"}


def drawn(folder, pixels: str, shapes, *options: str):  # noqa: F811
    """Compiled, dumps and figures of one shape a frame."""
    text = HEAD.format(frames=len(shapes), pixels=pixels)
    for n, corners in enumerate(shapes):
        text += f'[[objects]]\nmaterial = "it"\nfirst = {n}\nlast = {n}\nvertices = {corners}\n'
    (folder / "scene.toml").write_text(text)
    assert main(["run", str(folder / "scene.toml"), "-o", str(folder / "out"), *options]) == 0
    frames = [path.read_bytes() for path in sorted((folder / "out").glob("*.chunky"))]
    return (compile_scene(folder / "scene.toml"), frames,
            json.loads((folder / "out" / "run.json").read_text())["frames"])


@pytest.mark.parametrize("pixels", KINDS)
def test_spans_by_the_rules(folder, pixels):  # noqa: F811
    """Rows, copies, what turns and what wraps: each by its span, and the model's picture; the same
    with no rule followed, on the other machine, and in the plain forms."""
    kind = KINDS[pixels]
    wrapping = [[0, 0, 0, 0], [96, 0, 700, 900], [96, 64, 100, 1300], [0, 64, -600, 400]]
    turning = [[10, 0, 20, 30], [90, 20, 99, 80], [70, 60, 80, 160], [-10, 40, 1, 110]]
    shapes = {"_row": list(FLOORS.values()), "_copy": list(COPIES.values()), "_wrap": [wrapping],
              "": [turning, turned(FLOORS["upright"])]}
    wanted = [kind + ("_row" if (kind, end) == ("affine_32", "_copy") else end)
              for end, some in shapes.items() for _ in some]
    every = [shape for some in shapes.values() for shape in some]
    scene, frames, figures = drawn(folder, pixels, every)
    right = [model.render(scene, number) for number in range(len(every))]
    big_endian = scene.pixel.dtype.newbyteorder(">")
    for number, (frame, figure) in enumerate(zip(frames, figures, strict=True)):
        assert frame == right[number].astype(big_endian).tobytes(), number
        assert set(figure["spans"]) == {wanted[number]}, (number, figure["spans"])
    _, others, general = drawn(folder, pixels, every, "--off", "all", "--machine", "a1200")
    assert others == frames and {k for f in general for k in f["spans"]} == {f"{kind}_wrap"}
    forms = "swap", "c"
    for form, digests in zip(forms, guest_frames.draw([(scene, form) for form in forms], "a1200-fast")):
        for number, (frame, digest) in enumerate(zip(right, digests, strict=True)):
            assert guest_frames.is_models(frame, digest), f"form {form}, frame {number}"


def widened(scene: Scene, pixels: str) -> Scene:
    """A fuzzed scene in another format: what has a texture is drawn by the affine mapper."""
    pixel, noise = FORMATS[pixels], np.random.default_rng(5)
    pages = [Texture(noise.integers(0, 256**pixel.bytes, each.texels.shape, dtype=pixel.dtype))
             for each in scene.textures if each.layout == "page"]
    materials = [m if m.mapper == "flat" else
                 Material("affine", m.edges, m.gradients, m.start, m.clip, texture=k % len(pages))
                 for k, m in enumerate(scene.materials)]
    return replace(scene, format=pixels, textures=pages, materials=materials)


def fuzzed(pixels: str) -> list[tuple[Scene, list[tuple[int, int]]]]:
    """The fuzzer's scenes in a format, and the digests of the model's frames."""
    scenes = []
    for block in range(FUZZED_BLOCKS):
        some = [fuzz_polygons.polygon(SEED, block * fuzz_polygons.BLOCK + k)
                for k in range(FUZZED)]
        scene = widened(fuzz_polygons.scene(SEED, block, some), pixels)
        scenes.append((scene, [guest_frames.digest_of(model.render(scene, k)) for k in range(FUZZED)]))
    return scenes


@pytest.mark.parametrize("pixels, forms", [("rgb565", ["addx"]), ("rgba8888", ["addx", "swap"])])
def test_fuzzed_polygons(pixels: str, forms: list[str]) -> None:
    """The fuzzer's polygons with their settings: the model's frames, refused where they must be."""
    made = [(form, block, *each) for form in forms for block, each in enumerate(fuzzed(pixels))]
    drawn = guest_frames.draw([(scene, form) for form, _, scene, _ in made], "a1200-fast")
    for (form, block, scene, right), digests in zip(made, drawn, strict=True):
        wrong = [number for number, (wanted, digest) in enumerate(zip(right, digests, strict=True))
                 if (digest["sum"], digest["hash"]) != wanted]
        assert not wrong, (f"seed {SEED}, block {block}, form {form}: polygons {wrong}; "
                           f"{scene.materials[scene.objects[wrong[0]].material]}")


@pytest.mark.parametrize("name, spans", [
    ("wide", {"fill_32", "affine_32", "affine_32_wrap", "affine_32_row"}),
    ("panel", {"fill_16", "affine_16", "affine_16_row", "affine_16_copy"})])
def test_example_scenes(name: str, spans: set[str]) -> None:
    """The first frames of each are the model's and show many colours."""
    scene = compile_scene(SCENES / f"{name}.toml", 2)
    done = run.render(scene, "a1200-fast", "addx")
    for number, frame in enumerate(done.frames):
        assert np.array_equal(frame, model.render(scene, number)), number
        assert len(np.unique(frame)) > 1000
    assert set(run.total(done.figures)["spans"]) == spans
