"""Steps of accuracy for a loaded scene: what each draws is the model's frame of the same scene with
the same settings."""

import numpy as np
import pytest
from steps_scene import steps_scene

from tools import emulator, fuzz, layout, model, settings
from tools.paths import SCENES
from tools.scene import compile_scene
from tools.scene_file import write

#: A step of each axis; None: as the scene says. All steps, and what one does to the other.
STEPS = ([(None, None)] + [(step, None) for step in range(len(settings.ACCURACY))]
         + [(None, step) for step in range(len(settings.PERSPECTIVE))]
         + [(0, 0), (2, 0), (1, 2), (4, 3), (4, 4)])


@pytest.fixture(scope="module")
def scenes(tmp_path_factory) -> dict:
    """Every mapper with an 8-bit frame, and a wall of Glide's."""
    return {"steps": steps_scene(tmp_path_factory.mktemp("scene")),
            "wall": compile_scene(SCENES / "glide_wall.toml", 1)}


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
