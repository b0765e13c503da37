"""The report: one page that needs no network and can be read on a phone and on a wide screen."""

import html
import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import main
from tmap.accuracy import perspective_curves
from tmap.accuracy.errors import Errors
from tmap.base.errors import UserError
from tmap.base.paths import ACCURACY_BASELINE, BASELINE, ROOT
from tmap.bench import bench, published
from tmap.guest import cache
from tmap.guest.cache import Entry
from tmap.report import bench_pictures, data, pictures, report
from tmap.run import run

SIZES = ((360, 740), (1280, 900))  # a phone, a desk; CSS pixels
SECTIONS = ["scenes", "addx", "accuracy", "perspective", "fit", "bench", "ran", "hard", "polygons",
            "whole", "n64", "glide"]
SCENE = "mappers"
NAME = '<script>alert("rows & columns")</script>'
#: The browser has no network, nor have its own services.
BROWSER = ("chromium-headless-shell", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
           "--disable-background-networking", "--host-resolver-rules=MAP * ~NOTFOUND", "--dump-dom")
#: Writes into the page's title what it saw. ``requests`` are those that are not of files.
LOOK = """<script>addEventListener('load', () => {
  const pictures = [...document.images], root = document.documentElement;
  const outside = each => {
    if (each.getBoundingClientRect().right <= innerWidth + 0.5) return false;
    for (let up = each.parentElement; up; up = up.parentElement)
      if (getComputedStyle(up).overflowX != 'visible' && up != root && up != document.body)
        return false;
    return true;
  };
  document.title = JSON.stringify({width: root.scrollWidth, height: root.scrollHeight,
    broken: pictures.filter(each => each.checkVisibility() && !each.naturalWidth).map(
      each => each.src),
    pictures: pictures.length,
    wide: [...document.body.querySelectorAll('*')].filter(outside).map(
      each => each.outerHTML.slice(0, 80)),
    missing: [...document.querySelectorAll('a[href^="#"]')].map(each => each.hash.slice(1)).filter(
      each => !document.getElementById(each)),
    requests: performance.getEntriesByType('resource').map(each => each.name)});
})</script>"""


def look(page: Path, width: int, height: int, opened: bool = False) -> dict:
    """What LOOK sees of a page in a window of this size in pixels when all pictures are loaded,
    including those further down, and ``picture``, the page's upper part as displayed; ``opened``:
    details unfolded."""
    seen, shot = page.with_name("seen.html"), page.with_name("seen.png")
    text = page.read_text().replace(' loading="lazy"', "")
    seen.write_text((text.replace("<details", "<details open") if opened else text) + LOOK)
    dom = subprocess.run([*BROWSER, f"--window-size={width},{height}", f"--screenshot={shot}",
                          seen.as_uri()], capture_output=True, text=True, check=True).stdout
    found = json.loads(html.unescape(re.search("<title>(.*?)</title>", dom, re.S)[1]))
    return found | {"picture": Image.open(shot).convert("RGB")}


@pytest.fixture(scope="module")
def made(tmp_path_factory) -> tuple[Path, Path]:
    """A small report, one scene and the committed figures, and its cache."""
    out, kept = tmp_path_factory.mktemp("report"), tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(cache, "CACHE", kept)
        assert report.command(out, [SCENE], "a1200-fast", True) == 0
    return out, kept


def test_sections_stand_in_order_and_open_with_a_sentence(made) -> None:
    """All twelve sections are in order, with a paragraph under each title."""
    text = (made[0] / report.PAGE).read_text()
    assert re.findall(r'<h2 id="(\w+)">', text) == SECTIONS
    for section in text.split("<h2")[1:]:
        assert re.match(r'[^<]*</h2>\n<p>[A-Z][^<]*', section), section[:120]


def test_every_table_says_where_its_figures_are_from(made) -> None:
    """Machine, conditions, emulator, compiler and commit follow each table and list of
    materials."""
    text = (made[0] / report.PAGE).read_text()
    parts = re.split(r'<table|<div class="ran"', text)[1:]
    assert len(parts) > 20
    for part in parts:
        source = re.search(r'<p class="source">([^<]*)</p>', part)
        assert source and "</h2>" not in part[:source.start()], part[:200]
        for words in ("a1200", "DMA", "FS-UAE", "commit "):
            assert words in source[1], f"{words} is missing in {source[1]!r}"


def test_page_needs_no_network_and_no_script(made) -> None:
    """All files that it refers to are in its folder."""
    text = (made[0] / report.PAGE).read_text()
    assert "<script" not in text and "http" not in text
    references = re.findall(r'(?:src|srcset|href)="([^"#]+)', text)
    assert len(references) > 4
    for reference in references:
        assert (made[0] / reference).is_file(), reference


