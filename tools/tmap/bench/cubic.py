"""Calls of perspective's spans by cubics. In bench rows w differs 4 times, less in short lines; K is 256 texels away
from the far end; a line grows by a texel a pixel in u and 0.7 in v on the whole."""

import numpy as np

from tmap.base.fixed import M32
from tmap.bench.far import line_table
from tmap.bench.spans import GAP, Ground, framed, line_count
from tmap.bench.trial import Trial, Write
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup import cubic

SPANS = {"persp_pixel": "pixel", "persp_fine": "fine"}
BITS = 29  # of q in bench rows, half of 1.31's least


def kernel(k: cubic.Constants) -> str:
    """The span that draws a polygon with these constants."""
    return f"span_cubic_{'left' if k.leftwards else 'right'}"


def plan_fields(k: cubic.Constants) -> dict:
    """What a span's structure has of them."""
    values = {"ku": k.k[0], "kv": k.k[1], "most": k.most, "longest": k.longest - 1, "dq": abs(k.dqdx),
              "top": 1 << k.bits - 2}
    for axis, c, dc in zip("uv", k.c, k.dc):
        values[f"dc{axis}_low"] = dc & M32
    signed = {"shift": k.shift, "unshift": 32 - k.shift, "cu": k.c[0], "cv": k.c[1], "dcu": k.dc[0] >> 32,
              "dcv": k.dc[1] >> 32}
    return {name: n & M32 for name, n in values.items()} | signed | {
        "factors": list(k.factors)}


def span_trial(arena: Arena, ground: Ground, k: cubic.Constants, lines: list[tuple[int, int]], pitch: int,
               title: str = "") -> Trial:
    """One table of lines (first column, pixels); the first is at the constants' ``top``."""
    writes, qs = [], []
    for y, (left, count) in enumerate(lines):
        line = cubic.line(None, k, left, left + count, k.top + y)
        qs.append(line.q)
        if count > 0:
            u, v = cubic.coordinates([line])
            writes.append(Write(ground.frame_at + y * pitch + left,
                                ground.picture[v >> 16 & 255, u >> 16 & 255].tobytes(), far=True))
    near = {"lines": line_table(arena, lines, qs, k.leftwards, ground.frame_at, pitch)}
    plan = arena.struct("cubic_span", near, {"map": ground.map_at}, count=len(lines), **plan_fields(k))
    return Trial(Case(kernel(k), arena, pointers={"a0": plan}, far=ground.arena), title, writes=writes)


def constants(reach: int, setting: str, q: int, dqdx: int, dqdy: int, bits: int, **others) -> cubic.Constants:
    """Constants of a polygon ``reach`` texels from K; q and its steps 1.31, q 2^bits at least. ``others``: k, c, dc."""
    width, *factors = cubic.fit_of(reach, setting)
    dq = abs(dqdx)
    single = dq >= 1 << bits - 3
    return cubic.Constants(
        q=q, dqdx=dqdx, dqdy=dqdy, left=0, top=0, bits=bits, shift=min(13 - reach.bit_length() + bits, 31),
        factors=(0, 0, 0) if single else tuple(-(dq * n >> bits - 3) for n in factors),
        most=0 if single else min(width // dq, 65535), longest=cubic.WAYS[setting][2], raised=[0, 0], down=0,
        farthest=(reach, reach), setting=setting, **others)


def span_case(setting: str, length: int):
    """A bench row: lines of one length that begin 0 to 3 pixels on."""
    rng, count, memory = np.random.default_rng(length), line_count(length), Arena()
    picture = rng.integers(0, 256, (256, 256), dtype=np.uint8)
    map_at = memory.add(picture.tobytes(), layout.load().constants["ARENA_ALIGN"])
    q, reach = 1 << BITS, 256
    step = 3 * q // max(length, 12)
    across = 2.0**31 / q - 2.0**31 / (q + length * step)
    shift = 13 - reach.bit_length() + BITS
    c = tuple(int(-d * length * 65536 / across * 2.0**(shift + 1 - BITS)) for d in (1, 0.7))
    made = constants(reach, setting, q, step, 0, BITS, k=tuple(rng.integers(0, 1 << 32, 2).tolist()), c=c, dc=(0, 0))
    ground = framed(memory, map_at, picture, count, length)
    lines = [(k % 4, length) for k in range(count)]
    return span_trial(Arena(), ground, made, lines, length + GAP).row(count * length)
