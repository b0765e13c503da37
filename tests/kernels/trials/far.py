"""Trials of perspective from the far ends of lines: tables of lines with any planes that stay inside the table,
the lines themselves, K and C of triangles."""

from collections.abc import Iterator

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.edge import SPARE, SPLITS, side
from tests.kernels.trials.span import FRAME, picture_ground
from tmap.bench import far as bench
from tmap.bench.trial import Trial, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.setup import far as model
from tmap.setup.edges import measure
from tmap.setup.perspective import perspective

WIDTH, HEIGHT = 320, 200
PITCH = 1152
#: Pixels of a table's lines, as many as a frame has room for.
COUNTS = [*range(1, 20), 0, -3, *range(30, 35), 47, 48, 49, 64, 65, 100, 256, 257, 320,
          1024][:FRAME // PITCH - 1]
DEPTHS = (1.01, 1.5, 2, 3, 4, 6, 30, 1000)
ACROSS = max(COUNTS) + 4
LINES = [(k % 4, count) for k, count in enumerate(COUNTS)]
COARSE = (0, model.COARSE, 2 * model.COARSE)
MARGIN = 4000 * len(LINES)  # q grows by up to 4000 a line


def triangles(rng, count: int):
    """Planes of triangles on the screen whose w differs up to some ratio."""
    while count:
        points = [tuple(int(c) for c in rng.integers(-20 << 16, (side + 20) << 16, 3))
                  for side in (WIDTH, HEIGHT)]
        ratio = float(rng.choice(DEPTHS))
        reach = int(rng.choice((16, 128, 256))) << 16
        vertices = [(x, y, *(int(c) for c in rng.integers(-reach, reach, 2)),
                     int(65536 * ratio ** float(rng.random()))) for x, y in zip(*points)]
        sides = measure(vertices, WIDTH, HEIGHT)
        deep = sides and perspective(vertices, sides.corners, sides.box)
        if deep:
            count -= 1
            yield deep


def any_q(leftwards: bool, rng) -> tuple[int, int, int]:
    """q at the table's corner and its growth a pixel and a line: any step, from as far as it may be."""
    step = int(2.0 ** rng.uniform(0, 30)) // ACROSS + 1
    least = 1 << 29 - model.DEEP
    while step << (31 - least.bit_length() & ~1) > model.MOST:
        least *= 2
    most = (1 << 31) - 1 - ACROSS * step - MARGIN
    low = int((least + MARGIN) * 2.0 ** rng.uniform(0, np.log2(most / (least + MARGIN))))
    down = int(rng.integers(-4000, 4000))
    return (low + ACROSS * step, -step, down) if leftwards else (low, step, down)


def even_q(leftwards: bool, pixels: int, every: str, rng) -> tuple[int, int, int]:
    """The same between 2^28 and 2^30, for pieces of so many pixels everywhere."""
    most = min((model.LENGTHS[every][pixels] or 1 << 23) // 2, (3 << 28) // ACROSS - MARGIN // ACROSS * 2 - 1)
    step = int(2.0 ** rng.uniform(0, np.log2(most))) + 1
    low = int(rng.integers((1 << 28) + MARGIN, (1 << 30) - ACROSS * step - MARGIN))
    down = int(rng.integers(-4000, 4000))
    return (low + ACROSS * step, -step, down) if leftwards else (low, step, down)


def span_trial(every: str, leftwards: bool, coarse: int, rng, even: int = 0) -> Trial:
    """Any constants. ``even``: the pixels of pieces wherever they begin; 0: not even."""
    c, dc = ([int(rng.integers(-1 << bits, 1 << bits)) for bits in rng.integers(*reach, 2)]
             for reach in ((9, 31), (2, 23)))
    made = model.Constants(
        tuple(int(n) for n in rng.integers(0, 1 << 32, 2)), tuple(c), tuple(dc),
        *(even_q(leftwards, even, every, rng) if even else any_q(leftwards, rng)), 0, 0,
        every, coarse, [0, 0], even > 0)
    return bench.span_trial(Memory(int(rng.integers(1 << 30))), picture_ground(), made, LINES, PITCH, f"{made}")


def any_place(rng) -> tuple[int, ...]:
    """Where lines are, and q."""
    return (int(rng.integers(0, 1 << 31)), int(rng.integers(-2000, 2000)), int(rng.integers(0, 1 << 32)),
            *(int(n) for n in rng.integers(-1 << 31, 1 << 31, 2)))


def edges_trial(splits, exact: bool, rng) -> Trial:
    """Edges of any slopes; ``splits``: lines of each, by sides."""
    sides, where = [side(rng, split, None, exact) for split in splits], any_place(rng)
    return bench.edges_trial(Memory(int(rng.integers(1 << 30))), *sides, where, f"{sides}, {where}", SPARE)


def lines_trial(leftwards: bool, rng) -> Trial:
    """A table with any lines."""
    lines = [(int(left), int(count)) for left, count in rng.integers((-9, -3), (1100, 300), (20, 2))]
    where = any_place(rng)
    return bench.lines_trial(Memory(int(rng.integers(1 << 30))), lines, leftwards, where, f"{lines}, {where}")


def constants_trials(deep, less: int) -> Iterator[Trial]:
    """K of a triangle and, if it is near enough, C. ``less``: the bits that K lacks."""
    names = ("x", "y", "q", "s", "t")
    top, bottom, middle = (dict(zip(names, three)) for three in deep.corners.three)
    vectors = [{name: n - top[name] for name, n in other.items()} for other in (bottom, middle)]
    swapped = vectors[0]["x"] * vectors[1]["y"] < vectors[1]["x"] * vectors[0]["y"]
    shape, plan_shape = layout.load().struct("plane_corner"), layout.load().struct("far_plan").fields
    ks = model.asymptotes(deep, less)
    farthest = max(model.to_farthest(deep, ks, less)) if ks else 0
    bits = model.BITS_COARSE if less or farthest > model.REACH else model.BITS
    for kernel in ("far_asymptotes", "far_constants"):
        if kernel == "far_constants" and (not ks or farthest > model.REACH << model.COARSE + less):
            return
        memory = Memory()
        rows = [top, *(vectors[::-1] if swapped else vectors)]
        corners = memory.struct("plane_corners", {}, area=[0] * 8, x=0, y=deep.corners.y,
                                **{name: list(shape.pack(**row)) for name, row in zip(("first", "a", "b"), rows)})
        at = layout.load().struct("plane_corners").fields["b" if swapped else "a"]["offset"]
        texels = dict(zip(("top_u", "top_v", "bottom_u", "bottom_v"),
                          (n << model.K_BITS >> less for n in sum(deep.corners.texels[:2], ()))))
        given = dict(zip(("ku", "kv"), ks)) if kernel == "far_constants" else {"ku": 0, "kv": 0}
        plan = memory.struct("far_plan", dict(corners=corners, bottom=corners + at), scale=deep.scale, less=less,
                             cu=0, cv=0, dcu=0, dcv=0, rest_u=0, rest_v=0, **given, **texels)
        found = ks if kernel == "far_asymptotes" else model.starts(deep, ks, bits, less)
        made = ("ku", "kv") if kernel == "far_asymptotes" else ("cu", "cv", "dcu", "dcv", "rest_u", "rest_v")
        if found:
            flat = found if kernel == "far_asymptotes" else sum(found, [])
            writes = fields(plan, "far_plan", dict(zip(made, flat)))
        else:
            writes = [anything(plan + plan_shape[name]["offset"], 4) for name in made]
        registers = {"d0": bits} if kernel == "far_constants" else {}
        yield Trial(Case(kernel, memory, registers, {"a0": plan}), f"{deep}", {"d0": int(bool(found))}, writes=writes)


def trials() -> list[Trial]:
    rng = np.random.default_rng(24)
    ways = [(every, leftwards) for every in model.LENGTHS for leftwards in (False, True)]
    return [*(span_trial(*way, coarse, rng) for way in ways for coarse in COARSE for _ in range(16)),
            *(span_trial(every, leftwards, coarse, rng, even) for every, leftwards in ways
              for coarse in COARSE for even in (4, 8, 16) for _ in range(6)),
            *(edges_trial(splits, exact, rng) for splits in SPLITS for exact in (False, True) for _ in range(3)),
            *(lines_trial(leftwards, rng) for leftwards in (False, True) for _ in range(8)),
            *(trial for deep in triangles(rng, 60) if deep.scale < model.K_SCALE
              for less in (0, model.COARSE) for trial in constants_trials(deep, less))]
