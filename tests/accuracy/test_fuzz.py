"""The fuzzer: a fixed set of polygons passes on the emulated 68020; failures are found, reduced and
explained."""

import json
import signal
from dataclasses import replace

import numpy as np
import pytest

from tests.helpers import signalled
from tmap.__main__ import main
from tmap.base.errors import UserError
from tmap.corpus import hard_cases
from tmap.fuzz import fuzz, polygons as fuzz_polygons, record, shrink, units
from tmap.guest import guest_frames
from tmap.guest.emulator import SECOND
from tmap.model import model
from tmap.scene_file import scene_file
from tmap.scene_file.textures import IN_DEPTH
from tmap.setup import edges

SEED, COUNT = 2026, 4000


def test_a_fixed_slice_holds() -> None:
    """Every frame is the model's; every polygon with an ideal is within its bounds."""
    found = fuzz.run(SEED, 0, COUNT)
    assert not found.failed, {n: f.text for n, f in found.failed.items()}
    n = found.counts
    assert n["polygons"] == COUNT and n["drawn"] > COUNT / 2 and n["refused"] > COUNT / 100
    assert n["judged"] > COUNT / 3 and found.coverage_errors["exact"] == 0
    assert set(found.worst) == set(scene_file.MAPPERS[1])


def test_frames_of_all_sizes_hold() -> None:
    """Polygons of the blocks behind the slice: high and narrow frames, and some of few pixels."""
    found = fuzz.run_part(SEED, range(4 * fuzz_polygons.BLOCK, 8 * fuzz_polygons.BLOCK, 8), fuzz.MACHINE)
    assert not found.failed, {n: f.text for n, f in found.failed.items()}


def test_a_slice_in_perspective_holds() -> None:
    """The same of the family whose polygons all have depth and a perspective, in frames of every size."""
    found = fuzz.run_part(SEED, range(0, 8 * fuzz_polygons.BLOCK, 16), fuzz.MACHINE, "perspective")
    assert not found.failed, {n: f.text for n, f in found.failed.items()}
    assert found.counts["judged"] > 200
    assert not found.worst.keys() - IN_DEPTH


def test_digests_tell_frames_apart() -> None:
    """The digest changes with one bit and its position; with a pixel's line, for every byte of a
    longword and any distance; with lines shifted against each other."""
    moved = [np.eye(1, 64, k, dtype=np.uint8) for k in range(64)]
    moved += [np.left_shift(np.eye(1, 64, 9, dtype=np.uint8), bit) for bit in range(1, 8)]
    for width in (64, 128, 320):
        ground = np.full((48, width), 7, np.uint8)
        for column in range(4, 8):
            for line in range(48):
                moved.append(ground.copy())
                moved[-1][line, column] = 200
        for line in range(1, 48):  # two lines shifted, to the right and to the left
            moved.append(ground.copy())
            moved[-1][0, 8:40] = moved[-1][line, 7:39] = 200
            moved.append(ground.copy())
            moved[-1][0, 7:39] = moved[-1][line, 8:40] = 200
    assert len({guest_frames.digest_of(frame) for frame in moved}) == len(moved)


