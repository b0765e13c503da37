"""Bench rows of the texture engine's modes (tools.tx_modes): cycles a pixel of a polygon, set-up
included, beside the same drawn pixel by pixel in plain C; and what the first frame costs more,
which makes tables and decodes tiles.
"""

import tempfile
from functools import cache
from pathlib import Path

import numpy as np
from PIL import Image

from . import fuzz, model, scene_tx_build
from .bench_rules import MACHINES
from .emulator import CYCLES_PER_TICK
from .errors import UserError
from .scene_file import IDENTITY, Material, Object, Scene
from .tx_modes import EVERY, OTHER, PICTURE, SIDE, Mode

WIDTH, HEIGHT = 96, 80
EMPTY, FIRST, AGAIN = range(3)  # frames: nothing, the first that is drawn, the one that counts
PLAIN = " OFF tx_plain,tx_passes"  # every pixel by c/tx/pixel.c
ROW, FIRST_ROW, PLAIN_END = "mode_", "first_", "_c"
PLAIN_MACHINE = "a1200-fast"
KINDS = ("smooth", "noise")


def picture(kind: str, seed: int) -> np.ndarray:
    """An opaque picture, uint8 [SIDE, SIDE, 4]: periodic, neighbours differing by at most 20, or
    random colours."""
    if kind == "smooth":
        y, x = np.mgrid[:SIDE, :SIDE] * (2 * np.pi / SIDE)
        waves = np.stack([np.sin(x), np.cos(y + seed), np.sin(x + y), np.ones_like(x)], -1)
        return np.rint(waves * [100, 100, 100, 127] + 128).astype(np.uint8)
    made = np.random.default_rng(seed).integers(0, 256, (SIDE, SIDE, 4), np.uint8)
    made[..., 3] = 255
    return made


def first_drawn(vertices: list[tuple[int, ...]], plain: bool) -> list[tuple[int, ...]]:
    """What the first frame has: the polygon, or, to be drawn pixel by pixel in C, a triangle of a few
    pixels, which makes the same tables and spares thousands of cycles a pixel."""
    if not plain:
        return vertices
    corner = vertices[0]
    return [tuple(from_ + (to - from_ >> 4) for from_, to in zip(corner, v)) for v in vertices[:3]]


@cache
def scene_of(mode: Mode, kind: str = "noise", plain: bool = False) -> Scene:
    """An empty frame, then the mode's polygon in two; ``kind``: of KINDS; ``plain``: see
    first_drawn."""
    frames = AGAIN + 1
    with tempfile.TemporaryDirectory() as folder:
        for seed, name in enumerate((PICTURE, OTHER)):
            Image.fromarray(picture(kind, seed)).save(Path(folder) / name)
        _, tables = scene_tx_build.build({"materials": {"it": {"tx": mode.material()}}},
                                         Path(folder), frames, f"mode {mode.name}: ")
    first = first_drawn(mode.vertices, plain)
    return Scene(WIDTH, HEIGHT, frames, 7, np.zeros((256, 3), np.uint8), [],
                 [Material("unit", unit=0)],
                 [Object(0, 0, len(first), 0, 1, FIRST),
                  Object(0, len(first), len(mode.vertices), 0, 1, AGAIN)],
                 np.array(first + mode.vertices), np.array([IDENTITY]), mode.pixels, **tables)


@cache
def shown(mode: Mode, plain: bool = False) -> tuple[list[np.ndarray], int]:
    """The model's picture of each frame, and how many pixels the polygon of the last has."""
    if plain:
        (empty, _, again), pixels = shown(mode)
        return [empty, model.render(scene_of(mode, plain=True), FIRST), again], pixels
    scene = scene_of(mode)
    first = model.render(scene, FIRST)
    vertices = [v[:4] for v in mode.vertices]
    made = model.set_up(vertices, WIDTH, HEIGHT, False)
    return [model.render(scene, EMPTY), first, first], made.pixels


def measure(machine: str, names: list[str], plain: bool = True) -> dict[str, list[dict]]:
    """Rows "modes" and "first_frames" of modes, all in one boot; ``names``: of modes; ``plain``:
    with those in plain C, on PLAIN_MACHINE."""
    modes = [EVERY[name] for name in names]
    if not modes:
        return {"modes": [], "first_frames": []}
    boot, chip = MACHINES[machine]
    ways = {"": modes} | ({PLAIN_END: modes} if plain and machine == PLAIN_MACHINE else {})
    asked = [(mode, end) for end, some in ways.items() for mode in some]
    drawn = fuzz.draw([(scene_of(mode, plain=bool(end)), f"addx{chip}{PLAIN if end else ''}")
                       for mode, end in asked], boot)
    found = {"modes": [], "first_frames": []}
    for (mode, end), digests in zip(asked, drawn):
        frames, pixels = shown(mode, True) if end else shown(mode)
        for number, (frame, digest) in enumerate(zip(frames, digests, strict=True)):
            if not fuzz.is_models(frame, digest):
                raise UserError(f"bench: mode {mode.name}{end}, {machine}: frame {number} is not "
                                "the model's")
        ticks = digests["ticks"].astype(int).tolist()
        row = {"name": f"{ROW}{mode.name}{end}", "machine": machine, "length": pixels}
        found["modes"].append(row | {
            "cycles_per_pixel": round((ticks[AGAIN] - ticks[EMPTY]) * CYCLES_PER_TICK / pixels, 3),
            "one_tick": round(CYCLES_PER_TICK / pixels, 5)})
        if not end:
            found["first_frames"].append(row | {
                "name": f"{FIRST_ROW}{mode.name}", "one_tick": CYCLES_PER_TICK,
                "cycles_more": (ticks[FIRST] - ticks[AGAIN]) * CYCLES_PER_TICK})
    return found
