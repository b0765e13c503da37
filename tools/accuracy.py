"""``tmap accuracy``: what each accuracy setting and mapper is off, and what it costs.

Polygons of a named set are drawn under every combination on the emulated machine; each
frame must be the model's, byte for byte, so the model's u and v are the renderer's. They
are compared with the exact rational ideal (tools/ideal.py) pixel by pixel.
"""

import json
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from . import emulator, ideal, ideal_perspective, model, polygon_sets, provenance
from .emulator import CYCLES_PER_TICK
from .errors import UserError
from .model import Settings
from .model_shading import LIT
from .paths import ACCURACY_BASELINE
from .scene_file import (IDENTITY, MAPPER_LAYOUT, MAPPERS, ON_PLANE, SETTINGS, Material, Object, Scene,
                         Texture, write)

MACHINES = ("a1200", "a1200-fast")
#: Mappers that draw the same picture: a row is on the frontier among its own kind.
KINDS = {"flat": "flat", "gouraud": "gouraud"}
#: Combinations of the mappers other than affine: cheap, usual, exact.
USUAL = (("integer", "plane", "truncated"), ("subpixel", "plane", "subtexel"),
         ("exact", "plane", "subtexel"))


def usual(mapper: str) -> list[Settings]:
    """USUAL, as far as the mapper has them."""
    return [Settings(*each, mapper=mapper) for each in USUAL
            if mapper not in ON_PLANE or each[1:] == ("plane", "subtexel")]


def combinations() -> list[Settings]:
    """Every sensible combination of settings and mapper."""
    made = [Settings(e, g, s, mapper="affine") for e in ("integer", "subpixel", "exact")
            for g in ("scanline", "polygon", "plane") for s in ("truncated", "subtexel")]
    made += [Settings(e, "plane", "subtexel", mapper="flat")
             for e in ("integer", "subpixel", "exact")]
    return made + [settings for mapper in MAPPERS[1] if mapper not in ("flat", "affine")
                   for settings in usual(mapper)]


def depth_combinations() -> list[Settings]:
    """What a set with depth is drawn with: affine, and every other perspective beside it."""
    return [Settings(edges, perspective=p) for edges in ("subpixel", "exact")
            for p in SETTINGS["perspective"]]


def picture() -> np.ndarray:
    """A 256x256 map of noise."""
    return np.random.default_rng(256).integers(0, 256, (256, 256), dtype=np.uint8)


def set_polygons(name: str, mapper: str) -> list:
    """A set's polygons; where the map does not repeat, their coordinates stay inside."""
    return polygon_sets.polygons(name, 256.0 if mapper == "arbitrary" else None)


def scene_of(name: str, settings: list[Settings]) -> Scene:
    """An empty frame, then one with the whole set for each combination."""
    used = {MAPPER_LAYOUT[s.mapper] for s in settings}  # chip RAM alone has no room for all
    layouts = [layout for layout in dict.fromkeys(MAPPER_LAYOUT.values()) if layout in used and layout]
    lights = [Texture(picture()[:64], "light")] if any(s.mapper in LIT for s in settings) else []
    materials, objects, vertices = [], [], []
    for number, s in enumerate(settings):
        layout = MAPPER_LAYOUT[s.mapper]
        materials.append(Material(s.mapper, s.edges, s.gradients, s.start, perspective=s.perspective,
                                  colour=200, texture=layouts.index(layout) if layout else -1,
                                  light=len(layouts) if s.mapper in LIT else -1))
        for polygon in set_polygons(name, s.mapper):
            objects.append(Object(number, len(vertices), 3, 0, 1, number + 1))
            vertices += polygon
    palette = np.random.default_rng(1).integers(0, 256, (256, 3), dtype=np.uint8)
    return Scene(polygon_sets.WIDTH, polygon_sets.HEIGHT, len(settings) + 1, 7, palette,
                 [*(Texture(picture(), layout) for layout in layouts), *lights], materials, objects,
                 np.array(vertices), np.array([IDENTITY]))


