"""Scenes with ``visible = "once"``: the picture of ``"painter"`` byte for byte, with what is hidden left out."""

import random
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.helpers import guest_runs
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.bench.scenes import some_frames
from tmap.compiler.scene import compile_scene
from tmap.model import model
from tmap.run import run
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
    right = None
    for number, each in enumerate(zip(asked, drawn)):  # the model draws both in the same way
        right = guest_runs.check(f"scene {number // 2}, once {each[0].scene.once}", *each,
                                 expected=right if number % 2 else None)
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


def posts(count: int) -> str:
    """Posts beside each other, before a wall: each leaves a gap more in every line."""
    text = boxes(random.Random(1), ['colour = "#c08040"', 'shades = ["#201040", "#ffe0a0"]'])
    text = text[:text.index("[[objects]]")]
    wall = f'{BOX}material = "m1"\nposition = [0, 0, -20]\nsize = 12\n'
    return text + wall + "".join(f'{BOX}material = "m0"\nposition = [{(k - count / 2) * 0.8}, 0, 0]\nsize = 0.2\n'
                                 f'turns = 0.2\naxis = [1, 0, 0]\ntwo_sided = true\n' for k in range(count))


def test_too_many_gaps_draw_the_frame_again(tmp_path) -> None:
    """Where a frame would need more gaps than there is room for, it is drawn back to front: the same picture."""
    narrow = make(tmp_path, posts(13).replace("height = 96", "height = 6"))
    few, many = assert_same([make(tmp_path, posts(4)), narrow])
    assert hidden(few) > 0
    assert hidden(many) < hidden(few)


def test_ten_rooms_take_little_more_than_half_the_time(tmp_path) -> None:
    """Walls with doors behind each other: most of what is behind the first ones is hidden."""
    text = boxes(random.Random(1), ['texture = "brick", perspective = "every16"'], 320, 256)
    text = text[:text.index("[[objects]]")]
    for k in range(10):
        door = (-1.5, 1.5)[k % 2] + 0.4 * (k % 3)
        for low, high, bottom in ((-4, door - 0.6, -2), (door + 0.6, 4, -2), (door - 0.6, door + 0.6, 1)):
            points = [[x, y, z - 4 * k] for z in (-0.2, 0) for y in (bottom, 2) for x in (low, high)]
            text += BOX.replace(BOX.splitlines()[1], f"points = {points}") + f'material = "m0"\n{SQUARE}\n'
        for x in (-3, -1.1, 0.8, 2.7):
            text += f'{BOX}material = "m0"\n{SQUARE}\nposition = [{x}, -1.6, {-2 - 4 * k}]\nsize = 0.45\n'
    made = make(tmp_path, text)
    asked = [guest_runs.Asked(replace(made, once=once)) for once in (0, 1)]
    painter, once = (sum(frame["cycles"] for frame in each.figures)
                     for each in guest_runs.draw(asked, timed=True))
    assert 1.8 * once < painter


@pytest.mark.parametrize("look, said", [
    ('texture = "brick", mapper = "keyed"', '"once" is not for mapper "keyed"'),
    ('texture = "brick", edges = "subpixel"', '"once" needs edges "exact"')])
def test_others_are_refused(tmp_path, look: str, said: str) -> None:
    with pytest.raises(UserError, match=f"visible: {said}"):
        make(tmp_path, boxes(random.Random(2), [look]))


def test_the_file_is_refused_without_exact_edges(tmp_path) -> None:
    made = make(tmp_path, boxes(random.Random(2), LOOKS[:1]))
    made.materials = [replace(material, edges="snapped") for material in made.materials]
    with pytest.raises(UserError, match="once: instances"):
        scene_file.write(made)


def test_nothing_is_taken_where_it_is_not_asked_for(tmp_path) -> None:
    """The key is off unless a scene has it."""
    text = boxes(random.Random(2), LOOKS[:1])
    assert make(tmp_path, text).once == 1
    assert make(tmp_path, text.replace('visible = "once"\n', "")).once == 0


@pytest.mark.parametrize("pixel", ["2x1", "1x2"])
def test_a_level_of_larger_pixels_is_the_models(pixel: str) -> None:
    """Views stretch x or y there, and objects that z tests are looked for in them."""
    scene = some_frames(compile_scene(SCENES / "keep.toml", keys={"pixel": pixel}), [12, 72])
    for number, frame in enumerate(run.render(scene, "a1200-fast", "addx", timed=False).frames):
        assert np.array_equal(frame, model.render(scene, number)), (pixel, number)
