"""Lowering: each rule selects its cheaper span, leaves the picture unchanged, and nothing else
runs."""

import random
from dataclasses import replace

import numpy as np
import pytest

from tmap.bench import rules as bench_rules
from tmap.bench.rules import AFFINE, CASES, DEEP, GROUPS, TURNED, WIDE, Case
from tmap.build import layout
from tmap.fuzz import polygons as fuzz_polygons
from tmap.guest import emulator, guest_frames
from tmap.ideal import bounds
from tmap.model import model
from tmap.run import run
from tmap.scene_file.scene_file import ONE, write
from tmap.setup import tolerance
from tmap.setup.polygon import set_up

MACHINE = "a1200-fast"
SEED, BLOCKS, COUNT = 6, 3, 400


def test_every_exact_rule_has_its_case():
    """Rules with a tolerance change the picture; they are tested below."""
    rules = set(layout.load().names("RULE_")) - set(bench_rules.INEXACT)
    units = {rule for rule in rules if rule.startswith(("n64_", "glide_"))}  # tests/{n64,glide}/test_polygons.py
    assert rules - units == {case.rule for case in CASES}


@pytest.mark.parametrize("cases", GROUPS, ids=lambda group: f"{group[0].pixels}-{group[0].rule}")
def test_counts_show_that_nothing_else_ran(cases):
    """With each rule on and off, checks the spans of its frame and whether the rule was counted.
    Perspective rules are in their own group: the others would build its tables in every run."""
    scene = bench_rules.scene_of(cases)
    ways = [None] + [case.rule for case in cases]
    commands = ["render rules.scene COUNT" + (f" OFF {rule}" if rule else "") for rule in ways]
    with emulator.workspace() as directory:
        done = emulator.run_batch(commands, {"rules.scene": write(scene)}, MACHINE, directory, timed=False)
    parsed = [run.parse_output(each.output, scene.frames, len(scene.materials)) for each in done]
    (figures, executed), *others = parsed
    for number, (case, (without, executed_without)) in enumerate(zip(cases, others), 1):
        spans = figures[number]["spans"], without[number]["spans"]
        wanted = [[kind] if kind else [] for kind in (case.lowered, case.asked)]
        assert [list(found) for found in spans] == wanted, case.rule
        counted = executed[scene.materials.index(case.material)]["rules"]
        assert counted.get(case.rule, 0) >= 1, f"{case.rule} was not counted: {counted}"
        assert not any(case.rule in each["rules"] for each in executed_without), case.rule
        changed = [k for k in range(1, scene.frames) if figures[k]["spans"] != without[k]["spans"]]
        assert all(cases[k - 1].material.mapper == case.material.mapper
                   or cases[k - 1].lowered == case.lowered for k in changed), (case.rule, changed)


def calls_for_less(rng: random.Random, each: fuzz_polygons.Fuzzed) -> fuzz_polygons.Fuzzed:
    """Changes the polygon so that a rule or two may apply."""
    vertices = np.array(each.vertices, dtype=object)
    if rng.random() < 0.4:
        vertices[:, 4] = rng.choice((0, 3 * ONE, 100 * ONE + 5, 252 * ONE, 256 * ONE - 1))
    if rng.random() < 0.5:
        vertices[:, 5] = rng.choice((ONE, 5 * ONE + 3))
    column, along = rng.choice(((2, 1), (3, 1), (2, 0)))  # s = y, t = y or s = x, plus a constant
    if rng.random() < 0.5 and abs(vertices[:, along]).max() < fuzz_polygons.FAR // 2:
        vertices[:, column] = vertices[:, along] + rng.randrange(256 * ONE)
        if column == 2 and along == 0:
            vertices[:, 3] = vertices[:, 1]
    if each.settings.mapper == "arbitrary":  # stays inside its map
        vertices[:, 2:4] = np.array(each.vertices, dtype=object)[:, 2:4]
    return replace(each, vertices=tuple(map(tuple, vertices.tolist())),
                   settings=replace(each.settings, tolerance=0))


def test_random_scenes_are_the_same_without_rules():
    """With all rules and with none: the same digests, and, of one block, fewer cycles in total with rules."""
    rng = random.Random("lowering")
    scenes = []
    for block in range(BLOCKS):
        polygons = [calls_for_less(rng, fuzz_polygons.polygon(SEED, block * fuzz_polygons.BLOCK + k))
                    for k in range(COUNT)]
        scenes.append(fuzz_polygons.scene(SEED, block, polygons))
    drawn = [pair for some, timed in ((scenes[:1], True), (scenes[1:], False)) for pair in zip(*(
        guest_frames.draw([(scene, way) for scene in some], MACHINE, timed=timed) for way in ("addx", "addx OFF all")))]
    spent = [0, 0]
    for block, (on, off) in enumerate(drawn):
        for field in ("sum", "hash", "result"):
            wrong = np.flatnonzero(on[field] != off[field])
            assert not len(wrong), (f"seed {SEED}, block {block}, polygon {wrong[0]}: {field} is "
                                    f"{on[field][wrong[0]]} with rules, {off[field][wrong[0]]} without; "
                                    f"{scenes[block].materials[scenes[block].objects[wrong[0]].material]}")
        spent = [spent[0] + int(on["ticks"].sum()), spent[1] + int(off["ticks"].sum())]
    assert spent[0] < spent[1], spent


