"""Texture pictures and the palette they share."""

import zlib

import numpy as np
import pytest
from PIL import Image

from tmap.base.errors import UserError
from tmap.images import images, palette

WHERE = "scene.toml: textures.wall.image"


def refusal(folder, name) -> str:
    with pytest.raises(UserError) as caught:
        images.load(name, folder, WHERE)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def picture(folder, name):
    """Writes a picture of noise; returns its bytes."""
    Image.effect_noise((50, 30), 90).save(folder / name)
    return (folder / name).read_bytes()


@pytest.mark.parametrize("reference, message", [
    ("roof.png", "no such file"),
    (".", "no such file"),
    ("x" * 5000, "no such file"),
    ("a\0b", "no such file"),
    ("package:nowhere_at_all/x.png", "there is no Python package 'nowhere_at_all'"),
    ("package:numpy.linalg/x.png", "there is no Python package 'numpy.linalg'"),
    ("package:__main__/x.png", "there is no Python package '__main__'"),
    ("package:", "there is no Python package ''"),
    ("package:math/x.png", "there is no Python package 'math'"),  # a module without files
    ("package:numpy/x.png", "no such file"),
    ("package:numpy", "no such file"),
])
def test_missing_files(tmp_path, reference, message):
    assert refusal(tmp_path, reference) == f"{WHERE}: {reference}: {message}"


