"""The page of mutants."""

import textwrap
from collections import Counter
from pathlib import Path

from tests.mutants.changes import KINDS
from tests.mutants.explained import explanations
from tests.mutants.judge import KILLED, SAME, SURVIVES, UNBUILT
from tests.mutants.rooms import LISTED

PAGE = Path(__file__).with_name("MUTANTS.md")
WIDTH = 130
UNEXPLAINED = "**Not explained.**"
HEAD = """# Mutants

`make mutants` changes one line of assembly at a time, builds what the line is in, and runs what should notice it on
the second processor: the trials of the kernels that have it or call it, then frames of polygons and scenes that the
suite compares with the model. C and the model have rooms of mutants too, which its option `--room` tries and this
page does not list yet. A condition becomes another one, a carry is left out, a constant or an offset is one more or
less, an operation has another size or sign or is its opposite, an instruction is removed. Which lines are chosen
depends on a seed and on the lines alone. Changes that make the same code, or that cannot be built, do not count. Those
noticed by counts draw the same pictures by other spans or rules of lowering: they cost time, which the baselines of
`bench`, `accuracy` and `polys` hold. This page is written by that command; `tests/mutants/explained.json` has the
reasons below.
"""


def key(result: dict) -> tuple[str, str, str, str]:
    """Returns a result's key: as Mutant.key."""
    return result["file"], result["within"], result["before"], result["after"]


def counts(found: list[dict], field: str, names: tuple[str, ...]) -> str:
    """Returns a table of how mutants ended, a row for each value of a field."""
    rows = []
    for name in (*names, "all"):
        some = [each for each in found if name in (each[field], "all")]
        ends = Counter(each["how"] for each in some)
        explained = sum(each["how"] == SURVIVES and key(each) in explanations() for each in some)
        total = sum(ends[how] for how in (*KILLED, SURVIVES))
        rows.append([name, *(f"{n:,}" for n in (total, *(ends[how] for how in KILLED), explained, ends[SURVIVES] - explained))])
    return columns([[field, "mutants", *KILLED, "explained", "unexplained"], *rows])


def columns(rows: list[list[str]]) -> str:
    """Returns rows as text in columns: the tables in Markdown are those that scripts/tmap readme writes."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ("  ".join(cell.rjust(width) if k else cell.ljust(width) for k, (cell, width) in enumerate(zip(row, widths)))
             for row in rows)
    return "\n".join(["```text", *(line.rstrip() for line in lines), "```"])


def listed(found: list[dict]) -> list[str]:
    """Returns the lines of those that nothing notices, by room and reason."""
    lines = []
    for room in LISTED:
        reasons: dict[str, list[dict]] = {}
        for each in sorted((e for e in found if e["room"] == room and e["how"] == SURVIVES), key=lambda e: (e["file"], e["line"])):
            reasons.setdefault(explanations().get(key(each), UNEXPLAINED), []).append(each)
        if reasons:
            lines += ["", f"## {room}"]
        for why, some in reasons.items():
            lines += ["", *textwrap.wrap(why, WIDTH, break_on_hyphens=False, break_long_words=False), ""]
            for each in some:
                after = f"`{each['after']}`" if each["after"] else "removed"
                lines += textwrap.wrap(f"* `{each['file']}`, {each['within']}: `{each['before']}`: {after}", WIDTH,
                                       subsequent_indent="  ", break_on_hyphens=False, break_long_words=False)
    return lines


def write(found: list[dict]) -> None:
    """Writes the page."""
    found = [each for each in found if each["room"] in LISTED]
    left_out = Counter(each["how"] for each in found)
    parts = [HEAD, counts(found, "room", LISTED), "", counts(found, "kind", KINDS), "",
             f"{left_out[SAME]} more changes made the same code, {left_out[UNBUILT]} could not be built.", "",
             "Those that nothing notices, by what makes them equivalent; where it says so, they are not, and what would tell is named:", *listed(found)]
    PAGE.write_text("\n".join(parts) + "\n")
