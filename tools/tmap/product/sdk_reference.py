"""The SDK's reference: every call and every structure, from the C headers, the contract blocks and the baseline."""

import json
import re
from dataclasses import dataclass, field
from pathlib import Path

from tmap.base.markdown import MACHINES, table
from tmap.base.paths import BASELINE, ROOT
from tmap.bench import bench
from tmap.build.contracts import REGISTERS, Contract
from tmap.product import sdk_include

HEAD = """\
# Reference

Every call that the headers declare, header by header, and the structures and constants that these take. Generated from
the headers, the contract blocks of the assembly and the committed figures of the bench: do not edit.

* Begin with `polygon/polygon.h` (`polygon_draw`), `triangle/triangles.h`, `mesh/mesh.h`, `texture/map.h` and
  `screen/planar.h`; for the texture units with `n64/n64.h` and `glide/glide.h`. Other headers are parts of these.
* A routine of assembly has its registers: `name` takes them, `_name` the same arguments from the stack, in this order,
  32 bits each. It keeps all registers but those under *changes*.
* *reads*, *writes* say more than the types: without them a routine reads what its pointers to `const` point to, and
  writes what its others do.
* *error* is the largest error, against exact arithmetic on the same arguments; none: every bit is exact.
* Cycles are counted on a cycle-exact emulated A1200 (68EC020, 14.19 MHz), instruction cache warm, DMA and interrupts
  off, the cost of the call subtracted: with fast RAM, with code and tables there and textures and frame in chip RAM,
  and with chip RAM alone. *length*: pixels of a line or of a triangle, points of a mesh.
* `fix16` is signed 16.16 fixed point. Formats such as 12.4 are whole bits and bits of fraction.

"""
#: Kinds of the bench's rows, and what a figure counts.
UNITS = {"rows": "cycles a pixel", "lines": "cycles a line", "points": "cycles a point",
         "polygons": "cycles a triangle", "instructions": "cycles"}
COST_ROWS = re.compile(r"\bbench rows? ((?:\w+(?:, | and |(?= for|[:;]|$)))+)")
TOKEN = re.compile(r"""(?P<comment>/\*.*?\*/)|(?P<directive>^\#(?:[^\n]*\\\n)*[^\n]*$)|(?P<blank>\n[ \t]*\n)
    |(?P<type>^(?:struct|enum|union|typedef)\b[^;{(]*(?:\{[^}]*\})?[^;(]*;|^typedef\b[^;]*;)
    |(?P<inline>^static\s+inline\b[^;{]*\)\s*\{.*?^\})|(?P<call>^[a-z][\w \t]*?[ *]\w+\((?:[^;{}]|\n)*?\);)
    |(?P<passes>^\w+\s+\w+(?:,\s*\w+)*;)""", re.DOTALL | re.MULTILINE | re.VERBOSE)
NAME = re.compile(r"\b(\w+)\(")
INDENTED = re.compile(r"^ {7}\S", re.MULTILINE)


@dataclass
class Call:
    """A declared routine. ``text``: its declaration; ``about``: the comment above it."""

    name: str
    text: str
    about: str


@dataclass
class Header:
    """A header: what its first comment says, its calls, and the text of its types, comments included. ``listed``: that
    comment with its lines, if it has indented ones."""

    path: Path
    about: str = ""
    listed: str = ""
    calls: list[Call] = field(default_factory=list)
    types: list[str] = field(default_factory=list)


def words(comment: str) -> str:
    """Returns a comment's text in one line, without its marks."""
    return " ".join(comment.removeprefix("/*").removesuffix("*/").split())


def read(path: Path) -> Header:
    """Reads a public header, which is named relative to c/."""
    found, above, last = Header(path), "", ""
    for token in TOKEN.finditer((ROOT / "c" / path).read_text(encoding="utf-8")):
        kind, text = token.lastgroup, token[0]
        if kind == "comment" and token.start() == 0:
            found.about = words(text)
            if INDENTED.search(text):
                lines = text.removeprefix("/*").removesuffix("*/").rstrip().splitlines()
                found.listed = "```\n" + "\n".join([lines[0].strip(), *(line[3:] for line in lines[1:])]) + "\n```"
        elif kind == "comment":
            above = last = text
        elif kind == "type":
            found.types.append(f"{last}\n{text}".strip())
            last = ""
        elif kind == "blank":
            above = last = ""
        elif kind in ("call", "inline"):
            text = " ".join(text.split("{")[0].split()).removesuffix(";")
            found.calls.append(Call(NAME.search(text)[1], f"{text};", words(above)))
        elif kind == "passes":
            form, _, names = text.rstrip(";").partition(" ")
            found.calls += [Call(name, f"{form} {name};", words(above)) for name in names.replace(",", " ").split()]
    return found


