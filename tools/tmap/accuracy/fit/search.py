"""The search of ``tmap fit``: measures single changes, predicts all others, and measures what it would choose.

Materials cover different pixels, so what one of them costs and errs hardly depends on the others: some frames are
measured with one change at a time, and changes are added up. What is chosen is measured in all frames; where it was
predicted too low, its worst frame is measured too, and the next choice is tried.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tmap.accuracy.fit import steps
from tmap.accuracy.fit.steps import Choice, Space
from tmap.accuracy.fit.trials import Bench, Trial, joined, summed
from tmap.base.errors import UserError
from tmap.bench.scenes import some_frames
from tmap.compiler.scene import compile_scene, content_of, parse, text_of
from tmap.compiler.space import SIZES
from tmap.guest.emulator import CLOCK_HZ
from tmap.run import conversion

SAMPLES = 3  # frames that are measured beside the worst one
TRIES = 12  # choices that are measured in all frames, at most
NEAR = 1.1  # times as long as is allowed: what takes more is not made to hold the rate by single changes
NEXT = 1.02  # times shorter than a choice for which the blitter was late: what is tried next
MORE = 3  # frames that are added to those of the search, at most, in pixels of a size


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
    numbers: list[int]  # frames that every trial but those of single frames has
    predicted: list["Predicted"]


@dataclass
class Predicted:
    """A choice, and what the sums say of it."""

    choice: Choice
    worst: float  # cycles
    rms: float

    def order(self, space: Space) -> tuple:
        """Returns the order of choices: least error first; of equal ones, as they are said, the more exact settings."""
        return shown(self.rms), space.edges.index(self.choice.edges), sum(self.choice.steps), self.worst


def shown(rms: float) -> float:
    """Returns an error as it is said: smaller differences are chance."""
    return round(rms, 1)


class Size:
    """What is known of the choices in pixels of a size."""

    def __init__(self, bench: Bench, pixel: str, numbers: list[int]) -> None:
        self.bench, self.pixel = bench, pixel
        self.sets = [numbers]  # of frames
        exact = bench.space.exact(pixel)
        self.rms = summed(bench.differences(some_frames(bench.compiled(exact), numbers), numbers)).rms
        self.choices: list[Predicted] = []  # none yet
        self.is_open = True
        self.above = 1.0  # times what was predicted

    def measure(self) -> None:
        """Measures single changes, and predicts all choices."""
        frames = self.sets[-1]
        what = f"pixels of {self.pixel}, " + (f"frame {frames[0]}" if len(self.sets) > 1 else "single changes")
        space, self.is_open = self.bench.space, False
        singles = dict.fromkeys(space.singles(self.pixel))
        self.bench.measure(list(singles), frames, what)
        for choice in singles:
            some = [self.bench.trials.get((choice, *numbers)) for numbers in self.sets]
            singles[choice] = None if None in some else joined(some)
        self.choices = predictions(space, self.pixel, singles)

    def left(self, budget: float, tried: set[Choice]) -> list[Predicted]:
        """Returns the choices that may hold the rate."""
        return [each for each in self.choices if each.worst * self.above <= budget and each.choice not in tried]

    def learn(self, trial: Trial, first: Predicted, budget: float) -> None:
        """Takes a trial of all frames that does not hold the rate: its worst frame is measured too, or what follows
        must be predicted to take less."""
        frame = int(np.argmax(trial.drawing))
        if trial.busy <= budget:
            self.above = NEXT * budget / first.worst
        elif len(self.sets) <= MORE and not any(frame in some for some in self.sets):
            self.sets.append([frame])
            self.measure()
        else:
            self.above = max(self.above, trial.busy / first.worst)


def predictions(space: Space, pixel: str, singles: dict[Choice, Trial | None]) -> list[Predicted]:
    """Returns all choices in pixels of a size with what trials of single changes say of them."""
    known = [each for each in singles.values() if each]
    showing = np.array([each.showing for each in known]).min(axis=0)  # where it waits for nothing
    made = []
    for choice in space.every(pixel):
        parts = [(singles[each], factor) for each, factor in space.parts(choice).items() if factor]
        if any(trial is None for trial, _ in parts):
            continue
        drawing = sum(factor * np.array(trial.drawing) for trial, factor in parts)
        squares = sum(factor * trial.off.squares for trial, factor in parts)
        off = replace(parts[0][0].off, squares=max(squares, 0))
        made.append(Predicted(choice, float((drawing + showing).max()), off.rms))
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


def search(bench: Bench, sizes: list[str], numbers: list[int], every: list[int], fps: float,
           predicted: list[Predicted]) -> Trial | None:
    """Returns the most exact choice that holds the rate in all frames. Looks at the choice of the least error first;
    of a size that was not measured yet, that is the error of its most exact choice. Adds what it predicts to
    ``predicted``."""
    budget, tried = CLOCK_HZ / fps, set()
    ends = bench.measure([choice for pixel in sizes for choice in (bench.space.cheap(pixel), bench.space.bent(pixel))],
                         numbers, "the cheapest of each size")
    near = {trial.choice.pixel for trial in ends if trial and trial.busy <= NEAR * budget}
    known = {pixel: Size(bench, pixel, numbers) for pixel in sizes if pixel in near}
    best = None
    while not best and len(tried) < TRIES:
        left = [each for size in known.values() for each in size.left(budget, tried)]
        first = min(left, key=lambda each: each.order(bench.space), default=None)
        unknown = min((size for size in known.values() if size.is_open), key=lambda size: size.rms, default=None)
        if unknown and (not first or shown(unknown.rms) <= shown(first.rms)):
            unknown.measure()
            continue
        if not first:
            break
        tried.add(first.choice)
        trial, = bench.measure([first.choice], every, "all frames")
        if trial and trial.holds(fps):
            best = trial
        elif trial:
            known[first.choice.pixel].learn(trial, first, budget)
    predicted += [each for size in known.values() for each in size.choices]
    return best


def whole(bench: Bench, trial: Trial | None, every: list[int], fps: float) -> Trial | None:
    """Returns a trial of all frames if it holds the rate, as one of some frames does."""
    if not trial or not trial.holds(fps):
        return None
    again, = bench.measure([trial.choice], every, "all frames")
    return again if again and again.holds(fps) else None


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
    predicted: list[Predicted] = []
    best = own if own and own.holds(fps) and not shown(own.off.rms) else whole(bench, exact, every, fps)
    best = best or search(bench, sizes, numbers, every, fps, predicted)
    best = best or fastest(bench, predicted, every)
    if best and own and own.holds(fps) and shown(own.off.rms) <= shown(best.off.rms):
        best = own
    holds = bool(best and best.holds(fps))
    return Found(space, list(bench.trials.values()), own, exact, best, holds, bench.refused, numbers, predicted)


def fastest(bench: Bench, predicted: list[Predicted], every: list[int]) -> Trial | None:
    """Returns the fastest choice, measured in all frames: the nearest to a rate that none holds."""
    some = [(trial.busy, trial.off.rms, trial.choice) for trial in bench.trials.values()]
    some += [(each.worst, each.rms, each.choice) for each in predicted if each.choice not in bench.refused]
    if not some:
        return None
    trial, = bench.measure([min(some, key=lambda each: each[:2])[2]], every, "the fastest")
    return trial
