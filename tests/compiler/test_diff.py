"""The frame differ: exit codes, messages and pictures."""

import json

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import main
from tmap.run import diff
from tmap.run.diff import GAP, MARK, compare

HEIGHT, WIDTH = 6, 320


def dump(path, changes=(), size=(HEIGHT, WIDTH)):
    """Writes a dump of a ramp with some (x, y, value) changed."""
    frame = (np.arange(size[0] * size[1]) % 251).astype(np.uint8).reshape(size)
    for x, y, value in changes:
        frame[y, x] = value
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(frame.tobytes())
    return path


@pytest.fixture
def two(tmp_path):
    return dump(tmp_path / "a" / "frame_000.chunky"), dump(tmp_path / "b" / "frame_000.chunky")


def test_compare():
    """A pixel counts once, whatever its channels."""
    a = np.zeros((10, 20), np.uint8)
    b = a.copy()
    assert compare(a, b).count == 0
    b[3, 7], b[3, 4], b[8, 5] = 1, 255, 3
    found = compare(a, b)
    assert (found.count, found.box, found.first) == (3, (4, 3, 7, 8), (4, 3))
    assert (found.values, found.largest) == ((0, 255), 255)
    assert compare(b, a).largest == 255
    colours = np.zeros((4, 4, 3), np.uint8)
    others = colours.copy()
    others[2, 1] = (5, 0, 9)
    found = compare(colours, others)
    assert (found.count, found.largest, found.values) == (1, 9, ([0, 0, 0], [5, 0, 9]))
    with pytest.raises(ValueError):
        compare(a, a[1:])


def test_equal(two, tmp_path, capsys):
    assert diff.command(*two, tmp_path / "out") == 0
    assert capsys.readouterr().out == "1 frame: 0 different in index, for want of two palettes\n"
    assert not (tmp_path / "out").exists()


