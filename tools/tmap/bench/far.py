"""Calls of perspective's spans from the far ends of lines to the near ones. In bench rows w differs 4 times, less
in short lines; a line grows by a texel a pixel in u and 0.7 in v on the whole.
"""

import numpy as np

from tmap.base.fixed import M32, swap
from tmap.bench.spans import BIAS, GAP, Ground, framed, line_count, table_of
from tmap.bench.trial import Trial, Write
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup import far

#: Row: log2 of a piece's pixels.
SPANS = {"persp_far_16": 4, "persp_far_8": 3}
STEEPEST = 1 << 25  # of rows, steps of q a pixel


def table(arena: Arena) -> int:
    """Adds the table; where its index 0 is."""
    return arena.add(np.array(far.TABLE, ">u2").tobytes()) + far.COUNT // 2 * 2


def kernel(k: far.Constants) -> str:
    """The span that draws a polygon with these constants."""
    return (f"span_far_{1 << k.piece}_{'left' if k.dqdx < 0 else 'right'}"
            f"{'_coarse' if k.coarse else ''}")


def span_trial(arena: Arena, ground: Ground, k: far.Constants, lines: list[tuple[int, int]], pitch: int,
               title: str = "") -> Trial:
    """One table of lines (first column, pixels); the first is at the constants' ``top``."""
    writes = []
    for y, (left, count) in enumerate(lines):
        if count > 0:
            u, v = far.coordinates(far.line(None, k, left, left + count, k.top + y))
            writes.append(Write(ground.frame_at + y * pitch + left,
                                ground.picture[v >> 16 & 255, u >> 16 & 255].tobytes(), far=True))
    entries = table_of([{"left": left + BIAS, "last": left + count - 1 + BIAS} for left, count in lines])
    near = {"lines": arena.add(entries, name="lines", shape=layout.load().struct("scanline")),
            "table": table(arena)}
    values = {name: n & M32 for name, n in (
        ("q", k.q - (k.left + BIAS) * k.dqdx - (far.ORIGIN << 16)), ("dq", swap(abs(k.dqdx) << k.piece & M32)),
        ("ku", k.k[0]), ("kv", k.k[1]), ("cu", swap(k.c[0] & M32)), ("cv", swap(k.c[1] & M32)),
        ("dcu", swap(k.dc[0] & M32)), ("dcv", swap(k.dc[1] & M32)))}
    plan = arena.struct("far_span", near, dict(row=ground.frame_at - BIAS, map=ground.map_at),
                        count=len(lines), pitch=pitch, dqdx=k.dqdx, dqdy=k.dqdy, **values)
    return Trial(Case(kernel(k), arena, pointers={"a0": plan}, far=ground.arena), title, writes=writes)


def span_case(piece: int, length: int):
    """A bench row: lines of one length that begin 0 to 3 pixels on."""
    rng, count, memory = np.random.default_rng(length), line_count(length), Arena()
    picture = rng.integers(0, 256, (256, 256), dtype=np.uint8)
    map_at = memory.add(picture.tobytes(), layout.load().constants["ARENA_ALIGN"])
    step = min(3 * (1 << 29) // length, STEEPEST)
    q = 1 << 29, (1 << 29) + length * step
    r0, r1 = (far.TABLE[(n >> 16) - far.LOWEST] for n in q)
    c = tuple(int(d * length * (1 << 24 - piece) / (r1 - r0)) << 16 for d in (1, 0.7))
    made = far.Constants(tuple(int(n) for n in rng.integers(0, 1 << 32, 2)), c, (0, 0), q[0] + 65536, step, 0,
                         0, 0, piece, 0, [0, 0])
    ground = framed(memory, map_at, picture, count, length)
    lines = [(k % 4, length) for k in range(count)]
    return span_trial(Arena(), ground, made, lines, length + GAP).row(count * length)
