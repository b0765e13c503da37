"""The derived bounds: nothing exceeds them, errors come near them, and wrong renderers exceed
them."""

import itertools
import random
from dataclasses import replace

import numpy as np
import pytest

from tmap.base.fixed import ceil16
from tmap.corpus import polygon_sets
from tmap.fuzz import polygons as fuzz_polygons
from tmap.ideal import bounds, bounds_fetched
from tmap.ideal.bounds_coverage import FLOAT
from tmap.ideal.rows import Rows
from tmap.model import model
from tmap.model.model import Settings
from tmap.scene_file import textures
from tmap.setup import polygon as model_polygon, spans

WIDTH, HEIGHT = 320, 256
ALL = [Settings(edges, gradients, start) for edges, gradients, start in itertools.product(
    ("integer", "subpixel", "exact"), ("scanline", "polygon", "plane"), ("truncated", "subtexel"))]


def triangles(count: int) -> list[list[tuple]]:
    """Triangles of every named set, and random ones all over the frame."""
    sets = [p for name in polygon_sets.SHAPES for p in polygon_sets.polygons(name)[::4]]
    return sets + polygon_sets.random_triangles(count, seed=4)


def worst(settings: Settings, polygons) -> bounds.Verdict:
    """The combined verdict on polygons under one setting."""
    total = bounds.Verdict()
    for vertices in polygons:
        total.merge(bounds.judge(vertices, settings, WIDTH, HEIGHT))
    return total


@pytest.mark.parametrize("settings", ALL, ids=lambda s: f"{s.edges}-{s.gradients}-{s.start}")
def test_every_setting_keeps_its_bound(settings: Settings) -> None:
    """Errors stay within the bound and come near it: a bound that is never approached proves
    nothing."""
    found = worst(settings, triangles(40))
    assert not found.complaint
    assert 0.3 < found.texel_ratio <= FLOAT, found
    if settings.edges == "exact":
        assert not found.coverage_errors


@pytest.mark.parametrize("mapper", ["gouraud", "tiled", "columns", "generated"])
def test_every_mapper_keeps_its_bound(mapper: str) -> None:
    """The bound includes the bits that the mapper cuts off, and no more: under some setting it is
    nearly reached."""
    ratios = []
    for settings in ALL:
        found = worst(replace(settings, mapper=mapper), triangles(8))
        assert not found.complaint, (settings, found.complaint)
        ratios.append(found.texel_ratio)
    assert 0.9 < max(ratios) <= FLOAT, ratios


def carried(right):
    """Addresses by addition alone: if u leaves its row within a line, the texel is from the next
    row."""
    def fetched(line, mapper, size, stepped):
        columns, rows = right(line, mapper, size, stepped)
        seams = np.cumsum(np.abs(np.diff(columns, prepend=columns[:1])) > size[0] / 2)
        return columns, (rows + seams) % size[1]
    return fetched


