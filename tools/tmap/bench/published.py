"""Published loops and renderers beside ours: the same work measured on the same emulator. published.toml
has their figures, in cycles a pixel or a polygon, and where they are from."""

import tomllib
from dataclasses import dataclass
from pathlib import Path

from tmap.base.markdown import MACHINES
from tmap.bench import bench

LONG, SHORT = 256, 16  # pixels of a span
FLOOR_LONG = 1024  # the same where memory alone is measured


@dataclass(frozen=True)
class Loop:
    """One loop; figures that nobody took are None."""

    name: str
    source: str
    cycles: list[float]  # of LONG pixels, in the order of MACHINES
    exact: bool  # to 16 fraction bits
    short: float | None = None  # of SHORT pixels with set-up, fast RAM
    ours: bool = False
    repository: str = ""
    file: str = ""
    commit: str = ""


@dataclass(frozen=True)
class Renderer:
    """A published renderer of whole polygons."""

    name: str
    source: str
    repository: str
    kind: str  # flat, gouraud or affine
    cycles: list[int]  # a polygon, by polygon_sets.SIZES
    pixels: float  # of them wrong, per cent
    texels: float | None = None  # or shades


_READ = tomllib.loads(Path(__file__).with_suffix(".toml").read_text())
RENDERERS = [Renderer(**each) for each in _READ.pop("polygons")]
#: Kind of work to the published loops for it.
PUBLISHED = {kind: [Loop(**loop) for loop in loops] for kind, loops in _READ.items()}
#: Kind of work to our rows of the bench: row, name, what it is, whether it is exact.
OURS = {
    "textured": (("affine_addx", "affine, addx", "one circular chain of addx", True),
                 ("affine_swap", "affine, swap", "the same work by swap", True),
                 ("affine_c", "affine, C", "the same work in C", True),
                 ("generated", "generated", "code written for each polygon; a line's start loses "
                  "its fraction", False)),
    "lit": (("affine_lit", "lit", "256x256 texels through a light table, one level a polygon",
             True),
            ("affine_gouraud", "lit_gouraud", "the same, a level each pixel", True)),
}


def ranked(kind: str, measured: dict) -> list[Loop]:
    """All loops for a kind of work, ours from the bench; the fastest in fast RAM first."""
    figures = bench.figures(measured["rows"])
    ours = [Loop(name, source, [figures[row, machine, LONG] for machine in MACHINES], exact,
                 figures[row, "a1200-fast", SHORT], True)
            for row, name, source, exact in OURS[kind]]
    return sorted([*PUBLISHED[kind], *ours], key=lambda loop: loop.cycles[0])


def places(loops: list[Loop]) -> dict[str, list[int]]:
    """Each loop's place, from 1 on, on each of MACHINES."""
    return {each.name: [1 + sum(other.cycles[k] < each.cycles[k] for other in loops)
                        for k in range(len(MACHINES))] for each in loops}


def floors(measured: dict, row: str = "floor_copy") -> tuple[float, ...]:
    """What memory alone takes a pixel on each of MACHINES: a byte fetched and one stored."""
    figures = bench.figures(measured["rows"])
    return tuple(figures[row, machine, FLOOR_LONG] for machine in MACHINES)
