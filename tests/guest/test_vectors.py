"""The replay of reference data, for both engines."""

import pytest

from tmap import __main__
from tmap.base.errors import UserError
from tmap.base.paths import ROOT
from tmap.guest import emulator
from tmap.vectors import vector_file, vectors
from tmap.vectors.glide_text import GlideLines
from tmap.vectors.n64_text import TILE_BITS, N64Lines
from tmap.vectors.vector_text import Line

FILE = ROOT / "tests" / "vectors" / "tx_copy.txt.gz"


#: An 8-bit intensity from memory that is 0, as the unit's own colour; with perspective.
INTENSITY = "regs {mode} 0 0 0\npix 0 0 1 0 0 0 = {argb}\n"
PLAIN, PERSPECTIVE = "8241300", "8241301"


def test_the_command_counts_and_tells_by_its_status(tmp_path, capsys) -> None:
    """Files for both engines in one call: status 1 for one bad file, at least one line for each."""
    good, bad, unit = tmp_path / "good.txt", tmp_path / "bad.txt", tmp_path / "unit.txt"
    good.write_text("persp 1 1 32767 = 0 0 1 1\n")
    bad.write_text("persp 1 1 32767 = 0 0 1 1\n" + "persp 1 1 32767 = 0 0 2 1\n" * 7)
    unit.write_text(INTENSITY.format(mode=PLAIN, argb="ff000000") * 2
                    + INTENSITY.format(mode=PERSPECTIVE, argb="ff000000"))
    assert __main__.main(["vectors", str(good), str(unit)]) == 0
    assert capsys.readouterr().out == (
        f"{good}: 1 right, 0 wrong\n{unit}: 3 right, 0 wrong; without perspective 2 right, "
        "0 wrong; with perspective 1 right, 0 wrong\n")
    unit.write_text(INTENSITY.format(mode=PLAIN, argb="ff0100ab"))
    assert __main__.main(["vectors", str(good), str(bad), str(unit)]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[:2] == [f"{good}: 1 right, 0 wrong", f"{bad}: 1 right, 7 wrong"]
    assert lines[2].startswith("  line 2: persp 1 1 32767: expected ")
    assert lines[2 + vectors.SHOWN] == "  and 2 more"
    assert lines[3 + vectors.SHOWN:] == [
        f"{unit}: 0 right, 1 wrong; without perspective 0 right, 1 wrong; with perspective "
        "0 right, 0 wrong", "  line 2: pix 0 0 1 0 0 0: expected ff0100ab, found ff000000"]


PLAIN_KIND, DEEP_KIND = "without perspective", "with perspective"


@pytest.mark.parametrize(("engine", "kinds", "wrong", "passes"), [
    (N64Lines, {"exact": 1000}, {}, True),
    (N64Lines, {"exact": 1000}, {"exact": 1}, False),
    (GlideLines, {PLAIN_KIND: 500}, {PLAIN_KIND: 1}, True),
    (GlideLines, {PLAIN_KIND: 999}, {PLAIN_KIND: 2}, False),
    (GlideLines, {PLAIN_KIND: 500, DEEP_KIND: 600}, {DEEP_KIND: 3}, True),
    (GlideLines, {PLAIN_KIND: 500, DEEP_KIND: 600}, {DEEP_KIND: 4}, False),
])
def test_how_many_may_be_wrong(engine, kinds: dict, wrong: dict, passes: bool) -> None:
    """Each kind of question has its own rule."""
    line = Line(1, "pix", (), ())
    file = vectors.File(FILE, engine.ALLOWED,
                        [(kind, line) for kind, count in kinds.items() for _ in range(count)],
                        [(kind, line, ()) for kind, count in wrong.items() for _ in range(count)])
    assert file.passes() == passes


@pytest.mark.parametrize(("text", "line", "words"), [
    ("tmemhash = 0\nsing 1 2\n", 2, "there is no command 'sing'"),
    ("sample 0 1 2 = 0 0 0 0\n", 1, "4 arguments expected, 3 found"),
    ("sample 0 1 2 0\n", 1, "an answer of 4 numbers expected, 0 found"),
    ("fetch 0 1 x = 0 0 0 0\n", 1, "'x' is not a decimal number"),
    ("tmemhash = 0\nmode sample_tape 1\n", 2, "'sample_tape'"),
    ("mode sample_type 2\ntmemhash = 0\n", 1, "sample_type: 2 is not within 0 to 1"),
    ("tile 8 0 2 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n", 1, "n: 8 is not within 0 to 7"),
    ("tile 0 0 2 1 512 0 0 0 0 0 0 0 0 0 0 0 0 0\n", 1, "tmem: 512 is not within 0 to 511"),
    ("tmem fff 1 2\n", 1, "2 bytes from fff on are not within 1000 bytes"),
    ("rdram fffffe 1\n", 1, "not within 100000 bytes"),
    ("tmem 0 100\n", 1, "a byte: 256 is not within 0 to 255"),
    ("tmemrand 99999999999\n", 1, "does not fit into 32 bits"),
    ("regs 0 0 0 0\npersp 1 1 1 = 0 0 1 1\n", 2, "persp: the lines before are for another engine"),
    ("regs 600 0 0 0\n", 1, "regs: textureMode: there is no format 6"),
    ("regs 18000 0 0 0\n", 1, "regs: textureMode: rgb: there is no factor 6"),
    ("regs 3800000 0 0 0\n", 1, "regs: textureMode: alpha: there is no factor 7"),
    ("regs 0 800000 0 0\n", 1, "regs: tLOD: the bits 800000 stand for nothing"),
    ("regs 0 0 20000 0\n", 1, "regs: tDetail: the bits 20000 stand for nothing"),
    ("regs 0 0 0 20000000\n", 1, "regs: texBaseAddr: the bits 20000000 stand for nothing"),
    ("regs 0 0 0 100000000\n", 1, "regs: texBaseAddr: 100000000 does not fit into 32 bits"),
    ("grad 1 2 3\n", 1, "4 arguments expected, 3 found"),
    ("grad 1 2 3 4294967296\n", 1, "grad: 4294967296 does not fit into 32 bits"),
    ("pix 0 0 0 0 0 0\n", 1, "an answer of 1 numbers expected, 0 found"),
])
def test_bad_lines(text: str, line: int, words: str, tmp_path) -> None:
    """The error is one line that names file and line; nothing is run."""
    path = tmp_path / "bad.txt"
    path.write_text(text)
    with pytest.raises(UserError) as error:
        vectors.check([path])
    assert str(error.value).startswith(f"{path}:{line}: ") and words in str(error.value)
    assert "\n" not in str(error.value)


def test_bad_files(tmp_path, capsys) -> None:
    """Truncated, missing, without a question: one line each, status 2."""
    cut, empty = tmp_path / "cut.txt.gz", tmp_path / "empty.txt"
    cut.write_bytes(FILE.read_bytes()[:5000])
    empty.write_text("# nothing\ntmemrand 1\n")
    for path, words in ((cut, "end-of-stream"), (empty, "asks nothing"),
                        (tmp_path / "none.txt", "No such file")):
        assert __main__.main(["vectors", str(FILE), str(path)]) == 2
        out, err = capsys.readouterr()
        assert out == "" and err.startswith(f"tmap: {path}: ") and words in err
        assert err.count("\n") == 1


#: What the fields of a tile must be less than.
TILE_LIMITS = [1 << bits for bits in TILE_BITS.values()]


def operations(*longs: int, count: int = 1) -> bytes:
    """A file of questions from raw longs, with the right checksum."""
    made = vector_file.Operations()
    made.longs, made.count = list(longs), count
    return made.file()


def test_the_program_refuses_bad_files() -> None:
    """One line and return code 10 for each; nothing is run."""
    good = vector_file.Operations()
    good.add("HASH")
    codes = good.codes
    mode, tmem, fetch, call, glide_pixel, glide_call, tile, decode, bytes_of, level, logarithm, end = (
        codes[f"VECTOR_{name}"] << 16 for name in (
            "MODE", "TMEM", "FETCH", "CALL", "GLIDE_PIXEL", "GLIDE_CALL", "TILE", "DECODE", "GLIDE_BYTES_OF",
            "GLIDE_SUM", "GLIDE_LOGARITHM", "CODES"))
    files = {
        "is empty": [b""],
        "size": [good.file()[:20], good.file()[:-4], good.file() + bytes(4)],
        "magic": [b"TCEV" + good.file()[4:]],
        "version": [good.file()[:4] + bytes(4) + good.file()[8:]],
        "checksum": [good.file()[:-1] + b"\1"],
        "operation 0": [operations(end), operations(fetch | 2, 0, 0), operations(fetch | 3, 0, 0),
                        operations(mode | 2, 12, 0), operations(mode | 2, 1 << 31, 0),
                        operations(tmem | 0), operations(tmem | 2, 4096, 0),
                        operations(tmem | 2, 0xFFFFFFFF, 0), operations(call | 1, 8),
                        operations(glide_pixel | 5, 0, 0, 0, 0, 0), operations(glide_call | 0),
                        # Values that no routine is made for; the last three were worked on for hours, or for ever.
                        operations(mode | 2, 0, 4), operations(mode | 2, 1, 2),
                        *(operations(tile | 18, *(most * (n == field) for n, most in enumerate(TILE_LIMITS)))
                          for field in range(18)),
                        operations(decode | 2, 0, 3), operations(bytes_of | 2, 0, 0x10001),
                        operations(bytes_of | 2, 0, 0xFFFFFFFF), operations(level | 1, 0x80000000),
                        operations(logarithm | 2, 0, 0)],
        "operation 1": [operations(fetch | 3, 0, 0, 0, count=2)],
    }
    cases = [(words, data) for words, several in files.items() for data in several]
    with emulator.workspace() as folder:
        results = emulator.run_batch([f"vectors q{n} a{n}" for n in range(len(cases))],
                                    {f"q{n}": data for n, (_, data) in enumerate(cases)},
                                    "a1200-fast", folder, timed=False)
        for n, ((words, _), done) in enumerate(zip(cases, results)):
            assert done.code == 10, (n, words, done.output)
            assert done.output.count("\n") == 1 and done.output.startswith(f"q{n}: "), done.output
            assert done.output.endswith(f"{words}\n"), (n, words, done.output)
            assert not (done.directory / f"a{n}").exists()
