"""Amiga programs of the tests' own: sources linked with the tree's objects."""

import subprocess
from pathlib import Path

from tools import hunk
from tools.paths import BUILD, ROOT


def build(folder: Path, *sources: Path) -> Path:
    """Compiles and links sources as the Makefile does; returns the program, named like the first of
    them, its map beside it."""
    assembler, compiler, *_, linker = (BUILD / "obj" / "flags").read_text().splitlines()
    objects = (BUILD / "obj" / "objects").read_text().split()[1:]
    tools = {".s": ["scripts/vasm", *assembler.split()],
             ".c": ["m68k-linux-gnu-gcc", *compiler.split(), "-c"]}
    program = folder / sources[0].stem
    linked = program.with_suffix(".elf")
    made = [folder / f"{source.stem}.o" for source in sources]
    for source, to in zip(sources, made):
        subprocess.run([*tools[source.suffix], "-o", to, source], cwd=ROOT, check=True)
    subprocess.run(["m68k-linux-gnu-ld", *linker.split(), "-o", linked, *made, *objects], cwd=ROOT,
                   check=True)
    hunk.convert(linked, program)
    return program
