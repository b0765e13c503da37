"""``tmap demo``: makes the demo's folder for an Amiga, and plays the demo in a window.

``demo`` is the program, ``data/parts`` the script (c/demo/script.h) and ``data/NAME.scene`` the
scenes it names, compiled from the TOML beside it.
"""

import re
import shutil
from pathlib import Path

from tmap.base.paths import PROGRAMS, ROOT
from tmap.compiler.scene import compile_scene
from tmap.run import show
from tmap.scene_file.scene_file import write

SOURCE = ROOT / "tests" / "scenes" / "demo"
SCRIPT = "parts"


def data(source: Path = SOURCE) -> dict[str, bytes]:
    """Returns the script and its scenes, by their names in ``data``."""
    script = (source / SCRIPT).read_text()
    names = dict.fromkeys(re.findall(r"^scene (\S+)\.scene$", script, re.M))
    return {SCRIPT: script.encode()} | {
        f"{name}.scene": write(compile_scene(source / f"{name}.toml")) for name in names}


def files() -> dict[str, bytes]:
    """Returns all files of the folder, by path."""
    return {"demo": (PROGRAMS / "demo").read_bytes()} | {
        f"data/{name}": content for name, content in data().items()}


def make(out: Path) -> list[Path]:
    """Writes the folder, replacing an older one; returns its files."""
    written = files()
    shutil.rmtree(out / "data", ignore_errors=True)
    (out / "data").mkdir(parents=True)
    for name, content in written.items():
        (out / name).write_bytes(content)
    return [out / name for name in written]


def command(out: Path, machine: str | None) -> int:
    """``tmap demo``: writes the folder; if a machine is given, plays it too."""
    display = show.window() if machine else None
    made = make(out)
    size = sum(path.stat().st_size for path in made)
    print(f"{out}: demo and {len(made) - 1} files in data, {size:,} bytes")
    if machine:
        print(show.play("demo", '""', data(), machine, display), end="")
    return 0
