"""The corpus of hard polygons: what it promises, and every case drawn by the 68020.

A case has up to 60 drawings: its mappers with their settings. ``make test`` draws a
quarter of them, chosen by the case's name, so that each mapper of each case is there and
all settings meet every family; HARD_CASES=all draws all.
"""

import os
import random
import re
from dataclasses import replace
from itertools import groupby
from math import ceil

import numpy as np
import pytest
from polygon_report import explain

from tools import emulator, hard_cases, ideal, model, scene_file
from tools.errors import UserError
from tools.hard_case import FAR
from tools.hard_cases import HEIGHT, WIDTH, Case

CASES = hard_cases.cases()
FRAMES = 1000  # a scene's most
PART = 1 if os.environ.get("HARD_CASES") == "all" else 4


def chosen(case: Case) -> list[hard_cases.Drawing]:
    """The case's drawings that are run: of each mapper every PART-th."""
    rng, drawings = random.Random(case.name), []
    for _, same in groupby(hard_cases.combinations(case), lambda settings: settings.mapper):
        ways = list(same)
        drawings += [(case, s) for s in rng.sample(ways, ceil(len(ways) / PART))]
    return drawings


ADDX = [drawing for case in CASES for drawing in chosen(case)]
#: Form to what it draws: the other mappers are the same in both.
DRAWINGS = {"addx": ADDX, "swap": [d for d in ADDX if d[1].mapper == "affine"][::4]}
RUNS = [(form, first) for form, drawings in DRAWINGS.items()
        for first in range(0, len(drawings), FRAMES)]


def called(drawing: hard_cases.Drawing) -> str:
    """A drawing's name in messages."""
    case, s = drawing
    return f"{case.name}: {case.sentence} {s.mapper}, {s.edges}, {s.gradients}, {s.start}, {s.clip}"


@pytest.mark.parametrize("form, first", RUNS)
def test_every_case_is_the_models(form: str, first: int) -> None:
    """No byte differs, none outside the frame is touched, no fault, no endless loop."""
    drawings = DRAWINGS[form][first:first + FRAMES]
    scene = hard_cases.scene(drawings)
    again = (f"{'HARD_CASES=all ' if PART == 1 else ''}.deps/venv/bin/python -m pytest -q "
             f"'tests/test_hard_cases.py::test_every_case_is_the_models[{form}-{first}]'")
    with emulator.workspace() as directory:
        try:
            end = emulator.run("render", f"input.scene FORM {form}",
                               {"input.scene": scene_file.write(scene)}, "a1200-fast",
                               directory).output.splitlines()[-1]
        except UserError as error:
            end = str(error)
        dumps = sorted((directory / "volume").glob("frame_*.chunky"))
        assert len(dumps) == len(drawings), (
            f"{called(drawings[len(dumps)])}\n  {end}\n  again: {again}")
        wrong = []
        for number, dump in enumerate(dumps):
            found = np.fromfile(dump, np.uint8).reshape(HEIGHT, WIDTH)
            if not np.array_equal(found, model.render(scene, number)):
                wrong.append((number, found))
    assert not wrong, (f"{len(wrong)} drawings are wrong, of the cases "
                       f"{', '.join(dict.fromkeys(drawings[n][0].name for n, _ in wrong))}\n"
                       + explain(scene, *wrong[0], called(drawings[wrong[0][0]]), again))


def test_names_say_which_case_it_is() -> None:
    """Unique names in snake_case, one sentence each."""
    names = [case.name for case in CASES]
    assert len(set(names)) == len(names)
    for case in CASES:
        assert re.fullmatch("[a-z0-9]+(_[a-z0-9]+)*", case.name), case.name
        assert re.fullmatch(r"[A-Z0-9](?:[^.\n]|\.\d)*\.", case.sentence), case.sentence


def test_every_family_is_there() -> None:
    """All that issue 4 names has its own family, and together they concern every mapper."""
    families = {family.__name__: len(list(family())) for family in hard_cases.FAMILIES}
    assert families.keys() == {
        "slivers", "needles", "without_area", "repeated_vertices", "inside_one_pixel",
        "collinear_vertices", "on_centres", "level_edges", "between_lines", "slopes", "sizes",
        "off_screen", "at_the_border", "vertex_counts", "windings", "nearly_concave", "long_edges",
        "far_outside", "on_texel_borders", "gradients", "mirrored", "seams",
        "up_to_the_last_texel", "shades", "long_spans", "map_sizes"}
    assert min(families.values()) >= 5
    assert {m for case in CASES for m in case.mappers} == set(scene_file.MAPPER_LAYOUT)


def test_vertices_are_what_the_format_takes() -> None:
    """3 to 64, every coordinate in range."""
    for case in CASES:
        assert 3 <= len(case.vertices) <= 64, case.name
        assert all(-FAR << 16 <= c < FAR << 16 for v in case.vertices for c in v), case.name


def test_textures_are_planar() -> None:
    """s, t and shade of every vertex lie on the plane of three: each of the four is rounded by
    half a unit, and a plane through three corners doubles that at most."""
    planar = 0
    for case in CASES:
        a, b, c = (case.vertices[k] for k in ideal.corners(case.vertices))
        area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
        if len(case.vertices) == 3 or not area:
            continue
        planar += 1
        for noun, k in (("s", 2), ("t", 3), ("shade", 4)):
            plane = ideal.Plane((a[:2], b[:2], c[:2]), (a[k], b[k], c[k]))
            for x, y, *rest in case.vertices:
                exact = plane.nx * (x - plane.x0) + plane.ny * (y - plane.y0)
                off = rest[k - 2] - plane.value0 - exact / plane.d
                assert abs(off) <= 2.5, f"{case.name}: {noun} at {x}, {y} is {off} units off"
    assert planar > 100


def test_kept_case_joins_the_corpus(tmp_path, monkeypatch) -> None:
    """Sorted by name, read back as it was; a name that exists is refused, and nothing written."""
    monkeypatch.setattr(hard_cases, "FOUND", tmp_path / "hard_cases.json")
    assert hard_cases.found_cases() == []
    later, earlier = (replace(CASES[0], name=name, mappers=("flat", "columns"), map_size=(8, 16))
                      for name in ("found_b", "found_a"))
    hard_cases.keep(later)
    hard_cases.keep(earlier)
    assert hard_cases.found_cases() == [earlier, later] == hard_cases.cases()[-2:]
    text = hard_cases.FOUND.read_text()
    for name in ("found_a", CASES[0].name):
        with pytest.raises(UserError, match=f"there is a case called {name} already"):
            hard_cases.keep(replace(earlier, name=name))
    assert hard_cases.FOUND.read_text() == text
