"""Trials of a polygon's constants of lines by tables, and what trials of such lines have in common."""

from collections.abc import Callable
from fractions import Fraction

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.span import FRAME
from tmap.base.fixed import signed
from tmap.bench import perspective as bench_perspective, reciprocal
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.setup import reciprocal as model
from tmap.setup.edges import measure
from tmap.setup.perspective import perspective

WIDTH, HEIGHT = 320, 200
PITCH = 1152
#: Pixels of a table's lines, as many as a frame has room for.
COUNTS = [*range(1, 20), 0, -3, *range(30, 35), 47, 48, 49, 64, 65, 100, 256, 257, 320,
          1024][:FRAME // PITCH - 1]
STATED = 2048  # a texel in 32
DEPTHS = (1.01, 1.5, 2, 3, 4, 6, 30, 1000)


def triangles(rng, count: int):
    """Planes of triangles on the screen whose w differs up to some ratio, and the lines
    between their sides, straight ones."""
    while count:
        points = [tuple(int(c) for c in rng.integers(-20 << 16, (side + 20) << 16, 3))
                  for side in (WIDTH, HEIGHT)]
        ratio = float(rng.choice(DEPTHS))
        reach = int(rng.choice((16, 128, 256))) << 16
        vertices = [(x, y, *(int(c) for c in rng.integers(-reach, reach, 2)),
                     int(65536 * ratio ** float(rng.random()))) for x, y in zip(*points)]
        sides = measure(vertices, WIDTH, HEIGHT)
        deep = sides and perspective(vertices, sides.corners, sides.box)
        if not deep:
            continue
        left, top, right, bottom = sides.box
        lines = []
        for y in range(top, bottom):
            ends = [x0 + (x1 - x0) * ((y << 16) - y0) / (y1 - y0)
                    for (x0, y0, *_), (x1, y1, *_) in zip(vertices, vertices[1:] + vertices[:1])
                    if min(y0, y1) <= y << 16 < max(y0, y1)]
            ends = [-int(-x // 65536) for x in sorted(ends)] if len(ends) == 2 else [left, left]
            lines.append((max(ends[0], left), min(ends[1], right), y))
        if any(b > a for a, b, _ in lines):
            count -= 1
            yield deep, right - left, lines


def find_trial(deep, lines) -> Trial:
    memory = Memory()
    x, y = next((left - deep.i, k) for k, (left, right, _) in enumerate(lines) if right > left)
    found = model.asymptotes(deep, x, y) if deep.gentle else None
    planes = bench_perspective.add_perspective_plan(memory, deep, lines, memory.room("perspective_line"))
    at = memory.struct("reciprocal_plan", dict(planes=planes), ku=0, kv=0,
                       **dict.fromkeys(("cu", "cv", "dcu", "dcv"), [0] * 8))
    shape = layout.load().struct("reciprocal_plan").fields
    title = f"{deep}, pixel {x}, {y}"
    case = Case("reciprocal_find", memory, {"d0": x, "d1": y}, {"a0": at})
    if not found:
        taken = None not in [model.asymptote(deep.q, plane) for plane in (deep.s, deep.t)]
        first, last = shape["cu"]["offset"], shape["kv"]["offset"] + 4
        return Trial(case, title, {"d0": int(taken)}, writes=[anything(at + first, last - first)])
    ks, cs, dcs = found
    writes = fields(at, "reciprocal_plan", dict(zip(("ku", "kv"), ks)))
    writes += [Write(at + shape[name]["offset"], (n % (1 << 64)).to_bytes(8, "big"))
               for name, n in zip(("cu", "cv", "dcu", "dcv"), cs + dcs)]
    return Trial(case, title, {"d0": 1}, writes=writes)


def error(deep, line, pixels, u, v, y: int, bound: int, raised: list[int]) -> str | None:
    """Some pixels against the planes themselves: as far as ``bound`` and what is stated, from where they
    are ``raised`` to."""
    for x in pixels:
        at = line.left + x - deep.i, y - deep.j
        q = Fraction(deep.q.value(*at), 1 << 32)
        for found, plane, base, more in zip((u[x], v[x]), (deep.s, deep.t), deep.base, raised):
            off = signed(int(found) - base - more - int(plane.value(*at) / q), 32)
            if abs(off) > min(bound, STATED):
                return f"line {y}, pixel {x}: the model is {off} units off"
    return None


def lines_trial(bench, model, deep, lines, pixels_of) -> Trial | None:
    """Lines by logarithms, as ``bench`` calls them and ``model`` makes them: all of a
    polygon's, those that are left among them. ``pixels_of``: those of the k-th line that are held to
    the planes."""
    constants, *_ = reciprocal.constants_of(deep, lines)
    if constants is None:
        return None
    made = [model.line(deep, constants, *each) if each[1] > each[0] else None for each in lines]
    trial = bench.lines_trial(Memory(), deep, constants, lines, made,
                              f"{deep}")
    worst = next(filter(None, (
        error(deep, line, pixels_of(k, line.n), *model.coordinates(line), y, model.bound(line),
              constants.raised) for k, ((_, _, y), line) in enumerate(zip(lines, made)) if line)), None)
    trial.also = lambda _: worst
    return trial


def records(line_of: Callable[[int, int], object]) -> list:
    """Lines of COUNTS pixels: ``line_of`` their number and n, or n alone."""
    return [line_of(k, pixels - 1) if pixels > 0 else pixels - 1 for k, pixels in enumerate(COUNTS)]


def trials() -> list[Trial]:
    rng = np.random.default_rng(8)
    return [find_trial(deep, lines) for deep, _, lines in triangles(rng, 60)]
