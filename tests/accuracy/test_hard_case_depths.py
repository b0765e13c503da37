"""The hard depths: the properties of their vertices, and how they are drawn."""

from dataclasses import replace
from fractions import Fraction

import numpy as np

from tests.helpers.surfaces import off_surface
from tmap.accuracy import hard_report
from tmap.corpus import hard_cases, hard_depths
from tmap.corpus.hard_depths import DEEPEST, NEAREST
from tmap.ideal import bounds, ideal, perspective
from tmap.model import model
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import ONE

CASES = [case for family in hard_depths.FAMILIES for case in family()]
W_MIN, W_MAX = NEAREST * ONE, DEEPEST * ONE
BY_NAME = {case.name: case for case in CASES}


def adapted(case: hard_cases.Case) -> list[tuple]:
    """(x, y, u, v, w) on a map of 256x256."""
    return model.adapt(case.vertices, model.Settings("exact"), 256)


def test_all_are_defined_and_most_show() -> None:
    """Every vertex is in front of the viewer, except in the case without area."""
    shown = 0
    for case in CASES:
        vertices = adapted(case)
        assert perspective.in_front(vertices) == (case.name != "deep_without_area"), case.name
        shown += bool(ideal.coverage(vertices, hard_cases.WIDTH, hard_cases.HEIGHT).any())
    assert shown > 0.9 * len(CASES)


def test_all_vertices_are_on_the_surface_of_three() -> None:
    """The vertices are as near to the surface as tools/tmap/corpus/hard_depths.py derives, in exact
    fractions."""
    several = [case for case in CASES if len(case.vertices) > 3]
    for case in several:
        for what, off, allowed in off_surface(adapted(case), Fraction(1, 2)):
            assert off <= allowed, f"{case.name}: {what} is {float(off)} off, not {float(allowed)}"
    assert len(several) > 60


def test_depths_are_what_the_families_say() -> None:
    """Extremes of w in one polygon and in one span, constants, differences of a unit."""
    def ratio(name: str) -> Fraction:
        return perspective.depth_ratio(adapted(BY_NAME[name]))

    assert ratio("all_depths_in_a_span") == ratio("near_plane_on_screen") == W_MAX / W_MIN == 1 << 22
    steep = [case for case in CASES if case.name.startswith("1_to_1000")]
    assert len(steep) > 1
    for case in steep:  # each w is 256 units or more, rounded by half a unit
        ratio_of_line = perspective.curves(adapted(case))[0].ratio(0, hard_cases.WIDTH, 30)
        assert abs(ratio_of_line - 1000) < 1000 * Fraction(2, 511), case.name
    for k, family in enumerate((hard_depths.constant_depths, hard_depths.hardly_deep)):
        for case in family():
            depths = [v[5] for v in case.vertices]
            assert (max(depths) > min(depths)) == k, case.name
            assert 100 * (max(depths) - min(depths)) <= max(depths), case.name
    assert {v[5] for case in hard_depths.constant_depths() for v in case.vertices} >= {W_MIN, W_MAX}
    below = [v for v in BY_NAME["near_plane_below_two_near"].vertices if v[5] == W_MIN]
    assert len(below) == 2 and min(abs(v[0]) for v in below) > 16000 * ONE


def test_vanishing_values_are_what_the_names_say() -> None:
    """The values are exact to the unit: all numbers of these corners are representable in 16.16."""
    for name, wanted in (("vanishing_at_0_right", 0), ("vanishing_at_128_left", 128 * ONE),
                         ("vanishing_at_16777215_units_left", 256 * ONE - 1),
                         ("vanishing_at_minus_1000_right", -1000 * ONE)):
        assert [c.vanishing() for c in perspective.curves(adapted(BY_NAME[name]))] == [wanted] * 2
    far = perspective.curves(adapted(BY_NAME["vanishing_190000_texels_away"]))[0]
    assert abs(far.vanishing()) > 1 << 32


def test_every_perspective_is_combined() -> None:
    """Combined with edges that have an ideal, clipped or not; scenes of them can be written."""
    perspectives = scene_file.SETTINGS["perspective"]
    case = BY_NAME["corridor_left"]
    made = list(hard_cases.combinations(case))
    assert len(made) == len(set(made)) == 2 * 2 * len(perspectives) + 2 * len(perspectives)
    assert {(s.mapper, s.gradients, s.start) for s in made} == {
        (mapper, "plane", "subtexel") for mapper in ("affine", "lit", "lit_gouraud")}
    assert {s.edges for s in made} == {"subpixel", "exact"}
    for mapper in case.mappers:
        assert {s.perspective for s in made if s.mapper == mapper} == set(
            perspectives if mapper == "affine" else perspectives[1:])
    every = [(case, s) for case in CASES[::7] for s in hard_cases.combinations(case)]
    scene_file.write(hard_cases.scene(every))


def test_pictures_have_the_perspective() -> None:
    """In the exact picture of a case each texel is that of the curves; without perspective, of the
    plane. Both have the ideal's outline."""
    case, settings = BY_NAME["square_turned_half"], model.Settings("exact", perspective="fine")
    vertices, texels = adapted(case), np.arange(65536).reshape(256, 256) % 251
    three = [vertices[k] for k in ideal.corners(vertices)]
    affine = [ideal.Plane([v[:2] for v in three], [v[k] for v in three]) for k in (2, 3)]
    inside = ideal.coverage(vertices, hard_cases.WIDTH, hard_cases.HEIGHT) > 0
    pictures = []
    for planes, way in ((perspective.curves(vertices), "fine"), (affine, "none")):
        found = hard_report.exact_picture(vertices, replace(settings, perspective=way), texels)
        assert np.array_equal(found >= 0, inside) and inside.sum() > 500
        for y, x in np.argwhere(inside).tolist():
            u, v = (int(plane.at(x << 16, y << 16) // ONE) for plane in planes)
            assert found[y, x] == texels[v % 256, u % 256]
        pictures.append(found)
    assert (pictures[0] != pictures[1]).sum() > 300


def test_bounds_are_kept() -> None:
    """Drawn affine for want of precision is one triangle of a unit. Its only pixel is right, apart
    from the amount by which its plane is raised, 2 (gx + gy) way / 2^32 with gradients of 2^24
    texels a pixel and a way of 2 pixels: it is judged against the curve. Where a line ends at the
    tables' last entry (one_farther_at_the_top) the larger weight becomes 2^32 by the rounding of
    steps: the bound uses the smaller one."""
    unsure = {}
    for case in CASES:
        for way in ("fine", "pixel") if perspective.in_front(adapted(case)) else ():
            settings = model.Settings("exact" if way == "fine" else "subpixel", perspective=way)
            verdict = bounds.judge(case.vertices, settings, hard_cases.WIDTH, hard_cases.HEIGHT)
            assert not verdict.complaint, f"{case.name}, {way}: {verdict.complaint}"
            if way == "fine" and verdict.unsure:
                unsure[case.name] = verdict.texel_error
    assert unsure.keys() == {"deep_triangle_1_unit_1_to_16384"} and max(unsure.values()) < 1 / 64
