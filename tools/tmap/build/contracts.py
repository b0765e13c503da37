"""Reads the contract block above each assembly routine and checks the tree against it.

    ; name - summary
    ;
    ; like:    another routine, whose fields count where this block has none, and whose entries
    ;          of in and out count if this block has none of the register
    ; in:      d0  int32  meaning
    ; out:     d0  fix16  meaning
    ; trashes: d0-d2/a1, everything, or - for nothing
    ; reads: writes: formats: error: cost:    free text

The block is a comment of its own, which begins with that title. Fields are in this order. A longer
one continues on indented lines; an empty one is left out. Without ``trashes`` a routine may change
the registers that C allows, TRASHED. Without ``error`` a kernel has none. Without ``reads`` or
``writes`` a routine reads what its pointers to const point to or writes what its others do.
``cost`` is no other routine's: without it, it is the bench row of a kernel's own name, which has
no "span_".
A routine begins with the macro ``routine``, ``pass``, whose last argument is the count, or ``span``,
or with an exported label of a code section. Other labels that a documented routine runs into are entries
of that routine. The entry ``start`` of a command may be documented under the command's name.

``python -m tmap.build.contracts SRC OUT`` writes OUT/kernel_table.s and owners_table.s: names and addresses of all
kernels, for the program bench, and of those of some rooms, for the owners' bench.
"""

import itertools
import re
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from tmap.base.errors import UserError

FIELDS = ("like", "in", "out", "trashes", "reads", "writes", "formats", "error", "cost")
#: Attributes that another routine's block gives to one that is like it.
INHERITED = ("inputs", "outputs", "trashes", "reads", "writes", "formats", "error")
#: Attributes of Contract with other names than their fields.
ATTRIBUTES = {"in": "inputs", "out": "outputs"}
TRASHED = "d0-d1/a0-a1"
#: The registers of a pass, and the last one's argument, which no block gives.
PASS, COUNT = ("a0", "a1", "a2", "d0"), ("d0", "int32", "count")
#: Macros with which a routine begins, and the registers of C's arguments; None: it names them.
OPENING = {"routine": None, "pass": PASS, "span": ("a0",)}
REGISTERS = tuple(f"{bank}{number}" for bank in "da" for number in range(8))[:-1]  # no a7
#: Folders whose routines are kernels: called one by one by the program bench.
KERNELS = ("math", "mesh", "polygon", "edge", "coverage", "span", "triangle", "depths", "n64", "glide", "screen")

TITLE = re.compile(r"; (\w+) - (\S.*)$")
FIELD = re.compile(r"; (\w+):\s*(.*)$")
UNCOMMENTED = re.compile(r"""(?:[^;'"]|'[^']*'|"[^"]*"|['"])*""")
STATEMENT = re.compile(r"([^\s:=]+:{0,2})?\s*(=|[^\s=]+)?\s*(.*)$")
#: Statements that generate no code.
DIRECTIVES = {"xdef", "xref", "cnop", "even", "include", "=", "equ", "set", "reg", "rs",
              "ifd", "ifnd", "ifb", "ifnb", "ifeq", "ifne", "if", "else", "endif", "endc"}
#: Data directives: their labels are not entries, and execution does not run through them.
NO_CODE = {f"{name}{size}" for name in ("dc", "dcb", "ds", "blk") for size in ("", ".b", ".w", ".l")} \
    | {"incbin"}
#: After these, execution does not run into the next label.
NO_RETURN = {"rts", "rte", "rtd", "rtr", "jmp", "bra"}


class Argument(NamedTuple):
    """One entry of ``in`` or ``out``: register (or pair ``d0:d1``), C type, meaning."""

    register: str
    type: str
    meaning: str


@dataclass(frozen=True)
class Contract:
    """One routine's block; the text of a missing field is "".

    ``missing``: attributes that the block does not give. ``registers``: those to which the
    ``routine`` macro moves C's arguments, None if the routine is not entered through it.
    """

    name: str
    file: str
    line: int
    summary: str
    inputs: tuple[Argument, ...]
    outputs: tuple[Argument, ...]
    trashes: frozenset[str]
    reads: str
    writes: str
    formats: str
    error: str
    cost: str
    like: str = ""
    missing: frozenset[str] = frozenset()
    registers: tuple[str, ...] | None = None


