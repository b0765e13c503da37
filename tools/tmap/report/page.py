"""The report's page: the content of its sections. The template is report.html in this folder."""

import json
from pathlib import Path

import jinja2
from markdown_it import MarkdownIt
from markupsafe import Markup

from tmap.accuracy import engines, polys, rows, scene_errors
from tmap.accuracy.errors import Errors
from tmap.accuracy.hard_report import every_case
from tmap.base import markdown
from tmap.bench import bench, published
from tmap.guest import provenance
from tmap.guest.cache import Entry
from tmap.guest.emulator import CLOCK_HZ, MACHINES as EMULATED
from tmap.report import bench_pictures, pictures as report_pictures, readme, readme_scenes
from tmap.report.data import MACHINE, Found

TEMPLATES = Path(__file__).parent
TEMPLATE = "report.html"
#: The machines of all figures.
MACHINES = {
    "a1200": "68EC020, 2 MB of chip RAM and nothing else",
    "a1200-fast": "the same with 8 MB of fast RAM, which has code, tables, textures and frame",
    "a1200-mixed": "a1200-fast with textures and frame in chip RAM",
    "a1200-030": "a1200-fast with a 68EC030 at the same clock; its data cache on where said"}
#: Rows of the bench that are compared with memory alone.
FLOORED = ("gouraud", "generated", "affine_row", "affine_column", "affine_addx", "tiled",
           "columns", "arbitrary", "affine_lit", "affine_gouraud", "persp_even_16", "persp_even_8",
           "persp_pixel", "persp_fine")
STORES = ("gouraud",)  # rows without texel fetches, compared with stores alone
#: Hard cases that are listed: the number of those nearest to their bounds, their settings (edges,
#: gradients, start, mapper), and their least size in pixels, so that the eye can see them.
NEAREST, EXACT, LARGE = 9, ("exact", "plane", "subtexel", "affine"), 400


def tables(markdown: str, numbers: bool = False) -> Markup:
    """Returns Markdown's tables as HTML, each in a box that scrolls by itself; ``numbers``: all
    columns except the first are right-aligned."""
    made = MarkdownIt("commonmark").enable("table").render(markdown)
    box = f'<div class="wide{" numbers" if numbers else ""}"><table>'
    return Markup(made.replace("<table>", box).replace("</table>", "</table></div>"))


def source(machine: str, about: dict, conditions: str = "") -> Markup:
    """Returns the source of figures, to be shown beside them. ``about``: emulator, compiler, commit
    and, in most, conditions."""
    words = [machine, (conditions or about.get("conditions", "")).rstrip(" ."), about["emulator"],
             about["compiler"], f"commit {about['commit']}"]
    return Markup('<p class="source">{}.</p>').format("; ".join(word for word in words if word))


def scene(about: dict, pictures: Path) -> dict:
    """Returns a scene's run for the template."""
    count, cycles = len(about["frames"]), [frame["cycles"] for frame in about["frames"]]
    mean = sum(cycles) / count
    materials = [{"name": name, **each} for name, each in about["lowering"].items()]
    moving = f"{about['scene']}_animation.gif"
    return about | {"count": count, "mean": mean, "worst": max(cycles), "rate": CLOCK_HZ / mean,
                    "still": f"{pictures.name}/{about['scene']}_frame_000.png",
                    "moving": f"{pictures.name}/{moving}" if (pictures / moving).exists() else None,
                    "materials": materials, "settings": list(materials[0]["asked"]),
                    "source": source(about["machine"], about, "DMA and interrupts off")}


def floored(measured: dict) -> list[dict]:
    """Returns rows of the bench, 256 pixels, each with its cycles and those of memory alone."""
    figures, made = bench.figures(measured["rows"]), []
    for name in FLOORED:
        cycles = [figures[name, machine, published.LONG] for machine in markdown.MACHINES]
        floors = published.floors(measured, "floor_store" if name in STORES else "floor_copy")
        made.append({"name": name, "cells": list(zip(cycles, floors)), "stores": name in STORES})
    most = max(row["cells"][0][0] for row in made)
    return sorted((row | {"most": most} for row in made), key=lambda row: row["cells"][0][0])


def hard_cases(entry: Entry) -> dict:
    """The counts of hard cases, the excesses, and the most exact spans nearest to a bound."""
    rows = json.loads((entry.folder / "hard.json").read_text())["rows"]
    judged = [r for r in rows if r["worst_ratio"] is not None]
    exact = dict(zip(("edges", "gradients", "start", "mapper"), EXACT)).items()
    nearest: dict[str, dict] = {}
    for row in sorted(judged, key=lambda r: -r["worst_ratio"]):
        if exact <= row.items() and row["pixels"] >= LARGE:
            nearest.setdefault(row["case"], row)
    sentences = {case.name: case.sentence for case in every_case()}
    return entry.result | {
        "cases": len({r["case"] for r in rows}), "drawings": len(rows), "judged": len(judged),
        "nearest": [row | {"sentence": sentences.get(row["case"], "")}
                    for row in list(nearest.values())[:NEAREST]]}


def page(found: Found, pictures: Path) -> str:
    """The text of index.html; ``pictures``: the directory beside it, with all its pictures."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True)
    environment.filters["tables"] = tables
    scenes = [scene(entry.result, pictures) for entry in found.scenes]
    measured, settings = found.bench, found.accuracy["rows"]
    all_machines = ", ".join(bench.CONDITIONS)
    names = {machine: words for machine, words in MACHINES.items()
             if machine in bench.CONDITIONS or machine in EMULATED}
    return environment.get_template(TEMPLATE).render(
        found=found, scenes=scenes, made=provenance.record(), clock=CLOCK_HZ / 1e6,
        machines=names, machine=MACHINE, pictures=pictures.name, columns=markdown.MACHINES,
        measured=readme.measured_tables(measured, found.accuracy, found.polys),
        whole=readme_scenes.scenes_table(measured), engines=engines.ENGINES,
        bench_source=source(all_machines, measured),
        modes_source=source(all_machines, measured, "DMA and interrupts off; what the first frame "
                            "makes is there but in its own column"),
        frames_source=source("a1200, a1200-fast", measured,
                             "DMA and interrupts off; the screen cleared"),
        ranks={kind: published.ranked(kind, measured) for kind in published.PUBLISHED},
        places=published.places, floors=published.floors(measured), floored=floored(measured),
        plots={bench_pictures.file_of(group): group.title for group in bench_pictures.GROUPS},
        bench_tables={title: bench.table(measured[kind], list(bench.CONDITIONS))
                      for kind, title in bench.TITLES.items()
                      if measured.get(kind) and kind != "rules"},
        frontiers=report_pictures.frontiers(settings, MACHINE),
        sets=report_pictures.SETS,
        settings=[(f"{name}, {machine}", tables(rows.table(settings, name, machine)))
                  for name, machine in rows.tables(settings)],
        accuracy_source=source(MACHINE, found.accuracy),
        hard=hard_cases(found.hard) if found.hard else None,
        fit_source=source(found.fit.result["machine"], found.fit.result) if found.fit else None,
        polys_030=polys.table(found.polys["rows_68030"]),
        polys_source=source("a1200, a1200-fast, a1200-030", found.polys),
        errors=scene_errors.table([(s["scene"], s["totals"], s["count"], Errors(**s["errors"]))
                               for s in scenes], scenes[0]["machine"]), Source=source)
