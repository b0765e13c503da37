"""The commands' output: folders that are replaced as a whole, animations, progress bars."""

import json
import os
import shutil
import sys
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from PIL import Image
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from tmap.base.errors import UserError


def check_directory(out: Path) -> None:
    """Refuses a path where no directory can be made, before the work begins."""
    for place in (out, *out.parents):
        if os.path.lexists(place):
            if not place.is_dir():
                raise UserError(f"{place}: is not a directory")
            return


def bars() -> Progress:
    """Progress bars on stderr that vanish at the end; disabled if stderr is not a terminal."""
    return Progress(TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(),
                    TimeElapsedColumn(), console=Console(stderr=True), transient=True,
                    disable=not sys.stderr.isatty())


def as_json(found: dict) -> str:
    """The text of a file of figures: a field a line, of tables a row a line."""
    fields = [f'"{key}": ' + ("[\n  " + ",\n  ".join(map(json.dumps, value)) + "\n ]"
                             if isinstance(value, list) else json.dumps(value))
              for key, value in found.items()]
    return "{\n " + ",\n ".join(fields) + "\n}\n"


@contextmanager
def replaced(out: Path, old: Iterable[str], last: str) -> Iterator[Path]:
    """Yields a folder to write to. Once everything is on the disk, the files in ``out`` that match
    the patterns ``old`` are deleted and the folder's content is moved there. The file ``last``,
    which describes the rest, is moved last."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".tmap-", dir=out) as temporary:
            made = Path(temporary)
            yield made
            for path in [path for pattern in old for path in out.glob(pattern)]:
                shutil.rmtree(path) if path.is_dir() else path.unlink()
            for path in sorted(made.iterdir(), key=lambda path: (path.name == last, path.name)):
                path.replace(out / path.name)
    except OSError as error:
        raise UserError(f"{error.filename or out}: {error.strerror or error}") from None


def save_animation(path: Path, pictures: Iterable[Image.Image], frame_ms: int | list[int], **options) -> None:
    """Saves a GIF that repeats without end. ``frame_ms``: of all frames, or of each; ``options``:
    Pillow's."""
    first, *others = pictures
    first.save(path, save_all=True, append_images=others, duration=frame_ms, loop=0, **options)
