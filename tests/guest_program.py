"""Amiga programs of the tests' own: an assembly source linked with the tree's objects."""

import subprocess
from pathlib import Path

from tools import hunk
from tools.paths import BUILD, ROOT


def build(folder: Path, source: Path) -> Path:
    """Assembles and links a source as the Makefile does; returns the program, its map beside it."""
    assembler, *_, linker = (BUILD / "obj" / "flags").read_text().splitlines()
    objects = (BUILD / "obj" / "objects").read_text().split()[1:]
    program = folder / source.stem
    made, linked = (program.with_suffix(suffix) for suffix in (".o", ".elf"))
    for command in (["scripts/vasm", *assembler.split(), "-o", made, source],
                    ["m68k-linux-gnu-ld", *linker.split(), "-o", linked, made, *objects]):
        subprocess.run(command, cwd=ROOT, check=True)
    hunk.convert(linked, program)
    return program
