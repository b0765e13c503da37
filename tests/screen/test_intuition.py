"""Screens of Intuition's: their planes hold the frames, they are seen in the window, two work side by side, and the machine
is as before, however a program ends."""

import re

import numpy as np
import pytest

from tests.helpers import endings, guest_program
from tests.screen import window
from tests.screen.test_display import ECS
from tmap.base import planar
from tmap.base.paths import GUEST
from tmap.guest import emulator

MODES = ("SHOW", "WAIT", "TWO", "KEYS", "CRASH", "OPEN")
SOURCES = GUEST / "intuition.c", GUEST / "events.s", GUEST / "state.s"
FRAMES = 2
#: Frames by name: width, height, and the size of a pixel.
SHOWN = {"whole": (320, 256, 1, 1), "odd": (200, 61, 1, 1), "wide": (104, 61, 2, 1), "high": (320, 99, 1, 2),
         "large": (136, 99, 2, 2)}
TWO = 160, 100
MACHINE = "a1200"
LEFT, TOP = 74, 28      # of the picture in the window
SEEN = 230              # its rows above the emulator's own words


def command(mode: str, rest: str = "0 320 256 1 1") -> str:
    """The guest's command line."""
    return f"intuition {MODES.index(mode)} {rest}"


def shows(name: str, mode: str = "SHOW") -> str:
    width, height, wide, high = SHOWN[name]
    return command(mode, f"0 {width} {height} {wide} {high} {name}")


ENDINGS = {command("TWO", f"0 {TWO[0]} {TWO[1]} 1 1"): 0, command("KEYS", "0 32 32 1 1"): 0, command("CRASH"): 20,
           command("OPEN", "1 160 64 1 1"): 10, command("OPEN", "0 324 256 1 1"): 10}


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("programs")
    guest_program.build(folder, *SOURCES)
    return folder


@pytest.fixture(scope="module")
def files(programs) -> dict:
    rng = np.random.default_rng(29)
    return {"palette": rng.integers(0, 256, (256, 4), np.uint8).tobytes(), "intuition": programs / "intuition"} | {
        name: rng.integers(0, 256, (FRAMES, height, width), np.uint8).tobytes()
        for name, (width, height, *_) in SHOWN.items()}


@pytest.fixture(scope="module")
def ended(files, tmp_path_factory) -> dict[str, endings.Ended]:
    """All commands in one boot; the first screen of all makes the system allocate what it keeps."""
    commands = [command("OPEN"), *map(shows, SHOWN), *ENDINGS, command("OPEN")]
    found = endings.run([(0, each) for each in commands], files, MACHINE, tmp_path_factory.mktemp("run"),
                        command("OPEN"), timed=False)
    return dict(zip(commands[1:], found[1:]))


def frame(files, name: str, number: int) -> np.ndarray:
    """A frame's picture, as dots of low resolution."""
    width, height, wide, high = SHOWN[name]
    pixels = np.frombuffer(files[name], np.uint8).reshape(FRAMES, height, width)[number]
    return pixels.repeat(high, axis=0).repeat(wide, axis=1)


def picture(data: bytes, line: str, size: tuple[int, int]) -> np.ndarray:
    """The dots that dumped planes show; all around them is 0."""
    row_bytes, distance, left, top, _ = map(int, line.split())
    assert left % 32 == 0 and row_bytes % 4 == 0 and distance % 4 == 0
    block = np.frombuffer(data, np.uint8)
    dots = planar.Planes(320, 256, row_bytes, distance, planar.FORMS["c2p_8"].planes).decoded(block)
    height, width = size
    assert abs(2 * left + width - 320) < 64 and abs(2 * top + height - 256) <= 1
    inside = dots[top:top + height, left:left + width].copy()
    dots[top:top + height, left:left + width] = 0
    beside = dots[:, left + width:left + (width + 31) // 32 * 32]
    beside[:] = 0  # conversions end with whole longwords
    assert not dots.any()
    return inside


@pytest.mark.parametrize("name", SHOWN)
def test_planes_of_the_system_are_the_frame(ended, files, name):
    result = ended[shows(name)]
    assert result.code == 0, result.output
    fields = [int(line.split()[-1]) for line in result.said]
    assert fields[0] < fields[1]
    for number, line in enumerate(result.said):
        expected = frame(files, name, number)
        found = picture((result.directory / f"{name}.{number}").read_bytes(), line, expected.shape)
        wrong = planar.difference(expected, found)
        assert wrong is None, f"{name}, frame {number}, seed 29: {wrong}"


def test_two_screens_and_two_renderers(ended):
    """Squares drawn by turns, each renderer's on its own screen; one screen is closed and opened beside the other."""
    result = ended[command("TWO", f"0 {TWO[0]} {TWO[1]} 1 1")]
    assert result.code == 0, result.output
    for k, (name, line) in enumerate(zip(("first", "second"), result.said, strict=True)):
        expected = np.full(TWO[::-1], k, np.uint8)
        for i in range(k, 8, 2):
            expected[3 * i:3 * i + 40, 4 * i:4 * i + 40] = 16 * k + i
        found = picture((result.directory / name).read_bytes(), line, expected.shape)
        assert planar.difference(expected, found) is None


def test_machine_is_as_before(ended):
    """No memory, no signal, no interrupt is lost: the last program runs after all others. The system's own view is a new
    one after each screen of its own."""
    for each, found in ended.items():
        assert not found.lost(("view",)), (each, found.lost())


def test_return_codes(ended):
    for each, code in ENDINGS.items():
        assert ended[each].code == code, (each, ended[each].output)
    assert ended[command("OPEN", "1 160 64 1 1")].output == "screen: Intuition's screens show chunky frames alone\n"


def test_keys_of_the_window(ended):
    """Keys pressed, without repeats; Ctrl-C is a signal."""
    assert ended[command("KEYS", "0 32 32 1 1")].output.split() == [str(0x45), str(0x33), str(0x1000)]


def test_machine_without_aga(programs, tmp_path, monkeypatch):
    monkeypatch.setitem(emulator.MACHINES, "ecs", ECS)
    result = emulator.run("intuition", command("OPEN").partition(" ")[2], {}, "ecs", tmp_path, programs=programs)
    assert result.code == 20
    assert re.fullmatch(r"screen: Intuition opens none of 8 planes: [^\n]*\n", result.output)


def test_picture_in_the_window(files, tmp_path):
    """What is seen of the last frame, beside its colours; a key ends the program, and the shell is seen again."""
    colours = np.frombuffer(files["palette"], np.uint8).reshape(256, 4)[:, 1:]
    expected = colours[frame(files, "whole", FRAMES - 1)]
    command_line = f"{shows('whole', 'WAIT')} >its.output"
    with window.screen(tmp_path / "screen") as on, window.shell(on, files, tmp_path, command_line) as folder:
        def is_there(shot: np.ndarray) -> bool:
            return (shot[TOP:TOP + 2 * SEEN:2, LEFT:LEFT + 640:2] == expected[:SEEN]).all(axis=2).mean() > 0.99

        shot = on.wait("the picture", is_there)
        seen = shot[TOP:TOP + 2 * SEEN:2, LEFT:LEFT + 640:2]
        assert (seen == expected[:SEEN]).all()
        on.press("Escape")
        on.wait("the shell", lambda now: not is_there(now))
        assert (folder / "whole.1").exists()
