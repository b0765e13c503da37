"""The disk for owners of real Amigas: its image, and a boot from it."""

import json
import re
import time
from pathlib import Path

import pytest

from tmap.base.errors import UserError
from tmap.base.paths import BASELINE
from tmap.base.silence import Silence
from tmap.bench import bench, owner
from tmap.bench.steps import step_case
from tmap.guest import emulator, kernels
from tmap.guest.kernels import Shown
from tmap.product import disk

#: Commands that AmigaDOS's shell has in the ROM, from Kickstart 2.0 on.
IN_ROM = {"ask", "cd", "echo", "else", "endif", "endskip", "failat", "get", "if", "lab", "path",
          "prompt", "quit", "resident", "run", "set", "skip", "stack", "unset", "why"}
PARTS = 8  # of the demo
#: Seconds of processor time for which a booted disk may write nothing.
PATIENCE = emulator.PATIENT_SECONDS
FIGURES = re.compile(r"(.{16})(.{7})(.{7})(.{6})  (\d+) colour clocks, (\d+) calls")


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    return disk.contents()


@pytest.fixture(scope="module")
def image(files, tmp_path_factory) -> Path:
    """The disk as ``make adf`` writes it."""
    path = tmp_path_factory.mktemp("adf") / "tmap020.adf"
    disk.save(path, disk.image(files)[0])
    return path


def test_image_is_a_bootable_disk(files, image):
    """Size, boot block's checksum and type; every file can be read back, and the free space is
    right."""
    assert image.stat().st_size == disk.SIZE == 901_120
    volume = disk.opened(image)
    assert volume.boot.valid_chksum and volume.boot.dos_type == 0x444F5301
    assert image.read_bytes()[12:].startswith(disk.boot_code())
    for name, content in files.items():
        assert disk.read(image, name) == content, name
    content, free = disk.image(files)
    assert content == image.read_bytes(), "a second image of the same files differs"
    assert free == volume.get_free_blocks() * disk.BLOCK
    content, less = disk.image(files | {"more": bytes(512 * 10)})
    assert free - less == 512 * 11  # and its header
    assert len(content) == disk.SIZE


def test_start_needs_no_other_files(files):
    """Startup-Sequence's commands are in the ROM or on the disk."""
    known = IN_ROM | {name.lower() for name in files}
    for line in files["S/Startup-Sequence"].decode().splitlines():
        assert line.split()[0].lower() in known, line


def test_too_much_is_refused_before_anything_is_written(monkeypatch, image, tmp_path):
    """The error has name and sizes, and an existing image is unchanged."""
    out = tmp_path / "old.adf"
    out.write_bytes(b"old")
    monkeypatch.setattr(disk, "contents", lambda: {"small": bytes(1000), "large": bytes(900_000)})
    said = ("the disk is full: large has 900,000 bytes, 89.,... are free, and all files together "
            "have 901,000")
    with pytest.raises(UserError, match=said):
        disk.command(out)
    assert out.read_bytes() == b"old" and list(tmp_path.iterdir()) == [out]
    with pytest.raises(UserError, match="is a directory"):
        disk.command(tmp_path)


def test_texts_that_do_not_fit_are_refused(tmp_path):
    """Lines that are too wide, and characters that are not ASCII."""
    for content in ("x" * 77, "caf\u00e9", "a\tb"):
        path = tmp_path / "text"
        path.write_text("fine\n" + content + "\n")
        with pytest.raises(UserError, match="line 2"):
            disk.text(path)


def boot(path: Path, machine: str, folder: Path, last: str) -> None:
    """Boots a disk and waits until it has written the file ``last``."""
    config = emulator.write_config(folder, machine, emulator.HIDDEN, emulator.floppies(path))
    seen = path.stat().st_mtime_ns
    with emulator.started(["fs-uae", str(config)], folder, emulator.HIDDEN.environment, folder / "log") as process:
        silence = Silence(process.pid, PATIENCE)
        while process.poll() is None and not silence.end():
            time.sleep(0.1)
            changed = path.stat().st_mtime_ns
            if changed == seen and last in names(path):
                return
            seen = changed
    log = emulator.read(folder / "log")
    raise AssertionError(f"{machine}: {last} was not written; {log[-500:]}")


def names(path: Path) -> set[str]:
    """The names in an image's root; none while the directory is being written."""
    try:
        entries = disk.opened(path).get_root_dir().get_entries()
    except disk.FSError:
        return set()
    return {str(entry.name.get_name()) for entry in entries}


def entries_of(machine: str) -> list:
    """The rows that a machine shows."""
    return [entry for entry in owner.ENTRIES if not entry.apart or machine == "a1200-fast"]


def doubt(entry, machine: str, row: dict) -> float:
    """The largest difference in cycles between a figure and the committed one: DOUBT ticks if only
    the CPU counts; with chip RAM, whose refresh is not synchronised with the measurement, the
    bench's own tolerance; plus the rounding of both to two decimals."""
    if machine == "a1200-fast" and not entry.chip:
        return bench.DOUBT * row["one_tick"] + 0.01
    return max(bench.TOLERANCE * bench.cycles(row), bench.DOUBT * row["one_tick"]) + 0.01


