"""``tmap accuracy``: what each accuracy setting and mapper is off, and what it costs.

Polygons of a named set are drawn under every combination on the emulated machine; each
frame must be the model's, byte for byte, so the model's u and v are the renderer's. They
are compared with the exact rational ideal (tools/ideal.py) pixel by pixel.
"""

import json
import sys
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import numpy as np

from . import emulator, ideal, model, polygon_sets, provenance
from .errors import UserError
from .model import Settings
from .scene_file import MAPPER_LAYOUT, Material, Object, Scene, Texture, write

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

CYCLES_PER_TICK = 20
IDENTITY = (65536, 0, 0, 65536, 0, 0)
MACHINES = ("a1200", "a1200-fast")
#: Mappers that draw the same picture: a row is on the frontier among its own kind.
KINDS = {"flat": "flat", "gouraud": "gouraud"}
#: Combinations of the mappers other than affine: cheap, usual, exact.
USUAL = (("integer", "plane", "truncated"), ("subpixel", "plane", "subtexel"),
         ("exact", "plane", "subtexel"))


def combinations() -> list[Settings]:
    """Every sensible combination of settings and mapper."""
    made = [Settings(e, g, s, mapper="affine") for e in ("integer", "subpixel", "exact")
            for g in ("scanline", "polygon", "plane") for s in ("truncated", "subtexel")]
    made += [Settings(e, "plane", "subtexel", mapper="flat")
             for e in ("integer", "subpixel", "exact")]
    return made + [Settings(*usual, mapper=mapper) for mapper in MAPPER_LAYOUT
                   if mapper not in ("flat", "affine") for usual in USUAL]


def picture() -> np.ndarray:
    """A 256x256 map of noise."""
    return np.random.default_rng(256).integers(0, 256, (256, 256), dtype=np.uint8)


def set_polygons(name: str, mapper: str) -> list:
    """A set's polygons; where the map does not repeat, their coordinates stay inside."""
    return polygon_sets.polygons(name, 256.0 if mapper == "arbitrary" else None)


def scene_of(name: str, settings: list[Settings]) -> Scene:
    """An empty frame, then one with the whole set for each combination."""
    layouts = [layout for layout in dict.fromkeys(MAPPER_LAYOUT.values()) if layout]
    materials, objects, vertices = [], [], []
    for number, s in enumerate(settings):
        layout = MAPPER_LAYOUT[s.mapper]
        materials.append(Material(s.mapper, s.edges, s.gradients, s.start, colour=200,
                                  texture=layouts.index(layout) if layout else -1))
        for polygon in set_polygons(name, s.mapper):
            objects.append(Object(number, len(vertices), 3, 0, 1, number + 1))
            vertices += polygon
    palette = np.random.default_rng(1).integers(0, 256, (256, 3), dtype=np.uint8)
    return Scene(polygon_sets.WIDTH, polygon_sets.HEIGHT, len(settings) + 1, 7, palette,
                 [Texture(picture(), layout) for layout in layouts], materials, objects,
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
                self.texels(line, y, exact, settings)

    def texels(self, line: model.Line, y: int, exact: ideal.Picture, settings: Settings) -> None:
        """Adds u and v of a line's pixels."""
        found = model.coordinates(line, settings.mapper)
        columns = np.arange(line.left, line.right)
        worst, wrong = np.zeros(len(columns)), np.zeros(len(columns), bool)
        for values, plane in zip(found, exact.planes):
            error = plane.errors(values, columns, y)
            worst = np.maximum(worst, abs(error))
            fraction = (values & 0xFFFF) / 65536 - error  # of the exact value
            wrong |= (fraction < 0) | (fraction >= 1)
        self.worst = max(self.worst, float(worst.max()))
        self.squares += float((worst * worst).sum())
        self.wrong += int(wrong.sum())

    def figures(self) -> dict:
        """The error columns of a row."""
        pixels = max(self.pixels, 1)
        return {"coverage_errors_per_million": round(1e6 * self.coverage / self.ideal_pixels, 2),
                "texel_error_max": round(self.worst, 6),
                "texel_error_rms": round((self.squares / pixels) ** 0.5, 6),
                "wrong_texels_percent": round(100 * self.wrong / pixels, 4)}


def errors(name: str, settings: Settings) -> Errors:
    """What a combination is off on a set."""
    total = Errors()
    for vertices in set_polygons(name, settings.mapper):
        wanted = [(x, y, shade, 0) if settings.mapper == "gouraud" else (x, y, s, t)
                  for x, y, s, t, shade in vertices]
        exact = ideal.Picture(wanted, polygon_sets.WIDTH, polygon_sets.HEIGHT)
        polygon = model.set_up(model.adapt(vertices, settings, 256), polygon_sets.WIDTH,
                               polygon_sets.HEIGHT, settings.mapper != "flat", settings,
                               (256, 256))
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
                             "start": s.start, "mapper": s.mapper, "machine": machine,
                             "cycles_per_pixel": round(each * polygon_sets.COUNT
                                                       / max(total.pixels, 1), 3),
                             "cycles_per_polygon": round(each, 1), **total.figures()})
            if on_step:
                on_step()
    mark_frontier(rows)
    return rows


COLUMNS = ("mapper", "edges", "gradients", "start", "cycles_per_polygon", "cycles_per_pixel",
           "coverage_errors_per_million", "texel_error_max", "texel_error_rms",
           "wrong_texels_percent", "frontier")


def table(rows: list[dict], name: str, machine: str) -> str:
    """Markdown: one set on one machine, cheapest first within a mapper."""
    chosen = [r for r in rows if r["name"] == name and r["machine"] == machine]
    order = list(dict.fromkeys(r["mapper"] for r in chosen))
    chosen.sort(key=lambda r: (order.index(r["mapper"]), r["cycles_per_polygon"]))
    lines = ["| " + " | ".join(c.replace("_", " ") for c in COLUMNS) + " |",
             "|---" * 4 + "|--:" * 6 + "|---|"]
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


