"""Lit polygons in perspective: texels first, then a pass of light; bit for bit the model's."""

import itertools
from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import guest_runs
from tests.helpers.guest_runs import Asked
from tmap.base.fixed import ONE
from tmap.base.paths import SCENES
from tmap.bench import rules
from tmap.bench.rules import TURNED, WIDE, Case, scene_of
from tmap.compiler.scene import compile_scene
from tmap.ideal import bounds
from tmap.model import model
from tmap.scene_file.scene_file import IDENTITY, SETTINGS, Material, Object, Scene
from tmap.setup import polygon
from tmap.setup.shading import LIT

SHADES, DEPTHS = (30, 120, 240), (1, 3, 2)
#: Triangles inside the frame, across two of its borders, and around it; a quad.
PLACES = (WIDE, [(-40, -30), (150, 60), (50, 200)], [(-300, -200), (500, 20), (60, 400)],
          [(10, 8), (150, 8), (110, 100), (50, 100)])


def deep(mapper: str, **settings) -> Material:
    return Material(mapper, texture=0, light=1, **{"perspective": "pixel"} | settings)


def corners(points) -> list[tuple[int, ...]]:
    """Vertices whose shades and 1/w change with x + y alone, so that they are planar."""
    ways = [x + y for x, y in points]
    made = []
    for (x, y), way in zip(points, ways):
        part = (way - min(ways)) / (max(ways) - min(ways))
        w = 1 / (1 - part * 3 / 4)
        made.append(tuple(round(c * ONE) for c in (x, y, x * w, 30 * w, 10 + 240 * part, w)))
    return made


