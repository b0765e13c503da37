"""The table that owners of an A1200 measure: rows of the bench, as a plan for ``measure``.

Each row's cycles are the committed ones; what it must draw is found out on the emulated
machine, where the bench's own check has looked at it.
"""

import json
from dataclasses import dataclass

from tmap.base.errors import UserError
from tmap.base.paths import BASELINE
from tmap.bench import cases as bench_cases
from tmap.bench.bench import NOTHING_REPEATS, cycles, key, repeats
from tmap.guest.kernels import Case, Shown, call, checksum, plan

MACHINES = ("a1200", "a1200-fast")
#: Widest title, in columns of the screen.
TITLE = 16


@dataclass(frozen=True)
class Entry:
    """A row of the bench and its title. ``chip``: maps and frame are in chip RAM where there is
    fast RAM, too; ``apart``: and that is all the row is for, so it is left out elsewhere."""

    name: str
    length: int
    title: str
    chip: bool = False
    apart: bool = False

    @property
    def conditions(self) -> tuple[str | None, str]:
        """What the bench measured it under: with chip RAM alone, with fast RAM."""
        return None if self.apart else "a1200", "a1200-mixed" if self.chip else "a1200-fast"


#: Two of them are a line of the screen.
ENTRIES = (
    *(Entry(f"step_{form}_{n}", 1024, f"step, {form}, {n}") for n in (1, 2, 3)
      for form in ("swap", "addx")),
    *(Entry(f"affine_{form}", n, f"affine {form} {n}") for n in (256, 16)
      for form in ("swap", "addx")),
    Entry("affine_c", 256, "affine C 256"), Entry("affine_c", 16, "affine C 16"),
    Entry("affine_row", 256, "row 256"), Entry("affine_column", 256, "column 256"),
    Entry("affine_copy", 256, "copy 256"), Entry("fill", 256, "fill 256"),
    Entry("affine_lit", 256, "lit 256"), Entry("affine_gouraud", 256, "lit Gouraud 256"),
    Entry("gouraud", 256, "Gouraud 256"), Entry("affine_addx_wrap", 256, "addx, wrap 256"),
    Entry("persp_every16_exact", 256, "persp. 16 exact"),
    Entry("persp_every8_exact", 256, "persp. 8 exact"),
    Entry("persp_pixel_exact", 256, "persp. pixel"), Entry("persp_pixel_fine", 256, "persp. fine"),
    Entry("c2p_8", 320, "c2p, 8 planes", chip=True),
    Entry("c2p_ham8_16", 160, "c2p, HAM8 565", chip=True),
    Entry("n64_threepoint", 256, "N64 3 points"), Entry("glide_point", 256, "Glide point"),
    Entry("glide_bilinear", 256, "Glide bilinear"), Entry("glide_bilinear_565", 256, "Glide bil. 565"),
    Entry("glide_tile_16", 256, "Glide tile, 16"), Entry("glide_tile_32", 256, "Glide tile, 32"),
    Entry("affine_swap", 256, "swap, data chip", chip=True, apart=True),
    Entry("affine_addx", 256, "addx, data chip", chip=True, apart=True),
)


def origin(baseline: dict) -> str:
    """What the figures were measured with."""
    return f"{baseline['emulator']}, {baseline['compiler']}, {baseline['commit']}"


def rows() -> list[bench_cases.Row]:
    """The bench's rows of all entries, as often called as there."""
    made = {(row.name, row.length): row for row in bench_cases.rows("rows", False)}
    chosen = []
    for entry in ENTRIES:
        assert len(entry.title) <= TITLE, entry
        row = made[entry.name, entry.length]
        case = Case(**vars(row.case) | {"chip": entry.chip, "repeats": repeats(row)})
        chosen.append(bench_cases.Row(row.name, row.length, row.units, case, row.check))
    return chosen


def drawn(chosen: list[bench_cases.Row]) -> list[int]:
    """The checksum of what each row draws, 0 where that is not in its far memory."""
    results = call([row.case for row in chosen], "a1200-fast")
    for row, result in zip(chosen, results):
        wrong = row.check(result)
        if wrong:
            raise UserError(f"measure: {row.name}, length {row.length}: {wrong}")
    return [checksum(result.far_memory) if result.far_memory else 0 for result in results]


def make() -> bytes:
    """The plan file: first a call of nothing, by whose title the figures' origin is told."""
    baseline = json.loads(BASELINE.read_text())
    figures = {key(row): cycles(row) for row in baseline["rows"]}
    chosen = rows()
    cases = [Case("nothing", repeats=NOTHING_REPEATS, shown=Shown(origin(baseline), 0, 0, 0, 0))]
    for entry, row, sums in zip(ENTRIES, chosen, drawn(chosen)):
        chip, fast = (round(1000 * figures[entry.name, machine, entry.length]) if machine else 0
                      for machine in entry.conditions)
        row.case.shown = Shown(entry.title, row.units, chip, fast, sums)
        cases.append(row.case)
    return plan(cases)
