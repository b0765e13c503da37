"""``tmap play``: a bootable disk, or a folder, with which an Amiga plays one scene on its screen."""

from pathlib import Path

from tmap.base.errors import UserError
from tmap.base.outputs import check_directory, replaced
from tmap.base.paths import PROGRAMS
from tmap.compiler.scene import compile_scene
from tmap.product import disk
from tmap.run import conversion, memory, show
from tmap.scene_file.scene_file import write

PROGRAM, SCENE = "show", "play.scene"  # the files beside the script, which is
SCRIPT = "play"  # in a folder
VOLUME_MOST = 30  # letters of a volume's name


def volume_name(path: Path) -> str:
    """Returns a volume's name for a scene file: without what AmigaDOS reads as a path, in its characters."""
    letters = "".join("-" if letter in ":/" else letter for letter in path.stem)
    return letters.encode("latin-1", "replace").decode("latin-1")[:VOLUME_MOST]


def files(path: Path, machine: str, fps: float | None) -> dict[str, bytes]:
    """Returns the script, then the others, by name in a folder; raises UserError if the screen cannot show the scene, or it does not fit the machine."""
    hold, scene = show.held(fps), compile_scene(path)
    if conversion.cycles(scene, machine) is None:
        raise UserError(f"{path}: width, height: a screen shows at most {conversion.SCREEN[0]}x{conversion.SCREEN[1]}, "
                        "the width a multiple of 8")
    memory.check(scene, machine, str(path))
    start = f"{PROGRAM} {SCENE} PLAIN{hold}\n"
    return {SCRIPT: start.encode(), PROGRAM: (PROGRAMS / PROGRAM).read_bytes(), SCENE: write(scene)}


def save(out: Path, made: dict[str, bytes]) -> None:
    """Writes a folder; what else is in it stays."""
    check_directory(out)
    with replaced(out, made, SCRIPT) as folder:
        for name, content in made.items():
            (folder / name).write_bytes(content)


def command(path: Path, out: Path, machine: str, fps: float | None = None) -> int:
    """``tmap play``: an image if ``out`` ends with .adf, else a folder; raises UserError."""
    made = files(path, machine, fps)
    if out.suffix.lower() == ".adf":
        return disk.put(out, {disk.STARTUP: made.pop(SCRIPT)} | made, volume_name(path))
    save(out, made)
    print(f"{out}: {sum(map(len, made.values())):,} bytes; on the Amiga: cd there, then execute {SCRIPT}")
    return 0
