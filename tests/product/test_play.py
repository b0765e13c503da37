"""`tmap play`: a disk that boots into a scene, or a folder; what it refuses."""

import numpy as np
import pytest

from tests.screen.test_show import chunky_picture
from tests.screen.window import screen, window
from tmap.base.errors import UserError
from tmap.base.paths import PROGRAMS, SCENES
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator
from tmap.model import model
from tmap.product import disk, play
from tmap.scene_file.scene_file import write

SCENE = SCENES / "cube.toml"
FRAMES = 3  # of the scene that is looked at
MACHINE = "a1200"


@pytest.fixture(scope="module")
def short(tmp_path_factory):
    """A scene file of few frames."""
    path = tmp_path_factory.mktemp("scene") / "a cube.toml"
    path.write_text(SCENE.read_text().replace("frames = 50", f"frames = {FRAMES}")
                    .replace('"checker.png"', f'"{SCENES / "checker.png"}"'))
    return path


def test_disk_boots_into_the_scene(short, tmp_path) -> None:
    """In a window: a frame of the scene, and nothing below it."""
    path, scene = tmp_path / "cube.adf", compile_scene(short)
    assert play.command(short, path, MACHINE) == 0
    assert str(disk.opened(path).get_volume_name()) == "a cube"
    pictures = [chunky_picture(scene, model.render(scene, number)) for number in range(FRAMES)]
    assert len({each.tobytes() for each in pictures}) == FRAMES
    with screen(tmp_path / "frame") as on:
        config = emulator.write_config(tmp_path, MACHINE, window(on), emulator.floppies(path))
        with emulator.started(["fs-uae", str(config)], tmp_path, window(on).environment, tmp_path / "log"):
            shot = on.wait("a frame", lambda shot: any(np.array_equal(shot[:len(each)], each) for each in pictures),
                           still=False)
    assert not shot[len(pictures[0]):].any(), "status lines"


def test_folder_has_what_it_needs(short, tmp_path, capsys) -> None:
    """What else is there stays; a rate becomes fields a frame."""
    (tmp_path / "mine").write_bytes(b"mine")
    assert play.command(short, tmp_path, MACHINE, 12.5) == 0
    assert "execute play" in capsys.readouterr().out
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {
        "mine": b"mine", "play": b"show play.scene PLAIN HOLD 4\n", "show": (PROGRAMS / "show").read_bytes(),
        "play.scene": write(compile_scene(short))}


def test_what_it_refuses(short, tmp_path) -> None:
    """One line, and nothing is written."""
    out = tmp_path / "out.adf"
    large = tmp_path / "large.toml"
    large.write_text(short.read_text().replace("width = 320", "width = 400"))
    for arguments, said in (((large, out, MACHINE), "width, height: a screen shows at most 320x256"),
                            ((SCENES / "keep.toml", out, "a1200-fast"), "the disk is full: play.scene has"),
                            ((short, out, MACHINE, 2.0), "--fps: a screen of 50 fields a second holds 5 to 50, not 2"),
                            ((short, large / "folder", MACHINE), "is not a directory")):
        with pytest.raises(UserError, match=said):
            play.command(*arguments)
    assert [path.name for path in tmp_path.iterdir()] == ["large.toml"]
