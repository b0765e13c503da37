"""The packing of struct scanline's start fields, for calls of kernels from the host."""

from tmap.base.fixed import M32
from tmap.build import layout

#: The bits of a start that are used, by form: the middle of v--U is unused.
MASKS = {"addx": {"start0": 0xFFFF, "start1": 0xFFFF, "start2": 0xFF0000FF},
         "plain": {"start0": 0xFFFF, "start1": 0xFFFF, "start2": M32},
         "flat": {}}


def pack(form: str, u: int, v: int) -> dict[str, int]:
    """Returns the start fields of u and v, 16.16."""
    if form == "flat":
        return {}
    if form == "plain":
        return {"start0": u & 0xFFFF, "start1": u >> 16 & 0xFFFF, "start2": v & M32}
    return {"start0": u & 0xFFFF, "start1": v >> 8 & 0xFFFF,
            "start2": (v & 0xFF) << 24 | u >> 16 & 0xFF}


def pack_shade(level: int, added: int = 0) -> int:
    """Returns an entry of struct shade_plan's shades: a level, 16.16, as c-Cc, plus ``added``."""
    return ((level & 0xFF) << 24 | level >> 8 & 0xFFFFFF) + added & M32


def rounded_edge(lines: int, x: int, slope: int, **more: int) -> dict[str, int]:
    """Returns a struct edge of x and slope in 16.16, EDGE_BIAS included in x. No stepper reads
    ``upper``, ``lower`` and ``top``."""
    x += 0xFFFF
    more |= {"upper": 0xDEAD, "lower": 0xDEAD, "top": 0xDEAD}
    return {"lines": lines, "x": x >> 16, "whole": slope >> 16, "error": x << 16 & M32,
            "part": slope << 16 & M32, "height": 0} | more


def add_span_plan(arena, pointers: dict[str, int], far: dict[str, int], **values: int) -> int:
    """Puts a struct span_plan into an arena; fields that are not given are 0."""
    unread = layout.load().struct("span_plan").fields.keys() - pointers.keys() - far.keys()
    return arena.struct("span_plan", pointers, far, **dict.fromkeys(unread, 0) | values)
