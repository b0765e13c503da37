"""Affine polygons in frames of every format: the spans that rules select, and the example scenes of
16 and 32 bits."""

from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked, Drawn
from tests.helpers.engine_scenes import compiled, save_noise
from tmap.base.paths import SCENES
from tmap.base.pixel_formats import FORMATS
from tmap.compiler.scene import compile_scene
from tmap.fuzz import polygons
from tmap.guest import guest_frames
from tmap.model import model
from tmap.scene_file.scene_file import Material, Scene, Texture

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
it = {{texture = "wall", edges = "subpixel"}}
"""
#: Vertices [x, y, s, t] of upright pictures, one texel a pixel: inside the map, across its sides,
#: more than twice round it, mirrored in t.
COPIES = {
    "inside": [[3, 5, 10, 7], [90, 5, 97, 7], [90, 60, 97, 62], [3, 60, 10, 62]],
    "odd": [[3.5, 5.5, 10.25, 7], [90.5, 5.5, 97.25, 7], [90.5, 60.5, 97.25, 62],
            [3.5, 60.5, 10.25, 62]],
    "over the sides": [[2, 5, 222, 222], [91, 5, 311, 222], [91, 60, 311, 277], [2, 60, 222, 277]],
    "mirrored": [[0, 0, -30, 64], [96, 0, 66, 64], [96, 64, 66, 0], [0, 64, -30, 0]],
    "slanted": [[20, 0, 276, 0], [90, 0, 346, 0], [40, 64, 296, 64]],
}
KINDS = {"chunky": "affine", "rgb565": "affine_16", "rgba5551": "affine_16",
         "rgba8888": "affine_32"}
#: Endings of the spans in chunky frames; the span for rows also draws what is one texel.
CHUNKY = {"": "_addx", "_wrap": "_addx_wrap"}
GENERAL = {"affine_addx", "affine_addx_wrap"}

#: Vertices [x, y, s, t] of floors: t depends on y alone, so v is constant along a line.
FLOORS = {
    "upright": [[3.3, 5.2, 10, 7], [90.1, 5.2, 70, 7], [90.1, 60.7, 70, 40], [3.3, 60.7, 10, 40]],
    "mirrored": [[3, 5, 200, 90], [90, 5, 20, 90], [90, 60, 20, 40], [3, 60, 200, 40]],
    "over v's wrap": [[3, 5, 10, 200], [90, 5, 700, 200], [90, 60, 700, 310], [3, 60, 10, 310]],
    "62 texels a pixel": [[0, 0, 0, 0], [96, 0, 5951, 0], [96, 64, 5951, 99], [0, 64, 0, 99]],
    "beyond the frame": [[-40, -9, 5, 3], [150, -9, 250, 3], [99, 80, 250, 99]],
    "one texel": [[3, 5, 10, 7], [90, 5, 10, 7], [90, 60, 10, 7], [3, 60, 10, 7]],
}


def turned(corners: list[list[float]]) -> list[list[float]]:
    """Exchanges s and t."""
    return [[x, y, t, s] for x, y, s, t in corners]


WRAPPING = [[0, 0, 0, 0], [96, 0, 700, 900], [96, 64, 100, 1300], [0, 64, -600, 400]]
#: 63 texels a pixel along one axis alone: too many for the spans of chunky rows and columns.
FAST = [[0, 0, 0, 0], [96, 0, 6048, 0], [96, 64, 6048, 99], [0, 64, 0, 99]]
TURNING = [[10, 0, 20, 30], [90, 20, 99, 80], [70, 60, 80, 160], [-10, 40, 1, 110]]
#: Ending of a span's name: the shapes that it draws, one a frame.
SHAPES = {"_row": list(FLOORS.values()), "_copy": list(COPIES.values()), "_wrap": [WRAPPING],
          "": [TURNING]}
COLUMNS = [turned(corners) for name, corners in FLOORS.items() if name != "one texel"]
EXAMPLES = {"wide": {"fill_32", "affine_32", "affine_32_wrap", "affine_32_row",
                     "perspective_pieces"},
            "panel": {"fill_16", "affine_16", "affine_16_row", "affine_16_copy"}}


def spans_of(pixels: str) -> list[set[str]]:
    """The spans that may draw each shape: one, or for columns and fast ones, one of two."""
    kind, is_chunky = KINDS[pixels], pixels == "chunky"
    changed = CHUNKY if is_chunky else {"_copy": "_row"} if kind == "affine_32" else {}
    ends = [changed.get(end, end) for end, some in SHAPES.items() for _ in some]
    either = GENERAL if is_chunky else {kind, f"{kind}_wrap"}
    columns = {"affine_column"} if is_chunky else either
    return [*({kind + end} for end in ends), *[columns] * len(COLUMNS), either, either]


def shapes_text(pixels: str) -> str:
    """A scene of all shapes, one a frame, at last the fast ones."""
    shapes = [shape for some in SHAPES.values() for shape in some] + COLUMNS + [FAST, turned(FAST)]
    text = HEAD.format(frames=len(shapes), pixels=pixels)
    for n, corners in enumerate(shapes):
        text += f'[[objects]]\nmaterial = "it"\nfirst = {n}\nlast = {n}\nvertices = {corners}\n'
    return text


@pytest.fixture(scope="module")
def drawn(tmp_path_factory) -> dict[tuple, tuple[Asked, Drawn]]:
    """The scene of shapes by format and form, and by format on the other machine with no rule
    followed; the first frames of the examples by name. One boot a machine."""
    folder = tmp_path_factory.mktemp("scene")
    save_noise(folder, 2, noise=(256, 256))
    scenes = {pixels: compiled(folder, shapes_text(pixels)) for pixels in KINDS}
    asked = {(pixels, form): Asked(scene, form=form, counted=form == "addx") for pixels, scene in scenes.items()
             for form in ("addx", "swap", "c")}
    asked |= {(name,): Asked(compile_scene(SCENES / f"{name}.toml", 2)) for name in EXAMPLES}
    general = {(pixels, "a1200"): Asked(scene, "all") for pixels, scene in scenes.items()}
    found = guest_runs.draw([*asked.values()]) + guest_runs.draw([*general.values()], "a1200")
    return dict(zip([*asked, *general], zip([*asked.values(), *general.values()], found)))


@pytest.mark.parametrize("pixels", KINDS)
def test_spans_by_the_rules(drawn, pixels):
    """Rows, copies, turned and wrapping shapes are each drawn by their span and are the model's
    picture; so is the picture with no rule followed, on the other machine, and in the plain
    forms."""
    asked, done = drawn[pixels, "addx"]
    right = guest_runs.check(pixels, asked, done)
    for number, (figure, spans) in enumerate(zip(done.figures, spans_of(pixels), strict=True)):
        found = set(figure["spans"])
        assert set() < found <= spans, f"frame {number}: {found}, not {spans}"
    for form in ("swap", "c"):
        guest_runs.check(pixels, *drawn[pixels, form], expected=right)
    asked, done = drawn[pixels, "a1200"]
    guest_runs.check(pixels, asked, done, "a1200", right)
    assert done.spans == {f"{KINDS[pixels]}_{'addx_' * (pixels == 'chunky')}wrap"}


def widened(scene: Scene, pixels: str) -> Scene:
    """A fuzzed scene in another format; textured materials become affine ones."""
    pixel, noise = FORMATS[pixels], np.random.default_rng(5)
    pages = [Texture(noise.integers(0, 256**pixel.bytes, each.texels.shape, dtype=pixel.dtype))
             for each in scene.textures if each.layout == "page"]
    materials = [m if m.mapper == "flat" else
                 Material("affine", m.edges, m.gradients, m.start, m.clip, m.perspective,
                          texture=k % len(pages), tolerance=m.tolerance)
                 for k, m in enumerate(scene.materials)]
    return replace(scene, format=pixels, textures=pages, materials=materials)


#: Formats of fuzzed polygons, and the forms that draw them.
FUZZED_FORMS = (("rgb565", "addx"), ("rgba8888", "addx"), ("rgba8888", "swap"))


@pytest.fixture(scope="module")
def fuzzed() -> dict[str, list[tuple[Scene, list[tuple[int, int]]]]]:
    """The fuzzer's scenes and the digests of the model's frames, by format."""
    found = {pixels: [] for pixels, _ in FUZZED_FORMS}
    for block in range(FUZZED_BLOCKS):
        some = [polygons.polygon(SEED, block * polygons.BLOCK + k)
                for k in range(FUZZED)]
        for pixels, scenes in found.items():
            scene = widened(polygons.scene(SEED, block, some), pixels)
            scenes.append((scene, [guest_frames.digest_of(model.render(scene, k)) for k in range(FUZZED)]))
    return found


@pytest.fixture(scope="module")
def fuzzed_digests(fuzzed) -> dict[tuple[str, str, int], np.ndarray]:
    """The guest's digests by format, form and block, from one boot."""
    asked = {(pixels, form, block): (scene, form) for pixels, form in FUZZED_FORMS
             for block, (scene, _) in enumerate(fuzzed[pixels])}
    return dict(zip(asked, guest_frames.draw([*asked.values()], "a1200-fast", timed=False), strict=True))


@pytest.mark.parametrize("pixels, form", FUZZED_FORMS)
def test_fuzzed_polygons(pixels: str, form: str, fuzzed, fuzzed_digests) -> None:
    """The fuzzer's polygons with their settings are the model's frames, or are refused if they must
    be."""
    for block, (scene, right) in enumerate(fuzzed[pixels]):
        digests = fuzzed_digests[pixels, form, block]
        wrong = [number for number, (wanted, digest) in enumerate(zip(right, digests, strict=True))
                 if (digest["sum"], digest["hash"]) != wanted]
        assert not wrong, (f"seed {SEED}, block {block}, form {form}, {pixels}: polygons {wrong}; "
                           f"{scene.materials[scene.objects[wrong[0]].material]}")


@pytest.mark.parametrize("name", EXAMPLES)
def test_example_scenes(name: str, drawn) -> None:
    """The first frames of each are the model's and show many colours."""
    asked, done = drawn[name,]
    for number, frame in enumerate(guest_runs.check(name, asked, done)):
        assert len(np.unique(frame)) > 1000, f"frame {number}"
    assert done.spans == EXAMPLES[name]
