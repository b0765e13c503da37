"""Calls of the routines that draw batches of triangles: expected pixels come from the model."""

import math
import random

import numpy as np

from tmap.base import elementary
from tmap.base.fixed import M32
from tmap.bench.trial import Check, Trial, Write
from tmap.corpus import polygon_sets
from tmap.guest.kernels import Arena, Case
from tmap.setup import snapped
from tmap.setup.spans import coordinates

WIDTH, HEIGHT = 128, 128
COLOUR = 0xA7
COUNT = 32  # of a row
ROUTINES = {"flat": "triangles_flat", "gouraud": "triangles_gouraud", "affine": "triangles_affine"}


def page() -> np.ndarray:
    """A 256x256 map of noise."""
    return np.random.default_rng(256).integers(0, 256, (256, 256), dtype=np.uint8)


def draw(frame: np.ndarray, mapper: str, vertices, cull: bool, texture: np.ndarray) -> None:
    """Draws a triangle of the model's; ``vertices``: x, y in 1/16 pixel, values in 1/2^20."""
    made = snapped.set_up([v[:2 + snapped.VALUES[mapper]] for v in vertices], mapper,
                          snapped.VALUES[mapper], cull)
    for y, line in enumerate(snapped.lines(made) if made else (), made.top if made else 0):
        if line.right <= line.left:
            continue
        u, v = coordinates(line)
        frame[y, line.left:line.right] = {
            "flat": lambda: COLOUR, "gouraud": lambda: u >> 16 & 255,
            "affine": lambda: texture[v >> 16 & 255, u >> 16 & 255]}[mapper]()


def record(vertex) -> bytes:
    """A struct snapped_vertex. None: one that is out of range."""
    if vertex is None:
        return b"\xff" * 4 + bytes(12)
    x, y, u, v = vertex
    return b"".join((c & M32).to_bytes(4, "big") for c in (x + 16 << 16 | y + 15, u, v, 0))


def batch_trial(arena: Arena, mapper: str, triangles: list, title: str = "", cull: int = 0) -> Trial:
    """A batch. The routine must stop at the first triangle with a vertex None, or too high."""
    far, texture = Arena(), page()
    vertices = arena.add(b"".join(map(record, sum(triangles, []))), name="vertices")
    places = range(vertices, vertices + 48 * len(triangles), 16)
    listed = arena.add(b"".join(at.to_bytes(4, "big") for at in places), name="list")
    arena.pointers += range(listed, listed + 4 * len(places), 4)
    table = arena.add(b"".join(snapped.reciprocal(dy).to_bytes(4, "big")
                               for dy in range(16 * snapped.LINES)), name="reciprocals")
    map_at = far.add(texture.tobytes(), align=1 << 16, name="map")
    row = far.blank(WIDTH * HEIGHT, name="frame")
    plan = arena.struct("triangle_plan", {"list": listed, "end": listed + 12 * len(triangles),
                                          "reciprocals": table}, {"row": row, "map": map_at},
                        pitch=WIDTH, colour=COLOUR * 0x01010101, cull=cull)
    frame, drawn = np.zeros((HEIGHT, WIDTH), np.uint8), 0
    for vertices_ in triangles:
        if None in vertices_ or max(v[1] for v in vertices_) - min(v[1] for v in vertices_) \
                >= 16 * snapped.LINES:
            break
        draw(frame, mapper, vertices_, bool(cull), texture)
        drawn += 1

    return Trial(Case(ROUTINES[mapper], arena, pointers={"a0": plan}, far=far), title,
                 near_ends={"d0": listed + 12 * drawn}, writes=[Write(row, frame.tobytes(), far=True)])


def triangles(pixels: int) -> list:
    """COUNT triangles of polygon_sets.sized, as a batch has them."""
    rng, made = random.Random(f"triangles {pixels}"), []
    for _ in range(COUNT):
        points = polygon_sets.sized(rng, pixels)
        turn, texels = rng.uniform(0, math.tau), rng.uniform(0.4, 1) * (1 << 20)
        cos, sin = elementary.cos(turn), elementary.sin(turn)
        made.append([(round(16 * x), round(16 * y), round((cos * x - sin * y) * texels) + (128 << 20),
                      round((sin * x + cos * y) * texels) + (128 << 20)) for x, y in points])
    return made


def case(mapper: str, pixels: int) -> tuple[int, Case, Check]:
    """A row's batch, seen from the front."""
    return batch_trial(Arena(), mapper, triangles(pixels), cull=1).row(COUNT)
