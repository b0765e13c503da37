"""Trials of ``tmap fit``: a scene with some settings, measured on the emulated machine's screen and compared with the
exact picture.

`show` draws, converts and shows the frames while display, blitter and interrupts run. A frame's cycles are those from
the background until its conversion has ended, with the wait for the blitter, which still merges the frame before.
"""

import contextlib
import io
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from tmap.accuracy.fit.steps import Choice, Space, keys_of
from tmap.accuracy.resolutions import Difference, colours, difference
from tmap.base.errors import UserError
from tmap.bench.scenes import some_frames
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator
from tmap.guest.emulator import CLOCK_HZ, CYCLES_PER_TICK
from tmap.model import model
from tmap.run import run
from tmap.scene_file.scene_file import Scene, write

FIELDS = 50  # a second
LINE = re.compile(r"drawn (\d+) converted (\d+) field (\d+)")
PARTS = ("numbers", "drawing", "showing", "fields", "exact")  # of a trial, one for each frame
DRAWN_ON = "a1200-fast"  # what pictures are drawn on: they are every machine's


@dataclass
class Trial:
    """What some settings cost, and how far their pictures are off."""

    choice: Choice
    numbers: list[int]  # of the frames
    drawing: list[int]  # cycles of each
    showing: list[int]
    fields: list[int]  # for which each was shown
    off: Difference | None = None
    exact: list = field(default_factory=list, repr=False)  # each frame's Difference

    @property
    def work(self) -> np.ndarray:
        """Cycles of each frame."""
        return np.array(self.drawing) + self.showing

    @property
    def worst(self) -> int:
        """The cycles of the worst frame."""
        return int(self.work.max())

    @property
    def rates(self) -> tuple[float, float]:
        """Frames a second of the worst frame and of the mean. A frame that waits for a field is as fast as the fields
        say."""
        return (max(CLOCK_HZ / self.worst, FIELDS / max(self.fields)),
                max(CLOCK_HZ / float(self.work.mean()), FIELDS * len(self.fields) / sum(self.fields)))

    @property
    def busy(self) -> int:
        """The cycles of the worst frame without waits for the blitter and for fields."""
        return max(self.drawing) + min(self.showing)

    def holds(self, fps: float) -> bool:
        """Returns True if the processor is in time with every frame, and each was in time on the screen, where frames
        begin with fields."""
        return self.busy * fps <= CLOCK_HZ and max(self.fields) <= -(-FIELDS // fps) \
            and sum(self.fields) * fps <= FIELDS * len(self.fields) + fps

    def of(self, numbers: list[int]) -> "Trial":
        """Returns the trial of some of its frames alone."""
        at = [self.numbers.index(number) for number in numbers]
        parts = {name: [getattr(self, name)[k] for k in at] for name in PARTS}
        return Trial(self.choice, **parts, off=summed(parts["exact"]))


def count_of(scene: Scene) -> int:
    """Returns how many frames `show` is to show after its first one: one more than the scene has, as the second begins
    when the first one is shown. Those of Glide's units are drawn twice, so that what they decode once is there."""
    return scene.frames * (2 if len(scene.pipes) else 1) + 1


def times_of(output: str, frames: int) -> tuple[list[int], ...]:
    """Returns drawing, showing and fields of the last ``frames`` frames that `show` says, the scene's first one first:
    the last two are its first ones."""
    lines = [tuple(map(int, found)) for found in LINE.findall(output)]
    rows = [(CYCLES_PER_TICK * drawn, CYCLES_PER_TICK * converted, after - before)
            for (drawn, converted, after), (*_, before) in zip(lines[1:], lines)][-frames:]
    return tuple(map(list, zip(*(rows[-2:] + rows[:-2]))))


def on_screen(scenes: list[Scene], machine: str, tell: Callable[[int], None]) -> list[tuple | str]:
    """Returns each scene's times on a machine's screen, all in one boot, or why it was not shown. ``tell``: is called
    with the number of scenes done."""
    files = {f"{k}.scene": write(scene) for k, scene in enumerate(scenes)}
    commands = [f"show {k}.scene COUNT {count_of(scene)} TIMES" for k, scene in enumerate(scenes)]
    patience = emulator.PATIENT_SECONDS
    with emulator.workspace() as directory:
        done = emulator.run_batch(commands, files, machine, directory, lambda said: tell(said.count(" fields\n")),
                                  patience=patience, apart=True)
    made = []
    for scene, result in zip(scenes, done):
        if fault := emulator.explain_fault(emulator.PROGRAMS / "show", result.output):
            raise UserError(fault)
        said = result.output.strip().splitlines()[-1:]
        made.append(re.sub(r"^\d+\.scene: ", "", said[0] if said else f"show: return code {result.code}")
                    if result.code else times_of(result.output, scene.frames))
    return made


class Bench:
    """Measures choices of one scene; each is measured once."""

    def __init__(self, path: Path, space: Space, machine: str, tell: Callable[[str, int, int], None]) -> None:
        self.path, self.space, self.machine, self.tell = path, space, machine, tell
        self.trials: dict[tuple, Trial] = {}
        self.refused: dict[Choice, str] = {}  # choices that the compiler or the machine refuses, and why
        self.scenes: dict[Choice, Scene] = {}
        self.exact: list[np.ndarray] = []  # each frame's exact colours

    def compiled(self, choice: Choice) -> Scene:
        """Returns the scene under a choice; its notes are the file's own, which were said."""
        if choice not in self.scenes:
            with contextlib.redirect_stderr(io.StringIO()):
                self.scenes[choice] = compile_scene(self.path, keys=keys_of(self.space, choice))
        return self.scenes[choice]

    def draw_exact(self) -> None:
        """Draws the exact picture of each frame."""
        scene = self.compiled(self.space.exact("1x1"))
        self.tell("the exact picture", 0, 1)
        self.exact = [colours(scene, frame) for frame in run.render(scene, DRAWN_ON, "addx", timed=False).frames]

    def differences(self, scene: Scene, numbers: list[int]) -> list[Difference]:
        """Returns how far each frame is off. Those of the whole scene are drawn by the machine's program, others by the
        model, which draws the same."""
        frames = run.render(scene, DRAWN_ON, "addx", timed=False).frames if len(numbers) == len(self.exact) else \
            (model.render(scene, k) for k in range(len(numbers)))
        return [difference([colours(scene, frame)], [self.exact[number]]) for frame, number in zip(frames, numbers)]

    def measure(self, choices: list[Choice], numbers: list[int], what: str) -> list[Trial | None]:
        """Returns a trial of each choice with these frames, in one boot; None for a choice that is refused."""
        todo, scenes = [], []
        whole = len(numbers) == len(self.exact)
        for choice in dict.fromkeys(choices):
            if (choice, *numbers) in self.trials or choice in self.refused:
                continue
            try:
                scene = self.compiled(choice)
                scenes.append(scene if whole else some_frames(scene, numbers))
                todo.append(choice)
            except UserError as error:
                self.refused[choice] = str(error)
        self.tell(what, 0, len(todo))
        found = on_screen(scenes, self.machine, lambda done: self.tell(what, done, len(todo))) if todo else []
        for choice, scene, times in zip(todo, scenes, found):
            if isinstance(times, str):
                self.refused[choice] = times
                continue
            each = self.differences(scene, numbers)
            self.trials[choice, *numbers] = Trial(choice, numbers, *times, summed(each), each)
        return [self.trials.get((choice, *numbers)) for choice in choices]


def joined(trials: list[Trial]) -> Trial:
    """Returns one trial of all frames that trials of a choice have."""
    parts = {name: [value for trial in trials for value in getattr(trial, name)] for name in PARTS}
    return Trial(trials[0].choice, **parts, off=summed(parts["exact"]))


def summed(each: list[Difference]) -> Difference:
    """Returns the difference of all frames."""
    return Difference(*(sum(getattr(one, name) for one in each) for name in ("pixels", "other", "squares")))