def test_figures_are_the_runs_and_the_baselines(made) -> None:
    """Some numbers, compared with the files that have the measurements."""
    text = (made[0] / report.PAGE).read_text()
    about = next(made[1].glob("scene_mappers-*/run.json"))
    found = json.loads(about.read_text())
    mean = found["totals"]["cycles"] / len(found["frames"])
    assert f"{mean:,.0f} cycles, about {run.CLOCK_HZ / mean:.1f} frames a second" in text
    assert len(found["totals"]["spans"]) > 4
    for name, material in found["lowering"].items():
        for kind, pixels in material["spans"].items():
            assert f"<code>{kind}</code> {pixels:,}" in text, f"{name}: {kind} {pixels:,}"
    baseline = json.loads(BASELINE.read_text())
    figures = {bench.key(row): bench.cycles(row) for row in baseline["rows"]}
    assert f"{figures['affine_addx', 'a1200-fast', 256]:.1f}" in text and baseline["commit"] in text


def keep_plots(patch: pytest.MonkeyPatch, folder: Path) -> None:
    """Makes further reports take the plots of the committed figures from a report's folder of pictures."""
    patch.setattr(pictures, "plot", lambda rows, machine, path: shutil.copyfile(folder / path.name, path))
    patch.setattr(perspective_curves, "plot", lambda path: shutil.copyfile(folder / path.name, path))
    patch.setattr(bench_pictures, "draw",
                  lambda group, measured, path: shutil.copyfile(folder / path.name, path))


def test_nothing_is_measured_twice(made, tmp_path, monkeypatch) -> None:
    """The second report takes everything from the cache and is the same page."""
    def fail(*_):
        raise AssertionError("measured again")

    keep_plots(monkeypatch, made[0] / report.PICTURES)
    monkeypatch.setattr(cache, "CACHE", made[1])
    monkeypatch.setattr(run, "make", fail)
    assert report.command(tmp_path, [SCENE], "a1200-fast", True) == 0
    assert (tmp_path / report.PAGE).read_text() == (made[0] / report.PAGE).read_text()


@pytest.fixture(scope="module")
def complete(made, tmp_path_factory) -> Path:
    """A written report with all parts, from made-up files; its run has figures of lowering."""
    folder, out = tmp_path_factory.mktemp("parts"), tmp_path_factory.mktemp("complete")
    found = data.Found(*map(data.committed, (
        data.BASELINE, data.ACCURACY_BASELINE, data.POLYS_BASELINE)), [])
    about = {"emulator": "FS-UAE 3.1.66", "compiler": "gcc", "commit": "abc",
             "machine": "a1200-fast"}
    frame = {"number": 0, "cycles": 2000, "polygons": 5, "pixels": 100,
             "spans": {"affine_addx": 100}}
    asked = {"mapper": "affine", "edges": "exact", "gradients": "plane", "perspective": "every16"}
    scene = about | {
        "scene": "long", "title": NAME, "width": 320, "height": 256, "frames": [frame],
        "totals": run.total([frame]), "errors": vars(Errors()),
        "materials": {}, "cycles_unit": "CPU cycles",
        "lowering": {"a_material_with_a_rather_long_name_of_its_own": {
            "asked": asked, "polygons": 5, "unsure": 0, "rules": {"constant_w_needs_no_perspective": 4},
            "spans": {"affine_addx": 100, "affine_row": 12345678}}, "plain": {
            "asked": asked, "polygons": 1, "unsure": 0, "rules": {}, "spans": {"fill": 1}}}}
    names = ("frame_000.png", "animation.gif", "methods.png", "swimming.png", "swimming.gif",
             "accuracy.png", "sliver.png", "fit.png")
    for name in names:
        Image.fromarray(np.zeros((64, 1600, 3), np.uint8)).save(folder / name)
    (folder / "index.html").write_text("<p>cases")
    row = {"case": "sliver", "mapper": "affine", "edges": "exact",
           "gradients": "plane", "start": "subtexel", "perspective": "none",
           "cycles": 1234, "pixels": 999,
           "texel_error": 0.01, "worst_ratio": 0.97}
    rows = [row, row | {"worst_ratio": 0.5}, row | {"start": "truncated", "worst_ratio": 1.0},
            row | {"worst_ratio": None}]
    (folder / "hard.json").write_text(json.dumps({"rows": rows}))
    hard = about | {"complaints": ["sliver: 2 texels off"]}
    found.scenes = [Entry(scene, folder)]
    found.sets, found.hard = Entry({}, folder), Entry(hard, folder)
    found.fit = Entry(about | {"scene": "long", "conditions": "DMA on", "sentences": ["Chosen: pixels of 2x2."],
                               "lines": 'pixel = "2x2"', "table": "| a | b |\n|---|--:|\n| 1 | 2 |"}, folder)
    found.methods = Entry(about | {"table": "| a | b |\n|---|--:|\n| 1 | 2 |"}, folder)
    with pytest.MonkeyPatch.context() as patch:
        keep_plots(patch, made[0] / report.PICTURES)
        report.write(found, out)
    return out


