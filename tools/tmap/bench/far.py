"""Calls of perspective's spans from the far ends of lines to the near ones. In bench rows w differs 4 times, less
in short lines; a line grows by a texel a pixel in u and 0.7 in v on the whole.
"""

import numpy as np

from tmap.base.fixed import M32
from tmap.bench.edges import LINES, edge_columns, edge_sides
from tmap.bench.spans import BIAS, GAP, Ground, framed, line_count, table_of
from tmap.bench.trial import Trial, Write, fields
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup import far
from tmap.setup.perspective import PIECES

#: Row: the setting, whether by even spans.
SPANS = {"persp_far_16": ("every16", False), "persp_far_8": ("every8", False),
         "persp_even_16": ("every16", True), "persp_even_8": ("every8", True)}


def table(arena: Arena) -> int:
    """Adds the table; where its index 0 is."""
    return arena.add(np.array(far.TABLE, ">u2").tobytes()) + (far.ORIGIN - far.LOWEST) * 2


def kernel(k: far.Constants) -> str:
    """The span that draws a polygon with these constants."""
    way = "left" if k.leftwards else "right"
    return f"span_far_{'even_' if k.even else ''}{way}{('', '_coarse', '_coarser')[k.coarse // far.COARSE]}"


def plan_fields(k: far.Constants) -> dict:
    """What a span's structure has of them."""
    values = {"dq": abs(k.dqdx), "ku": k.k[0], "kv": k.k[1], "cu": k.c[0], "cv": k.c[1], "dcu": k.dc[0],
              "dcv": k.dc[1]}
    starts = {f"from_{pixels}": min(k.first_index(pixels) - far.ORIGIN, 32767) if k.even else 0
              for pixels in (8, 16)}
    return starts | {name: n & M32 for name, n in values.items()}


def lengths(arena: Arena, every: str) -> int:
    """Adds the lengths of a setting's pieces; where they are."""
    most = {f"most_{pixels}": far.LENGTHS[every][pixels] for pixels in (16, 8, 4, 2)}
    shape = layout.load().struct("far_lengths")
    return arena.add(shape.pack(**most), name="lengths", shape=shape)


def line_table(arena: Arena, lines: list[tuple[int, int]], qs: list[int], leftwards: bool, frame_at: int,
               pitch: int) -> int:
    """Adds the table of lines (first column, pixels) with their q, and room behind it; where it is."""
    shape, table = layout.load().struct("far_line"), bytearray()
    for y, ((left, count), q) in enumerate(zip(lines, qs)):
        ends = [frame_at + y * pitch + x for x in (left, left + count)]
        table += shape.pack(q=q & M32, **dict(zip(("from", "end"), ends[::-1] if leftwards else ends)))
    at = arena.add(table + bytes(range(1, shape.size + 1)), name="lines", shape=shape)
    arena.far_pointers += [at + n * shape.size + shape.fields[name]["offset"] for n in range(len(lines))
                           for name in ("from", "end")]
    return at


def far_lines(arena: Arena, k: far.Constants, lines: list[tuple[int, int]], frame_at: int, pitch: int) -> int:
    """Adds the table of the lines with these constants; where it is."""
    qs = [far.line(None, k, left, left + count, k.top + y).q for y, (left, count) in enumerate(lines)]
    return line_table(arena, lines, [q << 1 ^ 1 << 31 for q in qs] if k.even else qs, k.leftwards, frame_at, pitch)


def scanlines(arena: Arena, lines: list[tuple[int, int]]) -> int:
    """Adds a scanline table of lines (first column, pixels)."""
    entries = table_of([{"left": left + BIAS, "last": left + count - 1 + BIAS} for left, count in lines])
    return arena.add(entries, name="lines", shape=layout.load().struct("scanline"))


def span_trial(arena: Arena, ground: Ground, k: far.Constants, lines: list[tuple[int, int]], pitch: int,
               title: str = "") -> Trial:
    """One table of lines (first column, pixels); the first is at the constants' ``top``."""
    writes = []
    for y, (left, count) in enumerate(lines):
        if count > 0:
            u, v = far.coordinates([far.line(None, k, left, left + count, k.top + y)])
            writes.append(Write(ground.frame_at + y * pitch + left,
                                ground.picture[v >> 16 & 255, u >> 16 & 255].tobytes(), far=True))
    near = {"table": table(arena), "lengths": lengths(arena, k.every),
            "lines": far_lines(arena, k, lines, ground.frame_at, pitch)}
    near["ends"] = near["table"] + 2 * k.ahead
    if k.even:  # the line behind the table
        writes.append(Write(near["lines"] + len(lines) * layout.load().struct("far_line").size + 4, bytes(8)))
    plan = arena.struct("far_span", near, {"map": ground.map_at}, count=len(lines), **plan_fields(k))
    return Trial(Case(kernel(k), arena, pointers={"a0": plan}, far=ground.arena), title, writes=writes)


