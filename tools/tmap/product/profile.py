"""``tmap profile``: where a scene's cycles go, routine by routine.

The scene's program is linked whole and interrupted at regular intervals while its frames are timed; each interrupt
counts the place that the program has reached (src68k/amiga/profile.s). A routine's cycles are its share of the counts,
of what the full renderer takes for the same frames without interrupts. With n of N counts a share is off by
sqrt(n) / N, as a rule. What waits for an instruction to end is counted at the next one.
"""

import json
from dataclasses import asdict, dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from tmap.base.errors import UserError
from tmap.base.outputs import check_directory
from tmap.base.paths import PROGRAMS
from tmap.build.elf_object import Section
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator, provenance
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.product.scene_program import load_sections, run_programs, run_whole
from tmap.run.run import SCENE_NAME
from tmap.scene_file.scene_file import Scene, write

PROFILER = {"_main": "_profile_main", "_clock_start": "_profile_start", "_clock_stop": "_profile_stop"}
COUNTS = "profile.counts"
LISTED = 24  # routines in the table and the picture


@dataclass(frozen=True)
class Row:
    """A routine and what was counted in it."""

    name: str
    room: str  # the folder of its source
    counts: int
    share: float
    cycles: float  # a frame, mean


@dataclass(frozen=True)
class Profile:
    """A scene's routines, the dearest first. ``ticks``: of each frame, without interrupts."""

    rows: list[Row]
    ticks: list[int]

    @property
    def counts(self) -> int:
        """How often the program was interrupted in its code."""
        return sum(row.counts for row in self.rows)

    @property
    def cycles(self) -> float:
        """The mean of a frame."""
        return float(np.mean(self.ticks)) * CYCLES_PER_TICK


def counted(sections: list[Section], machine: str, folder: Path) -> dict[Section, int]:
    """Returns the counts of each section of code."""
    layout, done = run_whole(sections, PROFILER, "profile", machine, folder)
    counts = np.fromfile(done.directory / COUNTS, ">u4")
    if layout.code_end() > 2 * len(counts):
        raise UserError("the scene's program: more code than can be counted")
    return {section: int(counts[at // 2:(at + section.size + 1) // 2].sum())
            for section in layout.program.parts if section.code for at in (layout.at[section],)}


def profile(scene: Scene, machine: str) -> Profile:
    """Returns where the cycles of a scene's frames go."""
    with emulator.workspace() as folder:
        full, = run_programs(["render"], SCENE_NAME, {SCENE_NAME: write(scene)}, machine, folder / "full",
                             PROGRAMS, scene.frames)
        counts = counted(load_sections(scene), machine, folder / "counted")
    total = sum(counts.values())
    if not total:
        raise UserError("the scene's frames are over before the first count")
    mean = float(np.mean(full.ticks)) * CYCLES_PER_TICK
    rows = [Row(section.title, Path(section.file).parent.name, n, n / total, mean * n / total)
            for section, n in counts.items() if n]
    return Profile(sorted(rows, key=lambda row: (-row.counts, row.name)), full.ticks)


def table(found: Profile) -> str:
    """Returns the dearest routines, and the sum of the others."""
    rest = found.rows[LISTED:]
    rows = found.rows[:LISTED] + [
        Row(f"{len(rest)} others", "", sum(row.counts for row in rest), sum(row.share for row in rest),
            sum(row.cycles for row in rest))] * bool(rest)
    return "\n".join([f"{'cycles a frame':>14} {'share':>7}  routine",
                      *(f"{row.cycles:>14,.0f} {row.share:>6.1%}  {row.room + '/' * bool(row.room)}{row.name}"
                        for row in rows),
                      f"{found.cycles:>14,.0f}         a frame, mean of {len(found.ticks)}; {found.counts:,} counts"])


def plot(found: Profile, title: str, path: Path) -> None:
    """Draws the dearest routines as bars, a colour for each room."""
    rows = found.rows[:LISTED][::-1]
    rooms = sorted({row.room for row in rows})
    figure, axes = plt.subplots(figsize=(9, 1 + 0.27 * len(rows)), layout="constrained")
    for k, room in enumerate(rooms):
        own = [(n, row) for n, row in enumerate(rows) if row.room == room]
        axes.barh([n for n, _ in own], [row.cycles for _, row in own], color=f"C{k}", label=room)
    axes.set_yticks(range(len(rows)), [row.name for row in rows])
    axes.set_xlabel("68020 cycles a frame")
    axes.set_title(title)
    axes.legend()
    figure.savefig(path, dpi=100)
    plt.close(figure)


def command(path: Path, out: Path, machine: str, frames: int | None) -> int:
    """Profiles a scene file and writes profile.json and profile.png into the directory ``out``; raises UserError."""
    check_directory(out)
    found = profile(compile_scene(path, frames), machine)
    out.mkdir(parents=True, exist_ok=True)
    about = {"scene": path.stem, "machine": machine, **provenance.record(), "ticks": found.ticks,
             "routines": [asdict(row) for row in found.rows]}
    (out / "profile.json").write_text(json.dumps(about, indent=1) + "\n")
    plot(found, f"{path.stem} on {machine}: where {found.cycles:,.0f} cycles a frame go", out / "profile.png")
    print(f"{table(found)}\n{out / 'profile.json'}, profile.png")
    return 0
