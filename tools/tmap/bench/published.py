"""Published loops beside ours: the same work measured on the same emulator.

Their inner loops were taken as published and run under the bench's conditions: a span of 256
pixels, code in fast RAM, du 1.5, dv 1.25, FS-UAE 3.1.66, DMA off. The figures are cycles a pixel.
"""

from dataclasses import dataclass

from tmap.base.markdown import MACHINES
from tmap.bench import bench

LONG, SHORT = 256, 16  # pixels of a span
FLOOR_LONG = 1024  # the same where memory alone is measured


@dataclass(frozen=True)
class Loop:
    """One loop; figures that nobody took are None."""

    name: str
    source: str
    cycles: tuple[float, float, float]  # of LONG pixels, in the order of MACHINES
    short: float | None  # of SHORT pixels with set-up, fast RAM
    exact: bool  # to 16 fraction bits
    ours: bool = False


#: Kind of work to the published loops for it.
PUBLISHED = {
    "textured": (
        Loop("move and swap, dbra", "the textbook loop", (40.2, 44.3, 44.5), 37.8, True),
        Loop("move and swap, eight times unrolled", "the textbook loop in its best form",
             (29.3, 33.4, 33.6), None, True),
        Loop("Quake, 1x1 pixels", "a Quake port for the 68060: the best exact one published",
             (25.8, 33.9, 34.1), 37.2, True),
        Loop("demo loop, 8.8 steps", "the best one published in a demo; one texel in four is wrong "
             "on odd slopes", (22.4, 34.6, 45.0), 28.5, False)),
    "lit": (
        Loop("R_DrawSpan", "DoomAttack, 68020 and 68030: 64x64 texels through a light table",
             (31.9, 39.6, 40.8), 54.3, True),),
}
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
    ours = [Loop(name, source, tuple(figures[row, machine, LONG] for machine in MACHINES),
                 figures[row, "a1200-fast", SHORT], exact, True)
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
