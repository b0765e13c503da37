"""The report's plot: error against cycles of all settings together, the frontier marked."""

from pathlib import Path

import matplotlib.pyplot as plt

from tmap.accuracy.pictures import LEAST, MARKS, drawn_by

#: Title and colour of each set: polygons without depth and with it.
SETS = {"medium": ("without depth", "#1f5fa8"), "depth": ("with depth", "#b3541e")}
#: Label of a frontier's point: its offset from the point, in points, and its alignment. There is
#: one for the first point, one for the last, one for the points in between of each set, and one for a mapper that
#: has neighbours there.
PLACES = {"first": ((8, 3), "left"), "last": ((0, -14), "center"), "medium": ((7, 4), "left"),
          "depth": ((7, 5), "left"), "arbitrary": ((0, -14), "center")}
#: Each picture's size in inches, dots an inch and font size: for wide pages, for phones.
SIZES = {"frontier.png": ((9.6, 5.6), 120, 9), "frontier_narrow.png": ((4.4, 6.0), 160, 8)}


def plotted(rows: list[dict], machine: str) -> list[dict]:
    """Returns the rows of the plot: all rows with a texture."""
    return [r for r in rows if r["name"] in SETS and r["machine"] == machine
            and drawn_by(r) in MARKS]


def frontier(rows: list[dict]) -> list[dict]:
    """The rows that none beats in cycles and error of texels alone, cheapest first."""
    best = []
    for row in sorted(rows, key=lambda r: (r["cycles_per_pixel"], r["texel_error_rms"])):
        if not best or row["texel_error_rms"] < best[-1]["texel_error_rms"]:
            best.append(row)
    return best


def frontiers(rows: list[dict], machine: str) -> dict[str, list[dict]]:
    """Returns the frontier of each set."""
    chosen = plotted(rows, machine)
    return {name: frontier([r for r in chosen if r["name"] == name]) for name in SETS}


def plot(rows: list[dict], machine: str, path: Path) -> None:
    """Plots both sets. A point's shape is its mapper or perspective; a hollow point starts spans at
    whole texels or takes vertices as integers."""
    size, dots, letters = SIZES[path.name]
    chosen = plotted(rows, machine)
    with plt.rc_context({"font.size": letters}):
        figure, axes = plt.subplots(figsize=size, layout="constrained")
        for name, (_, colour) in SETS.items():
            for row in (r for r in chosen if r["name"] == name):
                cheap = row["start"] == "truncated" or row["edges"] == "integer"
                axes.scatter(row["cycles_per_pixel"], max(row["texel_error_rms"], LEAST), s=34,
                             marker=MARKS[drawn_by(row)], edgecolors=colour, linewidths=1,
                             facecolors="none" if cheap else colour, alpha=0.8)
        for name, best in frontiers(rows, machine).items():
            axes.plot([r["cycles_per_pixel"] for r in best],
                      [max(r["texel_error_rms"], LEAST) for r in best], "--", lw=1.2,
                      color=SETS[name][1], label=f"frontier {SETS[name][0]}", zorder=0)
            for row, after in zip(best, [*best[1:], None]):
                if not after or drawn_by(row) != drawn_by(after) \
                        or row["texel_error_rms"] > 2 * after["texel_error_rms"]:
                    label(axes, row, best, SETS[name][1])
        for way in dict.fromkeys(map(drawn_by, chosen)):
            axes.scatter([], [], marker=MARKS[way], color="#555", s=34, label=way)
        axes.scatter([], [], marker="o", facecolors="none", edgecolors="#555", s=34,
                     label="hollow: whole start or vertices")
        axes.set(xscale="log", yscale="log", xlabel="cycles a pixel, set-up included",
                 ylabel="rms error, texels")
        ticks = [20, 30, 50, 100, 200]
        axes.set_xticks(ticks, list(map(str, ticks)))
        axes.minorticks_off()
        axes.grid(alpha=0.25)
        axes.spines[["top", "right"]].set_visible(False)
        figure.legend(loc="outside lower center", ncols=4 if size[0] > size[1] else 2,
                      frameon=False)
        figure.savefig(path, dpi=dots)
        plt.close(figure)


def label(axes, row: dict, best: list[dict], colour: str) -> None:
    """Labels a point of the frontier; PLACES has the free side."""
    between = drawn_by(row) if drawn_by(row) in PLACES else row["name"]
    offset, end = PLACES["first" if row is best[0] else "last" if row is best[-1] else between]
    axes.annotate(drawn_by(row), (row["cycles_per_pixel"], max(row["texel_error_rms"], LEAST)),
                  color=colour, xytext=offset, textcoords="offset points", ha=end,
                  fontweight="bold")
