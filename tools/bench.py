"""``tmap bench``: measures every kernel, checks what it drew, reports and compares.

Cycles are exact in this emulator: repeats agree to within one tick of the clock (a colour clock,
4 cycles) in a whole measurement. The cost of calling is measured with a routine
that only returns, and subtracted.
"""

import fnmatch
import json
import sys
from pathlib import Path

from . import bench_cases, bench_modes, bench_rules, bench_scenes, provenance
from .emulator import CYCLES_PER_TICK
from .errors import UserError
from .kernels import Case, call
from .paths import BASELINE
from .plots import plt

#: Name to (emulated machine, data in chip RAM).
CONDITIONS = {"a1200": ("a1200", True), "a1200-fast": ("a1200-fast", False),
              "a1200-mixed": ("a1200-fast", True)}
#: Ticks a measurement lasts at least: one tick of doubt is then below 1 in 25,000.
TICKS = 25_000
#: The same where something is displayed, of which a field's lines have the most and its ends
#: nothing: 10 fields of 71,000 ticks.
TICKS_SHOWN = 710_000
ROUGH_CYCLES_PER_UNIT = 20
NOTHING_REPEATS = 2000  # calls of the routine that only returns
#: What a figure counts. "one_tick" beside it is one tick of the clock in the same unit.
UNITS = {"rows": "cycles_per_pixel", "lines": "cycles_per_line", "points": "cycles_per_point",
         "instructions": "cycles_per_instruction",
         "frames": "cycles_per_frame", "rules": "cycles_per_polygon",
         "modes": "cycles_per_pixel", "first_frames": "cycles_more"}
#: Kinds that depend on the C compiler.
IN_C = ("frames", "rules", "modes", "first_frames")
TOLERANCE = 0.01  # a change beyond it needs a new baseline and a reason in the commit
#: Ticks by which two measurements of the same may differ: each is the difference of two times, and
#: each of those is off by less than one.
DOUBT = 4


