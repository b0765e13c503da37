"""``tmap fit``: what it chooses is compared with a plain search of all choices on a made-up machine, and with what
``show`` says on the emulated one."""

import json
import tomllib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import main
from tmap.accuracy import choose
from tmap.accuracy.fit import fit, search, steps, toml
from tmap.accuracy.fit.steps import Choice
from tmap.accuracy.fit.trials import Bench, Trial, summed, times_of
from tmap.accuracy.resolutions import Difference, colours, difference
from tmap.base.paths import ACCURACY_BASELINE
from tmap.compiler.scene import compile_scene, content_of, parse, text_of
from tmap.compiler.space import SIZES
from tmap.guest import emulator
from tmap.guest.emulator import CLOCK_HZ
from tmap.model import model
from tmap.scene_file.scene_file import Scene, write

FRAMES = 3
#: A floor and a wall in space that move, and a mark on the screen.
TEXT = """\
width = 32
height = 24
frames = 3
background = "#102030"
[textures]
noise.image = "noise.png"
[materials]
floor = { texture = "noise", perspective = "every16" }
"the wall" = { texture = "noise", perspective = "pixel", tolerance = 0.25 }
mark.colour = "#ff0000"
[camera]
eye = [0, 1, 4]
target = [0, 0.5, 0]
keys = [{ frame = 0, eye = [0, 1, 4] }, { frame = 2, eye = [1, 0.7, 3] }]
[[objects]]
material = "floor"
points = [[-4, 0, 4], [4, 0, 4], [4, 0, -9], [-4, 0, -9]]
faces = [[0, 1, 2, 3]]
uvs = [[[0, 1024], [1024, 1024], [1024, 0], [0, 0]]]
[[objects]]
material = "the wall"
points = [[1, 0, 3], [1, 0, -9], [1, 3, -9], [1, 3, 3]]
faces = [[1, 0, 3, 2]]
uvs = [[[0, 256], [1024, 256], [1024, 0], [0, 0]]]
[[objects]]
material = "mark"
vertices = [[2, 2], [9, 2], [5, 9]]
"""
#: The made-up machine's cycles of a pixel by perspective, and of a frame.
PRICES = {"none": 20, "every16": 30, "every8": 34, "pixel": 80, "fine": 100}
EACH, CONVERTED = 8_000, 12
TWO = ["1x1", "2x2"]  # sizes of pixels that are searched
DRAWN: dict[tuple[Choice, int], Difference] = {}
SCENES: dict[Choice, Scene] = {}
REFUSED: list[str] = []  # sizes of pixels for which it has no memory


@pytest.fixture(scope="module")
def path(tmp_path_factory) -> Path:
    """The scene's file."""
    folder = tmp_path_factory.mktemp("fit")
    noise = 85 * np.random.default_rng(3).integers(0, 4, (64, 64, 1), np.uint8).repeat(3, 2)
    Image.fromarray(noise).save(folder / "noise.png")
    (folder / "small.toml").write_text(TEXT)
    return folder / "small.toml"


