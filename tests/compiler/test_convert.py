"""Pictures as maps and back, through the command line."""

import json
import re
import subprocess

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import main
from tmap.base import maps
from tmap.base.paths import ROOT


def there_and_back(tmp_path, image: Image.Image, *options: str) -> Image.Image:
    """Converts a picture to a map and back; returns the result."""
    image.save(tmp_path / "in.png")
    assert main(["map", str(tmp_path / "in.png"), "-o", str(tmp_path / "a.map"), *options]) == 0
    assert main(["picture", str(tmp_path / "a.map"), "-o", str(tmp_path / "out.png")]) == 0
    return Image.open(tmp_path / "out.png")


@pytest.mark.parametrize("layout, size", [("linear", (100, 37)), ("linear", (1, 1)),
                                          ("tiled", (256, 256)), ("columns", (512, 8)),
                                          ("columns", (16, 128))])
def test_palette_pictures_come_back(tmp_path, layout: str, size: tuple[int, int]) -> None:
    """Indices and palette come back exactly; the file has the bytes of the layout."""
    rng = np.random.default_rng([8, *size])
    pixels = rng.integers(0, 256, size[::-1], dtype=np.uint8)
    image = Image.fromarray(pixels, "P")
    palette = rng.integers(0, 256, (256, 3), dtype=np.uint8)
    image.putpalette(palette.tobytes())
    back = there_and_back(tmp_path, image, "--layout", layout)
    assert back.mode == "P" and np.array_equal(np.array(back), pixels)
    assert np.array_equal(np.array(back.convert("RGB")), palette[pixels])
    stored = np.fromfile(tmp_path / "a.map", np.uint8)
    if layout == "tiled":
        assert stored[2048 * 3 + 8 * 77 + 5] == pixels[77, 29]
    if layout == "columns":
        assert stored[4 * size[1] * 2 + 4 * 7 + 1] == pixels[7, 9]


def test_colours_come_back(tmp_path) -> None:
    """RGB pictures of 256 colours, and every colour of the other formats, alpha too."""
    rng = np.random.default_rng(8)
    few = rng.integers(0, 256, (200, 3), dtype=np.uint8)[rng.integers(0, 200, (8, 24))]
    assert np.array_equal(np.array(there_and_back(tmp_path, Image.fromarray(few)).convert("RGB")), few)
    every = maps.from_rgb565(np.arange(65536).reshape(256, 256))
    back = there_and_back(tmp_path, Image.fromarray(every), "--format", "rgb565",
                          "--layout", "tiled")
    assert np.array_equal(np.array(back), every)
    every = maps.from_rgba5551(np.arange(65536).reshape(256, 256))
    back = there_and_back(tmp_path, Image.fromarray(every), "--format", "rgba5551")
    assert np.array_equal(np.array(back), every)
    some = rng.integers(0, 256, (64, 32, 4), dtype=np.uint8)
    back = there_and_back(tmp_path, Image.fromarray(some), "--format", "rgba8888",
                          "--layout", "columns")
    assert np.array_equal(np.array(back), some)
    assert (tmp_path / "a.map").read_bytes()[:16] == some[0, :4].tobytes()


def test_bad_input_is_one_line(tmp_path, capsys) -> None:
    """Wrong sizes, missing and damaged files: status 2, nothing written."""
    Image.new("RGB", (100, 37)).save(tmp_path / "in.png")
    (tmp_path / "bad.png").write_bytes(b"no picture")
    Image.new("P", (8, 8)).save(tmp_path / "gif.png", "GIF")  # has a palette, whatever its name
    out = str(tmp_path / "a.map")
    for arguments, said in (
            (["map", str(tmp_path / "in.png"), "-o", out, "--layout", "tiled"], "100x37 texels"),
            (["map", str(tmp_path / "none.png"), "-o", out], "no such file"),
            (["map", str(tmp_path / "bad.png"), "-o", out], "not a usable PNG or JPEG"),
            (["map", str(tmp_path / "gif.png"), "-o", out], "not a usable PNG or JPEG"),
            (["picture", out, "-o", str(tmp_path / "b.png")], "No such file")):
        assert main(arguments) == 2
        error = capsys.readouterr().err
        assert said in error and error.count("\n") == 1
    assert not list(tmp_path.glob("a.map*"))
    assert main(["map", str(tmp_path / "in.png"), "-o", out]) == 0
    good = json.loads((tmp_path / "a.map.json").read_text())
    for about in ({"width": 3}, *(good | wrong for wrong in (
            {"palette": [[300, 0, 0]]}, {"width": float("inf")}, {"palette": [[0, 0, 0]] * 257},
            {"layout": "tiled"}))):
        (tmp_path / "a.map.json").write_text(json.dumps(about))
        assert main(["picture", out, "-o", str(tmp_path / "b.png")]) == 2
        assert "a.map.json: " in capsys.readouterr().err
    assert not (tmp_path / "b.png").exists()