@pytest.mark.parametrize("machine", owner.MACHINES)
def test_booted_disk_measures_what_is_committed(files, machine, tmp_path):
    """Boots from the floppy drive alone: Startup-Sequence with a frame of each of the demo's parts,
    then the bench. Its file, read back from the disk, has a line for every row, with the same
    cycles and the same pixels."""
    path = tmp_path / "booted.adf"
    start = files["S/Startup-Sequence"]
    assert start.count(b"\ndemo\n") == 1
    start = start.replace(b"\ndemo\n", b"\ndemo >shown FRAMES 1\n")
    start += b"measure\necho >end\n"
    disk.save(path, disk.image(files | {"S/Startup-Sequence": start})[0])
    boot(path, machine, tmp_path, "end")
    shown = disk.read(path, "shown").decode().splitlines()
    assert len(shown) == PARTS, shown
    said = disk.read(path, "tmap020.txt").decode()
    lines = said.splitlines()
    fast = emulator.MACHINES[machine].get("fast_memory", "0")  # AROS has another 1 MB
    assert re.fullmatch(r"Here: exec \d+\.\d+, 68020, AGA, PAL, 14187580 Hz, 204. KB chip, "
                        rf"{fast} KB fast", lines[1]), said
    baseline = json.loads(BASELINE.read_text())
    where = {"a1200": "chip RAM", "a1200-fast": "fast RAM"}[machine]
    assert lines[2] == f"Emulated: {owner.origin(baseline)}, {where}"
    assert max(map(len, lines)) <= disk.WIDTH and "WRONG" not in said
    committed = {bench.key(row): row for row in baseline["rows"]}
    shown = entries_of(machine)
    for entry, line in zip(shown, lines[4:], strict=False):
        title, here, emulated, ratio = FIGURES.fullmatch(line).groups()[:4]
        row = committed[entry.name, entry.conditions[machine == "a1200-fast"], entry.length]
        cycles = bench.cycles(row)
        assert title.strip() == entry.title and abs(float(emulated) - cycles) <= 0.0051, line
        assert abs(float(here) - cycles) <= doubt(entry, machine, row), f"{line}: {row}"
        assert abs(float(ratio) - float(here) / cycles) <= 0.0005 + 0.01 / cycles, line
    assert not FIGURES.fullmatch(lines[4 + len(shown)]), said


def small_plan(drawn: int) -> bytes:
    """An empty call, and a loop whose far memory must have the checksum ``drawn``."""
    units, case, _ = step_case("addx", 1)
    case.far.add(b"\1\2\3\4")
    case.repeats, case.shown = 4, Shown("steps", units, 4000, 5000, drawn)
    origin = kernels.Case("nothing", repeats=100, shown=Shown("here", 0, 0, 0, 0))
    return kernels.plan([origin, case])


def no_boot(content: bytes) -> bytes:
    """The image with a wrong checksum in its boot block, so that another disk is booted."""
    return content[:4] + bytes(4) + content[8:]


def full_disk() -> bytes:
    """An image with at most two blocks free."""
    blocks = disk.image({})[1] // disk.BLOCK
    return disk.image({"all": bytes(disk.BLOCK * (blocks * 72 // 73 - 1))})[0]


def save_to(content: bytes, folder: Path, **options: str) -> emulator.Result:
    """Runs the bench with its file on a floppy disk."""
    path = folder / "floppy.adf"
    disk.save(path, no_boot(content))
    result, = emulator.run_batch(["measure df0:x PLAN plan"], {"plan": small_plan(0)},
                                "a1200-fast", folder, drives=emulator.floppies(path) | options,
                                timed=False)
    return result


def test_what_is_lacking_is_said(tmp_path):
    """Missing arguments and files; pixels that differ from the emulated machine's."""
    right = kernels.checksum(b"\1\2\3\4")
    plan, wrong = small_plan(right), small_plan(right + 1)
    said = {"measure PLAN right": ("Saved as tmap020.txt", 0),
            "measure other PLAN wrong": ("Saved as other", 0),
            "measure": ("PROGDIR:measure.plan: cannot be opened", 10),
            "measure PLAN S": ("S: cannot be opened", 10),
            "measure PLAN short": ("short: not a usable plan file: size", 10),
            "measure PLAN none": ("none: has nothing to show", 10),
            "measure PLAN bench": ("bench: has nothing to show", 10),
            "measure a b c": ("measure: usage: measure [TO FILE] [PLAN FILE]", 10),
            "measure S PLAN right": ("S cannot be created: object is not of required type", 10)}
    files = {"right": plan, "wrong": wrong, "short": plan[:-4], "none": kernels.plan([]),
             "bench": kernels.plan([kernels.Case("nothing")])}
    results = emulator.run_batch(list(said), files, "a1200-fast", tmp_path)
    for (command, expected), result in zip(said.items(), results, strict=True):
        assert (result.output.splitlines()[-1], result.code) == expected, f"{command}: {result}"
    saved, other = (emulator.read(tmp_path / "volume" / name) for name in ("tmap020.txt", "other"))
    assert re.search(r"\nsteps +4\.6\d +5\.00 0\.92\d  ", saved) and "WRONG" not in saved
    assert re.search(r"\nsteps +4\.6\d +5\.00 WRONG  .*\nWRONG: ", other)


def test_disks_that_cannot_be_written(tmp_path):
    """The errors are dos's messages, without its requester: write-protected, and full (as AROS
    reports it)."""
    result = save_to(disk.image({})[0], tmp_path / "protected",
                     uae_floppy_write_protect="true")
    assert result.output.endswith("\ndf0:x cannot be created: disk is write-protected\n")
    assert result.code == 10
    result = save_to(full_disk(), tmp_path / "full")
    assert re.search(r"\ndf0:x cannot be (created|written): (disk is full|not enough memory "
                     r"available)\n$", result.output) and result.code == 10
