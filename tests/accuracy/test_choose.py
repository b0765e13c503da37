"""``tmap choose``: its choice is compared with a plain search of all rows."""

import itertools
import json
import os
import subprocess
import tomllib

import pytest

from tmap.__main__ import main
from tmap.accuracy import choose
from tmap.accuracy.choose import COST, LARGEST, POLYGON, RMS, WRONG, Wish
from tmap.base.paths import ACCURACY_BASELINE, ROOT
from tmap.compiler.materials import material_schema

ROWS = json.loads(ACCURACY_BASELINE.read_text())["rows"]
A1200, ERROR = ("--machine", "a1200"), ("--error", "1")


@pytest.fixture
def tmap(capsys):
    """Runs the command; returns its status, its output and its error output."""
    def run(*arguments) -> tuple[int, str, str]:
        status = main(["choose", *map(str, arguments)])
        return status, *capsys.readouterr()
    return run


@pytest.mark.parametrize("machine, depth, pixels, measure, wrong", [
    (machine, *kind, *limits) for machine in ("a1200", "a1200-fast")
    for kind in ((False, None), (True, None), (False, 30))
    for limits in itertools.product((LARGEST, RMS), (None, 0))])
def test_choice_is_the_cheapest_that_is_good_enough(machine, depth, pixels, measure, wrong) -> None:
    """For error limits between the errors of all rows: no row that is good enough is cheaper."""
    for error in sorted({r[measure] for r in ROWS} | {0.0, 1e9}):
        wish = Wish(error, machine, depth, wrong, None, measure, pixels)
        rows = choose.candidates(ROWS, wish)
        good = [r for r in rows if r[measure] <= error and (wrong is None or r[WRONG] <= wrong)]
        down, best, up = choose.choose(rows, wish)
        if not good:
            assert (down, best, up) == (None, None, None)
            continue
        assert best in good and best[COST] == min(r[COST] for r in good)
        if down:
            assert down[COST] < best[COST] and down not in good
        else:
            assert best[COST] == min(r[COST] for r in rows)
        if up:
            assert up[COST] >= best[COST]
            assert up[measure] <= best[measure] and up[WRONG] <= best[WRONG]


def test_size_is_the_nearest_by_ratio() -> None:
    assert [Wish(1, "a1200", pixels=pixels).set_name for pixels in (0.1, 14, 15, 220, 230, 1e9)] == [
        "8_pixels", "8_pixels", "25_pixels", "100_pixels", "500_pixels", "2000_pixels"]


def test_neighbours_are_the_nearest() -> None:
    """Made-up rows: the neighbours are the most expensive cheaper row that no other beats, and the
    cheapest more exact row."""
    def row(cost: float, error: float, wrong: float = 0) -> dict:
        return {COST: cost, LARGEST: error, WRONG: wrong}

    rows = [row(10, 9), row(12, 5), row(13, 6), row(20, 1), row(30, 1), row(40, .5), row(50, .2)]
    assert choose.choose(rows, Wish(2, "a1200")) == (rows[1], rows[3], rows[5])
    assert choose.choose(rows, Wish(9, "a1200")) == (None, rows[0], rows[1])
    assert choose.choose(rows, Wish(0.2, "a1200")) == (rows[5], rows[6], None)
    rows[3][WRONG] = 7
    assert choose.choose(rows, Wish(2, "a1200"))[2] == rows[4]  # as exact inside, better at edges
    assert choose.choose(rows, Wish(2, "a1200", wrong=0))[1] == rows[4]


@pytest.mark.parametrize("mapper", [None, "lit", "gouraud", "flat", "arbitrary"])
def test_pasted_lines_are_a_material(mapper) -> None:
    """The lines of the output are TOML that the scene compiler accepts, with the settings of the
    choice."""
    wish = Wish(1e9, "a1200", mapper=mapper)
    best = choose.choose(choose.candidates(ROWS, wish), wish)[1]
    material = tomllib.loads(choose.pasted(best))["materials"]["my_material"]
    read = material_schema()(material, "materials.my_material")
    for name in ("edges", "gradients", "start"):
        assert read[name] == best[name]
    if "texture" in material:
        for name in ("mapper", "perspective"):
            assert material[name] == best[name]


def test_output_names_choice_price_and_source(tmap) -> None:
    """The output has a table, the prices of both steps, the lines to paste and the source of the
    figures."""
    status, said, complaint = tmap("--error", 1, "--machine", "a1200-fast", "--depth")
    assert (status, complaint) == (0, "")
    for words in ("choice", "cheaper", "more exact", "[materials]",
                  'perspective = "pixel"', "commit", "Set depth", "DMA"):
        assert words in said, words