def test_light_table_of_a_picture(tmp_path) -> None:
    """Level 63 is the palette itself, level 0 the entry nearest to black, or to another colour."""
    colours = [(0, 0, 0), (255, 255, 255), (128, 128, 128), (64, 80, 96)]
    Image.fromarray(np.array([colours], np.uint8)).save(tmp_path / "in.png")
    for towards, darkest in ((), (0, 0, 0)), (("--towards", "#405060"), (64, 80, 96)):
        out = tmp_path / "a.light"
        assert main(["light", str(tmp_path / "in.png"), "-o", str(out), *towards]) == 0
        palette = json.loads((tmp_path / "a.light.json").read_text())["palette"]
        table = np.fromfile(out, np.uint8).reshape(64, 256)
        assert table[63].tolist() == list(range(256))
        assert {tuple(palette[index]) for index in table[0].tolist()} == {darkest}


CUBE = """\
v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1
f 1/1 2/2 3/3 4/4
"""


@pytest.mark.parametrize("options, faces, corners", [((), 1, 4), (("--triangles",), 2, 6), (("--size", "0.5"), 1, 4)])
def test_model_becomes_tables_in_c(tmp_path, options, faces, corners) -> None:
    """A square: a C compiler takes the header, and its rows are those of the model."""
    (tmp_path / "square.obj").write_text(CUBE)
    out = tmp_path / "square.h"
    assert main(["mesh", str(tmp_path / "square.obj"), "-o", str(out), *options]) == 0
    subprocess.run(["m68k-linux-gnu-gcc", "-std=c99", "-Wall", "-Wno-unused", "-Werror", "-fsyntax-only", "-I", ROOT / "c",
                    "-x", "c", out], check=True)
    rows = {name: [[int(n) for n in row.split(",")] for row in re.findall(r"\{([-\d, ]+)\}", body)]
            for name, body in re.findall(r"square_(\w+)\[\] = \{(.*?)\n\};", out.read_text(), re.S)}
    side = 32768 if "0.5" in options else 65536
    assert sorted(rows["points"]) == sorted([x, y, side] for x in (-side, side) for y in (-side, side))
    assert len(rows["faces"]) == faces and len(rows["corners"]) == corners
    for point, _, s, t in rows["corners"]:  # t downwards
        x, y, _ = rows["points"][point]
        assert (s, t) == ((x > 0) * 256 << 16, (y < 0) * 256 << 16)


@pytest.mark.parametrize("words, said", [
    (("mesh", "none.obj", "-o", "x.h"), "none.obj: no such file"),
    (("mesh", "bad.obj", "-o", "x.h"), "bad.obj: line 1: "),
    (("mesh", "square.obj", "-o", "1.h"), "must begin with a letter"),
    (("light", "bad.obj", "-o", "x"), "bad.obj: not a usable PNG"),
    (("light", "in.png", "-o", "x", "--towards", "red"), "--towards: 'red' is not a colour")])
def test_bad_models_and_pictures_are_one_line(tmp_path, capsys, monkeypatch, words, said) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bad.obj").write_text("v x\n")
    (tmp_path / "square.obj").write_text(CUBE)
    Image.new("RGB", (4, 4)).save(tmp_path / "in.png")
    assert main(list(words)) == 2
    message = capsys.readouterr().err
    assert message.count("\n") == 1 and said in message
    assert not (tmp_path / words[3]).exists()
