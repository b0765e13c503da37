"""The rooms of the tree: which room may use which, no circles, short files, folders that are not
full."""

from collections import Counter
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from tmap.base import rooms
from tmap.base.paths import ROOT

TOOLS, TESTS, C = ROOT / "tools" / "tmap", ROOT / "tests", ROOT / "c"
LINES = {".py": 400, ".c": 400, ".h": 400, ".s": 300, ".i": 300}
FILES = 25  # in a folder, without __init__.py


def python(top: Path) -> list[Path]:
    return sorted(top.rglob("*.py"))


def uses(files: Iterable[Path], used: Callable) -> dict[Path, set[Path]]:
    """Maps each file to those that it uses."""
    return {file: set(used(file)) - {file} for file in files}


GRAPHS = {
    "tools/tmap": (TOOLS, rooms.TOOLS, uses(python(TOOLS), lambda f: rooms.imported(f, "tmap", TOOLS))),
    "tests": (TESTS, rooms.TESTS, uses(python(TESTS), lambda f: rooms.imported(f, "tests", TESTS))),
    "c": (C, rooms.C, uses(sorted([*C.rglob("*.c"), *C.rglob("*.h")]), rooms.included))}


def upwards(top: Path, lists: Iterable[str], graph: dict[Path, set[Path]]) -> list[str]:
    """Lists uses of a room at the same level or below."""
    ranks = rooms.ranks(lists)
    found = []
    for file, used in graph.items():
        room = rooms.room_of(file, top, lists)
        for other in used:
            its = rooms.room_of(other, top, lists)
            if its != room and ranks[its] >= ranks[room]:
                found.append(f"{file.relative_to(ROOT)} ({room}) uses {other.relative_to(ROOT)} ({its})")
    return sorted(found)


def circle(graph: dict[Path, set[Path]]) -> list[Path]:
    """Returns the files of a circle, or none: repeatedly removes files that use none of the
    remaining ones."""
    left = {file: set(used) for file, used in graph.items()}
    while True:
        ends = {file for file, used in left.items() if not used & left.keys()}
        if not ends:
            return sorted(left)
        left = {file: used for file, used in left.items() if file not in ends}


@pytest.mark.parametrize("tree", GRAPHS)
def test_rooms_use_those_above(tree: str) -> None:
    """Every room is listed, and no import or include leads down or sideways."""
    top, lists, graph = GRAPHS[tree]
    folders = {file.parent.relative_to(top).as_posix() for file in graph}
    assert folders - {"."} <= {room for some in lists for room in some.split()}
    wrong = upwards(top, lists, graph)
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("tree", GRAPHS)
def test_no_file_uses_itself_through_others(tree: str) -> None:
    found = circle(GRAPHS[tree][2])
    assert not found, ", ".join(str(file.relative_to(ROOT)) for file in found)


def test_a_circle_and_a_use_upwards_are_found() -> None:
    """Made-up files with a circle and with a use in the wrong direction."""
    a, b, c = (TOOLS / name for name in ("base/a.py", "base/b.py", "build/c.py"))
    assert circle({a: {b}, b: {a}, c: {a}}) == [a, b, c] and not circle({a: {b}, b: set(), c: {a}})
    assert len(upwards(TOOLS, rooms.TOOLS, {a: {c}, c: {b}})) == 1


def test_files_are_short() -> None:
    files = [file for top in ("tools", "tests", "c", "src68k") for file in (ROOT / top).rglob("*")
             if file.suffix in LINES]
    counts = {str(file.relative_to(ROOT)): len(file.read_text().splitlines()) for file in files}
    assert not {name: n for name, n in counts.items() if n > LINES[Path(name).suffix]}


@pytest.mark.parametrize("tree", GRAPHS)
def test_folders_are_not_full(tree: str) -> None:
    """Counts Python and C files."""
    counts = Counter(file.parent for file in GRAPHS[tree][2] if file.name != "__init__.py")
    assert not {str(folder.relative_to(ROOT)): n for folder, n in counts.items() if n > FILES}
