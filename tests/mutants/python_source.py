"""Mutants of the integer model and of the judges, by Python's own parser."""

import ast
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from tests.mutants import workshop
from tests.mutants.changes import Mutant
from tmap.base.paths import ROOT
from tmap.guest import emulator

CONDITIONS = {ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">", ast.Eq: "!=", ast.NotEq: "=="}
OPERATIONS = {ast.Add: "-", ast.Sub: "+", ast.LShift: ">>", ast.RShift: "<<", ast.BitAnd: "|", ast.BitOr: "&"}
OPERATORS = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=", ast.Add: "+",
             ast.Sub: "-", ast.LShift: "<<", ast.RShift: ">>", ast.BitAnd: "&", ast.BitOr: "|"}
#: Linked into the copy beside tools.
LINKED = ("build", "tests", "c", "src68k", "scripts", "pytest.ini", "Makefile", ".deps")
SECONDS = 240.0  # of a check, on a busy host


def between(line: str, left: ast.expr, right: ast.expr, operator: ast.AST, other: str) -> str | None:
    """Returns a line with the operator between two expressions replaced, None if it is not on that line."""
    if left.end_lineno != right.lineno:
        return None
    start, end = left.end_col_offset, right.col_offset
    old = OPERATORS[type(operator)]
    at = line.find(old, start, end)
    return line[:at] + other + line[at + len(old):] if at >= 0 else None


def of_node(node: ast.AST, lines: list[str]) -> Iterator[tuple[int, str, str | None]]:
    """Yields number, kind and text of the lines that change a node."""
    if isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in CONDITIONS:
        left, right, operator = node.left, node.comparators[0], node.ops[0]
        yield right.lineno, "condition", between(lines[right.lineno - 1], left, right, operator, CONDITIONS[type(operator)])
    elif isinstance(node, ast.BinOp) and type(node.op) in OPERATIONS:
        yield node.right.lineno, "operation", between(lines[node.right.lineno - 1], node.left, node.right, node.op,
                                                      OPERATIONS[type(node.op)])
    elif isinstance(node, ast.Constant) and type(node.value) is int:
        line = lines[node.lineno - 1]
        for by in (1, -1):
            yield node.lineno, "constant", f"{line[:node.col_offset]}{node.value + by}{line[node.end_col_offset:]}"
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub)) and node.operand.lineno == node.lineno:
        line = lines[node.lineno - 1]
        yield node.lineno, "sign", line[:node.col_offset] + line[node.operand.col_offset:]
    elif isinstance(node, (ast.Assign, ast.AugAssign, ast.Expr)) and node.lineno == node.end_lineno and not (
            isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)):
        line = lines[node.lineno - 1]
        yield node.lineno, "removed", line[:node.col_offset] + "pass" + line[node.end_col_offset:]


def mutants(file: str) -> list[Mutant]:
    """Returns all mutants of the functions of a module, which is named from the root."""
    text = (ROOT / file).read_text(encoding="utf-8")
    lines, found = text.splitlines(), []
    for function in ast.walk(ast.parse(text)):
        if isinstance(function, ast.FunctionDef):
            for node in (each for part in function.body for each in ast.walk(part)):
                for number, kind, changed in of_node(node, lines):
                    if changed is not None and lines[number - 1].isascii():
                        before = lines[number - 1].partition("  #")[0]
                        found.append(Mutant(file, number, function.name, kind, " ".join(before.split()),
                                            " ".join(changed.partition("  #")[0].split()), changed))
    return found


def files(*rooms: str) -> list[str]:
    """Returns the modules of rooms of tools/tmap, from the root."""
    return [path.relative_to(ROOT).as_posix() for room in rooms
            for path in sorted((ROOT / "tools" / "tmap" / room).glob("*.py"))]


def check(mutant: Mutant, command: list[str]) -> subprocess.CompletedProcess:
    """Runs a command of Python in a copy of the tools with a mutant among them."""
    with emulator.workspace() as folder:
        for name in LINKED:
            (folder / name).symlink_to(ROOT / name)
        shutil.copytree(ROOT / "tools", folder / "tools", ignore=shutil.ignore_patterns("__pycache__"))
        workshop.write_changed(mutant, folder)
        paths = {"PYTHONPATH": f"{folder / 'tools'}:{folder}", "PYTHONDONTWRITEBYTECODE": "1", "PATH": "/usr/bin:/bin",
                 "TMPDIR": str(folder)}
        return subprocess.run([sys.executable, "-P", *command], cwd=folder, env=paths, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=SECONDS)


def path_of(module: str) -> Path:
    """Returns the file of a module of tools."""
    return ROOT / "tools" / (module.replace(".", "/") + ".py")
