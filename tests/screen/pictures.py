"""Plays the demo in a window under Xvfb and takes a picture of each part; ``python -m tests.screen.pictures`` writes
them side by side as tests/scenes/demo.png, for the pages."""

import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from PIL import Image

from tests.screen import window
from tmap.base.paths import PROGRAMS, SCENES
from tmap.guest import emulator
from tmap.run import demo

SHEET = SCENES / "demo.png"
LEFT, TOP, WIDTH, HEIGHT = 74, 12, 640, 512  # of the picture in the window
TITLE = slice(TOP + 516, TOP + 532)  # rows of the first status line
PARTS, ACROSS = 8, 4
SECONDS = (6, 6, 4, 5, 4, 7, 5, 4)  # from each title on
COLOURS = 96


@contextmanager
def played(arguments: str, folder: Path) -> Iterator[tuple[window.Screen, Path]]:
    """Starts the machine with the demo at its prompt, as a disk would; yields its window, and a file that is there once
    the demo has ended."""
    volume = folder / "volume"
    for name, content in (demo.files() | {
            "S/Startup-Sequence": f"demo {arguments}\necho >end $RC\n".encode()}).items():
        (volume / name).parent.mkdir(parents=True, exist_ok=True)
        (volume / name).write_bytes(content)
    with window.screen(folder / "frame") as on:
        display = window.window(on)
        config = emulator.write_config(folder, "a1200-fast", display, {"hard_drive_0": str(volume)})
        with emulator.started(["fs-uae", str(config)], folder, display.environment, folder / "emulator.log"):
            yield on, volume / "end"


def shown(shot: np.ndarray) -> np.ndarray:
    """The picture in a shot of the window, its lines and columns halved."""
    return shot[TOP:TOP + HEIGHT:2, LEFT:LEFT + WIDTH:2]


def is_part(shot: np.ndarray) -> bool:
    """Whether a part's picture is shown: it has colours. The emulator's own words are below."""
    return len(np.unique(shown(shot)[:HEIGHT // 4].reshape(-1, 3), axis=0)) > 8


def whole(on: window.Screen) -> np.ndarray:
    """A shot that was not read while it was written: two are the same."""
    shot, last = on.shot(), None
    while last is None or not np.array_equal(shot, last):
        shot, last = on.shot(), shot
    return shot


def take() -> list[np.ndarray]:
    """Returns a picture of each part."""
    taken = []
    with tempfile.TemporaryDirectory() as folder, played("", Path(folder)) as (on, _):
        on.wait("the first part", is_part, still=False)
        for part, seconds in enumerate(SECONDS, 1):
            time.sleep(seconds)
            on.wait(f"part {part}", is_part, still=False)
            shot = whole(on)
            taken.append(shown(shot))
            if part < PARTS:
                title = shot[TITLE]     # the emulator's words, which were over it, are gone
                on.wait("the next title", lambda now: not np.array_equal(now[TITLE], title), still=False)
    return taken


def sheet(taken: list[np.ndarray]) -> Image.Image:
    """All pictures in rows, in few colours."""
    rows = [np.concatenate(taken[at:at + ACROSS], axis=1) for at in range(0, PARTS, ACROSS)]
    return Image.fromarray(np.concatenate(rows)).quantize(COLOURS, dither=Image.Dither.NONE)


if __name__ == "__main__":
    sheet(take()).save(SHEET, optimize=True)
    print(f"written: {SHEET}")
