"""Bench rows of whole scenes: cycles a frame, clearing included, on the machines they run on.

Some frames from all their length; each must be the model's. With texture engines the first, with
Glide's units all of them are drawn twice, and count the second time: tables are made, tiles and
levels decoded by then.
"""

from dataclasses import replace
from functools import cache
from itertools import groupby

import numpy as np

from tmap.base.paths import SCENES
from tmap.compiler import views16
from tmap.compiler.scene import compile_scene
from tmap.guest import guest_frames
from tmap.guest.emulator import CYCLES_PER_TICK, MEASURED, PATIENT_SECONDS
from tmap.model import model
from tmap.scene_file.scene_file import Scene

NAMES = ("cube", "face", "floor", "corridor", "environment", "rotator", "lit", "torch", "shaded", "crane", "grove",
         "lamps", "wide", "panel", "n64_room", "n64_wall", "n64_ocean", "n64_floor", "n64_palettes", "n64_yuv",
         "n64_rectangles", "glide_aspects", "glide_floor", "glide_wall", "glide_window",
         "glide_lightmap", "dithered", "rooms", "terrace", "movers", "keep", "mist")
FRAMES, ENGINE_FRAMES = 4, 2  # with texture engines a frame takes four times as long
ROW = "scene_"


def cut(things, table: np.ndarray, row: str, numbers: list[int]) -> tuple[list, list, list[int]]:
    """Objects (``row``: "pose") or instances ("view") in these frames alone, the rows of ``table`` that
    they have there, and how many are kept of the first n, by n. One that comes again becomes two."""
    kept, rows, places = [], [], [0]
    for each in things:
        first, count = getattr(each, row), getattr(each, f"{row}s")
        ages = [number - each.first_frame for number in numbers]
        shown = [k for k, age in enumerate(ages) if 0 <= age < count]
        for _, some in groupby(enumerate(shown), lambda pair: pair[1] - pair[0]):
            run = [k for _, k in some]  # frames that follow each other
            kept.append(replace(each, first_frame=run[0], **{row: len(rows), f"{row}s": len(run)}))
            rows += [table[first + ages[k]] for k in run]
        places.append(len(kept))
    return kept, rows, places


def cut_lists(scene: Scene, numbers: list[int]) -> tuple[list, list]:
    """The engines' units and lists for these frames: one for the start and one a frame, or one."""
    units, lists = [], []
    for first, count in scene.units.tolist():
        kept = [first] + [first + 1 + number for number in numbers if count > 1]
        units.append([len(lists), len(kept)])
        lists += scene.lists[kept].tolist()
    return units, lists


def some_frames(scene: Scene, numbers: list[int]) -> Scene:
    """A scene of these frames alone, in this order; a frame may be there twice."""
    objects, poses, places = cut(scene.objects, scene.poses, "pose", numbers)
    instances, views, _ = cut(scene.instances, scene.views, "view", numbers)
    instances = [replace(each, before=places[each.before], view16=-1) for each in instances]
    units, lists = cut_lists(scene, numbers)
    made = replace(scene, frames=len(numbers), objects=objects, instances=instances,
                   poses=np.array(poses or scene.poses), views=np.array(views or scene.views),
                   units=np.array(units or scene.units), lists=np.array(lists or scene.lists))
    return views16.add(made)


def frames_of(scene: Scene) -> int:
    """The frames of a scene that its row is the mean of."""
    return ENGINE_FRAMES if len(scene.units) + len(scene.pipes) else FRAMES


@cache
def shown(name: str) -> tuple[Scene, list[np.ndarray]]:
    """Some frames of a scene, and the model's pictures of them."""
    whole = compile_scene(SCENES / f"{name}.toml")
    count = frames_of(whole)
    numbers = [k * whole.frames // count for k in range(count)]
    before = numbers if len(whole.pipes) else numbers[:1] if len(whole.units) else []
    scene = some_frames(whole, before + numbers)
    return scene, [model.render(scene, number) for number in range(scene.frames)]


def measure(machine: str, names: list[str]) -> list[dict]:
    """A row for each scene, all in one boot; none where data is put elsewhere than programs do."""
    if machine not in MEASURED or not names:
        return []
    rows = []
    drawn = guest_frames.draw([(shown(name)[0], "addx") for name in names], machine,
                              patience=PATIENT_SECONDS, apart=True)  # some fill all chip RAM
    for name, digests in zip(names, drawn):
        guest_frames.require_models(shown(name)[1], digests, f"bench: scene {name}, {machine}",
                                    (shown(name)[0], "addx", machine))
        frames = frames_of(shown(name)[0])
        cycles = int(digests["ticks"][-frames:].astype(int).sum()) * CYCLES_PER_TICK / frames
        rows.append({"name": f"{ROW}{name}", "machine": machine, "length": frames,
                     "cycles_per_frame": cycles, "one_tick": CYCLES_PER_TICK / frames})
    return rows