#: Made-up rows: cycles a pixel, largest and rms error, wrong pixels in a million.
MADE_UP = (10, 9, 2, 5), (12.5, 2, 0.5, 5), (20, 1, 0.25, 0), (30, 0.125, 0.0625, 1)
WORDS = {
    ("--error", 2): (
        "The cheapest with a largest error of at most 2 texels, on a1200:",
        "The next cheaper one saves 2.50 cycles a pixel (20.0 %); its largest error is 9.",
        "The next more exact one costs 7.50 cycles a pixel (60.0 %); its largest error is 1, its wrong "
        "pixels are 0 in a million."),
    ("--error", 0.5, "--rms"): (
        "The cheapest with an rms error of at most 0.5 texels, on a1200:",
        "The next cheaper one saves 2.50 cycles a pixel (20.0 %); its rms error is 2."),
    ("--error", 2, "--wrong", 0): (
        "The cheapest with a largest error of at most 2 texels and 0 wrong pixels in a million, on a1200:",
        "No setting is more exact."),
    ("--error", 9): ("No setting is cheaper.",),
    ("--error", 0.1): (
        "tmap: choose: no setting has a largest error of at most 0.1 texels on a1200; the most exact has "
        "0.125 (affine, exact, plane, subtexel, none), 1 wrong pixels in a million, at 30.00 cycles "
        "a pixel",),
    ("--error", 0.1, "--wrong", 0): (
        "tmap: choose: no setting has a largest error of at most 0.1 texels and 0 wrong pixels in a "
        "million on a1200; the most exact has 1 (affine, exact, plane, subtexel, none), 0 wrong pixels "
        "in a million, at 20.00 cycles a pixel",)}


@pytest.mark.parametrize("arguments", WORDS)
def test_prices_in_words(tmap, tmp_path, arguments) -> None:
    """Each difference has its sign, its percentage and the other figures that change. If nothing is
    good enough: status 1, and one line that says how near the best row is."""
    affine = {"name": "medium", "machine": "a1200", "mapper": "affine", "edges": "exact",
              "gradients": "plane", "start": "subtexel", "perspective": "none",
              "wrong_texels_percent": 0, POLYGON: 1000}
    rows = [affine | dict(zip((COST, LARGEST, RMS, WRONG), row)) for row in MADE_UP]
    (tmp_path / "made_up.json").write_text(json.dumps({"rows": rows}))
    status, said, complaint = tmap(*A1200, "--data", tmp_path / "made_up.json", *arguments)
    for line in WORDS[arguments]:
        assert line in (said + complaint).splitlines(), said + complaint
        if line.startswith("tmap: "):
            assert (status, said, complaint) == (1, "", f"{line}\n")


@pytest.mark.parametrize("arguments, content, words", [
    *(((*A1200, "--error", error), None, "--error") for error in ("much", "-1", "nan")),
    (A1200, None, "--error"),
    (ERROR, None, "--machine"),
    ((*ERROR, "--machine", "a500"), None, "--machine"),
    ((*ERROR, *A1200, "--wrong", "few"), None, "--wrong"),
    *(((*ERROR, *A1200, "--pixels", n), None, "--pixels") for n in ("0", "-8", "small")),
    ((*ERROR, *A1200, "--pixels", "8", "--depth"), None, "--depth"),
    ((*ERROR, *A1200, "--depth", "--mapper", "tiled"), None, "mapper tiled"),
    ((*ERROR, *A1200, "--data", "/nowhere.json"), None, "/nowhere.json: No such file"),
    ((*ERROR, *A1200), "{", "is not JSON"),
    ((*ERROR, *A1200), "[" * 100_000, "is not JSON"),
    ((*ERROR, *A1200), "[]", "rows"),
    ((*ERROR, *A1200), json.dumps({"rows": [ROWS[0], {
        key: value for key, value in ROWS[1].items() if key != COST}]}),
     "rows[1].cycles_per_pixel"),
    ((*ERROR, *A1200), '{"rows": []}', "no row of set medium"),
])
def test_bad_arguments_are_one_line(tmap, arguments, content, words, tmp_path) -> None:
    """Status 2, and one line that names the error."""
    if content is not None:
        (tmp_path / "data.json").write_text(content)
        arguments = [*arguments, "--data", tmp_path / "data.json"]
    status, said, complaint = tmap(*arguments)
    assert (status, said) == (2, "")
    assert complaint.count("\n") == 1 and words in complaint, complaint


@pytest.mark.parametrize(("redirection", "status", "said"), [
    (">&-", 0, ""), ("| true", 2, "tmap: standard output: Broken pipe\n"),
    (">/dev/full", 2, "tmap: standard output: No space left on device\n")])
def test_output_that_cannot_be_written(redirection: str, status: int, said: str) -> None:
    """One line at most, even where standard output is closed."""
    command = f"scripts/tmap choose --error 1 --machine a1200 {redirection}; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], cwd=ROOT, capture_output=True, text=True,
                          env={name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"})
    assert (done.returncode, done.stderr) == (status, said)
