"""Mutants of C."""

import re
from collections.abc import Iterator

from tests.mutants.changes import Mutant
from tmap.base.paths import ROOT

#: Comments and strings, which are left alone.
BLIND = re.compile(r"/\*.*?\*/|\"(?:[^\"\\]|\\.)*\"|'(?:[^'\\]|\\.)*'", re.DOTALL)
#: A function begins with its name at the start of a line.
FUNCTION = re.compile(r"[A-Za-z_].*?\b(\w+)\((?!\()")
#: What replaces what, by kind: a pattern, and the texts instead.
CHANGES = tuple((kind, re.compile(pattern), others) for kind, pattern, others in (
    ("condition", r" < ", (" <= ",)), ("condition", r" <= ", (" < ",)), ("condition", r" > ", (" >= ",)),
    ("condition", r" >= ", (" > ",)), ("condition", r" == ", (" != ",)), ("condition", r" != ", (" == ",)),
    ("condition", r" && ", (" || ",)), ("condition", r" \|\| ", (" && ",)), ("condition", r"!(?=[\w(])", ("",)),
    ("operation", r" \+ ", (" - ",)), ("operation", r" - ", (" + ",)), ("operation", r" \+= ", (" -= ",)),
    ("operation", r" -= ", (" += ",)), ("operation", r" & ", (" | ",)), ("operation", r" \| ", (" & ",)),
    ("operation", r" >> ", (" << ",)), ("operation", r" << ", (" >> ",)), ("operation", r"(?<=[(= ,])-(?=[a-z(])", ("",)),
    ("sign", r"\(uint32\)", ("(int32)",)), ("sign", r"\(int32\)", ("(uint32)",)), ("sign", r"\(uint16\)", ("(int16)",)),
    ("size", r"\((?:u?int16|uint8)\)", ("",)),
    ("constant", r"(?<!return )(?<![\w.\[])\d+(?![\w.])", ("+1", "-1"))))
STATEMENT = re.compile(r"\s+(?:[\w.>\[\]*()-]+ [-+*|&^<>]*= [^;]*|[\w.>\[\]-]+(?:\+\+|--)|[a-z]\w*\(.*\));$")


def changed_lines(line: str) -> Iterator[tuple[str, str]]:
    """Yields kind and text of changed lines."""
    for kind, pattern, others in CHANGES:
        for match in pattern.finditer(line):
            for other in others:
                if kind == "constant":
                    value = int(match[0], 8 if len(match[0]) > 1 and match[0][0] == "0" else 10) + int(other)
                    other = str(value)
                    if value < 0:
                        continue
                yield kind, line[:match.start()] + other + line[match.end():]
    if STATEMENT.match(line):
        yield "removed", line[:len(line) - len(line.lstrip())] + ";"


def mutants(file: str) -> list[Mutant]:
    """Returns all mutants of a source file, which is named from the root: of lines in functions."""
    text = (ROOT / file).read_text(encoding="utf-8")
    seen = BLIND.sub(lambda match: re.sub(r"[^\n]", "\0", match[0]), text).splitlines()
    found, within, is_inside = [], "", False
    for number, code in enumerate(seen, 1):
        if match := FUNCTION.match(code):
            within = match[1]
        if code[:1] == "{":
            is_inside = True
        elif code[:1] == "}":
            is_inside = False
        code = code.rstrip("\0 ")
        if not is_inside or not code.strip() or code.lstrip().startswith("#") or "\0" in code:
            continue
        for kind, changed in changed_lines(code):
            found.append(Mutant(file, number, within, kind, " ".join(code.split()), " ".join(changed.split()), changed))
    return found


def files(*rooms: str) -> list[str]:
    """Returns the sources of rooms of c, from the root."""
    return [path.relative_to(ROOT).as_posix() for room in rooms for path in sorted((ROOT / "c" / room).glob("*.c"))]
