"""``tmap accuracy``: errors and cycles of each accuracy setting and mapper.

The emulated machine draws the polygons of a named set under every combination. Each frame must be
the model's, byte for byte, so the model's u and v are the renderer's. They are compared with the
exact rational ideal (tools/tmap/ideal/ideal.py) pixel by pixel.
"""

from pathlib import Path

import numpy as np

from tmap.accuracy.errors import Errors
from tmap.accuracy.rows import mark_frontier, report, table
from tmap.base.errors import UserError
from tmap.base.outputs import as_json, bars, check_directory
from tmap.base.paths import ACCURACY_BASELINE
from tmap.corpus import polygon_sets, random_maps
from tmap.corpus.settings_grid import combinations, depth_combinations, size_combinations
from tmap.guest import guest_frames, provenance
from tmap.guest.emulator import CYCLES_PER_TICK, MEASURED
from tmap.ideal import ideal, perspective
from tmap.model import model
from tmap.model.model import Settings
from tmap.scene_file.scene_file import IDENTITY, MAPPER_LAYOUT, Material, Object, Scene, Texture
from tmap.setup.shading import LIT

#: Sets whose rows are kept in the committed baseline, for README and tests.
BASELINE_SETS = "medium", *polygon_sets.SIZES, "depth"
#: Settings in a row.
ASKED = "edges", "gradients", "start", "perspective", "mapper"
#: Names that --set takes in addition to the sets: the turning face, the scenes, the orders of meshes'
#: faces, larger pixels, texture engines' modes (those of tmap.accuracy.engines), the page of hard cases.
METHODS, SCENES, ORDERS, RESOLUTIONS, HARD = "methods", "scenes", "orders", "resolutions", "hard"
ENGINES = "n64", "glide"
#: What is written for them, and for the sets.
FILES = {METHODS: "methods.md, methods.png, methods.gif",
         SCENES: "scenes.md and an animation of each", ORDERS: "orders.md",
         RESOLUTIONS: "resolutions.md and a picture of each scene",
         **{name: f"{name}.md" for name in ENGINES}, HARD: f"{HARD}/index.html"}
SET_FILES = ("accuracy.json", "accuracy.md", "accuracy.png", "mappers.png", "swimming.gif",
             "swimming.png")


def set_polygons(name: str, mapper: str) -> list:
    """Returns a set's polygons. Where the map does not repeat, their coordinates stay inside it."""
    return polygon_sets.polygons(name, 256.0 if mapper == "arbitrary" else None)


def scene_of(name: str, settings: list[Settings]) -> Scene:
    """Returns a scene with an empty frame, then a frame with the whole set for each combination."""
    used = {MAPPER_LAYOUT[s.mapper] for s in settings}  # chip RAM alone has no room for all layouts
    layouts = [layout for layout in dict.fromkeys(MAPPER_LAYOUT.values()) if layout in used and layout]
    textures = [Texture(random_maps.page(), layout) for layout in layouts]
    if any(s.mapper in LIT for s in settings):
        textures.append(Texture(random_maps.page()[:64], "light"))
    materials, objects, vertices = [], [], []
    for number, s in enumerate(settings):
        layout = MAPPER_LAYOUT[s.mapper]
        materials.append(Material(**vars(s), texture=layouts.index(layout) if layout else -1,
                                  colour=200, light=len(layouts) if s.mapper in LIT else -1))
        for polygon in set_polygons(name, s.mapper):
            objects.append(Object(number, len(vertices), 3, 0, 1, number + 1))
            vertices += polygon
    return Scene(polygon_sets.WIDTH, polygon_sets.HEIGHT, len(settings) + 1, 7, random_maps.palette(),
                 textures, materials, objects, np.array(vertices), np.array([IDENTITY]))


def cycles(scene: Scene, machine: str, what: str) -> list[float]:
    """Returns the cycles a polygon of each frame after the first. Every frame is checked against
    the model. ``what``: the scene, for messages."""
    digests, = guest_frames.draw([(scene, "addx")], machine)
    guest_frames.require_models((model.render(scene, number) for number in range(scene.frames)),
                                digests, f"accuracy: {what} on {machine}", (scene, "addx", machine))
    empty, *spent = digests["ticks"].astype(int).tolist()
    return [(ticks - empty) * CYCLES_PER_TICK / polygon_sets.COUNT for ticks in spent]


def errors(name: str, settings: Settings) -> Errors:
    """Returns the errors of a combination on a set."""
    total = Errors()
    size = polygon_sets.WIDTH, polygon_sets.HEIGHT
    for vertices in set_polygons(name, settings.mapper):
        if name in polygon_sets.DEPTHS:
            exact = perspective.Picture([(*v[:4], v[5]) for v in vertices], *size)
        else:
            exact = ideal.Picture([(*v[:2], v[4], 0) if settings.mapper == "gouraud" else v[:4]
                                   for v in vertices], *size)
        polygon = model.set_up(model.adapt(vertices, settings, 256), *size,
                               settings.mapper != "flat", settings, (256, 256))
        total.add(polygon, exact, settings)
    return total


