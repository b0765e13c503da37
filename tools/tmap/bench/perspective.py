"""Bench rows of perspective: spans whose w differs RATIO times, and what a line costs before.

The line grows by a texel a pixel in u and 0.7 in v on the whole; every other line runs
from far to near.
"""

import numpy as np

from tmap.bench.spans import GAP, first_difference, line_count
from tmap.build import layout
from tmap.guest.kernels import Arena, Case, Result
from tmap.setup.edges import measure
from tmap.setup.perspective import (CURVES, Ends, Perspective, coordinates, ends, enough, level,
                                    perspective, way, weights)
from tmap.setup.scanline import MASKS, pack

RATIO = 4
NEAR = 1 << 30  # q of the nearer end
LINES = 64
ENOUGH = ("enough4", "enough8", "enough16", "enough32")
#: Row: setting, ratio of w.
SPANS = {"persp_every16_exact": ("every16", RATIO), "persp_every8_exact": ("every8", RATIO),
         "persp_pixel_exact": ("pixel", RATIO), "persp_pixel_fine": ("fine", RATIO),
         "persp_pixel_deep": ("pixel", 100), "persp_pixel_fine_deep": ("fine", 100)}


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
    shapes = layout.load()
    fields = dict(left=each.left + shapes.constants["EDGE_BIAS"], n=each.n, u=each.u, v=each.v,
                  du=each.du, dv=each.dv, weight=each.weight(0), dweight=each.last - each.first,
                  half=each.last >> 1)
    limits = enough(each, setting) if setting in CURVES else []
    fields |= dict(zip(ENOUGH, limits + [0] * (len(ENOUGH) - len(limits))))
    return shapes.struct("perspective_line").pack(**fields)


def case_of_lines(kernel: str, plan: str, length: int, line, coordinates, near, **fields):
    """A span over a table of lines of one length. ``line`` makes the k-th of k and random numbers,
    ``coordinates`` are u and v of its pixels; ``near`` puts lines and tables into an arena, the
    pointers to them are the plan's, as ``fields`` are."""
    rng = np.random.default_rng(length)
    count, pitch = line_count(length), length + GAP
    shapes = layout.load()
    arena, far = Arena(), Arena()
    picture = rng.integers(0, 256, (256, 256), dtype=np.uint8)
    map_at = far.add(picture.tobytes(), shapes.constants["ARENA_ALIGN"])
    lines = [line(k, rng) for k in range(count)]
    expected = np.zeros((count, pitch), np.uint8)
    for k, each in enumerate(lines):
        u, v = coordinates(each)
        expected[k, each.left:each.left + length] = picture[v >> 16 & 255, u >> 16 & 255]
    frame_at = far.add(bytes(pitch * count))
    plan_at = arena.struct(plan, near(arena, lines),
                           dict(row=frame_at - shapes.constants["EDGE_BIAS"], map=map_at),
                           count=count, pitch=pitch, **fields)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.far_memory, np.uint8, expected.size, frame_at)
        return first_difference(expected, found.reshape(expected.shape))

    return count * length, Case(kernel, arena, pointers={"a0": plan_at}, far=far), check


def first_wrong_line(shape, found: bytes, entries: list[bytes], but=()) -> str | None:
    """Of a table of structs: the first field that is another than expected, ``but`` for some."""
    for k, expected in enumerate(entries):
        made = shape.unpack(found[k * shape.size:(k + 1) * shape.size])
        for field, value in shape.unpack(expected).items():
            if made[field] != value and field not in but:
                return f"line {k}: {field} is {made[field]}, expected {value}"
    return None


def span_case(setting: str, ratio: int, length: int):
    """A table of lines of one length."""
    return case_of_lines(
        "span_perspective_curves" if setting in CURVES else "span_perspective_pieces",
        "perspective_span", length, lambda k, rng: line(k, length, ratio, rng),
        lambda each: coordinates(each, setting),
        lambda arena, lines: dict(lines=arena.add(b"".join(entry(each, setting) for each in lines))),
        longest=way(setting).piece)


