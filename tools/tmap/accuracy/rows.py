"""Rows of accuracy.json: the frontier, tables and JSON text."""

from tmap.base import markdown

#: Mappers without texture. All others draw the same picture, so they share a frontier; each of
#: these is compared with its own rows only.
UNTEXTURED = ("flat", "gouraud")
COLUMNS = ("mapper", "edges", "gradients", "start", "perspective", "cycles_per_polygon",
           "cycles_per_pixel", "coverage_errors_per_million", "texel_error_max", "texel_error_rms",
           "wrong_texels_percent", "frontier")


def beats(a: dict, b: dict, measures: tuple[str, ...]) -> bool:
    """Returns True if ``a`` is nowhere worse than ``b`` and better in one measure."""
    pairs = [(a[m], b[m]) for m in measures]
    return all(x <= y for x, y in pairs) and any(x < y for x, y in pairs)


def mark_frontier(rows: list[dict]) -> None:
    """Sets ``frontier``: True if no row of the same kind beats this one."""
    measures = ("cycles_per_polygon", "coverage_errors_per_million", "texel_error_rms")

    def kind(row: dict) -> tuple:
        return row["name"], row["machine"], row["mapper"] if row["mapper"] in UNTEXTURED else "texture"

    for row in rows:
        row["frontier"] = not any(kind(other) == kind(row) and beats(other, row, measures)
                                  for other in rows)


def table(rows: list[dict], name: str, machine: str) -> str:
    """Returns a Markdown table of one set on one machine, cheapest first within a mapper."""
    chosen = [r for r in rows if r["name"] == name and r["machine"] == machine]
    order = list(dict.fromkeys(r["mapper"] for r in chosen))
    chosen.sort(key=lambda r: (order.index(r["mapper"]), r["cycles_per_polygon"]))
    rows = [[*(f"{row[c]:,}" if isinstance(row[c], float) else row[c] for c in COLUMNS[:-1]),
             "yes" if row["frontier"] else ""] for row in chosen]
    return markdown.table([c.replace("_", " ") for c in COLUMNS], rows, "lllllrrrrrrl") + "\n"


def tables(rows: list[dict]) -> list[tuple[str, str]]:
    """Returns name and machine of each table that rows make."""
    return [(name, machine) for name in dict.fromkeys(r["name"] for r in rows)
            for machine in dict.fromkeys(r["machine"] for r in rows)]


def report(found: dict) -> str:
    """Returns the text of accuracy.md."""
    text = ("# What accuracy costs\n\n" + found["conditions"] + f" {found['emulator']}, "
            f"{found['compiler']}.\n")
    return text + "".join(f"\n## {name}, {machine}\n\n" + table(found["rows"], name, machine)
                          for name, machine in tables(found["rows"]))