def test_different(two, tmp_path, capsys):
    dump(two[1], [(5, 1, 0), (9, 3, 255)])
    assert diff.command(*two, tmp_path / "out") == 1
    lines = capsys.readouterr().out.splitlines()
    was = (1 * WIDTH + 5) % 251
    assert lines == [
        f"frame_000: 2 pixels differ, in x 5 to 9, y 1 to 3; first (5, 1): {was} / 0; "
        f"largest difference {max(was, 255 - (3 * WIDTH + 9) % 251)}",
        "1 frame: 1 different in index, for want of two palettes"]
    panels = np.array(Image.open(tmp_path / "out" / "frame_000_diff.png"))
    assert panels.shape == (HEIGHT, 3 * WIDTH + 2 * GAP, 3)
    third = panels[:, 2 * (WIDTH + GAP):]
    marked = (third == MARK).all(axis=2)
    assert np.argwhere(marked).tolist() == [[1, 5], [3, 9]]
    assert np.array_equal(third[~marked], panels[:, :WIDTH][~marked] // 3)
    assert panels[1, 5].tolist() == [was] * 3 and panels[1, 5 + WIDTH + GAP].tolist() == [0] * 3


def test_run_json_gives_size_and_colours(tmp_path):
    colours = [[i, 255 - i, 7] for i in range(256)]
    for run, changes in (("a", []), ("b", [(2, 3, 200)])):
        dump(tmp_path / run / "frame_000.chunky", changes, size=(8, 16))
        (tmp_path / run / "run.json").write_text(
            json.dumps({"width": 16, "height": 8, "palette": colours}))
    assert diff.command(tmp_path / "a", tmp_path / "b", tmp_path) == 1
    panels = np.array(Image.open(tmp_path / "frame_000_diff.png"))
    assert panels.shape == (8, 3 * 16 + 2 * GAP, 3)
    assert panels[3, 16 + GAP + 2].tolist() == [200, 55, 7]


def test_16_bits_a_pixel(tmp_path, capsys):
    for run, value in (("a", 0x0800), ("b", 0x07e0)):
        frame = np.zeros((4, 8), ">u2")
        frame[2, 5] = value
        (tmp_path / run).mkdir()
        (tmp_path / run / "frame_000.chunky").write_bytes(frame.tobytes())
        (tmp_path / run / "run.json").write_text(json.dumps(
            {"width": 8, "height": 4, "format": "rgb565", "palette": None}))
    assert diff.command(tmp_path / "a", tmp_path / "a") == 0
    assert diff.command(tmp_path / "a", tmp_path / "b", tmp_path) == 1
    out = capsys.readouterr().out
    assert "first (5, 2): 2048 / 2016; largest difference 32" in out and "1 different in colour\n" in out
    panels = np.array(Image.open(tmp_path / "frame_000_diff.png"))
    assert panels[2, 5].tolist() == [8, 0, 0] and panels[2, 5 + 8 + GAP].tolist() == [0, 255, 0]
    half = tmp_path / "c" / "frame_000.chunky"
    dump(half, size=(4, 8))
    half.with_name("run.json").write_text('{"width": 8}')
    assert "rgb565 and chunky" in refused([tmp_path / "a" / "frame_000.chunky", half], capsys)


def test_pngs(tmp_path, capsys):
    pixels = np.zeros((5, 7, 3), np.uint8)
    for name, value in (("a", 0), ("b", 0), ("c", 3)):
        pixels[4, 6, 1] = value
        Image.fromarray(pixels).save(tmp_path / f"{name}.png")
    assert diff.command(tmp_path / "a.png", tmp_path / "b.png") == 0
    assert diff.command(tmp_path / "a.png", tmp_path / "c.png", tmp_path / "out") == 1
    assert "first (6, 4): [0, 0, 0] / [0, 3, 0]" in capsys.readouterr().out
    assert (tmp_path / "out" / "a_diff.png").exists()


def test_directories(tmp_path, capsys):
    for i in range(4):
        for run in "ab":
            changes = [(i, i, 9)] if (run, i) == ("b", 2) else []
            dump(tmp_path / run / f"frame_{i:03}.chunky", changes)
    assert diff.command(tmp_path / "a", tmp_path / "b", tmp_path / "out") == 1
    out = capsys.readouterr().out.splitlines()
    assert out[0].startswith("frame_002: 1 pixels") and out[1:] == [
        "4 frames: 1 different in index, for want of two palettes"]
    assert [p.name for p in (tmp_path / "out").iterdir()] == ["frame_002_diff.png"]


def refused(arguments, capsys) -> str:
    """The error line of ``tmap diff`` that refuses; it prints nothing else."""
    assert main(["diff", *map(str, arguments)]) == 2
    caught = capsys.readouterr()
    assert caught.out == "" and caught.err.startswith("tmap: ") and caught.err.count("\n") == 1
    return caught.err


def run_of(folder, palette, frames):
    """Writes a run directory: a palette, uint8 (256, 3), and frames of the same size, uint8 (h, w)."""
    folder.mkdir()
    for number, frame in enumerate(frames):
        (folder / f"frame_{number:03}.chunky").write_bytes(frame.tobytes())
    (folder / "run.json").write_text(json.dumps(
        {"width": frame.shape[1], "height": frame.shape[0], "palette": palette.tolist()}))
    return folder


def test_palettes_that_differ(tmp_path, capsys):
    """Pictures are compared, not numbers: the same colours are equal, the same indices may differ."""
    random = np.random.default_rng(5)
    palette = random.permutation(np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, axis=1))
    order = random.permutation(256)
    frame = random.integers(0, 256, (6, 8)).astype(np.uint8)
    a = run_of(tmp_path / "a", palette, [frame, frame])
    same = run_of(tmp_path / "same", palette[order], [np.argsort(order).astype(np.uint8)[frame]] * 2)
    assert diff.command(a, same, tmp_path / "out") == 0
    assert capsys.readouterr().out == "2 frames: 0 different in colour; 2 of the same colours by other indices\n"
    changed = palette.copy()
    changed[frame[2, 3]] ^= 255
    assert diff.command(a, run_of(tmp_path / "other", changed, [frame, frame]), tmp_path / "out") == 1
    lines = capsys.readouterr().out.splitlines()
    y, x = np.argwhere(frame == frame[2, 3])[0]
    index, was = frame[2, 3], int(palette[frame[2, 3], 0])
    assert f"first ({x}, {y}): {index} = {[was] * 3} / {index} = {[255 - was] * 3}; " in lines[0]
    assert lines[2:] == ["2 frames: 2 different in colour"]
    panels = np.array(Image.open(tmp_path / "out" / "frame_001_diff.png"))
    marked = (panels[:, 2 * (8 + GAP):] == MARK).all(axis=2)
    assert np.array_equal(marked, frame == frame[2, 3])


