"""Whether a mutant is noticed: by the trials of the kernels that it is in, or by frames."""

import importlib
import pkgutil
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from tests.helpers import kernel_checker as checker
from tests.kernels import test_tables, trials as trials_of_rooms
from tests.mutants import corpora, python_source, workshop
from tests.mutants.changes import Mutant
from tmap.base.errors import UserError
from tmap.base.paths import ROOT
from tmap.bench.trial import Trial
from tmap.build import contracts
from tmap.guest import emulator, guest_frames, kernels
from tmap.guest.emulator import SECOND

TOGETHER = 6  # sources with an included line that are built at a time
MOST = 12  # kernels that are tried beside those of the changed sources
PATIENCE = 4.0  # seconds of processor time: trials take a tenth of a second


@dataclass(frozen=True)
class Verdict:
    """``how`` a mutant ended: of ENDS; ``by``: the kernel or the drawing that noticed, or what the tool said."""

    how: str
    by: str = ""


#: Noticed by a kernel's trials, by frames, as a crash, as no end, or by the counts of spans and rules (the same pictures
#: in another way); not noticed; and what does not count.
KILLED = ("trials", "frames", "crash", "no end", "counts")
SURVIVES, SAME, UNBUILT = "survives", "same code", "not built"
ENDS = (*KILLED, SURVIVES, SAME, UNBUILT)


class Trials:
    """The trials of kernels, made once. ``rooms``: files of tests/kernels/trials, all if there are none."""

    def __init__(self, rooms: Iterable[str] = ()) -> None:
        names = [room.name for room in pkgutil.iter_modules(trials_of_rooms.__path__)]
        self.trials: dict[str, list[Trial]] = {}
        for name in list(rooms) or names:
            for trial in importlib.import_module(f"{trials_of_rooms.__name__}.{name}").trials():
                self.trials.setdefault(trial.case.kernel, []).append(trial)
        self.contracts = {each.name: each for each in contracts.kernels(ROOT / "src68k")}

    def kernels(self, sources: list[str]) -> list[str]:
        """Returns the kernels to try if the objects of ``sources`` change: theirs, then those that call them."""
        by_file: dict[str, list[str]] = {}
        for name, each in self.contracts.items():
            if name in self.trials:
                file = Path(each.file)
                by_file.setdefault(str(file.relative_to(ROOT) if file.is_absolute() else file), []).append(name)
        own = [name for source in sources for name in by_file.get(source, ())]
        needed = dict.fromkeys(each for source in sources for each in workshop.needed_by(source))
        others = [name for source in needed for name in by_file.get(source, ()) if name not in own]
        return own + others[:MOST]

    def complaint(self, some: list[str], programs: Path) -> str:
        """Returns what is first wrong with kernels as a program ``bench`` has them, or "". Raises UserError if it does
        not end well."""
        called = [trial for name in some for trial in self.trials[name]]
        done = 0
        for batch in kernels.batches([checker.with_writes(trial) for trial in called], SECOND):
            part, done = called[done:done + len(batch)], done + len(batch)
            for trial, result in zip(part, kernels.call_batch(batch, SECOND, None, False, programs, PATIENCE)):
                if wrong := checker.complaints(trial, result, self.contracts[trial.case.kernel]):
                    return f"{trial.case.kernel}: {wrong[0]}"
        return ""


def ended(error: UserError) -> Verdict:
    """Returns the verdict on a program that did not end well."""
    text = str(error).splitlines()[0]
    if isinstance(error, kernels.Changed):
        return Verdict("trials", text)
    return Verdict("no end" if "did not end" in text else "crash", text)


def by_trials(trials: Trials, changed: dict[str, Path], folder: Path) -> Verdict | None:
    """Returns the verdict of the kernels' trials, None if they notice nothing."""
    compiler = workshop.objects()[0]
    some = trials.kernels([workshop.source_of(each, compiler) for each in changed])
    if not some:
        return None
    try:
        wrong = trials.complaint(some, workshop.link("bench", changed, folder))
    except workshop.Unbuilt:
        raise
    except UserError as error:
        return ended(error)
    return Verdict("trials", wrong) if wrong else None


def by_frames(subjects: Iterable[str], changed: dict[str, Path], folder: Path) -> Verdict | None:
    """Returns the verdict of drawings, None if all are as they should be."""
    workshop.link("render", changed, folder)
    way = None
    for subject in subjects:
        for number in range(len(corpora.PARTS[subject])):
            drawings, right = corpora.part(subject, number)
            try:
                found = corpora.draw(drawings, folder)
            except UserError as error:
                return ended(error)
            for (expected, counts), (digests, counted) in zip(right, found, strict=True):
                if any((expected[field] != digests[field]).any() for field in ("sum", "hash", "result")):
                    return Verdict("frames", f"{subject} {number}")
                if counts != counted:
                    way = way or Verdict("counts", f"{subject} {number}")
    return way


def judge(mutant: Mutant, trials: Trials, subjects: Iterable[str]) -> Verdict:
    """Builds a mutant and tries it."""
    sources, all_changed = workshop.concerned(mutant), {}
    if mutant.file == test_tables.FILE and " dc." in mutant.text and test_tables.wrong(workshop.changed_text(mutant)):
        return Verdict("trials", "tests/kernels/test_tables.py")
    with emulator.workspace() as folder:
        for first in range(0, len(sources), TOGETHER):
            here = folder / str(first)
            here.mkdir()
            try:
                changed = workshop.make_objects(mutant, sources[first:first + TOGETHER], here)
                all_changed |= changed
                if mutant.file.startswith("src68k/") and (verdict := by_trials(trials, changed, here)):
                    return verdict
            except workshop.SameCode:
                continue
            except workshop.Unbuilt as error:
                return Verdict(UNBUILT, str(error).splitlines()[0][:100])
        if not all_changed:
            return Verdict(SAME)
        try:
            return by_frames(subjects, all_changed, folder) or Verdict(SURVIVES)
        except workshop.Unbuilt as error:
            return Verdict(UNBUILT, str(error).splitlines()[0][:100])


def judge_python(mutant: Mutant, subjects: Iterable[str]) -> Verdict:
    """Tries a mutant of the model in a copy of the tools; the processor's programs are the tree's."""
    try:
        done = python_source.check(mutant, ["-m", "tests.mutants.model_check", *subjects])
    except subprocess.TimeoutExpired:
        return Verdict("no end")
    if not done.returncode:
        return Verdict(SURVIVES)
    said = (done.stderr.strip().splitlines() or ["nothing"])[-1]
    kind = said.partition(":")[0]
    return Verdict("crash" if "Error" in kind else "frames" if "frame" in said or "polygon " in said else "trials", said)