def rows_of(contract: Contract) -> list[str]:
    """Returns the names of the bench's rows that a contract's cost names."""
    return [name for match in COST_ROWS.finditer(contract.cost) for name in re.findall(r"\w+", match[1])
            if name != "and"]


def figures(names: list[str], measured: dict) -> str:
    """Returns a table of the bench's rows, or "" where there are none."""
    lines = []
    for kind, unit in UNITS.items():
        found = bench.figures([row for row in measured[kind] if row["name"] in names])
        for name, length in dict.fromkeys((name, length) for name, _, length in found):
            cells = (found.get((name, machine, length)) for machine in MACHINES)
            lines.append([f"`{name}`", f"{length:,}", unit,
                          *("" if cell is None else f"{cell:,.1f}" for cell in cells)])
    return table(["bench row", "length", "unit", *MACHINES.values()], lines, "lrlr") if lines else ""


def prototype(contract: Contract) -> str:
    """Returns the declaration in C of a routine that lists declare."""
    given = ", ".join(spaced(each.type) for each in contract.inputs)
    return f"{spaced(contract.outputs[0].type) if contract.outputs else 'void'} {contract.name}({given or 'void'});"


def spaced(words: str) -> str:
    """Returns a contract's type as C has it."""
    return words.replace("*", " *").replace("  *", " *")


def sentence(summary: str) -> str:
    """Returns a summary as a sentence, which a name or a formula may begin."""
    return re.sub(r"^[a-z]+(?=[ ,])(?! [-*/+])", lambda match: match[0].capitalize() if len(match[0]) > 1 else match[0],
                  summary) + "."


def entry(contract: Contract, call: Call | None, measured: dict) -> str:
    """Returns what the page says of a routine of assembly."""
    made = figures(rows_of(contract), measured)
    changed = "everything" if len(contract.trashes) == len(REGISTERS) else sdk_include.trashes(contract.trashes)
    lines = [f"* {way} `{each.register}` {each.type}: {each.meaning}"
             for way, some in (("in", contract.inputs), ("out", contract.outputs)) for each in some]
    lines.append(f"* changes {changed}")
    lines += [f"* {title}: {text}" for title in ("reads", "writes", "formats", "error", "cost")
              if (text := getattr(contract, title)) and not (title == "cost" and made and COST_ROWS.fullmatch(text))]
    head = f"### {contract.name}\n\n`{call.text if call else prototype(contract)}`\n\n{sentence(contract.summary)}\n\n"
    return head + "\n".join(lines) + (f"\n\n{made}" if made else "")


def section(header: Header, contracts: dict[str, Contract], measured: dict) -> str:
    """Returns a header's part of the page."""
    parts = [f"## {header.path.as_posix()}", header.listed or header.about]
    for call in header.calls:
        if contract := contracts.get(call.name):
            parts.append(entry(contract, call, measured))
        else:
            parts.append(f"### {call.name}\n\n`{call.text}`" + (f"\n\n{call.about}" if call.about else ""))
    if header.types:
        parts += ["### its structures and constants", "```c\n" + "\n\n".join(header.types) + "\n```"]
    return "\n\n".join(part for part in parts if part)


def reference(paths: list[Path], routines: list[Contract]) -> str:
    """Returns the page. ``paths``: the public headers, relative to c/; ``routines``: those of assembly."""
    measured = json.loads(BASELINE.read_text(encoding="utf-8"))
    contracts, headers = {each.name: each for each in routines}, [read(path) for path in paths]
    declared = {call.name for header in headers for call in header.calls}
    spans = [each for each in routines if each.name not in declared]
    contents = [f"* {header.path.as_posix()}: {header.about.split('. ')[0].rstrip('.')}" for header in headers]
    parts = [HEAD + "\n".join([*contents, "* spans, which `polygon/span_list.h` lists"])]
    parts += [section(header, contracts, measured) for header in headers]
    parts += ["## Spans\n\nThe routines of `polygon/span_list.h`: each draws the lines of a table."]
    parts += [entry(each, None, measured) for each in spans]
    return "\n\n".join(parts) + "\n"
