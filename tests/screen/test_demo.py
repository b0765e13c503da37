"""The demo on the emulated machines: the frame rate of each part, the governor's steps, the race,
how it ends, and which input it refuses.
"""

import re
import shutil
from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import endings, guest_program
from tests.helpers.endings import AT_ONCE, KEYS
from tmap.base.paths import PROGRAMS
from tmap.build import layout
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator, guest_frames
from tmap.run import demo
from tmap.run.governor import Governor

FRAMES = 100
MOST = 80  # most pictures of a form in the race's frames
CLOCK_FIELDS = 2  # for which a frame counts in the length of parts without a fixed rate
FORMS = ("addx", "swap")  # of the race
#: How far the ratio of both forms' times in the race may be from render's; interrupts slow both
#: forms. This is what the demo's figures promise, not a derived bound.
RATIO = 0.02
FIELD = 312 * 227  # colour clocks
#: The share of the display's DMA if code and data are in chip RAM: of a field's 312 lines of 227
#: colour clocks, 256 have 40 fetches (8 planes, 64 pixels each), 20 have 10 of the status lines,
#: and the copper reads 2 x 530 words. The CPU has every other colour clock, so each fetch costs it
#: two at most.
DISPLAY = 2 * (256 * 40 + 20 * 10 + 2 * 530) / FIELD
RACE, EDGES, PERSPECTIVE, HALL, MIRROR, OCEAN, FLOOR, ROTATOR = PARTS = range(1, 9)
#: Parts with the frame rate of their step once the governor has settled.
KEPT = RACE, EDGES, PERSPECTIVE, ROTATOR
FREE = HALL, MIRROR, OCEAN, FLOOR
SECOND = 50  # fields
FIRST = 2 * SECOND  # until the demo's first picture
BUSY = "display 8 0 320 256 1 1"  # tests/guest/display.c
KEY_FIELDS = 30  # of KEYS: cursor left, space, escape released, space, escape, one each so many
NUMBER = re.compile(r"\b(\w+) (\d+)")


class Played:
    """A part of the demo, as logged with LOG."""

    def __init__(self, frames: int, fields: int, step: int, waited: int, black: int, **_):
        self.frames, self.fields, self.step = frames, fields, step
        self.waited, self.black = waited, black  # fields, to the first picture
        self.panes = []  # pictures, ticks, used
        self.each = []  # step from 1, fields, work, lines


def read(output: str) -> dict[int, Played]:
    """Parses the demo's output into parts."""
    parts = {}
    for line in output.splitlines():
        found = [(name, int(value)) for name, value in NUMBER.findall(line)]
        kind, numbers = found[0][0], [value for _, value in found]
        if kind == "part":
            part = parts[numbers[0]] = Played(**dict(found[1:7]))
        else:
            {"pane": part.panes, "frame": part.each}[kind].append(numbers[1:])
    return parts


@pytest.fixture(scope="module")
def data() -> dict[str, bytes]:
    return demo.data()


@pytest.fixture(scope="module", params=["a1200-fast", "a1200"])
def played(request, data, tmp_path_factory):
    """The machine; its parts; the ticks of the race's frames by render, one row a form; and the
    ticks of one piece of work, timed repeatedly, the first time with interrupts off."""
    programs = tmp_path_factory.mktemp("programs")
    guest_program.build(programs, *endings.DISPLAY)
    for name in ("demo", "render"):
        shutil.copy(PROGRAMS / name, programs)
    done = emulator.run_batch(
        [f'demo "" FRAMES {FRAMES} LOG', BUSY] + [f"render race.scene FORM {form} FRAMES {MOST}"
                                                  for form in FORMS],
        data, request.param, tmp_path_factory.mktemp("played"), programs=programs, patience=60)
    assert [each.code for each in done] == [0] * len(done), done[0].output[-300:]
    quiet = [np.array([int(line.split()[3]) for line in each.output.splitlines()])
             for each in done[2:]]
    return request.param, read(done[0].output), quiet, [int(n) for n in done[1].output.split()]


STEP = re.compile(r"^step \d+ \d+ (?P<fields>\d+) \w+ (?P<name>.*)$", re.M)
PANE = re.compile(r"^pane \d+ \d+ (?P<form>\w+) \d+ (?P<perspective>\w+) (?P<dearest>\d+) ", re.M)


@pytest.mark.parametrize("part, name", [(RACE, "race"), (PERSPECTIVE, "face")])
def test_the_dearest_frames_are_named(data, part: int, name: str):
    """Where panes take turns, no picture takes longer than the named one and an eighth (lanes_probe)."""
    panes = list(PANE.finditer(data[demo.SCRIPT].decode().split("\npart ")[part]))
    made = compile_scene(demo.SOURCE / f"{name}.toml")
    scenes = []
    for pane in panes:
        own = pane["perspective"]
        materials = [material if own == "own" or material.perspective == "none" else
                     replace(material, perspective=own) for material in made.materials]
        scenes.append((replace(made, materials=materials), pane["form"]))
    for pane, digests in zip(panes, guest_frames.draw(scenes, "a1200"), strict=True):
        ticks = digests["ticks"].astype(int)
        named = int(pane["dearest"])
        assert ticks[named] * 9 // 8 > ticks.max(), (
            f"part {part}, {pane[0]}: frame {named} takes {ticks[named]} colour clocks, frame {ticks.argmax()} "
            f"{ticks.max()}; tests/scenes/demo/{demo.SCRIPT}")


