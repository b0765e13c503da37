"""The tables of the pages on the Amiga programs and on chunky to planar."""

import re
from pathlib import Path

from . import bench
from .errors import UserError
from .paths import ROOT
from .readme_modes import MACHINES, lines_of

PROGRAMS = ROOT / "c" / "programs"
#: "/* name - what it does." at a program's beginning.
SUMMARY = re.compile(r"/\* (\w+) - (.+?)\.\n", re.S)
TEMPLATE = re.compile(r'args_read\(((?:\s*"[^"]*")+)')


def about(source: Path) -> tuple[str, str, str]:
    """A program's name, its template of arguments and what it does."""
    text = source.read_text()
    summary, template = SUMMARY.match(text), TEMPLATE.search(text)
    if not summary or summary[1] != source.stem:
        raise UserError(f"{source.name}: does not begin with /* {source.stem} - what it does.")
    arguments = "".join(re.findall(r'"([^"]*)"', template[1])) if template else ""
    return source.stem, f"`{arguments}`" if arguments else "none", " ".join(summary[2].split())


def programs_table() -> str:
    """Markdown: each program."""
    lines = ["| program | template | does |", "|---|---|---|"]
    return "\n".join([*lines, *(f"| {' | '.join(about(source))} |"
                                for source in sorted(PROGRAMS.glob("*.c")))])


#: Chunky to planar: title, row, pixels of a line.
PLANAR_LINES = (("8 bits: eight planes", "c2p_8", 320), ("RGB565: HAM8", "c2p_ham8_16", 160),
                ("R G B A of 8 bits: HAM8", "c2p_ham8_32", 160))


def planar_table(baseline: dict) -> str:
    """Markdown: cycles a pixel of the frame, in plain C beside it."""
    figures = {bench.key(row): bench.cycles(row) for row in baseline["rows"]}
    return lines_of("cycles a pixel", [*MACHINES.values(), "plain C, fast RAM"], [
        [title, *(f"{figures[name, machine, width]:.1f}" for machine in MACHINES),
         f"{figures[f'{name}_c', 'a1200-fast', width]:.0f}"] for title, name, width in PLANAR_LINES])


def tables(baseline: dict) -> dict[str, str]:
    """By title."""
    return {"programs": programs_table(), "chunky to planar": planar_table(baseline)}
