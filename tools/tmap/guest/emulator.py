"""Runs programs on the emulated A1200 and judges how they ended.

A run has one private directory: it is the boot volume, and holds the programs, their input and all
that they write. The guest's start-up script runs each command with its output in ``N.log``, writes
its return code to ``N.code``, and at last writes ``end`` (the sentinel) and leaves the emulator by
``uae``. If consecutive commands run the same program, ``batch`` loads it once and does the same
for each.

SECOND is a machine too: another processor's core, for results only (tmap.guest.second_system).
"""

import contextlib
import importlib.util
import itertools
import os
import re
import select
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from tmap.base.errors import UserError
from tmap.base.paths import PROGRAMS, ROOT
from tmap.base.signals import held
from tmap.base.silence import Silence

#: FS-UAE options of each machine; all are A1200s with AGA, cycle-exact.
MACHINES = {
    "a1200": {},
    "a1200-fast": {"fast_memory": "8192"},
    # A 68EC030 at the same clock, for its data cache.
    "a1200-030": {"fast_memory": "8192", "cpu": "68EC030", "uae_cpu_model": "68030",
                  "uae_mmu_model": "0", "uae_cpu_24bit_addressing": "true",
                  "uae_cpu_compatible": "true", "uae_cpu_cycle_exact": "true",
                  "uae_cycle_exact": "true", "uae_blitter_cycle_exact": "true",
                  "uae_cpu_speed": "real"},
}
#: Machines of all measurements.
MEASURED = ("a1200", "a1200-fast")
#: Musashi's 68020 without an Amiga around it. It counts no cycles.
SECOND = "musashi"
#: Options of every run.
OPTIONS = {
    "amiga_model": "A1200",
    "floppy_drive_count": "0",
    "deterministic": "1",  # serves files synchronously: separate threads deadlock now and then
    "audio_driver": "null",
    "fullscreen": "0",
    "uae_sound_output": "none",
    "joystick_port_0": "none",
    "joystick_port_1": "none",
}


@dataclass(frozen=True)
class Display:
    """Where the emulator's picture goes: its options and additional environment variables."""

    options: dict[str, str]
    environment: dict[str, str] = field(default_factory=dict)


#: Of runs whose cycles are not asked for: the same A1200, its processor and chips not cycle by cycle, which takes
#: between a third and a fifth of the host's time, and the processor six times as fast beside the chips, which saves a
#: quarter of that.
UNTIMED = {"accuracy": "-1", "uae_cpu_throttle": "5000"}
#: A program that makes the machine cycle by cycle itself while it times a frame, and not else, if this is added to its
#: arguments (src68k/amiga/exact.s).
EXACT_PROGRAM, EXACT = "render", " EXACT"
#: A program that is emulated cycle by cycle from the boot on. For others a command makes the machine so, and AmigaDOS
#: loads what follows elsewhere: kernels that write their code share other lines of the cache then.
EXACT_BOOT = "bench"
#: The screen is not shown: showing each of its frames would be much of the host's work.
HIDDEN = Display({"warp_mode": "1", "window_width": "64", "window_height": "64",
                  "low_resolution": "1", "line_doubling": "0", "video_sync": "1",
                  "assume_refresh_rate": "10"}, {"SDL_VIDEODRIVER": "offscreen"})
#: Seconds of the host's processor time without a byte of output after which a run counts as hung
#: (tmap.base.silence). A boot takes about 1 s; the guest's own watchdog ends a program after 3 s at
#: most.
STALL_SECONDS = 20.0
#: The same for texture engines: a single frame may take that long.
PATIENT_SECONDS = 10 * STALL_SECONDS
LOOK_SECONDS = 0.1  # between two looks at what a guest has written; its end is seen at once
CYCLES_PER_TICK = 4  # CPU cycles in a colour clock, the unit of guests' measurements
CLOCK_HZ = 14_187_580  # of a PAL A1200's 68EC020
VERSION = "3.1.66"  # the cycle figures in this tree were measured with this version

EXCEPTIONS = {
    2: "bus error", 3: "address error", 4: "illegal instruction", 5: "division by zero",
    6: "CHK", 7: "TRAPV", 8: "privilege violation", 9: "trace", 10: "line A", 11: "line F",
    0x100: "no end: stopped by the watchdog",
}


