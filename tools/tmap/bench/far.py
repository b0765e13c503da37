"""Calls of perspective's spans from the far ends of lines to the near ones. In bench rows w differs 4 times, less
in short lines; a line grows by a texel a pixel in u and 0.7 in v on the whole.
"""

import numpy as np

from tmap.base.fixed import M32
from tmap.bench.spans import BIAS, GAP, Ground, framed, line_count, table_of
from tmap.bench.trial import Trial, Write
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup import far

#: Row: the most pixels of a piece.
SPANS = {"persp_far_16": 16, "persp_far_8": 8}


def table(arena: Arena) -> int:
    """Adds the table; where its index 0 is."""
    return arena.add(np.array(far.TABLE, ">u2").tobytes()) + (far.ORIGIN - far.LOWEST) * 2


def kernel(k: far.Constants) -> str:
    """The span that draws a polygon with these constants."""
    return f"span_far_{'left' if k.leftwards else 'right'}{'_coarse' if k.coarse else ''}"


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
        ("q", k.q - (k.left + BIAS) * k.dqdx), ("dq", abs(k.dqdx)), ("ku", k.k[0]), ("kv", k.k[1]),
        ("cu", k.c[0]), ("cv", k.c[1]), ("dcu", k.dc[0]), ("dcv", k.dc[1]))}
    plan = arena.struct("far_span", near, dict(row=ground.frame_at - BIAS, map=ground.map_at),
                        count=len(lines), pitch=pitch, dqdx=k.dqdx, dqdy=k.dqdy,
                        most_16=far.MOST[16] if k.longest == 16 else 0, **values)
    return Trial(Case(kernel(k), arena, pointers={"a0": plan}, far=ground.arena), title, writes=writes)


def span_case(longest: int, length: int):
    """A bench row: lines of one length that begin 0 to 3 pixels on."""
    rng, count, memory = np.random.default_rng(length), line_count(length), Arena()
    picture = rng.integers(0, 256, (256, 256), dtype=np.uint8)
    map_at = memory.add(picture.tobytes(), layout.load().constants["ARENA_ALIGN"])
    step = min(3 * (1 << 28) // length, far.MOST[longest] // 2)
    q = 1 << 28, (1 << 28) + length * step
    across = 2.0**38 / q[0] - 2.0**38 / q[1]  # of C r, where C is 1: see far.h
    c = tuple(int(-d * length / across * 65536) for d in (1, 0.7))
    made = far.Constants(tuple(int(n) for n in rng.integers(0, 1 << 32, 2)), c, (0, 0), q[0], step, 0,
                         0, 0, longest, 0, [0, 0])
    ground = framed(memory, map_at, picture, count, length)
    lines = [(k % 4, length) for k in range(count)]
    return span_trial(Arena(), ground, made, lines, length + GAP).row(count * length)
