"""Glide's texture unit on the emulated machine compared with reference data."""

import gzip
from pathlib import Path

import pytest

from tmap.base.paths import ROOT
from tmap.vectors import vectors

FILES = sorted((ROOT / "tests" / "vectors").glob("tmu*.txt.gz"))
QUESTIONS = 1000  # in each file
SHORT = 304  # lines of a file with a hundred questions
#: What the data do not ask: with all gradients 0 the level is the least one, whatever the bias;
#: with w = 0 the last one. White is multiplied by one more than the level's fraction, in 1/256.
EXAMPLES = """\
regs 06834000 00101800 00000000 0
grad 1048576 0 0 0
pix 0 0 1073741824 ffffffff 0 0 = 40404040
grad 0 0 0 0
pix 0 0 1073741824 ffffffff 0 0 = 00000000
regs 06834001 00101800 00000000 0
grad 1048576 0 0 0
pix 0 0 536870912 ffffffff 0 0 = 40404040
pix 0 0 0 ffffffff 0 0 = 00000000
"""


@pytest.fixture(scope="module")
def checked(tmp_path_factory) -> dict[str, vectors.File]:
    """All files after one boot, by name, the examples, and two short ones: with a wrong answer, and
    with a name that implies the wrong weights."""
    folder = tmp_path_factory.mktemp("vectors")
    (folder / "examples.txt").write_text(EXAMPLES)
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


def test_what_the_data_do_not_ask(checked) -> None:
    assert not checked["examples.txt"].wrong, "\n".join(vectors.report(checked["examples.txt"]))


def test_a_wrong_answer_is_noticed(checked) -> None:
    """Only that answer is reported; tests/n64/test_vectors.py has the report's lines."""
    count, _ = vectors.report(checked["tmu2.txt"])
    assert ": 99 right, 1 wrong; " in count


def test_the_name_tells_how_wide_weights_are(checked) -> None:
    """Weights of 4 bits do not give the colours of those of 8."""
    file = checked["glide.txt"]
    assert len(file.questions) == 100 and len(file.wrong) > 20 and not file.passes()


def test_programs_carry_what_they_call() -> None:
    """The linker leaves out unused routines."""
    maps = {name: (ROOT / "build" / "programs" / f"{name}.map").read_text()
            for name in ("vectors", "render", "bench")}
    assert "glide_pixel" in maps["vectors"] and "glide_pixel" in maps["render"]
    assert "glide_pixel" not in maps["bench"], "bench has passes alone"
    for call in ("glide_download_rows", "glide_registers_of"):
        assert call in maps["vectors"] and call not in maps["render"], call
