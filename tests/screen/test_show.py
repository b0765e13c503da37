"""``make show``: the picture in the window, pixel by pixel, and the effect of keys."""

import re
import threading

import numpy as np
import pytest

from tests.helpers.steps_scene import steps_scene
from tests.screen.window import Screen, screen, shell, window
from tmap.__main__ import main
from tmap.base import planar
from tmap.base.errors import UserError
from tmap.base.paths import PROGRAMS, SCENES
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator
from tmap.model import model, settings
from tmap.run import run, show
from tmap.scene_file.scene_file import Scene, write

#: Position of the screen's 640x512 high-resolution dots in the window.
LEFT, TOP = 74, 12
#: First rows of the status lines, and the size of a letter, in pixels.
LINES, LETTER = (TOP + 516, TOP + 534), (16, 8)
GROUND = 2  # each channel of the colour with which HAM8 lines begin
FRAMES = 4
KEYS = "arrows, S, G, space, Esc"  # at the end of the second status line


def surrounded(picture: np.ndarray) -> np.ndarray:
    """A picture of window pixels in the middle of a black screen, without the status lines."""
    full = np.zeros((TOP + 512, show.WIDTH, 3), np.uint8)
    y, x = TOP + (512 - len(picture)) // 2, LEFT + (640 - picture.shape[1]) // 2
    full[y:y + len(picture), x:x + picture.shape[1]] = picture
    return full


def chunky_picture(scene: Scene, frame: np.ndarray) -> np.ndarray:
    """An 8-bit frame through the palette, with each pixel doubled in both directions."""
    return surrounded(scene.palette[frame].repeat(2, 0).repeat(2, 1))


def ham8_picture(frame: np.ndarray) -> np.ndarray:
    """A small 32-bit frame as HAM8 shows it: a pixel is 4x4 dots."""
    form = planar.FORMS["c2p_ham8_32"]
    dots = form.convert(frame) | planar.ham8_control(form.dots * frame.shape[1])
    return surrounded(planar.ham8_shown(dots, (GROUND,) * 3).repeat(4, 0))


class Status:
    """Reads status lines as text, with letters learnt from lines whose text is known."""

    def __init__(self) -> None:
        self.letters: dict[bytes, str] = {}

    @staticmethod
    def cells(shot: np.ndarray, line: int) -> list[bytes]:
        """The pixels of 80 letters."""
        high, wide = LETTER
        row = shot[LINES[line]:LINES[line] + high, LEFT:LEFT + 640].any(axis=2)
        return [row[:, x:x + wide].tobytes() for x in range(0, 640, wide)]

    def learn(self, shot: np.ndarray, line: int, text: str, at: int = 0) -> None:
        """Asserts that a line has this text from a column on: each letter always looks the same,
        and different from all others."""
        for cell, letter in zip(self.cells(shot, line)[at:], text):
            assert self.letters.setdefault(cell, letter) == letter, (
                f"status line {line} should have {text!r} at {at}; is {self.read(shot, line)!r}")
        assert len(set(self.letters.values())) == len(self.letters), self.letters.values()

    def read(self, shot: np.ndarray, line: int) -> str:
        """Reads a line; unknown letters are #."""
        return "".join(self.letters.get(cell, "#") for cell in self.cells(shot, line)).rstrip()


def wait_for(on: Screen, picture: np.ndarray, what: str) -> np.ndarray:
    """Waits until the window shows exactly this picture above the status lines."""
    try:
        return on.wait(what, lambda shot: np.array_equal(shot[:len(picture)], picture))
    except AssertionError:
        shot = on.shot()[:len(picture)]
        wrong = np.argwhere((shot != picture).any(axis=2))
        y, x = wrong[0] if len(wrong) else (0, 0)
        raise AssertionError(f"{what}: {len(wrong)} pixels differ, the first at {x}, {y}: expected "
                             f"{picture[y, x]}, found {shot[y, x]}; again: pytest "
                             "tests/screen/test_show.py") from None


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    """An X server with a screen."""
    with screen(tmp_path_factory.mktemp("x") / "frame") as made:
        yield made


