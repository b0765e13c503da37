"""Glide's texture unit on the emulated machine compared with reference data."""

import gzip
from pathlib import Path

import pytest

from tmap.base.paths import ROOT
from tmap.vectors import vectors
from tmap.vectors.glide_text import read

FILES = sorted((ROOT / "tests" / "vectors").glob("tmu*.txt.gz"))
QUESTIONS = 1000  # in each file
SHORT = 304  # lines of a file with a hundred questions


@pytest.fixture(scope="module")
def checked(tmp_path_factory) -> dict[str, vectors.File]:
    """All files after one boot, by name, and two short ones: with a wrong answer, and with a name
    that implies the wrong weights."""
    folder = tmp_path_factory.mktemp("vectors")
    lines = gzip.decompress(FILES[0].read_bytes()).decode().splitlines()[:SHORT]
    (folder / "glide.txt").write_text("\n".join(lines) + "\n")
    place = [n for n, line in enumerate(lines) if line.startswith("pix")][3]
    question, _, answer = lines[place].partition(" = ")
    lines[place] = f"{question} = {int(answer, 16) ^ 0x100:08x}"
    (folder / "tmu2.txt").write_text("\n".join(lines) + "\n")
    paths = [*FILES, *sorted(folder.glob("*.txt"))]
    return {file.path.name: file for file in vectors.check(paths)}


def test_the_reference_data_is_there() -> None:
    """One file of Voodoo 2, three kinds of Voodoo."""
    assert [path.name.removesuffix(".txt.gz") for path in FILES] == [
        "tmu2_decal", "tmu_combine", "tmu_decal", "tmu_fixedlod"]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_every_answer_is_exact(path: Path, checked) -> None:
    """No answer differs, although some could."""
    file = checked[path.name]
    assert len(file.questions) == QUESTIONS
    assert min(file.count(kind)[0] for kind in file.allowed) > QUESTIONS // 3
    assert not file.wrong, "\n".join([*vectors.report(file), f"again: scripts/tmap vectors {path}"])


def test_a_wrong_answer_is_noticed(checked) -> None:
    """Only that answer is reported, with its line, the question, the expected and the found
    number."""
    file = checked["tmu2.txt"]
    right = {line.number: line for line in read(FILES[0])}
    (_, line, found), = file.wrong
    assert found[0] & 0xFFFFFFFF == right[line.number].expected[0]
    count, shown = vectors.report(file)
    assert ": 99 right, 1 wrong; " in count
    assert shown == (f"  line {line.number}: {vectors.asked(line)}: expected "
                     f"{line.expected[0]:08x}, found {right[line.number].expected[0]:08x}")


def test_the_name_tells_how_wide_weights_are(checked) -> None:
    """Weights of 4 bits do not give the colours of those of 8."""
    file = checked["glide.txt"]
    assert len(file.questions) == 100 and len(file.wrong) > 20 and not file.passes()
