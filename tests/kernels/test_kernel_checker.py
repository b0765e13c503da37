"""The kernel checker on kernels that are broken on purpose: it must find each one."""

import copy
import re
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from tests.helpers import guest_program
from tests.helpers import kernel_checker as checker
from tests.kernels.trials import span
from tmap.base import paths
from tmap.build import contracts
from tmap.guest.kernels import Case

SOURCE = paths.ROOT / "tests" / "broken" / "span.s"
LINE = r"line \d+ \(left \d+, count \d+, u \$[0-9a-f]{8} \(-?\d+\), v \$[0-9a-f]{8} \(-?\d+\)\)"
CHANGED = r" is written, and the block does not say so: was \$[0-9a-f]+ \(-?\d+\), is \$"
#: What the checker has to say of each; span_well obeys its block.
COMPLAINTS = {
    "span_well": None,
    "span_trashes_d2": r"d2 is trashed, and the block does not say so: "
                       r"was \$dead0002 \(-\d+\), is \$00000002 \(2\)$",
    "span_writes_past": LINE + r": 1 byte\(s\) past its end" + CHANGED,
    "span_writes_before": LINE + r": 1 byte\(s\) before its start" + CHANGED,
    "span_skips_last": r"count 1, .*: pixel 0: expected \$[0-9a-f]{2} \(\d+\), found \$",
    "span_texel_beside": LINE + r": pixel 0: expected \$[0-9a-f]{2} \(\d+\), found \$",
    "span_leaves_stack": r"sp is off by 4$",
    "span_changes_map": r"map \+ 1234" + CHANGED,
    "span_changes_lines": r"lines\[0\]\.start2" + CHANGED,
    "span_changes_guard": r"8 bytes past the end of span_plan" + CHANGED,
    "span_hangs": r"exception 256 \(no end: stopped by the watchdog\) at PC \$[0-9a-f]+, "
                  r"in span_hangs\+\$",
    "span_illegal": r"exception 4 \(illegal instruction\) at PC \$[0-9a-f]+, in span_illegal\+\$",
}


def build(out: Path) -> None:
    """A program bench in ``out`` that knows the broken kernels and no others."""
    block = contract("span_affine_swap")
    (out / "table.s").write_text(contracts.kernel_table([replace(block, name=n) for n in COMPLAINTS]))
    guest_program.build(out, SOURCE, out / "table.s", main="bench")


def contract(name: str) -> contracts.Contract:
    """The block of a kernel of the tree."""
    return next(c for c in contracts.kernels(paths.ROOT / "src68k") if c.name == name)


def trials(kernel: str) -> list[checker.Trial]:
    """A good trial of span_affine_swap, for a kernel that says it is like it; twice."""
    rng = np.random.default_rng(7)
    trial = span.span_trial(
        "span_affine_swap", 0x18000, 0x14000, 0, span.SHORT, rng, False)
    trial.case.kernel, trial.case.limit = kernel, 5
    return [trial, copy.copy(trial)]


@pytest.fixture(scope="module")
def reports(tmp_path_factory):
    """What the checker says of each kernel; all are run together, crashes included."""
    out = tmp_path_factory.mktemp("broken")
    build(out)
    called = [trial for kernel in COMPLAINTS for trial in trials(kernel)]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(checker.kernels, "call_batch", partial(checker.kernels.call_batch, programs=out))
        results = checker.run(called)
    swap = replace(contract("span_affine_swap"), trashes=frozenset(("d0", "d1", "a0", "a1")))
    return {kernel: checker.report(
        replace(swap, name=kernel), *zip(*[(t, r) for t, r in zip(called, results)
                                           if t.case.kernel == kernel])) for kernel in COMPLAINTS}


@pytest.mark.parametrize("kernel", COMPLAINTS)
def test_report(reports, kernel):
    """The fault, named as what it is, and nothing else; and how to see it again."""
    found, expected = reports[kernel], COMPLAINTS[kernel]
    if expected is None:
        assert found is None
        return
    head, first, *_ = found.splitlines()
    assert re.match(rf"{kernel}: 184 lines down, dudx \$00018000 \(98304\), dvdx \$00014000 \(81920\)",
                    head), found
    assert re.search(expected, first), found
    failed = 1 if "exception" in expected else 2
    assert f"{failed} of 2 calls failed" in found
    assert len(re.findall("trashed|expected|written|off by|exception", found)) == failed, found
    assert f"tests/kernels/test_kernels.py::test_contract[{kernel}]" in found.splitlines()[-1]


def test_kernel_without_trial():
    """A new routine with a block, and nobody thought of a test."""
    block = replace(contract("span_affine_swap"), name="span_new")
    assert re.match(r"span_new \(.*affine_swap\.s:\d+\) has no trial", checker.report(block, [], []))


def test_out_registers_of_block_and_trial_differ():
    """A block's new ``out`` must not go unchecked."""
    block = contract("mul_fix")
    trial = checker.Trial(Case("mul_fix"), "")
    result = checker.kernels.Result(0, b"", 0, b"", {}, 0, 0)
    with pytest.raises(ValueError, match="mul_fix: the block's out is d0, the trial's -"):
        checker.register_complaints(trial, result, block)


def test_widths():
    """Of an ``out`` register the bits of its C type count, and no others."""
    block = contract("floor_fetch")
    trial = checker.Trial(Case("floor_fetch"), "", outputs={"d0": 0x12})
    found = {name: 0xDEAD0000 + n for n, name in enumerate(checker.kernels.REGISTERS)}
    for d0, complaints in ((0x99999912, []), (0x13, ["d0: expected $00000012 (18), found $00000013 (19)"])):
        result = checker.kernels.Result(0, b"", 0, b"", found | {"d0": d0}, 0, 0)
        assert checker.register_complaints(trial, result, block) == complaints


def test_places():
    """Offsets are named by block, field and guard."""
    memory = checker.Memory()
    lines, sides = memory.room("scanline", 3, "lines"), memory.room("sides")
    last = memory.add(b"1234567", name="last")
    assert lines >= checker.GUARD and sides - lines - 36 >= checker.GUARD
    assert len(memory.data) - last - 7 >= checker.GUARD
    names = {lines - 1: "1 byte before lines", lines + 36: "1 byte past the end of lines",
             lines + 12 + 5: "lines[1].last", sides + 22: "sides.area[0]", sides + 25: "sides.area[1]",
             sides - 2: "2 bytes before sides", last + 3: "last + 3",
             last + 9: "3 bytes past the end of last"}
    assert {at: memory.place(at).name for at in names} == names
    assert memory.place(sides + 25) == ("sides.area[1]", sides + 24, 4)
