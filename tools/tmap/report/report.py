"""``tmap report``: all measurements in one page, index.html, which needs nothing else."""

import shutil
from pathlib import Path

from tmap.accuracy import perspective_curves
from tmap.base.outputs import bars, check_directory, replaced
from tmap.base.paths import SCENES
from tmap.guest.cache import ENTRY
from tmap.report import bench_pictures, data, page, pictures
from tmap.report.data import Found

PAGE, PICTURES, HARD = "index.html", "pictures", "hard"


def write_pictures(found: Found, folder: Path) -> None:
    """Writes all pictures of the page."""
    folder.mkdir()
    for scene in found.scenes:
        for name in data.SCENE_FILES[1:]:
            if (scene.folder / name).exists():
                shutil.copyfile(scene.folder / name, folder / f"{scene.result['scene']}_{name}")
    for name in pictures.SIZES:
        pictures.plot(found.accuracy["rows"], data.MACHINE, folder / name)
    bench_pictures.write(found.bench, folder)
    perspective_curves.plot(folder / "pieces.png")
    methods = found.methods.folder if found.methods else SCENES
    shutil.copyfile(methods / "methods.png", folder / "methods.png")
    shutil.copyfile(SCENES / "demo.png", folder / "demo.png")
    if found.fit:
        shutil.copyfile(found.fit.folder / "fit.png", folder / "fit.png")
    if found.sets:
        for name in ("swimming.gif", "swimming.png", "accuracy.png"):
            shutil.copyfile(found.sets.folder / name, folder / name)


def write(found: Found, out: Path) -> None:
    """Replaces an earlier report in ``out``."""
    with replaced(out, (PICTURES, HARD), PAGE) as made:
        write_pictures(found, made / PICTURES)
        if found.hard:
            shutil.copytree(found.hard.folder, made / HARD, ignore=shutil.ignore_patterns(ENTRY))
        (made / PAGE).write_text(page.page(found, made / PICTURES))


def command(out: Path, scenes: list[str] | None, machine: str, only_committed: bool) -> int:
    """``tmap report``: measures what the cache lacks, writes the page, prints its path."""
    check_directory(out)
    names = data.scene_names(scenes)
    with bars() as progress:
        found = data.gather(names, machine, only_committed, progress)
    write(found, out)
    print(f"written: {out / PAGE}")
    for line in found.hard.result["complaints"] if found.hard else ():
        print(f"exceeds its bound: {line}")
    return 0