def test_rules_and_spans_of_each_material(complete) -> None:
    """Settings, polygons, rules and spans of a run; names are text, never markup."""
    text = (complete / report.PAGE).read_text()
    for words in ("a_material_with_a_rather_long_name_of_its_own", "5 polygons", "1 polygon<",
                  "<code>constant_w_needs_no_perspective</code> 4",
                  "<code>affine_row</code> 12,345,678",
                  "affine · exact · plane · every16", "&lt;script&gt;", "97.0 % of its bound",
                  "1 cases in 4 drawings", "3 have an exact ideal",
                  "<strong>1 exceeds a bound", "sliver: 2 texels off"):
        assert words in text, words
    assert "all together" not in text and NAME not in text
    assert (complete / "hard" / "index.html").is_file()


@pytest.mark.parametrize("width, height", SIZES)
def test_pages_read_well_in_a_browser(made, complete, width: int, height: int) -> None:
    """Both reports on a phone and on a desktop, with folded parts shut and open: nothing is wider
    than the page, all pictures load, only files are requested, and every internal link has a
    target."""
    for page, opened in ((made[0] / report.PAGE, False), (complete / report.PAGE, True)):
        assert '<meta name="viewport" content="width=device-width' in page.read_text()
        view = look(page, width, height, opened)
        assert view["width"] <= width and view["height"] > 4 * height, view
        assert not (view["wide"] or view["broken"] or view["missing"] or view["requests"]), view
        assert view["pictures"] >= 4 and view["picture"].width == width, view
        assert len(view["picture"].getcolors(1 << 24)) > 50, view


def test_browser_notices_faults(tmp_path) -> None:
    """The checks above detect the faults that they look for."""
    page = tmp_path / "page.html"
    page.write_text('<meta name="viewport" content="width=device-width"><div style='
                    '"width:900px">wide</div>'
                    '<img src="gone.png"><a href="#nowhere">x</a>'
                    '<link rel="stylesheet" href="http://192.0.2.1/style.css">')
    view = look(page, 360, 740)
    assert view["width"] > 360 and view["wide"] and view["broken"]
    assert view["missing"] == ["nowhere"] and view["requests"] == ["http://192.0.2.1/style.css"]


def test_frontier_is_what_nothing_beats() -> None:
    rows = json.loads(ACCURACY_BASELINE.read_text())["rows"]
    for machine in ("a1200", "a1200-fast"):
        for name, best in pictures.frontiers(rows, machine).items():
            chosen = [r for r in pictures.plotted(rows, machine) if r["name"] == name]
            assert 1 < len(best) < len(chosen), (machine, name)
            for row in chosen:
                beaten = any(o["cycles_per_pixel"] <= row["cycles_per_pixel"]
                             and o["texel_error_rms"] < row["texel_error_rms"] for o in chosen)
                if row in best:
                    assert not beaten, (machine, row)
                assert beaten or row["texel_error_rms"] in {r["texel_error_rms"] for r in best}, (
                    machine, row)


@pytest.mark.parametrize("kind", published.PUBLISHED)
def test_ranks_are_places_among_all(kind) -> None:
    """In fast RAM the order is the list's; nothing is faster than memory alone."""
    measured = json.loads(BASELINE.read_text())
    loops = published.ranked(kind, measured)
    assert {loop.ours for loop in loops} == {True, False}
    assert [published.places(loops)[loop.name][0] for loop in loops] == list(range(1, len(loops) + 1))
    for loop in loops:
        assert all(mine > least for mine, least in zip(loop.cycles, published.floors(measured)))


@pytest.mark.parametrize("out, scenes, words", [
    (Path("build"), ["nowhere"], "no scene is called nowhere; there are corridor,"),
    (ROOT / "Makefile", None, "is not a directory")])
def test_bad_input_is_one_line(out, scenes, words) -> None:
    """The error is reported before anything is measured."""
    with pytest.raises(UserError, match=words) as told:
        report.command(out, scenes, "a1200-fast", True)
    assert "\n" not in str(told.value)


def test_bad_machine_is_one_line(capsys) -> None:
    assert main(["report", "--machine", "a500"]) == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1 and "--machine" in error


def test_the_bench_has_a_picture_for_each_group(made, tmp_path, monkeypatch) -> None:
    """Each can be read on a screen; a row has the same place in all of them."""
    measured = json.loads(BASELINE.read_text())
    keep_plots(monkeypatch, made[0] / report.PICTURES)
    names = bench_pictures.write(measured, tmp_path)
    assert names == [bench_pictures.file_of(group) for group in bench_pictures.GROUPS]
    for name in names:
        with Image.open(tmp_path / name) as picture:
            assert picture.width == 1000 and 300 < picture.height < 1200, name
            assert len(picture.convert("RGB").getcolors(1 << 20)) > 50, name
    shown = [row for group in bench_pictures.GROUPS for row, _ in bench_pictures.bars(group, measured)]
    assert len(shown) == len(set(shown)) > 200
    assert {row["name"] for row in measured["rows"]} <= {row.rpartition(" ")[0] for row in shown}
