"""Runs a program on the emulated A1200 and judges how it ended.

A run has one private directory: it is the boot volume, holds the program, its
input and whatever it writes. The guest's start-up script runs the program with
its output in ``out.log`` and then ``uaequit end``, which writes the program's
return code to ``end`` (the sentinel) and leaves the emulator.
"""

import re
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from .errors import UserError
from .paths import PROGRAMS

#: FS-UAE options of each machine; all are A1200s with AGA, cycle-exact.
MACHINES = {
    "a1200": {},
    "a1200-fast": {"fast_memory": "8192"},
}
OPTIONS = {
    "amiga_model": "A1200",
    "floppy_drive_count": "0",
    "warp_mode": "1",
    "audio_driver": "null",
    "fullscreen": "0",
    "uae_sound_output": "none",
    "joystick_port_0": "none",
    "joystick_port_1": "none",
}
#: Host seconds without a byte of output before a run counts as hung. A boot
#: takes about 1 s and the guest's own watchdog bites within 3 s.
STALL_SECONDS = 20.0
VERSION = "3.1.66"  # the cycle figures in this tree are those of this version

EXCEPTIONS = {
    2: "bus error", 3: "address error", 4: "illegal instruction", 5: "division by zero",
    6: "CHK", 7: "TRAPV", 8: "privilege violation", 9: "trace", 10: "line A", 11: "line F",
    0x100: "no end: stopped by the watchdog",
}


@dataclass
class Result:
    """What a run left: its directory, the program's output and return code."""

    directory: Path
    output: str
    code: int


def emulator_version() -> str:
    """The version of the FS-UAE on PATH."""
    try:
        return subprocess.run(["fs-uae", "--version"], capture_output=True, text=True).stdout.strip()
    except OSError:
        raise UserError("fs-uae is not installed: run scripts/setup") from None


def routine_at(program: str, offset: int) -> str:
    """Name and offset of the routine that holds a code offset of a program."""
    best = "?"
    for line in (PROGRAMS / f"{program}.map").read_text().splitlines():
        value, name = line.split()
        if int(value, 16) > offset:
            break
        best = f"{name.lstrip('_')}+${offset - int(value, 16):x}"
    return best


def explain_fault(program: str, output: str) -> str | None:
    """One line about the crash reported in ``output``, or None."""
    match = re.search(r"fault: exception ([0-9a-f]{8}) pc ([0-9a-f]{8})\n(.*)\n(.*)", output)
    if not match:
        return None
    number, pc = int(match[1], 16), int(match[2], 16)
    kind = EXCEPTIONS.get(number, "unexpected")
    name = routine_at(program, pc) if pc < 1 << 24 else "outside the program"
    return (f"{program} crashed: exception {number} ({kind}) at PC {pc:#x}, in {name}\n"
            f"  d0-d7 {match[3].strip()}\n  a0-a7 {match[4].strip()}")


def last_words(output: str) -> str:
    """The last line a guest wrote, for a message on how far it came."""
    lines = [line for line in output.splitlines() if line.strip()]
    return f"its last words: {lines[-1]!r}" if lines else "it wrote nothing"


def run(program: str, arguments: str, files: dict[str, bytes | Path], machine: str,
        directory: Path | None = None, on_output=None) -> Result:
    """Boots ``machine``, runs ``program arguments`` and waits for the end.

    ``files`` are put into the run's directory first (a name to bytes, or to a
    file that is copied). ``on_output`` is called with the output so far when
    there is more of it. Raises UserError for a crash or a hang; a non-zero
    return code is the caller's to judge.
    """
    if directory is None:
        directory = Path(tempfile.mkdtemp(prefix="tmap-"))
    volume = directory / "volume"
    (volume / "S").mkdir(parents=True)
    for name, content in files.items():
        target = volume / name
        if isinstance(content, bytes):
            target.write_bytes(content)
        else:
            shutil.copyfile(content, target)
    for name in (program, "uaequit"):
        shutil.copyfile(PROGRAMS / name, volume / name)
    (volume / "S" / "Startup-Sequence").write_text(
        f"failat 100\n{program} >out.log {arguments}\nuaequit end\n")
    options = OPTIONS | MACHINES[machine] | {
        "base_dir": str(directory / "base"), "hard_drive_0": str(volume)}
    config = directory / "a1200.fs-uae"
    config.write_text("[fs-uae]\n" + "".join(f"{k} = {v}\n" for k, v in options.items()))
    log = (directory / "emulator.log").open("wb")
    import os
    process = subprocess.Popen(["fs-uae", str(config)], stdout=log, stderr=subprocess.STDOUT,
                               stdin=subprocess.DEVNULL,
                               env=os.environ | {"SDL_VIDEODRIVER": "offscreen"})
    out, end = volume / "out.log", volume / "end"
    seen, quiet_since = -1, time.monotonic()
    try:
        while process.poll() is None:
            size = out.stat().st_size if out.exists() else 0
            size += sum(1 for _ in volume.iterdir())
            if size != seen:
                seen, quiet_since = size, time.monotonic()
                if on_output and out.exists():
                    on_output(out.read_text("latin-1"))
            elif time.monotonic() - quiet_since > STALL_SECONDS:
                break
            time.sleep(0.02)
    finally:
        if process.poll() is None:
            process.kill()
        process.wait()
        log.close()
    output = out.read_text("latin-1") if out.exists() else ""
    fault = explain_fault(program, output)
    if fault:
        raise UserError(fault)
    if not end.exists():
        raise UserError(f"{program} did not end within {STALL_SECONDS:.0f} s of its last output; "
                        f"{last_words(output)} (run directory {directory})")
    return Result(volume, output, int(end.read_text()))
