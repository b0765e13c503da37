"""``tmap run`` from end to end: the emulated machine's frames, and errors."""

import json
import subprocess

import numpy as np
import pytest
from PIL import Image

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tmap.__main__ import FORMS, main
from tmap.base.errors import UserError
from tmap.base.outputs import save_animation
from tmap.base.paths import ROOT, SCENES
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator
from tmap.guest.emulator import CLOCK_HZ, CYCLES_PER_TICK
from tmap.model import model
from tmap.run import run

SMALL = """\
title = "A wall and a sign"
width = 64
height = 48
frames = 3
background = "#102030"
[textures]
wall.image = "wall.png"
[materials]
red.colour = "#ff0000"
wall.texture = "wall"
[[objects]]
material = "wall"
sides = 6
radius = 30
centre = [24, 20]
angle = 5
turns = 0.3
[[objects]]
material = "red"
sides = 3
radius = 14
centre = [44, 30]
turns = -1
"""
QUARTERS = ((250, 10, 20), (20, 240, 30), (40, 50, 230), (230, 220, 60))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A directory with SMALL as small.toml and its picture: a colour a quarter, in reading order."""
    made = tmp_path_factory.mktemp("scene")
    pixels = np.zeros((256, 256, 3), np.uint8)
    for number, colour in enumerate(QUARTERS):
        pixels[number // 2 * 128:, number % 2 * 128:] = colour
    Image.fromarray(pixels).save(made / "wall.png")
    (made / "small.toml").write_text(SMALL)
    return made


def names(directory) -> list[str]:
    return sorted(path.name for path in directory.iterdir()) if directory.exists() else []


def dumps(directory) -> list[bytes]:
    return [path.read_bytes() for path in sorted(directory.glob("*.chunky"))]


@pytest.fixture(scope="module")
def out(folder):
    """The directory of a run of SMALL, by neither the usual machine nor form."""
    made = folder / "out" / "small"
    assert main(["run", str(folder / "small.toml"), "-o", str(made), "--machine", "a1200",
                 "--form", "swap"]) == 0
    return made


@pytest.fixture(scope="module")
def counted(folder):
    """SMALL in all forms, one boot a machine: {(machine, form): (Asked, Drawn)}."""
    scene, made = compile_scene(folder / "small.toml"), {}
    for machine in emulator.MACHINES:
        asked = [Asked(scene, form=form) for form in FORMS]
        for each, drawn in zip(asked, guest_runs.draw(asked, machine, timed=True), strict=True):
            made[machine, each.form] = each, drawn
    return made


def test_every_form_on_every_machine(counted):
    """The model's frames, with the same number of pixels; fast RAM is faster, and so is addx than
    swap, and swap than C."""
    cycles = {}
    for (machine, form), (asked, drawn) in counted.items():
        guest_runs.check("small", asked, drawn, machine)
        cycles[machine, form] = run.total(drawn.figures)["cycles"]
    assert len({run.total(drawn.figures)["pixels"] for _, drawn in counted.values()}) == 1
    for form in FORMS:
        assert cycles["a1200-fast", form] < cycles["a1200", form], cycles
    for machine in emulator.MACHINES:
        assert cycles[machine, "addx"] < cycles[machine, "swap"] < cycles[machine, "c"], cycles


def test_run_json(folder, out):
    """The figures of the run, of each frame and of all together; all frames are the model's."""
    scene = compile_scene(folder / "small.toml")
    expected = [model.render(scene, number).tobytes() for number in range(3)]
    assert len(set(expected)) == 3 and dumps(out) == expected
    about = json.loads((out / "run.json").read_text())
    assert about["commit"] and about["compiler"].split()[0] in ("gcc", "vbcc")
    for key, value in {"scene": "small", "title": "A wall and a sign", "machine": "a1200",
                       "form": "swap", "emulator": f"FS-UAE {emulator.VERSION}", "width": 64,
                       "height": 48, "palette": scene.palette.tolist()}.items():
        assert about[key] == value, key
    frames, totals = about["frames"], about["totals"]
    assert [frame["number"] for frame in frames] == [0, 1, 2]
    for frame in frames:
        assert frame["cycles"] > 64 * 48 and frame["cycles"] % CYCLES_PER_TICK == 0
        assert frame["polygons"] == 2
        assert {kind.removesuffix("_wrap") for kind in frame["spans"]} == {"triangles_flat", "affine_swap"}
        assert frame["pixels"] == sum(frame["spans"].values())
    for key in ("cycles", "polygons", "pixels"):
        assert totals[key] == sum(frame[key] for frame in frames)
    assert totals["cycles_per_pixel"] == round(totals["cycles"] / totals["pixels"], 3)
    assert sum(totals["spans"].values()) == totals["pixels"]
    lowering = about["lowering"]
    assert list(lowering) == ["red", "wall"] and lowering["wall"]["asked"] == {
        "mapper": "affine", "edges": "snapped", "gradients": "plane", "start": "subtexel",
        "clip": "scissor", "perspective": "none", "tolerance": 0}
    assert totals["pixels"] == sum(sum(each["spans"].values()) for each in lowering.values())


