"""The pictures of the pages are what the tree draws."""

import json

import numpy as np
import pytest
from PIL import Image

from tmap.accuracy import methods, showcase
from tmap.base.paths import SCENES
from tmap.compiler import scene
from tmap.guest import guest_frames
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.model import model
from tmap.report import readme


def test_picture_is_the_default_scenes() -> None:
    """The frame shown is the one that is drawn."""
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


def test_methods_are_as_the_picture_shows_them() -> None:
    """The picture's frames, and the cycles and errors stored in it as text, are the current
    ones."""
    scenes = {name: methods.scene_of(settings) for name, settings in methods.METHODS.items()}
    drawn = guest_frames.draw([(each, "addx") for each in scenes.values()], "a1200-fast")
    made = []
    for (name, each), digests in zip(scenes.items(), drawn):
        frames = [each.palette[model.render(each, k)] for k in range(methods.SHOWN + 1)]
        cycles = int(digests["ticks"].astype(int).sum()) * CYCLES_PER_TICK / each.frames
        errors = showcase.errors_of(each, 1, True)
        made.append(methods.Method(name, np.stack(frames), cycles, errors))
    with Image.open(readme.METHODS) as picture:
        shown = json.loads(picture.text["Description"])
    again = "the README's picture of methods is not today's: scripts/tmap readme"
    for name, figures in methods.described(made).items():
        assert shown[name].pop("cycles") == pytest.approx(figures.pop("cycles"), rel=0.001), again
        assert shown.pop(name) == figures, again
    assert not shown
