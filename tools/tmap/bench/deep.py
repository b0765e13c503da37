"""Cycles of polygons with depth: textured, lit with one level, lit with a level a pixel, under every
perspective, and affine beside them."""

import random
from functools import cache

import numpy as np

from tmap.base.elementary import power
from tmap.base.fixed import fix
from tmap.corpus import polygon_sets, random_maps
from tmap.guest import guest_frames
from tmap.guest.conditions import CONDITIONS
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.model import model
from tmap.scene_file.materials import SETTINGS, Material
from tmap.scene_file.scene_file import IDENTITY, Object, Scene, Texture
from tmap.scene_file.textures import IN_DEPTH

ROW = "deep_"
SIZES = (2000, 200)  # pixels of a triangle
COUNT = polygon_sets.COUNT
RATIO = polygon_sets.DEPTHS["depth"]
#: Row to its material.
MATERIALS = {f"{mapper}_{perspective}": Material(mapper, "exact", perspective=perspective, texture=0,
                                                 light=1 if mapper != "affine" else -1)
             for mapper in IN_DEPTH for perspective in SETTINGS["perspective"]}


def triangles(pixels: int) -> list[list[tuple[int, ...]]]:
    """COUNT triangles of so many pixels in space, whose levels are neither none nor full."""
    made = []
    for k in range(COUNT):
        rng = random.Random(f"deep {pixels} {k}")
        points = polygon_sets.sized(rng, pixels)
        surface = polygon_sets.in_space(rng, points, power(2, rng.uniform(-1, 1)), RATIO)
        made.append([tuple(map(fix, (*point, s, t, 20 + 70 * n, w)))
                     for n, (point, (s, t, w)) in enumerate(zip(points, surface))])
    return made


@cache
def scene_of(names: tuple[str, ...]) -> Scene:
    """An empty frame, then one for each row and size."""
    light = np.random.default_rng(64).integers(0, 256, (64, 256), dtype=np.uint8)
    objects, vertices = [], []
    for pixels in SIZES:
        made = triangles(pixels)
        for material in range(len(names)):
            frame = 1 + SIZES.index(pixels) * len(names) + material
            objects += [Object(material, len(vertices) + 3 * k, 3, 0, 1, frame) for k in range(COUNT)]
        vertices += [vertex for triangle in made for vertex in triangle]
    return Scene(polygon_sets.SIDE, polygon_sets.SIDE, 1 + len(SIZES) * len(names), 7,
                 random_maps.palette(), [Texture(random_maps.page()), Texture(light, "light")],
                 [MATERIALS[name] for name in names], objects, np.array(vertices), np.array([IDENTITY]))


@cache
def shown(names: tuple[str, ...]) -> list[np.ndarray]:
    """The model's pictures."""
    scene = scene_of(names)
    return [model.render(scene, number) for number in range(scene.frames)]


def measure(machine: str, names: list[str]) -> list[dict]:
    """The rows of one machine, all in one boot; ``names``: of MATERIALS."""
    if not names:
        return []
    condition, scene = CONDITIONS[machine], scene_of(tuple(names))
    way = f"addx{condition.options}"
    digests, = guest_frames.draw([(scene, way)], condition.machine)
    guest_frames.require_models(shown(tuple(names)), digests, f"bench: {ROW}*, {machine}",
                                (scene, way, condition.machine))
    empty, *spent = digests["ticks"].astype(int).tolist()
    places = [(name, pixels) for pixels in SIZES for name in names]
    return [{"name": ROW + name, "machine": machine, "length": pixels,
             "cycles_per_polygon": (ticks - empty) * CYCLES_PER_TICK / COUNT,
             "one_tick": CYCLES_PER_TICK / COUNT} for (name, pixels), ticks in zip(places, spent)]
