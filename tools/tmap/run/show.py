"""``tmap show``: plays a scene on the emulated A1200's screen, in a window."""

import math
import os
import subprocess
from pathlib import Path

from tmap.base.errors import UserError
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator
from tmap.guest.emulator import Display
from tmap.run.run import SCENE_NAME
from tmap.scene_file.scene_file import write

#: The visible part of the PAL screen, a dot of high resolution a pixel: nothing is scaled.
WIDTH, HEIGHT = 752, 572
#: The machine runs at its normal speed and uses the window's keyboard.
OPTIONS = {"window_width": str(WIDTH), "window_height": str(HEIGHT), "zoom": "full",
           "keep_aspect": "0", "texture_filter": "nearest", "initial_input_grab": "0"}
#: What the keys of c/programs/show.c do.
KEYS = ("space: pause and go on; cursor left and right: accuracy; down and up: perspective; S: the scene's own; "
        "G: hold 25, 16.7, 12.5, 10, 8.3 frames a second, or none; escape: the end")
FIELDS, FIELDS_MAX = 50, 10  # a second; most for a frame whose rate is held
#: Variables of display servers, and the driver for each. It is given by name, so that no other
#: driver is used.
DRIVERS = {"DISPLAY": "x11", "WAYLAND_DISPLAY": "wayland"}


def answers() -> bool:
    """Returns True if an X server answers at DISPLAY: without one the emulator just ends."""
    return subprocess.run(["xdotool", "getdisplaygeometry"], capture_output=True).returncode == 0


def window() -> Display:
    """Returns a window; raises UserError if none can be opened."""
    for name, driver in DRIVERS.items():
        if place := os.environ.get(name):
            if driver == "x11" and not answers():
                raise UserError(f"show: nothing answers at DISPLAY {place}; tmap run makes pictures")
            return Display(OPTIONS, {"SDL_VIDEODRIVER": driver})
    raise UserError("show: there is no DISPLAY to open a window on; tmap run makes pictures")


def play(program: str, arguments: str, files: dict[str, bytes], machine: str,
         display: Display) -> str:
    """Runs a program in a window until its end, escape, or until the window is closed; returns what
    it printed, nothing if it was closed."""
    with emulator.workspace() as directory:
        try:
            done = emulator.run(program, arguments, files, machine, directory, patience=math.inf,
                                display=display)
        except emulator.Closed:
            return ""
    if done.code:
        raise UserError(f"{program}: return code {done.code}; {emulator.last_words(done.output)}")
    return done.output


def held(fps: float | None) -> str:
    """Returns show's argument for a rate: the most fields a frame that keep it; raises UserError."""
    if fps is None:
        return ""
    if not FIELDS / FIELDS_MAX <= fps <= FIELDS:
        raise UserError(f"--fps: a screen of {FIELDS} fields a second holds {FIELDS // FIELDS_MAX} to {FIELDS}, not {fps:g}")
    return f" HOLD {math.floor(FIELDS / fps)}"


def command(path: Path, machine: str, display: Display, fps: float | None = None) -> int:
    """``tmap show``: plays a scene file; raises UserError."""
    hold = held(fps)
    print(KEYS)
    play("show", SCENE_NAME + hold, {SCENE_NAME: write(compile_scene(path))}, machine, display)
    return 0
