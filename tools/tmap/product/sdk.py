"""Makes the SDK: the files with which other programs link this tree's loops.

    include/    C headers as they are in c/, tmap020.h which includes them, tmap020.i for assembly
    c/          C sources, and sources.mk: which of them each drawing routine needs
    lib/        the assembly as link libraries: vlink/ and gcc/ hold hunk objects, elf/ ELF ones
                and a second library: screens, keys, clock, files, memory
    example/    programs and their Makefile
    REFERENCE.md    every call: arguments, formats, errors, cycles

A routine is public if a C header declares it. The libraries hold the public routines and all that
they refer to.
"""

import re
import shutil
import subprocess
import tarfile
from dataclasses import dataclass
from gzip import GzipFile
from pathlib import Path

from tmap.base import c_lists
from tmap.base.errors import UserError
from tmap.base.paths import BUILD, ROOT
from tmap.build import contracts, elf_object, hunk, hunk_object
from tmap.build.elf_object import Section
from tmap.guest.provenance import commit_seconds
from tmap.product import sdk_include, sdk_reference
from tmap.run import mesh_header

#: Public folders of c/, with their sources and headers, and of src68k/; and single public files.
#: Displays are left to the programs.
C_ROOMS = ("math", "mesh", "polygon", "perspective", "drawing", "drawing/parts", "mipmap", "depths", "coverage",
           "span", "texture", "triangle", "glide", "glide/polygons", "n64", "n64/polygons")
C_FILES = (Path("frames/draw_bodies.c"), Path("frames/draw_bodies.h"), Path("frames/draw_faces.c"),
           Path("frames/draw_meshes.c"), Path("frames/draw_meshes.h"), Path("frames/draw_near.c"),
           Path("frames/draw_once.c"), Path("frames/draw_depths.c"), Path("frames/draw_touched.c"),
           Path("frames/draw_touched.h"),
           Path("screen/ham8.c"), Path("screen/planar.h"))
#: Headers of the library of screens, which tmap020.h does not include.
SCREEN = tuple(Path(name) for name in (
    "screen/screen.h", "screen/display.h", "screen/intuition.h", "screen/layout.h", "screen/copper.h", "screen/blits.h",
    "system/system.h", "system/memory.h", "system/file.h", "system/text.h", "system/outcome.h"))
START = "start"  # its program's entry
#: These define what a program names: one of its C files includes them, and tmap020.h does not.
PARTS = tuple(Path(f"drawing/parts/{name}.h") for name in ("parts", "spans", "perspective"))
ASM_ROOMS = (*contracts.KERNELS, "gen")
#: Lists of C sources by name: the routines, or the whole room, that a list offers.
LISTS = {"polygon_draw": ("polygon_draw", "polygons_draw", "material_is_named"),
         "perspective": ("reciprocals_make",), "mipmap": ("polygon_draw_mipmapped",),
         "texture": ("column_layout_make", "map_rows_make", "map_scale"), "screen": ("ham8_control",),
         "mesh": ("mesh_draw", "mesh_points16", "coverage_draw"),
         "triangles_draw": ("triangles_draw", "triangle_tables_make"), "n64": "n64", "glide": "glide"}
FILES = Path(__file__).with_name("sdk_files")
EXAMPLE = ("Makefile", "example.c", "example_parts.c", "triangles.c", "triangles_parts.c", "spans.s", "start.s",
           "cube.c", "cube_parts.c", "stage.h", "viewer.c", "viewer_parts.c", "corridor.c", "corridor_parts.c",
           "rotator.c", "rotator_parts.c", "amiga.ld")
MODEL = ROOT / "tests" / "scenes" / "knot.obj"  # the viewer's
INCLUDE = re.compile(r'#include "([^"]+)"')
DECLARATION = re.compile(r"^\w[\w* ]*?\b(\w+)\(", re.MULTILINE)
#: Routines of one type: n64_pass n64_walk, n64_divide;
TYPED = re.compile(r"^\w+ (\w+(?:, \w+)*);", re.MULTILINE)
ARCHIVE = "tmap020"


