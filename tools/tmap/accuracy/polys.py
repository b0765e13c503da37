"""``tmap polys``: polygons a second, as fatmap2's own test program counts them.

Random triangles with x in 0..320, y in 0..200 and texture coordinates anywhere on the map
(Mats Byggmastar, fatmap2, 1997, section "Polygons per second", Pentium 120).
"""

import functools
from pathlib import Path

import numpy as np

from tmap.base import markdown
from tmap.base.errors import UserError
from tmap.base.outputs import as_json, check_directory
from tmap.base.paths import POLYS_BASELINE
from tmap.corpus import polygon_sets, random_maps
from tmap.guest import guest_frames, provenance
from tmap.guest.emulator import CLOCK_HZ, CYCLES_PER_TICK, MEASURED
from tmap.model import model
from tmap.scene_file.materials import Material
from tmap.scene_file.scene_file import IDENTITY, Object, Scene
from tmap.scene_file.textures import MAPPER_LAYOUT, Texture

#: Enough that their mean area, 4,889 pixels by expectation, has a deviation of 2 %.
TRIANGLES = 2000
M68030 = "a1200-030"
#: Row to (mapper, thousand cycles a polygon on the Pentium 120).
ROWS = {"flat": ("flat", 34.3), "gouraud": ("gouraud", 64.9), "texture": ("affine", 98.8),
        "arbitrary": ("arbitrary", 100.3), "tiled": ("tiled", 78.9)}


@functools.cache
def scene(row: str, count: int) -> Scene:
    """Returns a scene with an empty frame, then a frame with ``count`` triangles of a row."""
    mapper, _ = ROWS[row]
    layout = MAPPER_LAYOUT[mapper]
    material = Material(mapper, "subpixel" if row == "tiled" else "snapped", texture=0 if layout else -1, colour=200)
    objects, vertices = [], []
    for triangle in polygon_sets.random_triangles(count):
        objects.append(Object(0, len(vertices), 3, 0, 1, 1))
        vertices += triangle
    return Scene(polygon_sets.WIDTH, polygon_sets.HEIGHT, 2, 7, random_maps.palette(),
                 [Texture(random_maps.page(), layout)] if layout else [], [material], objects,
                 np.array(vertices), np.array([IDENTITY]))


@functools.cache
def frames(row: str, count: int) -> list[np.ndarray]:
    """Returns the model's frames of a row's scene."""
    return [model.render(scene(row, count), number) for number in (0, 1)]


def measure(machine: str, cache: bool = False, count: int = TRIANGLES) -> list[dict]:
    """A machine's rows, from one boot; frames must be the model's. ``cache``: with a data cache."""
    form = "addx DCACHE" if cache else "addx"
    drawn = guest_frames.draw([(scene(name, count), form) for name in ROWS], machine)
    rows = []
    for (name, (_, pentium)), digests in zip(ROWS.items(), drawn, strict=True):
        guest_frames.require_models(frames(name, count), digests, f"polys: {name} on {machine}",
                                    (scene(name, count), form, machine))
        empty, full = digests["ticks"].astype(int).tolist()
        cycles = (full - empty) * CYCLES_PER_TICK / count
        rows.append({"name": name, "machine": machine + ", data cache" * cache,
                     "polygons_per_second": round(CLOCK_HZ / cycles, 1),
                     "kilocycles_per_polygon": round(cycles / 1000, 2),
                     "pentium_kilocycles": pentium})
    return rows


def table(rows: list[dict]) -> str:
    """Returns a Markdown table: a line a row, two columns a machine."""
    machines = list(dict.fromkeys(r["machine"] for r in rows))
    lines = []
    for name in dict.fromkeys(r["name"] for r in rows):
        some = [r for r in rows if r["name"] == name]
        cells = [cell for r in some for cell in (f"{r['polygons_per_second']:.0f}",
                                                 f"{r['kilocycles_per_polygon']:.1f}")]
        lines.append([name, *cells, str(some[0]["pentium_kilocycles"])])
    titles = [f"{machine}, {what}" for machine in machines for what in ("polygons/s", "kcycles")]
    return markdown.table(["filler", *titles, "Pentium 120, kcycles"], lines) + "\n"


def measure_all(machine: str | None = None) -> dict:
    """Returns the content of polys.json. Rows of a 68030 are only measured if all machines are."""
    rows = [row for m in ([machine] if machine else MEASURED) for row in measure(m)]
    cached = [] if machine else measure(M68030) + measure(M68030, cache=True)
    return provenance.record() | {
        "conditions": f"{TRIANGLES} random triangles, x 0 to 320, y 0 to 200, edges snapped to 1/16 pixel (tiled: sub-pixel), "
                      "plane gradients, sub-texel starts; DMA and interrupts off",
        "rows_68030": cached, "rows": rows}


def command(out: str, machine: str | None, accept: bool) -> int:
    """``tmap polys``: measures, writes polys.json and polys.md, prints the table."""
    folder = Path(out)
    check_directory(folder)
    if accept and machine:
        raise UserError("polys: --accept needs all machines")
    found = measure_all(machine)
    rows, cached = found["rows"], found["rows_68030"]
    folder.mkdir(parents=True, exist_ok=True)
    text = table(rows) + ("\nA 68EC030 at the same clock, without and with its data cache:\n\n"
                          + table(cached) if cached else "")
    (folder / "polys.md").write_text("# Polygons a second\n\n" + found["conditions"] + ".\n\n"
                                     + text)
    (folder / "polys.json").write_text(as_json(found))
    if accept:
        POLYS_BASELINE.write_text(as_json(found))
    print(text)
    print(f"written to {out}: polys.json, polys.md")
    return 0
