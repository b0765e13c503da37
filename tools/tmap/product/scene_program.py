"""``tmap scene-program``: a program that holds one scene and only the code that draws it.

The scene's program is linked whole and run once, with each executed instruction recorded. The final
program has only those. It draws the same frames again, so it executes no other instructions. This
is checked here, and also that every frame takes the same time as in the full renderer.
"""

import json
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tmap.base.errors import UserError
from tmap.base.outputs import check_directory
from tmap.base.paths import BUILD, PROGRAMS, PROGRAMS_BASELINE, ROOT
from tmap.build import elf_object
from tmap.compiler.scene import compile_scene
from tmap.guest import emulator, provenance
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.product import still
from tmap.product.program_layout import HOLES, Layout
from tmap.product.program_parts import Program
from tmap.run.run import SCENE_NAME, parse_output
from tmap.scene_file.scene_file import Scene, write
from tmap.scene_file.textures import ordered

#: Calls of the first symbol go to the second: if memory is short, the program ends with a line.
ALIASES = {"_mem_alloc": "_mem_need", "_mem_take": "_mem_need_take",
           "workbench": "workbench_none"}
#: Where a program begins: it moves its code to its places, and goes on to its start. Offsets count from there.
ENTRY = "unpack"
TRACER = {"_main": "_trace_main", "_clock_wait": "_trace_wait",
          "_clock_start": "_trace_start"}
FLAGS = "trace.flags"
TIMED, AGAIN = 2, 4  # bits of a flag: executed while a frame is timed; more than once meanwhile
RENDER_LINK = BUILD / "obj" / "render.link"
LINKED = re.compile(r"^ (\S+)\s+0x([0-9a-f]+)\s+0x[0-9a-f]+ (\S+\.o)$", re.M)

TRACE_PATIENCE = 10 * emulator.STALL_SECONDS  # instructions take some 30 times as long
#: Ticks by which a frame may take longer than the full renderer's: 20 cycles, for a few longwords
#: of code that are fetched once more at other addresses.
LONGER = 20 // CYCLES_PER_TICK
ORDERS = 32  # orders in which a layout's parts are placed: they save some 100 bytes of 10,000
TOGETHER = 8  # layouts that are tried in one boot, after the first
ROUTINES = 12  # listed in the report


@dataclass
class Run:
    """A program's frames: dumps by name, ticks of each frame."""

    dumps: dict[str, bytes]
    ticks: list[int]


def scene_section(scene: Scene) -> elf_object.Section:
    """Returns the scene as a section of the program."""
    data = write(scene, with_palette=False)
    return elf_object.Section("", ".rodata.scene_data", data, len(data), 4,
                           symbols={"_scene_data": 0})


def load_sections(scene: Scene, ready: bool = False) -> list[elf_object.Section]:
    """Returns all sections that a program may hold; ``ready``: of a still scene."""
    compiler, *files = (BUILD / "obj" / "objects").read_text().split()
    if not ready:
        files.append(f"build/obj/{compiler}/programs/scene.o")
    found = [section for name in files for section in elf_object.load(ROOT / name)]
    found.append(elf_object.Section("", HOLES, b"", 0, 4, bss=True, symbols={"holes": 0}))
    if not ready:
        return [*found, scene_section(scene)]
    main = next(section for section in found if still.MAIN in section.symbols)
    main.symbols["_main"] = main.symbols[still.MAIN]
    return [*found, *still.sections(scene)]


def run_whole(sections: list[elf_object.Section], wrapper: dict[str, str], name: str, machine: str,
              folder: Path, patience: float | None = None,
              timed: bool = True) -> tuple[Layout, emulator.Result]:
    """Links the whole program of a scene, some of its routines replaced, and runs it once.

    ``wrapper``: calls of the first symbol go to the second; ``name``: the program's; ``patience``, ``timed``: as in
    emulator.run_batch."""
    layout = Layout(Program(sections, ALIASES | wrapper, None), {})
    folder.mkdir()
    layout.write(folder / name)
    done = emulator.run(name, "", {}, machine, folder / "run", programs=folder, patience=patience,
                        timed=timed)
    if done.code:
        raise UserError(f"the scene's program: return code {done.code}; "
                        + emulator.last_words(done.output))
    return layout, done


def renderer_places(sections: list[elf_object.Section]) -> dict[elf_object.Section, int]:
    """Returns the addresses of sections in the full renderer."""
    places = {(str(ROOT / file), name): at
              for name, address, file in LINKED.findall(RENDER_LINK.read_text())
              if (at := int(address, 16))}  # 0: the linker dropped it
    return {s: places[s.file, s.name] for s in sections if (s.file, s.name) in places}


