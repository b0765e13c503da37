"""The committed cycle figures: exact in this emulator, so a change is a decision."""

import json
import re

import pytest

from tmap.base.paths import BASELINE, ROOT, SCENES
from tmap.bench import bench, rules, scenes
from tmap.bench.modes import measure
from tmap.build import contracts
from tmap.compiler.scene import compile_scene
from tmap.guest.emulator import CYCLES_PER_TICK, MEASURED
from tmap.model.mesh import polygons_at
from tmap.report import readme_modes

UPDATE = ("if the change is meant: scripts/tmap bench -o build/bench --accept, and give the "
          "reason in the commit")


#: Most cycles a pixel, with set-up; c2p_8_low while its planes are displayed.
GOALS = {("affine_addx", "a1200-fast", 256): 17.0, ("affine_addx", "a1200-mixed", 256): 21.0,
         ("affine_addx", "a1200-fast", 16): 21.5, ("affine_row", "a1200-fast", 256): 13.0,
         ("affine_column", "a1200-fast", 256): 15.0, ("affine_copy", "a1200-fast", 256): 4.2,
         ("affine_lit", "a1200-fast", 256): 24.5, ("affine_gouraud", "a1200-fast", 256): 29.0,
         ("light", "a1200-fast", 256): 16.0, ("light", "a1200-mixed", 256): 21.0,
         ("light_gouraud", "a1200-fast", 256): 18.0,
         ("c2p_8", "a1200-mixed", 320): 17.5, ("c2p_8_low", "a1200-mixed", 320): 17.5,
         ("rotator", "a1200-fast", 320): 17.0, ("rotator", "a1200-mixed", 320): 21.0}


@pytest.fixture(scope="module")
def found() -> dict:
    """All rows but those in plain C: they are what modes are compared with, and a quarter of the time."""
    return bench.bench(list(bench.CONDITIONS), plain=False)


@pytest.fixture(scope="module")
def baseline() -> dict:
    return json.loads(BASELINE.read_text())


def in_plain_c(row: dict) -> bool:
    """Whether it is a mode's that is drawn pixel by pixel in C."""
    return row["name"].startswith(measure.ROW) and row["name"].endswith(measure.PLAIN_END)


def test_no_row_left_the_baseline(found, baseline) -> None:
    """No figure moves by more than 1 %, and no row is gone."""
    complaints = bench.compare(found, baseline)
    assert not complaints, "\n".join([*complaints, UPDATE])
    for kind in bench.UNITS:
        gone = {bench.key(r) for r in baseline[kind] if not in_plain_c(r)} - {bench.key(r) for r in found[kind]}
        assert not gone, f"rows of the baseline are no longer measured: {gone}; {UPDATE}"


def test_figures_repeat_to_a_tick(found) -> None:
    """A second measurement agrees to within a tick of the clock (4 cycles) of its own, and one of
    what calling costs, which is shared among that many calls; both figures are rounded."""
    again = bench.measure("a1200-fast", "affine_addx")["rows"]
    first = {bench.key(r): r for r in found["rows"]}
    for row in again:
        calling = CYCLES_PER_TICK / bench.NOTHING_REPEATS / row["length"]
        difference = abs(bench.cycles(row) - bench.cycles(first[bench.key(row)]))
        assert difference <= row["one_tick"] + calling + 0.001, row


def test_speeds_that_are_promised(found) -> None:
    figures = {bench.key(r): bench.cycles(r) for r in found["rows"]}
    for row, most in GOALS.items():
        assert figures[row] <= most, row
    for machine in bench.CONDITIONS:
        assert figures["rotator", machine, 320] < figures["rotator_swap", machine, 320]
        assert figures["affine_addx", machine, 256] < figures["affine_swap", machine, 256]
        for special, base, length in (
                ("affine_copy", "affine_row", 4), ("affine_short", "affine_addx", 16),
                ("affine_short_wrap", "affine_addx_wrap", 16), ("affine_row_short", "affine_row", 16),
                ("gouraud_short", "gouraud", 16), ("affine_lit_short", "affine_lit", 4),
                ("affine_lit_short_wrap", "affine_lit_wrap", 4)):
            assert figures[special, machine, length] < 0.97 * figures[base, machine, length], special


