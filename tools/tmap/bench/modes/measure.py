"""Bench rows of texture engines' modes (tmap.bench.modes.modes): cycles a pixel of a polygon, set-up
included, beside the same drawn pixel by pixel in plain C; and what the first frame costs more,
which makes tables and decodes texels.
"""

import tempfile
from functools import cache
from pathlib import Path

import numpy as np
from PIL import Image

from tmap.bench.modes import glide, modes, n64
from tmap.bench.modes.modes import Mode
from tmap.guest import guest_frames
from tmap.guest.conditions import CONDITIONS
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.model import model
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene

WIDTH, HEIGHT = 96, 80
EMPTY, FIRST, AGAIN = range(3)  # frames: nothing, the first that is drawn, the one that counts
ROW, FIRST_ROW, PLAIN_END = "mode_", "first_", "_c"
PLAIN_MACHINE = "a1200-fast"
EVERY: dict[str, Mode] = n64.EVERY | glide.EVERY | glide.SMALL

Vertices = list[tuple[int, ...]]


def shrunk(mode: Mode, shift: int, most: int) -> Vertices:
    """A mode's polygon 2^shift times as small, its first ``most`` corners, gradients unchanged."""
    found = []
    for first in range(0, len(mode.vertices), mode.corners):
        corners = mode.vertices[first:first + mode.corners][:most]
        found += [tuple(from_ + (to - from_ >> shift) for from_, to in zip(corners[0], corner))
                  for corner in corners]
    return found


def drawn(mode: Mode, plain: bool) -> tuple[Vertices, Vertices]:
    """The polygons of the frames FIRST and AGAIN. Where they are drawn pixel by pixel in C, the
    first is a triangle of a few pixels, which makes the same tables and spares thousands of cycles
    a pixel."""
    if not plain:
        return mode.vertices, mode.vertices
    return shrunk(mode, 4, 3), shrunk(mode, mode.PLAIN_SHIFT, mode.corners)


@cache
def scene_of(mode: Mode, kind: str = "noise", plain: bool = False) -> Scene:
    """An empty frame, then the mode's polygon in two; ``kind``: of KINDS; ``plain``: see drawn."""
    frames = AGAIN + 1
    with tempfile.TemporaryDirectory() as folder:
        for name, (side, seed, sheer) in modes.PICTURES.items():
            Image.fromarray(modes.picture(kind, seed, side, sheer)).save(Path(folder, name))
        tables = mode.tables({"materials": {"it": {mode.TABLE: mode.material()}}}, Path(folder),
                             frames, f"mode {mode.name}: ")
    first, again = drawn(mode, plain)
    return Scene(WIDTH, HEIGHT, frames, 7, np.zeros((256, 3), np.uint8), [],
                 [Material(mode.MAPPER, unit=0)],
                 [Object(0, 0, len(first), 0, 1, FIRST),
                  Object(0, len(first), len(again), 0, 1, AGAIN)],
                 np.array(first + again), np.array([IDENTITY]), mode.pixels, **tables)


@cache
def shown(mode: Mode, plain: bool = False) -> tuple[list[np.ndarray], int]:
    """The model's picture of each frame, and how many pixels the polygon of the last has."""
    scene, (first, again) = scene_of(mode, plain=plain), drawn(mode, plain)
    frames = [model.render(scene, EMPTY), model.render(scene, FIRST)]
    frames.append(frames[FIRST] if first == again else model.render(scene, AGAIN))
    made = model.set_up([v[:4] for v in again[:mode.corners]], WIDTH, HEIGHT, False)
    return frames, made.pixels


def rows_of(mode: Mode, end: str, machine: str, ticks: list[int], pixels: int) -> dict[str, dict]:
    """The rows of a mode by kind: what the frames FIRST and AGAIN took. ``end``: PLAIN_END, or ""."""
    row = {"name": f"{ROW}{mode.name}{end}", "machine": machine, "length": pixels}
    found = {"modes": row | {
        "cycles_per_pixel": round((ticks[AGAIN] - ticks[EMPTY]) * CYCLES_PER_TICK / pixels, 3),
        "one_tick": round(CYCLES_PER_TICK / pixels, 5)}}
    if not end:
        found["first_frames"] = row | {
            "name": f"{FIRST_ROW}{mode.name}", "one_tick": CYCLES_PER_TICK,
            "cycles_more": (ticks[FIRST] - ticks[AGAIN]) * CYCLES_PER_TICK}
    return found


def measure(machine: str, names: list[str], plain: bool = True) -> dict[str, list[dict]]:
    """Rows "modes" and "first_frames" of modes, all in one boot; ``names``: of modes; ``plain``:
    with those in plain C, on PLAIN_MACHINE."""
    wanted = [EVERY[name] for name in names]
    found: dict[str, list[dict]] = {"modes": [], "first_frames": []}
    if not wanted:
        return found
    condition = CONDITIONS[machine]
    asked = [(mode, "") for mode in wanted]
    if plain and machine == PLAIN_MACHINE:
        asked += [(mode, PLAIN_END) for mode in wanted if mode.in_c]
    scenes = [(scene_of(mode, plain=bool(end)),
               f"addx{condition.options}" + (f" OFF {mode.PLAIN}" if end else ""))
              for mode, end in asked]
    drawn = guest_frames.draw(scenes, condition.machine)
    for (mode, end), scene, digests in zip(asked, scenes, drawn):
        frames, pixels = shown(mode, True) if end else shown(mode)
        guest_frames.require_models(frames, digests, f"bench: mode {mode.name}{end}, {machine}",
                                    (*scene, condition.machine))
        ticks = digests["ticks"].astype(int).tolist()
        for kind, row in rows_of(mode, end, machine, ticks, pixels).items():
            found[kind].append(row)
    return found
