"""The scene file's ``pixel``: the same picture of fewer, larger pixels, each with the colour of its upper left one."""

import re

import numpy as np
import pytest

from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.compiler.space import SIZES
from tmap.model import model
from tmap.run.run import picture_of
from tmap.scene_file.scene_file import IDENTITY

FRAME = 1
#: Scenes in space and on the screen, turned objects and still ones, whose pixels ask for no level of detail and no
#: pattern of the screen.
SCENES_SAME = ("corridor", "cube", "default", "face", "floor", "grove", "lit", "n64_wall", "rotator")
PLAIN = '''width = 64
height = 48
frames = 2
background = "#102030"
{pixel}
[materials]
red = {{ colour = "#c02020" }}
'''
STILL = '''[[objects]]
material = "red"
vertices = [[8, 4], [56, 4], [56, 40], [8, 40]]
'''


@pytest.mark.parametrize("pixel", [pixel for pixel in SIZES if pixel != "1x1"])
@pytest.mark.parametrize("name", SCENES_SAME)
def test_larger_pixels_are_samples_of_the_picture(name: str, pixel: str) -> None:
    """Pixels on a texel's border or an edge may round the other way, and pieces of perspective are longer: below one
    in a hundred."""
    whole = compile_scene(SCENES / f"{name}.toml", FRAME + 1)
    large = compile_scene(SCENES / f"{name}.toml", FRAME + 1, keys={"pixel": pixel})
    across, down = SIZES[pixel]
    assert (large.width * across, large.height * down) == (whole.width, whole.height)
    full, found = model.render(whole, FRAME), model.render(large, FRAME)
    assert len(np.unique(found)) > 1
    assert (found != full[::down, ::across]).mean() < 0.01
    assert picture_of(found, large).size == (whole.width, whole.height)


def made(tmp_path, pixel: str, objects: str = STILL):
    """The scene of a file."""
    path = tmp_path / "scene.toml"
    path.write_text(PLAIN.format(pixel=pixel and f'pixel = "{pixel}"') + objects)
    return compile_scene(path)


def test_what_is_not_turned_needs_no_pose(tmp_path) -> None:
    """Its corners are moved themselves, so that its frames cost nothing more."""
    large = made(tmp_path, "2x1")
    assert (large.width, large.height, large.pixel_width, large.pixel_height) == (32, 48, 2, 1)
    assert large.poses.tolist() == [list(IDENTITY)] * len(large.poses)
    assert (large.vertices[:, :2] >> 16).tolist() == [[4, 4], [28, 4], [28, 40], [4, 40]]


def test_pixels_are_1x1_unless_a_scene_says_so(tmp_path) -> None:
    """A scene's file is the same, with and without the word."""
    plain, said = made(tmp_path, ""), made(tmp_path, "1x1")
    assert (plain.pixel_width, plain.pixel_height) == (said.pixel_width, said.pixel_height) == (1, 1)
    assert np.array_equal(plain.vertices, said.vertices)


@pytest.mark.parametrize("change, message", [
    ('pixel = "3x1"', "pixel: '3x1' is not one of 1x1, 2x1, 1x2, 2x2"),
    ('pixel = "2x1"\nwidth = 60', "width: 60 is not a multiple of 8, with pixels of 2x1"),
    ('pixel = "1x2"\nheight = 47', "height: 47 is not a multiple of 2, with pixels of 1x2")])
def test_bad_sizes_are_refused(tmp_path, change: str, message: str) -> None:
    text = PLAIN.format(pixel=change.partition("\n")[0]) + STILL
    name, _, value = change.partition("\n")[2].partition(" = ")
    text = re.sub(f"{name} = [0-9]+", f"{name} = {value}", text, count=1) if name else text
    path = tmp_path / "scene.toml"
    path.write_text(text)
    with pytest.raises(UserError, match=message):
        compile_scene(path)


def test_texture_rectangles_need_pixels_of_1x1() -> None:
    with pytest.raises(UserError, match=r"objects\[\d+\].rectangle: has steps a pixel of 1x1, but the scene's are 2x2"):
        compile_scene(SCENES / "n64_rectangles.toml", keys={"pixel": "2x2"})
