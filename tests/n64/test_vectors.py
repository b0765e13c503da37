"""The texture engine on the emulated machine compared with reference data, number by number."""

import gzip
from pathlib import Path

import pytest

from tmap.base.paths import ROOT
from tmap.vectors import n64_text, vectors

FILES = sorted((ROOT / "tests" / "vectors").glob("tx_*.txt.gz"))
QUESTIONS = 1000  # in each file

#: Computed by hand.
EXAMPLES = """\
# RGBA 16, line 2: rows lie 16 bytes apart, odd ones have their halves swapped
tile 0 0 2 2 0 0 0 0 0 0 0 0 0 0 0 0 60 60
tmem 0 f8 01
tmem 14 07 c0
tmem 10 00 3f
tmem 12 84 21
fetch 0 0 0 = 0ff 000 000 0ff
fetch 0 0 1 = 000 0ff 000 000
fetch 0 2 1 = 000 000 0ff 0ff
fetch 0 3 1 = 084 084 084 0ff
# RGBA 32, line 1: red and green in the low half, blue and alpha in the high one
tile 1 0 3 1 32 0 0 0 0 0 0 0 0 0 0 0 4 0
tmem 102 12 34
tmem 902 56 78
fetch 1 1 0 = 012 034 056 078
# CI 4, palette 3, nibble 5: entry 0x35
tile 2 2 0 1 64 3 0 0 0 0 0 0 0 0 0 0 60 0
tmem 200 05
tmem 9a8 7c 1f 7c 1f 7c 1f 7c 1f
mode en_tlut 1
fetch 2 1 0 = 07b 084 07b 0ff
mode en_tlut 0
# I 8 from 0 to 255: a quarter of the way to the next texel; two thirds down the other triangle
tile 3 4 1 1 128 0 0 0 3 0 0 0 3 0 0 0 28 28
tmem 400 00 ff
tmem 40c 00 ff
mode sample_type 1
sample 3 8 0 0 = 040 040 040 040
sample 3 24 16 0 = 0bf 0bf 0bf 0bf
# the last texel is clamped to, unfiltered
tile 4 4 1 1 136 0 1 0 0 0 1 0 0 0 0 0 4 0
tmem 440 10 20 30
sample 4 30 0 0 = 01f 01f 01f 01f
sample 4 32 0 0 = 020 020 020 020
sample 4 2000 0 0 = 020 020 020 020
sample 4 -1 0 0 = 010 010 010 010
# the quotients' hardware rounding
persp 8225 0 23754 = 0 0 11345 0
persp 3270 0 28965 = 0 0 3699 0
persp 1 -1 0 = 0 0 32767 32767
"""


@pytest.fixture(scope="module")
def checked(tmp_path_factory) -> dict[str, vectors.File]:
    """All files after one boot, by name, including the examples and a copy with a wrong answer."""
    folder = tmp_path_factory.mktemp("vectors")
    (folder / "examples.txt").write_text(EXAMPLES)
    lines = gzip.decompress(FILES[0].read_bytes()).decode().splitlines()
    place = [n for n, line in enumerate(lines) if line.startswith("copy")][3]
    question, _, answer = lines[place].partition(" = ")
    lines[place] = f"{question} = {int(answer.split()[0], 16) ^ 1:08x} {answer.split()[1]}"
    (folder / "wrong.txt").write_text("\n".join(lines) + "\n")
    (folder / "plain.txt").write_bytes(gzip.decompress(FILES[0].read_bytes()))
    paths = [*FILES, *sorted(folder.glob("*.txt"))]
    return {file.path.name: file for file in vectors.check(paths)}


def test_the_reference_data_is_there() -> None:
    """One file of each kind, for some kinds two."""
    assert [path.name.removesuffix(".txt.gz") for path in FILES] == [
        "tx_copy", "tx_copy_any", "tx_load", "tx_load_any", "tx_lod2", "tx_persp", "tx_sample",
        "tx_sample_any", "tx_yuv"]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_every_answer_is_exact(path: Path, checked) -> None:
    """No compared number differs."""
    file = checked[path.name]
    assert len(file.questions) == QUESTIONS
    assert not file.wrong, "\n".join([*vectors.report(file), f"again: scripts/tmap vectors {path}"])


def test_examples_worked_out_by_hand(checked) -> None:
    """Addresses, formats, filter, clamp, divide."""
    assert not checked["examples.txt"].wrong, "\n".join(vectors.report(checked["examples.txt"]))


def test_a_wrong_answer_is_noticed(checked) -> None:
    """Only that answer is reported, with its line, the question, the expected and the found
    numbers; uncompressed files work."""
    assert not checked["plain.txt"].wrong
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
