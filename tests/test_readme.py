"""What the README shows is what the tree does."""

import numpy as np
from PIL import Image

from tools import model, readme, scene
from tools.paths import SCENES


def test_table_is_the_baselines() -> None:
    """The table of addx against swap was written by the tool from the committed figures."""
    text = readme.README.read_text()
    assert text == readme.with_tables(text), (
        "the README's table is not the baseline's: scripts/tmap readme")


def test_picture_is_the_default_scenes() -> None:
    """The frame shown is the one that is drawn."""
    compiled = scene.compile_scene(SCENES / "default.toml", 1)
    shown = np.asarray(Image.open(readme.PICTURE).convert("RGB"))
    assert np.array_equal(shown, compiled.palette[model.render(compiled, 0)]), (
        "the README's picture is not the default scene's first frame: scripts/tmap readme")


def test_animation_is_the_knots() -> None:
    """Its first frame is the one that is drawn, in its fewer colours, and it turns."""
    compiled = scene.compile_scene(SCENES / "environment.toml", 1)
    with Image.open(readme.ANIMATION) as shown:
        assert shown.n_frames == 20
        first = np.asarray(shown.convert("RGB"))
    frame = model.render(compiled, 0)
    colours, entries = readme.fewer_colours(compiled.palette, frame)
    assert np.array_equal(first, colours[entries[frame]]), (
        "the README's animation is not the knot's: scripts/tmap readme")
