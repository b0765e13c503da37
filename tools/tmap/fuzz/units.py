"""Random polygons of texture units (tmap.corpus.random_n64, random_glide) for the fuzzer: each has a frame, which must be
the model's, bit for bit. Scenes of MOST polygons each have the formats of frames in turn."""

import sys
from types import ModuleType

import numpy as np

from tmap.base import workers
from tmap.base.errors import UserError
from tmap.corpus import random_glide, random_n64
from tmap.fuzz.families import GLIDE, N64, again, named
from tmap.fuzz.tally import Fault, Tally
from tmap.guest.emulator import SECOND
from tmap.guest.guest_frames import draw, first_wrong, frame_of, is_models
from tmap.model import model
from tmap.run.polygon_report import save_picture
from tmap.scene_file.scene_file import Scene

UNITS: dict[str, ModuleType] = {N64: random_n64, GLIDE: random_glide}
SCENES = 8  # in a part; the emulated A1200 draws the first one, if another processor is asked for
MACHINE = "a1200-fast"


def part_size(family: str) -> int:
    """Returns how many polygons one worker draws at a time."""
    return SCENES * UNITS[family].MOST


def scene_of(seed: int, numbers: list[int], family: str) -> Scene:
    """Returns the scene of polygons of the same MOST."""
    made = UNITS[family]
    pixels = made.PIXELS[numbers[0] // made.MOST % len(made.PIXELS)]
    return made.scene([made.case(seed, n, pixels) for n in numbers], seed, pixels)


def check(each: Scene, numbers: list[int], digests: dict[str, np.ndarray], tally: Tally) -> None:
    """Compares the frames of a scene; ``digests``: by machine."""
    for k, number in enumerate(numbers):
        frame = model.render(each, k)
        pixels = int((frame != each.background).sum())
        tally.counts.update(polygons=1, drawn=int(len(np.unique(frame)) > 2), pixels=pixels, refused=0)
        for machine, found in digests.items():
            if not is_models(frame, found[k]):
                tally.failed[number] = Fault("differs", f"{machine}: the guest's frame is not the model's", machine)


def run_scene(seed: int, numbers: list[int], machine: str, family: str, tally: Tally) -> None:
    """Draws the polygons of one scene on one machine; a crash is located by halves."""
    each = scene_of(seed, numbers, family)
    try:
        found, = draw([(each, "addx")], machine, timed=False)
    except UserError as error:
        if len(numbers) == 1:
            tally.counts.update(polygons=1)
            tally.failed[numbers[0]] = Fault("crash", str(error), machine)
            return
        middle = len(numbers) // 2
        for half in (numbers[:middle], numbers[middle:]):
            run_scene(seed, half, machine, family, tally)
        return
    check(each, numbers, {machine: found}, tally)


def run_part(seed: int, numbers: range, machine: str, family: str) -> Tally:
    """Draws and checks polygons: all on ``machine``, and all on the second processor or, if that is asked for, those of
    the first scene on the emulated A1200 too."""
    if workers.ended.is_set():
        sys.exit()
    scenes: dict[int, list[int]] = {}
    for number in numbers:
        scenes.setdefault(number // UNITS[family].MOST, []).append(number)
    parts, tally = [sorted(part, key=lambda n: UNITS[family].rank(seed, n)) for part in scenes.values()], Tally()
    made = [scene_of(seed, part, family) for part in parts]
    digests: list[dict[str, np.ndarray]] = [{} for _ in parts]
    try:
        for each, count in ((machine, len(parts)), (MACHINE, 1) if machine == SECOND else (SECOND, len(parts))):
            for k, found in enumerate(draw([(s, "addx") for s in made[:count]], each, timed=False)):
                digests[k][each] = found
    except UserError:  # a crash or a hang: scene by scene, then by halves
        for part in parts:
            run_scene(seed, part, machine, family, tally)
        return tally
    for each, part, found in zip(made, parts, digests):
        check(each, part, found, tally)
    return tally


def explanation(fault: Fault, seed: int, number: int, machine: str, family: str) -> str:
    """Returns the text that helps to find the cause: case, first wrong pixel, a picture's file, the command again."""
    made = UNITS[family]
    pixels = made.PIXELS[number // made.MOST % len(made.PIXELS)]
    this, what = scene_of(seed, [number], family), f"{named(seed, number, family)}, {pixels}: {fault.text}"
    lines = [what]
    if fault.kind == "differs":
        right, found = model.render(this, 0), frame_of(this, "addx", fault.machine or machine)
        count = int((right != found).sum())
        lines.append(f"  {count} pixels of {this.width}x{this.height}; {first_wrong(right, found)}" if count
                     else "  drawn once more it is right")
        lines.append(f"  picture (expected, found, difference): {save_picture(this, right, found, what)}")
    return "\n".join([*lines, *made.lines(made.case(seed, number, pixels)),
                      f"  again: {again(seed, number, family, machine)}"])
