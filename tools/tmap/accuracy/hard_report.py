"""The hard-case page of ``tmap accuracy``: every named case under each of its settings, with its
worst error, the derived bound and its cycles; and pictures of the ideal, ours and the difference.

The guest draws every case; its frames must be the model's. The model draws the pictures, with a map
that is easy to read by eye.
"""

from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path

import jinja2
import numpy as np
from PIL import Image

from tmap.accuracy import hard_mesh_report
from tmap.base.errors import UserError
from tmap.base.outputs import as_json
from tmap.corpus import hard_cases, hard_meshes
from tmap.corpus.hard_case import called
from tmap.corpus.hard_cases import HEIGHT, WIDTH, Case, Drawing
from tmap.guest import guest_frames
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.ideal import bounds, ideal, perspective as ideal_perspective
from tmap.model import model
from tmap.run.diff import MARK
from tmap.run.polygon_report import explain
from tmap.scene_file.scene_file import SETTINGS
from tmap.setup.texturing import Settings

#: Drawings in one scene, which has one more frame, an empty one.
PART = 999
#: Mappers for the picture of a case: the first of these that the case lists.
SHOWN = ("affine", "arbitrary", "columns", "gouraud", "flat")
SCALE = 2  # picture pixels per frame pixel
COLUMNS = ("mapper", "edges", "gradients", "start", "clip", "perspective", "cycles",
           "coverage_errors", "texel_error", "texel_bound", "worst_ratio")


@dataclass
class Row:
    """One case under one setting. Errors in texels (shades), or None where no ideal is defined."""

    case: str
    mapper: str
    edges: str
    gradients: str
    start: str
    clip: str
    perspective: str
    tolerance: int
    cycles: int
    pixels: int
    coverage_errors: int | None = None
    texel_error: float | None = None
    texel_bound: float | None = None  # at the same pixel
    worst_ratio: float | None = None  # the largest error / bound of a pixel
    complaint: str = ""


def row_of(case: Case | hard_meshes.MeshCase, settings: Settings, cycles: int,
           verdict: bounds.Verdict, has_ideal: bool = True) -> Row:
    """Returns a case's row; ``has_ideal``: False if its pixels alone are known."""
    row = Row(case.name, **vars(settings), cycles=cycles, pixels=verdict.pixels,
              complaint=verdict.complaint)
    if has_ideal and not (isinstance(case, hard_meshes.MeshCase) and settings.clip != "scissor"):
        row.coverage_errors = verdict.coverage_errors
    if verdict.texel_bound:
        row.texel_error, row.texel_bound = verdict.texel_error, verdict.texel_bound
        row.worst_ratio = verdict.texel_ratio
    return row


def judged(case: Case, settings: Settings, cycles: int) -> Row:
    """Returns a case's row, checked against its bounds."""
    size = hard_cases.map_size(case, settings.mapper)
    parts = [model.adapt(part, settings, max(size))
             for part in model.parts(case.vertices, settings, (WIDTH, HEIGHT), max(size))]
    has_ideal = all(bounds.has_ideal(part, settings) for part in parts)
    if has_ideal:
        verdict = bounds.judge(case.vertices, settings, WIDTH, HEIGHT, size)
    else:
        made = [model.set_up(part, WIDTH, HEIGHT, settings.mapper != "flat", settings, size)
                for part in parts]
        verdict = bounds.Verdict(sum(each.pixels for each in made if each))
    return row_of(case, settings, cycles, verdict, has_ideal)


def cycles(drawings: list[Drawing], machine: str, form: str = "addx", on_part=None,
           timed: bool = True) -> list[int]:
    """Returns the cycles of each drawing on the guest. Refuses a frame that differs from the
    model's. ``on_part`` is called with the number drawn and the number of all; ``timed``: as in
    guest_frames.draw."""
    spent: list[int] = []
    for first in range(0, len(drawings), PART):
        part = drawings[first:first + PART]
        scene = hard_cases.scene(part)
        scene.frames += 1
        digests, = guest_frames.draw([(scene, form)], machine, timed=timed)
        wrong = [number for number, digest in enumerate(digests[:-1])
                 if not guest_frames.is_models(model.render(scene, number), digest)]
        if wrong:
            alone = hard_cases.scene([part[wrong[0]]])
            raise UserError(f"{len(wrong)} drawings are not the model's\n" + explain(
                alone, 0, guest_frames.frame_of(alone, form, machine), called(*part[wrong[0]]),
                f"scripts/tmap accuracy --set hard --machine {machine}"))
        empty = int(digests[-1]["ticks"])
        spent += [(int(digest["ticks"]) - empty) * CYCLES_PER_TICK for digest in digests[:-1]]
        if on_part:
            on_part(len(spent), len(drawings))
    return spent


def measure(drawings: list[Drawing], machine: str, on_part=None, timed: bool = True) -> list[Row]:
    """Returns a row for each drawing, checked against its bounds; ``timed``: as in
    guest_frames.draw."""
    return [judged(case, settings, each) for (case, settings), each
            in zip(drawings, cycles(drawings, machine, on_part=on_part, timed=timed))]


def measure_meshes(drawings: list[hard_mesh_report.Drawing], machine: str) -> list[Row]:
    """A row for each drawing of a mesh, over all its faces. A case's drawings come together."""
    spent = iter(hard_mesh_report.cycles(drawings, machine))
    return [row_of(case, settings, next(spent), found)
            for case, ways in hard_mesh_report.grouped(drawings).items()
            for settings, found in zip(ways, hard_mesh_report.judge(case, ways))]


