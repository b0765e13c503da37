"""The Makefile: one build at a time, and names of files as they are given."""

import fcntl
import subprocess

import pytest

from tmap.base.paths import ROOT


def make(*arguments: str) -> subprocess.Popen:
    """Starts ``make``; its output is text in one pipe."""
    return subprocess.Popen(["make", "-s", "-C", str(ROOT), *arguments], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True)


def test_a_build_waits_for_another() -> None:
    """Two builds side by side would write the same files."""
    with (ROOT / "Makefile").open() as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        waiting = make("programs")
        with pytest.raises(subprocess.TimeoutExpired):
            waiting.wait(1.5)
    assert waiting.communicate(timeout=60) == ("", None) and waiting.returncode == 0


@pytest.mark.parametrize(("arguments", "said"), [
    (["run", "SCENE=none/a$HOME b$(x).toml"], "none/a$HOME b$(x).toml"),
    (["diff", "A=none/$HOME", "B=none/$$"], "none/$HOME")])
def test_names_are_not_expanded(arguments: list[str], said: str) -> None:
    """A name with a dollar or a blank reaches the command as it is."""
    done = make(*arguments)
    output = done.communicate(timeout=60)[0]
    assert done.returncode == 2 and output.startswith(f"tmap: {said}: "), output