class Statement(NamedTuple):
    """One line of assembly: line number, label, operation in small letters, operands."""

    line: int
    label: str
    operation: str
    operands: list[str]


class Entry(NamedTuple):
    """A label of code. ``registers``: the registers to which the ``routine`` macro moves C's
    arguments, None for a plain label; ``is_reached``: the code before it runs into it."""

    line: int
    name: str
    registers: tuple[str, ...] | None
    is_exported: bool
    is_reached: bool


def is_register(text: str) -> bool:
    """Returns true if ``text`` names a register, the stack pointer or a pair d0:d1."""
    return text == "sp" or 1 <= len(text.split(":")) <= 2 and all(
        part in REGISTERS for part in text.split(":"))


def expand(text: str) -> frozenset[str]:
    """Returns the registers of a list such as "d0-d2/a0"; a ValueError names a wrong part."""
    if text == "-":
        return frozenset()
    if text == "everything":
        return frozenset(REGISTERS)
    found: set[str] = set()
    for part in text.split("/"):
        first, _, last = part.partition("-")
        last = last or first
        if first not in REGISTERS or last not in REGISTERS or first[0] != last[0] or first > last:
            raise ValueError(f"{part!r} is no register or range")
        found.update(r for r in REGISTERS if r[0] == first[0] and first <= r <= last)
    return frozenset(found)


def parse_arguments(lines: list[str]) -> tuple[Argument, ...]:
    """Returns the arguments of an ``in`` or ``out`` field from its lines.

    A line at the first one's column begins an argument; a deeper one continues it.
    """
    if not lines:
        return ()
    column = len(lines[0]) - len(lines[0].lstrip())
    arguments: list[Argument] = []
    for line in lines:
        if len(line) - len(line.lstrip()) > column and arguments:
            last = arguments[-1]
            arguments[-1] = last._replace(meaning=f"{last.meaning} {line.strip()}")
            continue
        register, *rest = re.split(r"\s{2,}", line.strip(), maxsplit=2)
        if not is_register(register):
            raise ValueError(f"{register!r} is no register")
        if register == "sp" and len(rest) == 1:  # a stack frame has no C type
            rest.insert(0, "")
        if len(rest) != 2:
            raise ValueError(f"{register} needs a C type and a meaning, two blanks between them")
        arguments.append(Argument(register, *rest))
    return tuple(arguments)


def parse_block(file: str, first: int, lines: list[str]) -> Contract:
    """Returns the contract in the ``lines`` of a comment; ``first``: the first one's number."""

    def fail(number: int, text: str):
        raise UserError(f"{file}:{number}: {text}")

    name, *summary = TITLE.match(lines[0]).groups()
    fields: dict[str, tuple[int, list[str]]] = {}
    current = summary
    for number, line in enumerate(lines[1:], first + 1):
        match = FIELD.match(line)
        if match:
            if match[1] not in FIELDS:
                fail(number, f"{name}: unknown field {match[1]!r}")
            if match[1] in fields:
                fail(number, f"{name}: second field {match[1]!r}")
            if not match[2]:
                fail(number, f"{name}: field {match[1]!r} is empty: leave it out")
            if match[2] == "-" and match[1] != "trashes":
                fail(number, f"{name}: field {match[1]!r} says nothing: leave it out")
            current = [" " * match.start(2) + match[2].rstrip()]
            fields[match[1]] = number, current
        elif line.strip() != ";":
            current.append(" " + line[1:].rstrip())
    if list(fields) != sorted(fields, key=FIELDS.index):
        fail(first, f"{name}: the fields' order is {', '.join(FIELDS)}")

    def read(field: str, reader):
        number, content = fields.get(field, (first, []))
        try:
            return reader(content)
        except ValueError as error:
            fail(number, f"{name}: {field}: {error}")

    def text(content: list[str]) -> str:
        return " ".join(part.strip() for part in content)

    return Contract(
        name, file, first, text(summary), read("in", parse_arguments),
        read("out", parse_arguments), read("trashes", lambda c: expand(text(c) or TRASHED)),
        *(read(field, text) for field in FIELDS[4:]), like=read("like", text),
        missing=frozenset(ATTRIBUTES.get(field, field) for field in FIELDS if field not in fields))


