"""``tmap report``: all that is measured in one page, index.html, which needs nothing else."""

import shutil
import sys
import tempfile
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from . import perspective_curves, report_data, report_page, report_pictures
from .cache import ENTRY
from .errors import UserError
from .paths import SCENES
from .report_data import Found
from .run import check_directory

PAGE, PICTURES, HARD = "index.html", "pictures", "hard"


def write_pictures(found: Found, folder: Path) -> None:
    """All pictures of the page."""
    folder.mkdir()
    for scene in found.scenes:
        for name in report_data.SCENE_FILES[1:]:
            if (scene.folder / name).exists():
                shutil.copyfile(scene.folder / name, folder / f"{scene.result['scene']}_{name}")
    for name in report_pictures.SIZES:
        report_pictures.plot(found.accuracy["rows"], report_data.MACHINE, folder / name)
    perspective_curves.plot(folder / "pieces.png")
    methods = found.methods.folder if found.methods else SCENES
    shutil.copyfile(methods / "methods.png", folder / "methods.png")
    if found.sets:
        for name in ("swimming.gif", "swimming.png", "accuracy.png"):
            shutil.copyfile(found.sets.folder / name, folder / name)


def write(found: Found, out: Path) -> None:
    """Replaces what an earlier report left in ``out``, once everything new is on the disk."""
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".tmap-", dir=out) as temporary:
        made = Path(temporary)
        write_pictures(found, made / PICTURES)
        if found.hard:
            shutil.copytree(found.hard.folder, made / HARD, ignore=shutil.ignore_patterns(ENTRY))
        (made / PAGE).write_text(report_page.page(found, made / PICTURES))
        for name in (PICTURES, HARD):
            shutil.rmtree(out / name, ignore_errors=True)
        for path in sorted(made.iterdir(), key=lambda path: path.name == PAGE):  # the page last
            path.replace(out / path.name)


def command(out: Path, scenes: list[str] | None, machine: str, only_committed: bool) -> int:
    """``tmap report``: measures what is not in the cache, writes the page, says where it is."""
    check_directory(out)
    names = report_data.scene_names(scenes)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(),
               TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True,
                  disable=not sys.stderr.isatty()) as progress:
        found = report_data.gather(names, machine, only_committed, progress)
    try:
        write(found, out)
    except OSError as error:
        raise UserError(f"{error.filename or out}: {error.strerror or error}") from None
    print(f"written: {out / PAGE}")
    for line in found.hard.result["complaints"] if found.hard else ():
        print(f"exceeds its bound: {line}")
    return 0