#: w of a triangle's vertices, the tolerance in texels, the rule that applies, the spans it selects.
TOLERANT = (((4, 4.02, 4.01), 0.5, "tolerance", {"affine_addx"}),
            ((4, 4.02, 4.01), 0.01, None, {"perspective_pieces"}),
            ((4, 4.4, 4.2), 0.25, "coarser", {"reciprocal"}),
            ((2, 5, 3), 1.0, None, {"cubic"}))


def test_tolerances_are_kept_and_pay():
    """If the derived error allows it, less perspective is used: cheaper, equal to the model's
    picture, and within the tolerance of the exact one. Otherwise the picture does not change."""
    cases = [Case("tolerance", replace(DEEP, tolerance=round(tolerance * ONE)), WIDE, TURNED, None,
                  None, depths=depths) for depths, tolerance, _, _ in TOLERANT]
    scene = bench_rules.scene_of(cases)
    on = run.render(scene, MACHINE, "addx")
    off = run.render(scene, MACHINE, "addx", ",".join(bench_rules.INEXACT))
    for number, (case, (depths, tolerance, rule, spans)) in enumerate(zip(cases, TOLERANT), 1):
        where = f"w {depths}, tolerance {tolerance}"
        assert np.array_equal(on.frames[number], model.render(scene, number)), where
        assert set(on.figures[number]["spans"]) == spans, where
        cycles = [drawn.figures[number]["cycles"] for drawn in (on, off)]
        if rule:
            assert cycles[0] < cycles[1], where
        else:
            assert np.array_equal(on.frames[number], off.frames[number]), where
        settings = model.Settings(perspective="pixel", tolerance=case.material.tolerance)
        verdict = bounds.judge(case.vertices, settings, bench_rules.WIDTH, bench_rules.HEIGHT)
        assert not verdict.complaint and verdict.pixels, f"{where}: {verdict.complaint}"
    fired = [sum(each["rules"].get(rule, 0) for each in on.executed) for rule in bench_rules.INEXACT]
    assert fired == [1, 1]


def test_tolerances_allow_pieces_up_to_their_own_value():
    """Pieces of 8 and of 16 pixels begin with the tolerance that the bend gives them, to a unit of 1/65536 texel."""
    deep = Case("tolerance", DEEP, WIDE, TURNED, None, None, depths=(4, 6, 5))
    corners = [(x, y, s, t, w) for x, y, s, t, _, w in deep.vertices]

    def made(allowed: int):
        return set_up(corners, bench_rules.WIDTH, bench_rules.HEIGHT, True, model.Settings(
            perspective="pixel", tolerance=allowed))

    bend = tolerance.bend(made(0).perspective)
    wanted = {16 * bend - 1: "pixel", 16 * bend: "every8", 64 * bend - 1: "every8", 64 * bend: "every16"}
    assert {allowed: made(allowed).setting for allowed in wanted} == wanted
    scene = bench_rules.scene_of([replace(deep, material=replace(DEEP, tolerance=allowed)) for allowed in wanted])
    digests, = guest_frames.draw([(scene, "addx")], MACHINE, timed=False)
    pictures = [model.render(scene, number) for number in range(scene.frames)]
    guest_frames.require_models(pictures, digests, "tolerances", (scene, "addx", MACHINE))
    assert len({picture.tobytes() for picture in pictures[1:]}) == len({*wanted.values()})


@pytest.mark.parametrize("points", [WIDE, [(x - 40, y) for x, y in WIDE]], ids=["inside", "cut"])
def test_asking_costs_little(points):
    """For a polygon that only the rules of its position could make cheaper, testing them costs less
    than 1 %."""
    case = Case("outside", replace(AFFINE, mapper="generated"), points, TURNED, None, None)
    scene = bench_rules.scene_of([case])
    scene.textures = [replace(scene.textures[0], layout="margins"), *scene.textures[1:]]
    on, off = guest_frames.draw([(scene, "addx"), (scene, "addx OFF all")], MACHINE)
    cycles = [int(each["ticks"][1]) - int(each["ticks"][0]) for each in (on, off)]
    assert cycles[0] < 1.01 * cycles[1], cycles


#: A map whose v wraps near the right end of WIDE's lines: from the first pixel it seems to stay inside as
#: far as half the box, which is what counts from the middle.
FAR_WRAP = [100 + 1.4 * (x - WIDE[0][0]) for x, _ in WIDE]


@pytest.mark.parametrize("mapper, s, layout_, span", [
    ("dithered", [10, 120, 60], "page", "dithered_wrap"),
    ("generated", [200, 256.9, 220], "margins", "affine_addx_wrap")])
def test_wraps_far_from_the_first_pixel_are_seen(mapper, s, layout_, span):
    """Dithered spans, and affine ones where generated code would leave its row, are told that v may
    wrap, wherever the plane's first pixel is."""
    case = Case("no_wrap", replace(AFFINE, mapper=mapper), WIDE, (s, FAR_WRAP), None, None)
    scene = bench_rules.scene_of([case])
    scene.textures = [replace(scene.textures[0], layout=layout_), *scene.textures[1:]]
    drawn = run.render(scene, MACHINE, "addx", timed=False)
    assert set(drawn.figures[1]["spans"]) == {span}
    assert np.array_equal(drawn.frames[1], model.render(scene, 1))
