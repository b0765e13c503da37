"""The hard meshes: the emulated Amiga draws them as the model does, within the bounds of exact
faces.

``make test`` draws a quarter of the combinations of each case, chosen by its name; HARD_CASES=all
draws all.
"""

import os
import random
from dataclasses import replace
from math import ceil

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tmap.accuracy import hard_mesh_report, hard_report
from tmap.accuracy.hard_mesh_report import combinations, judge
from tmap.build import layout
from tmap.corpus import hard_meshes
from tmap.corpus.hard_case import UNIT
from tmap.ideal import faces as ideal_faces
from tmap.model import mesh
from tmap.scene_file import meshes, scene_file

CASES = hard_meshes.cases()
BY_NAME = {case.name: case for case in CASES}
PART = 1 if os.environ.get("HARD_CASES") == "all" else 4
#: Cases that show nothing, or only what rounding explains.
UNSEEN = {"mesh_face_1_unit_behind_the_near_plane", "mesh_beside_the_view", "mesh_ball_within_a_pixel",
          "mesh_wall_4_units_aside"} | {
    f"mesh_plane_{where}_the_eye"
    for where in ("1_unit_above", "through", "1_unit_below", "64_units_below")} | {
    f"mesh_leaning_{lean}_units_above" for lean in (1, 64)}
#: The eye is so near to the face's plane that its planes of 1/w are not precise enough: it is drawn
#: affine.
UNSURE = {"mesh_wall_4_units_aside_askew"}


def chosen(case) -> list:
    ways = combinations(case)
    return [(case, s) for s in random.Random(case.name).sample(ways, ceil(len(ways) / PART))]


def test_every_case_is_the_models_and_keeps_its_bound() -> None:
    """Frames are the model's bit for bit; every pixel and texel is as near to the exact faces as
    derived."""
    drawings = [drawing for case in CASES for drawing in chosen(case)]
    rows = hard_report.measure_meshes(drawings, "a1200-fast")
    wrong = [f"{hard_mesh_report.called(*drawing)}: {row.complaint}"
             for drawing, row in zip(drawings, rows, strict=True) if row.complaint]
    assert not wrong, "\n".join([f"{len(wrong)} drawings exceed a bound", *wrong[:20]])
    shown = {row.case for row in rows if row.pixels}
    assert shown == BY_NAME.keys() - UNSEEN
    assert sum(row.texel_bound is not None for row in rows) > len(rows) / 3
    assert max(row.worst_ratio or 0 for row in rows) > 0.1  # the bounds are not too wide


def test_families_are_what_the_scenes_need() -> None:
    """Near planes, faces seen edge on, guard bands, horizons, walls past the eye, tiny and huge
    faces, order, normals: each is a family; all names differ."""
    families = {family.__name__: len(list(family())) for family in hard_meshes.FAMILIES}
    assert families.keys() == {"near_planes", "edge_on", "guard_bands", "horizons", "grazing",
                               "tiny_and_huge", "orders", "normals"}
    assert min(families.values()) >= 4
    assert len(BY_NAME) == len(CASES)
    assert {case.look for case in CASES} == {"uv", "environment", "shade"}


def test_scenes_are_what_the_format_takes() -> None:
    """Every case can be written; points are exact, turns are rotations."""
    for case in CASES:
        made = hard_mesh_report.scene(case, combinations(case), np.zeros((256, 256), np.uint8))
        scene_file.write(made)
        assert all((c / UNIT).denominator == 1 for point in case.points for c in point)
        rows = case.turn
        assert all(ideal_faces.dot(a, b) == (a is b) for a in rows for b in rows), case.name
        faces = ideal_faces.exact_faces(made, made.instances[0], hard_mesh_report.camera(case))
        assert all(face.is_flat() for face in faces), case.name


def scene_of(name: str):
    """A scene of the case with its first combination."""
    return hard_mesh_report.scene(BY_NAME[name], combinations(BY_NAME[name])[:1],
                                  np.zeros((256, 256), np.uint8))


def borders_of(name: str) -> set[int]:
    """The borders that corners of a case are outside of, according to the model."""
    made = scene_of(name)
    points = mesh.transform(made, made.points.tolist(), made.views[0].tolist())
    depths = [mesh.depths(p.x, p.y, p.w, made.near_plane) for p in points]
    return {k for border in depths for k, depth in enumerate(border) if depth < 0}


@pytest.mark.parametrize("name, borders", [
    ("mesh_floor_behind_the_eye", {0, 1, 2, 3, 4}), ("mesh_corner_1_unit_behind_the_near_plane", {0}),
    ("mesh_corner_on_the_near_plane", set()), ("mesh_out_of_the_guard_band_left", {1}),
    ("mesh_out_of_the_guard_band_right", {2}), ("mesh_out_of_the_guard_band_above", {3}),
    ("mesh_out_of_the_guard_band_below", {4}), ("mesh_out_of_the_guard_band_everywhere", {1, 2, 3, 4}),
    ("mesh_edge_inside_the_guard_band", set()), ("mesh_edge_on_the_guard_band", set()),
    ("mesh_edge_outside_the_guard_band", {2}), ("mesh_ball_of_small_faces", set())])
