"""Ends a command by a signal while its emulator runs."""

import os
import signal
import subprocess
import time
from pathlib import Path

from tmap.base import paths
from tmap.base.signals import ENDING
from tmap.base.silence import Silence, children

SECONDS = 2  # a process is gone a moment after its files are closed; an emulator that had the signal ends by itself


def is_running(pid: int) -> bool:
    """Whether a process has not ended; one that nobody waited for has."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


def end(arguments: list[str], number: signal.Signals, to_all: bool, folder: Path) -> tuple[int, str]:
    """Runs ``scripts/tmap`` with ``folder`` as TMPDIR until an emulator runs there, then sends the
    signal: ``to_all``: as a terminal does, which reaches its children and emulators too; else to the
    first process alone. Returns its status and output; nothing may be left running."""
    def as_in_a_terminal() -> None:  # what a shell runs in the background ignores some, and nohup another
        for each in ENDING:
            signal.signal(each, signal.SIG_DFL)

    with subprocess.Popen([paths.ROOT / "scripts/tmap", *arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, preexec_fn=as_in_a_terminal,
                          start_new_session=True, env=os.environ | {"TMPDIR": str(folder)}) as process:
        silence = Silence(process.pid, 120)
        while not (list(folder.glob("tmap-*/emulator.log")) and children(process.pid)):
            assert process.poll() is None and not silence.end()
            time.sleep(0.1)
        started = children(process.pid)
        (os.killpg if to_all else os.kill)(process.pid, number)
        silence = Silence(process.pid, 20)
        while process.poll() is None:
            assert not silence.end()
            time.sleep(0.1)
        said = process.communicate(timeout=20)[0]  # an end of file only when its processes have ended
    ended = time.monotonic() + SECONDS
    while any(map(is_running, started)):
        assert time.monotonic() < ended, "something is still running"
        time.sleep(0.05)
    return process.returncode, said
