"""Two trees at different paths make the same programs, disk and kit, byte for byte."""

import shutil
import subprocess
from pathlib import Path

import pytest

from tmap.base.paths import PROGRAMS, ROOT

#: What is made anew in the other tree, one of each rule of the Makefile: everything after it is too.
MADE = ("gen/n64_weights.s", "obj/asm/span/affine_swap.o", "obj/asm/gen/n64_weights.o", "obj/gcc/drawing/lower.o",
        "obj/gcc/system/text.o", "obj/gcc/programs/render.o")


@pytest.fixture(scope="module")
def other(tmp_path_factory) -> Path:
    """A second tree with what is built, without MADE, at a longer path."""
    tree = tmp_path_factory.mktemp("a folder") / "with a blank" / "tree"
    kept = shutil.ignore_patterns(".git", ".deps", ".pytest_cache", "__pycache__", "accuracy", "bench", "run",
                                  "profile", "failed", "report", "tmp")
    shutil.copytree(ROOT, tree, ignore=lambda folder, names: kept(folder, names)
                    if folder in (str(ROOT), str(ROOT / "build")) else set(), symlinks=True)
    (tree / ".deps").symlink_to(ROOT / ".deps")
    (tree / ".git").write_text(f"gitdir: {ROOT}/.git\n")  # files on the disk have the commit's date
    for name in MADE:
        (tree / "build" / name).unlink()
    subprocess.run(["make", "programs"], cwd=tree, check=True, stdout=subprocess.DEVNULL)
    return tree


def test_programs_are_the_same(other: Path) -> None:
    for name in MADE:
        assert (other / "build" / name).read_bytes() == (ROOT / "build" / name).read_bytes(), name
    programs = sorted(path.name for path in PROGRAMS.iterdir())
    assert programs == sorted(path.name for path in (other / "build" / "programs").iterdir())
    for name in programs:
        made = (other / "build" / "programs" / name).read_bytes()
        assert made == (PROGRAMS / name).read_bytes(), name
        assert str(ROOT).encode() not in made and str(other).encode() not in made, name


@pytest.mark.parametrize("product, name", [("adf", "disk.adf"), ("sdk", "kit")])
def test_products_are_the_same(other: Path, tmp_path, product: str, name: str) -> None:
    found = []
    for tree in (ROOT, other):
        place = tmp_path / str(len(found))
        place.mkdir()
        subprocess.run([tree / "scripts" / "tmap", product, "-o", place / name], check=True, stdout=subprocess.DEVNULL)
        found.append({path.relative_to(place).as_posix(): path.read_bytes()
                      for path in place.rglob("*") if path.is_file()})
    first, second = found
    assert first.keys() == second.keys() and len(first) > 0
    wrong = [path for path in first if first[path] != second[path]]
    assert not wrong, wrong