def test_every_scene_has_rows(found) -> None:
    """Those of depth, effects and wide pixels, on both machines; quicker with fast RAM."""
    names = {path.stem for path in SCENES.glob("*.toml")} - {"default", "mappers", "triangle"}
    figures = {(r["name"], r["machine"]): r["cycles_per_frame"] for r in found["frames"]}
    assert figures.keys() == {(f"scene_{name}", machine) for name in names
                              for machine in MEASURED}
    for name in names:
        assert 50_000 < figures[f"scene_{name}", "a1200-fast"] < figures[f"scene_{name}", "a1200"]


@pytest.mark.parametrize("name", ["glide_wall", "environment", "corridor", "n64_rectangles"])
def test_cut_scenes_have_their_frames(name: str) -> None:
    """Frames of a scene, some of them twice, show the polygons that they show in the whole of it: all of
    them, and no other frame's."""
    whole = compile_scene(SCENES / f"{name}.toml")
    numbers = [0, 3, 4, whole.frames - 1, 0, 3, 4, whole.frames - 1]
    cut = scenes.some_frames(whole, numbers)
    for number, kept in enumerate(numbers):
        assert list(polygons_at(cut, number)) == list(polygons_at(whole, kept)), (number, kept)


def test_every_rule_of_lowering_saves_cycles(found) -> None:
    """Wherever map and frame lie, so that no rule need ask."""
    figures = {(r["name"], r["machine"]): r["cycles_per_polygon"] for r in found["rules"]}
    for case in rules.CASES:
        for machine in bench.CONDITIONS:
            on, off = (figures[f"rule_{case.name}{end}", machine]
                       for end in ("", rules.WITHOUT))
            assert on < 0.995 * off, (case.name, machine, on, off)


def test_every_mode_of_texture_engines_has_rows(baseline) -> None:
    """On all machines, and in plain C in fast RAM; a first frame costs more."""
    figures = readme_modes.figures_of(baseline)
    machines = set(bench.CONDITIONS)
    assert figures.keys() == {
        (name, machine) for mode in measure.EVERY.values()
        for name, some in ((measure.ROW + mode.name, machines),
                           (measure.FIRST_ROW + mode.name, machines),
                           (measure.ROW + mode.name + measure.PLAIN_END,
                            {"a1200-fast"} if mode.in_c else ()))
        for machine in some}
    for (name, _), cycles in figures.items():
        assert cycles > 0, name


def test_modes_are_thrice_as_fast_as_plain_c(found, baseline) -> None:
    """Pixel by pixel, by the same rules."""
    figures = readme_modes.figures_of(baseline) | readme_modes.figures_of(found)
    for mode in measure.EVERY.values():
        if mode.in_c:
            assert readme_modes.ratio(figures, mode.name) >= 3, mode


def test_a_moved_figure_is_noticed(baseline) -> None:
    """The comparison itself: 1.1 % is reported with both figures, 0.9 % is not."""
    moved = json.loads(json.dumps(baseline))
    row = moved["rows"][0]
    row["cycles_per_pixel"] = baseline["rows"][0]["cycles_per_pixel"] * 1.011
    (line,) = bench.compare(moved, baseline)
    assert row["name"] in line and "+1.1 %" in line
    row["cycles_per_pixel"] = baseline["rows"][0]["cycles_per_pixel"] * 0.991
    assert bench.compare(moved, baseline) == []


def test_rows_that_contract_blocks_name_exist(baseline) -> None:
    """Where a block says "bench row X" or "bench rows X, Y and Z" for the cost, the baseline has them."""
    names = {row["name"] for kind in bench.UNITS for row in baseline[kind]}
    named = [(contract, name) for contract in contracts.all_contracts(ROOT / "src68k")
             for list_ in re.findall(r"bench row (\w+)|bench rows ((?:\w+(?:, | and )?)+)", contract.cost)
             for name in re.findall(r"\w+", "".join(list_)) if name != "and"]
    assert len(named) > 100
    for contract, name in named:
        assert name in names, f"{contract.file}:{contract.line}: {contract.name}: no bench row {name}"
