"""Keeps results by content: the same inputs are not measured again.

An entry is the directory build/cache/NAME-KEY. Its entry.json, written last, has the result and the
digest of every file beside it. A damaged entry is measured again.
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
    """Returns the SHA-256 of a file's bytes."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


@functools.cache
def imports(text: str) -> list[str]:
    """Returns possible paths, as "tmap/n64/state", of the tools' modules that a source text
    imports, inside functions too."""
    names = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "tmap":
            base = node.module.replace(".", "/")
            names += [base, *(f"{base}/{alias.name}" for alias in node.names)]
    return names


def sources(module: str) -> list[Path]:
    """Returns the tools' source files that a module, as "tmap/bench/bench", needs: its own, and
    those of direct and indirect imports. FileNotFoundError: there is no such module."""
    (ROOT / "tools" / f"{module}.py").stat()
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
    """Returns a scene's file and every file beside it that it names."""
    def words(value) -> Iterable[str]:
        if isinstance(value, str):
            yield value
        elif isinstance(value, dict | list):
            for each in value.values() if isinstance(value, dict) else value:
                yield from words(each)

    named = {path.parent / word for word in words(tomllib.loads(path.read_text()))}
    # Unlike Path.is_file, os.path.isfile returns False for impossible names too.
    return [path, *sorted(file for file in named if os.path.isfile(file))]


def key(module: str, files: Iterable[Path] = (), words: Iterable[str] = ()) -> str:
    """Returns the key of a measurement: a digest of the Amiga programs, the sources of the
    measuring tool, the emulator's version, the files that it reads, and words such as the machine's
    name."""
    programs = [path for path in PROGRAMS.iterdir() if path.suffix != ".map"]
    total = hashlib.sha256()
    for path in [*sorted(programs), *sources(module), *files]:
        total.update(f"{path.name} {digest(path)}\n".encode())
    for word in [emulator.emulator_version(), *words]:
        total.update(f"{word}\n".encode())
    return total.hexdigest()[:32]


def load(folder: Path) -> Entry | None:
    """Returns an entry, or None if it is missing or damaged."""
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
    """Returns the digest of a result."""
    return hashlib.sha256(json.dumps(result).encode()).hexdigest()


def kept(name: str, identity: str, make: Callable[[Path], dict],
         cache: Path | None = None) -> Entry:
    """Returns the entry of a name and key. If there is none, ``make`` measures: it writes files
    into the given directory and returns the result."""
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
