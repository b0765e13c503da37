"""The corpus of hard polygons: its properties, and every case drawn by the 68020.

A case has up to 60 drawings: its mappers with their settings. ``make test`` draws a quarter of
them, chosen by the case's name, so that each mapper of each case is included and all settings are
combined with every family; HARD_CASES=all draws all.
"""

import json
import os
import random
import re
from dataclasses import replace
from itertools import groupby
from math import ceil

import pytest
from PIL import Image

from tmap.accuracy import hard_report
from tmap.base.errors import UserError
from tmap.build import layout
from tmap.corpus import hard_cases, hard_meshes, hard_planes
from tmap.corpus.hard_case import LIMIT
from tmap.corpus.hard_cases import HEIGHT, WIDTH, Case
from tmap.ideal import ideal
from tmap.scene_file import scene_file

CASES = hard_cases.cases()
PART = 1 if os.environ.get("HARD_CASES") == "all" else 4


def chosen(case: Case) -> list[hard_cases.Drawing]:
    """The case's drawings to run: every PART-th of each mapper."""
    rng, drawings = random.Random(case.name), []
    for _, same in groupby(hard_cases.combinations(case), lambda settings: settings.mapper):
        ways = list(same)
        drawings += [(case, s) for s in rng.sample(ways, ceil(len(ways) / PART))]
    return drawings


DRAWINGS = [drawing for case in CASES for drawing in chosen(case)]


def test_every_case_is_the_models_and_keeps_its_bound() -> None:
    """No byte differs, none outside the frame is written, no fault, no endless loop. A drawing with
    an exact ideal is as near to it as tools/tmap/ideal/bounds.py derives."""
    rows = hard_report.measure(DRAWINGS, "a1200-fast", timed=False)
    wrong = [f"{hard_report.called(*drawing)}: {row.complaint}"
             for drawing, row in zip(DRAWINGS, rows) if row.complaint]
    assert not wrong, "\n".join([f"{len(wrong)} drawings exceed a bound", *wrong[:20]])
    judged = [row for row in rows if row.coverage_errors is not None]
    assert len(judged) > 0.8 * len(rows)
    assert not any(row.coverage_errors for row in judged if row.edges == "exact")


def test_the_other_form_draws_the_same() -> None:
    """Only the affine mapper: the others have one form."""
    hard_report.cycles([d for d in DRAWINGS if d[1].mapper == "affine"][::4], "a1200-fast", "swap",
                       timed=False)


def test_page_shows_every_case(tmp_path, monkeypatch) -> None:
    """The page has a section, a picture and all rows of every case; an excess is marked."""
    some, meshes = CASES[::60], hard_meshes.cases()[::25]
    monkeypatch.setattr(hard_cases, "cases", lambda: some)
    monkeypatch.setattr(hard_meshes, "cases", lambda: meshes)
    rows = hard_report.write(tmp_path / "hard", "a1200-fast", "On a <test> machine.")
    text = (tmp_path / "hard" / "index.html").read_text()
    assert "On a &lt;test&gt; machine." in text and "none exceeds its bound" in text
    cases = [*some, *meshes]
    assert text.count("<section") == len(cases) and text.count("<tr>") == len(rows) + len(cases)
    for case in cases:
        assert f'<h2>{case.name}</h2>' in text
        with Image.open(tmp_path / "hard" / f"{case.name}.png") as picture:
            assert picture.size == (hard_report.SCALE * (3 * WIDTH + 8), hard_report.SCALE * HEIGHT)
    kept = json.loads((tmp_path / "hard" / "hard.json").read_text())["rows"]
    assert len(kept) == len(rows) and max(row["cycles"] for row in kept) > 10_000
    assert all(row["cycles"] >= 0 for row in kept)
    rows[0].complaint = "too far"
    assert "1 exceed a bound" in hard_report.page(rows, "")


def test_names_say_which_case_it_is() -> None:
    """Names are unique and in snake_case; each case has one sentence."""
    names = [case.name for case in CASES]
    assert len(set(names)) == len(names)
    for case in CASES:
        assert re.fullmatch("[a-z0-9]+(_[a-z0-9]+)*", case.name), case.name
        assert re.fullmatch(r"[A-Z0-9](?:[^.\n]|\.\d)*\.", case.sentence), case.sentence


def test_families() -> None:
    """Each kind of outline, texture and depth has some cases, and together they cover every
    mapper."""
    families = {family.__name__: len(list(family())) for family in hard_cases.FAMILIES}
    assert len(families) == len(hard_cases.FAMILIES) > 40 and min(families.values()) >= 5, families
    assert {m for case in CASES for m in case.mappers} == set(scene_file.MAPPERS[1])


def test_vertices_are_what_the_format_takes() -> None:
    """3 to 64 vertices, every coordinate and depth in range."""
    limits = layout.load().constants
    for case in CASES:
        assert 3 <= len(case.vertices) <= 64, case.name
        assert all(-LIMIT << 16 <= c < LIMIT << 16 for v in case.vertices for c in v[:5]), case.name
        assert all(limits["W_MIN"] <= v[5] <= limits["W_MAX"] for v in case.vertices), case.name
        assert case.depth or all(v[5] == scene_file.ONE for v in case.vertices), case.name


def test_textures_are_planar() -> None:
    """s, t and shade of every vertex are on the plane of three vertices, within 2 units: the vertex
    is rounded by half a unit, and the errors of the three count times its barycentric coordinates,
    whose sizes add up to 3 at most if no vertex is higher, lower or farther from the first two than
    they are. Cases that are not meant to be planar are not checked."""
    planar, uneven = 0, {case.name for family in hard_planes.FAMILIES for case in family()}
    for case in CASES:
        a, b, c = (case.vertices[k] for k in ideal.corners(case.vertices))
        area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
        if len(case.vertices) == 3 or not area or case.depth or case.name in uneven:
            continue
        planar += 1
        for noun, k in (("s", 2), ("t", 3), ("shade", 4)):
            plane = ideal.Plane((a[:2], b[:2], c[:2]), (a[k], b[k], c[k]))
            for vertex in case.vertices:
                off = vertex[k] - plane.at(*vertex[:2])
                assert abs(off) <= 2, f"{case.name}: {noun} at {vertex[:2]} is {float(off)} units off"
    assert planar > 100


def test_kept_case_joins_the_corpus(tmp_path, monkeypatch) -> None:
    """Cases are sorted by name and read back unchanged; a name that exists is refused, and nothing
    is written."""
    monkeypatch.setattr(hard_cases, "FOUND", tmp_path / "hard_cases.json")
    assert hard_cases.found_cases() == []
    later, earlier = (replace(CASES[0], name=name, mappers=("flat", "columns"), map_size=(8, 16),
                               depth=name == "found_a")
                      for name in ("found_b", "found_a"))
    hard_cases.keep(later)
    hard_cases.keep(earlier)
    assert hard_cases.found_cases() == [earlier, later] == hard_cases.cases()[-2:]
    text = hard_cases.FOUND.read_text()
    for name in ("found_a", CASES[0].name):
        with pytest.raises(UserError, match=f"there is a case called {name} already"):
            hard_cases.keep(replace(earlier, name=name))
    assert hard_cases.FOUND.read_text() == text
