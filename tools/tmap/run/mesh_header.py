"""``tmap mesh``: a model as a C header of the tables in c/mesh/records.h's formats, for programs of one's own.

The header needs mesh/records.h alone. Coordinates, normals and s and t are those of a scene file's mesh."""

import re
from collections.abc import Iterable
from pathlib import Path

from tmap.base.errors import UserError
from tmap.compiler import mesh_build
from tmap.compiler.mesh_build import Wishes
from tmap.shapes import mesh_file

EXTENT = (256, 256)  # s and t at the far ends of a square map
LINE = 6  # entries


def table(struct: str, name: str, rows: Iterable[Iterable[int]]) -> str:
    """Returns a table in C."""
    cells = ["{" + ", ".join(map(str, row)) + "}" for row in rows]
    lines = [", ".join(cells[first:first + LINE]) for first in range(0, len(cells), LINE)]
    return f"static const struct {struct} {name}[] = {{\n    " + ",\n    ".join(lines) + "\n};\n"


def text(name: str, made: mesh_build.Tables, source: str) -> str:
    """Returns the header."""
    guard = f"{name.upper()}_H"
    counts = {"points": len(made.points), "normals": len(made.normals), "corners": len(made.corners),
              "faces": len(made.faces)}
    tables = [table("scene_point", f"{name}_points", made.points.tolist()),
              table("scene_normal", f"{name}_normals", [[*row, 0][:4] for row in made.normals.tolist()]),
              table("scene_corner", f"{name}_corners", made.corners.tolist()),
              table("scene_face", f"{name}_faces", made.faces.tolist())]
    mesh = ", ".join(f"0, {count}" for count in counts.values())
    return (f"/* {source}: " + ", ".join(f"{count} {noun}" for noun, count in counts.items())
            + ". Made by tmap mesh. */\n"
            f'#ifndef {guard}\n#define {guard}\n\n#include "mesh/records.h"\n\n' + "\n".join(tables)
            + f"\nstatic const struct scene_mesh {name} = {{{mesh}}};\n\n#endif\n")


def write(source: Path, out: Path, size: float, triangles: bool) -> tuple[mesh_build.Tables, bool]:
    """Writes a model as a C header; returns its tables, and whether it has texture coordinates; raises UserError."""
    name = re.sub(r"\W", "_", out.stem)
    if not re.match(r"[A-Za-z]", name):
        raise UserError(f"{out}: the tables have the file's name, which must begin with a letter")
    shape = mesh_file.load(source.name, source.parent, str(source.parent), EXTENT)
    has_texels = shape.texels is not None and all(shape.texels)
    if shape.texels is not None and not has_texels and any(shape.texels):
        raise UserError(f"{source}: some of its faces have no texture coordinates")
    wishes = Wishes(size=size, mapping="uv" if has_texels else "none", light=True, triangles=triangles, planes=True)
    made = mesh_build.build(shape, wishes, str(source))
    out.write_text(text(name, made, source.name))
    return made, has_texels


def command(source: Path, out: Path, size: float, triangles: bool) -> int:
    """Writes a model as a C header, and says what is in it; raises UserError."""
    made, has_texels = write(source, out, size, triangles)
    for place in made.left_out:
        print(f"{place}: left out, has no area")
    print(f"{out}: {len(made.points)} points, {len(made.faces)} faces"
          + ("" if has_texels else "; the model has no texture coordinates: s and t are 0"))
    return 0
