"""How programs end on the emulated machine: crashes, hangs, and the state afterwards."""

import re
import signal

import pytest

from tests.helpers import endings, guest_program, signalled
from tests.helpers.endings import Ended
from tmap.base.errors import UserError
from tmap.base.paths import GUEST, PROGRAMS, ROOT
from tmap.guest import emulator, kernels
from tmap.guest.kernels import Case

#: The routines of failures.s, by number.
FAILURES = ("illegal_one", "zero_divide", "odd_jump", "privileged", "trap_five", "line_f",
            "jump_away", "quiet_illegal", "quiet_loop", "loud_loop", "reboot")
CRASHES = {
    "illegal_one": r"exception 4 \(illegal instruction\) at PC \$[0-9a-f]+, in illegal_one\+\$c",
    "zero_divide": r"exception 5 \(division by zero\) at PC \$[0-9a-f]+, in zero_divide\+\$[24]",
    # The emulator's 68020 accepts odd PCs; the real one does not.
    "odd_jump": r"exception (3 \(address error\)|4 \(ill.*\)) at PC \$[0-9a-f]+, in odd_(jump|place)",
    "privileged": r"exception 8 \(privilege violation\) at PC \$[0-9a-f]+, in privileged\+\$0",
    "trap_five": r"exception 37 \(unexpected\) at PC \$[0-9a-f]+, in trap_five\+\$2",
    "line_f": r"exception 11 \(line F\) at PC \$[0-9a-f]+, in line_f\+\$0",
    "jump_away": r"exception 10 \(line A\) at PC \$[0-9a-f]+, outside the program's code",
    "quiet_illegal": r"exception 4 \(illegal instruction\) at PC \$[0-9a-f]+, in quiet_illegal\+\$",
    "quiet_loop": r"exception 256 \(no end: stopped by the watchdog\) at PC \$[0-9a-f]+, "
                  r"in quiet_loop\+\$"}


def failing(name: str) -> str:
    return f"failures {FAILURES.index(name)}"


KERNEL = "bench kernels out"
#: quiet_loop twice: each has an open file in the table's first slot. The last is loaded once.
ENDED = [*map(failing, CRASHES), failing("quiet_loop"), KERNEL, "batch failures 90"]


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """A folder with ``failures``."""
    folder = tmp_path_factory.mktemp("programs")
    guest_program.build(folder, GUEST / "failures.s")
    return folder


@pytest.fixture(scope="module")
def ended(programs, tmp_path_factory) -> dict[str, Ended]:
    """Every crash in one boot, by command."""
    by_zero = Case("mul_div", registers={"d0": 1, "d1": 1, "a0": 0})
    files = {"failures": programs / "failures", "bench": PROGRAMS / "bench",
             "kernels": kernels.plan([by_zero]), "90.run": "".join(
                 f"{FAILURES.index(name)}\n" for name in ("quiet_illegal", "quiet_loop")).encode()}
    return dict(zip(ENDED, endings.run([(0, line) for line in ENDED], files, "a1200",
                                       tmp_path_factory.mktemp("run"), "bench", timed=False)))


@pytest.mark.parametrize("name", CRASHES)
def test_crash_is_reported(programs, ended, name):
    found = ended[failing(name)]
    fault = emulator.explain_fault(programs / "failures", found.output)
    assert found.code == 20 and re.match(f"failures crashed: {CRASHES[name]}", fault), fault


def test_registers_are_reported(programs, ended):
    fault = emulator.explain_fault(programs / "failures", ended[failing("illegal_one")].output)
    registers = [line.split()[1:] for line in fault.splitlines()[1:]]
    assert [len(bank) for bank in registers] == [8, 8]
    assert (registers[0][3], registers[1][4]) == ("12345678", "9abcdef0")


def test_crash_of_a_kernel_is_reported(ended):
    found = ended[KERNEL]
    assert found.code == 20 and found.output.startswith("case 0 of 1: mul_div\n")
    assert re.match(r"bench crashed: exception 5 \(division by zero\) at PC \$[0-9a-f]+, in mul_div\+",
                    emulator.explain_fault(PROGRAMS / "bench", found.output))


def test_everything_is_given_back(ended):
    """However a program ended; a file that was open leaves the table's first slot free."""
    for command, found in ended.items():
        assert not found.lost(), (command, found.lost())
    codes = [emulator.read(found.directory / f"{number}.code").strip() for number in (90, 91)]
    assert codes == ["20", "20"]
    for name in ("quiet_illegal", "quiet_loop"):
        assert ended[failing(name)].output.startswith("1\n"), name


