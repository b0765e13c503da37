"""Runs programs by tests/guest/endings.s, which prints the machine's state before and after."""

from dataclasses import dataclass
from pathlib import Path

from tests.helpers import guest_program
from tmap.base.paths import GUEST
from tmap.guest import emulator

#: The numbers in a line of tests/guest/state.s.
STATE = ("chip RAM", "fast RAM", "INTENA", "DMACON", "level 6 vector", "trap code",
         "Disable and Forbid", "signals allocated", "Ctrl-C pending", "timer A", "timer B", "CACR",
         "view", "level 3 vector", "the beam's last line")
#: How a program is run; 0: to its end; more: until Ctrl-C after so many fields.
AT_ONCE, DOUBLE_CLICK, IN_RAM, OLD_KICKSTART, KEYS = range(-1, -6, -1)
#: Sources of tests/guest/display.c's program.
DISPLAY = GUEST / "display.c", GUEST / "events.s", GUEST / "state.s"


@dataclass
class Ended:
    """The result of a program: its return code, its output, the machine's state before and after,
    and the volume's folder."""

    code: int
    output: str
    before: list[int]
    after: list[int]
    directory: Path

    @property
    def said(self) -> list[str]:
        return self.output.splitlines()

    def lost(self, but: tuple[str, ...] = ()) -> list[str]:
        """The parts of the state that have changed."""
        assert len(self.before) == len(self.after) == len(STATE)
        return [f"{name} {a} -> {b}" for name, a, b in zip(STATE, self.before, self.after)
                if a != b and name not in but]


def run(commands: list[tuple], files: dict[str, bytes | Path], machine: str, folder: Path,
        first: str = "render none", timed: bool = True) -> list[Ended]:
    """Runs (how, command line, ...) in one boot; ``files``: programs and their input. ``first`` is
    run before them, as the first program opens what stays open; ``timed``: as in emulator.run_batch."""
    (folder / "programs").mkdir()
    guest_program.build(folder / "programs", GUEST / "endings.s", GUEST / "state.s")
    lines = []
    for number, (how, line, *_) in enumerate([(0, first), *commands]):
        drawer, home = ("RAM:", "SYS:") if how == IN_RAM else ("SYS:", "")
        lines.append(f"endings {home}its.{number} {how} {drawer} {home}{line}")
    results = emulator.run_batch(lines, files, machine, folder / "run",
                                 programs=folder / "programs",
                                apart=True, patience=60, timed=timed)
    found = []
    for number, result in enumerate(results):
        *states, code = result.output.splitlines()
        before, after = ([int(value) for value in line.split()] for line in states)
        said = emulator.read(result.directory / f"its.{number}")
        found.append(Ended(int(code), said, before, after, result.directory))
    return found[1:]
