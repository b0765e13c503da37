"""Builds Amiga programs for tests: their sources linked with the tree's objects, as the Makefile
does."""

import subprocess
from pathlib import Path

from tmap.base.paths import BUILD, ROOT
from tmap.build import hunk


def build(folder: Path, *sources: Path, main: str = "") -> Path:
    """Compiles, assembles and links sources into ``folder``; returns the program, with its map in
    the same folder. The program is named after the first source, or after ``main``, a program of
    the tree, whose own object is then linked too."""
    assembler, compiler, _, _, linker, *_ = (BUILD / "obj" / "flags").read_text().splitlines()
    compiled, *objects = (BUILD / "obj" / "objects").read_text().split()
    tools = {".s": ["scripts/vasm", *assembler.split()],
             ".c": ["m68k-linux-gnu-gcc", *compiler.split(), "-c"]}
    if main:
        objects.insert(0, str(BUILD / "obj" / compiled / "programs" / f"{main}.o"))
    program = folder / (main or sources[0].stem)
    made, linked = [folder / f"{source.stem}.o" for source in sources], program.with_suffix(".elf")
    commands = [[*tools[source.suffix], "-o", out, source] for out, source in zip(made, sources)]
    for command in [*commands, ["m68k-linux-gnu-ld", *linker.split(), "-o", linked, *made, *objects]]:
        subprocess.run(command, cwd=ROOT, check=True)
    hunk.convert(linked, program)
    return program