def cycles(scene: Scene, machine: str, what: str, on_frame=None) -> list[float]:
    """Cycles a polygon of each frame but the first, checked against the model."""
    with emulator.workspace() as directory:
        done = emulator.run("render", "input.scene", {"input.scene": write(scene)}, machine,
                            directory, lambda output: on_frame and on_frame(output.count("\n")))
        if done.code:
            raise UserError(f"accuracy: {what}: {emulator.last_words(done.output)}")
        ticks = [int(line.split()[3]) for line in done.output.splitlines()]
        for number in range(scene.frames):
            found = np.fromfile(done.directory / f"frame_{number:03}.chunky", np.uint8)
            expected = model.render(scene, number)
            wrong = np.argwhere(found.reshape(expected.shape) != expected)
            if len(wrong):
                y, x = wrong[0]
                raise UserError(
                    f"accuracy: {what} on {machine}: frame {number} is not the model's: "
                    f"{len(wrong)} pixels, the first at (x {x}, y {y}): expected "
                    f"{expected[y, x]}, found {found.reshape(expected.shape)[y, x]}")
    return [(t - ticks[0]) * CYCLES_PER_TICK / polygon_sets.COUNT for t in ticks[1:]]


@dataclass
class Errors:
    """Sums over the pixels of a set."""

    coverage: int = 0
    ideal_pixels: int = 0
    pixels: int = 0
    worst: float = 0.0
    squares: float = 0.0
    wrong: int = 0

    def add(self, polygon: model.Polygon | None, exact: ideal.Picture, settings: Settings) -> None:
        """Adds a polygon as it was set up, compared with the exact one."""
        lines = {polygon.top + k: line for k, line in enumerate(polygon.lines)} if polygon else {}
        self.ideal_pixels += exact.pixels
        for y in lines.keys() | exact.extents.keys():
            line = lines.get(y)
            left, right = (line.left, max(line.left, line.right)) if line else (0, 0)
            first, end = exact.extents.get(y, (0, 0))
            both = max(0, min(right, end) - max(left, first))
            self.coverage += right - left + end - first - 2 * both
            self.pixels += right - left
            if right > left and settings.mapper != "flat":
                self.texels(polygon.coordinates(line, y, settings.mapper), line.left, y, exact)

    def texels(self, found, left: int, y: int, exact: ideal.Picture) -> None:
        """Adds u and v of a line's pixels from ``left`` on; where the ideal ends with the polygon,
        of those in it."""
        columns = np.arange(left, left + len(found[0]))
        first, end = (left, columns[-1] + 1) if exact.endless else exact.extents.get(y, (0, 0))
        inside = (columns >= first) & (columns < end)
        if inside.any():
            self.compare([c[inside] for c in found], columns[inside], y, exact)

    def compare(self, found, columns: np.ndarray, y: int, exact: ideal.Picture) -> None:
        """Adds u and v that were found at pixels of a line, next to each other."""
        worst, wrong = np.zeros(len(columns)), np.zeros(len(columns), bool)
        for values, plane in zip(found, exact.planes):
            error = plane.errors(values, columns, y)
            worst = np.maximum(worst, abs(error))
            fraction = (values & 0xFFFF) / 65536 - error  # of the exact value
            wrong |= (fraction < 0) | (fraction >= 1)
        self.worst = max(self.worst, float(worst.max()))
        self.squares += float((worst * worst).sum())
        self.wrong += int(wrong.sum())

    @property
    def rms(self) -> float:
        """Root of the mean square over all pixels, of the larger of u's and v's errors, texels."""
        return (self.squares / max(self.pixels, 1)) ** 0.5

    def figures(self) -> dict:
        """The error columns of a row."""
        pixels = max(self.pixels, 1)
        return {"coverage_errors_per_million": round(1e6 * self.coverage / self.ideal_pixels, 2),
                "texel_error_max": round(self.worst, 6),
                "texel_error_rms": round(self.rms, 6),
                "wrong_texels_percent": round(100 * self.wrong / pixels, 4)}


def errors(name: str, settings: Settings) -> Errors:
    """What a combination is off on a set."""
    total = Errors()
    size = polygon_sets.WIDTH, polygon_sets.HEIGHT
    for vertices in set_polygons(name, settings.mapper):
        if name in polygon_sets.DEPTHS:
            exact = ideal_perspective.Picture([(*v[:4], v[5]) for v in vertices], *size)
        else:
            exact = ideal.Picture([(*v[:2], v[4], 0) if settings.mapper == "gouraud" else v[:4]
                                   for v in vertices], *size)
        polygon = model.set_up(model.adapt(vertices, settings, 256), *size,
                               settings.mapper != "flat", settings, (256, 256))
        total.add(polygon, exact, settings)
    return total


