"""The search of ``tmap fit``: measures single changes, predicts all others, and measures what it would choose.

Materials cover different pixels, so what one of them costs and errs hardly depends on the others: some frames are
measured with one change at a time, and changes are added up. What is chosen is measured in all frames; where it was
predicted too low, its worst frame is measured too, and the next choice is tried.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tmap.accuracy.fit import steps
from tmap.accuracy.fit.steps import Choice, Space
from tmap.accuracy.fit.trials import Bench, Trial, joined, summed
from tmap.accuracy.resolutions import Difference
from tmap.base.errors import UserError
from tmap.bench.scenes import some_frames
from tmap.compiler.scene import compile_scene, content_of, parse, text_of
from tmap.compiler.space import SIZES
from tmap.guest.emulator import CLOCK_HZ
from tmap.run import conversion

SAMPLES = 3  # frames that are measured beside the worst one
TRIES = 12  # choices that are measured in all frames, at most
MORE = 3  # frames that are added to those of the search, at most, in pixels of a size
WAITS = 1.05  # times the shortest conversion: a longer one has waited for the blitter


@dataclass
class Found:
    """What a search has found."""

    space: Space
    trials: list[Trial]  # in order
    own: Trial | None  # the scene as it is
    exact: Trial | None
    best: Trial | None  # that holds the rate; or else, with ``holds`` False, the fastest
    holds: bool
    refused: dict[Choice, str]


@dataclass
class Predicted:
    """A choice, and what the sums say of it."""

    choice: Choice
    worst: float  # cycles
    squares: float  # sum of a pixel's squared differences


class Size:
    """What is known of the choices in pixels of a size."""

    def __init__(self, bench: Bench, pixel: str, numbers: list[int]) -> None:
        self.bench, self.pixel = bench, pixel
        self.sets = [numbers]  # of frames
        exact = bench.space.exact(pixel)
        self.squares = squares_of(summed(bench.differences(some_frames(bench.compiled(exact), numbers), numbers)))
        self.choices: list[Predicted] = []  # none yet
        self.is_open = True
        self.above = 1.0  # times what was predicted

    def measure(self) -> None:
        """Measures single changes, and predicts all choices."""
        frames = self.sets[-1]
        what = f"pixels of {self.pixel}, " + (f"frame {frames[0]}" if len(self.sets) > 1 else "single changes")
        space, self.is_open = self.bench.space, False
        singles = dict.fromkeys([*space.singles(self.pixel), space.cheap(self.pixel)])
        self.bench.measure(list(singles), frames, what)
        for choice in singles:
            some = [self.bench.trials.get((choice, *numbers)) for numbers in self.sets]
            singles[choice] = None if None in some else joined(some)
        self.choices = predictions(space, self.pixel, singles) if singles[space.base(self.pixel)] else []

    def left(self, budget: float, tried: set[Choice]) -> list[Predicted]:
        """Returns the choices that may hold the rate."""
        return [each for each in self.choices if each.worst * self.above <= budget and each.choice not in tried]

    def learn(self, trial: Trial, first: Predicted) -> None:
        """Takes a trial of all frames that does not hold the rate."""
        frame = int(trial.work.argmax())
        if len(self.sets) <= MORE and not any(frame in some for some in self.sets):
            self.sets.append([frame])
            self.measure()
        else:
            self.above = max(self.above, trial.worst / first.worst)


def squares_of(off: Difference) -> float:
    """Returns the sum of a pixel's squared differences."""
    return off.squares / off.pixels


def predictions(space: Space, pixel: str, singles: dict[Choice, Trial | None]) -> list[Predicted]:
    """Returns all choices in pixels of a size with what trials of single changes say of them."""
    base, known = singles[space.base(pixel)], [each for each in singles.values() if each]
    showing = np.array([each.showing for each in known]).min(axis=0)  # where it waits for nothing
    fastest_one = min(known, key=lambda each: sum(each.drawing))
    waits = np.array(fastest_one.showing) > WAITS * showing
    least = np.where(waits, fastest_one.work, 0)  # until the blitter has ended
    made = []
    for choice in space.every(pixel):
        changes = [singles[each] for each in space.changes(choice)]
        if None in changes:
            continue
        drawing = np.array(base.drawing) + sum(np.array(each.drawing) - base.drawing for each in changes)
        squares = squares_of(base.off) + sum(squares_of(each.off) - squares_of(base.off) for each in changes)
        made.append(Predicted(choice, float(np.maximum(drawing + showing, least).max()), max(squares, 0)))
    return made


