"""``tmap adf``: a bootable disk with the demo, the owners' bench and a readme.

The disk is FFS, which an A1200's Kickstart (3.0 and later) boots. Its boot block is ours, and it
holds no system files: all that Startup-Sequence uses is in the Kickstart ROM.
"""

import os
import tempfile
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
STARTUP = "S/Startup-Sequence"  # the script that a booted volume runs
IMAGE = BUILD / "adf" / f"{VOLUME}.adf"
SIZE = 901_120  # 80 tracks of two sides of 11 sectors of 512 bytes
BLOCK = 512
TEXTS = Path(__file__).with_name("disk_files")
WIDTH = 76  # columns of a text: a console has 77, and shows an empty line after lines of 77
READ, WRITE, EXECUTE, DELETE, SCRIPT = 8, 4, 2, 1, 64  # the first four mean "may not"


def text(path: Path) -> bytes:
    """Returns a text file or script; refuses lines that an Amiga's console cannot show."""
    content = path.read_text()
    for number, line in enumerate(content.splitlines(), 1):
        shown = line.removeprefix('Echo "').removesuffix('"')
        if len(shown) > WIDTH or not line.isascii() or "\t" in line:
            raise UserError(f"{path}: line {number}: not ASCII of at most {WIDTH} columns")
    return content.encode()


def contents() -> dict[str, bytes]:
    """Returns all files of the disk by name, in the order in which they are written."""
    return {STARTUP: text(TEXTS / "Startup-Sequence"), "measure": (PROGRAMS / "measure").read_bytes(),
            "measure.plan": owner.make(), "ReadMe.txt": text(TEXTS / "ReadMe.txt"),
            "LICENSE": (ROOT / "LICENSE").read_bytes()} | demo.files()


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


def volume_of(device: ADFBlockDevice, name: str) -> ADFSVolume:
    """Makes an empty bootable volume."""
    stamp, volume = commit_time(), ADFSVolume(device)
    volume.create(FSString(name), RootMetaInfo(stamp, stamp, stamp), DosType.DOS_FFS, boot_code())
    return volume


def write(volume: ADFSVolume, name: str, content: bytes) -> None:
    """Adds a file, and its drawer if that is new."""
    about = MetaInfo(protect=SCRIPT if name == STARTUP else 0, mod_ts=commit_time())
    drawer, _, last = name.rpartition("/")
    place = volume.get_root_dir()
    if drawer:
        place = volume.get_dir_path_name(FSString(drawer)) or place.create_dir(
            FSString(drawer), MetaInfo(protect=0, mod_ts=commit_time()), update_ts=False)
    place.create_file(FSString(last), content, about, update_ts=False)


def image(files: dict[str, bytes], name: str = VOLUME) -> tuple[bytes, int]:
    """Returns the image of a disk with a name, and the number of free bytes; raises UserError if the disk is full."""
    device = ADFBlockDevice(None)
    device.create()
    volume = volume_of(device, name)
    for path, content in files.items():
        free = BLOCK * volume.get_free_blocks()
        try:
            write(volume, path, content)
        except FSError as error:
            if error.code != NO_FREE_BLOCKS:
                raise
            raise UserError(f"adf: the disk is full: {path} has {len(content):,} bytes, "
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


def put(out: Path, files: dict[str, bytes], name: str = VOLUME) -> int:
    """Writes an image and prints its contents; returns 0, or raises UserError."""
    if out.is_dir():
        raise UserError(f"{out}: is a directory")
    content, free = image(files, name)
    save(out, content)
    for name, part in files.items():
        print(f"{len(part):>9,}  {name}")
    print(f"{free:>9,}  free")
    print(f"written to {out}")
    return 0


def command(out: Path) -> int:
    """``tmap adf``: writes the image of the project's disk; raises UserError."""
    return put(out, contents())