@dataclass
class Tree:
    """The objects of the project's build, by path and by the symbols that they define."""

    sections: dict[Path, list[Section]]
    home: dict[str, Path]  # of each symbol

    def needed(self, symbols: list[str]) -> list[Path]:
        """Returns the objects that define the symbols, and all objects that these refer to,
        sorted."""
        found: set[Path] = set()
        todo = [self.home[name] for name in symbols]
        while todo:
            path = todo.pop()
            if path not in found:
                found.add(path)
                todo += [self.home[name] for name in references(self.sections[path])
                         if name in self.home]
        return sorted(found)

    def groups(self, paths: list[Path]) -> list[list[Path]]:
        """Returns the objects in groups: those that refer to one another by distances are together.
        Linkers disagree on distances, so these are resolved here."""
        of = {path: [path] for path in paths}
        for path in paths:
            for target in references(self.sections[path], True):
                own, other = of[path], of[self.home[target]]
                if own is not other:
                    of |= dict.fromkeys(own + other, own + other)
        return [group for path, group in of.items() if group[0] == path]


def references(sections: list[Section], relative: bool = False) -> set[str]:
    """Returns the symbols that an object expects from others; ``relative``: only those that it
    takes distances to."""
    return {r.target for s in sections for r in s.relocations
            if isinstance(r.target, str) and (r.relative or not relative)}


def included(path: Path) -> list[Path]:
    """Returns the headers that a file of c/ includes directly."""
    return [Path(name) for name in INCLUDE.findall((ROOT / "c" / path).read_text())]


def offered(suffix: str) -> list[Path]:
    """Returns the public C sources or headers, relative to c/."""
    paths = [path.relative_to(ROOT / "c") for room in C_ROOMS
             for path in sorted((ROOT / "c" / room).glob(f"*{suffix}"))]
    return [path for path in (*paths, *C_FILES) if path.suffix == suffix]


def headers() -> list[Path]:
    """Returns the public headers, and those that public files include, relative to c/."""
    return with_included(offered(".c") + offered(".h"))


def with_included(todo: list[Path]) -> list[Path]:
    """Returns those of the files that are headers, and all that they include, sorted."""
    found: set[Path] = set()
    while todo:
        path = todo.pop()
        if path.suffix == ".h":
            found.add(path)
        todo += [each for each in included(path) if each not in found]
    return sorted(found)


def declared() -> set[str]:
    """Returns the names of the routines that public headers declare."""
    spans = {f"span_{name}" for _, name, _ in c_lists.rows("polygon/span_list.h", "SPAN")}
    texts = [(ROOT / "c" / path).read_text() for path in offered(".h")]
    return spans.union(*(DECLARATION.findall(text) for text in texts),
                       *(names.split(", ") for text in texts for names in TYPED.findall(text)))


def public() -> list[contracts.Contract]:
    """Returns the contracts of the public routines, by file."""
    names = declared()
    return [each for each in contracts.kernels(ROOT / "src68k") if each.name in names]


def built() -> Tree:
    """Returns the objects of the public rooms."""
    compiler, *names = (BUILD / "obj" / "objects").read_text().split()
    wanted = [BUILD / "obj" / compiler / path.with_suffix(".o") for path in offered(".c")] \
        + [ROOT / name for name in names if Path(name).parent.name in ASM_ROOMS
           and is_assembly(ROOT / name)]
    tree = Tree({path: elf_object.load(path) for path in wanted}, {})
    for path, sections in tree.sections.items():
        tree.home |= {name: path for section in sections for name in section.symbols}
    return tree


def source(path: Path) -> Path:
    """Returns the C source of an object, relative to c/."""
    compiler = (BUILD / "obj" / "objects").read_text().split()[0]
    return path.relative_to(BUILD / "obj" / compiler).with_suffix(".c")


