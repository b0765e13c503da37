"""Scenes with ``visible = "once"``: the picture of ``"painter"`` byte for byte, with what is hidden left out."""

import random
from dataclasses import replace
from pathlib import Path

import pytest

from tests.helpers import guest_runs
from tmap.base.errors import UserError
from tmap.build import layout
from tmap.compiler.scene import compile_scene
from tmap.model import model
from tmap.scene_file import scene_file

TEXTURED = ['texture = "brick"', *(f'texture = "brick", perspective = "{each}"' for each in
                                   ("every16", "every8", "pixel", "fine")),
            'texture = "brick", perspective = "pixel", tolerance = 0.5',
            'texture = "brick", gradients = "scanline"',
            'texture = "odd", mapper = "arbitrary"',
            *(f'texture = "brick", mapper = "{each}"' for each in ("tiled", "columns", "generated", "lit", "lit_gouraud",
                                                                  "dithered")),
            *(f'texture = "brick", mapper = "{each}", perspective = "{way}"' for each, way in
              (("lit", "every16"), ("lit_gouraud", "every8"), ("lit", "fine")))]
LOOKS = ['colour = "#c08040"', 'shades = ["#201040", "#ffe0a0"]', *TEXTURED]
SQUARE = "uvs = [[[3, 5], [170, 0], [170, 170], [0, 170]]]"
BOX = """\
[[objects]]
points = [[-1, -1, -1], [1, -1, -1], [-1, 1, -1], [1, 1, -1], [-1, -1, 1], [1, -1, 1], [-1, 1, 1], [1, 1, 1]]
faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3]]
"""


def boxes(rng: random.Random, looks: list[str], width: int = 128, height: int = 96) -> str:
    """Boxes that are before and behind each other, some of them moving, some beyond the frame's borders."""
    text = [f'width = {width}\nheight = {height}\nframes = 3\nbackground = "#203040"\nvisible = "once"\n'
            '[textures]\nbrick.image = "package:skimage/data/brick.png"\n'
            'odd = { image = "package:skimage/data/brick.png", width = 77, height = 53 }\n[materials]']
    text += [f"m{i} = {{ {look} }}" for i, look in enumerate(looks)]
    text += ["[light]\ndirection = [1, -2, -1.5]\n[camera]\neye = [0, 0, 9]\ntarget = [0, 0, 0]\nfov = 70"]
    tree = rng.random() < 0.5
    for k in range(rng.randint(6, 12)):
        look = rng.randrange(len(looks))
        place = [round(rng.uniform(-4, 4), 3), round(rng.uniform(-3, 3), 3), round(rng.uniform(-6, 7), 3)]
        turn = [rng.choice((0, 0, rng.randint(0, 359))) for _ in range(3)]
        text += [f'{BOX}material = "m{look}"\nposition = {place}\nrotation = {turn}\n'
                 f"size = {rng.choice((0.3, 1, 1, 2, 4))}"]
        text += [SQUARE] if "texture" in looks[look] else []
        text += ['order = "bsp"'] if tree else [f"turns = {rng.choice((0, 0.2))}"]
    return "\n".join(text) + "\n"


def make(folder: Path, text: str) -> scene_file.Scene:
    (folder / "scene.toml").write_text(text)
    return compile_scene(folder / "scene.toml")


def assert_same(scenes: list[scene_file.Scene]) -> list[guest_runs.Drawn]:
    """Asserts that scenes have the model's picture, drawn once and drawn over; returns what was drawn once."""
    asked = [guest_runs.Asked(replace(scene, once=once)) for scene in scenes for once in (1, 0)]
    drawn = guest_runs.draw(asked)
    for number, each in enumerate(zip(asked, drawn)):
        guest_runs.check(f"scene {number // 2}, once {each[0].scene.once}", *each)
    return drawn[::2]


def hidden(drawn: guest_runs.Drawn) -> int:
    return sum(material["hidden_pixels"] for material in drawn.executed)


@pytest.mark.parametrize("seed", range(3))
def test_random_scenes_are_the_painters(tmp_path, seed: int) -> None:
    """All mappers and perspectives, with exact edges; boxes moved, turned, in a tree, over the borders."""
    rng = random.Random(f"once {seed}")
    scenes = [make(tmp_path, boxes(rng, rng.sample(LOOKS, 4))) for _ in range(12)]
    assert sum(map(hidden, assert_same(scenes))) > 10000


def test_each_material_is_cut(tmp_path) -> None:
    """One material alone."""
    rng = random.Random("once")
    scenes = [make(tmp_path, boxes(rng, [look])) for look in LOOKS]
    assert min(map(hidden, assert_same(scenes))) > 0
