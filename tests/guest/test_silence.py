"""Silence is measured in the processor time that a process used, not by the host's clock."""

import contextlib
import os
import signal
import subprocess
import time

import pytest

from tmap.base import silence
from tmap.base.silence import SHARE, Silence

BUSY = "while :; do :; done"


@contextlib.contextmanager
def shell(script: str):
    """A shell that runs a script; it and all processes it started are ended afterwards."""
    process = subprocess.Popen(["sh", "-c", script], start_new_session=True)
    try:
        yield process
    finally:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def until_end(counted: Silence) -> tuple[str, float]:
    """Waits for the end; returns its message and the seconds passed by the clock."""
    since = time.monotonic()
    while not (said := counted.end()):
        time.sleep(0.02)
    return said, time.monotonic() - since


@pytest.mark.parametrize("script", [
    BUSY, f"({BUSY}) & wait", f"(({BUSY}) & wait) & wait",
    "while :; do sh -c 'i=0; while [ $i -lt 2000 ]; do i=$((i+1)); done'; done"])
def test_busy_silence_ends(script: str) -> None:
    """A busy process, its child or grandchild ends the silence, long before the clock's limit; so
    do short-lived children, one after the other, which may never be observed."""
    with shell(script) as process:
        said, _ = until_end(Silence(process.pid, 0.5))
    assert said == "0.5 s of processor time after its last sign of life"


def test_a_stopped_process_is_waited_for() -> None:
    """A stopped process may be silent for many times its patience; when it is busy again, the
    silence ends."""
    with shell(BUSY) as process:
        os.kill(process.pid, signal.SIGSTOP)
        counted = Silence(process.pid, 0.3)
        for _ in range(20):
            time.sleep(0.1)
            assert not counted.end()
        os.kill(process.pid, signal.SIGCONT)
        assert "processor time" in until_end(counted)[0]


@pytest.mark.parametrize("script", ["exec sleep 60", "kill -STOP $$"])
def test_a_stuck_process_ends_by_the_clock(script: str) -> None:
    """After SHARE times its patience, and not before."""
    with shell(script) as process:
        said, passed = until_end(Silence(process.pid, 0.1))
    assert said.startswith(f"{SHARE * 0.1:g} s after its last sign of life, stopped or blocked")
    assert passed >= SHARE * 0.1


def test_a_sign_of_life_begins_anew() -> None:
    with shell(BUSY) as process:
        counted = Silence(process.pid, 0.3)
        for _ in range(5):
            start = silence.processor_seconds(process.pid)
            while silence.processor_seconds(process.pid) - start < 0.2:
                time.sleep(0.01)
            counted.heard()
            assert not counted.end()


def test_a_pause_of_the_observer_is_no_silence(monkeypatch) -> None:
    """Ctrl-Z stops observer and process: an hour between two looks counts as a second."""
    now = [0.0]
    monkeypatch.setattr(silence.time, "monotonic", lambda: now[0])
    monkeypatch.setattr(silence, "processor_seconds", lambda pid: 0.0)
    counted = Silence(1, 20.0)
    for _ in range(int(SHARE * 20.0) - 1):
        now[0] += 3600
        assert not counted.end()
    now[0] += 3600
    assert counted.end()
