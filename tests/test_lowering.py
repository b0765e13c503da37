"""Lowering: each rule saves cycles and leaves the picture as it is, and nothing else ran."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from tools import model, run
from tools.layout import load
from tools.scene_file import IDENTITY, ONE, Material, Object, Scene, Texture

WIDTH, HEIGHT = 160, 128
MACHINES = ("a1200", "a1200-fast")
#: 64 levels of 256 texels: the first makes all one, the last shows them as they are.
LIGHT = np.random.default_rng(3).integers(1, 256, (64, 256), dtype=np.uint8)
LIGHT[0], LIGHT[63] = 9, np.arange(256)
PAGE = np.random.default_rng(4).integers(10, 256, (256, 256), dtype=np.uint8)
TEXTURES = [Texture(PAGE), Texture(LIGHT, "light"), Texture(PAGE[:70, :90].copy(), "linear")]

AFFINE = Material("affine", texture=0)
LIT = Material("lit", texture=0, light=1)
LIT_GOURAUD = Material("lit_gouraud", texture=0, light=1)
GOURAUD = Material("gouraud")
FLAT = Material("flat", colour=77)
DEEP = Material("affine", perspective="pixel", texture=0)
ARBITRARY = Material("arbitrary", texture=2)


def corners(points, s, t, shade=None, w=None) -> list[tuple]:
    """Vertices from pixels, texels, shades and depths."""
    rows = zip(points, s, t, shade or [100] * len(points), w or [1] * len(points))
    return [tuple(round(c * ONE) for c in (*p, *rest)) for p, *rest in rows]


#: A triangle inside the frame.
POINTS = [(20.3, 10.6), (140.7, 50.2), (60.1, 120.4)]
TURNED = ([10, 120, 60], [15, 70, 130])  # s and t that need both steps, without a wrap


@dataclass(frozen=True)
class Case:
    """A polygon to which one rule applies."""

    rule: str
    material: Material
    vertices: list
    lowered: str | None  # the span that draws it then; None: nothing is drawn
    asked: str | None  # without the rule
    #: Machines on which the rule saves cycles.
    machines: tuple[str, ...] = MACHINES


CASES = [
    Case("outside", FLAT, corners([(200, 10), (260, 40), (180, 90)], [0] * 3, [0] * 3), None, None),
    Case("equal_shades", GOURAUD, corners(POINTS, [0] * 3, [0] * 3, [200.1, 200.9, 200.4]),
         "fill", "gouraud"),
    Case("equal_levels", LIT_GOURAUD, corners(POINTS, *TURNED, [120.1, 121.9, 123.5]),
         "lit", "lit_gouraud"),
    Case("no_light", LIT, corners(POINTS, *TURNED, [3.9, 100, 200]), "fill", "lit"),
    Case("full_light", LIT, corners(POINTS, *TURNED, [252, 0, 0]), "affine_addx", "lit"),
    Case("constant_w", DEEP, corners(POINTS, *TURNED, w=[3.7] * 3), "affine_addx",
         "affine_scanline"),
    Case("inside_frame", AFFINE, corners(POINTS, *TURNED), "affine_addx", "affine_addx"),
    Case("inside_range", ARBITRARY, corners(POINTS, [10, 150, 70], [15, 60, 100]),
         "arbitrary", "arbitrary"),
    Case("still_v", AFFINE, corners(POINTS, TURNED[0], [y for _, y in POINTS]),
         "affine_row", "affine_addx"),
    Case("still_u", AFFINE, corners(POINTS, [y for _, y in POINTS], TURNED[1]),
         "affine_column", "affine_addx"),
    Case("no_wrap", AFFINE, corners(POINTS, *TURNED), "affine_addx", "affine_addx_wrap",
         ("a1200-fast",)),  # in chip RAM the chain of three waits for the bus no longer
    Case("no_wrap_lit", LIT, corners(POINTS, *TURNED), "lit", "lit_wrap", ("a1200-fast",)),
]


def scene_of(cases: list[Case]) -> Scene:
    """A frame for each case."""
    materials = list(dict.fromkeys(case.material for case in cases))
    vertices = [vertex for case in cases for vertex in case.vertices]
    objects = [Object(materials.index(case.material), 3 * k, 3, 0, 1, k)
               for k, case in enumerate(cases)]
    palette = np.random.default_rng(1).integers(0, 256, (256, 3), dtype=np.uint8)
    return Scene(WIDTH, HEIGHT, len(cases), 7, palette, TEXTURES, materials, objects,
                 np.array(vertices), np.array([IDENTITY]))


def test_every_exact_rule_has_its_case():
    """But for those of tolerances, which change the picture."""
    rules = {name.removeprefix("RULE_").lower() for name in load().constants
             if name.startswith("RULE_")}
    assert rules - {"tolerance", "coarser"} == {case.rule for case in CASES}


@pytest.mark.parametrize("machine", MACHINES)
def test_each_rule_saves_cycles_and_nothing_else_changes(machine):
    """A frame a case: the same bytes with the rule and without it, other spans, fewer cycles."""
    scene = scene_of(CASES)
    on = run.render(scene, machine, "addx")
    for rule in dict.fromkeys(case.rule for case in CASES):
        off = run.render(scene, machine, "addx", rule)
        for k, case in enumerate(CASES):
            again = f"rule {rule}, frame {k} (a case of {case.rule}) on {machine}"
            assert np.array_equal(on.frames[k], off.frames[k]), again
            assert np.array_equal(on.frames[k], model.render(scene, k)), again
            if case.rule != rule:
                continue
            assert list(on.figures[k]["spans"]) == ([case.lowered] if case.lowered else []), again
            assert list(off.figures[k]["spans"]) == ([case.asked] if case.asked else []), again
            saved = off.figures[k]["cycles"] - on.figures[k]["cycles"]
            print(f"{machine} {rule}: {off.figures[k]['cycles']} -> {on.figures[k]['cycles']}")
            assert saved > 0 or machine not in case.machines, f"{again}: {saved} cycles saved"
        assert not any(rule in executed["rules"] for executed in off.executed)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.rule)
def test_counts_name_the_rule(case):
    """What was executed for the material says which rule it was."""
    executed, = run.render(scene_of([case]), "a1200-fast", "addx").executed
    assert executed["rules"][case.rule] == 1
    assert list(executed["spans"]) == ([case.lowered] if case.lowered else [])
    assert executed["polygons"] == (case.lowered is not None)
