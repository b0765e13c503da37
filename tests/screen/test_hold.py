"""`show` holds a rate of frames: pixels twice as large without another scene file, the ladder of settings, the governor."""

import re
from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import guest_program
from tests.screen.test_show import chunky_picture
from tests.screen.window import screen, shell
from tmap.base.paths import GUEST, PROGRAMS, SCENES
from tmap.build import layout
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator
from tmap.model import model, settings
from tmap.run.governor import Governor, Rung, ladder
from tmap.scene_file.scene_file import Scene, write

#: Scenes of meshes: with coverage, trees, a z buffer, both formats of views, light; and frames of each.
COARSE = {"corridor": 2, "crane": 2, "cube": 2, "environment": 2, "face": 1, "floor": 2, "grove": 1, "keep": 1, "lamps": 1,
          "mist": 1, "movers": 2, "shaded": 2, "terrace": 1}
#: Scenes that have none: polygons of the screen's space, texture units.
FINE = ("default", "n64_wall", "glide_floor")
BATCH = 5  # scenes in memory at a time
LAST_FIELDS = 6  # a frame of G's last rate


def without_views16(scene: Scene) -> Scene:
    """A scene whose points are all transformed with 32-bit operands."""
    none = layout.load().constants["NO_VIEW16"]
    return replace(scene, instances=[replace(each, view16=none) for each in scene.instances])


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    folder = tmp_path_factory.mktemp("programs")
    guest_program.build(folder, GUEST / "coarse.c")
    return folder


def test_coarse_frames_are_the_compilers(program, tmp_path) -> None:
    """A scene with pixels twice as large draws what the same scene compiled with pixel = "2x2" does, and its own frames
    after that as before."""
    names = list(COARSE)
    for first in range(0, len(names), BATCH):
        some, files = names[first:first + BATCH], {}
        for name in some:
            for end, pixel in (("1", "1x1"), ("2", "2x2")):
                scene = compile_scene(SCENES / f"{name}.toml", COARSE[name], keys={"pixel": pixel})
                files[name + end] = write(without_views16(scene) if end == "2" else scene)
        done = emulator.run_batch([f"coarse {name}1 {name}2" for name in some], files, emulator.SECOND,
                                  tmp_path / some[0], programs=program, timed=False)
        for name, result in zip(some, done, strict=True):
            assert result.output.split() == COARSE[name] * ["-1", "-1"], f"{name}: {result.code}, {result.output}"


def test_scenes_without_coarse_frames(program, tmp_path) -> None:
    files = {name: write(compile_scene(SCENES / f"{name}.toml", 1)) for name in FINE}
    done = emulator.run_batch([f"coarse {name} {name}" for name in FINE], files, emulator.SECOND, tmp_path,
                              programs=program, timed=False)
    assert [result.output for result in done] == len(FINE) * ["none\n"]


def has_coarse(scene: Scene) -> bool:
    """As scene_has_coarse (c/scene/coarse.h) for scenes of meshes."""
    return scene.pixel_width == 1 and scene.width % 16 == 0


def played(scene: Scene, frames: int, fields: int, machine: str, folder) -> np.ndarray:
    """Ticks of drawing and of conversion, the field since which it is shown and the rung of each frame."""
    done = emulator.run("show", f"a.scene COUNT {frames} TIMES HOLD {fields}", {"a.scene": write(scene)}, machine, folder)
    lines = re.findall(r"^drawn (\d+) converted (\d+) field (\d+) rung (\d+)$", done.output, re.M)
    assert done.code == 0 and len(lines) == frames, done.output
    return np.array(lines, int)


@pytest.mark.parametrize("name, machine, fields, frames", [
    ("corridor", "a1200-fast", 4, 32), ("environment", "a1200-fast", 4, 32), ("crane", "a1200", 5, 40),
    ("rooms", "a1200-fast", 1, 20)])
