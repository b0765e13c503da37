"""The report's page: the content of its sections. The template is report.html in this folder."""

import json
from dataclasses import dataclass
from pathlib import Path

import jinja2
from markdown_it import MarkdownIt
from markupsafe import Markup

from tmap.accuracy import accuracy, engines, polys, showcase
from tmap.accuracy.errors import Errors
from tmap.accuracy.hard_report import every_case
from tmap.base import markdown
from tmap.bench import bench, published
from tmap.guest import provenance
from tmap.guest.cache import Entry
from tmap.guest.emulator import CLOCK_HZ, MACHINES as EMULATED
from tmap.report import pictures as report_pictures, readme_cycles, readme_modes, readme_scenes
from tmap.report.data import MACHINE, Found

TEMPLATES = Path(__file__).parent
TEMPLATE = "report.html"
#: The machines of all figures.
MACHINES = {
    "a1200": "68EC020, 2 MB of chip RAM and nothing else",
    "a1200-fast": "the same with 8 MB of fast RAM, which has code, tables, textures and frame",
    "a1200-mixed": "a1200-fast with textures and frame in chip RAM",
    "a1200-030": "a1200-fast with a 68EC030 at the same clock; its data cache on where said"}
#: Titles of the kinds of bench rows.
BENCH_KINDS = {"rows": "Cycles a pixel (step_*: a step)",
               "lines": "Cycles a line: edges and line tables",
               "points": "Cycles a point (mesh_looks: a normal, mesh_faces: a face)",
               "instructions": "Cycles of instructions, with a loop's around 16 of them",
               "frames": "Cycles a frame of whole scenes",
               "modes": "Cycles a pixel of texture engines' modes (_c: in plain C)",
               "first_frames": "Cycles more of the first frame of a mode"}
#: Rows of the bench that are compared with memory alone.
FLOORED = ("gouraud", "generated", "affine_row", "affine_column", "affine_addx", "tiled",
           "columns", "arbitrary", "affine_lit", "affine_gouraud", "persp_every16", "persp_every8",
           "persp_pixel", "persp_pixel_fine")
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


@dataclass
class Source:
    """The source of figures, to be shown beside them."""

    machine: str
    about: dict  # emulator, compiler, commit and, in most, conditions
    conditions: str = ""

    def __html__(self) -> str:
        words = [self.machine, (self.conditions or self.about.get("conditions", "")).rstrip(" ."),
                 self.about["emulator"], self.about["compiler"], f"commit {self.about['commit']}"]
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
                    "source": Source(about["machine"], about, "DMA and interrupts off")}


def floored(measured: dict) -> list[dict]:
    """Returns rows of the bench, 256 pixels, each with its cycles and those of memory alone."""
    figures, made = bench.figures(measured["rows"]), []
    for name in FLOORED:
        cycles = [figures[name, machine, published.LONG] for machine in markdown.MACHINES]
        floors = published.floors(measured, "floor_store" if name in STORES else "floor_copy")
        made.append({"name": name, "cells": list(zip(cycles, floors)), "stores": name in STORES})
    most = max(row["cells"][0][0] for row in made)
    return sorted((row | {"most": most} for row in made), key=lambda row: row["cells"][0][0])


def scene_errors(scenes: list[dict]) -> list[showcase.Shown]:
    """Returns scenes with the errors of their texels."""
    return [showcase.Shown(s["scene"], s["totals"], s["count"], Errors(**s["errors"]))
            for s in scenes]


def hard_cases(entry: Entry) -> dict:
    """Returns the number of hard cases, the rows that exceed a bound, and the rows nearest to a
    bound among the most exact spans."""
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


def all_settings(found: dict) -> list[tuple[str, Markup]]:
    """Returns title and table of each set on each machine."""
    rows = found["rows"]
    return [(f"{name}, {machine}", tables(accuracy.table(rows, name, machine)))
            for name in dict.fromkeys(r["name"] for r in rows)
            for machine in dict.fromkeys(r["machine"] for r in rows)]


def page(found: Found, pictures: Path) -> str:
    """Returns the text of index.html; ``pictures``: the directory beside it, with all its
    pictures."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True)
    environment.filters["tables"] = tables
    scenes = [scene(entry.result, pictures) for entry in found.scenes]
    measured = found.bench
    all_machines = ", ".join(bench.CONDITIONS)
    names = {machine: words for machine, words in MACHINES.items()
             if machine in bench.CONDITIONS or machine in EMULATED}
    return environment.get_template(TEMPLATE).render(
        found=found, scenes=scenes, made=provenance.record(), clock=CLOCK_HZ / 1e6,
        machines=names, machine=MACHINE, pictures=pictures.name, columns=markdown.MACHINES,
        versus=readme_cycles.versus_table(measured),
        effects=readme_cycles.effects_table(measured),
        rules=readme_cycles.rules_table(measured), meshes=readme_cycles.mesh_table(measured),
        whole=readme_scenes.scenes_table(measured), steps=readme_modes.steps_table(measured),
        uncalled=readme_modes.uncalled_table(measured),
        engines={name: (readme_modes.modes_table(measured, engine),
                        readme_modes.formats_table(measured, engine))
                 for name, engine in engines.ENGINES.items()},
        meant={name: engine.meant for name, engine in engines.ENGINES.items()},
        bench_source=Source(all_machines, measured),
        modes_source=Source(all_machines, measured, "DMA and interrupts off; what the first frame "
                            "makes is there but in its own column"),
        frames_source=Source("a1200, a1200-fast", measured,
                             "DMA and interrupts off; the screen cleared"),
        ranks={kind: published.ranked(kind, measured) for kind in published.PUBLISHED},
        places=published.places, floors=published.floors(measured), floored=floored(measured),
        bench_tables={title: bench.table(measured[kind], list(bench.CONDITIONS))
                      for kind, title in BENCH_KINDS.items() if measured.get(kind)},
        frontiers=report_pictures.frontiers(found.accuracy["rows"], MACHINE),
        sets=report_pictures.SETS, settings=all_settings(found.accuracy),
        accuracy_source=Source(MACHINE, found.accuracy),
        perspective=readme_cycles.perspective_table(measured, found.accuracy),
        hard=hard_cases(found.hard) if found.hard else None,
        polys=polys.table(found.polys["rows"]), polys_030=polys.table(found.polys["rows_68030"]),
        polys_source=Source("a1200, a1200-fast, a1200-030", found.polys),
        errors=showcase.table(scene_errors(scenes), scenes[0]["machine"]), Source=Source)
