"""Steps of accuracy for a loaded scene: what each draws is the model's frame of the same scene with
the same settings."""

import numpy as np
import pytest
from engine_scenes import save_noise

from tools import emulator, fuzz, layout, model, settings
from tools.paths import SCENES
from tools.scene import compile_scene
from tools.scene_file import write

#: A step of each axis; None: as the scene says. All steps, and what one does to the other.
STEPS = ([(None, None)] + [(step, None) for step in range(len(settings.ACCURACY))]
         + [(None, step) for step in range(len(settings.PERSPECTIVE))]
         + [(0, 0), (2, 0), (1, 2), (4, 3), (4, 4)])
TEXT = """\
width = 96
height = 72
frames = 1
background = "#102030"
[textures]
noise.image = "noise.png"
[materials]
flat = {colour = "#ff0000"}
gouraud = {shades = ["#201040", "#ffe0a0"], gradients = "scanline"}
affine = {texture = "noise", edges = "exact"}
quad = {texture = "noise", gradients = "scanline", start = "truncated"}
columns = {texture = "noise", mapper = "columns"}
arbitrary = {texture = "noise", mapper = "arbitrary"}
lit = {texture = "noise", mapper = "lit"}
gradual = {texture = "noise", mapper = "lit_gouraud"}
dithered = {texture = "noise", mapper = "dithered", edges = "integer"}
deep = {texture = "noise", perspective = "every8"}
bent = {texture = "noise", perspective = "pixel", edges = "integer", tolerance = 0.5}
cube = {texture = "noise", perspective = "every16"}
[camera]
eye = [0, 0, 3]
target = [0, 0, 0]
fov = 60
near = 0.25
"""
PLANE = "vertices = [[3.3, 2.7, 0, 0], [29.6, 5.2, 200, 10], [8.1, 33.9, 20, 180]]"
DEEP = "vertices = [[{}.3, 2.7, 0, 0, 1], [{}.6, 5.2, 90, 10, 3.5], [{}.1, 33.9, 30, 120, 2]]"
FOUR = "vertices = [[1.5, 40.2, 0, 0], [30.4, 43.7, 150, 0], [30.4, 69, 150, 120], [1.5, 65.5, 0, 120]]"
#: Edges through pixels' centres and texels' borders at them, by thirds: no binary number is exact.
THIRDS = "vertices = [[33.5, 2.5, 0, 0], [93.5, 2.5, 40, 0], [53.5, 62.5, 0, 40]]"
OBJECTS = (("affine", THIRDS), ("flat", PLANE), ("gouraud", "sides = 3\nradius = 14\ncentre = [40.3, 15.1]"),
           ("affine", PLANE + "\ncentre = [25, 22]"), ("quad", FOUR),
           ("columns", PLANE + "\ncentre = [28, 37]"),
           ("arbitrary", "sides = 3\nradius = 13\ncentre = [50.2, 20.9]\nmap_radius = 90\nangle = 17"),
           ("lit", "sides = 3\nradius = 12.5\ncentre = [83.7, 58.3]\nangle = 50\nshades = [150]"),
           ("gradual", "vertices = [[33.3, 42.7, 0, 0, 30], [52.6, 45.2, 90, 10, 250], "
                       "[38.1, 69.9, 20, 80, 120]]"),
           ("dithered", "sides = 3\nradius = 11\ncentre = [62.2, 60.9]\nangle = 17"),
           ("deep", DEEP.format(60, 80, 66)), ("bent", DEEP.format(76, 94, 79)),
           ("cube", "points = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]\n"
            "faces = [[0, 1, 2, 3]]\nuvs = [[[0, 256], [256, 256], [256, 0], [0, 0]]]\n"
            "triangles = true\ntwo_sided = true\nsize = 0.5\nrotation = [10, 60, 0]"))


@pytest.fixture(scope="module")
def scenes(tmp_path_factory) -> dict:
    """Every mapper with an 8-bit frame, and a wall of Glide's."""
    folder = tmp_path_factory.mktemp("scene")
    save_noise(folder, 5, noise=(64, 64))
    text = TEXT + "".join(f'[[objects]]\nmaterial = "{name}"\n{lines}\n' for name, lines in OBJECTS)
    (folder / "steps.toml").write_text(text)
    wall = compile_scene(SCENES / "glide_wall.toml", 1)
    return {"steps": compile_scene(folder / "steps.toml"), "wall": wall}


def arguments(accuracy: int | None, perspective: int | None) -> str:
    """What render is told."""
    return "".join(f" {name} {step}" for name, step in (("ACCURACY", accuracy),
                                                        ("PERSPECTIVE", perspective))
                   if step is not None)


def test_names_are_the_headers() -> None:
    known = layout.load()
    assert known.constants["ACCURACY_STEPS"] == len(settings.ACCURACY)
    numbers = [known.constants[f"PERSPECTIVE_{name.upper()}"] for name in settings.PERSPECTIVE]
    assert numbers == list(range(known.constants["PERSPECTIVE_KINDS"]))


def test_steps_are_the_models(scenes) -> None:
    wanted = {("steps", step): scenes["steps"] for step in STEPS}
    wanted |= {("wall", step): scenes["wall"] for step in ((0, 0), (None, 2))}
    digests = fuzz.draw([(scene, "addx" + arguments(*step))
                         for (_, step), scene in wanted.items()], "a1200-fast",
                        patience=emulator.PATIENT_SECONDS)
    drawn = {}
    for ((name, step), scene), (digest,) in zip(wanted.items(), digests):
        expected = drawn[name, step] = model.render(settings.with_settings(scene, *step), 0)
        assert fuzz.is_models(expected, digest), (
            f"{name}: render input.scene{arguments(*step)} does not draw the model's frame, which "
            f"has {np.unique(expected).size} colours; again: pytest tests/test_settings.py")
    for steps in ([(step, None) for step in range(5)], [(None, step) for step in range(5)]):
        each = {drawn["steps", step].tobytes() for step in steps}
        assert len(each) == len(steps), f"{steps}: two of them draw the same"


def test_steps_out_of_range_are_refused(scenes, tmp_path) -> None:
    commands = {f"render input.scene {name} {number}": f"render: {name}: not between 0 and 4"
                for name in ("ACCURACY", "PERSPECTIVE") for number in (-1, 5)}
    commands["render input.scene ACCURACY"] = "render: usage"
    done = emulator.run_many(list(commands), {"input.scene": write(scenes["steps"])}, "a1200",
                             tmp_path)
    for (command, line), result in zip(commands.items(), done):
        assert result.code == 20 and result.output.startswith(line), f"{command}: {result.output}"
