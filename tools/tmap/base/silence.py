"""Limits how long a process may be silent. The limit is in processor time, so that a process on a
busy host, which gets little of it, does not look hung.

A guest that hangs keeps its emulator busy: on an idle host it is found after as many seconds as the
limit. A process that is stopped or blocked uses no processor time. It is given up after SHARE times
as many seconds of real time, far more than a process needs that competes for a processor.
"""

import os
import time
from glob import glob
from pathlib import Path

SHARE = 15  # a process that gets less than 1/SHARE of a processor counts as not running
TICKS = os.sysconf("SC_CLK_TCK")  # in /proc, per second of processor time
LONGEST = 1.0  # most seconds counted between two checks: the checking process may be stopped too


def children(pid: int) -> list[int]:
    """Returns the processes that any thread of a process has started and not yet waited for."""
    found = []
    for path in glob(f"/proc/{pid}/task/*/children"):
        try:
            found += map(int, Path(path).read_text().split())
        except OSError:  # the thread has ended
            pass
    return found


def processor_seconds(pid: int) -> float:
    """Returns the processor time of a process and of its children, those it has waited for and
    those still there; 0 if it is gone."""
    try:
        stat = Path(f"/proc/{pid}/stat").read_text()
    except OSError:
        return 0.0
    fields = stat.rpartition(")")[2].split()  # the name in parentheses may have blanks
    # Children last: one that ends meanwhile is left out this time, but never counted twice.
    return sum(map(int, fields[11:15])) / TICKS + sum(map(processor_seconds, children(pid)))


class Silence:
    """The time since a process's last sign of life. ``patience``: the limit in seconds of processor
    time."""

    def __init__(self, pid: int, patience: float) -> None:
        self.pid, self.patience = pid, patience
        self.heard()

    def heard(self) -> None:
        """Records a sign of life: restarts the count."""
        self.from_, self.last, self.clock = processor_seconds(self.pid), time.monotonic(), 0.0
        self.soonest = self.last + self.patience / os.cpu_count()  # with all processors

    def end(self) -> str:
        """Returns why the process is silent for too long, or "". Must be called repeatedly."""
        now = time.monotonic()
        self.clock += min(now - self.last, LONGEST)
        self.last = now
        if now >= self.soonest and processor_seconds(self.pid) - self.from_ >= self.patience:
            return f"{self.patience:g} s of processor time after its last sign of life"
        if self.clock >= SHARE * self.patience:
            return (f"{SHARE * self.patience:g} s after its last sign of life, stopped or blocked "
                    "most of the time")
        return ""