@dataclass
class Result:
    """The volume after a command, its output and its return code."""

    directory: Path
    output: str
    code: int


class Closed(UserError):
    """The emulator ended without an error but before the guest: its window was closed."""


def has_fast_memory(machine: str) -> bool:
    """Returns true if a machine has more than chip RAM."""
    return machine == SECOND or "fast_memory" in MACHINES[machine]


def emulator_version() -> str:
    """Returns the version of the FS-UAE on PATH."""
    try:
        return subprocess.run(["fs-uae", "--version"], capture_output=True, text=True).stdout.strip()
    except OSError:
        raise UserError("fs-uae is not installed: run scripts/setup") from None


def routine_at(program: Path, offset: int) -> str:
    """Returns the place of an offset in a program's code: the routine, and the distance from its
    start."""
    header = program.read_bytes()[:24]  # of the hunk file; the code's hunk comes first
    if not offset < 4 * int.from_bytes(header[20:], "big"):
        return "outside the program's code"
    best = "?"
    for line in program.with_name(program.name + ".map").read_text().splitlines():
        value, name = line.split()
        if int(value, 16) > offset:
            break
        best = f"in {name.lstrip('_')}+${offset - int(value, 16):x}"
    return best


def explain_fault(program: Path, output: str) -> str | None:
    """Returns the crash report in ``output`` as one line and the registers, or None if there is
    none."""
    match = re.search(r"fault: exception ([0-9a-f]{8}) pc ([0-9a-f]{8})\n(.*)\n(.*)", output)
    if not match:
        return None
    number, pc = int(match[1], 16), int(match[2], 16)
    kind = EXCEPTIONS.get(number, "unexpected")
    return (f"{program.name} crashed: exception {number} ({kind}) at PC ${pc:x}, "
            f"{routine_at(program, pc)}\n"
            f"  d0-d7 {match[3].strip()}\n  a0-a7 {match[4].strip()}")


def explain_second_fault(program: Path, log: str) -> str | None:
    """The same from the log of the second processor's system."""
    match = re.search(r"Initial PC=([0-9a-f]+).* PC=([0-9a-f]+)(.*)Error: (.*?)\n", log, re.DOTALL)
    if not match:
        return None
    pc, why = match[2], match[4]
    registers = "\n".join("  " + line.split(":  ")[-1] for line in match[3].splitlines()[1:3])
    if exception := re.match(r"Invalid CPU State: pc=([0-9a-f]+): m68k Exception", why):  # its frame is on the stack
        number = (int(re.search(r"SP\+04=([0-9a-f]+)", match[3])[1], 16) & 0xFFF) // 4
        pc, why = exception[1], f"exception {number} ({EXCEPTIONS.get(number, 'unexpected')})"
    offset = int(pc, 16) - int(match[1], 16)
    return f"{program.name} crashed: {why} at PC ${offset:x}, {routine_at(program, offset)}\n{registers}"


def last_words(output: str) -> str:
    """Returns the last line a guest wrote, for messages."""
    lines = [line for line in output.splitlines() if line.strip()]
    return f"its last words: {lines[-1]!r}" if lines else "it wrote nothing"


@contextlib.contextmanager
def workspace() -> Iterator[Path]:
    """Yields a private directory for one run, removed afterwards."""
    with held():
        folder = tempfile.TemporaryDirectory(prefix="tmap-")
    with folder as name:
        yield Path(name)


def read(path: Path) -> str:
    """Returns a guest's text file; empty if it does not exist."""
    return path.read_text("latin-1") if path.exists() else ""


def floppies(*images: Path) -> dict[str, str]:
    """Returns options for images in DF0:, DF1: and so on, read and written without delay. The guest
    writes into the files themselves."""
    return {f"floppy_drive_{n}": str(path) for n, path in enumerate(images)} | {
        "floppy_drive_count": str(len(images)), "floppy_drive_speed": "0",
        "writable_floppy_images": "1"}