def plan_of(arena, deep: Perspective, setting: str, count: int, pointers: dict[str, int]) -> int:
    """Puts a struct perspective_plan into an arena."""
    fields = {}
    for key, plane in (("q", deep.q), ("s", deep.s), ("t", deep.t)):
        fields[key] = list(b"".join((n % (1 << 64)).to_bytes(8, "big")
                                    for n in (plane.at, plane.dx, plane.dy)))
    limits = {f"{c}_{end}": value for end, pair in (("low", deep.low), ("high", deep.high))
              for c, value in zip("uv", pair)}
    return arena.struct("perspective_plan", pointers, count=count, left=deep.i, q_low=deep.least,
                        gentle=deep.gentle, u=deep.base[0], v=deep.base[1], bend=way(setting).bend,
                        **fields, **limits)


def polygon_lines():
    """The planes of a turned triangle whose w differs RATIO times, and (left, right, y) of
    LINES lines."""
    corners = [(0, 0, 0, 0, 1 << 16), (200 << 16, 10 << 16, 200 << 16, 7 << 16, RATIO << 16),
               (20 << 16, 90 << 16, 30 << 16, 100 << 16, 2 << 16)]
    sides = measure(corners, 256, 10 + LINES)
    return perspective(corners, sides.corners, sides.box), \
        [(5 + y // 8, 60 + y, y) for y in range(LINES)]


def scanlines(arena, lines) -> int:
    """Puts a table of (left, right, y) into an arena."""
    shapes = layout.load()
    bias = shapes.constants["EDGE_BIAS"]
    return arena.add(b"".join(shapes.struct("scanline").pack(
        left=left + bias, last=right - 1 + bias, start0=0, start1=0, start2=0)
        for left, right, _ in lines))


def add_perspective_plan(arena: Arena, deep: Perspective, lines, to_at: int, setting: str = "every16") -> int:
    """Adds a perspective_plan and its scanline table."""
    return plan_of(arena, deep, setting, len(lines), dict(lines=scanlines(arena, lines), to=to_at))


def level_case():
    """LINES lines as if each had its first pixel's depth."""
    arena, shape = Arena(), layout.load().struct("scanline")
    deep, lines = polygon_lines()
    lines_at, steps_at = scanlines(arena, lines), arena.add(bytes(8 * LINES))
    plan_at = plan_of(arena, deep, "every16", LINES, dict(lines=lines_at, to=steps_at))

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.memory, shape.dtype, LINES, lines_at)
        steps = np.frombuffer(result.memory, ">i4", 2 * LINES, steps_at).reshape(-1, 2)
        for left, _, y in lines:
            u, v = level(deep, left, left + 2, y)
            for field, value in pack("addx", int(u[0]), int(v[0])).items():
                if (int(found[y][field]) ^ value) & MASKS["addx"][field]:
                    return f"line {y}: {field} is {found[y][field]}, expected {value}"
            if [int(u[1] - u[0]), int(v[1] - v[0])] != steps[y].tolist():
                return f"line {y}: steps {steps[y]}, expected {u[1] - u[0]}, {v[1] - v[0]}"
        return None

    return LINES, Case("level_lines", arena, pointers={"a0": plan_at, "a1": steps_at}), check


def lines_case(setting: str):
    """LINES lines of a turned triangle."""
    arena, shape = Arena(), layout.load().struct("perspective_line")
    deep, lines = polygon_lines()
    expected = [ends(deep, *each) for each in lines]
    to_at = arena.add(bytes(shape.size * LINES))
    plan_at = add_perspective_plan(arena, deep, lines, to_at, setting)

    def check(result: Result) -> str | None:
        return first_wrong_line(shape, result.memory[to_at:], [entry(each, setting) for each in expected],
                                () if setting in CURVES else ENOUGH)

    return LINES, Case("perspective_lines", arena, pointers={"a0": plan_at}), check
