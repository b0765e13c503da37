"""``tmap adf``: a bootable disk with the demo, the owners' bench and a readme.

The disk is FFS, which an A1200's Kickstart (3.0 and later) boots. Its boot block is ours, and it
holds no system files: all that Startup-Sequence uses is in the Kickstart ROM.
"""

import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from amitools.fs import DosType
from amitools.fs.ADFSVolume import ADFSVolume
from amitools.fs.blkdev.ADFBlockDevice import ADFBlockDevice
from amitools.fs.FSError import NO_FREE_BLOCKS, FSError
from amitools.fs.FSString import FSString
from amitools.fs.MetaInfo import MetaInfo
from amitools.fs.RootMetaInfo import RootMetaInfo
from amitools.fs.TimeStamp import TimeStamp

from tmap.base.errors import UserError
from tmap.base.paths import BUILD, PROGRAMS, ROOT
from tmap.bench import owner
from tmap.build import elf_object
from tmap.guest.provenance import commit_seconds
from tmap.run import demo

VOLUME = "tmap020"
IMAGE = BUILD / "adf" / f"{VOLUME}.adf"
SIZE = 901_120  # 80 tracks of two sides of 11 sectors of 512 bytes
BLOCK = 512
TEXTS = Path(__file__).with_name("disk_files")
WIDTH = 76  # columns of a text: a console has 77, and shows an empty line after lines of 77
READ, WRITE, EXECUTE, DELETE, SCRIPT = 8, 4, 2, 1, 64  # the first four mean "may not"


@dataclass(frozen=True)
class Item:
    """A file of the disk; ``make`` returns its bytes."""

    name: str
    make: Callable[[], bytes]
    script: bool = False


def text(path: Path) -> bytes:
    """Returns a text file or script; refuses lines that an Amiga's console cannot show."""
    content = path.read_text()
    for number, line in enumerate(content.splitlines(), 1):
        shown = line.removeprefix('Echo "').removesuffix('"')
        if len(shown) > WIDTH or not line.isascii() or "\t" in line:
            raise UserError(f"{path}: line {number}: not ASCII of at most {WIDTH} columns")
    return content.encode()


#: Files on the disk in addition to the demo, in the order in which they are written.
ITEMS = (
    Item("S/Startup-Sequence", lambda: text(TEXTS / "Startup-Sequence"), script=True),
    Item("measure", (PROGRAMS / "measure").read_bytes),
    Item("measure.plan", owner.make),
    Item("ReadMe.txt", lambda: text(TEXTS / "ReadMe.txt")),
    Item("LICENSE", (ROOT / "LICENSE").read_bytes),
)


def contents() -> dict[str, bytes]:
    """Returns all files of the disk by name: ITEMS, and the demo's folder."""
    return {item.name: item.make() for item in ITEMS} | demo.files()


def boot_code() -> bytes:
    """Returns the boot block's code."""
    path = BUILD / "obj" / "asm" / "amiga" / "boot.o"
    code, = (part for part in elf_object.load(path) if part.name == ".text.boot")
    assert not code.relocations
    return code.data


def commit_time() -> TimeStamp:
    """Returns the date of all files."""
    stamp = TimeStamp()
    stamp.from_secs(commit_seconds())
    return stamp


def volume_of(device: ADFBlockDevice) -> ADFSVolume:
    """Makes an empty bootable volume."""
    stamp, volume = commit_time(), ADFSVolume(device)
    volume.create(FSString(VOLUME), RootMetaInfo(stamp, stamp, stamp), DosType.DOS_FFS, boot_code())
    return volume


def write(volume: ADFSVolume, name: str, content: bytes) -> None:
    """Adds a file, and its drawer if that is new."""
    script = SCRIPT if any(item.script for item in ITEMS if item.name == name) else 0
    about = MetaInfo(protect=script, mod_ts=commit_time())
    drawer, _, last = name.rpartition("/")
    place = volume.get_root_dir()
    if drawer:
        place = volume.get_dir_path_name(FSString(drawer)) or place.create_dir(
            FSString(drawer), MetaInfo(protect=0, mod_ts=commit_time()), update_ts=False)
    place.create_file(FSString(last), content, about, update_ts=False)


def image(files: dict[str, bytes]) -> tuple[bytes, int]:
    """Returns a disk's image and the number of free bytes; raises UserError if the disk is full."""
    device = ADFBlockDevice(None)
    device.create()
    volume = volume_of(device)
    for name, content in files.items():
        free = BLOCK * volume.get_free_blocks()
        try:
            write(volume, name, content)
        except FSError as error:
            if error.code != NO_FREE_BLOCKS:
                raise
            raise UserError(f"adf: the disk is full: {name} has {len(content):,} bytes, "
                            f"{free:,} are free, and all files together have "
                            f"{sum(map(len, files.values())):,}") from None
    volume.close()
    return bytes(device.data), BLOCK * volume.get_free_blocks()


def opened(path: Path) -> ADFSVolume:
    """Opens the volume of an image file."""
    device = ADFBlockDevice(str(path), read_only=True)
    device.open()
    volume = ADFSVolume(device)
    volume.open()
    return volume


def read(path: Path, name: str) -> bytes:
    """Reads a file from an image file."""
    return bytes(opened(path).read_file(FSString(name)))


def save(path: Path, content: bytes) -> None:
    """Writes an image, whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile(dir=path.parent, prefix=".tmap-", delete=False) as stream:
        try:
            stream.write(content)
            stream.close()
            os.chmod(stream.name, 0o644)
            os.replace(stream.name, path)
        except BaseException:
            os.unlink(stream.name)
            raise


def command(out: Path) -> int:
    """``tmap adf``: writes the image and prints its contents; raises UserError."""
    if out.is_dir():
        raise UserError(f"{out}: is a directory")
    files = contents()
    content, free = image(files)
    save(out, content)
    for name, part in files.items():
        print(f"{len(part):>9,}  {name}")
    print(f"{free:>9,}  free")
    print(f"written to {out}")
    return 0
