"""``tmap profile``: where a scene's cycles go, routine by routine; and what texture units take a pixel, material by
material, which ``tmap run`` prints.

The scene's program is linked whole and interrupted at regular intervals while its frames are timed; each interrupt
notes the place that the program has reached, and the material that a texture unit draws (src68k/amiga/profile.s). A
routine's cycles are its share of the notes, of what the full renderer takes for the same frames without interrupts.
With n of N notes a share is off by sqrt(n) / N, as a rule. What waits for an instruction to end is noted at the next
one.
"""

import contextlib
import io
import json
from dataclasses import asdict, dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from tmap.base.errors import UserError
from tmap.base.outputs import check_directory
from tmap.build.elf_object import Section
from tmap.compiler.scene import compile_scene, parse
from tmap.guest import emulator, provenance
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.product.scene_program import load_sections, run_whole
from tmap.run.run import drawn, render
from tmap.scene_file.scene_file import Scene

PROFILER = {"_main": "_profile_main", "_clock_start": "_profile_start", "_clock_stop": "_profile_stop",
            "_n64_polygon_draw": "_profile_polygon", "_n64_polygon_draw_coloured": "_profile_coloured",
            "_n64_rectangle_draw": "_profile_rectangle", "_glide_polygon_draw": "_profile_glide"}
NOTES = "profile.notes"
PLACE_BITS = 18  # of a note
LISTED = 24  # routines in the table and the picture
FRAMES = 4  # whose units `tmap run` asks for
LEAST = 0.01  # of a material's cycles: routines that take less are summed


@dataclass(frozen=True)
class Row:
    """A routine and its notes."""

    name: str
    room: str  # the folder of its source
    notes: int
    share: float
    cycles: float  # a frame, mean; of a material: a pixel


@dataclass(frozen=True)
class Profile:
    """A scene's routines, the dearest first. ``ticks``: of each frame, without interrupts; ``units``: routines of each
    material that a texture unit drew, and ``pixels`` of these, by the material's number."""

    rows: list[Row]
    ticks: list[int]
    units: dict[int, list[Row]]
    pixels: dict[int, int]

    @property
    def notes(self) -> int:
        """How often the program was interrupted in its code."""
        return sum(row.notes for row in self.rows)

    @property
    def cycles(self) -> float:
        """The mean of a frame."""
        return float(np.mean(self.ticks)) * CYCLES_PER_TICK


def noted(sections: list[Section], machine: str, folder: Path) -> tuple[dict[Section, tuple[int, int]], np.ndarray]:
    """Returns the places where each section of code begins and ends, and the notes, as in profile.s."""
    layout, done = run_whole(sections, PROFILER, "profile", machine, folder)
    if layout.code_end() > 2 << PLACE_BITS:
        raise UserError("the scene's program: more code than can be noted")
    notes = np.fromfile(done.directory / NOTES, ">u4")
    return {section: (at // 2, (at + section.size + 1) // 2)
            for section in layout.program.parts if section.code for at in (layout.at[section],)}, notes


def rows_of(places: dict[Section, tuple[int, int]], notes: np.ndarray, cycles: float) -> list[Row]:
    """Returns the routines of ``notes``, the dearest first. ``cycles``: of them all."""
    ordered = np.sort(notes & (1 << PLACE_BITS) - 1)
    counts = {section: int(np.subtract(*np.searchsorted(ordered, (end, begin))))
              for section, (begin, end) in places.items()}
    total = sum(counts.values())
    rows = [Row(section.title, Path(section.file).parent.name, n, n / total, cycles * n / total)
            for section, n in counts.items() if n]
    return sorted(rows, key=lambda row: (-row.notes, row.name))


def profile(scene: Scene, machine: str) -> Profile:
    """Returns where the cycles of a scene's frames go."""
    full = render(scene, machine, "addx")
    with emulator.workspace() as folder:
        places, notes = noted(load_sections(scene), machine, folder / "noted")
    if not len(notes):
        raise UserError("the scene's frames are over before the first note")
    cycles = sum(frame["cycles"] for frame in full.figures)
    units, pixels = {}, {}
    for tag in filter(None, np.unique(notes >> PLACE_BITS).tolist()):
        own = notes[notes >> PLACE_BITS == tag]
        pixels[tag - 1] = drawn(full.executed[tag - 1]["spans"])
        if pixels[tag - 1]:
            units[tag - 1] = rows_of(places, own, cycles * len(own) / len(notes) / pixels[tag - 1])
    return Profile(rows_of(places, notes, cycles / scene.frames),
                   [frame["cycles"] // CYCLES_PER_TICK for frame in full.figures], units, pixels)


def table(found: Profile) -> str:
    """Returns the dearest routines, and the sum of the others."""
    rest = found.rows[LISTED:]
    rows = found.rows[:LISTED] + [
        Row(f"{len(rest)} others", "", sum(row.notes for row in rest), sum(row.share for row in rest),
            sum(row.cycles for row in rest))] * bool(rest)
    return "\n".join([f"{'cycles a frame':>14} {'share':>7}  routine",
                      *(f"{row.cycles:>14,.0f} {row.share:>6.1%}  {row.room + '/' * bool(row.room)}{row.name}"
                        for row in rows),
                      f"{found.cycles:>14,.0f}         a frame, mean of {len(found.ticks)}; {found.notes:,} notes"])


def units_table(found: Profile, names: list[str]) -> str:
    """Returns what texture units take for a pixel of each material, routine by routine. ``names``: of materials."""
    lines = []
    for number, rows in found.units.items():
        shown = [row for row in rows if row.share >= LEAST]
        rest = sum(row.cycles for row in rows[len(shown):])
        lines += [f"{names[number]}  {sum(row.cycles for row in rows):,.1f}, of {found.pixels[number]:,} pixels",
                  *(f"{row.cycles:>10,.1f}  {row.room}/{row.name}" for row in shown),
                  *[f"{rest:>10,.1f}  {len(rows) - len(shown)} others"] * (len(shown) < len(rows))]
    return "\n".join(lines)


def print_units(path: Path, machine: str, frames: int | None) -> None:
    """Prints units_table of a scene file's first frames, FRAMES at most; nothing if it has no texture units."""
    content = parse(path)
    with contextlib.redirect_stderr(io.StringIO()):  # the run has printed the notes for the author
        scene = compile_scene(path, min(frames or content["frames"], FRAMES))
    if len(scene.units) + len(scene.pipes) == 0:
        return
    found = profile(scene, machine)
    print(f"\nCycles a pixel of texture units, in {len(found.ticks)} {'frame' if len(found.ticks) == 1 else 'frames'}, "
          f"{found.notes:,} interrupts:\n\n"
          + units_table(found, list(content["materials"])))


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
    names = list(parse(path)["materials"])
    found = profile(compile_scene(path, frames), machine)
    out.mkdir(parents=True, exist_ok=True)
    about = {"scene": path.stem, "machine": machine, **provenance.record(), "ticks": found.ticks,
             "routines": [asdict(row) for row in found.rows],
             "units": {names[number]: {"pixels": found.pixels[number], "routines": [asdict(row) for row in rows]}
                       for number, rows in found.units.items()}}
    (out / "profile.json").write_text(json.dumps(about, indent=1) + "\n")
    plot(found, f"{path.stem} on {machine}: where {found.cycles:,.0f} cycles a frame go", out / "profile.png")
    print(table(found))
    if found.units:
        print(f"\nCycles a pixel of texture units:\n\n{units_table(found, names)}\n")
    print(f"{out / 'profile.json'}, profile.png")
    return 0
