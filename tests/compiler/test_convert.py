"""Pictures as maps and back, through the command line."""

import json

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import main
from tmap.base import maps


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