def test_all_parts_are_played(played):
    machine, parts, *_ = played
    assert list(parts) == list(PARTS)
    assert all(part.frames == FRAMES for n, part in parts.items() if n not in FREE)


def steps_of(data: dict[str, bytes], part: int) -> list[re.Match]:
    """The steps of a part in the script: fields a picture, name."""
    return list(STEP.finditer(data[demo.SCRIPT].decode().split("\npart ")[part]))


def test_frames_come_in_time(played, data):
    """Once the governor has settled, each frame is shown for its step's fields, and the step's name says how many these
    are in a second. The first frame may be late: the blitter has none to work on while it is drawn."""
    machine, parts, *_ = played
    for number in KEPT:
        script = steps_of(data, number)
        assert [step["name"] for step in script] == [f"{SECOND / int(step['fields']):.1f} a second" for step in script]
        last = parts[number].each[-1][0]
        fields = [fields for step, fields, *_ in parts[number].each[1:] if step == last]
        assert len(fields) > FRAMES // 4 and set(fields[1:]) == {int(script[last - 1]["fields"])}, (
            f"{machine}, part {number}, step {last}: fields {fields}")


def test_waits_are_short(played):
    """The first picture, from when the display is taken, and how long the screen is black before a part."""
    machine, parts, *_ = played
    assert parts[RACE].waited <= FIRST, f"{machine}: {parts[RACE].waited} fields"
    for number, part in parts.items():
        assert part.black <= SECOND, f"{machine}, part {number}: {part.black} fields"


def test_triangles_are_counted(data):
    """The mirror's caption says how many it has."""
    said = int(re.search(r"^says A knot of (\d+) triangles:$", data[demo.SCRIPT].decode(), re.M)[1])
    assert len(compile_scene(demo.SOURCE / "mirror.toml").faces) == said


def test_steps_have_equal_times(played, data):
    """In parts without a fixed frame rate each step has an equal share of the time: it begins with
    the frame after the one in which its share of the time begins."""
    machine, parts, *_ = played
    for number in FREE:
        each, count = parts[number].each, len(steps_of(data, number))
        steps = [step for step, *_ in each]
        assert steps == sorted(steps) and set(steps) == set(range(1, count + 1)), (
            f"{machine}, part {number}: {steps}")
        for step in range(2, count + 1):
            first = steps.index(step)
            before = sum(fields for _, fields, *_ in each[:first - 1])
            share = FRAMES * CLOCK_FIELDS * (step - 1) / count
            assert before >= share > before - each[first - 2][1], (
                f"{machine}, part {number}, step {step}: {each}")


def test_governor_is_the_models(played, data):
    """The steps are the model's exactly, computed from the times in the log."""
    machine, parts, *_ = played
    budget = layout.load().constants["FIELD_BUDGET"]
    for number in KEPT:
        model = Governor([int(step["fields"]) * budget for step in steps_of(data, number)])
        for frame, (step, _, work, _) in enumerate(parts[number].each):
            assert step == model.step + 1, f"{machine}, part {number}, frame {frame}"
            model.next(work)


def test_fast_ram_reaches_better_steps(played):
    """Fast RAM reaches better steps: the rates of pictures."""
    machine, parts, *_ = played
    better = {"a1200-fast": 1, "a1200": 2}[machine]
    assert [parts[number].step for number in KEPT] == [better, better, 1, better], machine


def interrupted(busy: list[int], elapsed: int) -> int:
    """The most ticks that interrupts took in a period of ``elapsed`` ticks, anywhere in the
    measured work."""
    exact, *ticks = busy
    ends = np.cumsum([0, *ticks])
    assert ends[-1] > 2 * elapsed, f"{ends[-1]} ticks are measured, {elapsed} elapsed"
    taken = []
    for first, begin in enumerate(ends):
        last = int(np.searchsorted(ends, begin + elapsed))
        if last < len(ends):
            taken.append(int(ends[last] - begin) - (last - first) * exact)
    return max(taken)


