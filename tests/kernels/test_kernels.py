"""Every routine of the rooms of src68k that are kernels (contracts.KERNELS),
called on the emulated A1200, and by another emulator's processor, and held to its contract block and to a reference
in Python."""

import importlib
import pkgutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import pytest

from tests.helpers import kernel_checker as checker
from tests.kernels import trials
from tests.kernels.trials import glide, n64, screen
from tmap.base import paths
from tmap.build import contracts
from tmap.guest.emulator import SECOND

#: Written in C and without a block: the compilers' rules are its contract.
IN_C = contracts.Contract(
    "span_affine_c", "c/span/affine.c", 1, "span_affine_swap in C", (), (),
    contracts.expand("d0-d1/a0-a1"), *[""] * 5)
ALL_IN_C = [IN_C,
            replace(IN_C, name="column_layout_make", file="c/texture/columns.c",
                    summary="where a column map has its texels"),
            *(replace(IN_C, name=name, file=file, summary=summary) for file, summary, names in (
                ("c/plain", "a pass in C", n64.IN_C),
                ("c/plain", "a pass in C", glide.IN_C),
                ("c/screen", "in C", screen.IN_C)) for name in names)]
CONTRACTS = {c.name: c for c in [*contracts.kernels(paths.ROOT / "src68k"), *ALL_IN_C]
             if c.name not in checker.UNCALLED}
ROOMS = [importlib.import_module(f"{trials.__name__}.{room.name}")
         for room in pkgutil.iter_modules(trials.__path__)]
PROCESSORS = (checker.MACHINE, SECOND)
TOGETHER = 4  # rooms: a boot's plan is seldom full with the trials of one
BOOTS = 2  # emulators that run side by side, while the next trials are made


@pytest.fixture(scope="module")
def called(request):
    """Trials with their results on each processor, by kernel, of the kernels that this run asks for; rooms share
    boots."""
    wanted = {item.callspec.params["kernel"] for item in request.session.items
              if item.path == request.path and hasattr(item, "callspec")}
    with ThreadPoolExecutor(BOOTS) as boots:
        begun = []
        for first in range(0, len(ROOMS), TOGETHER):
            trials = [trial for room in ROOMS[first:first + TOGETHER] for trial in room.trials()
                      if trial.case.kernel in wanted]
            begun.append((trials, [boots.submit(checker.run, trials, machine) for machine in PROCESSORS]))
        done = {kernel: [] for kernel in wanted}
        for trials, parts in begun:
            for trial, *results in zip(trials, *(part.result() for part in parts)):
                done[trial.case.kernel].append((trial, *results))
    return done


@pytest.mark.parametrize("kernel", CONTRACTS)
def test_contract(called, kernel):
    trials, *parts = zip(*called[kernel]) if called[kernel] else ((), *[()] * len(PROCESSORS))
    for machine, results in zip(PROCESSORS, parts):
        wrong = checker.report(CONTRACTS[kernel], trials, results)
        if wrong:
            pytest.fail(f"{machine}: {wrong}", pytrace=False)