def place(lines: int, row: int, pitch: int, q: int, dqdx: int, dqdy: int) -> list[int]:
    """A far_place, which begins a struct; ``lines`` is to be relocated."""
    return list(layout.load().struct("far_place").pack(lines=lines, row=row, pitch=pitch, q=q & M32, dqdx=dqdx,
                                                       dqdy=dqdy))


def line_writes(at: int, lines: list[tuple[int, int]], row: int, pitch: int, q: int, dqdx: int,
                dqdy: int) -> list[Write]:
    """What a table at ``at`` gets of lines from a far x to a near one."""
    writes = []
    for y, (far_x, near_x) in enumerate(lines):
        writes += fields(at + y * layout.load().struct("far_line").size, "far_line",
                         {"q": q + far_x * dqdx + y * dqdy, "from": row + y * pitch + far_x,
                          "end": row + y * pitch + near_x})
    return writes


def edges_trial(arena: Arena, fars: list[dict[str, int]], nears: list[dict[str, int]], where: tuple[int, ...],
                title: str = "", spare: int = 0) -> Trial:
    """edges_far with the edges of both sides, struct edge each. ``where``: row, pitch, q, dqdx, dqdy."""
    shape = layout.load().struct("edge")
    lines = list(zip(*([x for edge in side for x in edge_columns(edge)] for side in (fars, nears))))
    table_at = arena.room("far_line", len(lines) + spare, "lines")
    sides = {name: arena.add(b"".join(shape.pack(**e) for e in edges), name=name, shape=shape)
             for name, edges in (("far", fars), ("near", nears))}
    plan = arena.struct("far_edges", sides, place=place(table_at, *where), fars=len(fars), nears=len(nears))
    arena.pointers.append(plan)
    return Trial(Case("edges_far", arena, pointers={"a0": plan}), title,
                 writes=line_writes(table_at, lines, *where))


def lines_trial(arena: Arena, lines: list[tuple[int, int]], leftwards: bool, where: tuple[int, ...],
                title: str = "") -> Trial:
    """lines_far with a scanline table (first column, pixels)."""
    ends = [(left + BIAS, left + count + BIAS)[::-1 if leftwards else 1] for left, count in lines]
    table_at = arena.room("far_line", len(lines), "to")
    plan = arena.struct("far_lines", {"from": scanlines(arena, lines)}, place=place(table_at, *where),
                        count=len(lines), leftwards=int(leftwards))
    arena.pointers.append(plan)
    return Trial(Case("lines_far", arena, pointers={"a0": plan}), title, writes=line_writes(table_at, ends, *where))


def edges_case():
    """A bench row: the lines of edge_flat_exact's, each with its q."""
    sides = edge_sides("edge_flat_exact")
    return edges_trial(Arena(), *sides, (0, 320, 1 << 28, 1 << 20, -1 << 18)).row(LINES)


def lines_case():
    """A bench row: lines of a table."""
    return lines_trial(Arena(), [(k, 10) for k in range(LINES)], True, (0, 320, 1 << 28, 1 << 20, -1 << 18)).row(LINES)


def span_case(every: str, even: bool, length: int):
    """A bench row: lines of one length that begin 0 to 3 pixels on."""
    rng, count, memory = np.random.default_rng(length), line_count(length), Arena()
    picture = rng.integers(0, 256, (256, 256), dtype=np.uint8)
    map_at = memory.add(picture.tobytes(), layout.load().constants["ARENA_ALIGN"])
    step = min(3 * (1 << 28) // length, far.LENGTHS[every][PIECES[every]] // 2)
    q = 1 << 28, (1 << 28) + length * step
    k = tuple(rng.integers(0, 1 << 32, 2).tolist())
    across = 2.0**38 / q[0] - 2.0**38 / q[1]  # of C r, where C is 1: see far.h
    c = tuple(int(-d * length / across * 65536) for d in (1, 0.7))
    made = far.Constants(k, c, (0, 0), q[0], step, 0, 0, 0, every, 0, [0, 0], even)
    ground = framed(memory, map_at, picture, count, length)
    lines = [(k % 4, length) for k in range(count)]
    return span_trial(Arena(), ground, made, lines, length + GAP).row(count * length)