def find_blocks(file: str, lines: list[str]) -> dict[str, Contract]:
    """Returns the contract blocks of a source file, by name."""
    blocks: dict[str, Contract] = {}
    for first, (before, line) in enumerate(zip(["", *lines], lines)):
        if before.startswith(";") or not TITLE.match(line):
            continue
        comment = itertools.takewhile(lambda each: each.startswith(";"), lines[first:])
        block = parse_block(file, first + 1, list(comment))
        if block.name in blocks:
            raise UserError(f"{file}:{block.line}: second contract block of {block.name}")
        blocks[block.name] = block
    return blocks


def statements(lines: list[str]) -> list[Statement]:
    """Returns the statements of a source file, without comments and macro definitions."""
    found: list[Statement] = []
    in_macro = False
    for number, line in enumerate(lines, 1):
        code = "" if line.startswith("*") else UNCOMMENTED.match(line)[0]
        label, operation, operands = STATEMENT.match(code).groups("")
        if in_macro:
            in_macro = operation.lower() != "endm"
        elif "macro" in (label.lower(), operation.lower()):
            in_macro = True
        elif label or operation:
            found.append(Statement(number, label.rstrip(":"), operation.lower(),
                                   re.split(r"\s*,\s*", operands.strip())))
    return found


def find_entries(file_statements: list[Statement]) -> list[Entry]:
    """Returns the labels and routines at which a source file's code can be entered, in order."""
    exported = {name for s in file_statements if s.operation == "xdef" for name in s.operands}
    entries: list[Entry] = []
    in_code, runs_on = True, False      # vasm starts in a code section
    for statement, following in zip(file_statements, file_statements[1:] + [None]):
        number, label, operation, operands = statement
        if operation in OPENING:
            registers = OPENING[operation] or tuple(operands[1:])
            entries.append(Entry(number, operands[0], registers, True, False))
            in_code = runs_on = True
            continue
        if operation == "section":
            in_code = any(word in " ".join(operands).lower() for word in ("text", "code"))
            runs_on = False
            continue
        if label and not operation and following and not following.label:
            operation = following.operation     # the label is alone on its line
        if not in_code or operation in DIRECTIVES:
            continue
        if operation in NO_CODE:
            runs_on = False
            continue
        if label and not label.startswith(".") and not label.endswith("$"):
            entries.append(Entry(number, label, None, label in exported, runs_on))
        runs_on = operation.partition(".")[0] not in NO_RETURN
    return entries


def read(path: Path | str) -> list[Contract]:
    """Returns the contracts of a source file, in its order, as they are written. Raises UserError
    if one is wrong, a routine has none, or one has no routine."""
    file = str(path)
    lines = Path(path).read_text(encoding="utf-8").splitlines()
    blocks = find_blocks(file, lines)
    described: set[str] = set()
    is_documented = False       # true if the code before the entry has a contract
    for entry in find_entries(statements(lines)):
        name = entry.name
        if name == "start" and name not in blocks:
            name = next((b.name for b in reversed(blocks.values()) if b.line < entry.line), name)
        if name in blocks and name not in described:
            is_documented = True
            described.add(name)
            given = blocks[name].inputs
            if entry.registers == PASS and not blocks[name].like and len(given) == len(PASS) - 1:
                given += (Argument(*COUNT),)
            blocks[name] = replace(blocks[name], inputs=given, registers=entry.registers)
        elif not (is_documented and entry.is_reached):
            is_documented = False
            if entry.is_exported:
                raise UserError(f"{file}:{entry.line}: routine {entry.name} has no contract block")
    for block in blocks.values():
        if block.name not in described:
            raise UserError(f"{file}:{block.line}: no routine {block.name} for this block")
    return list(blocks.values())