def test_paths_that_cannot_be_compared(two, tmp_path, capsys):
    """Missing, no run directory, another number of frames or other ones: one line, no picture."""
    a, b, empty, missing = (tmp_path / name for name in ("a", "b", "empty", "missing"))
    empty.mkdir()
    dump(two[1], [(5, 1, 0)])
    for number in (1, 2):
        dump(a / f"frame_{number:03}.chunky")
    for other, message in ((missing, "missing: no such file or directory"), (b, f"{a} and {b}: 3 and 1 frames"),
                           (empty, "empty: is no run directory: it has no frame_*.chunky")):
        for pair in ((a, other), (other, a)):
            wanted = message if other != b or pair[0] == a else f"{b} and {a}: 1 and 3 frames"
            assert wanted in refused([*pair, "-o", tmp_path / "out"], capsys)
    for number in (1, 3):
        dump(b / f"frame_{number:03}.chunky")
    assert "frame_002.chunky is in one only" in refused([a, b, "-o", tmp_path / "out"], capsys)
    dump(b / "frame_002.chunky", size=(HEIGHT + 1, WIDTH))
    (b / "frame_003.chunky").unlink()
    assert "320x6 and 320x7 pixels" in refused([a, b, "-o", tmp_path / "out"], capsys)
    assert not (tmp_path / "out").exists()


def about(text):
    """Writes run.json beside the second dump."""
    return lambda a, b: b.with_name("run.json").write_text(text)


@pytest.mark.parametrize("spoil, message", [
    (lambda a, b: b.unlink(), "frame_000.chunky: no such file or directory"),
    (lambda a, b: b.write_bytes(b""), "0 bytes is not 320x? pixels"),
    (lambda a, b: b.write_bytes(bytes(321)), "321 bytes is not 320x1 pixels"),
    (lambda a, b: dump(b, size=(HEIGHT + 1, WIDTH)), "320x6 and 320x7 pixels"),
    (about("{"), "run.json: width, height, format or palette"),
    (about("[]"), "run.json: width, height, format or palette"),
    (about('{"width": 0}'), "run.json: width, height"),
    (about('{"width": -320, "height": -6}'), "is not -320x-6 pixels"),
    (about('{"width": 320, "height": 7}'), "1920 bytes is not 320x7 pixels"),
    (about('{"palette": [[1, 2, 3]]}'), "run.json: "),
    (about('{"palette": 300}'), "run.json: "),
    (about('{"format": "rgb555"}'), "run.json: "),
    (about('{"format": ["rgb565"]}'), "run.json: "),
    (about('{"format": "rgb565"}'), "320x6 and 320x3 pixels"),
    (about('{"format": "rgb565", "height": 6}'), "1920 bytes is not 320x6 pixels of 2 bytes"),
    (about('{"format": "rgb565", "height": 6, "width": 160}'), "320x6 and 160x6 pixels"),
])
def test_unusable(two, tmp_path, capsys, spoil, message):
    spoil(*two)
    assert message in refused([*two, "-o", tmp_path / "out"], capsys)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("first, second, message", [
    ("a/frame_000.chunky", "cut.png", "cut.png: cannot be read: "),
    ("a/frame_000.chunky", "empty.png", "empty.png: cannot be read: "),
    ("a/frame_000.chunky", "x.gif", "x.gif: neither a .chunky dump nor a .png frame"),
    ("a/frame_000.chunky", "x.png", "one is a dump, the other a picture"),
    ("a/frame_000.chunky", "b", "one is a directory, the other is not"),
    ("empty", "empty", "empty: is no run directory"),
])
def test_unlike_things(two, tmp_path, capsys, first, second, message):
    (tmp_path / "cut.png").write_bytes(b"\x89PNG\r\n\x1a\n\0\0")
    (tmp_path / "empty.png").write_bytes(b"")
    (tmp_path / "x.gif").write_bytes(b"GIF89a")
    (tmp_path / "empty").mkdir()
    Image.new("RGB", (WIDTH, HEIGHT)).save(tmp_path / "x.png")
    assert message in refused([tmp_path / first, tmp_path / second], capsys)


def test_output_that_cannot_be_written(two, tmp_path, capsys):
    """Without a place for pictures none are written."""
    dump(two[1], [(0, 0, 9)])
    (tmp_path / "out").write_text("in the way")
    assert diff.command(*two) == 1
    capsys.readouterr()
    assert "out: is not a directory" in refused([*two, "-o", tmp_path / "out"], capsys)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b", "out"]
