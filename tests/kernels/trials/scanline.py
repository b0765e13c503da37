"""Trials of edge_ramp and edge_hold: u and v of each line against their definition."""

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.edge import BIAS, ONE, table_writes
from tmap.bench.trial import Trial, Write, values
from tmap.build import layout
from tmap.guest.kernels import M32, Case
from tmap.model import model
from tmap.setup.scanline import pack

FAR = 16383 * ONE


def table_of(lines: list[dict[str, int]]) -> bytes:
    """A scanline table with the fields given."""
    table = np.zeros(len(lines), layout.load().struct("scanline").dtype)
    for entry, line in zip(table, lines):
        for field, value in line.items():
            entry[field] = value
    return table.tobytes()


def ramps(rng, total: int, low: int, high: int) -> list[dict[str, int]]:
    """A side: x stays between two columns (16.16), u and v within the vertices' range."""
    made = []
    while total:
        lines = min(total, int(rng.integers(1, 12)))
        total -= lines
        ends = [[int(rng.integers(a, b)) for _ in range(2)]
                for a, b in ((low, high), (-FAR, FAR), (-FAR, FAR))]
        steps = [(b - a) // lines for a, b in ends]
        made.append(dict(zip(("x", "u", "v", "dx", "du", "dv"), [e[0] for e in ends] + steps),
                         lines=lines))
    return made


def points(side: list[dict[str, int]]) -> list[tuple[int, int, int]]:
    """x, u and v of each line."""
    return [tuple(r[k] + n * r["d" + k] for k in "xuv") for r in side for n in range(r["lines"])]


def ramp_trial(rng, truncated: bool, packed: bool, gap: tuple[int, int],
               x: tuple[int, int] = (-100 * ONE, 300 * ONE)) -> Trial:
    """One table; ``gap``: least and most pixels between the sides, ``x``: where the left one
    is, 16.16."""
    total = int(rng.integers(1, 40))
    left = ramps(rng, total, *x)
    right = [r | {"x": r["x"] + int(rng.integers(gap[0], gap[1] + 1)), "u": int(rng.integers(-FAR, FAR)),
                  "v": int(rng.integers(-FAR, FAR))} for r in left]
    before, after, steps = [], [], []
    for a, b in zip(points(left), points(right)):
        line = model.Line(max(model.ceil16(a[0]), 0), min(model.ceil16(b[0]), 320))
        before.append({"left": line.left + BIAS, "last": max(line.right, line.left - 5) + BIAS - 1})
        if line.right > line.left:
            model.scanline_line(line, a, b, truncated)
            after.append(pack("addx" if packed else "plain", line.u, line.v))
            steps.append({"dudx": line.dudx, "dvdx": line.dvdx})
        else:
            after.append({})
            steps.append({})
    memory = Memory(int(rng.integers(1 << 30)))
    shape, step = layout.load().struct("ramp"), layout.load().struct("scanline_step")
    lines_at = memory.add(table_of(before), name="lines", shape=layout.load().struct("scanline"))
    sides = [memory.add(b"".join(shape.pack(**{k: v & M32 if k in "uv" else v
                                               for k, v in r.items()}) for r in side),
                        name=name, shape=shape) for name, side in (("left", left), ("right", right))]
    steps_at = memory.room("scanline_step", total, "steps")
    plan = memory.struct("ramp_plan", dict(lines=lines_at, left=sides[0], right=sides[1],
                                           steps=steps_at),
                         count=total, truncated=int(truncated), packed=int(packed))
    writes = table_writes(lines_at, after, "addx" if packed else "plain")
    for index, line in enumerate(steps):
        for name, value in line.items():
            entry = step.fields[name]
            writes.append(table_write(steps_at + index * step.size + entry["offset"], value))
    for side, at in zip((left, right), sides):  # used up: what is left there does not count
        writes.append(anything(at, len(side) * shape.size))
    return Trial(Case("edge_ramp", memory, pointers={"a0": plan}),
                 f"{total} lines, truncated {truncated}, packed {packed}, gap {gap[1] / ONE:g}",
                 writes=writes)


def table_write(at: int, value: int) -> Write:
    """A longword that must be there."""
    return Write(at, (value & M32).to_bytes(4, "big"))


def anything(at: int, size: int) -> Write:
    """Bytes that may become anything."""
    return Write(at, bytes(size), bytes(size))


def held(start: int, step: int, pixels: int, low: int, high: int) -> int:
    """The start nearest to ``start`` with which no pixel leaves low..high."""
    travel = (pixels - 1) * step
    return min(max(start, low - min(travel, 0)), high - max(travel, 0))


def hold_trial(rng, most: int) -> Trial:
    """A table with lines of up to ``most`` pixels."""
    counts = [int(rng.integers(-3, most + 1)) for _ in range(int(rng.integers(1, 30)))]
    longest = max(max(counts), 1) - 1
    plan = {"count": len(counts)}
    for name, step in (("u", "dudx"), ("v", "dvdx")):
        low = int(rng.choice((0, rng.integers(0, 255 * ONE))))
        high = low + int(rng.choice((0, 1, ONE - 1, rng.integers(0, 1024 * ONE - 1))))
        plan |= {f"{name}_low": low, f"{name}_high": high,
                 step: int(rng.integers(-20 * ONE, 20 * ONE)) >> int(rng.integers(0, 20))}
    limited = dict(plan)
    for name, step in (("u", "dudx"), ("v", "dvdx")):
        if longest:
            most_step = (plan[f"{name}_high"] - plan[f"{name}_low"]) // longest
            limited[step] = min(max(plan[step], -most_step), most_step)
    before, after = [], []
    for count in counts:
        start = {name: int(rng.integers(plan[f"{name}_low"] - 5 * ONE, plan[f"{name}_high"] + 5 * ONE))
                 for name in "uv"}
        if rng.integers(10) == 0:
            start = {name: int(rng.integers(-1 << 30, 1 << 30)) for name in "uv"}
        before.append(pack("plain", start["u"], start["v"]) | {"left": BIAS, "last": BIAS + count - 1})
        kept = [held(start[n], limited[s], count, plan[f"{n}_low"], plan[f"{n}_high"])
                for n, s in (("u", "dudx"), ("v", "dvdx"))]
        after.append(pack("plain", *kept) if count > 0 else {})
    memory = Memory(int(rng.integers(1 << 30)))
    at = memory.add(table_of(before), name="lines", shape=layout.load().struct("scanline"))
    plan_at = memory.struct("hold_plan", dict(lines=at), **plan)
    fields = layout.load().struct("hold_plan").fields
    writes = table_writes(at, after, "plain")
    writes += [table_write(plan_at + fields[s]["offset"], limited[s]) for s in ("dudx", "dvdx")]
    return Trial(Case("edge_hold", memory, pointers={"a0": plan_at}), values(**plan), writes=writes)


def trials() -> list[Trial]:
    """All of them, the same in every run."""
    rng = np.random.default_rng(5)
    ways = [(truncated, packed) for truncated in (False, True) for packed in (False, True)]
    made = [ramp_trial(rng, *way, (0, gap)) for way in ways
            for gap in (0, 3, ONE // 2, ONE, 2 * ONE, 320 * ONE) for _ in range(6)]
    # The border between narrow and wide: a pixel exactly, and a unit less or more, whatever the steps.
    made += [ramp_trial(rng, *way, (gap, gap), (10 * ONE, 12 * ONE)) for way in ways
             for gap in (ONE - 1, ONE, ONE + 1) for _ in range(4)]
    first = -16384 * ONE  # sides as far apart as they can be, and drifted a little further
    made += [ramp_trial(rng, *way, (gap, gap + 80), (first - 40, first + 40)) for way in ways
             for gap in (32767 * ONE, 32768 * ONE - 40) for _ in range(3)]
    return made + [hold_trial(rng, most) for most in (1, 2, 3, 40, 320) for _ in range(20)]