def complete(contracts: list[Contract]) -> list[Contract]:
    """Returns the contracts with the fields that they take from others and with the defaults, which
    no block may repeat, and checks them."""
    named = {c.name: c for c in contracts}
    done: dict[str, Contract] = {}

    def completed(c: Contract, above: tuple[str, ...] = ()) -> Contract:
        if c.name in done:
            return done[c.name]
        given: dict[str, object] = {}
        if is_kernel(c):
            given = {"error": "none", "cost": f"bench row {c.name.removeprefix('span_')}"}
        if c.like:
            if c.like not in named or c.like in (*above, c.name):
                fail(c, f"like: no other routine {c.like}")
            base = completed(named[c.like], (*above, c.name))
            given |= {field: getattr(base, field) for field in INHERITED}
            c = replace(c, inputs=merged(c, c.inputs, base.inputs),
                        outputs=merged(c, c.outputs, base.outputs))
        for field in given.keys() - c.missing:
            if getattr(c, field) == given[field]:
                fail(c, f"field {field!r} says nothing: leave it out")
        done[c.name] = replace(c, **{field: given[field] for field in given.keys() & c.missing})
        check_registers(done[c.name])
        return done[c.name]

    return [completed(c) for c in contracts]


def fail(block: Contract, text: str):
    """Raises a UserError about a block."""
    raise UserError(f"{block.file}:{block.line}: {block.name}: {text}")


def merged(block: Contract, own: tuple[Argument, ...],
           base: tuple[Argument, ...]) -> tuple[Argument, ...]:
    """Returns another routine's entries of ``in`` or ``out``, with the block's own among them."""
    for argument in set(own) & set(base):
        fail(block, f"{argument.register} says nothing: leave it out")
    return tuple(({a.register: a for a in base} | {a.register: a for a in own}).values())


def check_registers(block: Contract) -> None:
    """Checks that C's arguments go to the registers that the block lists, in its order.

    A routine whose block lists arguments but whose macro has no registers is for assembly only.
    """
    stated = tuple(r for argument in block.inputs for r in argument.register.split(":"))
    if block.registers and block.registers != stated:
        fail(block, f"takes {', '.join(block.registers)} from C, its block says in: "
                    f"{', '.join(stated) or '-'}")


def is_kernel(block: Contract) -> bool:
    """Returns true if the program bench calls the routine."""
    return block.registers is not None and Path(block.file).parent.name in KERNELS


def all_contracts(root: Path | str) -> list[Contract]:
    """Returns the contracts of all source files under ``root``, by file name."""
    return complete([c for path in sorted(Path(root).rglob("*.s")) for c in read(path)])


def kernels(root: Path | str) -> list[Contract]:
    """Returns the contracts of the kernels under ``root``, which the program bench calls."""
    return [c for c in all_contracts(root) if is_kernel(c)]


#: The rooms whose kernels the owners' bench calls.
OWNERS = "span", "screen", "glide", "n64"


def kernel_table(contracts: list[Contract]) -> str:
    """Returns the assembly of ``kernel_table``: each one's name and register entry, then zeros."""
    lines = ["; Generated by tools/tmap/build/contracts.py: the kernels, by name.", ""]
    lines += [f"        xref    {c.name}" for c in contracts]
    lines += ["        xdef    _kernel_table", "        section .data.kernel_table,data",
              "        cnop    0,4", "_kernel_table:"]
    lines += [f"        dc.l    .name{i},{c.name}" for i, c in enumerate(contracts)]
    lines += ["        dc.l    0,0"]
    lines += [f".name{i:<6} dc.b    '{c.name}',0" for i, c in enumerate(contracts)]
    return "\n".join(lines) + "\n"


def main(source: str, out: str) -> None:
    """Checks the tree ``source`` and writes the table into ``out``."""
    Path(out).mkdir(parents=True, exist_ok=True)
    every = kernels(source)
    owners = [c for c in every if Path(c.file).parent.name in OWNERS]
    for name, of in (("kernel_table", every), ("owners_table", owners)):
        (Path(out) / f"{name}.s").write_text(kernel_table(of))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: python -m tmap.build.contracts SRC OUT")
    try:
        main(*sys.argv[1:])
    except UserError as error:
        sys.exit(f"contracts: {error}")
