"""Pictures of the bench: a figure for each group of rows, addx against swap first."""

from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path

import matplotlib.pyplot as plt

from tmap.bench import bench, published

ROW_HEIGHT, WIDTH = 0.24, 10  # inches
AS_MEASURED = ("steps", "triangles")  # groups in the bench's order, the others begin with the fastest
LOG = 12  # times the least that the greatest figure is, from which on an axis is logarithmic


@dataclass(frozen=True)
class Group:
    """Rows of a kind that one figure shows. ``floor``: the row of memory alone that is marked; ``published``: the
    kind of published loops that are shown beside them."""

    name: str
    title: str
    kind: str
    rows: tuple[str, ...]  # patterns; a row is in the first group that has one
    floor: str = ""
    published: str = ""


GROUPS = (
    Group("addx", "Textured pixels by addx, by swap and in C: cycles a pixel of a span", "rows",
          ("affine_addx", "affine_swap", "affine_c", "generated"), "floor_copy", "textured"),
    Group("steps", "addx against swap: cycles of a step of one, two and three values, and of a pixel with it", "rows",
          ("*_swap_[123]", "*_addx_[123]", "*_chain_[123]")),
    Group("light", "Gouraud and light: cycles a pixel of a span", "rows",
          ("gouraud*", "affine_lit*", "affine_gouraud", "light*"), "floor_copy", "lit"),
    Group("perspective", "Perspective: cycles a pixel of a span", "rows", ("persp_*",), "floor_copy"),
    Group("n64", "The N64's texture engine: cycles a pixel of a pass", "rows", ("n64_*",)),
    Group("glide", "Glide's texture unit: cycles a pixel of a pass", "rows", ("glide_*",)),
    Group("screen", "Whole screens: cycles a pixel", "rows", ("c2p_*", "rotator*", "*_low", "*_super")),
    Group("wide", "Spans of 16 and 32 bits: cycles a pixel", "rows", ("*_16", "*_32", "*_16_*", "*_32_*")),
    Group("spans", "Other spans of 8 bits: cycles a pixel", "rows", ("*",), "floor_copy"),
    Group("edges", "Tables of lines: cycles a line", "lines", ("*",)),
    Group("mesh", "Meshes and set-up: cycles a point, a normal or a face", "points", ("*",)),
    Group("triangles", "Triangles of a batch, by their pixels: cycles a triangle", "polygons", ("*",)),
)


def file_of(group: Group) -> str:
    """Returns the name of a group's picture."""
    return f"bench_{group.name}.png"


def group_of(kind: str, row: str) -> Group | None:
    """Returns the group of a row; None if its kind has no figure."""
    return next((group for group in GROUPS
                 if group.kind == kind and any(fnmatch(row, pattern) for pattern in group.rows)), None)


def bars(group: Group, measured: dict) -> list[tuple[str, list[float | None]]]:
    """Returns what a figure shows: a name, and the cycles on each machine of the bench, None where they were not
    measured. Spans have their longest length, triangles all lengths."""
    rows = [row for row in measured[group.kind] if group_of(group.kind, row["name"]) is group]
    values = bench.figures(rows)
    longest: dict[str, int] = {}
    for row in rows:
        longest[row["name"]] = max(longest.get(row["name"], 0), row["length"])
    keys = dict.fromkeys((row["name"], row["length"]) for row in rows
                         if group.kind == "polygons" or row["length"] == longest[row["name"]])
    return [(f"{name} ({length})", [values.get((name, machine, length)) for machine in machines_of(measured)])
            for name, length in keys]


def machines_of(measured: dict) -> list[str]:
    """Returns the machines that have rows, in their order."""
    return list(dict.fromkeys(row["machine"] for group in GROUPS for row in measured[group.kind]))


def loops(group: Group, machines: list[str]) -> list[tuple[str, list[float | None]]]:
    """Returns the published loops of a group as ``bars`` does."""
    columns = list(published.MACHINES)
    return [(f"published: {loop.name}", [loop.cycles[columns.index(machine)] if machine in columns else None
                                         for machine in machines])
            for loop in published.PUBLISHED.get(group.published, [])]


def draw(group: Group, measured: dict, path: Path) -> None:
    """Draws a group's figure: bars of each machine, the figure of the first at its end."""
    machines = machines_of(measured)
    shown = bars(group, measured) + loops(group, machines)
    if group.name not in AS_MEASURED:
        shown.sort(key=lambda each: min(filter(None, each[1])))
    figure, axes = plt.subplots(figsize=(WIDTH, ROW_HEIGHT * len(shown) + 1.6), layout="constrained")
    height = 0.8 / len(machines)
    for k, machine in enumerate(machines):
        lengths = [values[k] or 0 for _, values in shown]
        places = [i + (k - (len(machines) - 1) / 2) * height for i in range(len(shown))]
        axes.barh(places, lengths, height, label=machine)
        for place, length in zip(places, lengths):
            if length:
                axes.text(length, place, f" {length:,.1f}", va="center", fontsize=5.5)
    found = [value for _, values in shown for value in values if value]
    if max(found) > LOG * min(found):
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter("{x:g}")
        axes.xaxis.set_minor_formatter("")
    floors = {row["machine"]: bench.cycles(row) for row in measured["rows"] if row["name"] == group.floor}
    for k, machine in enumerate(machines):
        if machine in floors:
            axes.axvline(floors[machine], color=f"C{k}", linestyle=":", label=f"memory alone, {machine}")
    axes.set_yticks(range(len(shown)), [name for name, _ in shown], fontsize=7)
    axes.set_ylim(len(shown) - 0.4, -0.6)
    axes.margins(x=0.08)
    axes.set_title(group.title, fontsize=10)
    axes.set_xlabel("68020 cycles, emulated A1200; in brackets the pixels or lines of a call", fontsize=8)
    axes.tick_params(axis="x", labelsize=8)
    axes.grid(axis="x", alpha=0.3)
    figure.legend(fontsize=7, loc="outside lower center", ncols=6)
    figure.savefig(path, dpi=100)
    plt.close(figure)


def write(measured: dict, out: Path) -> list[str]:
    """Draws the figures of the groups that have rows; returns their files' names."""
    names = []
    for group in GROUPS:
        if any(group_of(group.kind, row["name"]) is group for row in measured[group.kind]):
            names.append(file_of(group))
            draw(group, measured, out / names[-1])
    return names
