"""The tables of the pages on the Amiga programs and on chunky to planar."""

import json
import re
from pathlib import Path

from tmap.base.errors import UserError
from tmap.base.markdown import MACHINES, table
from tmap.base.paths import PROGRAMS_BASELINE, ROOT
from tmap.bench import bench

PROGRAMS = ROOT / "c" / "programs"
#: "/* name - summary." at a program's beginning.
SUMMARY = re.compile(r"/\* (\w+) - (.+?)\.\n", re.S)
TEMPLATE = re.compile(r'args_read\(((?:\s*"[^"]*")+)')


def about(source: Path) -> tuple[str, str, str]:
    """Returns a program's name, its template of arguments and its summary."""
    text = source.read_text()
    summary, template = SUMMARY.match(text), TEMPLATE.search(text)
    if not summary or summary[1] != source.stem:
        raise UserError(f"{source.name}: does not begin with /* {source.stem} - what it does.")
    arguments = "".join(re.findall(r'"([^"]*)"', template[1])) if template else ""
    return source.stem, f"`{arguments}`" if arguments else "none", " ".join(summary[2].split())


#: Chunky to planar: title of the frame's format, row, pixels of a line; for each display of 320x256
#: its title and the end of the row's name.
PLANAR_LINES = (
    ("8 bits", "c2p_8", 320, (("eight planes", "_low"),)),
    ("8 bits, with the blitter", "c2p_8_blit", 320, (("the processor's part", "_low"),)),
    ("8 bits, with the blitter, which merges twice", "c2p_8_blits", 320, (("the processor's part", "_low"),)),
    ("8 bits, 2x1", "c2p_8_2x1", 160, (("eight planes", "_low"),)),
    ("8 bits, 2x1, with the blitter", "c2p_8_2x1_blit", 160, (("the processor's part", "_low"),)),
    ("8 bits, 2x1, with the blitter, which merges too", "c2p_8_2x1_blits", 160, (("the processor's part", "_low"),)),
    *((title, row, 160, (("HAM8, 640 dots", "_high"), ("HAM8, 1280 dots", "_super")))
      for title, row in (("`rgb565`", "c2p_ham8_16"), ("`rgba5551`", "c2p_ham8_5551"),
                         ("`rgba8888`", "c2p_ham8_32"))))


def planar_table(baseline: dict) -> str:
    """A Markdown table: cycles a pixel of the frame, display off and with the frame's own."""
    figures, rows = bench.figures(baseline["rows"]), []
    for title, name, width, displays in PLANAR_LINES:
        for shown, end in displays:
            cells = [f"{figures[name + kind, machine, width]:.1f}"
                     for kind in ("", end) for machine in ("a1200-mixed", "a1200")]
            rows.append([f"{title}: {shown}", *cells,
                         f"{figures[in_c]:.0f}" if (in_c := (f"{name}_c", "a1200-mixed", width)) in figures else ""])
    titles = [f"{display}: {MACHINES[machine]}" for display in ("display off", "shown")
              for machine in ("a1200-mixed", "a1200")]
    return table(["cycles a pixel", *titles, "plain C, off: data in chip"], rows)


def scenes_table() -> str:
    """A Markdown table: bytes of programs built for one scene, and the mean cycles of their frames."""
    rows = sorted(json.loads(PROGRAMS_BASELINE.read_text()).items(), key=lambda row: row[1]["code"] + row[1]["scene"])
    return table(["scene", "bytes without maps", "code and tables", "the scene", "maps", "cycles a frame"],
                 [[name, *(f"{n:,}" for n in (row["code"] + row["scene"], row["code"], row["scene"], row["maps"],
                                              row["cycles"]))] for name, row in rows])


def tables(baseline: dict) -> dict[str, str]:
    """Returns the tables by title."""
    programs = [about(source) for source in sorted(PROGRAMS.glob("*.c"))]
    return {"programs": table(["program", "template", "does"], programs, "l"),
            "programs of scenes": scenes_table(), "chunky to planar": planar_table(baseline)}
