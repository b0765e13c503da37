"""Builds programs with one changed file: in a temporary folder, never in the checkout."""

import re
import subprocess
from functools import cache
from pathlib import Path

from tests.mutants.changes import Mutant
from tmap.base.errors import UserError
from tmap.base.paths import BUILD, ROOT
from tmap.build import hunk


class Unbuilt(UserError):
    """The assembler, the compiler or the linker refuses the mutant."""


class SameCode(UserError):
    """The mutant's code is the original's, byte for byte."""


@cache
def flags() -> list[str]:
    """Returns the lines of the Makefile's flags: assembler, compiler, its options for small code, vbcc, linker, and the
    objects of small code."""
    return (BUILD / "obj" / "flags").read_text().splitlines()


@cache
def objects() -> tuple[str, list[str]]:
    """Returns the C compiler's name, and the objects of all programs, from the root."""
    compiler, *some = (BUILD / "obj" / "objects").read_text().split()
    return compiler, some


@cache
def includes() -> dict[str, set[str]]:
    """Returns for each source of assembly all files that it is made of, from the root."""
    found = {}
    for path in (BUILD / "obj" / "asm").rglob("*.d"):
        _, source, *others = path.read_text().split("\n")[0].split()
        if object_of(source) in objects()[1]:  # or its source is gone
            found[source] = {source, *others}
    return found


@cache
def symbols() -> dict[str, tuple[set[str], set[str]]]:
    """Returns for each source of assembly or C the symbols that its object defines, and those that it lacks."""
    compiler, some = objects()
    found = {}
    done = subprocess.run(["m68k-linux-gnu-nm", "-A", "-g", *some], cwd=ROOT, capture_output=True, text=True, check=True)
    for line in done.stdout.splitlines():
        match = re.match(r"(\S+?):\w* +(\w) (\w+)$", line)
        if match and match[2] in "TtDBRUC":
            source = source_of(match[1], compiler)
            found.setdefault(source, (set(), set()))[match[2] == "U"].add(match[3].lstrip("_"))
    return found


def source_of(made: str, compiler: str) -> str:
    """Returns the source of an object."""
    name = made.removeprefix("build/obj/").removesuffix(".o")
    if name.startswith("asm/gen/"):
        return f"build/gen/{name.removeprefix('asm/gen/')}.s"
    folder, _, rest = name.partition("/")
    return f"src68k/{rest}.s" if folder == "asm" else f"c/{rest}.c"


def object_of(source: str) -> str:
    """Returns the object of a source, from the root."""
    room, _, rest = source.partition("/")
    return f"build/obj/{'asm' if room == 'src68k' else objects()[0]}/{rest.rpartition('.')[0]}.o"


@cache
def needed_by(source: str) -> list[str]:
    """Returns the sources that call what a source defines, at any depth, the nearest first; itself first of all."""
    found, last = [source], [source]
    while last:
        defined = set().union(*(symbols().get(each, (set(),))[0] for each in last))
        last = [each for each, (_, lacks) in symbols().items() if lacks & defined and each not in found]
        found += sorted(last)
    return found


def concerned(mutant: Mutant) -> list[str]:
    """Returns the sources of assembly in which a changed line of an included file is used: those that name the macro
    that has it, or that name macros of included files that do."""
    path = ROOT / mutant.file
    if path.suffix != ".i":
        return [mutant.file]
    within = [each for each, parts in includes().items() if mutant.file in parts]
    names, texts = {mutant.within}, {p: (ROOT / p).read_text() for p in (ROOT / "src68k" / "include").glob("*.i")}
    is_macro = re.search(rf"^{mutant.within}\s+macro\b", path.read_text(), re.MULTILINE)
    if not is_macro:
        return within
    while True:
        more = set()
        for text in texts.values():
            for body in re.finditer(r"^(\w+)\s+macro\b(.*?)^\s+endm\b", text, re.MULTILINE | re.DOTALL):
                if body[1] not in names and any(re.search(rf"\b{name}\b", body[2]) for name in names):
                    more.add(body[1])
        if not more:
            break
        names |= more
    uses = re.compile(rf"\b({'|'.join(names)})\b")
    return [each for each in within if uses.search((ROOT / each).read_text())]


def command(*words: str | Path) -> None:
    """Runs a tool of the build."""
    done = subprocess.run([*map(str, words)], cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode:
        raise Unbuilt((done.stdout + done.stderr).strip())


def changed_text(mutant: Mutant) -> str:
    """Returns the changed file's text."""
    lines = (ROOT / mutant.file).read_text(encoding="utf-8").splitlines()
    lines[mutant.line - 1] = mutant.text
    return "\n".join(lines) + "\n"


def write_changed(mutant: Mutant, folder: Path) -> Path:
    """Writes the changed file below a folder; returns it."""
    path = folder / mutant.file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(changed_text(mutant), encoding="utf-8")
    return path


def make_objects(mutant: Mutant, sources: list[str], folder: Path) -> dict[str, Path]:
    """Assembles or compiles the sources with the mutant's line; returns the objects that differ from the tree's.
    Raises Unbuilt, or SameCode if none does."""
    changed, made = write_changed(mutant, folder), {}
    for number, source in enumerate(sources):
        out = folder / f"{number}.o"
        given = changed if source == mutant.file else ROOT / source
        if source.endswith(".s"):
            here = [f"-I{folder / 'src68k' / 'include'}", f"-I{(ROOT / source).parent}"]
            command("scripts/vasm", *flags()[0].split()[:3], *here, *flags()[0].split()[3:], "-o", out, given)
        else:
            small = flags()[2].split() if object_of(source) in flags()[5].split() else []
            command("m68k-linux-gnu-gcc", *flags()[1].split(), *small, "-w", f"-I{(ROOT / source).parent}", "-c", "-o",
                    out, given)
        if code(out) != code(ROOT / object_of(source)):
            made[object_of(source)] = out
    if not made:
        raise SameCode("the same code")
    return made


def code(path: Path) -> bytes:
    """Returns an object's bytes without its source's name."""
    return re.sub(rb"[\w./-]+\.[sc]\0", b"", path.read_bytes())


def link(program: str, changed: dict[str, Path], folder: Path) -> Path:
    """Links a program of the tree with changed objects into a folder; returns that folder."""
    compiler, some = objects()
    some = [f"build/obj/{compiler}/programs/{program}.o", *some]
    if program == "bench":
        some.append("build/obj/asm/gen/kernel_table.o")
    linked = folder / f"{program}.elf"
    command("m68k-linux-gnu-ld", *flags()[4].split(), "-o", linked, *(changed.get(each, each) for each in some))
    try:
        hunk.convert(linked, folder / program)
    except UserError as error:
        raise Unbuilt(str(error)) from None
    return folder
