"""Trials of perspective: planes against exact fractions, lines and spans against the model."""

from fractions import Fraction

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.math import any_size
from tests.kernels.trials.span import BIAS, FRAME, picture_memory, texture
from tmap.base.fixed import signed
from tmap.bench import perspective
from tmap.bench.trial import Trial, Write, fields_check, first_of, values
from tmap.build import layout
from tmap.guest.kernels import M32, Case
from tmap.setup import perspective as model
from tmap.setup.scanline import pack

M64 = (1 << 64) - 1
PITCH = 1152
CURVES = model.CURVES
#: Depths of a line's ends: q in the polygon's scale.
Q_ENDS = ((1 << 30, 1 << 30), (1 << 30, 1 << 29), (1 << 28, 1 << 30), (1 << 30, (1 << 30) // 100),
          ((1 << 30) // 1000, 1 << 30), (256, 1 << 30), (1 << 30, 256), (257, 256), (256, 256),
          ((1 << 30) - 1, 1 << 30), (1 << 30, (1 << 30) - 70000))


def longs(*numbers: int) -> list[int]:
    """Numbers of 64 bits as the bytes of a field."""
    return list(b"".join((n & M64).to_bytes(8, "big") for n in numbers))


def planes_trial(rng) -> Trial:
    """Three planes through three corners of any kind."""
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
    out = memory.room("found_planes")
    cut = max(area.bit_length() - 32, 0)

    def divided(n: int) -> int:
        n, sign = abs(n), -1 if n < 0 else 1
        return sign * (((n >> cut) << 32) // (area >> cut))

    expected = b""
    worst = None
    for k in range(2, 5):
        n = rows[1][k] * b[1] - rows[2][k] * a[1], a[0] * rows[2][k] - b[0] * rows[1][k]
        dx, dy = map(divided, n)
        for found, exact in zip((dx, dy), (Fraction(part << 32, area) for part in n)):
            if abs(found - exact) > abs(exact) / 2**31 + 3:
                worst = f"the reference itself is off: {found}, exact {float(exact)}"
        # each gradient is what its 64 bits say
        dx, dy = signed(dx, 64), signed(dy, 64)
        numbers = (rows[0][k] << 16) + (dx * x >> 16) + (dy * y >> 16), dx, dy
        expected += bytes(longs(*numbers))
    return Trial(Case("planes_find", memory, pointers={"a0": out, "a1": at}),
                 values(x=x, y=y) + f", a {a}, b {b}", writes=[Write(out, expected)],
                 also=lambda _: worst)


def any_plane(rng, value: int) -> model.Plane:
    """A plane about a value of 64 bits."""
    return model.Plane(value, any_size(rng, 50), any_size(rng, 50))


def any_perspective(rng) -> model.Perspective:
    """Planes that may lead anywhere."""
    scale, reach = int(rng.integers(16, 32)), int(rng.integers(17, 30))
    least = 1 << int(rng.integers(8, 30))
    q = any_plane(rng, int(rng.integers(least, (1 << 30) + 1)) << 32)
    return model.Perspective(q, any_plane(rng, any_size(rng, 30) << scale),
                             any_plane(rng, any_size(rng, 30) << scale), int(rng.integers(0, 40)), 0,
                             tuple(any_size(rng, 13) << 16 for _ in "uv"), scale, least,
                             tuple(-abs(any_size(rng, reach)) for _ in "uv"),
                             tuple(abs(any_size(rng, reach)) for _ in "uv"))


def lines_trial(setting: str, rng) -> Trial:
    """Some lines, empty ones and single pixels among them."""
    count, deep = int(rng.integers(1, 8)), any_perspective(rng)
    memory, shapes = Memory(), layout.load()
    entry, shape = shapes.struct("scanline"), shapes.struct("perspective_line")
    out = memory.room("perspective_line", count)
    table, parts = b"", []
    for k in range(count):
        left = deep.i + int(rng.integers(0, 900))
        pixels = int(rng.choice((0, -5, 1, 2, 3, 4, 17, 33, 300)))
        table += entry.pack(left=left + BIAS, last=left + pixels - 1 + BIAS, start0=0, start1=0,
                            start2=0)
        wanted = {"n": pixels - 1, "left": left + BIAS}
        if pixels > 0:
            line = model.ends(deep, left, left + pixels, k)
            wanted = shape.unpack(perspective.entry(line, setting))
            if pixels == 1:
                wanted = {field: wanted[field] for field in ("left", "n", "u", "v")}
            elif setting not in CURVES:
                wanted = {f: n for f, n in wanted.items() if f not in perspective.ENOUGH}
            elif setting == "fine":  # no piece is so long
                del wanted["enough32"]
        parts.append(fields_check(out + k * shape.size, "perspective_line", wanted, {}, f"line {k}"))
    writes = [write for part in parts for write in part[0]]
    if setting == "fine":
        field = shape.fields["enough32"]["offset"]
        writes += [Write(out + k * shape.size + field, bytes(4), bytes(4)) for k in range(count)]
    at = perspective.plan_of(memory, deep, setting, count, dict(
        lines=memory.add(table, name="lines", shape=entry), to=out))
    return Trial(Case("perspective_lines", memory, pointers={"a0": at}),
                 f"{setting}, {count} lines, {deep}", writes=writes,
                 also=first_of([part[1] for part in parts]))


def level_trial(rng) -> Trial:
    """Lines of which only the first pixel's q counts."""
    count, deep = int(rng.integers(1, 8)), any_perspective(rng)
    memory, shapes = Memory(), layout.load()
    entry = shapes.struct("scanline")
    rows, parts = [], []
    out = memory.room("scanline_step", count)
    for k in range(count):
        left, pixels = deep.i + int(rng.integers(0, 900)), int(rng.choice((0, -5, 1, 2, 300)))
        rows.append((left, pixels))
    table = b"".join(entry.pack(left=left + BIAS, last=left + pixels - 1 + BIAS, start0=0, start1=0,
                                start2=0) for left, pixels in rows)
    lines = memory.add(table, name="lines", shape=entry)
    for k, (left, pixels) in enumerate(rows):
        if pixels > 0:
            u, v = (c.tolist() for c in model.level(deep, left, left + 2, k))
            parts.append(fields_check(lines + k * entry.size, "scanline", pack("addx", u[0], v[0]), {},
                                      f"line {k}"))
            parts.append(fields_check(out + 8 * k, "scanline_step",
                                      {"dudx": signed(u[1] - u[0]), "dvdx": signed(v[1] - v[0])}, {},
                                      f"step {k}"))
    at = perspective.plan_of(memory, deep, "every16", count, dict(lines=lines, to=out))
    return Trial(Case("level_lines", memory, pointers={"a0": at, "a1": out}),
                 f"{count} lines, {deep}", writes=[w for part in parts for w in part[0]],
                 also=first_of([part[1] for part in parts]))


def span_trial(setting: str, counts, ends, reach: int, rng) -> Trial:
    """A table of lines between ends of such depths."""
    far, frame_at, map_at = picture_memory()
    memory = Memory(int(rng.integers(1 << 30)))
    shape = layout.load().struct("perspective_line")
    table, writes = b"", []
    for k, pixels in enumerate(counts):
        left = k % 4
        line = model.Ends(left, pixels - 1, any_size(rng, 31) & M32, any_size(rng, 31) & M32)
        if pixels > 1:
            line.du, line.dv = any_size(rng, reach), any_size(rng, reach)
            line.first, line.last = model.weights(*ends, line.n)
        if pixels > 0:
            table += perspective.entry(line, setting)
            u, v = model.coordinates(line, setting)
            writes.append(Write(frame_at + 64 + k * PITCH + left,
                                texture()[v >> 16 & 255, u >> 16 & 255].tobytes(), far=True))
        else:
            table += shape.pack(**dict.fromkeys(shape.fields, 0) | {"n": pixels - 1})
    at = memory.struct("perspective_span", dict(lines=memory.add(table, name="lines", shape=shape)),
                       dict(row=frame_at + 64 - BIAS, map=map_at), count=len(counts), pitch=PITCH,
                       longest=model.way(setting).piece)
    kernel = "span_perspective_curves" if setting in CURVES else "span_perspective_pieces"
    return Trial(Case(kernel, memory, pointers={"a0": at}, far=far),
                 f"{setting}, q {ends}, {reach} bits of u and v", writes=writes)


def span_trials(settings, rng) -> list[Trial]:
    counts = [*range(1, 20), 0, -3, *range(30, 35), 47, 48, 49, 64, 65, 100, 256, 257, 320, 1024]
    lines = FRAME // PITCH - 1
    return [span_trial(setting, counts[:lines], ends, reach, rng) for setting in settings
            for ends in Q_ENDS for reach in (31, 24, 20, 12)]


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    rng = np.random.default_rng(5)
    every = ("every16", "every8", "pixel", "fine")
    return [*(planes_trial(rng) for _ in range(120)),
            *(level_trial(rng) for _ in range(60)),
            *(lines_trial(setting, rng) for setting in every for _ in range(40)),
            *span_trials(every[:2], rng), *span_trials(every[2:], rng)]
