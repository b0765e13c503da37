"""Mutants of assembly."""

import re
from collections.abc import Iterator
from pathlib import Path

from tests.mutants.changes import Mutant
from tmap.base.paths import ROOT
from tmap.build.contracts import UNCOMMENTED

#: Other conditions: those that differ in one case, or the opposite.
CONDITIONS = {"lt": "le", "le": "lt", "gt": "ge", "ge": "gt", "hi": "cc", "ls": "cs", "eq": "ne", "ne": "eq",
              "pl": "mi", "mi": "pl", "vc": "vs", "vs": "vc", "cc": "cs", "cs": "cc", "hs": "hi", "lo": "ls"}
CARRIES = {"addx": "add", "subx": "sub", "negx": "neg", "roxl": "lsl", "roxr": "lsr"}
SIGNS = {"muls": "mulu", "mulu": "muls", "divs": "divu", "divu": "divs", "divsl": "divul", "divul": "divsl",
         "asr": "lsr", "lsr": "asr"}
OPERATIONS = {"add": "sub", "sub": "add", "addq": "subq", "subq": "addq", "adda": "suba", "suba": "adda",
              "addi": "subi", "subi": "addi", "addx": "subx", "subx": "addx", "and": "or", "or": "and", "lsl": "lsr",
              "rol": "ror", "ror": "rol", "neg": "not", "not": "neg", "bset": "bclr", "bclr": "bset"}
#: Those of which another size says something else and is allowed.
SIZED = {"add", "sub", "addx", "subx", "move", "cmp", "asr", "lsr", "lsl", "asl", "neg", "negx", "and", "or", "eor",
         "tst", "clr", "addq", "subq", "rol", "ror", "adda", "suba", "cmpa", "addi", "cmpi", "not"}
SIZES = {"b": "w", "w": "l", "l": "w"}
#: What is not taken away: data, what assembles, and what ends or leads elsewhere, without which nothing would run.
KEPT = re.compile(r"(dc|ds|dcb|blk|rs)\b|equ$|=$|set$|macro$|endm$|x(def|ref)$|section$|cnop$|even$|if|else$|end|include"
                  r"|rept$|reg$|b(ra|sr)\b|j(mp|sr)$|rt[sed]$|routine$|pass$|b(cc|cs|eq|ge|gt|hi|le|ls|lt|mi|ne|pl|vc|vs)\b"
                  r"|db|save|return|dr$|fail$|inline$|einline$|nop$|mexit$")
LINE = re.compile(r"(?P<label>[^\s:]+:?)?(?P<gap>\s+)(?P<operation>[a-z]\w*)(?P<size>\.[bwls])?(?P<blank>\s+|$)"
                  r"(?P<operands>.*?)\s*$")
NUMBER = re.compile(r"(?<![\w$.\\])(\$[0-9a-f]+|\d+)(?![\w.])")
CONDITIONAL = re.compile(r"(b|db|s)(lt|le|gt|ge|hi|ls|eq|ne|pl|mi|vc|vs|cc|cs|hs|lo)$")
ENTRY = re.compile(r"(?:(\w+)\s+macro\b|(\w+):|\s+(?:routine|pass|span|mapper\w*)\s+(\w+))")


def moved(number: str, by: int) -> str:
    """Returns a number's text ``by`` greater."""
    if number.startswith("$"):
        return f"${int(number[1:], 16) + by:0{len(number) - 1}x}"
    return str(int(number) + by)


def of_numbers(operation: str, operands: str, counted: bool) -> Iterator[tuple[str, str]]:
    """Yields kind and operands of changed numbers; ``counted``: a loop's count may be among them."""
    for match in NUMBER.finditer(operands):
        before, value = operands[:match.start()], int(match[0].lstrip("$"), 16 if "$" in match[0] else 10)
        is_constant = before.endswith(("#", "#-", "+", "*", "-")) or operation.startswith("dc") or operation in ("equ", "=")
        scale = re.search(r"\.[wl]\*$", before)
        if is_constant and not scale and (operands.startswith("#") or "#" not in operands):
            kind = "count" if counted and operands.startswith("#") else "constant"
            for by in (1, -1):
                if value + by >= 0:
                    yield kind, before + moved(match[0], by) + operands[match.end():]
        elif operands[match.end():].startswith(("(a", "(sp", "(d")):
            yield "offset", before + moved(match[0], 2) + operands[match.end():]
    for match in re.finditer(r"\b([a-z]\w+_\w+)\((?=a\d|sp)", operands):
        yield "offset", operands[:match.end(1)] + "+4" + operands[match.end(1):]
    for match in re.finditer(r"(?<=,d\d)\.([wl])(?=[*)])", operands):
        yield "size", operands[:match.start(1)] + SIZES[match[1]] + operands[match.end(1):]


def of_operation(operation: str, size: str, operands: str, counted: bool) -> Iterator[tuple[str, str, str, str]]:
    """Yields kind, operation, size and operands of the changes of an instruction."""
    if match := CONDITIONAL.match(operation):
        yield "condition", match[1] + CONDITIONS[match[2]], size, operands
    is_low = operation in ("muls", "mulu") and size == ".l" and ":" not in operands  # the same 32 bits
    for kind, table in (("carry", CARRIES), ("sign", SIGNS), ("operation", OPERATIONS)):
        if operation in table and not (kind == "sign" and is_low):
            yield kind, table[operation], size, operands
    if operation in ("ext", "extb"):
        yield "sign", "", "", ""
    elif operation in SIZED and size[1:] in SIZES and not re.match(r"#\d,(a\d|sp)$", operands):  # always 32 bits
        yield "size", operation, "." + SIZES[size[1:]], operands
    if not KEPT.match(operation):
        yield "count" if counted and operation == "subq" else "removed", "", "", ""
    if not re.match(r"(if|rept|cnop|section|x(def|ref)$|include|ds|rs|macro|routine|pass)", operation):
        for kind, changed in of_numbers(operation, operands, counted):
            yield kind, operation, size, changed


def mutants(file: str) -> list[Mutant]:
    """Returns all mutants of a source file, which is named from the root."""
    lines = (ROOT / file).read_text(encoding="utf-8").splitlines()
    counters = {match[1] for line in lines if (match := re.match(r".*\sdb(?:ra|f)\s+(d\d)", line))}
    found, within = [], ""
    for number, line in enumerate(lines, 1):
        code = "" if line.startswith("*") else UNCOMMENTED.match(line)[0].rstrip()
        if entry := ENTRY.match(code):
            within = next(filter(None, entry.groups()))
        match = LINE.match(code)
        if not match:
            continue
        label, gap, operation, size, operands = (match[name] or "" for name in (
            "label", "gap", "operation", "size", "operands"))
        counted = operands.rpartition(",")[2].strip() in counters and operands.startswith("#")
        for kind, *parts in of_operation(operation, size, operands, counted):
            operation_, size_, operands_ = parts
            changed = f"{operation_}{size_}"
            after = f"{label}{gap}{changed}{' ' * max(len(operation + size + match['blank']) - len(changed), 1)}{operands_}"
            after = after.rstrip() if changed else label
            found.append(Mutant(file, number, within, kind, " ".join(code.split()), " ".join(after.split()), after))
    return found


def files(*rooms: str) -> list[str]:
    """Returns the sources of rooms of src68k, from the root."""
    return [path.relative_to(ROOT).as_posix() for room in rooms for path in sorted((ROOT / "src68k" / room).glob("*.[si]"))]


def main_file(path: Path) -> bool:
    """Returns True for a file that is assembled by itself."""
    return path.suffix == ".s"
