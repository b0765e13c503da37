"""How long a process may be silent: counted in processor time that it used, so that a busy host, which
gives it little, does not make it look hung.

A guest that hangs keeps its emulator busy: on an idle host it is found after as many seconds. A
process that is stopped or blocked uses no processor time. It is given up after SHARE times as many
seconds by the clock, which is far more than one needs that waits for a processor among others.
"""

import os
import time
from glob import glob
from pathlib import Path

SHARE = 15  # a process that gets less than this part of a processor, 1/SHARE, does not run at all
TICKS = os.sysconf("SC_CLK_TCK")  # a second of processor time in /proc
LONGEST = 1.0  # seconds that count between two looks: whoever looks may have been stopped as well


def children(pid: int) -> list[int]:
    """The processes that a process, by any of its threads, has started and not yet waited for."""
    found = []
    for path in glob(f"/proc/{pid}/task/*/children"):
        try:
            found += map(int, Path(path).read_text().split())
        except OSError:  # the thread has ended
            pass
    return found


def processor_seconds(pid: int) -> float:
    """Processor time of a process, those that it waited for and those that it has; 0 if it is gone."""
    try:
        stat = Path(f"/proc/{pid}/stat").read_text()
    except OSError:
        return 0.0
    fields = stat.rpartition(")")[2].split()  # a name in parentheses may have blanks
    # Children last: one that ends meanwhile is left out this time, and never counted twice.
    return sum(map(int, fields[11:15])) / TICKS + sum(map(processor_seconds, children(pid)))


class Silence:
    """The time since a process was heard. ``patience``: seconds of processor time that are too
    many."""

    def __init__(self, pid: int, patience: float) -> None:
        self.pid, self.patience = pid, patience
        self.heard()

    def heard(self) -> None:
        """It gave a sign of life: counts from here."""
        self.from_, self.last, self.clock = processor_seconds(self.pid), time.monotonic(), 0.0

    def end(self) -> str:
        """Why it lasts too long, or nothing. To be asked again and again."""
        now = time.monotonic()
        self.clock += min(now - self.last, LONGEST)
        self.last = now
        if processor_seconds(self.pid) - self.from_ >= self.patience:
            return f"{self.patience:g} s of processor time after its last sign of life"
        if self.clock >= SHARE * self.patience:
            return (f"{SHARE * self.patience:g} s after its last sign of life, stopped or blocked "
                    "most of the time")
        return ""
