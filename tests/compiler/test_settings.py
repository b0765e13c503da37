"""Steps of accuracy for a loaded scene: each draws the model's frame of the scene with the same
settings."""

import re

import numpy as np
import pytest

from tests.helpers.steps_scene import steps_scene
from tmap.base.paths import SCENES
from tmap.build import layout
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator, guest_frames
from tmap.model import model, settings
from tmap.run import demo
from tmap.scene_file.scene_file import write

#: A step of each axis; None: as in the scene. All steps, and some pairs that influence each other.
STEPS = ([(None, None)] + [(step, None) for step in range(len(settings.ACCURACY))]
         + [(None, step) for step in range(len(settings.PERSPECTIVE))]
         + [(0, 0), (2, 0), (1, 2), (5, 3), (5, 4)])

REFUSED = {f"render input.scene {name} {number}": f"render: {name}: not between 0 and {most}"
           for name, most in (("ACCURACY", 5), ("PERSPECTIVE", 4)) for number in (-1, most + 1)}
REFUSED["render input.scene ACCURACY"] = "render: usage"
PANES, FRAMES = ("every8", "pixel"), 10
#: Separates both cases: lines divided exactly take a quarter longer, interrupts about 4 % of the
#: time (tests/guest/display.c, BUSY).
LONGER = 0.1
PART = """\
part 1 together
title 1
says all
scene face.scene
pane 0 0 addx 5 every8 0
pane 80 0 addx 5 pixel 0
step 0 1 3 own all
"""


@pytest.fixture(scope="module")
def scenes(tmp_path_factory) -> dict:
    """Every mapper with an 8-bit frame, and a wall of Glide's."""
    return {"steps": steps_scene(tmp_path_factory.mktemp("scene")),
            "wall": compile_scene(SCENES / "glide_wall.toml", 1)}


def arguments(accuracy: int | None, perspective: int | None) -> str:
    """The arguments for render."""
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
    digests = guest_frames.draw([(scene, "addx" + arguments(*step))
                         for (_, step), scene in wanted.items()], "a1200-fast",
                        patience=emulator.PATIENT_SECONDS)
    drawn = {}
    for ((name, step), scene), (digest,) in zip(wanted.items(), digests):
        expected = drawn[name, step] = model.render(settings.with_settings(scene, *step), 0)
        assert guest_frames.is_models(expected, digest), (
            f"{name}: render input.scene{arguments(*step)} does not draw the model's frame, which "
            f"has {np.unique(expected).size} colours; again: pytest tests/compiler/test_settings.py")
    for steps in ([(step, None) for step in range(len(settings.ACCURACY))],
                  [(None, step) for step in range(len(settings.PERSPECTIVE))]):
        each = {drawn["steps", step].tobytes() for step in steps}
        assert len(each) == len(steps), f"{steps}: two of them draw the same"


@pytest.fixture(scope="module")
def done(scenes, tmp_path_factory) -> list[emulator.Result]:
    """The output of REFUSED's commands, and of a demo with two parts that need the same tables."""
    folder = tmp_path_factory.mktemp("demo")
    text = re.sub("^tables = .*\n", "", (demo.SOURCE / "face.toml").read_text(), flags=re.M)
    (folder / "face.toml").write_text(text.replace('perspective = "pixel"', 'perspective = "fine"')
                                      .replace("../checker.png", str(SCENES / "checker.png")))
    files = {"input.scene": write(scenes["steps"]), "parts": 2 * PART.encode(),
             "face.scene": write(compile_scene(folder / "face.toml"))}
    return emulator.run_batch([*REFUSED, f'demo "" FRAMES {FRAMES} LOG'], files, "a1200-fast",
                             folder / "run")


def test_steps_out_of_range_are_refused(done) -> None:
    for (command, line), result in zip(REFUSED.items(), done):
        assert result.code == 10 and result.output.startswith(line), f"{command}: {result.output}"


def test_each_scene_has_its_tables(done) -> None:
    """This includes the second scene of a process, in memory that another one used before: without
    tables lines are divided exactly, which takes at least a quarter longer. Times vary by the share
    of interrupts."""
    times = [int(ticks) for ticks in re.findall(r"^pane .* ticks (\d+)", done[-1].output, re.M)]
    assert done[-1].code == 0 and len(times) == 4, done[-1].output
    for pane, first, second in zip(PANES, times, times[2:]):
        assert abs(second / first - 1) < LONGER, f"{pane}: {first} ticks, then {second}"
