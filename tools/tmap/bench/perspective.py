"""Calls of perspective's spans, and of what makes their lines. In bench rows w differs RATIO times.

A row's line grows by a texel a pixel in u and 0.7 in v on the whole; every other line runs
from far to near.
"""

from dataclasses import replace
from functools import partial

import numpy as np

from tmap.base import maps
from tmap.bench.spans import BIAS, GAP, Ground, framed, line_count, table_of
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup.edges import measure
from tmap.setup import level_reciprocal
from tmap.setup.level import level, level_line
from tmap.setup.perspective import (CURVES, EXACT, Ends, Perspective, coordinates, ends, enough,
                                    perspective, steepness, way, weights)
from tmap.setup.scanline import pack
from tmap.setup.texturing import Line

RATIO = 4
NEAR = 1 << 30  # q of the nearer end
LINES = 64
ENOUGH = ("enough4", "enough8", "enough16", "enough32")
#: Row: setting, ratio of w; bytes of a texel, if not one.
SPANS = {"persp_every16_exact": ("every16", RATIO), "persp_every8_exact": ("every8", RATIO),
         "persp_pixel_exact": ("pixel", RATIO), "persp_pixel_fine": ("fine", RATIO),
         "persp_pixel_deep": ("pixel", 100), "persp_pixel_fine_deep": ("fine", 100),
         "persp_every16_wide": ("every16", RATIO, 2), "persp_pixel_wide": ("pixel", RATIO, 2)}