def repeats(row: bench_cases.Row) -> int:
    """Calls that last about TICKS, or TICKS_SHOWN."""
    ticks = TICKS if row.case.display == "OFF" else TICKS_SHOWN
    return max(4, ticks * CYCLES_PER_TICK // (row.units * ROUGH_CYCLES_PER_UNIT))


def measure(machine: str, only: str = "*", on_case=None) -> dict[str, list[dict]]:
    """Rows of one machine by kind: in pixels, lines, points, instructions, frames, polygons with and
    without a rule of lowering, and modes of the texture engine."""
    boot, chip = CONDITIONS[machine]
    kinds = {"rows": bench_cases.pixel_rows(chip), "lines": bench_cases.line_rows(chip),
             "points": bench_cases.point_rows(chip),
             "instructions": bench_cases.instruction_rows(chip)}
    kinds = {kind: [r for r in rows if fnmatch.fnmatch(r.name, only)]
             for kind, rows in kinds.items()}
    rows = [row for kind in kinds.values() for row in kind]
    frames = bench_scenes.measure(machine, [name for name in bench_scenes.NAMES
                                            if fnmatch.fnmatch(f"scene_{name}", only)])
    whole = {"frames": frames, "rules": bench_rules.measure(
        machine, [f"rule_{case.name}" for case in bench_rules.CASES
                  if fnmatch.fnmatch(f"rule_{case.name}", only)])}
    whole |= bench_modes.measure(machine, [name for name in bench_modes.EVERY if fnmatch.fnmatch(
        f"{bench_modes.ROW}{name}", only)])
    if not rows:
        return {kind: [] for kind in kinds} | whole
    for row in rows:
        row.case.repeats = repeats(row)
    nothing = Case("nothing", repeats=NOTHING_REPEATS)
    overhead, *results = call([nothing] + [row.case for row in rows], boot, on_case)
    per_call = overhead.cycles / nothing.repeats
    measured = {}
    for row, result in zip(rows, results):
        wrong = row.check(result)
        if wrong:
            raise UserError(f"bench: {row.name}, length {row.length}, {machine}: {wrong}")
        cycles = (result.cycles / row.case.repeats - per_call) / row.units
        measured[id(row)] = round(cycles, 3), CYCLES_PER_TICK / row.case.repeats / row.units
    return {kind: [{"name": r.name, "machine": machine, "length": r.length,
                    UNITS[kind]: measured[id(r)][0], "one_tick": round(measured[id(r)][1], 5)}
                   for r in group] for kind, group in kinds.items()} | whole


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
    old = {key(row): cycles(row) for kind in UNITS for row in baseline.get(kind, [])}
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
            elif abs(now - before) > max(TOLERANCE * before, DOUBT * row["one_tick"]):
                complaints.append(f"{where}: {now} cycles, the baseline says {before} "
                                  f"({100 * (now - before) / before:+.1f} %)")
    return complaints


def table(rows: list[dict], machines: list[str]) -> str:
    """Markdown: a line for each name and length, a column for each machine."""
    lines = ["| row | length | " + " | ".join(machines) + " |",
             "|---|---|" + "---|" * len(machines)]
    values = figures(rows)
    for name, length in dict.fromkeys((row["name"], row["length"]) for row in rows):
        cells = [f"{values[name, m, length]:.2f}" if (name, m, length) in values else ""
                 for m in machines]
        lines.append(f"| {name} | {length} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def plot(rows: list[dict], machines: list[str], path: Path) -> None:
    """Bars: cycles a pixel of each row at its longest length."""
    longest = {}
    for row in rows:
        longest[row["name"]] = max(longest.get(row["name"], 0), row["length"])
    names = sorted(longest, key=lambda n: -min(cycles(r) for r in rows if r["name"] == n))
    figure, axes = plt.subplots(figsize=(9, 0.32 * len(names) + 1.5), layout="constrained")
    height = 0.8 / len(machines)
    values = figures(rows)
    for k, machine in enumerate(machines):
        axes.barh([i + (k - (len(machines) - 1) / 2) * height for i in range(len(names))],
                  [values.get((n, machine, longest[n]), 0) for n in names], height, label=machine)
    axes.set_yticks(range(len(names)), [f"{n} ({longest[n]})" for n in names])
    axes.set_xlabel("68020 cycles a pixel (or a step), emulated A1200; in brackets the length")
    axes.grid(axis="x", alpha=0.3)
    axes.legend()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def bench(machines: list[str], only: str = "*", on_case=None) -> dict:
    """The content of bench.json."""
    found = {kind: [] for kind in UNITS}
    for machine in machines:
        for kind, rows in measure(machine, only, on_case).items():
            found[kind] += rows
    return provenance.record() | {
        "conditions": "DMA and interrupts off (but for rows ..._low, _high, _super: eight planes of "
                      "320, 640, 1280 dots are displayed), instruction cache warm, 256x256 8-bit map, "
                      "du 1.5, dv 1.25, the cost of the call subtracted", **found}


def write(found: dict, out: Path) -> None:
    """bench.json, bench.md and bench.png into ``out``."""
    out.mkdir(parents=True, exist_ok=True)
    machines = list(dict.fromkeys(row["machine"] for kind in UNITS
                                  for row in found[kind]))
    text = "# Cycles\n\n" + found["conditions"] + f". {found['emulator']}, {found['compiler']}.\n"
    text += "\nCycles a pixel (step_*: a step):\n\n" + table(found["rows"], machines)
    text += "\nCycles a line:\n\n" + table(found["lines"], machines)
    text += "\nCycles a point (mesh_looks: a normal, mesh_faces: a face):\n\n" \
        + table(found["points"], machines)
    text += "\nCycles of instructions, with a loop's around 16 of them:\n\n" \
        + table(found["instructions"], machines)
    text += f"\nCycles a frame, mean of {bench_scenes.FRAMES}:\n\n" + table(found["frames"], machines)
    text += "\nCycles a polygon, with each rule of lowering and without it:\n\n" \
        + table(found["rules"], machines)
    text += "\nTexture engines' modes, cycles a pixel of a polygon (_c: in plain C):\n\n" \
        + table(found["modes"], machines)
    text += "\nCycles that the first frame costs more: tables, texels decoded:\n\n" \
        + table(found["first_frames"], machines)
    if found["rows"]:
        plot(found["rows"], machines, out / "bench.png")
    (out / "bench.md").write_text(text)
    (out / "bench.json").write_text(json.dumps(found, indent=1) + "\n")


def command(out: str, machine: str | None, only: str | None, accept: bool) -> int:
    """``tmap bench``: prints the table; status 1 where the baseline is left."""
    from rich.progress import Progress

    if Path(out).exists() and not Path(out).is_dir():
        raise UserError(f"{out}: is not a directory")
    if accept and (machine or only):
        raise UserError("bench: --accept needs all machines and all rows")
    machines = [machine] if machine else list(CONDITIONS)
    with Progress(transient=True, disable=not sys.stderr.isatty()) as progress:
        task = progress.add_task("bench", total=None)
        found = bench(machines, only or "*", lambda n: progress.update(task, completed=n))
    rows = [row for kind in UNITS for row in found[kind]]
    if not rows:
        raise UserError(f"bench: no row is called {only}")
    write(found, Path(out))
    print(table(rows, machines))
    print(f"written to {out}: bench.json, bench.md, bench.png")
    if accept:
        BASELINE.parent.mkdir(parents=True, exist_ok=True)
        BASELINE.write_text(json.dumps(found, indent=1) + "\n")
        print("the baseline is these figures now; give the reason in the commit")
        return 0
    if not BASELINE.exists():
        return 0
    complaints = compare(found, json.loads(BASELINE.read_text()))
    for line in complaints:
        print(line, file=sys.stderr)
    return 1 if complaints else 0
