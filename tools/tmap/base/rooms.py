"""The rooms of the tree and which rooms each may use.

A room may use the rooms listed above it. Rooms on one line may not use each other. ROOMS.md shows
these lists, and tests/product/test_rooms.py checks every import and include against them.
"""

import ast
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from tmap.base.markdown import table
from tmap.base.paths import ROOT

#: tools/tmap; each room's docstring gives its purpose. The top folder has the command line.
TOOLS = ("base", "build", "images", "setup", "n64 glide", "scene_file", "model", "trees", "shapes",
         "compiler", "guest", "vectors", "corpus", "ideal", "run", "fuzz",
         "bench/modes bench/examples", "bench", "accuracy", "accuracy/fit", "report", "product assets", ".")
#: tests, in the same way. The top folder has conftest.py.
TESTS = ("helpers", "mesh n64 glide", "compiler", "kernels/trials", "kernels", "polygon mipmap", "accuracy",
         "screen", "guest", "product", "mutants", ".")
#: c, each with a description.
C = {".": "integer types and the limits that all rooms keep to",
     "math system texture": "products and quotients in assembly; AmigaDOS, memory, clock; maps in memory",
     "span": "what spans and line makers in `src68k/` are called with",
     "polygon": "a polygon and its renderer; edges, gradients, planes",
     "triangle": "batches of triangles with snapped vertices",
     "perspective": "planes of 1/w, lines from their far ends, level or divided, light over them",
     "drawing": "lowering, and the way from vertices to spans",
     "drawing/parts": "what of it a program may leave out",
     "mipmap": "mip maps: a level for each polygon",
     "depths": "a z buffer where faces are tested pixel by pixel",
     "coverage": "what of a frame is drawn already: polygons front to back, each pixel once",
     "n64 glide": "the N64's texture engine and Glide's texture unit: state, commands, pixel by pixel",
     "n64/polygons glide/polygons mesh screen": "the units' polygons, by passes; meshes; display",
     "scene": "the scene file: checked, loaded",
     "frames": "a scene's frames: drawn, timed, counted, saved",
     "plain show": "routines in C as the bench calls them; figures below a picture",
     "bench demo": "plans and reports of the bench; the demo's parts",
     "programs": "the programs themselves"}
#: src68k; all rooms use include/.
SRC68K = {"math": "products and quotients", "span": "loops over a line's pixels",
          "edge": "lines of a polygon from its edges",
          "coverage": "which pixels are drawn already", "polygon": "edges, gradient set-up, planes",
          "triangle": "whole triangles with snapped vertices, in batches",
          "mesh": "points, faces, normals", "depths": "z of lines, and pixels by it",
          "n64": "passes of the N64's texture engine",
          "glide": "passes of Glide's texture unit", "screen": "chunky to planar, HAM8",
          "amiga": "start and end, clock, display, keys", "include": "macros"}


def ranks(rooms: Iterable[str]) -> dict[str, int]:
    """Returns the index of each room's line."""
    return {room: line for line, some in enumerate(rooms) for room in some.split()}


def room_of(path: Path, top: Path, rooms: Iterable[str]) -> str:
    """Returns the room of a file below ``top``: the longest one that its folder's path begins
    with."""
    folder = path.parent.relative_to(top).as_posix()
    found = [room for room in ranks(rooms) if folder == room or folder.startswith(room + "/")]
    return max(found, key=len, default=".")


def imported(path: Path, package: str, top: Path) -> Iterator[Path]:
    """Yields the files below ``top`` that a Python file imports from ``package``."""
    for node in ast.walk(ast.parse(path.read_text())):
        if not isinstance(node, ast.ImportFrom) or (node.module or "").split(".")[0] != package:
            continue
        base = top.joinpath(*node.module.split(".")[1:])
        for file in (base.with_suffix(".py"), *(base / f"{each.name}.py" for each in node.names)):
            if file.is_file():
                yield file


def included(path: Path) -> Iterator[Path]:
    """Yields the files of c/ that a file includes."""
    for name in re.findall(r'^#include "([^"]+)"', path.read_text(), re.M):
        yield ROOT / "c" / name


def tables() -> dict[str, str]:
    """Returns the tables for ROOMS.md, by title."""
    def sentence(room: str) -> str:
        text = (ROOT / "tools" / "tmap" / room / "__init__.py").read_text()
        return " ".join(ast.get_docstring(ast.parse(text)).split("\n\n")[0].split())

    tools = [[", ".join(f"`{room}`" for room in rooms.split()),
              "<br>".join(sentence(room) for room in rooms.split())] for rooms in TOOLS[:-1]]
    c, asm = ([[", ".join(f"`{room}`" for room in rooms.split()), text] for rooms, text in listed.items()]
              for listed in (C, SRC68K))
    return {"rooms of tools/tmap": table(["room", "what it has"], tools, "ll"),
            "rooms of c": table(["room", "what it has"], c, "ll"),
            "rooms of src68k": table(["room", "what it has"], asm, "ll")}
