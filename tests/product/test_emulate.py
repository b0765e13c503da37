"""``tmap emulate``: output, return codes, files and pictures of programs that are not the project's; crashes, hangs."""

import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import main
from tmap.base.errors import UserError
from tmap.base.paths import ROOT
from tmap.product import emulate, sdk

HEIGHT, WIDTH = 128, 160  # of the example's pictures
#: Programs by name. `broken` lies behind another routine, whose name must not be said.
SOURCES = {
    "speak": """
start:  move.l  a0,d2
        move.l  d0,d3
        movea.l 4.w,a6
        lea     dos(pc),a1
        moveq   #36,d0
        jsr     -552(a6)
        movea.l d0,a6
        jsr     -60(a6)
        move.l  d0,d1
        jsr     -48(a6)
        moveq   #5,d0
        rts
dos     dc.b    'dos.library',0
""",
    "crash": """
start:  bsr     first
        rts
first:  bsr     broken
        rts
broken: moveq   #7,d3
        illegal
        rts
""",
    "wild": """
start:  movea.l #$f00001,a0
        jmp     (a0)
""",
    "hang": """
start:  bra     spin
first:  rts
spin:   bra     spin
"""}


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """The sources above as ELF programs, linked with the SDK's script."""
    folder = tmp_path_factory.mktemp("programs")
    for name, source in SOURCES.items():
        text, made = folder / f"{name}.s", folder / f"{name}.o"
        names = [line.split(":")[0] for line in source.splitlines() if line[:1].strip() and ":" in line]
        text.write_text(f"        xdef    {','.join(names)}\n        section .text,code\n" + source)
        subprocess.run([ROOT / "scripts" / "vasm", "-quiet", "-m68020", "-Felf", "-o", made, text], check=True)
        (folder / "start.o").unlink(missing_ok=True)
        made.rename(folder / "start.o")  # the script puts it first
        subprocess.run(["m68k-linux-gnu-ld", "-q", "-z", "noexecstack", "-T", sdk.FILES / "amiga.ld",
                        "-o", folder / f"{name}.elf", "start.o"], check=True, cwd=folder)
    return folder


@pytest.fixture(scope="module")
def example(tmp_path_factory):
    """The SDK's example, as a hunk file."""
    kit = tmp_path_factory.mktemp("made") / "sdk"
    sdk.make(kit)
    subprocess.run(["make", "-s", "-C", kit / "example", "TOOLS=elf", f"PYTHON={sys.executable}",
                    f"VASM={ROOT / 'scripts' / 'vasm'}", "elf/example"], check=True, capture_output=True)
    return kit / "example" / "elf" / "example"


def test_output_arguments_and_return_code(programs, tmp_path, capfd):
    code = main(["emulate", "-o", str(tmp_path), str(programs / "speak.elf"), "a", "-o", 'two "words"; here', "*"])
    assert code == 5
    assert capfd.readouterr().out == 'a -o "two *"words*"; here" "**"\n'
    assert not list(tmp_path.iterdir())


def test_files_and_pictures(example, tmp_path, capfd):
    palette = tmp_path / "palette.png"
    colours = np.arange(768, dtype=np.uint32).astype(np.uint8)
    image = Image.new("P", (1, 1))
    image.putpalette(colours.tobytes())
    image.save(palette)
    out = tmp_path / "out"
    assert main(["emulate", "-o", str(out), "--picture", f"{WIDTH}x{HEIGHT}", "--palette", str(palette),
                 str(example)]) == 0
    names = {path.name for path in out.iterdir()}
    assert names == {f"frame_{n}.chunky{end}" for n in range(4) for end in ("", ".png")}
    dump = np.fromfile(out / "frame_2.chunky", np.uint8).reshape(HEIGHT, WIDTH)
    with Image.open(out / "frame_2.chunky.png") as picture:
        assert (np.array(picture) == dump).all() and len(np.unique(dump)) > 100
        assert picture.getpalette("RGB") == colours.tolist()
    assert capfd.readouterr().err.count("bytes, and as a PNG") == 4


@pytest.mark.parametrize("name, says", [
    ("crash", "crash.elf crashed: exception 4 (illegal instruction) at PC $a, in broken+$2\n  d0-d7 "),
    ("wild", "wild.elf crashed: exception 3 (address error) at PC ")])
def test_crash_has_its_place(programs, tmp_path, capfd, name, says):
    assert main(["emulate", "-o", str(tmp_path), str(programs / f"{name}.elf")]) == 2
    found = capfd.readouterr()
    assert found.out == "" and found.err.startswith(f"tmap: {says}"), found


def test_hang_ends_by_the_limit(programs, tmp_path, capfd):
    assert main(["emulate", "-o", str(tmp_path), "--limit", "4", str(programs / "hang.elf")]) == 2
    assert capfd.readouterr().err == ("tmap: hang.elf: it did not end, 4 s of processor time after its last sign of "
                                      "life; it wrote nothing\n")


@pytest.mark.parametrize("words, says", [
    (["{}/none"], "{}/none: No such file or directory"),
    (["{}/speak.s"], "{}/speak.s: neither an Amiga program (hunk file) nor an ELF program"),
    (["{}/start.o"], "{}/start.o: cannot be made a hunk file: not a linked program for the 68000's family"),
    (["--picture", "320", "{}/speak.elf"], "emulate: argument --picture: invalid pair value: '320'; see tmap emulate "
                                           "--help"),
    (["--input", "{}/gone", "{}/speak.elf"], "{}/gone: No such file or directory"),
    (["--palette", "{}/speak.s", "{}/speak.elf"], "{}/speak.s: not a usable picture: "),
    (["{}/speak.elf", "a" * 400], "{}/speak.elf: 416 letters of arguments, more than 400")])
def test_bad_arguments_get_a_line(programs, tmp_path, capfd, words, says):
    assert main(["emulate", "-o", str(tmp_path / "out"), *(word.format(programs) for word in words)]) == 2
    err = capfd.readouterr().err
    assert err.startswith("tmap: " + says.format(programs)) and err.count("\n") == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("word, shell", [("plain.1", "plain.1"), ("", '""'), ("a b", '"a b"'), ('"', '"*""')])
def test_words_for_the_shell(word, shell):
    assert emulate.quoted(word) == shell


def test_palettes_of_maps(tmp_path) -> None:
    """What ``tmap map`` writes beside a map is a palette too; what is not has one line."""
    path = tmp_path / "wall.map.json"
    path.write_text('{"palette": [[1, 2, 3], [255, 0, 4]]}')
    assert emulate.colours(path).tolist() == [1, 2, 3, 255, 0, 4]
    for text in ("[1]", "{}", '{"palette": [[1, 256, 3]]}', '{"palette": 7'):
        path.write_text(text)
        with pytest.raises(UserError, match="wall.map.json: "):
            emulate.colours(path)
