"""Transparent texels: what the compiler makes of alpha and keys, and what the 68020 leaves in the frame."""

import numpy as np
import pytest
from PIL import Image

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tests.helpers.refusals import without_line
from tmap.base.errors import UserError
from tmap.compiler.scene import compile_scene
from tmap.model import mesh, model

HEAD = """\
width = 64
height = 64
frames = 1
background = "#0000ff"
[textures]
leaf = { image = "leaf.png", width = 32, height = 32 }
[materials]
leaf = { texture = "leaf", mapper = "keyed" }
"""
#: The picture, each texel two pixels wide and high.
SQUARE = """\
[[objects]]
material = "leaf"
vertices = [[0, 0, 0, 0], [64, 0, 256, 0], [64, 64, 256, 256], [0, 64, 0, 256]]
"""
TURNED = SQUARE.replace("[64, 0, 256, 0]", "[64, 0, 0, 256]").replace("[0, 64, 0, 256]", "[0, 64, 256, 0]")
BILLBOARD = """\
[camera]
eye = [3, 5, 9]
target = [0, 1, 0]
[[objects]]
material = "leaf"
billboard = [2, 3]
position = [0.5, 0, -1]
"""


def saved(folder, seed: int = 5) -> tuple[np.ndarray, np.ndarray]:
    """Saves a picture of black, red and transparent blocks; returns its colours, and which pixels are opaque."""
    rng = np.random.default_rng(seed)
    colours = np.zeros((32, 32, 3), np.uint8)
    colours[..., 0] = np.kron(rng.integers(0, 2, (8, 8)), np.ones((4, 4), int)) * 255
    alpha = np.kron(rng.choice((0, 127, 128, 255), (16, 16)), np.ones((2, 2), int)).astype(np.uint8)
    Image.fromarray(np.dstack([colours, alpha])).save(folder / "leaf.png")
    return colours, alpha >= 128


def made(folder, text: str):
    """Compiles a scene."""
    (folder / "scene.toml").write_text(text)
    return compile_scene(folder / "scene.toml")


def test_alpha_is_transparent_below_a_half(tmp_path):
    """Transparent texels are 0, and no opaque one is, black ones neither."""
    colours, opaque = saved(tmp_path)
    scene = made(tmp_path, HEAD + SQUARE)
    texels = scene.textures[scene.materials[0].texture].texels
    assert np.array_equal(texels != 0, opaque)
    assert (abs(scene.palette[texels][opaque].astype(int) - colours[opaque]) < 8).all()


def test_pixels_of_the_keys_colour_are_transparent(tmp_path):
    colours, _ = saved(tmp_path)
    Image.fromarray(colours).save(tmp_path / "leaf.png")
    scene = made(tmp_path, HEAD.replace("height = 32", 'height = 32, key = "#ff0000"') + SQUARE)
    texels = scene.textures[scene.materials[0].texture].texels
    assert np.array_equal(texels != 0, colours[..., 0] == 0)


def test_a_texture_may_be_keyed_and_plain(tmp_path):
    """The same picture as other materials draw it has no texel of 0."""
    saved(tmp_path)
    scene = made(tmp_path, HEAD + 'plain = { texture = "leaf" }\n' + SQUARE)
    plain = scene.textures[scene.materials[1].texture].texels
    assert len(scene.textures) == 2 and plain.all()


def test_the_background_shows_through(tmp_path):
    """On the 68020, of a picture twice as large, upright and on its side, with rules and without: each pixel by
    itself."""
    saved(tmp_path)
    asked, spans = {}, {}
    for text, name in ((SQUARE, "upright"), (TURNED, "turned")):
        scene = made(tmp_path, HEAD + text)
        texels = np.kron(scene.textures[scene.materials[0].texture].texels, np.ones((2, 2), np.uint8))
        texels = texels.T if text == TURNED else texels
        assert np.array_equal(model.render(scene, 0), np.where(texels, texels, scene.background))
        for off in (None, "opaque_rows", "all"):
            asked[name, off] = Asked(scene, off)
            rows = "keyed_row" if off else "keyed_rows"
            spans[name, off] = "keyed_wrap" if off == "all" else rows if name == "upright" else "keyed"
    drawn = guest_runs.check_all(asked, "a1200-fast")
    assert {key: each.spans for key, each in drawn.items()} == {key: {span} for key, span in spans.items()}


def test_billboards_face_the_camera(tmp_path):
    """All corners have one depth, and sides are upright and level on the screen, wherever the camera is."""
    saved(tmp_path)
    scene = made(tmp_path, HEAD + BILLBOARD)
    (_, vertices, _), = mesh.placed_at(scene, 0)
    x, y, _, _, _, w = np.array(vertices).T
    assert len(set(w.tolist())) == 1
    assert len(set(x.tolist())) == len(set(y.tolist())) == 2
    assert abs((y.max() - y.min()) / (x.max() - x.min()) - 1.5) < 0.001


@pytest.mark.parametrize("text, message", [
    (HEAD.replace("height = 32", 'height = 32, key = "#ff0000"').replace('mapper = "keyed"', 'mapper = "affine"')
     + SQUARE, 'textures.leaf.key: no material with mapper "keyed" has this texture'),
    (HEAD.replace("height = 32", 'height = 32, key = "red"') + SQUARE, "textures.leaf.key: must be"),
    (HEAD + BILLBOARD.replace("[2, 3]", "[2]"), "objects[0].billboard: must have 2 entries, not 1"),
    (HEAD + BILLBOARD.replace("[2, 3]", "[2, 0]"), "objects[0].billboard[1]: must be from 0.001 to 10000"),
    (HEAD + BILLBOARD + "rotation = [0, 1, 0]", "objects[0].rotation: unknown field"),
    (HEAD + BILLBOARD + "keys = [{ frame = 1, rotation = [0, 0, 0] }]",
     "objects[0].keys[0].rotation: a billboard always faces the camera"),
    (HEAD + BILLBOARD + 'mesh = "leaf.obj"', "objects[0]: needs exactly one of"),
    (HEAD + BILLBOARD.replace("[camera]\neye = [3, 5, 9]\ntarget = [0, 1, 0]\n", ""), "camera: is missing")])
def test_refused(tmp_path, text, message):
    saved(tmp_path)
    with pytest.raises(UserError) as refused:
        made(tmp_path, text)
    assert without_line(str(refused.value), tmp_path / "scene.toml").partition(": ")[2].startswith(message) \
        or message in str(refused.value)


def test_an_empty_picture_is_refused(tmp_path):
    Image.new("RGBA", (32, 32)).save(tmp_path / "leaf.png")
    with pytest.raises(UserError, match="leaf.png has no opaque pixel"):
        made(tmp_path, HEAD + SQUARE)