def test_pixel_counts_are_the_models(counted):
    """The pixels of polygons are counted even if others cover them."""
    asked, drawn = counted["a1200", "addx"]
    for number, figures in enumerate(drawn.figures):
        polygons = [model.prepare(asked.scene, obj, number) for obj in asked.scene.objects]
        assert figures["pixels"] == sum(polygon.pixels for polygon in polygons), f"frame {number}"


def figures_of(*milliseconds) -> list[dict]:
    """Figures of frames that take so long."""
    return [{"cycles": round(ms * CLOCK_HZ / 1000)} for ms in milliseconds]


@pytest.mark.parametrize("takes, times, factor", [
    ([100, 200, 160], [100, 200, 160], 1),
    ([33.3] * 6, [30, 40, 30, 30, 40, 30], 1.001),  # rounded, but not all to the same side
    ([5, 35], [20, 20], 1),  # the second makes up for the first
    ([10] * 4, [20] * 4, 2),  # as browsers would not show them
    ([400_000] * 2, [327_670] * 2, 0.819)])
def test_animations_play_at_the_machines_speed(takes, times, factor):
    """As far as a GIF can; the factor tells how far."""
    assert run.animation(figures_of(*takes)) == {"times_ms": times, "factor": factor}


def test_a_single_frame_has_no_animation():
    assert run.animation(figures_of(100)) is None


def test_equal_frames_of_a_long_animation(tmp_path):
    """They become one, which is shown as long as all."""
    pictures = [Image.new("L", (8, 8), value) for value in [9] * 50 + [5]]
    times = run.gif_times(figures_of(*[20_000] * 51))
    save_animation(tmp_path / "long.gif", pictures, times)
    with Image.open(tmp_path / "long.gif") as moving:
        assert moving.n_frames == 2 and moving.info["duration"] == 50 * times[0] > 600_000


@pytest.mark.parametrize("factor, words", [
    (1.004, "at the estimated speed"),
    (2, "takes 2.00 times as long as estimated: a frame is shown for 20 ms at least"),
    (0.819, "takes 0.82 times as long as estimated: all frames are shown for 655 s at most")])
def test_summary_tells_the_animations_speed(out, capsys, factor, words):
    about = json.loads((out / "run.json").read_text())
    about["animation"]["factor"] = factor
    run.print_report(about, out)
    line = capsys.readouterr().out.splitlines()[-2]
    assert line.startswith("animation ") and words in line


def test_pictures_are_the_dumps(out):
    """Each frame as PNG, and all as an animation that repeats without end."""
    about = json.loads((out / "run.json").read_text())
    palette, times = np.array(about["palette"], np.uint8), about["animation"]["times_ms"]
    assert abs(sum(times) - max(60, 1000 * about["totals"]["cycles"] / CLOCK_HZ)) <= 5
    assert names(out) == ["animation.gif", *(f"frame_{n:03}.{end}" for n in range(3)
                                             for end in ("chunky", "png")), "run.json"]
    with Image.open(out / "animation.gif") as animation:
        assert (animation.n_frames, animation.info["loop"]) == (3, 0)
        for number, dump in enumerate(dumps(out)):
            colours = palette[np.frombuffer(dump, np.uint8).reshape(48, 64)]
            with Image.open(out / f"frame_{number:03}.png") as picture:
                assert picture.mode == "P"
                assert (np.array(picture.convert("RGB")) == colours).all()
            animation.seek(number)
            assert animation.info["duration"] == times[number]
            assert (np.array(animation.convert("RGB")) == colours).all()