def test_every_setting_is_the_models() -> None:
    """Each perspective with all edges, both ways of clipping, and with no rule."""
    made = [deep(mapper, perspective=perspective, edges=edges, clip=clip)
            for mapper, perspective, edges, clip in itertools.product(
                LIT, SETTINGS["perspective"][1:], SETTINGS["edges"], SETTINGS["clip"])]
    objects, vertices = [], []
    for number in range(len(made)):  # each edges and clip at every place
        points = PLACES[(number + number // 8) % len(PLACES)]
        objects.append(Object(number, len(vertices), len(points), 0, 1, number))
        vertices += corners(points)
    scene = Scene(rules.WIDTH, rules.HEIGHT, len(objects), 7, np.zeros((256, 3), np.uint8),
                  rules.textures("chunky"), made, objects, np.array(vertices), np.array([IDENTITY]))
    drawn = guest_runs.check_all({"lit": Asked(scene), "without rules": Asked(scene, off="all")})
    for each in drawn.values():
        assert each.spans >= {"light", "light_gouraud", "reciprocal"}
        for frame in each.figures:
            passes = sum(frame["spans"].get(kind, 0) for kind in ("light", "light_gouraud"))
            assert passes == frame["pixels"] > 100, frame


#: What a triangle is drawn by, all rules on: mapper, shades, depths, tolerance, spans, rules.
LOWERED = (
    ("lit", (100, 0, 0), DEPTHS, 0, {"cubic", "light"}, set()),
    ("lit", (3, 100, 200), DEPTHS, 0, {"fill"}, {"no_light"}),
    ("lit", (252, 0, 0), DEPTHS, 0, {"cubic"}, {"full_light"}),
    ("lit", (100, 0, 0), (2, 2, 2), 0, {"lit"}, {"constant_w", "no_wrap_lit"}),
    ("lit", (100, 0, 0), (4, 4.02, 4.01), 0.5, {"lit"}, {"tolerance", "no_wrap_lit"}),
    ("lit", (100, 0, 0), (4, 4.4, 4.2), 0.25, {"reciprocal", "light"}, {"coarser"}),
    ("lit_gouraud", SHADES, DEPTHS, 0, {"cubic", "light_gouraud"}, set()),
    ("lit_gouraud", (120.1, 121.9, 123.5), DEPTHS, 0, {"cubic", "light"}, {"equal_levels"}),
    ("lit_gouraud", (252, 253, 254), DEPTHS, 0, {"cubic"}, {"equal_levels", "full_light"}),
    ("lit_gouraud", (0, 1, 2), DEPTHS, 0, {"fill"}, {"equal_levels", "no_light"}),
    ("lit_gouraud", SHADES, (2, 2, 2), 0, {"lit_gouraud"}, {"constant_w"}),
    ("lit_gouraud", SHADES, (4, 4.02, 4.01), 0.5, {"lit_gouraud"}, {"tolerance"}),
    ("lit_gouraud", SHADES, (1, 12, 4), 0, {"cubic", "light_gouraud"}, set()),
    ("lit", (100, 0, 0), (1, 12, 4), 0, {"cubic", "light"}, set()))


def test_lowering() -> None:
    """Rules of light lead to a cheaper pass or to none, rules of depth to the affine lit spans."""
    cases = [Case("", deep(mapper, tolerance=round(tolerance * ONE), colour=k), WIDE, TURNED, None, None,
                  shades, depths)
             for k, (mapper, shades, depths, tolerance, *_) in enumerate(LOWERED)]
    drawn = guest_runs.check_all({"lowered": Asked(scene_of(cases))}, colours=0)["lowered"]
    for row, frame, material in zip(LOWERED, drawn.figures[1:], drawn.executed):
        assert (set(frame["spans"]), material["rules"].keys() - {"inside_frame"}) == row[-2:], row
        passes = [frame["spans"][kind] for kind in ("light", "light_gouraud") if kind in row[-2]]
        assert passes in ([], [frame["pixels"]]), row


def test_an_unsure_polygon_is_lit() -> None:
    """One whose depth varies too much for its planes is drawn by the affine lit spans, and counted."""
    points = [(50, 50), (50 + 1 / 65536, 50), (50, 50 + 1 / 65536)]
    cases = [Case("", deep(mapper, edges="exact"), points, ([0, 250, 0], [0, 0, 250]), None, None, SHADES,
                  (1, 16384, 2)) for mapper in LIT]
    drawn = guest_runs.check_all({"unsure": Asked(scene_of(cases))}, colours=0)["unsure"]
    for mapper, frame, material in zip(LIT, drawn.figures[1:], drawn.executed):
        assert material["unsure"] == 1 and sum(frame["spans"].values()) == 1, (mapper, frame, material)


def test_scene_with_meshes() -> None:
    """The passage: objects and meshes, cut by the near plane and the frame."""
    torch = Asked(compile_scene(SCENES / "torch.toml", 3))
    drawn = guest_runs.check_all({"torch": torch}, colours=50)["torch"]
    assert drawn.spans >= {"reciprocal", "light", "light_gouraud"}


@pytest.mark.parametrize("perspective", SETTINGS["perspective"][1:])
def test_wrong_levels_are_caught(perspective: str, monkeypatch) -> None:
    """Levels are within their bound of the exact plane; a quarter of one more is not."""
    settings = model.Settings("exact", perspective=perspective, mapper="lit_gouraud")
    vertices = Case("", deep("lit_gouraud"), WIDE, TURNED, None, None, SHADES, DEPTHS).vertices
    judged = bounds.judge(vertices, settings, rules.WIDTH, rules.HEIGHT)
    assert judged.pixels > 1000 and not judged.complaint
    right = polygon.light_lines

    def wrong(lines, *given) -> None:
        right(lines, *given)
        for line in lines:
            line.c += ONE // 4

    monkeypatch.setattr(polygon, "light_lines", wrong)
    assert "level at pixel" in bounds.judge(vertices, settings, rules.WIDTH, rules.HEIGHT).complaint


@pytest.mark.parametrize("mapper", LIT)
def test_light_follows_the_texels(mapper: str) -> None:
    """The model's picture is the unlit one, each pixel through its level's row of the table."""
    case = Case("", deep(mapper, edges="exact"), WIDE, TURNED, None, None, SHADES, DEPTHS)
    plain = replace(case, material=replace(case.material, mapper="affine", light=-1))
    lit, texels = (model.render(scene_of([each]), 1).astype(int) for each in (case, plain))
    light, inside = rules.textures("chunky")[1].texels, texels != 7
    (x0, y0), (x1, y1), (x2, y2) = WIDE
    y, x = np.indices(texels.shape)
    levels = [shade / 4 for shade in SHADES]
    b = ((x - x0) * (y2 - y0) - (x2 - x0) * (y - y0)) / ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0))
    c = ((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0))
    level = levels[0] + (b * (levels[1] - levels[0]) + c * (levels[2] - levels[0]) if mapper != "lit" else 0 * x)
    sure = inside & (abs(level - np.rint(level)) > 1 / 64)
    assert sure.sum() > 0.9 * inside.sum() > 1000
    assert (lit[sure] == light[level[sure].astype(int), texels[sure]]).all()
