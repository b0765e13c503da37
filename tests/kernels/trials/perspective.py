"""Trials of perspective: planes against exact fractions, lines and spans against the model."""

from bisect import bisect_left
from fractions import Fraction

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.math import any_size
from tests.kernels.trials.far import COUNTS, PITCH
from tests.kernels.trials.span import picture_ground
from tests.kernels.trials.wide import ground
from tmap.base.fixed import mul_div, signed
from tmap.bench import perspective
from tmap.bench.trial import Trial, Write, fields, values
from tmap.build import layout
from tmap.guest.kernels import M32, Case
from tmap.setup import perspective as model
from tmap.setup.level import bends
from tmap.setup.level_reciprocal import find
from tmap.setup.texturing import Line

SOME = [count for count in COUNTS if count < 260]  # that fit in rows of PITCH bytes
M64 = (1 << 64) - 1
#: Depths of a line's ends: q in the polygon's scale.
Q_ENDS = ((1 << 30, 1 << 30), (1 << 30, 1 << 29), (1 << 28, 1 << 30), (1 << 30, (1 << 30) // 100),
          ((1 << 30) // 1000, 1 << 30), (256, 1 << 30), (1 << 30, 256), (257, 256), (256, 256),
          ((1 << 30) - 1, 1 << 30), (1 << 30, (1 << 30) - 70000))


def longs(*numbers: int) -> list[int]:
    return list(b"".join((n & M64).to_bytes(8, "big") for n in numbers))


def planes_trial(rng, kernel: str, out: str, keys: range) -> Trial:
    """Planes through three corners of any kind. ``out``: the struct; ``keys``: their values, q, s and t being 2
    to 4."""
    reach = int(rng.integers(4, 31))
    while True:
        a, b = ([any_size(rng, reach) for _ in range(2)] for _ in range(2))
        area = a[0] * b[1] - b[0] * a[1]
        if area < 0:
            a, b, area = b, a, -area
        if 0 < area < 1 << 63:
            break
    first = [any_size(rng, 29) for _ in range(2)]
    corners = [[any_size(rng, 30) for _ in range(3)] for _ in range(3)]
    x, y = any_size(rng, 31), any_size(rng, 31)
    memory = Memory()
    names = "xyqst"
    rows = [first + corners[0], *([*way, *(c - o for c, o in zip(corner, corners[0]))]
                                  for way, corner in ((a, corners[1]), (b, corners[2])))]
    shape = layout.load().struct("plane_corner")
    at = memory.struct("plane_corners", {}, area=list(area.to_bytes(8, "big")), x=x, y=y,
                       **{field: list(shape.pack(**dict(zip(names, row))))
                          for field, row in zip(("first", "a", "b"), rows)})
    out = memory.room(out)
    cut = max(area.bit_length() - 32, 0)

    def divided(n: int) -> int:
        n, sign = abs(n), -1 if n < 0 else 1
        return sign * (((n >> cut) << 32) // (area >> cut))

    expected = b""
    worst = None
    for k in keys:
        n = rows[1][k] * b[1] - rows[2][k] * a[1], a[0] * rows[2][k] - b[0] * rows[1][k]
        dx, dy = map(divided, n)
        for found, exact in zip((dx, dy), (Fraction(part << 32, area) for part in n)):
            if abs(found - exact) > abs(exact) / 2**31 + 3:
                worst = f"the reference itself is off: {found}, exact {float(exact)}"
        # each gradient is what its 64 bits say
        dx, dy = signed(dx, 64), signed(dy, 64)
        numbers = (rows[0][k] << 16) + (dx * x >> 16) + (dy * y >> 16), dx, dy
        expected += bytes(longs(*numbers))
    return Trial(Case(kernel, memory, pointers={"a0": out, "a1": at}),
                 values(x=x, y=y) + f", a {a}, b {b}", writes=[Write(out, expected)],
                 also=lambda _: worst)


def ranges_trial(rng) -> Trial:
    """Vertices of any number, whose u and v are near each other or far apart."""
    memory, count = Memory(), int(rng.integers(3, 9))
    reach = int(rng.integers(5, 30))
    base = [any_size(rng, 29) for _ in "uv"]
    rows = [[*(b + any_size(rng, reach) for b in base), int(2.0 ** rng.uniform(0, 31))] for _ in range(count)]
    shape = layout.load().struct("vertex")
    vertices = memory.add(b"".join(shape.pack(x=0, y=0, s=u, t=v, shade=0, w=w) for u, v, w in rows),
                          name="vertices", shape=shape)
    source, plan = memory.room("corner_source"), memory.room("perspective_plan")
    low, high = ([way(row[k] for row in rows) for k in range(2)] for way in (min, max))
    middles = [(a + b >> 1) & ~0xFFFF for a, b in zip(low, high)]
    low, high = ([n - b for n, b in zip(ends, middles)] for ends in (low, high))
    farthest = max(0, *high, *(-n for n in low))
    limits = {f"{c}_{end}": n for end, ends in (("low", low), ("high", high)) for c, n in zip("uv", ends)}
    writes = fields(source, "corner_source", dict(zip("uv", middles)) | {
        "nearest": min(row[2] for row in rows), "scale": max(16, farthest.bit_length())})
    writes += fields(plan, "perspective_plan", limits | {c: b + 1 for c, b in zip("uv", middles)})
    return Trial(Case("ranges_find", memory, {"d1": count}, {"a0": source, "a1": plan, "d0": vertices}),
                 f"{rows}", writes=writes)


def corners_trial(rng) -> Trial:
    """Three vertices of any depth, u and v near a base."""
    memory, nearest = Memory(), int(2.0 ** rng.uniform(0, 30))
    scale, base = int(rng.integers(16, 30)), [any_size(rng, 28) for _ in "uv"]
    reach = (1 << scale) - 1
    vertices, rows = {}, []
    for name in ("first", "a", "b"):
        w = int(nearest * 2.0 ** rng.uniform(0, 31 - nearest.bit_length()))
        x, y = any_size(rng, 29), any_size(rng, 29)
        u, v = (b + int(rng.integers(-reach, reach + 1)) for b in base)
        vertices[name] = memory.struct("vertex", {}, x=x, y=y, s=u, t=v, shade=0, w=w)
        q = mul_div(nearest, model.Q_ONE, w)
        rows.append([x, y, q, *((c - near) * q >> scale for c, near in zip((u, v), base))])
    source = memory.struct("corner_source", vertices, u=base[0], v=base[1], nearest=nearest, scale=scale)
    out = memory.room("plane_corners")
    shape = layout.load().struct("plane_corner")
    rows[1:] = [[c - o for c, o in zip(row, rows[0])] for row in rows[1:]]
    writes = [Write(out + k * shape.size, shape.pack(**dict(zip("xyqst", row)))) for k, row in enumerate(rows)]
    return Trial(Case("corners_find", memory, pointers={"a0": out, "a1": source}),
                 f"w from {nearest}, scale {scale}", writes=writes)


def any_plane(rng, value: int) -> model.Plane:
    return model.Plane(value, any_size(rng, 50), any_size(rng, 50))


def any_perspective(rng) -> model.Perspective:
    """Planes that may lead anywhere."""
    scale, reach = int(rng.integers(16, 32)), int(rng.integers(17, 30))
    least = 1 << int(rng.integers(8, 30))
    q = any_plane(rng, int(rng.integers(least, (1 << 30) + 1)) << 32)
    return model.Perspective(q, any_plane(rng, any_size(rng, 30) << scale),
                             any_plane(rng, any_size(rng, 30) << scale), int(rng.integers(0, 40)), 0,
                             tuple(any_size(rng, 13) << 16 for _ in "uv"), scale, least, 1 << 30,
                             tuple(-abs(any_size(rng, reach)) for _ in "uv"),
                             tuple(abs(any_size(rng, reach)) for _ in "uv"))


def lines_and_planes(pixels, rng) -> tuple[list[tuple[int, int, int]], model.Perspective]:
    """Up to 7 lines (left, right, y), each of some of these pixels, and planes."""
    count, deep, lines = int(rng.integers(1, 8)), any_perspective(rng), []
    for k in range(count):
        left = deep.i + int(rng.integers(0, 900))
        lines.append((left, left + int(rng.choice(pixels)), k))
    return lines, deep


def lines_trial(setting: str, rng) -> Trial:
    """Some lines, empty ones and single pixels among them."""
    lines, deep = lines_and_planes((0, -5, 1, 2, 3, 4, 17, 33, 300), rng)
    return perspective.lines_trial(setting, Memory(), deep, lines,
                                   f"{setting}, {len(lines)} lines, {deep}")


def level_trial(rng, is_held: bool = False) -> Trial:
    """Lines of which only the first pixel's q counts, and its growth there in every other table. ``is_held``: the
    first pixels of most are held below the range's end."""
    lines, deep = lines_and_planes((0, -5, 1, 2, 300), rng)
    if is_held:
        deep.high = tuple(int(rng.integers(1 << 12)) for _ in "uv")
        deep.s.at, deep.t.at = abs(deep.s.at), abs(deep.t.at)
    deep.tilt = int(rng.integers(0, 2)) * any_size(rng, 30)
    deep.chained = bool(rng.integers(2))
    if rng.integers(2):  # steps that q divides
        deep.tilt = deep.q.dx = deep.q.dy = 0
        for plane in (deep.s, deep.t):
            plane.dx = (deep.q.at >> 32) * int(rng.integers(-1 << 18, 1 << 18))
    return perspective.level_trial(Memory(), deep, lines, f"{len(lines)} lines, {deep}")


def reciprocal_trial(rng, drawn: str = "") -> Trial:
    """Lines of a depth of their own, seen anyhow, with gaps; many a trial's numbers do not fit. ``drawn``: "lines" or
    "columns", which are drawn too."""
    lines, deep = lines_and_planes((0, -5, 1, 2, 15, 16, 17, 33, 300), rng)
    count, width = len(lines), int(rng.choice([1200, 1000, 500]))
    if rng.integers(4):  # a plane in space: s and t are between their limits at two lines' left, 1.0 or less deep
        ends = [int(2.0 ** rng.uniform(rng.integers(16, 30), 30)) << 32 for _ in range(2)]
        deep.q.at, deep.q.dy = ends[0], (ends[1] - ends[0]) // max(count - 1, 1)
        for plane, high in ((deep.s, deep.high[0]), (deep.t, deep.high[1])):
            at = [int(rng.integers(-high, high + 1)) * (end >> 32) for end in ends]
            plane.at, plane.dy = at[0], (at[1] - at[0]) // max(count - 1, 1)
            plane.dx = any_size(rng, 40)
        deep.q.dx = any_size(rng, 20) * int(rng.integers(2))
        if drawn == "columns" and rng.integers(2):  # u has no step
            deep.s.dx = 0
        elif rng.integers(3) == 0:  # v has none
            deep.t.dx = 0
    deep.chained, spare = bool(rng.integers(2) or drawn), int(rng.choice([50, 500, 1 << 20]))
    if not drawn and rng.integers(2) and find(deep, count, width, 1 << 20):  # the least that is enough, or one less
        least = bisect_left(range(1 << 20), True, key=lambda some: bool(find(deep, count, width, some)))
        spare = least - int(rng.integers(2))
    if drawn:
        upright, memory = drawn == "columns", Memory(int(rng.integers(1 << 30)))
        return perspective.draw_trial(memory, picture_ground(), deep, lines, width, spare, 8 if upright else 1280,
                                      upright, f"{count} {drawn}, {spare} spare, {deep}")
    return perspective.reciprocal_trial(Memory(), deep, lines, width, spare, f"{count} lines, {spare} spare, {deep}")


def bend_trial(rng) -> Trial:
    """Lines on both sides of what may be straight."""
    lines, deep = lines_and_planes((0, -5, 1, 2, 90, 300), rng)
    steep, width = int(rng.integers(1, 1 << int(rng.integers(1, 12)))), int(rng.integers(300, 512))
    slope = steep - 1 if rng.integers(2) else -steep
    deep.q.dx, deep.tilt = slope * (1 << 32) + int(rng.integers(1, 1 << 32)), slope << 8
    longest = max(max(right - left for left, right, _ in lines), 2)
    limit = steep * longest**2 // 2
    deep.q.at = (limit + int(rng.integers(-limit // 8 - 9, limit // 8 + 9))) % (1 << 30) << 32
    deep.q.dy = int(rng.integers(-limit // 20 - 2, limit // 20 + 2)) << 32
    memory = Memory()
    plan = perspective.plan_of(memory, deep, "every16", len(lines), dict(lines=perspective.scanlines(memory, lines),
                                                                         to=0))
    found = bends(deep, [Line(left, right) for left, right, _ in lines], width)
    return Trial(Case("lines_bend", memory, {"d0": width}, {"a0": plan}), f"{lines}, {width}, {deep}",
                 outputs={"d0": int(found)})


def span_trial(setting: str, ends, reach: int, rng, wide: int = 1) -> Trial:
    """A table of lines between ends of such depths. ``wide``: bytes of a texel."""
    memory, lines = Memory(int(rng.integers(1 << 30))), []
    for k, pixels in enumerate(COUNTS if wide == 1 else SOME):
        line = model.Ends(k % 4, pixels - 1, any_size(rng, 31) & M32, any_size(rng, 31) & M32)
        if pixels > 1:
            line.du, line.dv = any_size(rng, reach), any_size(rng, reach)
            line.first, line.last = model.weights(*ends, line.n)
        lines.append(line if pixels > 0 else line.n)
    return perspective.span_trial(setting, memory, picture_ground() if wide == 1 else ground(wide), lines, PITCH,
                                  f"{setting}, q {ends}, {reach} bits of u and v")


def trials() -> list[Trial]:
    rng = np.random.default_rng(5)
    every = ("every16", "every8", "pixel", "fine")
    spans = ("every32", "every64", *every)
    return [*(planes_trial(rng, "depth_plane_find", "screen_plane", range(2, 3)) for _ in range(60)),
            *(planes_trial(rng, "texel_planes_find", "texel_planes", range(3, 5)) for _ in range(60)),
            *(ranges_trial(rng) for _ in range(60)),
            *(corners_trial(rng) for _ in range(60)),
            *(level_trial(rng, held) for held in (False, True) for _ in range(60)),
            *(reciprocal_trial(rng, drawn) for drawn in ("", "lines", "columns") for _ in range(160)),
            *(bend_trial(rng) for _ in range(80)),
            *(lines_trial(setting, rng) for setting in every for _ in range(40)),
            *(span_trial(setting, ends, reach, rng) for setting in spans for ends in Q_ENDS
              for reach in (31, 24, 20, 12)),
            *(span_trial(setting, ends, reach, rng, wide) for wide in (2, 4) for setting in spans
              for ends in Q_ENDS[1::3] for reach in (24, 20, 12))]