@pytest.mark.parametrize("name", ["wall.png", "wall.jpg"])
def test_truncated_and_damaged_pictures(tmp_path, name):
    data = picture(tmp_path, name)
    for cut in (0, 1, 7, 20, len(data) // 2):
        (tmp_path / name).write_bytes(data[:cut])
        assert refusal(tmp_path, name).startswith(f"{WHERE}: {name}: ")


@pytest.mark.parametrize("name", ["wall.gif", "wall.bmp", "wall.tiff"])
def test_other_formats(tmp_path, name):
    picture(tmp_path, name)
    assert f"{name}: not a PNG or JPEG picture" in refusal(tmp_path, name)


@pytest.mark.parametrize("size, taken", [((8192, 1), True), ((8193, 1), False), ((1, 8193), False)])
def test_picture_sizes(tmp_path, size, taken):
    Image.new("L", size).save(tmp_path / "wall.png")
    if taken:
        images.load("wall.png", tmp_path, WHERE)
    else:
        assert refusal(tmp_path, "wall.png") == (
            f"{WHERE}: wall.png: cannot be read: {size[0]}x{size[1]} pixels; "
            "a side must be from 1 to 8192")


def test_enormous_picture_is_refused_unread(tmp_path, recwarn):
    header = bytearray(picture(tmp_path, "wall.png"))
    header[16:24] = (60000).to_bytes(4, "big") * 2
    header[29:33] = zlib.crc32(header[12:29]).to_bytes(4, "big")
    (tmp_path / "wall.png").write_bytes(header)
    assert "a side must be from 1 to 8192" in refusal(tmp_path, "wall.png")
    assert not recwarn.list


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGBA", "I;16"])
def test_picture_modes(tmp_path, mode):
    """Every kind of PNG gives the same colour: bright grey."""
    value = {"1": 1, "L": 200, "LA": (200, 255), "P": 0, "RGBA": (200, 200, 200, 255),
             "I;16": 200 * 256}[mode]
    image = Image.new(mode, (9, 9), value)
    if mode == "P":
        image.putpalette([200, 200, 200])
    image.save(tmp_path / "grey.png")
    loaded = images.load("grey.png", tmp_path, WHERE)
    assert loaded.shape == (256, 256, 3) and loaded.dtype == np.uint8
    assert np.unique(loaded).tolist() == [255 if mode == "1" else 200]


def test_picture_is_turned_as_its_camera_was(tmp_path):
    """EXIF orientation 3: the camera was upside down."""
    pixels = np.zeros((40, 40, 3), np.uint8)
    pixels[:, 20:] = 220
    exif = Image.Exif()
    exif[0x0112] = 3
    Image.fromarray(pixels).save(tmp_path / "turned.jpg", exif=exif)
    loaded = images.load("turned.jpg", tmp_path, WHERE)
    assert loaded[:, :100].min() > 150 and loaded[:, 156:].max() < 50


@pytest.mark.parametrize("width, height, dark", [(60, 20, 1 / 3), (20, 60, 1), (8, 8, 1), (30, 10, 1 / 3)])
def test_picture_is_cut_to_the_shape_of_its_map(tmp_path, width, height, dark):
    pixels = np.full((10, 30, 3), 255, np.uint8)
    pixels[:, 10:20] = 0
    Image.fromarray(pixels).save(tmp_path / "wide.png")
    Image.fromarray(pixels.transpose(1, 0, 2)).save(tmp_path / "high.png")
    found = images.load("wide.png", tmp_path, WHERE, width, height)
    assert found.shape == (height, width, 3) and found.dtype == np.uint8
    assert abs((found < 128).mean() - dark) < 0.01
    if width == height:  # of the usual size it is the picture's centre too
        assert not images.load("wide.png", tmp_path, WHERE).any()
    turned = images.load("high.png", tmp_path, WHERE, height, width)
    assert np.array_equal(turned.transpose(1, 0, 2), found)


@pytest.mark.parametrize("mode, opaque, clear", [
    ("RGBA", (9, 9, 9, 255), (9, 9, 9, 254)), ("LA", (9, 255), (9, 0)), ("P", 7, 8), ("RGB", (9, 9, 9), (9, 9, 8)),
    ("L", 9, 8), ("1", 0, 1)])
def test_transparent_pixels(tmp_path, mode, opaque, clear):
    """One is found, in every kind of PNG, unless the map's shape cuts it off; an alpha of opaque pixels is
    none. In modes without alpha one value stands for transparency."""
    key = {} if mode in ("RGBA", "LA") else {"transparency": clear}
    image = Image.new(mode, (90, 30), opaque)
    if mode == "P":
        image.putpalette(range(30))
    for at, found in ((None, False), ((45, 29), True), ((2, 2), False)):
        shown = image.copy()
        if at:
            shown.putpixel(at, clear)
        shown.save(tmp_path / "wall.png", **key)
        assert images.is_transparent("wall.png", tmp_path, WHERE) == found, at
    assert images.is_transparent("wall.png", tmp_path, WHERE, 96, 32)


def test_picture_in_a_package():
    portrait = "package:matplotlib/mpl-data/sample_data/grace_hopper.jpg"
    loaded = images.load(portrait, None, WHERE)
    assert loaded.shape == (256, 256, 3)


@pytest.mark.parametrize("at_once", [77, palette.AT_ONCE])
def test_nearest_is_exact(monkeypatch, at_once):
    """Of equally near entries the lowest is found, however many colours are looked up together."""
    monkeypatch.setattr(palette, "AT_ONCE", at_once)
    random = np.random.default_rng(3)
    pixels = random.integers(0, 256, (40, 50, 3)).astype(np.uint8)
    entries = random.integers(0, 256, (200, 3)).astype(np.uint8)
    distance = ((pixels[..., None, :].astype(int) - entries.astype(int)) ** 2).sum(axis=-1)
    assert np.array_equal(palette.nearest(pixels, entries), distance.argmin(axis=-1))


@pytest.mark.parametrize("height, part", [(128, 1), (129, 4)])
def test_of_large_pictures_a_quarter_counts(height, part):
    """The sample has texels from every row and every column."""
    rows, columns = np.indices((height, 128), np.uint8)
    kept = palette.sample(np.stack([rows, columns, rows], axis=-1))
    assert len(kept) == height * 128 // part
    assert len(np.unique(kept[:, 0])) == height and len(np.unique(kept[:, 1])) == 128


def test_palette_without_textures():
    colours, maps = palette.build([(1, 2, 3), (4, 5, 6), (1, 2, 3)], [], "here")
    assert colours[:4].tolist() == [[1, 2, 3], [4, 5, 6], [1, 2, 3], [0, 0, 0]] and maps == []


def test_palette_of_unlike_pictures():
    """A small picture's colours count too, and each picture keeps its size."""
    small, large = np.full((8, 16, 3), 200, np.uint8), np.zeros((256, 512, 3), np.uint8)
    small[3, 5] = (255, 0, 9)
    colours, maps = palette.build([(1, 2, 3)], [large, small], "here")
    assert [texels.shape for texels in maps] == [(256, 512), (8, 16)]
    assert (colours[maps[0]] == large).all() and (colours[maps[1]] == small).all()


def test_light_table():
    """Black, then ever lighter, finally the entry itself; always the nearest entry."""
    colours = np.random.default_rng(4).integers(0, 256, (256, 3)).astype(np.uint8)
    colours[0] = 0
    table = palette.light(colours)
    assert table.shape == (64, 256) and (table[0] == 0).all()
    assert (table[63] == np.arange(256)).all()
    for level in (1, 20, 62):
        wanted = np.rint(colours * (level / 63)).astype(int)
        distance = ((wanted[:, None] - colours.astype(int)) ** 2).sum(axis=-1)
        assert (distance[np.arange(256), table[level]] == distance.min(axis=-1)).all()


def test_palette_of_lit_pictures():
    """The palette also has entries for lit pictures in less light."""
    v, u = np.indices((64, 64)) * 4
    picture = np.stack([u, 255 - v, (u + v) // 2], axis=-1).astype(np.uint8)
    errors = []
    for lit in ([], [(picture, (0, 0, 0))]):
        colours, (texels,) = palette.build([(0, 0, 0)], [picture], "here", lit)
        table = palette.light(colours)
        errors.append(np.mean([abs(colours[table[level, texels]] - picture * (level / 63)).mean()
                               for level in range(0, 64, 7)]))
    assert errors[1] < 0.7 * errors[0]


@pytest.mark.parametrize("count, pictures, taken", [
    (256, 0, True), (257, 0, False), (192, 1, True), (193, 1, False)])
def test_palette_has_256_entries(count, pictures, taken):
    exact, noise = [(1, 2, n % 256) for n in range(count)], np.zeros((8, 8, 3), np.uint8)
    if taken:
        palette.build(exact, [noise] * pictures, "here")
        return
    with pytest.raises(UserError, match=f"^here: {count} palette entries for flat colours"):
        palette.build(exact, [noise] * pictures, "here")


@pytest.mark.parametrize("size, sides", [
    ((300, 300), (256, 256)), ((60, 40), (256, 256)), ((128, 64), (256, 128)), ((64, 128), (128, 256)),
    ((126, 64), (256, 128)), ((120, 64), (256, 256)), ((400, 100), (256, 64)), ((500, 100), (256, 64)),
    ((8192, 1), (256, 8))])
def test_maps_have_the_proportions_of_their_pictures(tmp_path, size, sides):
    """Powers of two, no longer than the picture but for 1/32; 8 texels at least."""
    Image.new("RGB", size).save(tmp_path / "wall.png")
    assert images.size_like("wall.png", tmp_path, WHERE) == sides


def test_proportions_of_a_turned_picture_and_of_none(tmp_path):
    """A camera's turn counts; a picture that cannot be read is refused when it is loaded."""
    exif = Image.Exif()
    exif[images.ORIENTATION] = 6
    Image.new("RGB", (128, 64)).save(tmp_path / "wall.jpg", exif=exif)
    assert images.size_like("wall.jpg", tmp_path, WHERE) == (128, 256)
    assert images.size_like("roof.png", tmp_path, WHERE) == (256, 256)


def test_a_whole_picture_is_stretched(tmp_path):
    """Its left and right quarters, which are cut away otherwise."""
    pixels = np.zeros((32, 64, 3), np.uint8)
    pixels[:, :16] = pixels[:, 48:] = 200
    Image.fromarray(pixels).save(tmp_path / "wall.png")
    cut, whole = (images.load("wall.png", tmp_path, WHERE, 16, 16, "RGB", each) for each in (False, True))
    assert (cut == 0).all() and (whole[:, [0, 15]] > 190).all() and (whole[:, 6:10] < 10).all()
