"""Two renderers in one program: neither changes what the other draws, nor does counting."""

import numpy as np
import pytest

from tests.helpers import guest_program
from tmap.base.paths import GUEST, SCENES
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator
from tmap.model import model
from tmap.scene_file import scene_file

FRAMES = 2
SECOND = 100  # the number of the second scene's first dump: tests/guest/renderers.c
#: Both kinds of texture units, meshes in perspective beside affine mappers, and a scene beside itself.
PAIRS = (("n64_room", "glide_window"), ("cube", "mappers"), ("glide_lightmap", "glide_lightmap"))


@pytest.fixture(scope="module")
def dumps(tmp_path_factory):
    """By pair: the two scenes and the folder of what was drawn, all of one boot."""
    programs = tmp_path_factory.mktemp("programs")
    guest_program.build(programs, GUEST / "renderers.c")
    scenes = {name: compile_scene(SCENES / f"{name}.toml", FRAMES) for pair in PAIRS for name in pair}
    files = {f"{name}.scene": scene_file.write(scene) for name, scene in scenes.items()}
    found = {}
    for pair in PAIRS:
        first, second = pair
        result, = emulator.run_batch([f"renderers {first}.scene {second}.scene {FRAMES}"], files,
                                    "a1200-fast", tmp_path_factory.mktemp("drawn"), programs=programs,
                                    patience=emulator.PATIENT_SECONDS, timed=False)
        assert result.code == 0, result.output
        found[pair] = scenes[first], scenes[second], result.directory
    return found


@pytest.mark.parametrize("pair", PAIRS, ids="-".join)
def test_frames_are_the_models(pair, dumps) -> None:
    first, second, folder = dumps[pair]
    for scene, name, start in ((first, pair[0], 0), (second, pair[1], SECOND)):
        for number in range(FRAMES):
            expected = model.render(scene, number)
            drawn = np.frombuffer((folder / f"frame_{start + number:03}.chunky").read_bytes(),
                                  expected.dtype.newbyteorder(">")).reshape(expected.shape)
            wrong = np.argwhere(drawn != expected)
            assert not len(wrong), (
                f"{name} beside {pair}, frame {number}: {len(wrong)} pixels, the first (x, y) = "
                f"{tuple(wrong[0][::-1])}: {drawn[tuple(wrong[0])]:#x}, expected "
                f"{expected[tuple(wrong[0])]:#x}; scripts/tmap run tests/scenes/{name}.toml")
