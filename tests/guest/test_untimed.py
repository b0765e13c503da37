"""Runs that are not timed, or exact only where they time, give what those do that are emulated cycle by cycle."""

from dataclasses import replace

import numpy as np
import pytest

from tmap.base.paths import SCENES
from tmap.bench import bench, cases
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator, guest_frames, kernels

MACHINE = "a1200-fast"


def test_kernels_return_the_same() -> None:
    """Registers, memory and far memory after a call of each kernel of the bench. A register may hold an address of
    code, which is moved by the same number of bytes for all."""
    rows = {row.case.kernel: row for kind in cases.KINDS for row in cases.rows(kind, False)
            if row.case.display == "OFF"}
    some = [replace(row.case, repeats=1) for row in rows.values()]
    assert len(some) > 100
    timed, untimed = (
        [result for batch in kernels.batches(some, MACHINE) for result in kernels.call_batch(batch, MACHINE, None, way)]
        for way in (True, False))
    moves = set()
    for case, exact, quick in zip(some, timed, untimed, strict=True):
        moves |= {exact.registers[name] - quick.registers[name] for name in exact.registers}
        assert replace(exact, cycles=0, registers={}) == replace(quick, cycles=0, registers={}), case.kernel
    assert len(moves - {0}) <= 1, moves


def test_frames_are_the_same() -> None:
    scene = replace(compile_scene(SCENES / "mappers.toml"), frames=2)
    timed, untimed = (guest_frames.draw([(scene, form) for form in ("addx", "swap", "c")], MACHINE, timed=way)
                      for way in (True, False))
    for exact, quick in zip(timed, untimed, strict=True):
        for field in ("sum", "hash", "result"):
            assert (exact[field] == quick[field]).all(), field
        assert exact["ticks"].all() and not quick["ticks"].any()


@pytest.mark.parametrize("machine", emulator.MEASURED)
def test_ticks_are_those_of_a_machine_that_is_always_exact(monkeypatch, machine: str) -> None:
    """To the tick, with maps and frame in chip RAM too. Where code is in chip RAM, some frames take up to 5 in 100,000
    more or less: a tenth of what the baseline counts as a change, so that it never makes one, is allowed. (A mapper that
    writes its code is not among them: the lines of the cache that it shares depend on where AmigaDOS loads it.)"""
    asked = [(replace(compile_scene(SCENES / f"{name}.toml"), frames=2), form)
             for name in ("cube", "corridor", "movers") for form in ("addx", "c CHIP")]
    found = guest_frames.draw(asked, machine)
    monkeypatch.setattr(emulator, "EXACT_PROGRAM", "")  # all that it does is exact, after a boot that is not
    found += guest_frames.draw(asked[:2], machine)
    monkeypatch.setattr(emulator, "EXACT_BOOT", "render")
    whole = guest_frames.draw(asked, machine)
    for each, whole in zip(found, whole + whole[:2], strict=True):
        assert all(np.array_equal(each[field], whole[field]) for field in ("sum", "hash", "result"))
        off = abs(each["ticks"].astype(int) - whole["ticks"].astype(int)) / whole["ticks"]
        assert each["ticks"].all() and off.max() <= (0 if emulator.has_fast_memory(machine) else bench.TOLERANCE / 10)
