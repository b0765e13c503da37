"""Runs that are not timed give what timed ones do, whose processor and chips are emulated cycle by cycle."""

from dataclasses import replace

from tmap.base.paths import SCENES
from tmap.bench import cases
from tmap.compiler.scene import compile_scene
from tmap.guest import guest_frames, kernels

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
