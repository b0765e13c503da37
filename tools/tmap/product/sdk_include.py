"""The SDK's include files: tmap020.h, and tmap020.i from headers and contract blocks, also for GNU's assembler."""

import re
import subprocess
from pathlib import Path

from tmap.base.errors import UserError
from tmap.base.paths import ROOT
from tmap.build import layout
from tmap.build.contracts import Argument, Contract
from tmap.guest.emulator import workspace

UMBRELLA = """\
/* All of tmap020's routines and structures. */
#ifndef TMAP020_H
#define TMAP020_H

#ifdef __cplusplus
extern "C" {
#endif

%s

#ifdef __cplusplus
}
#endif

#endif
"""
HEAD = """\
; Offsets, constants and routines of tmap020, for vasm (-nowarn=62: not all of them are used).
; Generated from its C headers and contract blocks: do not edit.

        ifnd    TMAP020_I
TMAP020_I equ 1

"""
ROUTINES = """
; Routines. Each takes its arguments in registers, under its plain name, and keeps all registers
; but those under "changes"; _name takes them from the stack, as C gives them. None expects
; anything of a5 or a6.
"""
FLAGS = ("-std=c99", "-m68020", "-ffreestanding", "-O0", "-g", "-fno-eliminate-unused-debug-types")
WIDTH = 96


def umbrella(headers: list[Path]) -> str:
    """Returns the text of tmap020.h."""
    return UMBRELLA % "\n".join(f'#include "{path}"' for path in headers)


def equates(headers: list[Path]) -> str:
    """Returns offsets and constants of the headers, in the form of layout.i."""
    with workspace() as folder:
        source, target = folder / "headers.c", folder / "headers.o"
        source.write_text("".join(f'#include "{path}"\n' for path in headers))
        done = subprocess.run(["m68k-linux-gnu-gcc", *FLAGS, "-I", ROOT / "c", "-c", "-o", target,
                               source], capture_output=True, text=True, errors="replace")
        if done.returncode:
            raise UserError(f"the headers cannot be compiled: {done.stderr.strip()}")
        return layout.equates(layout.extract(target.read_bytes(), [str(h) for h in headers]))


def arguments(title: str, given: tuple[Argument, ...]) -> list[str]:
    """Returns the lines of ``in`` or ``out``."""
    return [f";   {title if not k else '':<8} {a.register:<5} {a.type:<20} {a.meaning}"
            for k, a in enumerate(given)]


def trashes(registers: frozenset[str]) -> str:
    """Returns registers as text, data registers first."""
    return " ".join(sorted(registers, key=lambda r: (r[0] == "a", r))) or "-"


def routine(contract: Contract) -> list[str]:
    """Returns the lines of a routine: its interface, and its names."""
    lines = ["", f"; {contract.name} - {contract.summary}", *arguments("in", contract.inputs),
             *arguments("out", contract.outputs), f";   changes  {trashes(contract.trashes)}"]
    for title, words in (("formats", contract.formats), ("error", contract.error)):
        if words:
            lines += wrapped(title, words)
    return lines + [f"        xref    {contract.name}", f"        xref    _{contract.name}"]


def wrapped(title: str, words: str) -> list[str]:
    """Wraps a field's text into comment lines."""
    lines, line = [], f";   {title:<8}"
    for word in words.split():
        if len(line) + 1 + len(word) > WIDTH:
            lines.append(line)
            line = f";   {'':<8}"
        line += f" {word}"
    return [*lines, line]


def assembly(headers: list[Path], offered: list[Contract]) -> str:
    """Returns the text of tmap020.i."""
    lines = [line for each in offered for line in routine(each)]
    return HEAD + equates(headers).split("\n", 1)[1] + ROUTINES + "\n".join(lines) \
        + "\n\n        endc\n"


def for_gas(text: str) -> str:
    """Returns tmap020.i for GNU's assembler, to which routines of other objects need no declaration."""
    text = text.replace("for vasm (-nowarn=62: not all of them are used)", "for GNU's assembler")
    for pattern, to in ((r"^ +xref .*\n", ""), (r"^;", "|"), (r"^(\w+) equ (.*)", r".equ \1, \2"),
                        (r"^ +ifnd +", "        .ifndef "), (r"^ +endc", "        .endif")):
        text = re.sub(pattern, to, text, flags=re.MULTILINE)
    return text
