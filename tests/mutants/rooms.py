"""The rooms whose mutants are tried, how many of each, and what notices them."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from tests.mutants import assembly, c_source, python_source
from tests.mutants.changes import Mutant


@dataclass(frozen=True)
class Room:
    """``count``: mutants; ``files``: those that have them; ``subjects``: what is drawn, of corpora.PARTS."""

    count: int
    files: Callable[[], list[str]]
    subjects: tuple[str, ...]

    def mutants(self) -> list[Mutant]:
        """Returns all that there could be."""
        makers = {".c": c_source, ".py": python_source}
        return [each for file in self.files()
                for each in makers.get(Path(file).suffix, assembly).mutants(file)]


def included(*names: str) -> list[str]:
    """Returns files of src68k/include."""
    return [f"src68k/include/{name}.i" for name in names]


EDGES = "edge", "extent", "starts", "scissor", "chain", "upright"
#: By name; those of C are called so.
ROOMS = {
    "edges": Room(50, lambda: assembly.files("edge") + included("edge", "extent", "level_reciprocal", "eye"),
                  ("polygons", "meshes")),
    "set-up": Room(60, lambda: assembly.files("polygon", "math") + included(
        "gentle", "outline", "plane", "quotient", "vertices", "perspective", "starts", "level", "cubic", "upright", "clamp"),
        ("polygons", "meshes")),
    "spans": Room(50, lambda: assembly.files("span") + included(
        "span", "chain", "dither", "far", "far_even", "keyed", "short", "wide", "pieces", "perspective_curves",
        "perspective_pieces", "level_draw"), ("polygons", "meshes")),
    "triangles": Room(25, lambda: assembly.files("triangle") + included(
        "triangle", "triangle_chain", "triangle_lines", "triangle_small", "triangle_table", "triangle_wide"),
        ("meshes", "polygons")),
    "meshes": Room(50, lambda: assembly.files("mesh", "depths", "coverage") + included("transform", "depths", "nearest"),
                   ("meshes",)),
    "N64": Room(40, lambda: assembly.files("n64") + included("n64"), ("n64",)),
    "Glide": Room(28, lambda: assembly.files("glide") + included("glide"), ("glide",)),
    "set-up in C": Room(24, lambda: c_source.files("polygon", "perspective", "drawing", "drawing/parts", "triangle"),
                           ("polygons", "meshes")),
    "meshes in C": Room(10, lambda: c_source.files("mesh", "depths", "coverage"), ("meshes",)),
    "model": Room(12, lambda: python_source.files("setup", "model"), ("polygons", "meshes")),
    "units in C": Room(10, lambda: c_source.files("n64/polygons", "glide/polygons"), ("n64", "glide")),
}
#: Those of assembly, which MUTANTS.md lists. The others are tried by --room.
LISTED = tuple(ROOMS)[:7]