def measure(sections: list[elf_object.Section], folder: Path, timing: dict[str, str] | None = None) -> dict:
    """Runs the whole program once on the emulator; returns the executed offsets of each section,
    and timed as in Part. ``timing``: a wrapper by which its frames are timed."""
    layout, done = run_whole(sections, TRACER | (timing or {}), "trace", "a1200-fast", folder, TRACE_PATIENCE,
                             timed=False)
    flags = np.frombuffer((done.directory / FLAGS).read_bytes(), np.uint8)
    if layout.code_end() > 2 * len(flags):
        raise UserError("the scene's program: more code than can be traced")
    trace = {}
    for section in layout.program.parts:
        if section.code:
            at = layout.at[section]
            found = flags[at // 2:(at + section.size + 1) // 2]
            timed = sum(bool((found & bit).any()) for bit in (TIMED, AGAIN))
            trace[section] = (2 * np.flatnonzero(found)).tolist(), timed
    return trace


def run_programs(names: list[str], arguments: str, files: dict, machine: str, folder: Path,
                 programs: Path, frames: int) -> list[Run]:
    """Runs a scene's programs in one boot or, with arguments, the full renderer."""
    ended = emulator.run_batch([f"{name} {arguments}" for name in names], files, machine, folder,
                               programs=programs, folders=not arguments)
    found = []
    for name, done in zip(names, ended):
        if fault := emulator.explain_fault(programs / name, done.output):
            raise UserError(fault)
        if done.code:
            raise UserError(f"{name}: return code {done.code}; {emulator.last_words(done.output)}")
        if arguments:
            ticks = [frame["cycles"] // CYCLES_PER_TICK
                     for frame in parse_output(done.output, frames, 0)[0]]
        else:
            ticks = [int(line) for line in done.output.split()]
        dumps = {path.name: path.read_bytes() for path in done.directory.glob("*.chunky")}
        found.append(Run(dumps, ticks))
    return found


def compare(full: Run, own: Run, name: str) -> None:
    """Refuses a program whose frames differ from the full renderer's."""
    if sorted(full.dumps) != sorted(own.dumps) or len(full.ticks) != len(own.ticks):
        raise UserError(f"{name}: {len(own.dumps)} frames drawn and {len(own.ticks)} timed where "
                        f"the full renderer has {len(full.dumps)} and {len(full.ticks)}")
    for dump in sorted(full.dumps):
        if full.dumps[dump] != own.dumps[dump]:
            raise UserError(f"{name}: {dump} is not what the full renderer draws")


def check_dumps(full: Run, program: Path, machine: str, folder: Path) -> None:
    """Runs a program without a clock; refuses one whose frames differ from the full renderer's."""
    own, = run_programs([program.name], "", {}, machine, folder, program.parent, len(full.dumps))
    compare(Run(full.dumps, []), own, program.name)


def is_as_fast(own: int, full: int) -> bool:
    """Returns True if a frame's ticks exceed the full renderer's by at most LONGER."""
    return own <= full + LONGER


def layouts(program: Program, places: dict[elf_object.Section, int]) -> list[Layout]:
    """Returns layouts of the program, the smallest first. These parts keep their places in the full
    renderer: none, those timed more than once, all timed ones (Part.timed); the latter two in
    ORDERS orders. Layouts that do not fit are left out, unless none fits."""
    made = []
    for least in (3, 2, 1):
        fixed = {p.section: places[p.section] for p in program.parts.values()
                 if p.timed >= least and p.section in places}
        made += [Layout(program, fixed, order) for order in range(ORDERS if fixed else 1)]
    return sorted([each for each in made if each.fits] or made, key=lambda layout: layout.size)


def fit(program: Program, places: dict[elf_object.Section, int], full: Run, name: str,
        machine: str, folder: Path, timed: Program | None = None) -> tuple[Layout, Run]:
    """Returns the smallest layout whose frames are all as fast as the full renderer's, or the
    last. ``timed``: the program with the clock that it has not itself, behind its own bytes."""
    tried = layouts(program, places)
    for first in [0, *range(1, len(tried), TOGETHER)]:
        some = tried[first:first + TOGETHER if first else 1]
        made = folder / f"made{first}"
        made.mkdir()
        names = [f"{name}{number}" for number in range(len(some))]
        for own, layout in zip(names, some):
            (layout.extended(timed) if timed else layout).write(made / own)
        runs = run_programs(names, "", {}, machine, folder / f"run{first}", made, len(full.ticks))
        for layout, own in zip(some, runs):
            compare(full, own, name)
            if all(is_as_fast(*ticks) for ticks in zip(own.ticks, full.ticks)):
                return layout, own
    return layout, own


def sizes(program: bytes, scene: Scene) -> dict[str, int]:
    """Returns bytes of the file: code with its tables, the scene without maps, the maps."""
    maps = sum(len(data) + -len(data) % 4 for data in map(ordered, scene.textures))
    inside = len(write(scene, with_palette=False))
    if still.is_still(scene):
        inside = sum(section.size for section in still.sections(scene))
    return {"file": len(program), "code": len(program) - inside, "scene": inside - maps,
            "maps": maps, "without_maps": len(program) - maps}


def describe(layout: Layout) -> list[dict]:
    """Returns the program's parts, the largest first."""
    rows = [{"name": part.section.title, "file": Path(part.section.file).stem,
             "bytes": part.bytes, "of": part.section.size, "timed": part.timed}
            for part in layout.program.parts.values() if not part.section.bss]
    return sorted(rows, key=lambda row: (-row["bytes"], row["name"]))


def print_report(about: dict, out: Path) -> None:
    """Prints a short table."""
    own, full = about["bytes"], about["full_bytes"]
    print(f"{about['scene']} on {about['machine']}: {out / about['scene']}\n")
    print(f"{'bytes':<22} {'full renderer':>14} {'this program':>14}")
    for name, text in (("code", "code and tables"), ("scene", "scene without maps"),
                       ("maps", "maps"), ("file", "together"),
                       ("without_maps", "without maps")):
        print(f"{text:<22} {full[name]:>14,} {own[name]:>14,}")
    ticks = about["ticks"]
    same = sum(map(is_as_fast, ticks["own"], ticks["full"]))
    print(f"{'cycles a frame, mean':<22}", *(
        f"{np.mean(ticks[kind]) * CYCLES_PER_TICK:>14,.0f}" for kind in ("full", "own")))
    print(f"{'frames as fast':<22} {'':>14} {f'{same} of ' + str(len(ticks['own'])):>14}\n")
    inside = [row for row in about["inside"] if row["name"] != "scene_data"]
    names = [f"{row['name']} {row['bytes']}" for row in inside]
    more = f" and {len(names) - ROUTINES} more" if len(names) > ROUTINES else ""
    print("inside: " + ", ".join(names[:ROUTINES]) + more)


def accept(about: dict) -> None:
    """Writes a program's sizes and cycles to the baseline; a table of the page shows them."""
    rows = json.loads(PROGRAMS_BASELINE.read_text()) if PROGRAMS_BASELINE.exists() else {}
    cycles = round(float(np.mean(about["ticks"]["own"])) * CYCLES_PER_TICK)
    rows[about["scene"]] = {key: about["bytes"][key] for key in ("code", "scene", "maps")} | {"cycles": cycles}
    PROGRAMS_BASELINE.write_text(json.dumps(dict(sorted(rows.items())), indent=1) + "\n")


def command(path: Path, out: Path, machine: str, accepted: bool = False) -> int:
    """Makes the program of a scene file in the directory ``out``; raises UserError. ``accepted``: its sizes become
    the baseline's."""
    check_directory(out)
    scene = compile_scene(path, None)
    name = path.stem
    if not re.fullmatch(r"[A-Za-z0-9_-]{1,30}", name):
        raise UserError(f"{path}: its name is not from 1 to 30 letters, digits, _ and -, "
                        "as the program's shall be")
    ready = still.is_still(scene)
    sections = load_sections(scene, ready)
    scene_file = write(scene)
    print(f"{name}: {scene.frames} frames, traced, then drawn by each arrangement that is tried",
          flush=True)
    with emulator.workspace() as folder:
        full, = run_programs(["render"], SCENE_NAME, {SCENE_NAME: scene_file}, machine,
                             folder / "full", PROGRAMS, scene.frames)
        names = ALIASES | {"start": ENTRY, "program_start": still.START if ready else "start"}
        if ready:
            trace = measure(sections, folder / "measured", still.TIMED)
            program = Program(sections, names, trace, ENTRY)
            timed = Program(sections, names | still.TIMED, trace, ENTRY)
        else:
            program, timed = Program(sections, names, measure(sections, folder / "measured"), ENTRY), None
        layout, own = fit(program, renderer_places(sections), full, name, machine, folder, timed)
        layout.write(folder / name)
        if timed:
            check_dumps(full, folder / name, machine, folder / "last")
        made = {file: (folder / file).read_bytes() for file in (name, f"{name}.map")}
    full_bytes = (PROGRAMS / "render").stat().st_size
    inside = sizes(made[name], scene)
    about = {"scene": name, "machine": machine, **provenance.record(), "bytes": inside,
             "full_bytes": {"file": full_bytes + len(scene_file), "code": full_bytes,
                            "scene": len(scene_file) - inside["maps"], "maps": inside["maps"],
                            "without_maps": full_bytes + len(scene_file) - inside["maps"]},
             "memory": {"code": layout.size, "cleared": layout.bss},
             "ticks": {"full": full.ticks, "own": own.ticks}, "inside": describe(layout)}
    out.mkdir(parents=True, exist_ok=True)
    for file, data in made.items():
        (out / file).write_bytes(data)
    (out / "program.json").write_text(json.dumps(about, indent=1) + "\n")
    print_report(about, out)
    if accepted:
        accept(about)
    return 0
