"""Bench rows of whole scenes: cycles a frame, clearing included, on the machines they run on.

Some frames from all their length; each must be the model's. With texture engines the first, with
Glide's units all of them are drawn twice, and count the second time: tables are made, tiles and
levels decoded by then.
"""

from dataclasses import replace
from functools import cache

import numpy as np

from . import fuzz, model
from .emulator import CYCLES_PER_TICK, PATIENT_SECONDS
from .errors import UserError
from .paths import SCENES
from .scene import compile_scene
from .scene_file import Scene

NAMES = ("cube", "face", "floor", "corridor", "environment", "rotator", "lit", "shaded", "wide",
         "panel", "tx_room", "tx_wall", "tx_ocean", "tx_floor", "tx_palettes", "tx_yuv",
         "tx_rectangles", "glide_aspects", "glide_floor", "glide_wall", "glide_window",
         "glide_lightmap", "dithered")
FRAMES = 4
#: Conditions of the bench that a program can be run under.
MACHINES = ("a1200", "a1200-fast")


def some_frames(scene: Scene, numbers: list[int]) -> Scene:
    """A scene of these frames alone, none before the last."""
    poses, views, objects, instances = [], [], [], []
    places = [0]  # of objects among those that are kept
    for things, kept, table, rows, first, count in (
            (scene.objects, objects, scene.poses, poses, "pose", "poses"),
            (scene.instances, instances, scene.views, views, "view", "views")):
        for each in things:
            ages = [number - each.first_frame for number in numbers]
            seen = [k for k, age in enumerate(ages) if 0 <= age < getattr(each, count)]
            if seen:
                kept.append(replace(each, first_frame=seen[0], **{first: len(rows), count: len(seen)}))
                rows += [table[getattr(each, first) + ages[k]] for k in seen]
            if kept is objects:
                places.append(len(objects))
    instances = [replace(each, before=places[each.before]) for each in instances]
    units, lists = [], []
    for first, count in scene.units.tolist():
        kept = [first] + [first + 1 + number for number in numbers if count > 1]
        units.append([len(lists), len(kept)])
        lists += scene.lists[kept].tolist()
    return replace(scene, frames=len(numbers), objects=objects, instances=instances,
                   poses=np.array(poses or scene.poses), views=np.array(views or scene.views),
                   units=np.array(units or scene.units), lists=np.array(lists or scene.lists))


@cache
def shown(name: str) -> tuple[Scene, list[np.ndarray]]:
    """Some frames of a scene, and the model's pictures of them."""
    whole = compile_scene(SCENES / f"{name}.toml")
    numbers = [k * whole.frames // FRAMES for k in range(FRAMES)]
    before = numbers if len(whole.pipes) else numbers[:1] if len(whole.units) else []
    scene = some_frames(whole, before + numbers)
    return scene, [model.render(scene, number) for number in range(scene.frames)]


def measure(machine: str, names: list[str]) -> list[dict]:
    """A row for each scene, all in one boot."""
    if machine not in MACHINES or not names:
        return []
    rows = []
    drawn = fuzz.draw([(shown(name)[0], "addx") for name in names], machine,
                      patience=PATIENT_SECONDS, apart=True)  # some fill all chip RAM
    for name, digests in zip(names, drawn):
        for number, (frame, digest) in enumerate(zip(shown(name)[1], digests, strict=True)):
            if not fuzz.is_models(frame, digest):
                raise UserError(f"bench: scene {name}, {machine}: frame {number} is not the model's")
        cycles = int(digests["ticks"][-FRAMES:].astype(int).sum()) * CYCLES_PER_TICK / FRAMES
        rows.append({"name": f"scene_{name}", "machine": machine, "length": FRAMES,
                     "cycles_per_frame": cycles, "one_tick": CYCLES_PER_TICK / FRAMES})
    return rows
