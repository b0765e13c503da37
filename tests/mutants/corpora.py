"""What mutants draw: polygons and scenes that the suite draws too, and holds to the model there."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np

from tests.accuracy import test_high
from tests.helpers import mesh_cases
from tests.polygon import test_runs
from tmap.base.paths import SCENES
from tmap.compiler.scene import compile_scene
from tmap.corpus import random_glide, random_n64
from tmap.fuzz import fuzz
from tmap.fuzz.families import ALL, PERSPECTIVE
from tmap.fuzz.polygons import BLOCK, polygon, scene
from tmap.guest import emulator, guest_frames
from tmap.guest.emulator import SECOND
from tmap.scene_file.scene_file import Scene

Drawing = tuple[Scene, str]  # with its form and further arguments of render
SEED = 2026  # of tests/accuracy/test_fuzz.py
FRAMES = 3  # of a scene
PATIENCE = 10.0  # seconds of processor time without output: a mutant hangs


def fuzzed(family: str, block: int, step: int) -> list[Drawing]:
    """Returns each ``step``-th polygon of one of the fuzzer's blocks, some of them with no rule of lowering."""
    some = [polygon(SEED, block * BLOCK + k, family) for k in range(0, BLOCK, step)]
    return [(scene(SEED, block, some), fuzz.form_of(block)), (scene(SEED, block, some[::4]), "addx OFF all")]


def runs(seed: int) -> list[Drawing]:
    """Returns the random runs of tests/polygon."""
    return [(test_runs.scene_of(name, seed), "addx") for name in test_runs.SIZES]


def written(*names: str) -> list[Drawing]:
    """Returns scenes of tests/scenes, a few frames of each."""
    return [(made, f"addx FRAMES {min(made.frames, FRAMES)}")
            for made in (compile_scene(SCENES / f"{name}.toml") for name in names)]


def meshes(make: Callable[[int], Scene], count: int, form: str = "addx") -> list[Drawing]:
    """Returns random scenes of meshes."""
    return [(make(seed), form) for seed in range(count)]


def n64(pixels: str, form: str, count: int) -> list[Drawing]:
    """Returns the random polygons of tests/n64."""
    return [(random_n64.scene([random_n64.case(1, k, pixels) for k in range(count)], 1, pixels), form)]


def glide(pixels: str, form: str, first: int, count: int) -> list[Drawing]:
    """Returns some of the random polygons of tests/glide."""
    return [(random_glide.scene([random_glide.case(1, k) for k in range(first, first + count)], 1, pixels), form)]


#: By subject, in parts that are drawn one after the other until one differs.
PARTS: dict[str, tuple[Callable[[], list[Drawing]], ...]] = {
    "polygons": (*(lambda block=block: fuzzed(ALL, block, 5) for block in range(4)),
                 *(lambda block=block: fuzzed(ALL, block, 8) + fuzzed(PERSPECTIVE, block - 4, 8)
                   + fuzzed(PERSPECTIVE, block, 8) for block in range(4, 8)),
                 lambda: [*runs(0), (test_high.high_scene(), "addx")],
                 lambda: written("mappers", "wide", "dithered", "lit", "panel", "default")),
    "meshes": (lambda: written("cube", "corridor", "environment", "face", "floor", "grove", "lamps"),
               lambda: written("keep", "movers", "rooms", "torch", "terrace", "mist", "crane", "shaded"),
               lambda: meshes(mesh_cases.boxes, 6) + meshes(mesh_cases.before, 3),
               lambda: meshes(mesh_cases.trees, 3) + meshes(mesh_cases.hostile, 6) + meshes(mesh_cases.crowd, 3),
               lambda: meshes(mesh_cases.boxes, 2, "swap") + meshes(mesh_cases.boxes, 2, "c")),
    "n64": (lambda: n64("rgba5551", "addx", 100), lambda: n64("rgba8888", "addx", 100),
            lambda: n64("rgba5551", "addx OFF all", 25), lambda: n64("rgba8888", "addx OFF all", 25),
            lambda: written("n64_floor", "n64_ocean", "n64_palettes", "n64_rectangles", "n64_room", "n64_wall", "n64_yuv")),
    "glide": (*(lambda first=first: glide("rgb565", "addx", first, 15) for first in (0, 15, 30, 45)),
              *(lambda first=first: glide("rgba8888", "addx", first, 15) for first in (0, 15, 30, 45)),
              lambda: glide("rgb565", "addx OFF all", 0, 15),
              lambda: written("glide_aspects", "glide_floor", "glide_lightmap", "glide_wall", "glide_window")),
}


@cache
def part(subject: str, number: int) -> tuple[list[Drawing], list[tuple[np.ndarray, str]]]:
    """Returns the drawings of a part, and their digests and counts as the program of the tree draws them."""
    drawings = PARTS[subject][number]()
    return drawings, draw(drawings)


def draw(drawings: list[Drawing], programs: Path = emulator.PROGRAMS) -> list[tuple[np.ndarray, str]]:
    """Returns digests, and what is printed: polygons, those that each rule applied to, pixels of each span."""
    return guest_frames.drawn([(scene, f"{form} COUNT") for scene, form in drawings], SECOND, patience=PATIENCE, timed=False,
                              programs=programs)
