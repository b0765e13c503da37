"""Every function that a header of the SDK declares is in the SDK, or asked of the program; all of it links."""

import re
import subprocess

import numpy as np

from tmap.base.paths import ROOT
from tmap.build import elf_object
from tmap.product import sdk, sdk_include

#: What the program has itself, as README.txt says.
ASKED = {"mem_take"}
FLAGS = ("-std=c99", "-m68020", "-ffreestanding", "-fno-pic", "-fleading-underscore")
COMPILER = ("m68k-linux-gnu-gcc", *FLAGS, "-I", ROOT / "c")
MARKER = re.compile(r"^#.*$", re.M)
#: A declaration at the outermost level: no inline function, no type, no array.
DECLARATION = re.compile(r"^(?!static|typedef|enum\b[^(]*[;{]|struct \w+ *[;{]|extern\b[^(]*\[)[a-z][\w *]*?[ *](?=\w)"
                         r"([^;{]*);", re.M)


def declared() -> set[str]:
    """The functions and tables that all headers declare, those of one type in a row too."""
    headers = "".join(f'#include "{path}"\n' for path in sdk.headers() if path not in sdk.PARTS)
    text = subprocess.run([*COMPILER, "-E", "-x", "c", "-"], input=headers, capture_output=True, text=True,
                          check=True).stdout
    found = set()
    for match in DECLARATION.finditer(MARKER.sub("", text)):
        names = re.sub(r"\(.*", "(", match[1], flags=re.S)
        if "(" not in names:
            found |= {re.findall(r"\w+", name)[-1] for name in names.split(",")}
        elif routine := re.search(r"(\w+)\($", names):
            found.add(routine[1])
    return found


def test_every_declared_function_is_there_and_links(tmp_path):
    tree = sdk.built()
    functions = declared()
    assert functions >= {"polygon_draw", "n64_walk", "span_fill", "triangles_draw", "drawing_parts"}
    missing = {name for name in functions if f"_{name}" not in tree.home} - ASKED
    assert not missing
    source, made = tmp_path / "all.c", tmp_path / "all.o"
    names = sorted(functions - ASKED)
    source.write_text("".join(f"extern char {name}[];\n" for name in names)
                      + f"char *all[] = {{{', '.join(names)}}};\nint mem_take(void) {{ return 0; }}\n")
    subprocess.run([*COMPILER, "-fno-builtin", "-c", "-o", made, source], check=True)
    done = subprocess.run(["m68k-linux-gnu-ld", "-q", "-z", "noexecstack", "--no-check-sections", "-e", "0", "-T",
                           sdk.FILES / "amiga.ld", "-o", tmp_path / "all.elf", made, *tree.sections],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]


def test_include_file_is_gnus_assemblers_too(tmp_path):
    """Offsets and constants have the same values there."""
    vasms = sdk_include.assembly(sdk.headers(), sdk.public())
    (tmp_path / "tmap020_gas.i").write_text(sdk_include.for_gas(vasms))
    source, made = tmp_path / "all.s", tmp_path / "all.o"
    values = {name: int(value) for name, value in re.findall(r"^(\w+) equ (-?\d+)$", vasms, re.M)}
    assert len(values) > 1000
    source.write_text('.include "tmap020_gas.i"\n' + "".join(f".long {name}\n" for name in values))
    subprocess.run(["m68k-linux-gnu-as", "-m68020", "-I", tmp_path, "-o", made, source], check=True)
    data = next(each.data for each in elf_object.load(made) if each.name == ".text")
    assert np.frombuffer(data, ">i4")[:len(values)].tolist() == [(v + 2**31) % 2**32 - 2**31 for v in values.values()]


def test_makefile_leaves_out_what_needs_an_assembler_that_is_not_there():
    done = subprocess.run(["make", "-n", "-f", sdk.FILES / "Makefile", "TOOLS=elf", "VASM=nonesuch", "SDK=/nowhere", "all"],
                          capture_output=True, text=True)
    assert "spans is left out: there is no nonesuch" in done.stdout


def test_library_of_screens_has_what_its_headers_declare():
    """With the C sources of its list and the other library."""
    objects, sources = sdk.screen_objects()
    written = " ".join((ROOT / "c" / path).read_text() for path in sources)
    there = set(sdk.built().home)
    for path in objects:
        there |= {name for section in elf_object.load(path) for name in section.symbols}
    names = {name for header in sdk.SCREEN for name in sdk.DECLARATION.findall((ROOT / "c" / header).read_text())}
    assert names >= {"screen_open", "display_fields", "key_take", "clock_start", "mem_alloc", "file_save"}
    missing = {name for name in names if f"_{name}" not in there
               and not re.search(rf"^\w[\w* ]*\b{name}\(", written, re.M)}
    assert not missing