def test_a_wrong_model_is_found_and_explained(monkeypatch, capsys, tmp_path) -> None:
    """The model leaves out pixels whose centre is on the edge: the first difference is
    reduced, printed with all details, and kept. Each round of reduction takes one boot, as drawing
    the polygons does."""
    boots, draw = [], guest_frames.draw
    monkeypatch.setattr(fuzz, "draw", lambda scenes, machine, **how: boots.append(machine) or draw(
        scenes, machine, **how))
    monkeypatch.setattr(edges.Edge, "column", lambda edge, line: (edge.at(line) >> 16) + 1)
    monkeypatch.setattr(shrink, "ROUNDS", 3)
    monkeypatch.setattr(hard_cases, "FOUND", tmp_path / "found.json")
    monkeypatch.setattr(fuzz, "run", lambda seed, first, count, machine, on_part, family: fuzz.run_part(
        seed, range(first, first + count), machine, family))
    assert main(["fuzz", "--seed", "1", "--first", "600", "--count", "60", "--keep", "wrong_ceil"]) == 1
    text = capsys.readouterr().out
    for part in ("60 polygons", "failed: ", "seed 1, polygon 6", "the guest's frame is not the model's",
                 "expected / found: ", "vertex 2: x ", "(0x", "slope ", "picture (expected, found",
                 "again: scripts/tmap fuzz --seed 1 --first 6", "kept as wrong_ceil"):
        assert part in text, f"{part!r} is missing in\n{text}"
    assert boots == (1 + shrink.ROUNDS) * [fuzz.MACHINE, SECOND]
    kept, = json.loads((tmp_path / "found.json").read_text())
    number = int(kept["sentence"].split("polygon ")[1].split(":")[0])
    assert kept["name"] == "wrong_ceil" and "seed 1" in kept["sentence"]
    bits = [sum(bin(abs(c)).count("1") for vertex in vertices for c in vertex)
            for vertices in (kept["vertices"], fuzz_polygons.polygon(1, number).vertices)]
    assert bits[0] < bits[1]


@pytest.mark.parametrize("family", units.UNITS)
def test_a_wrong_unit_is_found_and_explained(family: str, monkeypatch, capsys, tmp_path) -> None:
    """The model has another pixel in the middle of one polygon of three: it alone is printed, with all that it is made
    of, and the run is kept."""
    render = model.render

    def wrong(scene, number):
        frame = render(scene, number)
        frame[16, 24] += number == 0
        return frame

    monkeypatch.setattr(units.model, "render", wrong)
    monkeypatch.setattr(record, "FUZZED", tmp_path / "fuzzed.json")
    monkeypatch.setattr(fuzz, "run", lambda seed, first, count, machine, on_part, family: units.run_part(
        seed, range(first, first + count), machine, family))
    number = min(range(5, 8), key=lambda n: units.UNITS[family].rank(1, n))  # of the scene's frame 0
    asked = ["fuzz", "--family", family, "--first", "5", "--count", "3", "--machine", SECOND, "--record"]
    assert main(asked) == 1
    text = capsys.readouterr().out
    for part in ("3 polygons, ", f"1 failed: {number}; the first\n", f"seed 1, polygon {number} of {family}", "1 pixels of 48x32; ",
                 "pixel (24, 16) is 0x", "picture (expected, found", "edges ", "  x ",
                 f"again: scripts/tmap fuzz --family {family} --seed 1 --first {number} --count 1"):
        assert part in text, f"{part!r} is missing in\n{text}"
    kept, = json.loads((tmp_path / "fuzzed.json").read_text())
    assert (kept["family"], kept["first"], kept["polygons"], kept["wrong"]) == (family, 5, 3, 1)
    assert main(asked) == 2
    assert "polygons 5 to 7 of seed 1" in capsys.readouterr().err


def test_faults_of_each_kind_are_told_apart() -> None:
    """Wrong pixels, wrong results and exceeded bounds are distinct faults."""
    each = fuzz_polygons.polygon(SEED, 3)
    checked = fuzz.check(each, SEED, 0)
    good = {"result": checked.result, **dict(zip(("sum", "hash"), guest_frames.digest_of(checked.frame)))}
    right = {fuzz.MACHINE: good, SECOND: good}
    assert fuzz.compare(checked, right) is None
    assert fuzz.compare(checked, right | {SECOND: good | {"result": 3}}) == fuzz.Fault(
        "refused", f"{SECOND}: the result is 3, not {checked.result}", SECOND)
    assert fuzz.compare(checked, right | {fuzz.MACHINE: good | {"hash": 1}}).kind == "differs"
    checked.verdict.complaint = "too far"
    assert fuzz.compare(checked, right) == fuzz.Fault("bound", "too far")