def test_borders_are_crossed_as_the_names_say(name: str, borders: set[int]) -> None:
    """Borders are near, left, right, above, below; a unit decides."""
    assert borders_of(name) == borders


def test_planes_near_the_eye_are_what_the_names_say() -> None:
    """Planes are seen from the front if the eye is above them by more than rounding; within
    rounding either is right."""
    for name, height in (("mesh_plane_1_unit_above_the_eye", -1), ("mesh_plane_through_the_eye", 0),
                         ("mesh_plane_1_unit_below_the_eye", 1), ("mesh_plane_64_units_below_the_eye", 64)):
        made = scene_of(name)
        face, = ideal_faces.exact_faces(made, made.instances[0], hard_mesh_report.camera(BY_NAME[name]))
        assert face.height == pytest.approx(height / meshes.ONE, abs=1e-12)
        seen = mesh.is_seen(made.faces[0].tolist(), made.views[0].tolist())
        assert seen == (height > 0) or abs(height) < 3
    for lean in (1, 64):
        assert judge(BY_NAME[f"mesh_leaning_{lean}_units_below"], combinations(CASES[0])[:1])[0].pixels > 30


def test_only_planes_that_are_not_sure_are_drawn_affine() -> None:
    """Of all hard meshes this is one: a wall 1/16,000 beside the eye."""
    fine = [s for s in combinations(CASES[0]) if s.perspective == "fine"]
    kinds = "mesh_wall", "mesh_near", "mesh_floor", "mesh_ring"
    grazing = [case for case in CASES if case.name.startswith(kinds)]
    assert {case.name for case in grazing if judge(case, fine)[0].unsure} == UNSURE


def test_faces_drawn_affine_are_counted() -> None:
    """The guest says so: the wall beside the eye is one, another wall none."""
    fine = [s for s in combinations(CASES[0]) if s.perspective == "fine"][:1]
    names = [*sorted(UNSURE), "mesh_wall_256_units_aside_askew"]
    asked = [Asked(hard_mesh_report.scene(BY_NAME[name], fine, np.zeros((256, 256), np.uint8))) for name in names]
    assert [sum(of["unsure"] for of in drawn.executed) for drawn in guest_runs.draw(asked)] == [1, 0]


WRONG = {  # the errors that a wrong renderer adds to a corner
    "beside by 1/16 pixel": lambda x: (4096, 0, 0, 0, 0, 0),
    "below by 1/16 pixel": lambda x: (0, 4096, 0, 0, 0, 0),
    "deeper by 1/64 on the right": lambda x: (0, 0, 0, 0, 0, 1024 * (x > 64 << 16)),
    "1/8 texel further": lambda x: (0, 0, 8192, 0, 0, 0),
    "half a shade lighter": lambda x: (0, 0, 0, 0, 32768, 0)}


@pytest.mark.parametrize("wrong", WRONG)
def test_a_wrong_renderer_is_found(wrong: str, monkeypatch) -> None:
    """The comparison with exact faces alone finds the error, in at least one case."""
    right = mesh.faces_of

    def changed(*arguments):
        return [(depth, [tuple(c + way for c, way in zip(v, WRONG[wrong](v[0]))) for v in vertices], which)
                for depth, vertices, which in right(*arguments)]

    monkeypatch.setattr(mesh, "faces_of", changed)
    cases = [BY_NAME[name] for name in ("mesh_corridor_middle_askew", "mesh_shade_of_a_ball")]
    ways = [s for s in combinations(cases[0]) if s.perspective == "fine"], combinations(cases[1])[:1]
    assert any(verdict.complaint for case, way in zip(cases, ways) for verdict in judge(case, way))


def test_a_face_too_many_or_left_out_is_found(monkeypatch) -> None:
    """A face drawn although seen from the back, and a visible face not drawn."""
    box = BY_NAME["mesh_box_before_a_wall"]
    flat = combinations(box)[:1]
    assert not judge(box, flat)[0].complaint
    for seen, said in ((lambda *_: True, "behind its plane"), (lambda *_: False, "left out")):
        monkeypatch.setattr(mesh, "is_seen", seen)
        assert said in judge(box, flat)[0].complaint


def test_cracks_are_found() -> None:
    """Removes each face of a box around the eye."""
    box = BY_NAME["mesh_box_around_the_eye"]
    flat = combinations(box)[:1]
    assert not judge(box, flat)[0].complaint
    for k in range(6):
        less, only = (replace(box, faces=tuple(box.faces[n] for n in kept),
                              texels=tuple(box.texels[n] for n in kept))
                      for kept in ([n for n in range(6) if n != k], [k]))
        left_out = "leaves pixels out" in judge(less, flat)[0].complaint
        assert left_out == (judge(only, flat)[0].pixels > 0)


def test_limits_are_the_formats() -> None:
    """The family's constants are those of the format."""
    limits = layout.load().constants
    assert hard_meshes.REACH == limits["MESH_REACH"]
    assert hard_meshes.NEAREST * meshes.ONE == limits["W_MIN"]
