"""The accuracy report: its promises, and its arithmetic."""

import json

import numpy as np
import pytest

from tmap.accuracy import accuracy, pictures
from tmap.accuracy.errors import Errors
from tmap.base.errors import UserError
from tmap.base.paths import ACCURACY_BASELINE, SCENES
from tmap.compiler import scene
from tmap.corpus import polygon_sets
from tmap.ideal import ideal, perspective
from tmap.model import model
from tmap.scene_file import scene_file

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
    """No coverage error at all; u and v are within 1/128 texel at every pixel."""
    found = accuracy.errors(name, BEST)
    assert found.coverage == 0 and found.pixels == found.ideal_pixels > 0
    assert found.worst <= 1 / 128, f"{name}: {found.worst} texels"


def test_best_setting_costs_little(medium: list[dict]) -> None:
    """At most 3 % more than the cheapest of the affine mapper's settings that are set up as it is,
    for the edges' carry."""
    affine = [r["cycles_per_polygon"] for r in medium
              if r["mapper"] == "affine" and r["edges"] != "snapped"]
    assert row(medium, BEST)["cycles_per_polygon"] <= 1.03 * min(affine)


def test_no_row_left_the_baseline(medium: list[dict]) -> None:
    """Errors equal the committed ones; cycles are within 1 % of them."""
    others = accuracy.measure_all([*polygon_sets.SIZES, "depth"], ["a1200-fast"])
    kept = [r for r in json.loads(ACCURACY_BASELINE.read_text())["rows"]
            if r["machine"] == "a1200-fast"]
    again = "if the change is meant: scripts/tmap accuracy --accept, and give the reason"
    for old, new in zip(kept, medium + others, strict=True):
        for key, value in old.items():
            if key.startswith("cycles"):
                assert abs(new[key] - value) <= 0.01 * value, f"{new}: {key} was {value}; {again}"
            elif key != "frontier":
                assert new[key] == value, f"{new}: {key} was {value}; {again}"


def test_every_combination_has_a_row(medium: list[dict]) -> None:
    """18 combinations of the affine mapper, 3 of each other mapper (2 if it has no truncated
    start), snapped edges of those with triangles' routines, and a frontier."""
    assert len(medium) == 18 + 3 * 7 + 2 * 3 + 5
    assert {r["mapper"] for r in medium} == {"affine", "flat", "gouraud", "arbitrary", "tiled",
                                             "columns", "generated", "lit", "lit_gouraud",
                                             "dithered", "keyed"}
    assert any(r["frontier"] for r in medium) and not all(r["frontier"] for r in medium)
    assert row(medium, BEST)["texel_error_rms"] < row(
        medium, model.Settings("integer", "polygon", "truncated"))["texel_error_rms"] / 100


