"""Where a scene's cycles go: counted on the emulated machine, as shares of what the renderer takes."""

import json

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import main
from tmap.base.errors import UserError
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.product import profile

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
    # a count is every 2,020 cycles, of frames that its interrupts make longer by a tenth or so
    counts = sum(row["counts"] for row in rows)
    assert 1 <= counts * 2020 / (3 * mean) < 1.25
    assert len(np.unique(np.asarray(Image.open(tmp_path / "out" / "profile.png")))) > 10
    assert "span/level_draw" in capsys.readouterr().out


def test_no_count_is_one_line(tmp_path, monkeypatch) -> None:
    path = tmp_path / "small.toml"
    path.write_text(SMALL)
    monkeypatch.setattr(profile, "counted", lambda *_: {})
    with pytest.raises(UserError, match="over before the first count"):
        profile.profile(compile_scene(path), "a1200-fast")