def readable_map(width: int, height: int) -> np.ndarray:
    """Palette indices: squares of 8 texels, two colours, 16 levels, brighter right and down."""
    v, u = np.mgrid[:height, :width]
    level = (u * 8 // width + v * 8 // height).clip(0, 15)
    return (16 + (u // 8 + v // 8) % 2 * 16 + level).astype(np.uint8)


def palette() -> np.ndarray:
    """Returns uint8 (256, 3): shades as greys; entries 16 to 47 are the readable map's colours."""
    colours = np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, axis=1)
    level = np.arange(16)[:, None]
    colours[16:32] = 40 + level * np.array([12, 8, 4])
    colours[32:48] = 40 + level * np.array([4, 9, 13])
    return colours


def exact_picture(vertices, settings: Settings, texels: np.ndarray | None) -> np.ndarray | None:
    """Returns int16 (HEIGHT, WIDTH): the exact ideal's pixel values, -1 outside; None if there is
    no ideal. ``vertices``: (x, y, u, v, w)."""
    if not bounds.has_ideal(vertices, settings):
        return None
    frame = np.full((HEIGHT, WIDTH), -1, np.int16)
    is_flat = settings.perspective == "none"
    exact = (ideal if is_flat else ideal_perspective).Picture(vertices, WIDTH, HEIGHT)
    if is_flat and not exact.planes[0].d:
        return frame
    for y, (left, right) in exact.extents.items():
        u, v = (plane.texels(left, right, y) for plane in exact.planes)
        frame[y, left:right] = (200 if settings.mapper == "flat" else [value & 255 for value in u]
                                if settings.mapper == "gouraud" else
                                [texels[b % texels.shape[0], a % texels.shape[1]]
                                 for a, b in zip(u, v)])
    return frame


def shown(case: Case) -> Settings:
    """Returns the settings for a case's picture: exact edges, plane gradients, sub-texel starts
    and, if it has depth, the finest perspective."""
    mapper = next((m for m in SHOWN if m in case.mappers), case.mappers[0])
    return Settings("exact", perspective=SETTINGS["perspective"][-1] if case.depth else "none",
                    mapper=mapper)


def both(case: Case) -> tuple[np.ndarray | None, np.ndarray]:
    """Returns the exact ideal and ours, int16 (HEIGHT, WIDTH), -1 outside the polygon."""
    settings = shown(case)
    size = hard_cases.map_size(case, settings.mapper)
    texels = readable_map(*size)
    ours, exact = np.full((HEIGHT, WIDTH), -1, np.int16), []
    for part in model.parts(case.vertices, settings, (WIDTH, HEIGHT), max(size)):
        adapted = model.adapt(part, settings, max(size))
        made = model.set_up(adapted, WIDTH, HEIGHT, settings.mapper != "flat", settings, size)
        if made:
            model.draw(ours, made, texels, 200)
        exact.append(exact_picture(adapted, settings, texels))
    if any(picture is None for picture in exact):
        return None, ours
    return np.max(exact, axis=0), ours  # triangles share no pixel


def picture(case: Case | hard_meshes.MeshCase) -> np.ndarray:
    """Returns uint8 RGB: the exact ideal, ours and the difference, side by side."""
    if isinstance(case, Case):
        exact, ours = both(case)
    else:
        exact, ours = hard_mesh_report.both(case, readable_map(256, 256))
    colours, ground = palette(), np.array([24, 28, 48], np.uint8)
    panels = [np.where((values < 0)[..., None], ground, colours[values.clip(0)])
              for values in (ours if exact is None else exact, ours)]
    marked = (panels[1] // 3).astype(np.uint8)
    if exact is not None:
        marked[exact != ours] = MARK
    gap = np.full((HEIGHT, 4, 3), 255, np.uint8)
    joined = np.concatenate([panels[0], gap, panels[1], gap, marked], axis=1)
    return joined.repeat(SCALE, axis=0).repeat(SCALE, axis=1)


def page(rows: list[Row], conditions: str) -> str:
    """Returns the text of index.html; the template is hard.html in this folder."""
    by_case: dict[str, list[Row]] = {case.name: [] for case in every_case()}
    for row in rows:
        by_case[row.case].append(row)
    template = jinja2.Template((Path(__file__).parent / "hard.html").read_text(), autoescape=True,
                               undefined=jinja2.StrictUndefined, trim_blocks=True,
                               lstrip_blocks=True)
    return template.render(conditions=conditions, rows=rows, columns=COLUMNS, sections=[
        (case, by_case[case.name]) for case in every_case()],
        excess=sum(bool(row.complaint) for row in rows))


def every_case() -> list[Case | hard_meshes.MeshCase]:
    """Returns all cases: polygons, then meshes."""
    return [*hard_cases.cases(), *hard_meshes.cases()]


def write(folder: Path, machine: str, conditions: str,
          on_part: Callable[[int, int], None] | None = None) -> list[Row]:
    """Measures and writes the page, its pictures and hard.json into ``folder``."""
    rows = measure([(case, s) for case in hard_cases.cases() for s in hard_cases.combinations(case)],
                   machine, on_part)
    rows += measure_meshes([(case, s) for case in hard_meshes.cases()
                            for s in hard_mesh_report.combinations(case)], machine)
    folder.mkdir(parents=True, exist_ok=True)
    for case in every_case():
        Image.fromarray(picture(case)).save(folder / f"{case.name}.png")
    (folder / "index.html").write_text(page(rows, conditions))
    found = {"conditions": conditions, "rows": list(map(asdict, rows))}
    (folder / "hard.json").write_text(as_json(found))
    return rows