def test_errors_are_the_exact_ones() -> None:
    """Lines with known errors: half a texel in u at each pixel; then three quarters, with no wrong
    texel; then a quarter across a border, with every texel wrong."""
    vertices = [(0, 0, 0, 0), (64 << 16, 0, 64 << 16, 0), (0, 64 << 16, 0, 64 << 16)]
    plane = ideal.Picture(vertices, 320, 256).planes[0]
    columns = np.arange(10, 20)
    found = (columns << 16) + 32768
    assert plane.errors(found, columns, 5).tolist() == [0.5] * 10
    total = Errors()
    line = model.Line(10, 20, (10 << 16) + 65536 * 3 // 4, 5 << 16, 65536, 0)
    total.texels(model.coordinates(line), 10, 5, ideal.Picture(vertices, 320, 256))
    assert total.worst == 0.75 and total.wrong == 0
    line.u -= 65536
    total.texels(model.coordinates(line), 10, 5, ideal.Picture(vertices, 320, 256))
    assert total.wrong == 10


@pytest.mark.parametrize("name", polygon_sets.DEPTHS)
def test_sets_with_depth_are_what_they_say(name: str) -> None:
    """Medium triangles with one corner half to all of the stated ratio deeper than another. On
    average their texture is as dense as in the other sets, and the format can store them."""
    most = polygon_sets.DEPTHS[name]
    made = polygon_sets.polygons(name)
    assert len(made) == polygon_sets.COUNT and made == polygon_sets.polygons(name)
    for k, vertices in enumerate(made):
        points, texels = ([[c / 65536 for c in v[a:a + 2]] for v in vertices] for a in (0, 2))
        low, high = polygon_sets.SHAPES["medium"][0]
        assert 0.99 * low < polygon_sets.area(points) < 1.01 * high
        depths = [v[5] / 65536 for v in vertices]
        assert 0.99 * most / 2 <= max(depths) / min(depths) <= 1.01 * most
        assert 0.2 <= min(depths) and max(depths) <= 16 * most
        dense = (polygon_sets.area(texels) / polygon_sets.area(points)) ** 0.5
        assert dense == pytest.approx(polygon_sets.STEPS[k % len(polygon_sets.STEPS)], rel=0.01)
        assert all(abs(c) < polygon_sets.LARGEST for pair in texels for c in pair)
    scene = accuracy.scene_of(name, accuracy.depth_combinations())
    scene_file.write(scene)
    assert {m.perspective for m in scene.materials} == set(scene_file.SETTINGS["perspective"])


def hand_made(name: str, values) -> Errors:
    """The errors of a renderer on a set. ``values`` computes u or v of pixels, 16.16, from a curve,
    the first and last pixel and the line."""
    total = Errors()
    for vertices in polygon_sets.polygons(name):
        picture = perspective.Picture([(*v[:4], v[5]) for v in vertices], 320, 256)
        total.ideal_pixels += picture.pixels
        for y, (first, end) in picture.extents.items():
            found = [np.array(values(curve, first, end - 1, y)) % (1 << 32) for curve in picture.planes]
            total.texels(found, first, y, picture)
            total.pixels += end - first
    assert total.pixels == total.ideal_pixels > 1000 * polygon_sets.COUNT
    return total


def rounded(curve, first: int, last: int, y: int) -> list[int]:
    """Divides at each pixel, rounded down to a unit."""
    return [n // q for n, q in (curve.terms(i << 16, y << 16) for i in range(first, last + 1))]


def in_pieces(n: int):
    """Affine pieces of n pixels; the remainder ends at the line's last pixel."""
    def values(curve, first: int, last: int, y: int) -> list[int]:
        found = []
        for start in range(first, last + 1, n):
            end = min(start + n, last)
            (a, qa), (b, qb) = (curve.terms(i << 16, y << 16) for i in (start, end))
            whole = 2 * qa * qb * max(end - start, 1)
            at, step = a * whole // qa + whole // 2, 2 * (b * qa - a * qb)
            found += [(at + k * step) // whole for k in range(min(n, last + 1 - start))]
        return found
    return values


@pytest.mark.parametrize("name", polygon_sets.DEPTHS)
def test_errors_of_hand_made_renderers(name: str) -> None:
    """Exact division is off by a unit at most and shows no wrong texel. Affine pieces are off by
    their chord errors; shorter pieces are better, and all are better than the affine renderer."""
    exact = hand_made(name, rounded)
    assert 0 < exact.worst < 1 / 65536 + 2**-33 and exact.wrong == 0
    pieces = {n: hand_made(name, in_pieces(n)) for n in (4, 16, 320)}
    assert exact.worst < pieces[4].worst < pieces[16].worst < pieces[320].worst
    largest = 0.0
    for vertices in polygon_sets.polygons(name):
        picture = perspective.Picture([(*v[:4], v[5]) for v in vertices], 320, 256)
        for y, (first, end) in picture.extents.items():
            largest = max([largest, *(curve.chord_error(first, end - 1 - first, y)
                                      for curve in picture.planes if end - first > 1)])
    assert 0.9 * largest < pieces[320].worst <= largest + 1 / 65536
    assert accuracy.errors(name, BEST).worst > pieces[320].worst  # not even the lines' ends are right


def test_every_mapper_is_shown() -> None:
    """Each mapper has a polygon in the picture of mappers; those with texture have a mark in the
    plot."""
    shown = scene.compile_scene(SCENES / "mappers.toml")
    assert {shown.materials[obj.material].mapper for obj in shown.objects} == set(scene_file.MAPPERS[1])
    assert {mapper for mapper, kept in scene_file.MAPPER_LAYOUT.items() if kept} <= set(
        pictures.MARKS)


def test_unknown_set_is_refused(tmp_path) -> None:
    """The error is one line that names the known sets."""
    with pytest.raises(UserError, match="no set is called huge; there are small, medium"):
        accuracy.command(tmp_path / "out", ["huge"], None, False)
    assert not (tmp_path / "out").exists()