def test_program_that_is_loaded_once(programs, tmp_path):
    """Each run finds the program's data as loaded, also after a crash or the watchdog; output and
    codes belong to the right run."""
    names = ["quiet_illegal", "illegal_one", "quiet_loop", "quiet_illegal"]
    results = emulator.run_batch([failing(name) for name in names], {}, "a1200", tmp_path,
                                programs=programs)
    assert (tmp_path / "volume" / "0.run").exists()
    for name, result in zip(names, results):
        fault = emulator.explain_fault(programs / "failures", result.output)
        assert result.code == 20 and re.match(f"failures crashed: {CRASHES[name]}", fault), fault
        if name.startswith("quiet"):  # the first slot of the file table was free
            assert result.output.startswith("1\n"), name


def test_run_raises_what_run_many_returns(programs, tmp_path):
    with pytest.raises(UserError, match=f"^failures crashed: {CRASHES['quiet_loop']}"):
        emulator.run(*failing("quiet_loop").split(), {}, "a1200-fast", tmp_path, programs=programs)


@pytest.mark.parametrize("name", ["loud_loop", "reboot"])
def test_silent_guest_is_stopped(programs, tmp_path, monkeypatch, name):
    monkeypatch.setattr(emulator, "STALL_SECONDS", 4.0)
    seen = []
    with pytest.raises(UserError) as caught:
        emulator.run(*failing(name).split(), {}, "a1200-fast", tmp_path, seen.append, programs)
    assert str(caught.value) == (f"{failing(name)}: it did not end, 4 s of processor time after its "
                                 "last sign of life; its last words: 'this far'")
    assert seen[-1] == "this far\n"


def replaced(folder, monkeypatch, script: str) -> None:
    """Replaces the emulator by a script, which may be silent for 0.2 seconds."""
    fake = folder / "fs-uae"
    fake.write_text(f"#!/bin/sh\n{script}\n")
    fake.chmod(0o755)
    monkeypatch.setenv("PATH", str(folder), prepend=":")
    monkeypatch.setattr(emulator, "STALL_SECONDS", 0.2)


@pytest.mark.parametrize("script, message", [
    ("exit 0", "the emulator ended before it; it wrote nothing"),
    ("echo '  FATAL: no display'; exit 1", "before it; the emulator says: FATAL: no display"),
    ("while :; do :; done", "it did not end, 0.2 s of processor time after its last sign of life; it "
                            "wrote nothing"),
    ("exec sleep 60", "it did not end, 3 s after its last sign of life, stopped or blocked most of "
                      "the time; it wrote nothing"),
])
def test_emulator_in_trouble(tmp_path, monkeypatch, script, message):
    replaced(tmp_path, monkeypatch, script)
    with pytest.raises(UserError, match=message):
        emulator.run("render", "x", {}, "a1200", tmp_path)


def test_emulator_without_a_processor_is_waited_for(tmp_path, monkeypatch):
    """The emulator is stopped for five times the patience, and then continues."""
    replaced(tmp_path, monkeypatch, "(sleep 1; kill -CONT $$) & kill -STOP $$; cd ${1%/*}/volume; "
                                    "echo done >0.log; echo 0 >0.code; echo >end")
    assert emulator.run("render", "x", {}, "a1200", tmp_path).output == "done\n"


def test_no_emulator(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    for call in (emulator.emulator_version,
                 lambda: emulator.run("render", "x", {}, "a1200", tmp_path)):
        with pytest.raises(UserError, match="fs-uae is not installed: run scripts/setup"):
            call()


def test_version_is_the_pinned_one():
    assert emulator.emulator_version() == emulator.VERSION


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT])
def test_a_signal_leaves_nothing_behind(tmp_path, number):
    """The emulator ends, and the run's folder is deleted."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    code, said = signalled.end(["run", str(ROOT / "tests/scenes/default.toml"), "-o", str(tmp_path / "out")],
                               number, False, folder)
    assert (code, said) == (128 + number, "tmap: interrupted\n" if number == signal.SIGINT else "")
    assert not list(folder.iterdir()) and not list((tmp_path / "out").glob("*"))


def test_a_folder_with_a_line_break(tmp_path, monkeypatch):
    """The emulator's configuration has a line for each path."""
    folder = tmp_path / "two\nlines"
    folder.mkdir()
    with pytest.raises(UserError) as caught:
        emulator.run("render", "x", {}, "a1200", folder)
    assert str(caught.value) == f"{str(folder)!r}: a path with a line break, which the emulator cannot take"
