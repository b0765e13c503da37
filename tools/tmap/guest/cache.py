"""Results kept by content: what was measured from the same inputs is not measured again.

An entry is the directory build/cache/NAME-KEY. Its entry.json, written last, has the result and
the digest of every file beside it; an entry that is not as it says is measured again.
"""

import ast
import functools
import hashlib
import json
import os
import shutil
import tempfile
import tomllib
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from tmap.base.paths import BUILD, PROGRAMS, ROOT
from tmap.guest import emulator

CACHE = BUILD / "cache"
ENTRY = "entry.json"


@dataclass
class Entry:
    """A result (JSON) and the directory of the files that belong to it."""

    result: dict
    folder: Path


def digest(path: Path) -> str:
    """SHA-256 of a file's bytes."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


@functools.cache
def imports(text: str) -> list[str]:
    """What may be the modules of the tools that a source text imports, inside functions too: their
    paths, as "tmap/n64/state"."""
    names = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "tmap":
            base = node.module.replace(".", "/")
            names += [base, *(f"{base}/{alias.name}" for alias in node.names)]
    return names


def sources(module: str) -> list[Path]:
    """The files of the tools that a module, as "tmap/bench/bench", needs: its own, and what it imports,
    however deep."""
    found, names = {}, [module]
    while names:
        name = names.pop()
        path = ROOT / "tools" / f"{name}.py"
        if name in found or not path.is_file():
            continue
        found[name] = path
        names += imports(path.read_text())
    return [found[name] for name in sorted(found)]


def scene_files(path: Path) -> list[Path]:
    """A scene's file and every file beside it that it names."""
    def words(value) -> Iterable[str]:
        if isinstance(value, str):
            yield value
        elif isinstance(value, dict | list):
            for each in value.values() if isinstance(value, dict) else value:
                yield from words(each)

    named = {path.parent / word for word in words(tomllib.loads(path.read_text()))}
    # Unlike Path.is_file, os.path's says no of impossible names too.
    return [path, *sorted(file for file in named if os.path.isfile(file))]


def key(module: str, files: Iterable[Path] = (), words: Iterable[str] = ()) -> str:
    """What identifies a measurement: the Amiga programs' bytes, the sources of the tool that
    measures, the emulator's version, files that it reads, and words such as the machine's name."""
    programs = [path for path in PROGRAMS.iterdir() if path.suffix != ".map"]
    total = hashlib.sha256()
    for path in [*sorted(programs), *sources(module), *files]:
        total.update(f"{path.name} {digest(path)}\n".encode())
    for word in [emulator.emulator_version(), *words]:
        total.update(f"{word}\n".encode())
    return total.hexdigest()[:32]


def load(folder: Path) -> Entry | None:
    """An entry as it was kept, or None where it is missing or damaged."""
    try:
        about = json.loads((folder / ENTRY).read_text())
        result, files = about["result"], about["files"]
        if about["digest"] != of_result(result) or not isinstance(files, dict):
            return None
        if any(digest(folder / name) != kept for name, kept in files.items()):
            return None
    except (OSError, ValueError, KeyError, TypeError):
        return None
    return Entry(result, folder)


def of_result(result) -> str:
    """The digest of a result."""
    return hashlib.sha256(json.dumps(result).encode()).hexdigest()


def kept(name: str, identity: str, make: Callable[[Path], dict],
         cache: Path | None = None) -> Entry:
    """The entry of a name and key; ``make`` measures what is not there: it writes files into the
    directory it is given and returns the result."""
    folder = (cache or CACHE) / f"{name}-{identity}"
    entry = load(folder)
    if entry:
        return entry
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=f".{name}-", dir=folder.parent) as temporary:
        made = Path(temporary) / "made"
        made.mkdir()
        result = json.loads(json.dumps(make(made)))
        files = {str(path.relative_to(made)): digest(path)
                 for path in sorted(made.rglob("*")) if path.is_file()}
        (made / ENTRY).write_text(json.dumps(
            {"digest": of_result(result), "files": files, "result": result}) + "\n")
        shutil.rmtree(folder, ignore_errors=True)
        made.replace(folder)
    return Entry(result, folder)