def evenly(frames: int, count: int) -> list[int]:
    """Returns frames evenly over a scene."""
    return sorted({k * frames // count for k in range(count)})


def sizes_of(bench: Bench) -> list[str]:
    """Returns the sizes of pixels in which the scene can be drawn and shown; raises UserError if there are none."""
    found = []
    for pixel in SIZES:
        try:
            scene = bench.compiled(bench.space.exact(pixel))
        except UserError as error:
            bench.refused[bench.space.exact(pixel)] = str(error)
            continue
        if conversion.cycles(scene, bench.machine) is not None:
            found.append(pixel)
        else:
            bench.refused[bench.space.exact(pixel)] = "the screen does not show it"
    return found


def check_shown(path: Path, scene) -> None:
    """Refuses a scene that the screen cannot show."""
    for side, size, most in (("width", scene.pixel_width, conversion.SCREEN[0]),
                             ("height", scene.pixel_height, conversion.SCREEN[1])):
        if getattr(scene, side) * size > most:
            raise UserError(f"{path}: {side}: {getattr(scene, side) * size} pixels; the screen shows {most} at most")
    if scene.width % 8:
        raise UserError(f"{path}: width: {scene.width} pixels; the screen shows multiples of 8")


def search(bench: Bench, sizes: list[str], numbers: list[int], every: list[int], fps: float) -> Trial | None:
    """Returns the most exact choice that holds the rate in all frames. Looks at the choice of the least error first; of
    a size that was not measured yet, that is the error of its most exact choice."""
    budget, tried = CLOCK_HZ / fps, set()
    cheap = dict(zip(sizes, bench.measure(list(map(bench.space.cheap, sizes)), numbers, "the cheapest of each size")))
    known = {pixel: Size(bench, pixel, numbers) for pixel in sizes if cheap[pixel] and cheap[pixel].worst <= budget}
    while len(tried) < TRIES:
        left = [each for size in known.values() for each in size.left(budget, tried)]
        first = min(left, key=lambda each: (each.squares, each.worst), default=None)
        unknown = min((size for size in known.values() if size.is_open), key=lambda size: size.squares, default=None)
        if unknown and (not first or unknown.squares <= first.squares):
            unknown.measure()
            continue
        if not first:
            break
        tried.add(first.choice)
        trial, = bench.measure([first.choice], every, "all frames")
        if trial and trial.holds(fps):
            return trial
        if trial:
            known[first.choice.pixel].learn(trial, first)
    return None


def fit(path: Path, fps: float, machine: str, tell: Callable[[str, int, int], None]) -> Found:
    """Searches the most exact settings of a scene that hold a rate on a machine's screen."""
    raw, spec = content_of(text_of(path), path), parse(path)
    scene = compile_scene(path)  # says its notes, and refuses what is wrong with the scene
    check_shown(path, scene)
    bench = Bench(path, steps.space_of(raw, spec, machine), machine, tell)
    space, every = bench.space, list(range(scene.frames))
    sizes = sizes_of(bench)
    bench.draw_exact()
    own, = bench.measure([Choice(spec["pixel"])], every, "as it is")
    numbers = sorted({*evenly(scene.frames, SAMPLES), *([int(own.work.argmax())] if own else [])})
    exact, = bench.measure([space.exact(sizes[0])], numbers, "the most exact")
    best = search(bench, sizes, numbers, every, fps)
    holds = best is not None
    if not holds:
        best = fastest(bench, sizes, every)
    return Found(space, list(bench.trials.values()), own, exact, best, holds, bench.refused)


def fastest(bench: Bench, sizes: list[str], every: list[int]) -> Trial | None:
    """Returns the fastest choice, measured in all frames: the nearest to a rate that none holds."""
    cheap = {bench.space.cheap(pixel) for pixel in sizes}
    some = [trial for trial in bench.trials.values() if trial.choice in cheap or trial.choice.edges is None]
    if not some:
        return None
    first = min(some, key=lambda trial: (trial.worst, trial.off.squares))
    trial, = bench.measure([first.choice], every, "the fastest")
    return trial