def line(k: int, length: int, ratio: int, rng) -> Ends:
    """Line k of a row."""
    u, v = (int(c) for c in rng.integers(0, 256 << 16, 2))
    made = Ends(k % 4, length - 1, u, v)
    if made.n:
        made.du, made.dv = length << 16, 7 * (length << 16) // 10
        ends = (NEAR, NEAR // ratio)
        made.first, made.last = weights(*(ends if k % 2 else ends[::-1]), made.n)
    return made


def entry(each: Ends, setting: str) -> bytes:
    """The line as perspective_lines leaves it."""
    fields = dict(left=each.left + BIAS, n=each.n, u=each.u, v=each.v,
                  du=each.du, dv=each.dv, weight=each.weight(0), dweight=each.last - each.first,
                  half=each.last >> 1)
    limits = enough(each, setting) if setting in CURVES else []
    fields |= dict(zip(ENOUGH, limits + [0] * (len(ENOUGH) - len(limits))))
    return layout.load().struct("perspective_line").pack(**fields)


def record_table(arena: Arena, struct: str, lines: list, entry) -> int:
    """Adds a table of lines' records, each as ``entry`` packs it; of an empty line only n, which is less
    than 0, is given, and all else is 0."""
    shape = layout.load().struct(struct)
    zeros = dict.fromkeys(shape.fields, 0)
    packed = (shape.pack(**zeros | {"n": each}) if isinstance(each, int) else entry(each)
              for each in lines)
    return arena.add(b"".join(packed), name="lines", shape=shape)


def records_trial(kernel: str, plan: str, arena: Arena, ground: Ground, lines: list, pitch: int,
                  coordinates, near: dict[str, int], title: str = "", **fields: int) -> Trial:
    """A span over a table of records. ``pitch``: in bytes; ``coordinates``: u and v of a line's pixels; ``near``:
    the plan's pointers to the table and others, which are in the arena; ``fields``: more of the plan."""
    writes, wide = [], ground.picture.itemsize
    for k, each in enumerate(lines):
        if not isinstance(each, int):
            u, v = coordinates(each)
            writes.append(Write(ground.frame_at + k * pitch + each.left * wide,
                                ground.picture[v >> 16 & 255, u >> 16 & 255].tobytes(), far=True))
    plan_at = arena.struct(plan, near, dict(row=ground.frame_at - BIAS * wide, map=ground.map_at),
                           count=len(lines), pitch=pitch, **fields)
    return Trial(Case(kernel, arena, pointers={"a0": plan_at}, far=ground.arena), title, writes=writes)


def row_of_records(length: int, line, trial, wide: int = 1):
    """The bench row of a table of lines of one length. ``line`` makes the k-th of k and random numbers,
    ``trial`` the call of an arena, a ground, lines and their pitch; ``wide``: bytes of a texel."""
    rng, count, far = np.random.default_rng(length), line_count(length), Arena()
    picture = rng.integers(0, 256**wide, (256, 256), dtype=f"u{wide}").astype(f">u{wide}")
    map_at = far.add(maps.to_page(picture).tobytes(), layout.load().constants["ARENA_ALIGN"])
    lines = [line(k, rng) for k in range(count)]
    ground = framed(far, map_at + (picture.nbytes // 2 if wide > 1 else 0), picture, count, length)
    return trial(Arena(), ground, lines, (length + GAP) * wide).row(count * length)


def span_trial(setting: str, arena: Arena, ground: Ground, lines: list, pitch: int,
               title: str = "") -> Trial:
    """One table of Ends."""
    kernel = "span_perspective_curves" if setting in CURVES else "span_perspective_pieces"
    kernel += {1: "", 2: "_16", 4: "_32"}[ground.picture.itemsize]
    table = record_table(arena, "perspective_line", lines, lambda each: entry(each, setting))
    return records_trial(kernel, "perspective_span", arena, ground, lines, pitch,
                         lambda each: coordinates(each, setting), dict(lines=table), title,
                         longest=EXACT[setting].bit_length() - 1 if setting in EXACT else way(setting).piece)


def span_case(setting: str, ratio: int, *wide_and_length: int):
    """A table of lines of one length, the last argument; before it may be the bytes of a texel."""
    *wide, length = wide_and_length
    return row_of_records(length, lambda k, rng: line(k, length, ratio, rng),
                          partial(span_trial, setting), *wide)


def plan_of(arena, deep: Perspective, setting: str, count: int, pointers: dict[str, int],
            far: dict[str, int] | None = None, **more: int) -> int:
    """Puts a struct perspective_plan into an arena; ``more``: of its fields; ``far``: its row and map."""
    fields, unread = {}, dict(width=0, spare=0, pitch=0) | ({} if far else dict(row=0, map=0))
    for key, plane in (("q", deep.q), ("s", deep.s), ("t", deep.t)):
        fields[key] = list(b"".join((n % (1 << 64)).to_bytes(8, "big")
                                    for n in (plane.at, plane.dx, plane.dy)))
    limits = {f"{c}_{end}": value for end, pair in (("low", deep.low), ("high", deep.high))
              for c, value in zip("uv", pair)}
    return arena.struct("perspective_plan", pointers, far, count=count, left=deep.i, q_low=deep.least, q_high=deep.most,
                        gentle=deep.gentle, tilt=deep.tilt, chained=int(deep.chained),
                        steep=steepness(deep.q.dx) + 1, u=deep.base[0], v=deep.base[1], bend=way(setting).bend,
                        **fields, **limits, **unread | more)


def polygon_lines():
    """A turned triangle's planes, whose w differs RATIO times, and its LINES (left, right, y)."""
    corners = [(0, 0, 0, 0, 1 << 16), (200 << 16, 10 << 16, 200 << 16, 7 << 16, RATIO << 16),
               (20 << 16, 90 << 16, 30 << 16, 100 << 16, 2 << 16)]
    sides = measure(corners, 256, 10 + LINES)
    return perspective(corners, sides.corners, sides.box), \
        [(5 + y // 8, 60 + y, y) for y in range(LINES)]


def scanlines(arena: Arena, lines) -> int:
    """Puts a table of (left, right, y) into an arena."""
    return arena.add(table_of([{"left": left + BIAS, "last": right - 1 + BIAS}
                               for left, right, _ in lines]), name="lines", shape=layout.load().struct("scanline"))


def add_perspective_plan(arena: Arena, deep: Perspective, lines, to_at: int,
                         setting: str = "every16") -> int:
    """Adds a perspective_plan and its scanline table."""
    return plan_of(arena, deep, setting, len(lines), dict(lines=scanlines(arena, lines), to=to_at))


def level_trial(arena: Arena, deep: Perspective, lines, title: str = "") -> Trial:
    """Lines (left, right, y) as if each had its first pixel's depth."""
    size = layout.load().struct("scanline").size
    lines_at, steps_at = scanlines(arena, lines), arena.room("scanline_step", len(lines), "steps")
    plan_at = plan_of(arena, deep, "every16", len(lines), dict(lines=lines_at, to=steps_at))
    writes = []
    for k, (left, right, y) in enumerate(lines):
        if right > left:
            (u, dudx), (v, dvdx) = level_line(deep, left, right, y)
            writes += fields(lines_at + k * size, "scanline", pack("addx", u, v))
            writes += fields(steps_at + 8 * k, "scanline_step", {"dudx": dudx, "dvdx": dvdx})
    return Trial(Case("level_lines", arena, pointers={"a0": plan_at, "a1": steps_at}), title,
                 writes=writes)


def level_case(tilt: bool = False):
    """LINES lines of a turned triangle; with a tilt, from their first pixels to their last."""
    deep, lines = polygon_lines()
    return level_trial(Arena(), replace(deep, tilt=int(tilt) << 8), lines).row(LINES)


def reciprocal_trial(arena: Arena, deep: Perspective, lines, width: int, spare: int, title: str = "") -> Trial:
    """Lines (left, right, y) of one depth each, by reciprocals, if the planes let them."""
    size = layout.load().struct("scanline").size
    lines_at, steps_at = scanlines(arena, lines), arena.room("scanline_step", len(lines), "steps")
    plan_at = plan_of(arena, deep, "every16", len(lines), dict(lines=lines_at, to=steps_at), width=width, spare=spare)
    writes, deep = [], replace(deep, inverse=level_reciprocal.find(deep, len(lines), width, spare))
    for k, (left, right, y) in enumerate(lines):
        if deep.inverse and right > left:
            (u, dudx), (v, dvdx) = level_line(deep, left, right, y)
            writes += fields(lines_at + k * size, "scanline", pack("addx", u, v))
            writes += fields(steps_at + 8 * k, "scanline_step", {"dudx": dudx, "dvdx": dvdx})
    return Trial(Case("level_reciprocal", arena, pointers={"a0": plan_at, "a1": steps_at}), title,
                 writes=writes, outputs={"d0": int(bool(deep.inverse))})


def draw_trial(arena: Arena, ground: Ground, deep: Perspective, lines, width: int, spare: int, pitch: int,
               upright: bool, title: str = "") -> Trial:
    """``reciprocal_trial`` of lines that are drawn, chained; ``upright``: as columns. ``pitch``: in bytes."""
    along, down = (pitch, 1) if upright else (1, pitch)
    plan_at = plan_of(arena, deep, "every16", len(lines), dict(lines=scanlines(arena, lines), to=0),
                      dict(row=ground.frame_at - BIAS * along, map=ground.map_at), width=width, spare=spare,
                      pitch=pitch)
    writes, deep = [], replace(deep, inverse=level_reciprocal.find(deep, len(lines), width, spare))
    if upright:
        level_reciprocal.settle_still(deep, width)
    for k, (left, right, y) in enumerate(lines):
        if deep.inverse and right > left:
            at, (u, v) = ground.frame_at + k * down + left * along, level(deep, [Line(left, right)], [y])
            seen = ground.picture[v >> 16 & 255, u >> 16 & 255]
            writes += [Write(at + j * along, seen[j:j + 1].tobytes(), far=True) for j in range(len(seen))] \
                if upright else [Write(at, seen.tobytes(), far=True)]
    return Trial(Case("level_draw_upright" if upright else "level_draw", arena, pointers={"a0": plan_at},
                      far=ground.arena), title, writes=writes, outputs={"d0": int(bool(deep.inverse))})


def reciprocal_case():
    """LINES lines of a turned triangle whose depth changes from line to line alone."""
    deep, lines = polygon_lines()
    deep.q.dx = 0
    trial = reciprocal_trial(Arena(), deep, lines, 300, 300)
    if not trial.outputs["d0"]:
        raise ValueError("no reciprocals")
    return trial.row(LINES)


def lines_trial(setting: str, arena: Arena, deep: Perspective, lines, title: str = "") -> Trial:
    """Lines (left, right, y), empty ones and single pixels among them."""
    shape, out = layout.load().struct("perspective_line"), arena.room("perspective_line", len(lines))
    longest, writes = shape.fields[ENOUGH[3]]["offset"], []
    for k, (left, right, y) in enumerate(lines):
        at, wanted = out + k * shape.size, {"n": right - left - 1, "left": left + BIAS}
        if setting == "fine":  # no piece is so long
            writes.append(anything(at + longest, 4))
        if right > left:
            found = shape.unpack(entry(ends(deep, left, right, y), setting))
            unread = found.keys() - {*wanted, "u", "v"} if right - left == 1 else \
                ENOUGH if setting not in CURVES else ENOUGH[3:] if setting == "fine" else ()
            wanted = {name: value for name, value in found.items() if name not in unread}
        writes += fields(at, "perspective_line", wanted)
    plan_at = add_perspective_plan(arena, deep, lines, out, setting)
    return Trial(Case("perspective_lines", arena, pointers={"a0": plan_at}), title, writes=writes)


def lines_case(setting: str):
    """LINES lines of a turned triangle."""
    return lines_trial(setting, Arena(), *polygon_lines()).row(LINES)
