"""The pages' pictures are what the tree draws; tests/accuracy/test_methods.py has one more."""

import numpy as np
from PIL import Image

from tmap.base.paths import SCENES
from tmap.compiler import scene
from tmap.model import model
from tmap.report import readme


def test_picture_is_the_default_scenes() -> None:
    compiled = scene.compile_scene(SCENES / "default.toml", 1)
    shown = np.asarray(Image.open(readme.PICTURE).convert("RGB"))
    assert np.array_equal(shown, compiled.palette[model.render(compiled, 0)]), (
        "the README's picture is not the default scene's first frame: scripts/tmap readme")


def test_animation_is_the_knots() -> None:
    """The animation is every other frame of the scene, with fewer colours."""
    compiled = scene.compile_scene(SCENES / "environment.toml")
    colours, entries = readme.fewer_colours(compiled.palette, model.render(compiled, 0))
    with Image.open(readme.ANIMATION) as shown:
        assert shown.n_frames == compiled.frames // 2
        for k in range(shown.n_frames):
            shown.seek(k)
            assert np.array_equal(np.asarray(shown.convert("RGB")),
                                  colours[entries[model.render(compiled, 2 * k)]]), (
                f"frame {k} of the README's animation is not the knot's: scripts/tmap readme")
