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


def several(tmp_path, *options: str) -> tuple[list[np.ndarray], np.ndarray]:
    """Converts a.png and b.png to maps in one folder. Returns what they show, uint8 [row][x][channel], and their
    palette."""
    pictures, folder = [str(tmp_path / f"{name}.png") for name in "ab"], tmp_path / "maps"
    assert main(["map", *pictures, "-o", str(folder), *options]) == 0
    assert sorted(path.name for path in folder.iterdir()) == ["a.map", "a.map.json", "b.map", "b.map.json", "palette"]
    entries = np.fromfile(folder / "palette", np.uint8).reshape(256, 4)
    assert not entries[:, 0].any()
    shown = []
    for name in "ab":
        about = json.loads((folder / f"{name}.map.json").read_text())
        assert about["palette"] == entries[:, 1:].tolist()
        assert main(["picture", str(folder / f"{name}.map"), "-o", str(tmp_path / "out.png")]) == 0
        shown.append(np.array(Image.open(tmp_path / "out.png").convert("RGB")))
    return shown, entries[:, 1:]


def test_several_pictures_share_a_palette(tmp_path) -> None:
    """Colours that fit in one palette come back exactly, in pictures with palettes of their own too; equal
    palettes stay."""
    rng = np.random.default_rng(28)
    colours = rng.permutation(np.unique(rng.integers(0, 256, (240, 3), dtype=np.uint8), axis=0))
    first, second = colours[rng.integers(0, 120, (8, 24))], colours[rng.integers(80, len(colours), (100, 37))]
    Image.fromarray(first).save(tmp_path / "a.png")
    Image.fromarray(second).convert("P", palette=Image.Palette.ADAPTIVE, colors=256).save(tmp_path / "b.png")
    second = np.array(Image.open(tmp_path / "b.png").convert("RGB"))
    (found, other), _ = several(tmp_path)
    assert np.array_equal(found, first) and np.array_equal(other, second)
    indices = rng.integers(0, 256, (2, 16, 16), dtype=np.uint8)
    for name, texels in zip("ab", indices):
        image = Image.fromarray(texels, "P")
        image.putpalette(np.arange(768).astype(np.uint8).tobytes())
        image.save(tmp_path / f"{name}.png")
    several(tmp_path)
    assert [(tmp_path / "maps" / f"{name}.map").read_bytes() for name in "ab"] == [each.tobytes() for each in indices]


@pytest.mark.parametrize("most", [1, 16, 100, 256])
def test_shared_palette_keeps_its_number(tmp_path, most) -> None:
    """More colours are reduced to so many, the rest is black; each pixel has the nearest of them, in both pictures."""
    rng = np.random.default_rng(29)
    pictures = [rng.integers(0, 256, (64, 32, 3), dtype=np.uint8), rng.integers(0, 99, (16, 128, 3), dtype=np.uint8)]
    for name, pixels in zip("ab", pictures):
        Image.fromarray(pixels).save(tmp_path / f"{name}.png")
    shown, palette = several(tmp_path, "--colours", str(most), "--layout", "columns")
    assert not palette[most:].any() and len(np.unique(palette[:most], axis=0)) > most * 3 // 4
    for found, pixels in zip(shown, pictures):
        off = ((found.astype(int) - pixels) ** 2).sum(axis=-1)
        every = ((palette[:most].astype(int) - pixels[..., None, :]) ** 2).sum(axis=-1)
        assert np.array_equal(off, every.min(axis=-1))


def test_several_maps_of_other_formats(tmp_path) -> None:
    """They have no palette."""
    every = maps.from_rgb565(np.arange(65536).reshape(256, 256))
    for name in "ab":
        Image.fromarray(every).save(tmp_path / f"{name}.png")
    assert main(["map", *(str(tmp_path / f"{name}.png") for name in "ab"), "-o", str(tmp_path / "maps"), "--format",
                 "rgb565"]) == 0
    assert sorted(path.name for path in (tmp_path / "maps").iterdir()) == ["a.map", "a.map.json", "b.map", "b.map.json"]
    assert (tmp_path / "maps" / "b.map").read_bytes() == np.arange(65536, dtype=">u2").tobytes()


@pytest.mark.parametrize("words, said", [
    (("a.png", "none.png", "-o", "maps"), "none.png: no such file"),
    (("a.png", "bad.png", "-o", "maps"), "bad.png: not a usable PNG or JPEG"),
    (("a.png", "odd.png", "-o", "maps", "--layout", "columns"), "odd.png: 100x37 texels; layout columns needs "),
    (("a.png", "more/A.jpg", "-o", "maps"), "more/A.jpg: its map would have the name of a.png's"),
    (("a.png", "odd.png", "-o", "bad.png"), "bad.png: is not a directory"),
    (("a.png", "odd.png", "-o", "maps", "--colours", "257"), "--colours: 257; a palette has 1 to 256"),
    (("a.png", "odd.png", "-o", "maps", "--colours", "0"), "--colours: 0; a palette has 1 to 256"),
    (("a.png", "-o", "maps", "--colours", "9", "--format", "rgb565"),
     "--colours: texels in format rgb565 have no palette"),
    (("-o", "maps"), "PICTURE")])
def test_bad_pictures_among_several_are_one_line(tmp_path, capsys, monkeypatch, words, said) -> None:
    """Nothing is written, and no folder made."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "more").mkdir()
    Image.new("RGB", (8, 8)).save("a.png")
    Image.new("RGB", (8, 8)).save("more/A.jpg")
    Image.new("RGB", (100, 37)).save("odd.png")
    (tmp_path / "bad.png").write_bytes(b"no picture")
    before = sorted(tmp_path.rglob("*"))
    assert main(["map", *words]) == 2
    message = capsys.readouterr().err
    assert message.count("\n") == 1 and said in message
    assert sorted(tmp_path.rglob("*")) == before


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


@pytest.mark.parametrize("colours, warns", [
    ([(200, 30, 30), (30, 200, 30), (240, 240, 240)], True),            # with black, one or two shades of each
    ([(shade, shade, shade) for shade in range(256)], False),
    ([(250, 0, 0), (188, 0, 0), (125, 0, 0), (63, 0, 0), (0, 0, 0)], False),    # two of the five have fewer than five
    ([(9, 9, 9), (12, 0, 0), (0, 30, 40)], False)])                     # all are near black
def test_light_of_few_colours_warns_on_one_line(tmp_path, capsys, colours, warns) -> None:
    Image.fromarray(np.array([colours], np.uint8)).save(tmp_path / "in.png")
    assert main(["light", str(tmp_path / "in.png"), "-o", str(tmp_path / "a.light")]) == 0
    said = capsys.readouterr().err
    assert said.count("\n") == warns and ("warning" in said) == warns


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