def write_config(directory: Path, machine: str, display: Display, more: dict[str, str]) -> Path:
    """Writes the emulator's configuration file into a run's directory; ``more``: further options."""
    if "\n" in str(directory):
        raise UserError(f"{str(directory)!r}: a path with a line break, which the emulator cannot take")
    options = OPTIONS | display.options | MACHINES[machine] | {
        "base_dir": str(directory / "base")} | more
    config = directory / "a1200.fs-uae"
    config.write_text("[fs-uae]\n" + "".join(f"{k} = {v}\n" for k, v in options.items()))
    return config


def second_command(commands: list[str], folders: bool) -> list[str]:
    """Returns the host's command that runs the guest's on the second processor."""
    if not importlib.util.find_spec("machine68k"):
        raise UserError(f"{SECOND} is not installed: run scripts/setup second")
    return [sys.executable, "-P", "-m", "tmap.guest.second_system", *["--folders"] * folders, *commands]


@contextlib.contextmanager
def started(command: list[str], volume: Path, environment: dict[str, str], log: Path) -> Iterator[subprocess.Popen]:
    """Runs an emulator in its ``volume`` with its own messages in ``log``; kills it afterwards."""
    process = None
    try:
        with log.open("wb") as stream, held():
            process = subprocess.Popen(
                command, cwd=volume, stdin=subprocess.DEVNULL, stdout=stream, stderr=subprocess.STDOUT,
                env=os.environ | {"PYTHONPATH": str(ROOT / "tools")} | environment)
        yield process
    except FileNotFoundError:
        if process:
            raise
        raise UserError("fs-uae is not installed: run scripts/setup") from None
    finally:
        if process:
            process.kill()
            process.wait()


def prepare(directory: Path, commands: list[str], files: dict[str, bytes | Path], programs: Path,
            apart: bool, folders: bool, exact: bool) -> None:
    """Writes a run's volume; parameters as in run_batch. ``exact``: the machine is made cycle by cycle before them."""
    volume = directory / "volume"
    (volume / "S").mkdir(parents=True)
    for name, content in files.items():
        if isinstance(content, bytes):
            (volume / name).write_bytes(content)
        else:
            shutil.copyfile(content, volume / name)
    for name in {command.split()[0] for command in commands}:
        shutil.copyfile(programs / name, volume / name)
    for name in ("uae", "batch"):
        shutil.copyfile(PROGRAMS / name, volume / name)
    script = ["failat 100"] + ["uae exact"] * exact  # no return code ends the script
    for program, numbered in itertools.groupby(enumerate(commands), lambda c: c[1].split()[0]):
        numbers, some = zip(*numbered)
        arguments = [command.partition(" ")[2] for command in some]
        if folders:
            for number, line in zip(numbers, arguments):
                (volume / str(number)).mkdir()
                script += [f"cd :{number}", f":{program} >:{number}.log {line}",
                           f"echo >:{number}.code $RC", "cd :"]
        elif len(some) > 1 and not apart:
            run = "".join(f"{line}\n" for line in arguments)
            (volume / f"{numbers[0]}.run").write_text(run)
            script += [f"batch {program} {numbers[0]}"]
        else:
            for number, line in zip(numbers, arguments):
                script += [f"{program} >{number}.log {line}", f"echo >{number}.code $RC"]
    script += ["echo >end", "uae"]
    (volume / "S" / "Startup-Sequence").write_text("\n".join(script) + "\n")


def wait(process: subprocess.Popen, volume: Path, on_output, patience: float) -> tuple[str, dict[str, str]]:
    """Waits until the emulator ends, or until the guest was silent for ``patience`` seconds.
    Returns a text about the silence, or an empty one; and what each log had at the last sign of life, as a guest that
    reboots writes them anew.

    Only more files and output than ever before count as a sign of life, so that a guest that
    reboots again and again counts as silent too.
    """
    most, silence, heard = -1, Silence(process.pid, patience), {}
    with os.fdopen(os.pidfd_open(process.pid), "rb", 0) as ended:
        while process.poll() is None:
            with os.scandir(volume) as entries:
                names = [entry.name for entry in entries]
            logs = [volume / name for name in names if name.endswith(".log")]
            size = len(names) + sum(path.stat().st_size for path in logs)
            if size > most:
                most = size
                silence.heard()
                heard = {path.name: read(path) for path in logs}
                if on_output:
                    on_output("".join(heard.values()))
            elif said := silence.end():
                return said, heard
            select.select([ended], [], [], LOOK_SECONDS)
    return "", heard