def mark_frontier(rows: list[dict]) -> None:
    """Sets ``frontier``: nothing of its kind is as cheap and as exact, and better in one."""
    measures = ("cycles_per_polygon", "coverage_errors_per_million", "texel_error_rms")

    def beats(a: dict, b: dict) -> bool:
        pairs = [(a[m], b[m]) for m in measures]
        return all(x <= y for x, y in pairs) and any(x < y for x, y in pairs)

    def kind(row: dict) -> tuple:
        return row["name"], row["machine"], KINDS.get(row["mapper"], "texture")

    for row in rows:
        row["frontier"] = not any(kind(o) == kind(row) and beats(o, row) for o in rows)


def measure(names: list[str], machines: list[str], settings: list[Settings],
            on_step=None) -> list[dict]:
    """The rows of accuracy.json."""
    rows = []
    for name in names:
        scene, found = scene_of(name, settings), [errors(name, s) for s in settings]
        for machine in machines:
            spent = cycles(scene, machine, f"set {name}")
            for s, total, each in zip(settings, found, spent):
                rows.append({"name": name, "edges": s.edges, "gradients": s.gradients,
                             "start": s.start, "perspective": s.perspective,
                             "mapper": s.mapper, "machine": machine,
                             "cycles_per_pixel": round(each * polygon_sets.COUNT
                                                       / max(total.pixels, 1), 3),
                             "cycles_per_polygon": round(each, 1), **total.figures()})
            if on_step:
                on_step()
    mark_frontier(rows)
    return rows


COLUMNS = ("mapper", "edges", "gradients", "start", "perspective", "cycles_per_polygon", "cycles_per_pixel",
           "coverage_errors_per_million", "texel_error_max", "texel_error_rms",
           "wrong_texels_percent", "frontier")


def table(rows: list[dict], name: str, machine: str) -> str:
    """Markdown: one set on one machine, cheapest first within a mapper."""
    chosen = [r for r in rows if r["name"] == name and r["machine"] == machine]
    order = list(dict.fromkeys(r["mapper"] for r in chosen))
    chosen.sort(key=lambda r: (order.index(r["mapper"]), r["cycles_per_polygon"]))
    lines = ["| " + " | ".join(c.replace("_", " ") for c in COLUMNS) + " |",
             "|---" * 5 + "|--:" * 6 + "|---|"]
    for row in chosen:
        cells = [row[c] for c in COLUMNS[:-1]] + ["yes" if row["frontier"] else ""]
        lines.append("| " + " | ".join(f"{c:,}" if isinstance(c, float) else str(c)
                                       for c in cells) + " |")
    return "\n".join(lines) + "\n"


def report(found: dict) -> str:
    """accuracy.md."""
    text = ("# What accuracy costs\n\n" + found["conditions"] + f" {found['emulator']}, "
            f"{found['compiler']}.\n")
    rows = found["rows"]
    for name in dict.fromkeys(r["name"] for r in rows):
        for machine in dict.fromkeys(r["machine"] for r in rows):
            text += f"\n## {name}, {machine}\n\n" + table(rows, name, machine)
    return text


def as_json(found: dict) -> str:
    """JSON with a row a line."""
    head = json.dumps({k: v for k, v in found.items() if k != "rows"}, indent=1)
    rows = ",\n  ".join(map(json.dumps, found["rows"]))
    return f'{head[:-2]},\n "rows": [\n  {rows}\n ]\n}}\n'


#: The sets whose rows are kept beside the bench's baseline, for README and tests.
BASELINE_SETS = "medium", "depth"


#: What --set takes besides the sets: the turning face, the scenes, texture engines' modes (those
#: of tools.engines), the page of hard cases.
METHODS, SCENES, HARD, ENGINES = "methods", "scenes", "hard", ("tx", "tmu")