def is_assembly(path: Path) -> bool:
    """Returns True if an object was built from an assembly source."""
    return path.is_relative_to(BUILD / "obj" / "asm")


def run_tool(*words: str | Path) -> None:
    """Runs a tool; raises UserError with its output if it fails."""
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode:
        raise UserError(f"{Path(words[0]).name} failed: {done.stdout.strip()}")


def hunk_units(path: Path) -> dict[str, bytes]:
    """Converts an ELF object to hunk objects, by linker."""
    sections = elf_object.load(path)
    return {kind: hunk_object.unit(path.name, sections, names)
            for kind, names in (("gcc", hunk_object.GCC), ("vlink", hunk_object.VLINK))}


def write_libraries(out: Path, groups: list[list[Path]]) -> None:
    """Writes the objects in all three forms, each alone and all in a library."""
    folders = {name: out / "lib" / name for name in ("elf", "gcc", "vlink")}
    for folder in folders.values():
        (folder / "objects").mkdir(parents=True)
    libraries = {"gcc": b"", "vlink": b""}
    for group in groups:
        name = f"{group[0].parent.name}_{group[0].name}"
        merged = folders["elf"] / "objects" / name
        run_tool("m68k-linux-gnu-ld", "-r", "-x", "-T", FILES / "merge.ld", "-o", merged, *group)
        for kind, unit in hunk_units(merged).items():
            (folders[kind] / "objects" / name).write_bytes(unit)
            libraries[kind] += unit
    start = folders["elf"] / "start.o"
    run_tool(ROOT / "scripts" / "vasm", "-quiet", "-m68020", "-Felf", "-o", start,
                 FILES / "start.s")
    for kind, unit in hunk_units(start).items():
        (folders[kind] / "start.o").write_bytes(unit)
    (folders["gcc"] / f"lib{ARCHIVE}.a").write_bytes(libraries["gcc"])
    (folders["vlink"] / f"{ARCHIVE}.lib").write_bytes(libraries["vlink"])
    run_tool("m68k-linux-gnu-ar", "rcsD", folders["elf"] / f"lib{ARCHIVE}.a",
                 *sorted((folders["elf"] / "objects").iterdir()))


def screen_objects() -> tuple[list[Path], list[Path]]:
    """Returns what screens need beside the other library: objects of assembly, the program's entry among them, and C
    sources."""
    names = (BUILD / "obj" / "objects").read_text().split()[1:]
    tree = Tree({ROOT / name: elf_object.load(ROOT / name) for name in names}, {})
    for path, sections in tree.sections.items():
        tree.home |= {name: path for section in sections for name in section.symbols}
    texts = [(ROOT / "c" / path).read_text() for path in SCREEN]
    wanted = [f"_{name}" for text in texts for name in DECLARATION.findall(text) if f"_{name}" in tree.home]
    needed = tree.needed([*wanted, START])
    return ([path for path in needed if path.parent.name == "amiga"],
            [source(path) for path in needed if not is_assembly(path)])


def write_screen(out: Path) -> None:
    """Writes the library of screens in all three forms, and its entry, which is linked first."""
    members, libraries = out / "lib" / "elf" / "screen", {"gcc": b"", "vlink": b""}
    members.mkdir()
    for path in screen_objects()[0]:
        merged = members / f"{path.parent.name}_{path.name}"
        run_tool("m68k-linux-gnu-ld", "-r", "-x", "-T", FILES / "merge.ld", "-o", merged, path)
        is_entry = path.stem == "startup"
        if is_entry:
            merged = merged.rename(out / "lib" / "elf" / "screen_start.o")
        for kind, unit in hunk_units(merged).items():
            if is_entry:
                (out / "lib" / kind / "screen_start.o").write_bytes(unit)
            else:
                libraries[kind] += unit
    (out / "lib" / "gcc" / "libscreen.a").write_bytes(libraries["gcc"])
    (out / "lib" / "vlink" / "screen.lib").write_bytes(libraries["vlink"])
    run_tool("m68k-linux-gnu-ar", "rcsD", out / "lib" / "elf" / "libscreen.a", *sorted(members.iterdir()))
    shutil.rmtree(members)