class MadeUp(Bench):
    """Measures a machine of simple sums: both materials in space have half of the pixels, later frames more of the
    floor; snapped edges save a tenth of what has no perspective. The model draws the pictures."""

    def draw_exact(self) -> None:
        self.scenes = SCENES
        scene = self.compiled(self.space.exact("1x1"))
        self.exact = [colours(scene, model.render(scene, k)) for k in range(scene.frames)]

    def difference_of(self, scene: Scene, choice: Choice, number: int) -> Difference:
        """A frame's difference; it is drawn once by all machines."""
        if (choice, number) not in DRAWN:
            DRAWN[choice, number] = difference([colours(scene, model.render(scene, number))], [self.exact[number]])
        return DRAWN[choice, number]

    def drawing(self, scene: Scene, number: int) -> int:
        """Cycles of a frame."""
        made = EACH
        for k, material in enumerate(scene.materials[:2]):
            price = PRICES[material.perspective] - (10 if material.tolerance else 0)
            price -= 2 * (material.perspective == "none" and material.edges == "snapped")
            made += scene.width * scene.height * price * (10 + number * (k == 0)) // 20
        return made

    def measure(self, choices: list[Choice], numbers: list[int], what: str) -> list[Trial | None]:
        made = []
        for choice in choices:
            if choice.pixel in REFUSED:
                self.refused[choice] = "no memory"
                made.append(None)
                continue
            scene = self.compiled(choice)
            drawing = [self.drawing(scene, number) for number in numbers]
            showing = [CONVERTED * scene.width * scene.height] * len(numbers)
            fields = [-(-(one + other) * 50 // CLOCK_HZ) for one, other in zip(drawing, showing)]
            each = [self.difference_of(scene, choice, k) for k in numbers]
            made.append(Trial(choice, numbers, drawing, showing, fields, summed(each), each))
            self.trials[choice, *numbers] = made[-1]
        return made


def made_up(path: Path) -> MadeUp:
    """A machine with the scene in it."""
    raw, spec = content_of(text_of(path), path), parse(path)
    bench = MadeUp(path, steps.space_of(raw, spec, "a1200-fast"), "a1200-fast", lambda *_: None)
    bench.draw_exact()
    return bench


def every_trial(bench: Bench) -> list[Trial]:
    """All choices, measured in all frames."""
    choices = [choice for pixel in TWO for choice in bench.space.every(pixel)]
    return [trial for trial in bench.measure(choices, list(range(FRAMES)), "all") if trial]


def test_steps_are_those_that_nothing_beats() -> None:
    """Of the committed figures: each is cheaper than the one before, and less exact."""
    rows = json.loads(ACCURACY_BASELINE.read_text())["rows"]
    for machine in ("a1200", "a1200-fast"):
        kept = steps.perspectives(rows, machine, "affine")
        assert kept[0] == "fine" and kept[-1] == "none" and len(kept) > 2
        cost = {row["perspective"]: row[choose.POLYGON] for row in rows if (row["name"], row["machine"], row["edges"])
                == ("depth", machine, "exact") and row["mapper"] == "affine"}
        assert [cost[each] for each in kept] == sorted((cost[each] for each in kept), reverse=True)


def test_values_are_toml() -> None:
    found = {"a b": 'say "ü"', "n": [1, 2.5, True, {"x": False}], "plain-key_1": -3}
    assert tomllib.loads(toml.lines("2x1", {"odd name": found})) == {"pixel": "2x1", "materials": {"odd name": found}}
    assert toml.lines(None, {}) == "" and toml.lines("2x2", {}) == 'pixel = "2x2"'


def test_times_are_in_order_of_frames() -> None:
    """`show` begins with frame 0 and shows one more than all: the first to count is frame 2."""
    said = "4 frames in 12 fields\n" + "".join(f"drawn {k}0 converted {k} field {at}\n"
                                               for k, at in ((1, 5), (2, 7), (0, 10), (1, 12)))
    assert times_of(said, 3) == ([0, 40, 80], [0, 4, 8], [3, 2, 2])
    assert times_of("drawn 1 converted 2 field 6\ndrawn 3 converted 4 field 9", 1) == ([12], [16], [3])


def test_choice_is_the_most_exact_that_holds(path) -> None:
    """For rates between those of all choices: no other that holds the rate has a smaller error, as it is said. Where
    none holds, none is chosen."""
    whole = every_trial(made_up(path))
    rates = sorted(CLOCK_HZ / trial.busy for trial in whole)
    for rate in (rates[0] / 2, *rates[20::40], rates[-1] * 0.999, rates[-1] * 1.001):
        bench, predicted = made_up(path), []
        best = search.search(bench, TWO, [0, 1], list(range(FRAMES)), rate, predicted)
        good = [trial for trial in whole if trial.holds(rate)]
        assert bool(best) == bool(good), rate
        if best:
            assert best.holds(rate) and best.numbers == list(range(FRAMES))
            assert best.off.rms < min(trial.off.rms for trial in good) + 0.1, (rate, best.choice)
            assert len(bench.trials) < len(whole) / 2
            assert 50 < len(predicted)


def test_sums_predict_what_is_measured(path) -> None:
    """Where materials cost as much whatever the others are, the sums of single changes are exact."""
    bench = made_up(path)
    size = search.Size(bench, "2x2", list(range(FRAMES)))
    size.measure()
    whole = {trial.choice: trial for trial in every_trial(bench)}
    for each in size.choices:
        assert abs(each.worst - whole[each.choice].busy) <= 8, each.choice
        assert abs(each.rms - whole[each.choice].off.rms) < 1, each.choice


@pytest.mark.parametrize("pixel", SIZES)
def test_pasted_lines_make_the_choice(path, pixel) -> None:
    """A file with the lines in place of its own compiles to the scene that was measured."""
    bench = made_up(path)
    for choice in (bench.space.exact(pixel), bench.space.cheap(pixel), Choice(pixel, "exact", (3, 4)),
                   Choice(pixel, "snapped", (2, len(bench.space.groups[1].steps) - 2)), Choice(pixel)):
        found = search.Found(bench.space, [], None, None, None, True, {}, [], [])
        lines = tomllib.loads(fit.shortest_lines(found, choice, path))
        content = tomllib.loads(TEXT)
        content["materials"] |= lines.pop("materials", {})
        assert write(compile_scene(path, keys=content | lines)) == write(bench.compiled(choice)), choice


@pytest.fixture
def tmap(capsys, monkeypatch, path, tmp_path):
    """Runs the command on the made-up machine; returns its status, its output and its error output."""
    monkeypatch.setattr(search, "Bench", MadeUp)

    def run(*arguments, scene=path) -> tuple[int, str, str]:
        status = main(["fit", str(scene), "-o", str(tmp_path / "out"), *map(str, arguments)])
        return status, *capsys.readouterr()
    return run


def test_output_and_files(tmap, tmp_path) -> None:
    """Table, choice, error, lines, picture; the same each time."""
    status, said, complaint = tmap("--fps", 50)
    assert (status, complaint) == (0, "")
    for words in ("small on a1200-fast, 50 frames a second: 1 field a frame, 283,752 cycles", "most exact", "as it is",
                  "Chosen: pixels of 1x1", "The worst frame (2)", "of 255 (rms)", "as the scene has them"):
        assert words in said, words
    out = tmp_path / "out"
    assert sorted(path.name for path in out.iterdir()) == ["fit.json", "fit.md", "fit.png"]
    with Image.open(out / "fit.png") as picture:
        assert picture.size == (880, 550) and len(picture.convert("RGB").getcolors(1 << 20)) > 50
    found = json.loads((out / "fit.json").read_text())
    assert found["holds"] and {trial["mark"] for trial in found["trials"]} >= {"as it is", "most exact, chosen"}
    assert all(len(trial["drawing"]) == len(trial["numbers"]) for trial in found["trials"])
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    assert tmap("--fps", 50)[1] == said
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before


def test_cannot(tmap, monkeypatch) -> None:
    """Status 1, and the nearest that can, with its lines; sizes without memory are said."""
    for perspective in PRICES:
        monkeypatch.setitem(PRICES, perspective, 5_000)
    REFUSED.append("1x1")
    status, said, complaint = tmap("--fps", 50)
    REFUSED.clear()
    assert (status, complaint) == (1, "")
    assert "cannot: no settings hold 50 frames a second on a1200-fast; the nearest that can are pixels of 2x2" in said
    assert 'pixel = "2x2"' in said and "Left out: pixels of 1x1" in said and "no memory" in said


WIDE = TEXT.replace("width = 32", "width = 328")


@pytest.mark.parametrize("arguments, text, words", [
    *(((f"--fps={rate}",), None, "--fps") for rate in ("0", "-1", "nan", "inf", "much", "51")),
    ((), None, "--fps"),
    (("--fps=9", "--machine=a500"), None, "--machine"),
    (("--fps=9",), "missing", "No such file"),
    (("--fps=9",), WIDE, "width: 328 pixels; the screen shows 320 at most"),
    (("--fps=9",), TEXT.replace("width = 32", "width = 36"), "width: 36 pixels; the screen shows multiples of 8"),
    (("--fps=9",), TEXT.replace("height = 24", "height = 257"), "height: 257 pixels; the screen shows 256 at most"),
    (("--fps=9",), TEXT.replace("frames = 3", "frames = 0"), "frames"),
    (("--fps=9",), TEXT + "[", "is not TOML")])
def test_bad_input_is_one_line(tmap, tmp_path, path, arguments, text, words) -> None:
    """Status 2, a line that names the field, and nothing is written."""
    scene = path if text is None else tmp_path / "bad.toml"
    if text not in (None, "missing"):
        (tmp_path / "noise.png").write_bytes((path.parent / "noise.png").read_bytes())
        scene.write_text(text)
    status, said, complaint = tmap(*arguments, scene=scene)
    assert (status, said) == (2, "")
    assert complaint.count("\n") == 1 and words in complaint, complaint
    assert not (tmp_path / "out").exists()


def test_choice_holds_on_the_screen(path, tmp_path, capsys) -> None:
    """The emulated machine: what is said of the choice is what `show` says of the pasted scene."""
    machine = "a1200-fast"
    assert main(["fit", str(path), "--fps", "25", "--machine", machine, "-o", str(tmp_path)]) == 0
    said = capsys.readouterr().out
    found = json.loads((tmp_path / "fit.json").read_text())
    best = next(trial for trial in found["trials"] if "chosen" in trial["mark"] and len(trial["numbers"]) == FRAMES)
    assert max(best["fields"]) <= 2 and f"{FRAMES} frames took {sum(best['fields'])} fields" in said
    lines = tomllib.loads(found["lines"])
    content = tomllib.loads(TEXT)
    content["materials"] |= lines.pop("materials", {})
    scene = compile_scene(path, keys=content | lines)
    done = emulator.run("show", f"a.scene COUNT {FRAMES + 1} TIMES", {"a.scene": write(scene)}, machine, tmp_path / "x")
    assert times_of(done.output, FRAMES) == (best["drawing"], best["showing"], best["fields"])
