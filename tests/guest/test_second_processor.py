"""The second processor: what a program does there is what it does on the emulated A1200."""

import contextlib
import os
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.helpers import guest_program
from tmap.base.errors import UserError
from tmap.base.paths import GUEST, SCENES
from tmap.bench import cases
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator, guest_frames, kernels
from tmap.guest.emulator import SECOND

MACHINE = "a1200-fast"
#: Scenes that between them have all engines, orders, and formats of texels.
DRAWN = ("mappers", "wide", "dithered", "corridor", "floor", "movers", "torch", "lamps", "n64_room", "glide_floor")
#: Routines of failures.s with their numbers there, and what is said of them.
CRASHES = {"illegal_one": (0, r"exception 4 \(illegal instruction\)"),
           "zero_divide": (1, r"exception 5 \(division by zero\)"), "line_f": (5, r"exception 11 \(line F\)")}


def test_kernels_return_the_same() -> None:
    """Memory and registers after a call of each kernel of the bench, every bit, those that a contract leaves open too.
    Addresses of arenas, of code and of the program's data differ by as much as these lie elsewhere."""
    rows = {row.case.kernel: row for kind in cases.KINDS for row in cases.rows(kind, False)
            if row.case.display == "OFF"}
    some = [replace(row.case, repeats=0) for row in rows.values()]
    first, second = (
        [result for batch in kernels.batches(some, machine)
         for result in kernels.call_batch(batch, machine, None, False)] for machine in (MACHINE, SECOND))
    moves = set()
    for case, one, other in zip(some, first, second, strict=True):
        known = {0, other.address - one.address, other.far_address - one.far_address}
        for name in ("memory", "far_memory"):
            before, after = (np.frombuffer(getattr(each, name), ">u4").astype(np.int64) for each in (one, other))
            moves |= {(case.kernel, int(move)) for move in np.unique(after - before) if move not in known}
        moves |= {(case.kernel, move) for move in (other.registers[r] - one.registers[r] for r in one.registers)
                  if move not in known}
    assert len({move for _, move in moves}) <= 2, moves


def test_frames_are_the_same() -> None:
    scenes = [compile_scene(SCENES / f"{name}.toml") for name in DRAWN]
    scenes = [(scene, f"addx FRAMES {min(scene.frames, 2)}") for scene in scenes]
    for name, first, second in zip(DRAWN, *(guest_frames.draw(scenes, machine, timed=False)
                                            for machine in (MACHINE, SECOND)), strict=True):
        for field in ("sum", "hash", "result"):
            assert (first[field] == second[field]).all(), (name, field)


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """A folder with ``failures``."""
    folder = tmp_path_factory.mktemp("programs")
    guest_program.build(folder, GUEST / "failures.s")
    return folder


@pytest.mark.parametrize("name", CRASHES)
def test_crash_is_reported(programs, tmp_path, name) -> None:
    number, why = CRASHES[name]
    with pytest.raises(UserError, match=rf"failures {number}: .*failures crashed: {why} at PC \$[0-9a-f]+, in {name}"):
        emulator.run("failures", str(number), {}, SECOND, tmp_path, programs=programs)


def test_no_end_is_reported(programs, tmp_path) -> None:
    with pytest.raises(UserError, match="failures 9: it did not end, 2 s of processor time"):
        emulator.run("failures", "9", {}, SECOND, tmp_path, programs=programs, patience=2)
    time.sleep(0.5)
    assert not any(place.startswith(str(tmp_path)) for place in folders_of_processes())


def folders_of_processes() -> Iterator[str]:
    """Yields the current folder of each process."""
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):  # it has ended
            yield os.readlink(process / "cwd")


def test_a_stack_deeper_than_a_shells_is_refused(tmp_path) -> None:
    source = tmp_path / "deep.c"
    source.write_text("""#include "system/system.h"
int main(void)
{
    volatile uint8 room[5000];

    room[0] = 1;
    return room[0] - 1;
}
""")
    guest_program.build(tmp_path, source)
    with pytest.raises(UserError, match="deep crashed: .*50[0-9]{2} bytes of stack were used; a shell gives 4096"):
        emulator.run("deep", "", {}, SECOND, tmp_path / "run", programs=tmp_path)