def test_rates_are_held(name: str, machine: str, fields: int, frames: int, tmp_path) -> None:
    """Rungs are the governor's, from the times that `show` says; a frame is never shown for less than its fields, and
    once the last rung is reached for no more, where that rung has time for it; where none has, it is the last one."""
    scene = compile_scene(SCENES / f"{name}.toml", keys={"pixel": "1x1"})
    rungs = ladder(scene, has_coarse(scene))
    rows = played(scene, frames, fields, machine, tmp_path)
    budget = layout.load().constants["FIELD_BUDGET"] * fields
    governor = Governor([budget] * len(rungs))
    for number, (drawn, converted, _, rung) in enumerate(rows.tolist()):
        assert rung == governor.step, f"{name}, frame {number}"
        governor.next(drawn + converted)
    shown = np.diff(rows[:, 2])
    assert (shown >= fields).all(), shown
    last = rows[-1, 3]
    settled = int(np.flatnonzero(rows[:, 3] != last)[-1]) + 2 if (rows[:, 3] != last).any() else 1
    in_time = rows[settled:, :2].sum(axis=1) <= budget
    assert len(in_time) >= frames // 4, f"{name}: it goes on to change: {rows}"
    if in_time.all():
        assert set(shown[settled:].tolist()) == {fields}, shown
    else:
        assert last == len(rungs) - 1, f"{name}: rung {last} of {len(rungs)} is late, {rows}"


def test_rungs_are_left_out() -> None:
    """What changes nothing is none of them."""
    far, own = 1, None
    snapped = settings.ACCURACY.index(("snapped", "plane", "subtexel"))
    rungs = {name: ladder(compile_scene(SCENES / f"{name}.toml", 1), coarse)
             for name, coarse in (("keep", True), ("environment", True), ("lit", False), ("glide_floor", False))}
    assert rungs["environment"] == [Rung(own, own, False), Rung(own, own, True)]
    assert rungs["keep"] == [Rung(own, own, False), Rung(own, own, True)]
    assert rungs["lit"][0] == Rung(own, own, False) and not any(rung.is_coarse for rung in rungs["lit"])
    assert Rung(own, far, False) in rungs["glide_floor"]
    floor = ladder(compile_scene(SCENES / "floor.toml", 1), True)
    assert floor == [Rung(own, own, False), Rung(own, far, False), Rung(own, own, True), Rung(own, far, True)]
    cube = ladder(compile_scene(SCENES / "cube.toml", 1), False)
    assert cube == [Rung(own, own, False), Rung(own, far, False), Rung(snapped, far, False)]


def shown_at(scene: Scene, rung: Rung, number: int) -> np.ndarray:
    """A frame of a scene with pixels of 2x2 as the window shows it at a rung."""
    at = settings.with_settings(scene, rung.accuracy, rung.perspective, only_cheaper=True)
    return chunky_picture(scene, model.render(at, number).repeat(2, 0).repeat(2, 1))


def test_held_pictures_are_the_models(tmp_path) -> None:
    """In a window: the last rung's picture is the model's of the scene with pixels of 2x2, and G goes on to other rates
    and at last to the scene's own picture."""
    fine, coarse = (compile_scene(SCENES / "cube.toml", 2, keys={"pixel": pixel}) for pixel in ("1x1", "2x2"))
    last = ladder(fine, True)[-1]
    with screen(tmp_path / "frame") as on, shell(on, {"a.scene": write(fine), "show": PROGRAMS / "show"}, tmp_path / "run"):
        on.settled("the prompt")
        on.enter("show a.scene hold 1")
        pictures = [shown_at(coarse, last, number) for number in range(fine.frames)]
        on.wait("the last rung", lambda shot: any(np.array_equal(shot[:len(each)], each) for each in pictures), still=False)
        on.press("space")
        on.wait("its frame stands still", lambda shot: any(np.array_equal(shot[:len(each)], each) for each in pictures))
        on.press(*["g"] * LAST_FIELDS)
        own = [chunky_picture(fine, model.render(fine, number)) for number in range(fine.frames)]
        on.wait("the scene's own", lambda shot: any(np.array_equal(shot[:len(each)], each) for each in own))