LEAST = 1e-6  # texels: what a logarithmic axis shows for 0
MARKS = {"affine": "o", "arbitrary": "s", "tiled": "D", "columns": "^", "generated": "v"}


def plot(rows: list[dict], path: Path) -> None:
    """Error against cycles of the texture mappers, a panel a set, the frontier drawn."""
    machine = rows[-1]["machine"]
    names = list(dict.fromkeys(r["name"] for r in rows))
    figure, panels = plt.subplots(1, len(names), figsize=(4 * len(names), 4.2), sharey=True,
                                  layout="constrained", squeeze=False)
    for axes, name in zip(panels[0], names):
        chosen = [r for r in rows if r["name"] == name and r["machine"] == machine
                  and r["mapper"] in MARKS]
        for mapper, mark in MARKS.items():
            some = [r for r in chosen if r["mapper"] == mapper]
            axes.scatter([r["cycles_per_polygon"] for r in some],
                         [max(r["texel_error_rms"], LEAST) for r in some], marker=mark, s=28,
                         alpha=0.75, label=mapper)
        best = sorted((r for r in chosen if r["frontier"]), key=lambda r: r["cycles_per_polygon"])
        axes.plot([r["cycles_per_polygon"] for r in best],
                  [max(r["texel_error_rms"], LEAST) for r in best], "k--", lw=1, label="frontier")
        axes.set_yscale("log")
        axes.set_title(f"{name}")
        axes.set_xlabel("cycles a polygon")
        axes.grid(alpha=0.3)
    panels[0][0].set_ylabel(f"rms error, texels ({machine})")
    panels[0][0].legend(fontsize=8)
    figure.savefig(path, dpi=110)
    plt.close(figure)


#: What the swimming picture shows side by side.
SWIMMERS = (Settings("integer", "polygon", "truncated", mapper="affine"),
            Settings("subpixel", "plane", "truncated", mapper="affine"),
            Settings("exact", "plane", "subtexel", mapper="affine"))
SWIM_FRAMES = 24
SWIM_SIDE = 64  # pixels of a panel


def swimming_scene() -> Scene:
    """A small triangle that moves an eighth of a pixel a frame, under three settings."""
    texture = np.indices((256, 256)).sum(0) // 8 % 2 * 255  # stripes of 8 texels
    objects, materials, poses = [], [], []
    corners = [(6, 4, 0, 0, 0), (52, 22, 92, 36, 0), (17, 56, 22, 104, 0)]
    vertices = [tuple(c << 16 for c in corner) for corner in corners]
    for number, s in enumerate(SWIMMERS):
        materials.append(Material("affine", s.edges, s.gradients, s.start, texture=0))
        objects.append(Object(number, 0, 3, len(poses), SWIM_FRAMES, 0))
        poses += [(65536, 0, 0, 65536, (number * SWIM_SIDE << 16) + k * 8192, k * 4096)
                  for k in range(SWIM_FRAMES)]
    grey = np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, 1)
    return Scene(3 * SWIM_SIDE, SWIM_SIDE, SWIM_FRAMES, 96, grey,
                 [Texture(texture.astype(np.uint8), "page")], materials, objects,
                 np.array(vertices), np.array(poses))


def write_swimming(out: Path) -> None:
    """swimming.gif and swimming.png: rendered on the emulated machine, five times as large."""
    from PIL import Image

    from .run import render

    scene = swimming_scene()
    frames, _ = render(scene, MACHINES[-1], "addx")
    pictures = []
    for frame in frames:
        big = np.kron(frame, np.ones((5, 5), np.uint8))
        big[:, 5 * SWIM_SIDE::5 * SWIM_SIDE] = 255
        pictures.append(Image.fromarray(big))
    pictures[0].save(out / "swimming.gif", save_all=True, append_images=pictures[1:],
                     duration=120, loop=0)
    strip = np.concatenate([np.asarray(p) for p in pictures[::SWIM_FRAMES // 3][:3]])
    Image.fromarray(strip).save(out / "swimming.png")


def command(out: str, names: list[str] | None, machine: str | None) -> int:
    """``tmap accuracy``: measures, writes the report into ``out``, prints a table."""
    from rich.progress import Progress

    folder = Path(out)
    if folder.exists() and not folder.is_dir():
        raise UserError(f"{out}: is not a directory")
    unknown = set(names or ()) - polygon_sets.SHAPES.keys()
    if unknown:
        raise UserError(f"accuracy: no set is called {unknown.pop()}; "
                        f"there are {', '.join(polygon_sets.SHAPES)}")
    names = names or list(polygon_sets.SHAPES)
    machines = [machine] if machine else list(MACHINES)
    with Progress(transient=True, disable=not sys.stderr.isatty()) as progress:
        task = progress.add_task("accuracy", total=len(names) * len(machines))
        rows = measure(names, machines, combinations(), lambda: progress.advance(task))
    found = provenance.record() | {
        "conditions": f"{polygon_sets.COUNT} triangles a set; cycles with set-up, DMA and "
                      "interrupts off; texel error: the larger of u's and v's.", "rows": rows}
    folder.mkdir(parents=True, exist_ok=True)
    plot(rows, folder / "accuracy.png")
    write_swimming(folder)
    (folder / "accuracy.md").write_text(report(found))
    (folder / "accuracy.json").write_text(json.dumps(found, indent=1) + "\n")
    print(table(rows, names[min(1, len(names) - 1)], machines[-1]))
    print(f"written to {out}: accuracy.json, accuracy.md, accuracy.png, swimming.gif, swimming.png")
    return 0
