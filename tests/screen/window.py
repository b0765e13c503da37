"""A separate X server, the emulator's window on it, its keys and its pixels."""

import contextlib
import os
import subprocess
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tmap.base.silence import Silence
from tmap.guest import emulator
from tmap.guest.emulator import Display
from tmap.run import show

#: Seconds of processor time of the test, the server and the emulator, for each wait.
PATIENCE = 60.0
HEADER, COLOUR = 100, 12  # bytes read of an XWD file's header, of an entry of its colours


@dataclass
class Screen:
    """A display as large as the window; ``display`` is its name."""

    display: str
    folder: Path

    def shot(self) -> np.ndarray:
        """The visible pixels: uint8 [y][x][red, green, blue]."""
        data = (self.folder / "Xvfb_screen0").read_bytes()
        fields = np.frombuffer(data, ">u4", HEADER // 4)
        start, (width, height), pitch = fields[0] + COLOUR * fields[19], fields[4:6], fields[12]
        rows = np.frombuffer(data, np.uint8, pitch * height, start).reshape(height, -1)
        return rows[:, :4 * width].reshape(height, width, 4)[..., 2::-1]

    def _tell(self, *words: str) -> None:
        subprocess.run(["xdotool", *words], env=os.environ | {"DISPLAY": self.display}, check=True)

    def press(self, *keys: str) -> None:
        """Presses keys one after the other, each for at least a field of the machine."""
        self._tell("key", "--delay", "40", *keys)

    def type(self, text: str) -> None:
        """Types text."""
        self._tell("type", "--delay", "40", text)

    def enter(self, command: str) -> None:
        """Types a command and Return."""
        self.type(command)
        self.press("Return")

    def wait(self, what: str, ready: Callable[[np.ndarray], bool], still: bool = True) -> np.ndarray:
        """Returns the first picture that is ready; fails after PATIENCE. The file is read while it
        is written: if the picture should be still, it must be the same twice."""
        silence, last = Silence(os.getpid(), PATIENCE), None
        while True:
            shot = self.shot()
            if ready(shot) and (not still or np.array_equal(shot, last)):
                return shot
            assert not (said := silence.end()), f"{what}: not to be seen, {said}"
            last = shot
            time.sleep(0.05)

    def settled(self, what: str, pause: float = 0.5) -> np.ndarray:
        """Returns the picture once it has not changed for ``pause`` seconds and has more than one
        colour."""
        last, since = self.shot(), time.monotonic()

        def ready(shot: np.ndarray) -> bool:
            nonlocal last, since
            if (shot != last).any():
                last, since = shot, time.monotonic()
            return time.monotonic() - since > pause and len(np.unique(shot)) > 2

        return self.wait(what, ready)


@contextlib.contextmanager
def screen(folder: Path) -> Iterator[Screen]:
    """Starts an X server; ends it afterwards."""
    folder.mkdir()
    reader, writer = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{show.WIDTH}x{show.HEIGHT}x24",
         "-fbdir", str(folder)], pass_fds=[writer], stderr=subprocess.DEVNULL)
    try:
        os.close(writer)
        with os.fdopen(reader) as stream:
            number = stream.readline().strip()
        assert number, "Xvfb does not start"
        yield Screen(f":{number}", folder)
    finally:
        server.kill()
        server.wait()


def window(on: Screen) -> Display:
    """The window options of ``make show``, at the machine's own speed: in warp mode keys repeat
    while they are pressed, and the emulator writes over the picture."""
    return Display(show.OPTIONS, {"SDL_VIDEODRIVER": "x11", "DISPLAY": on.display})


@contextlib.contextmanager
def shell(on: Screen, volume: dict[str, bytes | Path], directory: Path, then: str = "") -> Iterator[Path]:
    """Starts the machine in a window, with these files, at its prompt or with a command; yields their folder."""
    folder = directory / "volume"
    (folder / "S").mkdir(parents=True)
    (folder / "S" / "Startup-Sequence").write_text(f"echo >started\n{then}\n")
    for name, content in volume.items():
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.read_bytes())
    display = window(on)
    config = emulator.write_config(directory, "a1200-fast", display, {"hard_drive_0": str(folder)})
    with emulator.started(["fs-uae", str(config)], directory, display.environment, directory / "emulator.log"):
        on.wait("the start-up script's end", lambda _: (folder / "started").exists())
        yield folder
