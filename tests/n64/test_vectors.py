"""The texture engine on the emulated machine compared with reference data, number by number."""

import gzip
from pathlib import Path

import pytest

from tmap.base.paths import ROOT
from tmap.vectors import n64_text, vectors

FILES = sorted((ROOT / "tests" / "vectors").glob("tx_*.txt.gz"))
QUESTIONS = 1000  # in each file


@pytest.fixture(scope="module")
def checked(tmp_path_factory) -> dict[str, vectors.File]:
    """All files after one boot, by name, and a copy with a wrong answer, uncompressed."""
    folder = tmp_path_factory.mktemp("vectors")
    lines = gzip.decompress(FILES[0].read_bytes()).decode().splitlines()
    place = [n for n, line in enumerate(lines) if line.startswith("copy")][3]
    question, _, answer = lines[place].partition(" = ")
    lines[place] = f"{question} = {int(answer.split()[0], 16) ^ 1:08x} {answer.split()[1]}"
    (folder / "wrong.txt").write_text("\n".join(lines) + "\n")
    return {file.path.name: file for file in vectors.check([*FILES, folder / "wrong.txt"])}


def test_the_reference_data_is_there() -> None:
    """One file of each kind, for some kinds two."""
    assert [path.name.removesuffix(".txt.gz") for path in FILES] == [
        "tx_copy", "tx_copy_any", "tx_load", "tx_load_any", "tx_lod2", "tx_persp", "tx_sample",
        "tx_sample_any", "tx_yuv"]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_every_answer_is_exact(path: Path, checked) -> None:
    file = checked[path.name]
    assert len(file.questions) == QUESTIONS
    assert not file.wrong, "\n".join([*vectors.report(file), f"again: scripts/tmap vectors {path}"])


def test_a_wrong_answer_is_noticed(checked) -> None:
    """Only that answer is reported, with its line, the question, the expected and the found
    numbers; uncompressed files work."""
    file = checked["wrong.txt"]
    right = {line.number: line for line in n64_text.read(FILES[0])}
    (_, line, found), = file.wrong
    assert found[1:] == tuple(v - (1 << 32) if v >> 31 else v
                              for v in right[line.number].expected[1:])
    count, shown = vectors.report(file)
    assert count.endswith("wrong.txt: 999 right, 1 wrong")
    assert shown == (f"  line {line.number}: {vectors.asked(line)}: expected "
                     f"{line.expected[0]:08x} {line.expected[1]:08x}, found "
                     f"{right[line.number].expected[0]:08x} {line.expected[1]:08x}")
