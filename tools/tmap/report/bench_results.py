"""``tmap bench``: writes what was measured, as numbers, tables and pictures, and compares it with the baseline."""

import json
import sys
from pathlib import Path

from tmap.base.errors import UserError
from tmap.base.outputs import as_json, bars, check_directory
from tmap.base.paths import BASELINE
from tmap.bench import bench
from tmap.guest.conditions import CONDITIONS
from tmap.report import bench_pictures


def write(found: dict, out: Path) -> list[str]:
    """bench.json, bench.md and pictures into ``out``; returns the files' names."""
    out.mkdir(parents=True, exist_ok=True)
    machines = list(dict.fromkeys(row["machine"] for kind in bench.UNITS for row in found[kind]))
    text = "# Cycles\n\n" + found["conditions"] + f". {found['emulator']}, {found['compiler']}.\n"
    text += "".join(f"\n{title}:\n\n" + bench.table(found[kind], machines) for kind, title in bench.TITLES.items())
    (out / "bench.md").write_text(text)
    (out / "bench.json").write_text(as_json(found))
    return ["bench.json", "bench.md", *bench_pictures.write(found, out)]


def command(out: Path, machine: str | None, only: str | None, accept: bool) -> int:
    """``tmap bench``: prints the table; status 1 where the baseline is left."""
    check_directory(out)
    if accept and (machine or only):
        raise UserError("bench: --accept needs all machines and all rows")
    machines = [machine] if machine else list(CONDITIONS)
    with bars() as progress:
        task = progress.add_task("bench", total=None)
        found = bench.bench(machines, only or "*", lambda n: progress.update(task, completed=n))
    rows = [row for kind in bench.UNITS for row in found[kind]]
    if not rows:
        raise UserError(f"bench: no row is called {only}")
    names = write(found, out)
    print(bench.table(rows, machines))
    print(f"written to {out}: {', '.join(names)}")
    if accept:
        BASELINE.write_text(as_json(found))
        print("the baseline is these figures now; give the reason in the commit")
        return 0
    if not BASELINE.exists():
        return 0
    complaints = bench.compare(found, json.loads(BASELINE.read_text()))
    for line in complaints:
        print(line, file=sys.stderr)
    return 1 if complaints else 0