@pytest.fixture(scope="module")
def steps(tmp_path_factory):
    """The folder of a scene that moves, and the scene."""
    folder = tmp_path_factory.mktemp("steps")
    return folder, steps_scene(folder, FRAMES)


def off(scene: Scene, number: int, accuracy: int | None, perspective: int | None) -> str:
    """The share of a frame's displayed pixels that differ from the exact picture."""
    shown, best = (model.render(settings.with_settings(scene, *step), number)
                   for step in ((accuracy, perspective), (5, settings.EXACT)))
    return f"{int((shown != best).sum()) * 10000 // shown.size / 100:.2f} % of pixels off"


def play_chunky(on: Screen, scene: Scene) -> None:
    """Changes steps with cursor keys while the scene is paused, then lets it run."""
    def frame(number: int, *steps: int | None) -> np.ndarray:
        stepped = settings.with_settings(scene, *steps)
        return chunky_picture(scene, model.render(stepped, number))

    def expect(text: str, *steps: int | None) -> None:
        shot = wait_for(on, frame(1, *steps), f"frame 1 at steps {steps}")
        status.learn(shot, 1, text.ljust(80 - len(KEYS)) + KEYS)
        status.learn(shot, 0, "paused, frame 1   ")
        end = f" cycles/pixel   {off(scene, 1, *steps)}"
        status.learn(shot, 0, end.ljust(80), len(status.read(shot, 0)) - len(end))
        said = status.read(shot, 0)
        assert re.fullmatch(r"paused, frame 1   [\d#]+\.[\d#]" + re.escape(end), said), said

    status = Status()
    expect("settings of the scene   perspective of the scene", None, None)
    on.press(*["Left"] * 7)
    expect("integer, polygon, truncated   perspective of the scene", 0, None)
    on.press("Down", "Down", "Down", "Down")
    expect("integer, polygon, truncated   perspective every16", 0, 1)
    on.press("Right", "Right", "Right", "Right", "Right", "Right", "Up", "Up", "Up", "Up")
    expect("exact, plane, subtexel   perspective fine", 5, 4)
    on.press("space")
    on.wait("frames per second", lambda shot: re.match(r"[\d#]+\.[\d#] fps", status.read(shot, 0)),
            still=False)
    on.press("space")
    frames = [frame(number, 5, 4) for number in range(FRAMES)]
    assert len({each.tobytes() for each in frames}) == FRAMES
    on.wait("any frame", lambda shot: "paused" in status.read(shot, 0)
            and any(np.array_equal(shot[:len(each)], each) for each in frames))


def prompt(on: Screen, before: np.ndarray) -> np.ndarray:
    """Waits until the shell's window looks as before."""
    on.wait("the shell", lambda shot: np.array_equal(shot[:50], before[:50]))
    return on.settled("the prompt")


def test_pictures_keys_and_the_end(server, steps, tmp_path) -> None:
    """Commands are typed at the prompt, as a user would."""
    scene, ocean = steps[1], compile_scene(SCENES / "n64_ocean.toml", 1)
    files = {"a.scene": write(scene), "h.scene": write(ocean), "show": PROGRAMS / "show"}
    with shell(server, files, tmp_path / "run") as volume:
        server.settled("the prompt")
        server.type("show a.scene pause frame 1")
        before = server.settled("the command")
        server.press("Return")
        play_chunky(server, scene)
        server.press("Escape")
        after = prompt(server, before)
        quiet = slice(0, 480)  # the emulator's own notices at its start are below
        rows = np.flatnonzero((after[quiet] != before[quiet]).any(axis=(1, 2)))
        assert np.ptp(rows) < 2 * LETTER[0], "more than the lines of the prompts is other than before"
        server.enter("echo >left $RC")
        server.enter("show h.scene pause")
        wait_for(server, ham8_picture(model.render(ocean, 0)), "the ocean in HAM8")
        server.press("ctrl+c")
        prompt(server, before)
        server.enter("echo >broken $RC")
        server.wait("return codes", lambda _: [emulator.read(volume / name).strip()
                                               for name in ("left", "broken")] == ["0", "5"])


