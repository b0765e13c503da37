"""Calls of the routines that draw batches of triangles: expected pixels come from the model."""

import functools
import math
import random

import numpy as np

from tmap.base import elementary
from tmap.base.fixed import M32
from tmap.bench.edges import table_writes
from tmap.bench.trial import Check, Trial, Write, fields
from tmap.build import layout
from tmap.corpus import polygon_sets
from tmap.guest.kernels import Arena, Case
from tmap.setup import snapped
from tmap.setup.scanline import add_span_plan, pack
from tmap.setup.spans import coordinates

WIDTH, HEIGHT = 128, 128
COLOUR = 0xA7
COUNT = 32  # of a row
BIAS = layout.load().constants["EDGE_BIAS"]
#: Fields of a plan that only triangles_spans reads.
UNUSED = dict.fromkeys(("lines", "kind", "lowered", "only_counts", "off", "light", "shades", "span", "shade"), 0)
ROUTINES = {"flat": "triangles_flat", "gouraud": "triangles_gouraud", "affine": "triangles_affine"}
#: Makers of tables of lines, and a mapper whose lines they are.
LINERS = {"triangle_lines_flat": ("flat", "flat", 4), "triangle_lines_addx": ("lit", "addx", 1),
          "triangle_lines_levels": ("lit_gouraud", "addx", 1)}


def page() -> np.ndarray:
    """A 256x256 map of noise."""
    return np.random.default_rng(256).integers(0, 256, (256, 256), dtype=np.uint8)


def draw(frame: np.ndarray, mapper: str, vertices, cull: bool, texture: np.ndarray) -> None:
    """Draws a triangle of the model's; ``vertices``: x, y in 1/16 pixel, values in 1/2^20."""
    made = snapped.set_up(vertices, mapper, cull)
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
    x, y, *values = vertex
    return b"".join((c & M32).to_bytes(4, "big") for c in (x + 16 << 16 | y + 15, *values))


@functools.cache
def reciprocals() -> bytes:
    """The table of reciprocals, by height in sixteenths of a line: uint32."""
    return b"".join(snapped.reciprocal(dy).to_bytes(4, "big") for dy in range(16 * snapped.LINES))


def add_list(arena: Arena, triangles: list) -> tuple[int, int]:
    """Puts a batch's vertices, list and reciprocals into an arena; returns where the last two are."""
    vertices = arena.add(b"".join(map(record, sum(triangles, []))), name="vertices")
    places = range(vertices, vertices + 48 * len(triangles), 16)
    listed = arena.add(b"".join(at.to_bytes(4, "big") for at in places), name="list")
    arena.pointers += range(listed, listed + 4 * len(places), 4)
    return listed, arena.add(reciprocals(), name="reciprocals")


def is_handed(triangle) -> bool:
    """Returns true if a routine stops at a triangle: it has a vertex None, or is too high and has area."""
    if None in triangle:
        return True
    ys = [v[1] for v in triangle]
    (x0, y0), (x1, y1), (x2, y2) = (v[:2] for v in triangle)
    return (max(ys) - min(ys) >= 16 * snapped.LINES
            and (x1 - x0) * (y2 - y0) != (x2 - x0) * (y1 - y0))


def lines_trial(arena: Arena, routine: str, triangles: list, title: str = "", cull: int = 0,
                height: int = HEIGHT) -> Trial:
    """The table of lines of the first triangle of a batch that has some, in a frame of so many lines."""
    mapper, form, pixel_bytes = LINERS[routine]
    listed, table = add_list(arena, triangles)
    room = arena.room("scanline", height, "lines")
    span = add_span_plan(arena, {"lines": room}, {}, pitch=WIDTH)
    shade = arena.struct("shade_plan", {}, **dict.fromkeys(layout.load().struct("shade_plan").fields, 0))
    plan = arena.struct("triangle_plan", {"list": listed, "end": listed + 12 * len(triangles),
                                          "reciprocals": table, "span": span, "shade": shade},
                        row=0, map=0, pitch=WIDTH, colour=0, cull=cull, **{
                            name: 0 for name in UNUSED if name not in ("span", "shade")})
    behind, made = 0, None
    for triangle in triangles:
        if is_handed(triangle):
            break
        behind += 1
        made = snapped.set_up(triangle, mapper, bool(cull), pixel_bytes)
        if made:
            break
    lines = snapped.lines(made) if made else []
    numbers, levels = {"count": len(lines)}, {}
    if lines:
        numbers |= {"row": made.top * WIDTH}
        sign = -1 if made.right else 1
        numbers |= {f"d{name}dx": sign * value.pixel for name, value in zip("uv", made.values)}
        levels = {"shade": made.level_at(0, -BIAS), "dcdx": made.level_at(0, 1) - made.level_at(0, 0),
                  "dcdy": made.level_at(1, 0) - made.level_at(0, 0)} if made.level else {}
    entries = [{"left": line.left + BIAS, "last": line.right - 1 + BIAS} | pack(form, line.u, line.v)
               for line in lines]
    return Trial(Case(routine, arena, pointers={"a0": plan}), title,
                 near_ends={"d0": listed + 12 * behind},
                 writes=fields(span, "span_plan", numbers) + fields(shade, "shade_plan", levels)
                 + table_writes(room, entries, form))


def batch_trial(arena: Arena, mapper: str, triangles: list, title: str = "", cull: int = 0,
                height: int = HEIGHT) -> Trial:
    """A batch in a frame of so many lines. The routine must stop at the first triangle with a vertex
    None, or too high."""
    far, texture = Arena(), page()
    listed, table = add_list(arena, triangles)
    map_at = far.add(texture.tobytes(), align=1 << 16, name="map")
    row = far.blank(WIDTH * height, name="frame")
    plan = arena.struct("triangle_plan", {"list": listed, "end": listed + 12 * len(triangles),
                                          "reciprocals": table}, {"row": row, "map": map_at},
                        pitch=WIDTH, colour=COLOUR * 0x01010101, cull=cull, **UNUSED)
    frame, drawn = np.zeros((height, WIDTH), np.uint8), 0
    for vertices_ in triangles:
        if is_handed(vertices_):
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
                      round((sin * x + cos * y) * texels) + (128 << 20), 16 + 12 * k << 20)
                     for k, (x, y) in enumerate(points)])
    return made


def case(mapper: str, pixels: int) -> tuple[int, Case, Check]:
    """A row's batch, seen from the front."""
    return batch_trial(Arena(), mapper, triangles(pixels), cull=1).row(COUNT)


def lines_case(routine: str, pixels: int) -> tuple[int, Case, Check]:
    """A row's call: the lines of one triangle."""
    return lines_trial(Arena(), routine, triangles(pixels)[:1]).row(1)


#: Rows to what makes their calls, by a triangle's pixels.
CASES = {f"polygon_{mapper}": functools.partial(case, mapper) for mapper in ROUTINES} \
    | {name: functools.partial(lines_case, name) for name in LINERS}
