"""Where a scene's cycles go: counted on the emulated machine, as shares of what the renderer takes."""

import json
import re

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import main
from tmap.base.errors import UserError
from tmap.base.paths import BASELINE, SCENES
from tmap.bench.modes import measure, passes
from tmap.compiler.scene import compile_scene
from tmap.product import profile

#: Routines that only a first frame takes much of, and those that call the passes.
OTHERS = {"n64_quads", "n64_divide_table_make", "glide_products_make", "glide_colour", "n64_stages_draw", "glide_lines"}
SMALL = """\
frames = 1
width = 16
height = 16
background = "#000000"
[materials]
red.colour = "#ff0000"
[[objects]]
material = "red"
sides = 3
radius = 2
centre = [4, 4]
"""


def test_a_floors_cycles_are_its_spans(tmp_path, capsys) -> None:
    assert main(["profile", str(SCENES / "floor.toml"), "-o", str(tmp_path / "out"), "--frames", "3"]) == 0
    about = json.loads((tmp_path / "out" / "profile.json").read_text())
    rows = about["routines"]
    assert rows[0]["name"] == "level_draw" and rows[0]["room"] == "span"
    assert sum(row["share"] for row in rows if row["name"] in ("level_draw", "span_affine_level")) > 0.5
    assert {"level_lines", "sides_find", "polygon_draw_whole"} <= {row["name"] for row in rows}
    mean = np.mean(about["ticks"]) * 4
    assert sum(row["cycles"] for row in rows) == pytest.approx(mean)
    # a note is every 2,020 cycles, of frames that its interrupts make longer by a tenth or so
    notes = sum(row["notes"] for row in rows)
    assert 1 <= notes * 2020 / (3 * mean) < 1.25
    assert len(np.unique(np.asarray(Image.open(tmp_path / "out" / "profile.png")))) > 10
    assert "span/level_draw" in capsys.readouterr().out


def test_units_take_nearly_all_of_a_scene(tmp_path, capsys) -> None:
    """Each material's cycles a pixel, of all its pixels, are the scene's, but for the background."""
    path = SCENES / "glide_window.toml"
    assert main(["run", str(path), "-o", str(tmp_path / "out"), "--frames", "1"]) == 0
    text = capsys.readouterr().out.partition("Cycles a pixel of texture units, in 1 frame,")[2]
    found = {name: (float(each.replace(",", "")), int(pixels.replace(",", "")))
             for name, each, pixels in re.findall(r"^(\w+)  ([\d,.]+), of ([\d,]+) pixels$", text, re.M)}
    about = json.loads((tmp_path / "out" / "run.json").read_text())
    assert list(found) == ["wall", "boards"]
    assert sum(pixels for _, pixels in found.values()) == about["totals"]["pixels"]
    assert 0.95 < sum(each * pixels for each, pixels in found.values()) / about["totals"]["cycles"] < 1
    for routines in text.split("pixels\n")[1:]:
        assert "glide/glide_divide" in routines and "glide/glide_bilinear_times" in routines


def test_passes_are_of_modes_and_rows() -> None:
    rows = {row["name"] for row in json.loads(BASELINE.read_text())["rows"]}
    assert passes.PASSES.keys() <= measure.EVERY.keys()
    assert {name for some in passes.PASSES.values() for name in some} <= rows


@pytest.mark.parametrize("name", ("modulate_shade", "glide_modulate_perspective"))
def test_passes_are_those_that_run(name: str) -> None:
    """The pages' list of a mode's passes has every routine of the unit's assembly that takes 3 % of it, and none that
    does not run."""
    found, = profile.profile(measure.scene_of(measure.EVERY[name]), "a1200-fast").units.values()
    shares = {row.name: row.share for row in found if row.room in ("n64", "glide") and row.name not in OTHERS}
    assert {each for each, share in shares.items() if share > 0.03} <= set(passes.PASSES[name]) <= shares.keys()


def test_scenes_without_units_have_no_table_of_them(tmp_path, capsys) -> None:
    (tmp_path / "small.toml").write_text(SMALL)
    assert main(["run", str(tmp_path / "small.toml"), "-o", str(tmp_path / "out")]) == 0
    assert "texture units" not in capsys.readouterr().out


def test_no_note_is_one_line(tmp_path, monkeypatch) -> None:
    path = tmp_path / "small.toml"
    path.write_text(SMALL)
    monkeypatch.setattr(profile, "noted", lambda *_: ({}, np.zeros(0, np.uint32)))
    with pytest.raises(UserError, match="over before the first note"):
        profile.profile(compile_scene(path), "a1200-fast")