def test_texture_is_upright_and_exact(folder, capsys):
    """A square that shows the map 1:1 is the picture itself, pixel by pixel."""
    text = SMALL[:SMALL.index("[[objects]]")].replace("64", "256").replace("48", "256")
    (folder / "upright.toml").write_text(
        text + '[[objects]]\nmaterial = "wall"\n'
        "vertices = [[0, 0, 0, 0], [256, 0, 256, 0], [256, 256, 256, 256], [0, 256, 0, 256]]\n")
    out = folder / "out" / "upright"
    assert main(["run", str(folder / "upright.toml"), "-o", str(out), "--frames", "1"]) == 0
    with Image.open(out / "frame_000.png") as shown, Image.open(folder / "wall.png") as picture:
        assert shown.convert("RGB").tobytes() == picture.tobytes()
    scene = compile_scene(folder / "upright.toml", 1)
    assert dumps(out) == [scene.textures[0].texels.tobytes()]
    assert not (out / "animation.gif").exists()
    assert capsys.readouterr().out.splitlines()[-1].split() == ["pictures", f"{out}/frame_000.png"]


def test_default_scene_through_the_script(tmp_path):
    """Two frames; files of an earlier run are removed, the user's stay."""
    out = tmp_path / "deep" / "out"
    out.mkdir(parents=True)
    for name in ("frame_002.png", "frame_777.chunky", "frame_notes.png", "mine.txt"):
        (out / name).write_text("old")
    done = subprocess.run(
        [ROOT / "scripts" / "tmap", "run", SCENES / "default.toml", "-o", "deep/out", "--frames", "2"],
        cwd=tmp_path, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert "Polygons in a ring: 320x256 on a1200-fast, form addx" in done.stdout
    assert done.stdout.splitlines()[-1].endswith(
        "deep/out/frame_000.png to frame_001.png, animation.gif")
    scene = compile_scene(SCENES / "default.toml", 2)
    assert dumps(out) == [model.render(scene, number).tobytes() for number in range(2)]
    assert names(out) == ["animation.gif", "frame_000.chunky", "frame_000.png", "frame_001.chunky",
                          "frame_001.png", "frame_notes.png", "mine.txt", "run.json"]


def test_frames_of_16_bits(folder):
    """An empty scene, in which one colour is right: background, dump, pictures and run.json."""
    text = SMALL.replace("frames = 3", "frames = 2\nformat = \"rgb565\"").replace(
        'wall.texture = "wall"', 'wall = {texture = "wall", mapper = "columns"}')
    (folder / "wide.toml").write_text(text.replace("centre = [", "centre = [500, 500]\nmove = ["))
    out = folder / "out" / "wide"
    assert main(["run", str(folder / "wide.toml"), "-o", str(out)]) == 0
    assert dumps(out) == [b"\x11\x06" * 64 * 48] * 2
    about = json.loads((out / "run.json").read_text())
    assert (about["format"], about["palette"]) == ("rgb565", None)
    assert names(out) == ["animation.gif", "frame_000.chunky", "frame_000.png", "frame_001.chunky",
                          "frame_001.png", "run.json"]
    with Image.open(out / "frame_001.png") as picture:
        assert picture.mode == "RGB" and picture.getcolors() == [(64 * 48, (16, 32, 49))]
    with Image.open(out / "animation.gif") as animation:
        assert animation.convert("RGB").getcolors() == [(64 * 48, (16, 32, 49))]


def refused(arguments, capsys) -> str:
    """The error line of a command that fails."""
    assert main([str(argument) for argument in arguments]) == 2
    caught = capsys.readouterr()
    assert caught.out == "" and caught.err.startswith("tmap: ") and caught.err.count("\n") == 1
    return caught.err


@pytest.mark.parametrize("text, options, message", [
    (None, [], "bad.toml: No such file or directory"),
    ("width = 1\nheight", [], "bad.toml:2: is not TOML: "),
    (SMALL.replace("title", "titel"), [], "bad.toml:1: titel: unknown field"),
    (SMALL.replace("wall.png", "roof.png"), [], "textures.wall.image: roof.png: no such file"),
    (SMALL.replace('"wall.png"', '"small.toml"'), [], "small.toml: not a PNG or JPEG picture"),
    (SMALL, ["--frames", "0"], "frames: must be from 1 to 1000"),
    (SMALL, ["--frames", "1001"], "frames: must be from 1 to 1000"),
    (SMALL, ["--frames", "two"], "--frames: invalid int value: 'two'"),
    (SMALL, ["--machine", "a500"], "--machine: invalid choice: 'a500'"),
    (SMALL, ["--form", "mmx"], "--form: invalid choice: 'mmx'"),
    (SMALL, ["--speed"], "unrecognized arguments: --speed"),
])
def test_bad_input_leaves_nothing(folder, tmp_path, capsys, text, options, message):
    """Status 2, one line, no directory."""
    bad = folder / "bad.toml"
    bad.unlink(missing_ok=True)
    if text is not None:
        bad.write_text(text)
    assert message in refused(["run", bad, "-o", tmp_path / "out", *options], capsys)
    assert names(tmp_path) == []


@pytest.mark.parametrize("inside", ["", "deeper/out"])
def test_directory_that_is_a_file(folder, tmp_path, capsys, inside):
    """The error names it, and the file stays."""
    (tmp_path / "out").write_text("mine")
    out = tmp_path / "out" / inside
    assert f"{tmp_path}/out: is not a directory" in refused(
        ["run", folder / "small.toml", "-o", out], capsys)
    assert (tmp_path / "out").read_text() == "mine"


def test_bad_input_through_the_script(tmp_path):
    """Status 2 and one line, nothing on standard output."""
    for arguments, message in ((["run", "no.toml"], "tmap: no.toml: No such file or directory\n"),
                               ([], "tmap: usage: the following arguments are required: COMMAND; "
                                    "see tmap --help\n"),
                               (["paint"], "tmap: usage: argument COMMAND: invalid choice: 'paint'")):
        done = subprocess.run([ROOT / "scripts" / "tmap", *arguments], cwd=tmp_path,
                              capture_output=True, text=True)
        assert (done.returncode, done.stdout) == (2, "")
        assert done.stderr.startswith(message) and done.stderr.count("\n") == 1
    assert names(tmp_path) == []


@pytest.mark.parametrize("thrown, status, message", [
    (KeyboardInterrupt(), 130, "tmap: interrupted\n"),
    (OSError(28, "No space left on device", "x"), 2, "tmap: x: No space left on device\n")])
def test_stopped_run_leaves_no_emulator_and_no_file(folder, tmp_path, capsys, monkeypatch, thrown,
                                                    status, message):
    """Stopped by an interrupt, or by a full disk."""
    emulators = []

    def wait(process, volume, on_output, patience):
        emulators.append(process)
        raise thrown

    monkeypatch.setattr(emulator, "wait", wait)
    assert main(["run", str(folder / "small.toml"), "-o", str(tmp_path / "out")]) == status
    assert capsys.readouterr().err == message
    assert emulators[0].poll() is not None and names(tmp_path) == []


def test_failing_run_keeps_the_earlier_one(folder, out, capsys, monkeypatch):
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    monkeypatch.setattr(run, "FRAME_LINE", run.re.compile("nothing matches"))
    assert "is not the line of frame 0" in refused(["run", folder / "small.toml", "-o", out], capsys)
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before


@pytest.mark.parametrize("output, message", [
    ("", "0 lines of output for 2 frames and 0 materials; it wrote nothing"),
    ("frame 0 ticks 5 polygons 1\n", "1 lines of output for 2 frames and 0 materials; its last words: 'frame 0"),
    ("frame 0 ticks 5 polygons 1\nframe 2 ticks 5 polygons 1\n", "'frame 2 ticks 5 polygons 1' is"),
    ("frame 0 ticks 5 polygons 1\nframe 1 ticks 5 polygons 1 fill\n", "not the line of frame 1"),
])
def test_output_that_does_not_match_the_plan(output, message):
    """Too few lines, a frame left out, figures without numbers."""
    with pytest.raises(UserError, match=message):
        run.parse_output(output, 2, 0)


def test_dumps_that_do_not_match_the_plan(folder, tmp_path):
    """Frames of one colour, truncated, missing, too many."""
    scene = compile_scene(folder / "small.toml")
    drawn = [model.render(scene, number) for number in range(3)]
    empty = np.full_like(drawn[0], scene.background)
    for spoil, message in (
            ({0: empty}, "frame 0: one colour only"), ({2: empty}, "frame 2: one colour only"),
            ({1: drawn[1][1:]}, r"frame_001.chunky has 3008 bytes, not 64x48"),
            ({1: None}, "frame_001.chunky is missing"), ({3: empty}, "frame_003.chunky is one frame")):
        for old in tmp_path.iterdir():
            old.unlink()
        for number, frame in (dict(enumerate(drawn)) | spoil).items():
            if frame is not None:
                (tmp_path / f"frame_{number:03}.chunky").write_bytes(frame.tobytes())
        with pytest.raises(UserError, match=message):
            run.load_dumps(tmp_path, scene)