def source_lists(tree: Tree) -> str:
    """Returns sources.mk: for each entry of LISTS a variable with the C sources that it needs."""
    lines = ["# C sources by what they offer, each list with all C that it needs."]
    for name, offer in LISTS.items():
        symbols = [f"_{routine}" for routine in offer] if isinstance(offer, tuple) else \
            [symbol for symbol, path in tree.home.items()
             if not is_assembly(path) and source(path).parts[0] == offer]
        paths = [path for path in tree.needed(symbols) if not is_assembly(path)]
        files = [str(source(path)) for path in paths]
        lines += [f"{name} := \\", *(f"  {file} \\" for file in files[:-1]), f"  {files[-1]}"]
    lines.append(f"own_screen := {' '.join(map(str, screen_objects()[1]))}")
    return "\n".join(lines) + "\n"


def copy_files(out: Path) -> None:
    """Copies headers, sources, example, licence and README."""
    screens = screen_objects()[1]
    for folder, files in (("include", headers() + with_included([*SCREEN, *screens])), ("c", [*offered(".c"), *screens])):
        for path in files:
            (out / folder / path.parent).mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / "c" / path, out / folder / path)
    (out / "example").mkdir()
    for name in EXAMPLE:
        shutil.copyfile(FILES / name, out / "example" / name)
    mesh_header.write(MODEL, out / "example" / "model.h", 1.0, True)
    shutil.copyfile(Path(hunk.__file__), out / "example" / "elf2hunk.py")
    shutil.copyfile(FILES / "README.txt", out / "README.txt")
    shutil.copyfile(ROOT / "LICENSE", out / "LICENSE")


def make(out: Path) -> int:
    """Writes the SDK into ``out``, whose other content is removed; returns the number of routines
    that the SDK offers."""
    if out.exists() and not (out / "README.txt").exists() and any(out.iterdir()):
        raise UserError(f"{out} holds something else than an SDK: it is left as it is")
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    copy_files(out)
    tree, routines = built(), public()
    paths = tree.needed([each.name for each in routines])
    write_libraries(out, tree.groups([path for path in paths if is_assembly(path)]))
    write_screen(out)
    (out / "c" / "sources.mk").write_text(source_lists(tree))
    (out / "include" / "tmap020.h").write_text(sdk_include.umbrella([path for path in offered(".h") if path not in PARTS]))
    offsets = sdk_include.assembly(headers(), routines)
    for name, text in (("tmap020.i", offsets), ("tmap020_gas.i", sdk_include.for_gas(offsets))):
        (out / "include" / name).write_text(text)
    (out / "REFERENCE.md").write_text(sdk_reference.reference(
        offered(".h") + list(SCREEN), routines + [each for each in contracts.all_contracts(ROOT / "src68k")
                                                  if Path(each.file).parent.name == "amiga" and each.registers is not None]))
    return len(routines)


def without_maker(member: tarfile.TarInfo) -> tarfile.TarInfo:
    """Gives a file of the archive the commit's date and nobody's name."""
    member.mtime, member.uid, member.gid, member.uname, member.gname = commit_seconds(), 0, 0, "", ""
    member.mode = 0o755 if member.isdir() else 0o644
    return member


def command(out: Path) -> int:
    """``tmap sdk``: makes the folder, and an archive of it beside it."""
    count = make(out)
    archive = out.with_name(f"{ARCHIVE}-sdk.tar.gz")
    with GzipFile(archive, "wb", mtime=commit_seconds()) as packed, tarfile.open(fileobj=packed, mode="w") as tar:
        tar.add(out, f"{ARCHIVE}-sdk", filter=without_maker)
    print(f"{out}: {count} routines; {out / 'README.txt'} says how to link them\n"
          f"{archive}: the same, packed")
    return 0