def explain_end(program: Path, arguments: str, output: str, silence: str, log: str) -> str:
    """Returns why there is no sentinel, and how far the guest came; ``silence``: from ``wait``."""
    how = f"it did not end, {silence}" if silence else "the emulator ended before it"
    fatal = [line.strip() for line in log.splitlines() if re.search("FATAL|ERROR", line)]
    said = f"the emulator says: {fatal[0]}" if fatal else last_words(output)
    fault = explain_fault(program, output) or explain_second_fault(program, log)
    return f"{program.name} {arguments}: {how}; {fault or said}"


def run_batch(commands: list[str], files: dict[str, bytes | Path], machine: str, directory: Path,
             on_output=None, programs: Path = PROGRAMS,
             patience: float | None = None, apart: bool = False, folders: bool = False,
             display: Display = HIDDEN, drives: dict[str, str] | None = None, timed: bool = True) -> list[Result]:
    """Boots ``machine``, runs the commands one after the other and waits for the end.

    ``files`` are put into the run's ``directory`` first (a name to bytes, or to a file that is
    copied); a command's first word is one of ``programs``. ``on_output`` is called with the output
    so far when there is more of it; ``patience``: seconds of silence, in processor time, that count
    as a hang (STALL_SECONDS); ``apart``: each command loads its program again; ``folders``: and
    runs in a folder of its own, ``directory`` of its result; ``drives``: options for further disks;
    ``timed``: False if no cycles are asked for (UNTIMED). True is all of the commands, but with EXACT_PROGRAM alone,
    which is exact where it times. The boot is not, but with EXACT_BOOT.
    Raises UserError for a hang, Closed if a window was closed. The caller judges return codes and
    crash reports.
    """
    names = {command.split()[0] for command in commands}
    late = timed and machine in MEASURED and EXACT_BOOT not in names
    itself = late and names == {EXACT_PROGRAM}
    prepare(directory, [command + EXACT * itself for command in commands], files, programs, apart, folders,
            late and not itself)
    patience = patience or STALL_SECONDS
    volume, log = directory / "volume", directory / "emulator.log"
    environment = display.environment
    if machine == SECOND:
        command, environment = second_command(commands, folders), {"HOME": str(directory)}
    else:
        more = {"hard_drive_0": str(volume)} | (drives or {}) | (UNTIMED if late or not timed else {})
        command = ["fs-uae", str(write_config(directory, machine, display, more))]
    with started(command, volume, environment, log) as process:
        silence, heard = wait(process, volume, on_output, patience)
    codes = [read(volume / f"{number}.code").strip() for number in range(len(commands))]
    outputs = [read(volume / f"{number}.log") for number in range(len(commands))]
    if not (volume / "end").exists():
        last = codes.index("") if "" in codes else len(codes) - 1
        program, _, arguments = commands[last].partition(" ")
        output = max(outputs[last], heard.get(f"{last}.log", ""), key=len)
        why = explain_end(programs / program, arguments, output, silence, read(log))
        raise (Closed if not silence and process.returncode == 0 else UserError)(why)
    if "" in codes:
        raise UserError(f"{commands[codes.index('')]}: batch could not run it")
    places = [volume / str(number) if folders else volume for number in range(len(commands))]
    return [Result(*ended) for ended in zip(places, outputs, map(int, codes))]


def run(program: str, arguments: str, files: dict[str, bytes | Path], machine: str,
        directory: Path, on_output=None, programs: Path = PROGRAMS,
        patience: float | None = None, display: Display = HIDDEN, timed: bool = True) -> Result:
    """Runs one command as ``run_batch`` does; raises UserError for a crash too."""
    result, = run_batch([f"{program} {arguments}"], files, machine, directory, on_output, programs,
                       patience, display=display, timed=timed)
    fault = explain_fault(programs / program, result.output)
    if fault:
        raise UserError(fault)
    return result
