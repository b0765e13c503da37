"""Calls of perspective's spans from the far ends of lines to the near ones. In bench rows w differs 4 times, less
in short lines; a line grows by a texel a pixel in u and 0.7 in v on the whole.
"""

import numpy as np

from tmap.base.fixed import M32, signed
from tmap.bench.spans import BIAS, GAP, Ground, framed, line_count, table_of
from tmap.bench.trial import Trial, Write
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup import far, far_planes

#: Row: the most pixels of a piece, whether by planes of u and v, whether all pieces have so many.
SPANS = {"persp_far_16": (16, False, False), "persp_far_8": (8, False, False),
         "persp_planes_16": (16, True, False), "persp_even_16": (16, False, True),
         "persp_even_8": (8, False, True)}


def table(arena: Arena) -> int:
    """Adds the table; where its index 0 is."""
    return arena.add(np.array(far.TABLE, ">u2").tobytes()) + (far.ORIGIN - far.LOWEST) * 2


def kernel(k: far.Constants | far_planes.Constants) -> str:
    """The span that draws a polygon with these constants."""
    way = "left" if k.leftwards else "right"
    if isinstance(k, far_planes.Constants):
        return f"span_far_planes_{way}"
    return f"span_far_{'even_' if k.even else ''}{way}{'_coarse' if k.coarse else ''}"


def plan_fields(k: far.Constants | far_planes.Constants) -> dict:
    """What a span's structure has of them."""
    bias = k.left + BIAS
    most = {f"most_{pixels}": far.LENGTHS[k.longest][pixels] for pixels in (16, 8, 4, 2)}
    lengths = layout.load().struct("far_lengths").pack(**most)
    found = {"q": k.q - bias * k.dqdx & M32, "lengths": list(lengths)}
    if isinstance(k, far_planes.Constants):
        for name, (at, dx, dy) in zip("st", k.st):
            found |= {name: signed(at - bias * dx), f"d{name}dx": dx, f"d{name}dy": dy}
        return found | dict(zip("uv", k.base))
    values = {"dq": abs(k.dqdx), "ku": k.k[0], "kv": k.k[1], "cu": k.c[0], "cv": k.c[1], "dcu": k.dc[0],
              "dcv": k.dc[1], "even": max(k.even.bit_length() - 1, 0)}
    return found | {name: n & M32 for name, n in values.items()}


def span_trial(arena: Arena, ground: Ground, k: far.Constants | far_planes.Constants, lines: list[tuple[int, int]],
               pitch: int, title: str = "") -> Trial:
    """One table of lines (first column, pixels); the first is at the constants' ``top``."""
    writes, planes = [], isinstance(k, far_planes.Constants)
    model = far_planes if planes else far
    for y, (left, count) in enumerate(lines):
        if count > 0:
            u, v = model.coordinates(model.line(None, k, left, left + count, k.top + y))
            writes.append(Write(ground.frame_at + y * pitch + left,
                                ground.picture[v >> 16 & 255, u >> 16 & 255].tobytes(), far=True))
    entries = table_of([{"left": left + BIAS, "last": left + count - 1 + BIAS} for left, count in lines])
    near = {"lines": arena.add(entries, name="lines", shape=layout.load().struct("scanline")),
            "table": table(arena)}
    plan = arena.struct("far_planes_span" if planes else "far_span", near,
                        dict(row=ground.frame_at - BIAS, map=ground.map_at), count=len(lines), pitch=pitch,
                        dqdx=k.dqdx, dqdy=k.dqdy, **plan_fields(k))
    return Trial(Case(kernel(k), arena, pointers={"a0": plan}, far=ground.arena), title, writes=writes)


def span_case(longest: int, planes: bool, even: bool, length: int):
    """A bench row: lines of one length that begin 0 to 3 pixels on."""
    rng, count, memory = np.random.default_rng(length), line_count(length), Arena()
    picture = rng.integers(0, 256, (256, 256), dtype=np.uint8)
    map_at = memory.add(picture.tobytes(), layout.load().constants["ARENA_ALIGN"])
    step = min(3 * (1 << 28) // length, far.LENGTHS[longest][longest] // 2)
    q = 1 << 28, (1 << 28) + length * step
    any_two = rng.integers(0, 1 << 32, 2)
    if planes:  # from 0 on
        st = tuple((0, int(d * q[1] / 4096), 0) for d in (1, 0.7))
        made = far_planes.Constants(q[0], step, 0, st, tuple(map(signed, any_two.tolist())), 0, 0, longest, [0, 0])
    else:
        across = 2.0**38 / q[0] - 2.0**38 / q[1]  # of C r, where C is 1: see far.h
        c = tuple(int(-d * length / across * 65536) for d in (1, 0.7))
        made = far.Constants(tuple(any_two.tolist()), c, (0, 0), q[0], step, 0, 0, 0, longest, 0, [0, 0],
                             longest * even)
    ground = framed(memory, map_at, picture, count, length)
    lines = [(k % 4, length) for k in range(count)]
    return span_trial(Arena(), ground, made, lines, length + GAP).row(count * length)
