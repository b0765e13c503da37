"""What a frame touches: frames drawn over one another, of which only that is cleared, are the frames that are drawn
whole, and all else is the background. tests/screen/test_display.py has what is converted of them."""

import numpy as np
import pytest

from tests.helpers import guest_program
from tmap.base.paths import GUEST, SCENES
from tmap.compiler.scene import compile_scene
from tmap.fuzz import polygons
from tmap.guest import emulator
from tmap.scene_file import scene_file

#: Scenes that are cleared, with meshes, objects, billboards, trees and both texture units, and frames of each.
NAMES = {"cube": 12, "crane": 24, "floor": 12, "environment": 4, "shaded": 3, "grove": 12, "terrace": 4, "default": 2,
         "lit": 2, "wide": 3, "panel": 3, "n64_rectangles": 2, "n64_palettes": 3, "glide_wall": 1}
#: Random polygons with every setting and mapper, one a frame: seed, blocks, and polygons of each.
SEED, BLOCKS, EACH = 77, range(8), 150


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    folder = tmp_path_factory.mktemp("programs")
    guest_program.build(folder, GUEST / "touched.c")
    return folder


def frames_of(program, scenes: dict, machine: str, folder) -> dict[str, np.ndarray]:
    """By name, what tests/guest/touched.c prints: [frame][column]."""
    files = {f"{name}.scene": scene_file.write(scene) for name, scene in scenes.items()}
    done = emulator.run_batch([f"touched {name}" for name in files], files, machine, folder, programs=program,
                              patience=emulator.PATIENT_SECONDS, timed=False)
    found = {}
    for (name, scene), result in zip(scenes.items(), done, strict=True):
        assert result.code == 0, f"{name}: {result.output}"
        found[name] = np.array([line.split() for line in result.output.splitlines()], int)
        assert len(found[name]) == scene.frames
    return found


def complaint(name: str, rows: np.ndarray) -> str | None:
    """What is wrong with a scene's frames."""
    wrong = np.flatnonzero(rows[:, 3] >= 0)
    if not len(wrong):
        return None
    return (f"{name}: {len(wrong)} frames are not those that are drawn whole, the first is {wrong[0]} "
            f"at (x, y) = {tuple(rows[wrong[0], 3:].tolist())}")


@pytest.mark.parametrize("machine, frames", [(emulator.SECOND, NAMES), ("a1200-fast", {"floor": 6, "cube": 6})])
def test_scenes(program, tmp_path, machine, frames):
    scenes = {name: compile_scene(SCENES / f"{name}.toml", count) for name, count in frames.items()}
    found = frames_of(program, scenes, machine, tmp_path)
    for name, rows in found.items():
        assert complaint(name, rows) is None
        assert (rows[:, 2] > 0).any(), f"{name}: nothing was touched"
    share = found["floor"][:, 2].mean() / (scenes["floor"].width * scenes["floor"].height)
    assert share < 0.7, f"floor: {share:.0%} touched, less than 70 % is below the horizon"


def test_random_polygons(program, tmp_path):
    """None is drawn farther outside of its vertices' box than TOUCHED_BEYOND."""
    scenes = {}
    for block in BLOCKS:
        numbers = range(block * polygons.BLOCK, block * polygons.BLOCK + EACH)
        scenes[f"block{block}"] = polygons.scene(SEED, block, [polygons.polygon(SEED, k) for k in numbers])
    for name, rows in frames_of(program, scenes, emulator.SECOND, tmp_path).items():
        assert complaint(name, rows) is None, f"{complaint(name, rows)}; seed {SEED}"