def test_race_is_the_renderers(played):
    """Each form's pictures take at least what render measures for the same frames with the system
    off. The extra time of both together is at most what interrupts take of the race's whole time,
    plus, with chip RAM alone, the display's share. Every COUNT_EVERY-th picture is left out, as its
    pixels are counted."""
    machine, parts, quiet, busy = played
    every = layout.load().constants["COUNT_EVERY"]
    display = DISPLAY if machine == "a1200" else 0
    times, longer = [], 0
    for form, ticks, (pictures, summed, _) in zip(FORMS, quiet, parts[RACE].panes):
        timed = [number for number in range(pictures) if number % every]
        here, there = summed / len(timed), ticks[timed].mean()
        assert here >= there, f"{form}: {here:.0f} ticks a picture, render {there:.0f}"
        longer += summed * (1 - display) - ticks[timed].sum()
        times.append((here, there))
    (addx, quiet_addx), (swap, quiet_swap) = times
    most = interrupted(busy, parts[RACE].fields * FIELD)
    said = (f"ticks a picture: addx {addx:.0f}, render {quiet_addx:.0f}; swap {swap:.0f}, render "
            f"{quiet_swap:.0f}; scripts/tmap run tests/scenes/demo/race.toml --form swap")
    assert longer <= most, f"{longer:.0f} ticks longer, interrupts took {most}; {said}"
    # what both forms take alike, as the clearing of a pane line by line, is no part of the difference
    more, exact = swap - addx, quiet_swap - quiet_addx
    assert abs(more / exact - 1) <= 1 / (1 - RATIO - display) - 1, f"{more / exact - 1:.4f}; {said}"


def test_lanes_have_equal_time(played):
    """The pane with the least time is drawn next: panes differ by at most one picture, which may
    take twice the mean."""
    machine, parts, *_ = played
    for number in (RACE, PERSPECTIVE):
        panes = parts[number].panes
        worst = max(used / pictures for pictures, _, used in panes)
        spread = max(u for *_, u in panes) - min(u for *_, u in panes)
        assert spread <= 2 * worst, f"{machine}, part {number}: {panes}"


def changes(steps: list[int]) -> int:
    """How often a sequence changes direction."""
    ways = [b > a for a, b in zip(steps, steps[1:]) if a != b]
    return sum(a != b for a, b in zip(ways, ways[1:]))


@pytest.mark.parametrize("seed", range(20))
def test_governor_does_not_oscillate(seed):
    """A load that varies by less than a tenth changes the step in only one direction."""
    rng = np.random.default_rng(seed)
    for case in range(20):
        count = int(rng.integers(2, 7))
        costs = np.sort(rng.integers(20_000, 250_000, count))[::-1]
        governor = Governor([134_000] * count)
        steps = [0]
        for _ in range(300):
            load = costs[governor.step] * rng.uniform(1, 1.1)
            steps.append(governor.next(int(load)))
        assert changes(steps) == 0, f"seed {seed}, case {case}, costs {costs.tolist()}: {steps}"


def test_governor_goes_up_where_there_is_room():
    """If the load halves the better step returns, but only after a calm second."""
    governor = Governor([134_000] * 2)
    for _ in range(10):
        governor.next([150_000, 100_000][governor.step])
    assert governor.step == 1
    steps = [governor.next(50_000) for _ in range(60)]
    assert 25 <= steps.index(0) < 50 and not any(steps[steps.index(0):])


#: How, command line, return code. Part 9 lacks its scene.
ENDINGS = [(0, "demo SYS: PART 5 FRAMES 2", 0), (0, "demo SYS: PART 6 FRAMES 2", 0),
           (0, "demo SYS: PART 9", 5), (AT_ONCE, "demo SYS: PART 1", 5),
           (0, "demo SYS: PART 10", 10), (0, "demo none", 10), (KEYS, "demo SYS:", 0)]


@pytest.fixture(scope="module")
def ended(data, tmp_path_factory) -> list[endings.Ended]:
    parts = data[demo.SCRIPT]
    broken = parts + parts[parts.rindex(b"\npart "):].replace(b"scene rotator.", b"scene nothing.")
    return endings.run(ENDINGS, data | {"demo": PROGRAMS / "demo", "parts": broken}, "a1200-fast",
                       tmp_path_factory.mktemp("ended"), "demo SYS: PART 7 FRAMES 2", timed=False)


def test_endings(ended):
    """Return codes and last lines; the machine's state is as before."""
    for (_, line, code), found in zip(ENDINGS, ended, strict=True):
        assert found.code == code and not found.lost(), (line, found.said, found.lost())
    missing, broken_off, no_part, no_parts = (found.said for found in ended[2:6])
    assert missing[-1] == "SYS:nothing.scene: cannot be opened" and "***Break" in broken_off
    assert no_part[-1].startswith("demo: PART") and no_parts[-1].startswith("none/parts: ")


def test_keys(ended):
    """Space ends a part and the next one begins; escape ends the demo when it is pressed; other
    keys do nothing. Without keys the parts would take 8 and 10 seconds."""
    parts = read("\n".join(ended[-1].said))
    assert list(parts) == [RACE, EDGES, PERSPECTIVE], ended[-1].said
    for part in parts.values():
        assert part.frames > 0 and part.fields <= 2 * KEY_FIELDS, ended[-1].said