def beside_once(right):
    """Shows the adjacent column at one pixel in the middle of each line."""
    def fetched(*given):
        columns, rows = right(*given)
        return columns + (np.arange(len(columns)) == len(columns) // 2), rows
    return fetched


@pytest.mark.parametrize("mapper, wrong", [
    *((mapper, carried) for mapper in ("affine", "tiled", "columns", "lit", "lit_gouraud", "dithered")),
    *((mapper, beside_once) for mapper in textures.MAPPERS[1] if mapper != "flat")])
def test_a_wrong_texel_is_caught(mapper: str, wrong, monkeypatch) -> None:
    """u and v are right, but the texel is a row too far behind a seam, or one pixel's column is
    wrong."""
    settings, inside = Settings(mapper=mapper), 256.0 if mapper == "arbitrary" else None
    polygons = [p for name in ("medium", "large") for p in polygon_sets.polygons(name, inside)[::4]]
    assert not worst(settings, polygons).complaint
    monkeypatch.setattr(spans, "fetched", wrong(spans.fetched))
    assert "the texel at pixel" in worst(settings, polygons).complaint


@pytest.mark.parametrize("perspective", ["every16", "pixel"])
def test_a_wrong_texel_in_perspective_is_caught(perspective: str, monkeypatch) -> None:
    """For polygons with depth, and for those drawn affine although w differs."""
    settings = Settings(perspective=perspective)
    deep = polygon_sets.polygons("depth")[::4]
    flat = [[(*v[:5], 65536 + (v[5] > p[0][5])) for v in p] for p in deep]
    right = spans.repeated
    for polygons, tolerance in ((deep, 0), (flat, 65536)):
        some = replace(settings, tolerance=tolerance)
        assert not worst(some, polygons).complaint
        with monkeypatch.context() as patch:
            patch.setattr(spans, "repeated", lambda values, side: right(values, side) + (
                np.arange(len(values)) % 50 == 25))
            assert "the texel at pixel" in worst(some, polygons).complaint


@pytest.mark.parametrize("first, last", [(0, 500), (0, 2040), (500, 0), (-700, -200), (-30, -800)])
def test_generated_code_beyond_its_row_is_caught(first: int, last: int, monkeypatch) -> None:
    """If generated code drew polygons whose u repeats, it would show other rows; the affine spans
    that draw them are exact."""
    settings = Settings("exact", mapper="generated")
    vertices = [tuple(c << 16 for c in corner) for corner in (
        (0, 0, first, 20, 0, 1), (256, 0, last, 37, 0, 1), (256, 200, last, 220, 0, 1))]
    found = bounds.judge(vertices, settings, WIDTH, HEIGHT)
    assert found.pixels and not found.complaint and found.texel_error < 0.01
    monkeypatch.setattr(model_polygon, "may_be_written", lambda *given: True)
    found = bounds.judge(vertices, settings, WIDTH, HEIGHT)
    assert found.pixels and not found.complaint and found.texel_error < 0.01
    monkeypatch.setattr(model_polygon, "stays_in_row", lambda line: True)
    assert "the exact v" in bounds.judge(vertices, settings, WIDTH, HEIGHT).complaint


def test_coverage_is_judged_on_the_edge_alone() -> None:
    """With exact edges a pixel on the wrong side of an edge is a complaint, and is counted."""
    vertices = [(x << 16, y << 16, 0, 0, 0, 65536) for x, y in ((0, 0), (8, 0), (0, 8))]
    good = bounds.judge(vertices, Settings("exact", mapper="flat"), 16, 16)
    assert (good.pixels, good.coverage_errors, good.complaint) == (36, 0, "")
    moved = [(x + 0x1000, *rest) for x, *rest in vertices]
    polygon = model.set_up([v[:4] for v in moved], 16, 16, False, Settings("exact", mapper="flat"))
    errors, complaint = bounds.check_coverage([v[:4] for v in vertices], polygon, Settings("exact"),
                                              16, 16)
    assert errors == 16 and "left out" in complaint and "0.0" in complaint


def test_ideal_is_defined_for_convex_polygons_only() -> None:
    """A polygon made concave by integer edges, or one that winds round twice, has no ideal."""
    square = [(0, 0, 0, 0), (ceil16(9 << 16) << 16, 0, 0, 0), (9 << 16, 9 << 16, 0, 0), (0, 9 << 16, 0, 0)]
    star = [square[0], square[2], square[1], square[3]]
    assert bounds.has_ideal(square) and not bounds.has_ideal(star)
    twice = square * 2
    assert not bounds.has_ideal(twice)
    dented = [square[0], square[0], square[1], square[1], (1, 1, 0, 0), square[3]]
    assert not bounds.has_ideal(dented)  # repeated vertices do not hide the concave corner
    assert not bounds.has_ideal([(1 << 30, 0, 0, 0), *square[1:3]])


def test_random_polygons_have_all_that_is_promised() -> None:
    """Every setting and mapper except units, planes for polygons that are judged, some of every
    difficulty."""
    some = [fuzz_polygons.polygon(9, k) for k in range(3000)]
    for kind, names in fuzz_polygons.SETTINGS.items():
        assert {getattr(p.settings, kind) for p in some} == set(names) - {"n64", "glide"}
    far = sum(any(abs(c) >= 1 << 30 for v in p.vertices for c in v[:4]) for p in some)
    assert 20 < far < 300
    assert {len(p.vertices) for p in some} >= set(range(3, 10))
    assert sum(not bounds.has_ideal([v[:4] for v in p.vertices]) for p in some) > 100
    rng = random.Random(1)
    plane = fuzz_polygons.plane_of(rng, [(0, 0), (1 << 29, 0), (1 << 29, 1 << 29), (0, 1 << 29)], 1 << 30)
    assert all(abs(c) < 1 << 30 for pair in plane for c in pair)


@pytest.mark.parametrize("off, allowed, word", [
    (-127.72, (127.74, 126.87), ""), (-127.72, (127.2, 126.87), "above"), (127.72, (126.87, 127.74), ""),
    (-3.0, (2.5, 2.5), "below"), (3.5, (2.5, 2.5), "above"), (-3.0, (3.0, 0.0), ""), (200.0, (0.0, 200.0), ""),
    (0.0, (0.0, 0.0), "")])
def test_a_texel_half_a_map_away_may_be_on_either_side(off: float, allowed, word: str) -> None:
    """The texel begins 0.9 below what is stepped: if that is 127.72 texels too low, the texel's middle is 128.12
    below the exact value, or 127.88 above it. Found by seed 32, polygon 9924."""
    values = np.array([(37 << 16) + 58982])
    out = bounds.Verdict()
    line = np.array([37]), values, np.array([off]), 256
    bounds_fetched.judge("v", *line, 3, 78, allowed, out)
    assert (word in out.complaint) if word else not out.complaint
    assert bounds_fetched.far_rows(Rows.of(np.array([3]), 78), *line, allowed).tolist() == [bool(word)]


#: Found by the fuzzer (seed 202 in perspective, 5286) and made smaller. x, y; 42 levels a pixel, from 3.5 to 64.
STEEP_LIGHT = [tuple(round(c * 65536) for c in (x, y, 0, 0, shade, 1))
               for x, y, shade in ((1, 555, 14.0977), (0, 0, 255.99998), (3.75, 857, 255.99998))]


def test_a_pixel_past_a_long_edge_moves_its_lines_light(monkeypatch) -> None:
    """Its level is 0.012 beyond the range. What holds it there moves the pixels inside by as much."""
    lit = Settings(mapper="lit_gouraud")
    assert not bounds.judge(STEEP_LIGHT, lit, 8, 1024).complaint
    monkeypatch.setattr(bounds, "past_edges", lambda *_: 0.0)
    assert "level at pixel (1, 457) is -0.012367" in bounds.judge(STEEP_LIGHT, lit, 8, 1024).complaint
