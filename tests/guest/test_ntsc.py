"""An A1200 for 60 Hz, whose raster lines have 227 and 228 colour clocks alternately: clock_wait
ends, times are right, and the display is PAL while a program has it."""

import json
import re
import shutil

import numpy as np
import pytest

from tests.helpers import endings, guest_program
from tmap.base.paths import BASELINE, GUEST, PROGRAMS, ROOT
from tmap.bench import bench, owner, scenes
from tmap.build import layout
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator, guest_frames, kernels
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.guest.kernels import Case, Shown
from tmap.run import demo
from tmap.scene_file.scene_file import write

NTSC = {"ntsc_mode": "1"}
SCENE = "cube"
FIGURES = re.compile(r"(.{16})(.{7})(.{7})(.{6})  \d+ colour clocks, \d+ calls")
ROUGH = 20  # ticks by which clock_stop may be off if lines differ in length
FIELD = {"PAL": (311, 312), "NTSC": (261, 262)}  # the beam's last line
FRAMES, STEP, FIELDS = 20, "2", "4"  # of the demo's race with chip RAM alone, the step it comes to, its fields a frame
#: All positions in a line, in E-clocks; each line of NTSC meets only some of them.
PLACES = range(60, 65)
WAITS = """\
        include "amiga.i"
        include "routine.i"
        xref    clock_open
        xref    clock_start
        xref    quiet_enter
        xref    quiet_leave
{equs}
        routine main
        jsr     clock_open
{calls}
        moveq   #0,d0
        rts
{waits}
"""
CALL = """\
        jsr     quiet_enter
        moveq   #3,d0                   ; the watchdog: 276 ms
        jsr     clock_start
        bsr.w   wait_{place}
        jsr     quiet_leave
"""
SHOW = "endings SYS:shown 0 SYS: display 0 0 96 60 1 1 noise"  # tests/guest/display.c


@pytest.fixture(scope="module")
def committed() -> dict:
    """Rows of the baseline by name, machine and length."""
    baseline = json.loads(BASELINE.read_text())
    return {bench.key(row): row for kind in ("rows", "frames") for row in baseline[kind]}


def plan(committed: dict) -> bytes:
    """The plan that owners measure; the disk's tests compare its pixels."""
    cases = [Case("nothing", repeats=bench.NOTHING_REPEATS, shown=Shown("", 0, 0, 0, 0))]
    for entry, row in zip(owner.ENTRIES, owner.rows(), strict=True):
        if not entry.apart:
            figure = bench.cycles(committed[entry.name, "a1200", entry.length])
            row.case.shown = Shown(entry.title, row.units, round(1000 * figure), 0, 0)
            cases.append(row.case)
    return kernels.plan(cases)


def waits() -> str:
    """A program that waits like clock_wait, for each of PLACES."""
    clock = (ROOT / "src68k" / "amiga" / "clock.s").read_text()
    body = re.search(r"\n        routine clock_wait\n(.*?\n        rts\n)", clock, re.S)[1]
    assert "BEAM_PLACE" in body
    return WAITS.format(
        equs="\n".join(re.findall(r"^LINE_\w+ +equ .*", clock, re.M)),
        calls="".join(CALL.format(place=place) for place in PLACES),
        waits="".join(f"wait_{place}\n" + body.replace("BEAM_PLACE", str(place)) for place in PLACES))


@pytest.fixture(scope="module")
def booted(committed, tmp_path_factory) -> list[emulator.Result]:
    """All commands in one boot, with chip RAM alone."""
    folder = tmp_path_factory.mktemp("ntsc")
    (folder / "waits.s").write_text(waits())
    guest_program.build(folder, folder / "waits.s")
    guest_program.build(folder, GUEST / "endings.s", GUEST / "state.s")
    for name in ("render", "measure", "demo"):
        shutil.copy(PROGRAMS / name, folder)
    noise = np.random.default_rng(11).integers(0, 256, 3 * 96 * 60, np.uint8)
    files = {"it.scene": write(scenes.shown(SCENE)[0]), "plan": plan(committed),
             "display": guest_program.build(folder, *endings.DISPLAY),
             "palette": noise[:1024].tobytes(), "noise": noise.tobytes(),
             "parts": (demo.SOURCE / demo.SCRIPT).read_bytes(),
             "race.scene": write(compile_scene(demo.SOURCE / "race.toml"))}
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(emulator.MACHINES, "ntsc", NTSC)
        done = emulator.run_batch(
            ["render it.scene FORM addx DIGEST digests", "measure table PLAN plan", SHOW,
             f'demo "" PART 1 FRAMES {FRAMES} LOG', "waits"], files, "ntsc", folder / "run",
            programs=folder, patience=60)
    assert [result.code for result in done[:-1]] == [0] * (len(done) - 1), done
    return done


def test_wait_comes_to_an_end(booted):
    """Wherever in a line E-clocks begin."""
    assert booted[-1].code == 0, f"clock_wait stopped by the watchdog: {booted[-1].output}"


def test_frames_take_what_is_committed(booted, committed):
    """Within the bench's own tolerance, as refresh comes at other times, plus ROUGH."""
    digests = np.fromfile(booted[0].directory / "digests", layout.load().struct("frame_digest").dtype)
    frames = scenes.shown(SCENE)[1]
    assert all(map(guest_frames.is_models, frames, digests)) and len(frames) == len(digests)
    cycles = digests["ticks"].astype(int).mean() * CYCLES_PER_TICK
    expected = committed[f"scene_{SCENE}", "a1200", scenes.FRAMES]["cycles_per_frame"]
    doubt = bench.TOLERANCE * expected + ROUGH * CYCLES_PER_TICK
    assert abs(cycles - expected) <= doubt, f"{cycles} cycles a frame, {expected} committed"


def test_measure_shows_what_is_committed(booted, committed):
    lines = emulator.read(booted[1].directory / "table").splitlines()
    assert re.fullmatch(r"Here: exec \d+\.\d+, 68020, AGA, NTSC, 14318180 Hz, 204. KB chip, "
                        "0 KB fast", lines[1]), lines[1]
    entries = [entry for entry in owner.ENTRIES if not entry.apart]
    for entry, line in zip(entries, lines[4:], strict=False):
        row = committed[entry.name, "a1200", entry.length]
        title, here, *_ = FIGURES.fullmatch(line).groups()
        doubt = bench.TOLERANCE * bench.cycles(row) + 2 * ROUGH * row["one_tick"] + 0.01
        assert title.strip() == entry.title, line
        assert abs(float(here) - bench.cycles(row)) <= doubt, f"{line}: {row}"


def test_display_is_pals_while_it_is_ours(booted):
    """312 lines, enough for 256 and two status lines; 262 before and afterwards."""
    before, after, code = (int(line.split()[-1]) for line in booted[2].output.splitlines())
    said = emulator.read(booted[2].directory / "shown").splitlines()
    shown = [int(line.split()[6]) for line in said]
    assert code == 0 and before == after and before in FIELD["NTSC"]
    assert len(shown) == 3 and all(line in FIELD["PAL"] for line in shown)


def test_demo_comes_in_time(booted):
    """Counted in PAL fields, for which the demo has its budget."""
    frames = re.findall(r"^frame \d+ step (\d+) fields (\d+)", booted[3].output, re.M)
    settled = [fields for step, fields in frames if step == STEP]
    assert len(settled) > FRAMES // 2 and set(settled) == {FIELDS}, booted[3].output