def test_command_ends_with_the_window(server, steps) -> None:
    folder, scene = steps
    result = []
    play = threading.Thread(target=lambda: result.append(
        show.command(folder / "steps.toml", "a1200", window(server))))
    play.start()
    above = slice(0, TOP + 512)
    frames = [chunky_picture(scene, model.render(scene, number))[above] for number in range(FRAMES)]
    server.wait("a frame", lambda shot: any(np.array_equal(shot[above], each) for each in frames),
                still=False)
    server.press("Escape")
    play.join(60)
    assert result == [0]


@pytest.mark.parametrize("machine", emulator.MEASURED)
def test_frames_are_counted(steps, machine: str, tmp_path) -> None:
    """So many are shown, and how long they took is said: a field each at least."""
    done = emulator.run("show", "a.scene COUNT 5", {"a.scene": write(steps[1])}, machine, tmp_path,
                        timed=False)
    said = re.fullmatch(r"5 frames in (\d+) fields\n", done.output)
    assert done.code == 0 and said and 5 <= int(said[1]) < 500, done.output


@pytest.mark.parametrize("machine", emulator.MEASURED)
def test_frames_are_timed(steps, machine: str, tmp_path) -> None:
    """Drawing and conversion fit into the fields of which a frame is shown, and drawing with the display on takes longer
    than without it."""
    scene = steps[1]
    done = emulator.run("show", "a.scene COUNT 8 TIMES", {"a.scene": write(scene)}, machine, tmp_path)
    said = re.fullmatch(r"8 frames in (\d+) fields\n((?:drawn \d+ converted \d+ field \d+\n){8})", done.output)
    assert done.code == 0 and said, done.output
    times = np.array(re.findall(r"\d+", said[2]), int).reshape(8, 3)
    assert times[-1, 2] == int(said[1]) and (np.diff(times[:, 2]) > 0).all()
    cycles = emulator.CYCLES_PER_TICK * times[:, :2].sum(axis=1)
    assert abs(cycles[1:].sum() / emulator.CLOCK_HZ * 50 - (times[-1, 2] - times[0, 2])) < 1.5
    quiet = [frame["cycles"] for frame in run.render(scene, machine, "addx").figures]
    assert quiet[1] < emulator.CYCLES_PER_TICK * times[4, 0] < 1.5 * quiet[1]


def test_what_cannot_be_shown(tmp_path, monkeypatch, capsys) -> None:
    for name in show.DRIVERS:
        monkeypatch.delenv(name, raising=False)
    assert main(["show", str(SCENES / "default.toml")]) == 2
    assert capsys.readouterr().err == ("tmap: show: there is no DISPLAY to open a window on; tmap "
                                       "run makes pictures\n")
    monkeypatch.setenv("DISPLAY", ":9999")
    assert main(["show", str(SCENES / "default.toml")]) == 2
    assert capsys.readouterr().err == ("tmap: show: nothing answers at DISPLAY :9999; tmap run makes "
                                       "pictures\n")
    wide = tmp_path / "wide.toml"
    wide.write_text('width = 400\nheight = 8\nframes = 1\nbackground = "#000000"\n[materials]\n'
                    'it.colour = "#ffffff"\n[[objects]]\nmaterial = "it"\nsides = 3\nradius = 9\n')
    with pytest.raises(UserError) as caught:
        show.command(wide, "a1200", emulator.HIDDEN)
    assert str(caught.value) == ("show: return code 10; its last words: \"screen: the picture's width "
                                 'is not 8 to 320 in steps of 8 pixels"')