def test_both_processors_draw() -> None:
    """All that the emulated A1200 draws the second one draws too; of its own blocks the A1200 draws a share."""
    blocks = [(block, [fuzz_polygons.polygon(SEED, block * fuzz.BLOCK)], "addx") for block in range(fuzz.BLOCKS)]
    first, second = (fuzz.draw_blocks(blocks, SEED, machine) for machine in (fuzz.MACHINE, SECOND))
    assert [list(each) for each in first] == fuzz.BLOCKS * [[fuzz.MACHINE, SECOND]]
    assert [list(each) for each in second] == [[SECOND, fuzz.MACHINE]] + (fuzz.BLOCKS - 1) * [[SECOND]]


def test_a_crash_is_sought_by_halves(monkeypatch) -> None:
    """The polygon that ends a boot is found; the others are still judged."""
    polygons = [fuzz_polygons.polygon(SEED, k) for k in range(9)]
    checks = {id(p): fuzz.check(p, SEED, 0) for p in polygons}
    right = [(c.result, *guest_frames.digest_of(c.frame)) for c in checks.values()]

    def draw(scenes, machine, timed):
        (this, _), = scenes
        corners = [tuple(map(int, v)) for v in this.vertices]
        if polygons[5].vertices[0] in corners:
            raise UserError("render crashed: exception 5")
        return [np.array([right[polygons.index(p)] for p in polygons
                          if p.vertices[0] in corners], [("result", int), ("sum", int), ("hash", int)])]

    monkeypatch.setattr(fuzz, "draw", draw)
    assert fuzz.faults(polygons, SEED, 0, "addx", "a1200-fast") == {
        5: fuzz.Fault("crash", "render crashed: exception 5")}


def test_shrinking_ends_at_the_simplest() -> None:
    """Vertices, settings and numbers that do not matter are removed; those that matter stay."""
    start = next(p for p in (fuzz_polygons.polygon(SEED, k) for k in range(500))
                 if len(p.vertices) > 4 and p.settings.edges == "subpixel"
                 and max(v[0] for v in p.vertices) > 40 << 16)

    def failing(some):
        return {k: "wide" for k, p in enumerate(some)
                if max(v[0] for v in p.vertices) > 40 << 16 and p.settings.edges == "subpixel"}

    found, fault = shrink.shrink(start, "wide", failing)
    assert fault == "wide" and len(found.vertices) == 3
    plain = {"clip": "scissor", "start": "subtexel", "gradients": "plane", "edges": "subpixel"}
    assert found.settings == replace(start.settings, **plain)
    numbers = sorted(abs(c) for v in shrink.away(found.vertices) for c in v)
    assert numbers[:-1] == [0] * 17 and 40 << 16 < numbers[-1] < 84 << 16


@pytest.mark.parametrize("arguments, complaint", [
    (["--count", "0"], "fuzz: --count must be 1 or more"),
    (["--seed", "-1"], "fuzz: --count must be 1 or more, --first and --seed 0 or more"),
    (["--count", "x"], "fuzz: argument --count: invalid int value: 'x'"),
    (["--family", "cubes"], "fuzz: argument --family: invalid choice: 'cubes'"),
    (["--machine", "z80"], "fuzz: argument --machine: invalid choice: 'z80'")])
def test_bad_arguments(arguments: list[str], complaint: str, capsys) -> None:
    assert main(["fuzz", *arguments]) == 2
    assert complaint in capsys.readouterr().err


@pytest.mark.parametrize(("to_all", "number", "said"), [
    (True, signal.SIGINT, "tmap: interrupted\n"), (True, signal.SIGTERM, ""), (True, signal.SIGHUP, ""),
    (False, signal.SIGTERM, "")])
def test_a_signal_ends_all_at_once(to_all: bool, number: signal.Signals, said: str, tmp_path) -> None:
    """``to_all``: a terminal's signals reach processes and emulators too; kill's the first process
    alone. One line at most, and nothing is left."""
    assert signalled.end(["fuzz", "--count", "40000"], number, to_all, tmp_path) == (128 + number, said)
    assert not list(tmp_path.iterdir())
