"""The bench: measures every kernel, checks what it drew, and compares.

Cycles are exact in this emulator: repeats agree to within one tick of the clock (a colour clock,
4 cycles) in a whole measurement. The cost of calling is measured with a routine
that only returns, and subtracted.
"""

import fnmatch

from tmap.base import markdown
from tmap.bench import cases, deep, rules as bench_rules, scenes
from tmap.bench.modes import measure as bench_modes
from tmap.guest import provenance
from tmap.guest.conditions import CONDITIONS
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.guest.kernels import Case, call

#: Ticks a measurement lasts at least: one tick of doubt is then below 1 in 25,000.
TICKS = 25_000
#: The same where something is displayed, of which a field's lines have the most and its ends
#: nothing: 10 fields of 71,000 ticks.
TICKS_SHOWN = 710_000
NOTHING_REPEATS = 2000  # calls of the routine that only returns
#: What a figure counts. "one_tick" beside it is one tick of the clock in the same unit.
UNITS = {"rows": "cycles_per_pixel", "lines": "cycles_per_line", "points": "cycles_per_point",
         "polygons": "cycles_per_polygon", "instructions": "cycles_per_instruction",
         "frames": "cycles_per_frame", "rules": "cycles_per_polygon",
         "deep": "cycles_per_polygon",
         "modes": "cycles_per_pixel", "first_frames": "cycles_more"}
#: What stands over each kind's table.
TITLES = {"rows": "Cycles a pixel (step_*: a step)", "lines": "Cycles a line",
          "points": "Cycles a point (mesh_attributes: a normal, mesh_faces: a face)",
          "polygons": "Cycles a triangle of so many pixels, set-up included: edges snapped, a batch of 32",
          "instructions": "Cycles of instructions, with a loop's around 16 of them",
          "frames": f"Cycles a frame, mean of {scenes.FRAMES}",
          "rules": "Cycles a polygon, with each rule of lowering and without it",
          "deep": f"Cycles a polygon in perspective, edges exact, mean of {deep.COUNT}: textured, lit, a level "
                  "a pixel; affine beside them",
          "modes": "Texture engines' modes, cycles a pixel of a polygon (_c: in plain C)",
          "first_frames": "Cycles that the first frame costs more: tables, texels decoded"}
#: Kinds that depend on the C compiler.
IN_C = ("frames", "rules", "deep", "modes", "first_frames")
TOLERANCE = 0.01  # a change beyond it needs a new baseline and a reason in the commit
#: Ticks by which two measurements of the same may differ: each is the difference of two times, and
#: each of those is off by less than one.
DOUBT = 4


def repeats(row: cases.Row) -> int:
    """Calls that last about TICKS, or TICKS_SHOWN."""
    ticks = TICKS if row.case.display == "OFF" else TICKS_SHOWN
    return max(4, ticks * CYCLES_PER_TICK // (row.units * row.rough))


def measure_kernels(machine: str, only: str, on_case=None) -> dict[str, list[dict]]:
    """The rows of kernels called one by one, by kind: in pixels, lines, points, instructions."""
    condition = CONDITIONS[machine]
    rows = [(kind, row) for kind in cases.KINDS for row in cases.rows(kind, condition.chip)
            if fnmatch.fnmatch(row.name, only)]
    found: dict[str, list[dict]] = {kind: [] for kind in cases.KINDS}
    if not rows:
        return found
    for _, row in rows:
        row.case.repeats = repeats(row)
    nothing = Case("nothing", repeats=NOTHING_REPEATS)
    overhead, *results = call([nothing, *(row.case for _, row in rows)], condition.machine, on_case)
    for (kind, row), result in zip(rows, results, strict=True):
        if wrong := row.check(result):
            raise UserError(f"bench: {row.name}, length {row.length}, {machine}: {wrong}")
        spent = result.cycles / row.case.repeats - overhead.cycles / nothing.repeats
        found[kind].append({
            "name": row.name, "machine": machine, "length": row.length,
            UNITS[kind]: round(spent / row.units, 3),
            "one_tick": round(CYCLES_PER_TICK / row.case.repeats / row.units, 5)})
    return found


def measure(machine: str, only: str = "*", on_case=None, plain: bool = True) -> dict[str, list[dict]]:
    """Rows of one machine by kind: those of kernels, then frames, polygons with and without a rule of
    lowering, polygons with depth, and modes of the texture engines. ``machine``: of CONDITIONS; ``only``: a pattern of
    names; ``on_case``: told how many kernels were begun; ``plain``: with modes in plain C."""
    def chosen(prefix: str, names) -> list[str]:
        return [name for name in names if fnmatch.fnmatch(prefix + name, only)]

    rules = chosen(bench_rules.ROW, (case.name for case in bench_rules.CASES))
    return (measure_kernels(machine, only, on_case)
            | {"frames": scenes.measure(machine, chosen(scenes.ROW, scenes.NAMES)),
               "rules": bench_rules.measure(machine, rules),
               "deep": deep.measure(machine, chosen(deep.ROW, deep.MATERIALS))}
            | bench_modes.measure(machine, chosen(bench_modes.ROW, bench_modes.EVERY), plain))


def key(row: dict) -> tuple:
    """What identifies a row."""
    return row["name"], row["machine"], row["length"]


def cycles(row: dict) -> float:
    """Cycles a pixel, a line, a point, a frame or a polygon, or of a first frame."""
    return next(row[unit] for unit in UNITS.values() if unit in row)


def figures(rows: list[dict]) -> dict[tuple, float]:
    """Cycles by what identifies a row."""
    return {key(row): cycles(row) for row in rows}


def compare(found: dict, baseline: dict) -> list[str]:
    """Rows that left the baseline by more than TOLERANCE and DOUBT, in words."""
    old = figures([row for kind in UNITS for row in baseline.get(kind, [])])
    complaints = []
    for kind in UNITS:
        for row in found[kind]:
            in_c = row["name"].endswith("_c") or kind in IN_C
            if in_c and found["compiler"] != baseline["compiler"]:
                continue  # another compiler's code: nothing to compare
            before, now = old.get(key(row)), cycles(row)
            where = "{} {} length {}".format(*key(row))
            if before is None:
                complaints.append(f"{where}: {now} cycles, not in the baseline")
            elif abs(now - before) > max(TOLERANCE * abs(before), DOUBT * row["one_tick"]):
                change = f" ({100 * (now - before) / before:+.1f} %)" if before else ""
                complaints.append(f"{where}: {now} cycles, the baseline says {before}{change}")
    return complaints


def table(rows: list[dict], machines: list[str]) -> str:
    """Markdown: a line for each name and length, a column for each machine."""
    values = figures(rows)
    cells = [[name, str(length), *(f"{values[name, m, length]:.2f}" if (name, m, length) in values else ""
                                   for m in machines)]
             for name, length in dict.fromkeys((row["name"], row["length"]) for row in rows)]
    return markdown.table(["row", "length", *machines], cells, "l") + "\n"


def bench(machines: list[str], only: str = "*", on_case=None, plain: bool = True) -> dict:
    """The content of bench.json; parameters as in ``measure``."""
    found = {kind: [] for kind in UNITS}
    for machine in machines:
        for kind, rows in measure(machine, only, on_case, plain).items():
            found[kind] += rows
    return provenance.record() | {
        "conditions": "DMA and interrupts off (but for rows ..._low, _high, _super: eight planes of "
                      "320, 640, 1280 dots are displayed), instruction cache warm, 256x256 8-bit map, "
                      "du 1.5, dv 1.25, the cost of the call subtracted", **found}