def write_sets(folder: Path, names: list[str], machines: list[str], accept: bool, on_step) -> str:
    """Measures the sets, writes their report; returns the table to print."""
    from . import accuracy_pictures as pictures
    from . import perspective_curves

    flat = [name for name in names if name not in polygon_sets.DEPTHS]
    rows = measure(flat, machines, combinations(), on_step) + measure(
        [name for name in names if name not in flat], machines, depth_combinations(), on_step)
    found = provenance.record() | {
        "conditions": f"{polygon_sets.COUNT} triangles a set; cycles with set-up, DMA and "
                      "interrupts off; texel error: the larger of u's and v's.", "rows": rows}
    folder.mkdir(parents=True, exist_ok=True)
    pictures.plot(rows, folder / "accuracy.png")
    if flat != names:
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
    """Measures and writes the page of hard cases; returns what exceeds a bound."""
    from . import hard_report

    about = provenance.record()
    conditions = (f"Cycles on {machine}, set-up included, DMA and interrupts off; "
                  f"{about['emulator']}, {about['compiler']}, commit {about['commit']}.")
    rows = hard_report.write(folder, machine, conditions, on_part)
    return [f"{row.case}, {row.mapper}, {row.edges}, {row.gradients}, {row.start}, {row.clip}, "
            f"{row.perspective}: {row.complaint}" for row in rows if row.complaint]


def write_other(folder: Path, name: str, machine: str, progress) -> str:
    """What a set that is no set of polygons comes to: methods, scenes, texture engines' modes."""
    folder.mkdir(parents=True, exist_ok=True)
    if name in ENGINES:
        from . import engines

        engine = engines.ENGINES[name]
        progress.add_task(engine.title, total=None)
        return engines.write(folder, engine, machine)
    from . import methods, showcase

    tool, steps = {METHODS: (methods, methods.METHODS), SCENES: (showcase, showcase.NAMES)}[name]
    task = progress.add_task(name, total=len(steps))
    return tool.write(folder, machine, lambda: progress.advance(task))


def command(out: str, names: list[str] | None, machine: str | None, accept: bool) -> int:
    """``tmap accuracy``: measures, writes the report into ``out``, prints a table. 1: a hard
    case exceeds its bound."""
    from rich.progress import Progress

    folder = Path(out)
    if accept and (machine or names):
        raise UserError("accuracy: --accept needs all machines and all sets")
    if folder.exists() and not folder.is_dir():
        raise UserError(f"{out}: is not a directory")
    known = [*polygon_sets.SHAPES, *polygon_sets.DEPTHS]
    others = [METHODS, SCENES, *ENGINES]
    unknown = set(names or ()) - {*known, *others, HARD}
    if unknown:
        raise UserError(f"accuracy: no set is called {unknown.pop()}; "
                        f"there are {', '.join([*known, *others])} and {HARD}")
    names = names or [*known, *others, HARD]
    sets = [name for name in names if name in known]
    machines, text, excess = [machine] if machine else list(MACHINES), "", []
    with Progress(transient=True, disable=not sys.stderr.isatty()) as progress:
        if sets:
            task = progress.add_task("accuracy", total=len(sets) * len(machines))
            text = write_sets(folder, sets, machines, accept, lambda: progress.advance(task))
        for name in others:
            if name in names:
                made = write_other(folder, name, machines[-1], progress)
                text += f"\n{made}\n" if text else f"{made}\n"
        if HARD in names:
            task = progress.add_task("hard cases", total=None)
            excess = write_hard_cases(folder / HARD, machines[-1], lambda done, total:
                                      progress.update(task, completed=done, total=total))
    deep = bool(polygon_sets.DEPTHS.keys() & sets)
    written = (["accuracy.json", "accuracy.md", "accuracy.png", "mappers.png", "swimming.gif",
                "swimming.png"] * bool(sets) + ["pieces.png"] * deep
               + ["methods.md", "methods.png", "methods.gif"] * (METHODS in names)
               + ["scenes.md and an animation of each"] * (SCENES in names)
               + [f"{name}.md" for name in ENGINES if name in names]
               + [f"{HARD}/index.html"] * (HARD in names))
    print(text + f"written to {out}: {', '.join(written)}")
    for line in excess:
        print(f"exceeds its bound: {line}")
    return 1 if excess else 0