def measure(names: list[str], machines: list[str], settings: list[Settings],
            on_step=None) -> list[dict]:
    """Returns the rows of accuracy.json."""
    rows = []
    for name in names:
        scene, found = scene_of(name, settings), [errors(name, s) for s in settings]
        for machine in machines:
            spent = cycles(scene, machine, f"set {name}")
            for s, total, each in zip(settings, found, spent):
                pixel = each * polygon_sets.COUNT / max(total.pixels, 1)
                rows.append({"name": name, **{kind: getattr(s, kind) for kind in ASKED},
                             "machine": machine, "cycles_per_pixel": round(pixel, 3),
                             "cycles_per_polygon": round(each, 1), **total.figures()})
            if on_step:
                on_step()
    mark_frontier(rows)
    return rows


def measure_all(names: list[str], machines: list[str], on_step=None) -> list[dict]:
    """Returns the rows of sets, each with its settings, in the order of ``polygon_sets.every``."""
    kinds = ((polygon_sets.SHAPES, combinations()), (polygon_sets.SIZES, size_combinations()),
             (polygon_sets.DEPTHS, depth_combinations()))
    return [row for sets, settings in kinds
            for row in measure([name for name in names if name in sets], machines, settings, on_step)]


def write_sets(folder: Path, names: list[str], machines: list[str], accept: bool, on_step) -> str:
    """Measures the sets and writes their report; returns the table to print."""
    from tmap.accuracy import perspective_curves, pictures

    rows = measure_all(names, machines, on_step)
    found = provenance.record() | {
        "conditions": f"{polygon_sets.COUNT} triangles a set; cycles with set-up, DMA and "
                      "interrupts off; texel error: the larger of u's and v's.", "rows": rows}
    folder.mkdir(parents=True, exist_ok=True)
    pictures.plot([r for r in rows if r["name"] not in polygon_sets.SIZES], folder / "accuracy.png")
    if polygon_sets.DEPTHS.keys() & set(names):
        perspective_curves.plot(folder / "pieces.png")
    pictures.write_swimming(folder)
    pictures.write_mappers(folder)
    (folder / "accuracy.md").write_text(report(found))
    (folder / "accuracy.json").write_text(as_json(found))
    if accept:
        kept = [r for r in rows if r["name"] in BASELINE_SETS]
        ACCURACY_BASELINE.write_text(as_json(found | {"rows": kept}))
    return table(rows, names[min(1, len(names) - 1)], machines[-1])


def write_hard_cases(folder: Path, machine: str, on_part) -> list[str]:
    """Measures the hard cases and writes their page; returns a line for each excess of a bound."""
    from tmap.accuracy import hard_report

    about = provenance.record()
    conditions = (f"Cycles on {machine}, set-up included, DMA and interrupts off; "
                  f"{about['emulator']}, {about['compiler']}, commit {about['commit']}.")
    rows = hard_report.write(folder, machine, conditions, on_part)
    return [f"{row.case}, {row.mapper}, {row.edges}, {row.gradients}, {row.start}, {row.clip}, "
            f"{row.perspective}: {row.complaint}" for row in rows if row.complaint]


def write_other(folder: Path, name: str, machine: str, progress) -> str:
    """Runs a set not made of polygons (methods, scenes, orders, pixels, engines' modes); returns its table."""
    folder.mkdir(parents=True, exist_ok=True)
    if name in ENGINES:
        from tmap.accuracy import engines

        engine = engines.ENGINES[name]
        progress.add_task(engine.title, total=None)
        return engines.write(folder, engine, machine)
    from tmap.accuracy import italian_methods, orders, resolutions, scene_errors

    tool, steps = {METHODS: (italian_methods, italian_methods.METHODS),
                   SCENES: (scene_errors, scene_errors.NAMES),
                   ORDERS: (orders, orders.ROWS), RESOLUTIONS: (resolutions, resolutions.ROWS)}[name]
    task = progress.add_task(name, total=len(steps))
    return tool.write(folder, machine, lambda: progress.advance(task))


def command(folder: Path, names: list[str] | None, machine: str | None, accept: bool) -> int:
    """``tmap accuracy``: measures, writes the report. Returns 1 if a bound is exceeded."""
    if accept and (machine or names):
        raise UserError("accuracy: --accept needs all machines and all sets")
    check_directory(folder)
    every = [*polygon_sets.every(), *FILES]
    if unknown := [name for name in names or () if name not in every]:
        raise UserError(f"accuracy: no set is called {unknown[0]}; "
                        f"there are {', '.join(every[:-1])} and {every[-1]}")
    names = names or every
    sets = [name for name in names if name in polygon_sets.every()]
    machines, made, excess = [machine] if machine else list(MEASURED), [], []
    with bars() as progress:
        if sets:
            task = progress.add_task("accuracy", total=len(sets) * len(machines))
            made.append(write_sets(folder, sets, machines, accept, lambda: progress.advance(task)))
        for name in (METHODS, SCENES, ORDERS, RESOLUTIONS, *ENGINES):
            if name in names:
                made.append(write_other(folder, name, machines[-1], progress) + "\n")
        if HARD in names:
            task = progress.add_task("hard cases", total=None)
            excess = write_hard_cases(folder / HARD, machines[-1], lambda done, total:
                                      progress.update(task, completed=done, total=total))
    files = [*SET_FILES] if sets else []
    if polygon_sets.DEPTHS.keys() & set(sets):
        files.append("pieces.png")
    files += [words for name, words in FILES.items() if name in names]
    print("\n".join(made) + f"written to {folder}: {', '.join(files)}")
    for line in excess:
        print(f"exceeds its bound: {line}")
    return 1 if excess else 0
