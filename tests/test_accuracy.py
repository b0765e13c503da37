"""The accuracy report: what it promises, and its own arithmetic."""

import json

import numpy as np
import pytest

from tools import accuracy, ideal, model, polygon_sets
from tools.errors import UserError
from tools.paths import ACCURACY_BASELINE

BEST = model.Settings("exact", "plane", "subtexel", mapper="affine")


@pytest.fixture(scope="module")
def medium() -> list[dict]:
    """The rows of the medium set in fast RAM; every frame was compared with the model."""
    return accuracy.measure(["medium"], ["a1200-fast"], accuracy.combinations())


def row(rows: list[dict], settings: model.Settings) -> dict:
    """The row of a combination."""
    found, = (r for r in rows if (r["edges"], r["gradients"], r["start"], r["mapper"])
              == (settings.edges, settings.gradients, settings.start, settings.mapper))
    return found


@pytest.mark.parametrize("name", polygon_sets.SHAPES)
def test_best_setting_is_exact_to_a_128th_texel(name: str) -> None:
    """No coverage error at all, u and v within 1/128 texel at every pixel."""
    found = accuracy.errors(name, BEST)
    assert found.coverage == 0 and found.pixels == found.ideal_pixels > 0
    assert found.worst <= 1 / 128, f"{name}: {found.worst} texels"


def test_best_setting_costs_little(medium: list[dict]) -> None:
    """At most 3 % over the cheapest setting of the affine mapper, by the edges' carry."""
    affine = [r["cycles_per_polygon"] for r in medium if r["mapper"] == "affine"]
    assert row(medium, BEST)["cycles_per_polygon"] <= 1.03 * min(affine)


def test_no_row_left_the_baseline(medium: list[dict]) -> None:
    """Errors are the committed ones; cycles stay within 1 %."""
    kept = [r for r in json.loads(ACCURACY_BASELINE.read_text())["rows"]
            if r["machine"] == "a1200-fast"]
    again = "if the change is meant: scripts/tmap accuracy --accept, and give the reason"
    for old, new in zip(kept, medium, strict=True):
        for key, value in old.items():
            if key.startswith("cycles"):
                assert abs(new[key] - value) <= 0.01 * value, f"{new}: {key} was {value}; {again}"
            elif key != "frontier":
                assert new[key] == value, f"{new}: {key} was {value}; {again}"


def test_every_combination_has_a_row(medium: list[dict]) -> None:
    """18 combinations of the affine mapper, 3 of each other one, and a frontier."""
    assert len(medium) == 18 + 3 * 6
    assert {r["mapper"] for r in medium} == {"affine", "flat", "gouraud", "arbitrary", "tiled",
                                             "columns", "generated"}
    assert any(r["frontier"] for r in medium) and not all(r["frontier"] for r in medium)
    assert row(medium, BEST)["texel_error_rms"] < row(
        medium, model.Settings("integer", "polygon", "truncated"))["texel_error_rms"] / 100


def test_gouraud_keeps_the_range_of_its_vertices() -> None:
    """No pixel has a shade outside the vertices', in any set."""
    settings = model.Settings("subpixel", "plane", "subtexel", mapper="gouraud")
    for name in polygon_sets.SHAPES:
        for vertices in polygon_sets.polygons(name):
            polygon = model.set_up(model.adapt(vertices, settings, 256), polygon_sets.WIDTH,
                                   polygon_sets.HEIGHT, True, settings)
            shades = [v[4] >> 16 for v in vertices]
            for line in polygon.lines if polygon else []:
                if line.right > line.left:
                    found = model.coordinates(line)[0] >> 16
                    assert min(shades) <= found.min() and found.max() <= max(shades), name


def test_errors_are_the_exact_ones() -> None:
    """Of a line whose error is known: half a texel in u, none in v."""
    vertices = [(0, 0, 0, 0), (64 << 16, 0, 64 << 16, 0), (0, 64 << 16, 0, 64 << 16)]
    plane = ideal.Picture(vertices, 320, 256).planes[0]
    columns = np.arange(10, 20)
    found = (columns << 16) + 32768
    assert np.allclose(plane.errors(found, columns, 5), 0.5)
    total = accuracy.Errors()
    line = model.Line(10, 20, (10 << 16) + 65536 * 3 // 4, 5 << 16, 65536, 0)
    total.texels(line, 5, ideal.Picture(vertices, 320, 256), BEST)
    assert total.worst == 0.75 and total.wrong == 0
    line.u -= 65536
    total.texels(line, 5, ideal.Picture(vertices, 320, 256), BEST)
    assert total.wrong == 10


def test_unknown_set_is_refused(tmp_path) -> None:
    """One line that names the sets there are."""
    with pytest.raises(UserError, match="no set is called huge; there are small, medium"):
        accuracy.command(str(tmp_path / "out"), ["huge"], None, False)
    assert not (tmp_path / "out").exists()
